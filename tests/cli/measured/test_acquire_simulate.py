"""``brdf-suite acquire --simulate`` and ``--template``: folders to start from, and options that are refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from brdf_suite.acquisition.session.check import check_session
from brdf_suite.acquisition.session.store import read_session
from brdf_suite.cli.main import FAILED, main

SMALL = ["--size", "40x32", "--positions", "3", "--exposures", "3", "--stated"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("simulated") / "session"
    options = [
        "--light-offset",
        "0.5",
        "--centre-offset",
        "2",
        "-1",
        "--bits",
        "16",
        "--curve",
        "linear",
        "--tiff",
    ]
    assert main(["acquire", "--simulate", "table1_blue", str(made), *SMALL, *options]) == 0
    return made


def test_a_simulated_folder_is_a_session_with_its_truth(folder: Path) -> None:
    session = read_session(folder)
    assert session.name == "Blue"
    assert [p.angle_deg for p in session.positions] == [0.0, 60.0, 120.0]
    assert session.camera.bit_depth == 16
    assert session.camera.response == "linear"
    assert session.light.irradiance_rgb is not None
    assert session.positions[0].photographs[0].endswith(".tif")
    assert check_session(folder, session) == ()
    truth = json.loads((folder / "truth.json").read_text())
    assert truth["settings"]["light_offset_deg"] == 0.5
    assert truth["settings"]["centre_offset_px"] == [2.0, -1.0]


def test_what_was_done_is_reported_as_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = tmp_path / "new"
    assert main(["acquire", "--simulate", "table1_blue", str(made), *SMALL, "--no-noise", "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["photographs"] == len(read_session(made).files())
    (made / "session.json").unlink()
    assert main(["acquire", "--template", str(made), "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["file"] == str(made / "session.json")
    assert reported["photographs"] == len(read_session(made).files())


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--simulate", "no_such_paint", "{new}"], "no_such_paint"),
        (["--simulate", "table1_blue", "{made}"], "is not empty"),
        (["--simulate", "table1_blue", "{new}", "--bits", "40"], "bit_depth"),
        (["--simulate", "table1_blue", "{new}", "--moved", "900", "1", "1"], "moved"),
        (["--simulate", "table1_blue", "{new}", "--moved", "nan", "1", "1"], "a whole number"),
        (["--simulate", "table1_blue", "{new}", "--moved", "3", "inf", "1"], "moved"),
        (["--simulate", "table1_blue", "{new}", "--centre-offset", "nan", "1"], "centre_offset_px"),
        (["--template", "{made}"], "not overwritten"),
        (["--template", "--simulate", "table1_blue", "{new}"], "not both"),
    ],
    ids=["paint", "occupied", "bits", "moved", "half", "far", "offset", "template", "both"],
)
def test_what_cannot_be_is_reported_in_a_line(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], options: list[str], words: str
) -> None:
    places = {"made": str(folder), "new": str(tmp_path / "new")}
    assert main(["acquire", *(option.format(**places) for option in options)]) == FAILED
    reported = capsys.readouterr().err
    assert words in reported
    assert len(reported.splitlines()) == 1
