"""``brdf-suite palette find``: the nearest entries as a table and as JSON."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import pytest

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.cli.palette.palette import add_find
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.errors import SuiteError
from brdf_suite.palettes.columns import labs_of
from brdf_suite.pipeline.material import load_shipped_paint, paint_names


@pytest.fixture
def palette(tmp_path: Path) -> Path:
    entries = [Entry(load_shipped_paint(name), code=name, group=("Shipped",)) for name in paint_names()]
    file = tmp_path / "all.brdfpalette"
    save_palette(Palette("All", (*entries, Entry(FlatColour("", "RGB", (1.0, 0.0, 0.0))))), file)
    return file


def find(*arguments: str) -> int:
    parser = argparse.ArgumentParser()
    add_find(parser.add_subparsers())
    options = parser.parse_args(["find", *arguments])
    return int(options.run(options))


def test_the_nearest_are_reported_with_every_angle(palette: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert find("blue", "--in", str(palette), "--count", "3", "--combine", "worst", "--json") == 0
    reported = json.loads(capsys.readouterr().out)
    assert [reported["paint"], reported["palette"], reported["entries"]] == [
        "Blue",
        "All",
        len(paint_names()) + 1,
    ]
    first, second, _third = reported["found"]
    assert first["code"] == "blue"
    assert first["delta_e_2000"] == 0.0
    other = load_shipped_paint(second["code"])
    each = delta_e_2000(labs_of(load_shipped_paint("blue")), labs_of(other))
    assert list(second["per_angle"].values()) == pytest.approx(each.tolist())
    assert second["delta_e_2000"] == pytest.approx(each.max())


def test_a_table_names_codes_and_groups(palette: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert find("solid_red", "--in", str(palette), "--count", "60") == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 2 + len(paint_names()) + 1
    assert lines[2].split()[:4] == ["0.00"] * 4
    assert lines[2].endswith("(solid_red)  [Shipped]")
    assert any(line.endswith("(no name)") for line in lines)


@pytest.mark.parametrize("wrong", [["nothing", "--in", "{}"], ["blue", "--in", "/nowhere/x.ase"]])
def test_what_is_not_there_is_reported(palette: Path, wrong: list[str]) -> None:
    with pytest.raises(SuiteError):
        find(*(word.format(palette) for word in wrong))


def test_a_count_must_be_a_number(palette: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        find("blue", "--in", str(palette), "--count", "0")
    assert "whole number" in capsys.readouterr().err
