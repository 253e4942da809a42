"""``brdf-suite palette convert`` and ``info``: what they print, write and refuse."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.files.palettes import read_palette

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def source(tmp_path: Path) -> Path:
    path = tmp_path / "a.brdfpalette"
    entries = (
        Entry(FlatColour("Ink", "CMYK", (1.0, 0.0, 0.5, 0.25)), group=("Inks",), usage="spot", code="I1"),
        Entry(solid_paint("White", (95.0, 0.0, 1.0)), tags=("fleet",)),
        Entry(FlatColour("", "RGB", (1.0, 0.0, 0.0))),
    )
    save_palette(Palette("Süd", entries), path)
    return path


def test_convert_reports_losses(source: Path, tmp_path: Path, capsys: Capture) -> None:
    target = tmp_path / "b.gpl"
    assert main(["palette", "convert", str(source), str(target), "--list-losses"]) == 0
    listed = capsys.readouterr().err
    assert not target.exists()
    assert main(["palette", "convert", str(source), str(target)]) == 0
    out, err = capsys.readouterr()
    assert "note: 1 CMYK colour is shown without a profile" in err
    assert "lost: 1 colour in CMYK is written as RGB, computed without a profile." in err
    assert "lost: 1 paint is written as the one colour at 45°" in err
    assert [line for line in listed.splitlines() if line.startswith("lost:")] == [
        line for line in err.splitlines() if line.startswith("lost:")
    ]
    assert f"{target}: 3 entries, GIMP palette" in out
    assert len(read_palette(target).palette) == 3


def test_convert_by_format_and_json(source: Path, tmp_path: Path, capsys: Capture) -> None:
    target = tmp_path / "b.bin"
    assert main(["palette", "convert", str(source), str(target), "--format", "ase", "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert (reported["input_format"], reported["output_format"], reported["entries"]) == (
        "brdfpalette",
        "ase",
        3,
    )
    assert reported["bytes"] == target.stat().st_size
    assert reported["losses"]
    assert read_palette(target).format.name == "ase"


def test_info_prints_everything(source: Path, capsys: Capture) -> None:
    assert main(["palette", "info", str(source), "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert (reported["format"], reported["name"]) == ("brdfpalette", "Süd")
    ink, white, red = reported["entries"]
    assert ink["flat"] == {"name": "Ink", "model": "CMYK", "values": [1.0, 0.0, 0.5, 0.25]}
    assert (ink["group"], ink["usage"], ink["code"]) == (["Inks"], "spot", "I1")
    assert white["kind"] == "aspecular"
    assert [reading["aspecular_deg"] for reading in white["readings"]] == [15.0, 45.0, 110.0]
    assert white["lab"] == [95.0, 0.0, 1.0]
    assert red["hex"] == "#ff0000"
    assert "CMYK" in reported["messages"][0]
    assert main(["palette", "info", str(source)]) == 0
    out = capsys.readouterr().out
    assert "[Inks]\n  Ink (I1): CMYK 1 0 0.5 0.25, spot" in out
    assert "White: paint, 15°, 45°, 110°" in out
    assert "(no name): RGB 1 0 0" in out


def test_what_cannot_be_done_is_one_line(source: Path, tmp_path: Path, capsys: Capture) -> None:
    other = tmp_path / "keep.xyz"
    other.write_text("mine", "utf-8")
    assert main(["palette", "convert", str(source), str(other)]) == 1
    assert "names no palette format" in capsys.readouterr().err
    assert main(["palette", "convert", str(other), str(tmp_path / "b.gpl")]) == 1
    assert "no palette format that is known" in capsys.readouterr().err
    assert other.read_text("utf-8") == "mine"
    assert main(["palette", "info", str(tmp_path / "none.ase")]) == 1
    assert capsys.readouterr().err.count("\n") == 1


def test_convert_writes_three_colours_of_a_paint(source: Path, tmp_path: Path, capsys: Capture) -> None:
    target = tmp_path / "b.ase"
    assert main(["palette", "convert", str(source), str(target), "--three-angles"]) == 0
    assert "5 entries" in capsys.readouterr().out
    names = [entry.name for entry in read_palette(target).palette]
    assert [name for name in names if name.startswith("White")] == ["White 15°", "White 45°", "White 110°"]
