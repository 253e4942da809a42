"""``brdf-suite acquire``: a folder in, a table out, and what it says of both."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.cli.measured.acquire import _summed_up
from brdf_suite.files.measured import read_measured
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

RIG = ["--size", "144x144", "--positions", "6", "--exposures", "6", "--longest", "0.016", "--stated"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("rig") / "titan"
    simulate = [
        "acquire",
        "--simulate",
        "table1_opel_titan",
        str(folder),
        *RIG,
        "--curve",
        "linear",
        "--no-noise",
    ]
    assert main([*simulate, "--json"]) == 0
    return folder


def test_a_table_is_written_and_reported(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    output = tmp_path / "titan.brdftable"
    assert main(["acquire", str(folder), "-o", str(output), "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["file"] == str(output)
    assert reported["positions"] == 6
    assert reported["left_out"] == []
    table = read_measured(output)
    assert isinstance(table, IsotropicTable)
    assert table.coverage is not None
    assert np.count_nonzero(table.coverage.samples) == reported["coverage"]["bins"]
    # A second time it is not overwritten, and the reason names the way on.
    before = output.read_bytes()
    assert main(["acquire", str(folder), "-o", str(output)]) == 1
    assert "--overwrite" in capsys.readouterr().err
    assert output.read_bytes() == before


def test_the_check_names_a_missing_photograph(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(["acquire", str(folder / "session.json"), "--check"]) == 0
    assert "6 positions" in capsys.readouterr().out
    session = json.loads((folder / "session.json").read_text())
    gone = folder / session["positions"][2]["photographs"][1]
    content = gone.read_bytes()
    gone.unlink()
    assert main(["acquire", str(folder), "--check", "--json"]) == 0
    findings = json.loads(capsys.readouterr().out)["findings"]
    assert [(one["severity"], one["path"]) for one in findings] == [("exposure", str(gone))]
    gone.write_bytes(content)


def test_where_the_table_goes_must_be_said(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    assert main(["acquire", str(folder)]) == 1
    assert "-o FILE.brdftable" in capsys.readouterr().err
    assert main(["acquire", str(folder), "-o", str(tmp_path / "a.brdftable"), "--partial"]) == 1
    assert "nothing to write yet" in capsys.readouterr().err
    assert main(["acquire", str(tmp_path), "-o", str(tmp_path / "a.brdftable")]) == 1
    assert "session.json" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_many_notices_alike_are_summed_up() -> None:
    alike = [
        f"light_{k:04d}/05.png: stated as 0.02 s, but its pixels show about 0.0{k + 20} s." for k in range(9)
    ]
    other = ["The scale is unknown.", "dark/00.png: is missing."]
    reported = _summed_up([*alike, *other])
    assert reported == [f"{alike[0]} And 8 more photographs alike (--json names all).", *other]
    assert _summed_up(alike[:3]) == alike[:3]
