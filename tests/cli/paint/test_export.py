"""``brdf-suite export``: by ending and by name, several paints, losses first."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reports.handover import formats, read_paints


def test_several_paints_go_into_one_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "paints.csv"
    assert main(["export", "blue", "red", "-o", str(path), "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["paints"] == ["Blue", "Red"]
    assert reported["format"] == "csv"
    assert read_paints(path).paints == (load_shipped_paint("blue"), load_shipped_paint("red"))


def test_a_format_is_named_where_the_ending_says_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "paint.xml"
    assert main(["export", "blue", "-o", str(path)]) == 1
    assert "names no format" in capsys.readouterr().err
    assert main(["export", "blue", "--format", "cxf", "--out", str(path)]) == 0
    assert "lost: " in capsys.readouterr().err
    assert read_paints(path).paints == (load_shipped_paint("blue"),)


def test_losses_are_listed_and_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["export", "blue", "--list-losses", "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)["losses"]["blue"]
    assert list(reported) == [known.name for known in formats()]
    assert any("flakes" in sentence for sentence in reported["luxcore"])
    assert main(["export", "blue", "--list-losses", "--format", "csv"]) == 0
    assert "Nothing is lost." in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main(["export", "blue"])
    assert "-o FILE" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_report_against_a_standard_without_pictures(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "report.html"
    assert main(["export", "blue", "-o", str(path), "--standard", "midnight_blue", "--no-pictures"]) == 0
    assert "Against Midnight blue: " in path.read_text(encoding="utf-8")
    assert main(["export", "nowhere", "-o", str(path)]) == 1
    assert "nowhere" in capsys.readouterr().err
