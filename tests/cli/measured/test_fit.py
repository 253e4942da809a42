"""``brdf-suite fit PAINT --angles K``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.files.measured import write_measured
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.tensor.tabulate import tabulate


def test_weights_and_errors_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fit", "blue", "--angles", "6", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["angles"] == len(found["cosines"]) == len(found["kg"]) == 6
    assert found["cosines"] == sorted(found["cosines"])
    assert not found["time_limited"]
    assert {row["illumination_deg"] for row in found["errors"]} >= {20.0, 45.0, 65.0}


def test_a_table_for_people(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fit", "blue", "--angles", "6"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "6 incidences" in lines[0]
    at_45 = next(line for line in lines if line.split()[:1] == ["45"])
    assert len(at_45.split()) == 7


@pytest.mark.parametrize(
    ("paint", "count", "words"),
    [
        ("blue", "2", "at least 3 angles"),
        ("blue", "3000", "at most 256, not 3000"),
        ("blue.bsdf", "8", "nothing divides measured data into coat and base"),
    ],
)
def test_what_cannot_be_fitted_so_is_refused_in_one_line(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, paint: str, count: str, words: str
) -> None:
    if paint == "blue.bsdf":
        paint = str(tmp_path / paint)
        write_measured(tabulate(load_material("blue").reflectance, incidences=24, resolution=64), paint)
    assert main(["fit", paint, "--angles", count]) != 0
    error = capsys.readouterr().err.strip()
    assert words in error
    assert "\n" not in error
