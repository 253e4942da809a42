"""``brdf-suite represent``: a table, a JSON object, and the Lobe Visualizer with the same fits."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli import default_action
from brdf_suite.cli.main import FAILED, main
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.fitting.cook_torrance.samples import even_pairs
from brdf_suite.inspection.representations import KINDS
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples


@pytest.fixture
def file(tmp_path: Path) -> Path:
    wi, wo = even_pairs(400, 1, 75.0)
    write_brdftable(
        ScatteredSamples(wi, wo, Lambertian((0.5, 0.3, 0.2)).eval(wi, wo)), tmp_path / "matt.brdftable"
    )
    return tmp_path / "matt.brdftable"


def test_three_rows_with_errors_size_and_time(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["represent", str(file), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["held_out"]["pairs"] == 80
    assert found["environment"] == "booth"
    assert [row["kind"] for row in found["representations"]] == list(KINDS)
    for row in found["representations"]:
        numbers = [row[key] for key in ("held_out_relative_rms", "held_out_median_relative", "delta_e_mean")]
        assert np.all(np.array(numbers) < 0.5)
        assert row["size_bytes"] > 0
        assert row["nanoseconds"] > 0.0


def test_the_table_is_printed_and_the_window_opens_the_same_file(
    file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    opened = []
    monkeypatch.setattr(default_action, "open_one", lambda *words: opened.append(words) or 0)
    assert main(["represent", str(file), "--open"]) == 0
    assert opened == [("lobes", [str(file), "--representations"])]
    printed = capsys.readouterr().out
    assert all(kind in printed for kind in KINDS)
    assert "80 pairs" in printed


def test_what_does_not_exist_is_named(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["represent", str(file), "--environment", "no_such_light"]) == FAILED
    assert "no_such_light" in capsys.readouterr().err
