"""The choice of basis, weighting and diffuse term, made in one program and kept for all."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import pytest
from brdf_qt.program.settings import settings
from brdf_qt.window.fit_choice import FitChoice, FitCommand, FitDialog, stored_choice
from brdf_qt.window.main_window import SuiteWindow

from brdf_suite.cli.fit_options import add_fitting, parse_fitting
from brdf_suite.errors import DocumentError, FileError
from brdf_suite.fitting.lobes.basis import LobeBasis, shipped_basis
from brdf_suite.fitting.lobes.settings import FitSettings


@pytest.fixture
def own(tmp_path: Path) -> Path:
    path = tmp_path / "own basis.json"
    results = [{"exponents": [2.0, 50.0]}, {"exponents": [2.0, 30.0, 900.0]}]
    path.write_text(
        json.dumps({"format": "lobe_basis", "version": 1, "default_count": 3, "results": results})
    )
    return path


@pytest.fixture
def window(qtbot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> SuiteWindow:
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    window = SuiteWindow("Test")
    qtbot.addWidget(window)
    return window


def test_a_choice_is_kept_for_every_program(window, own: Path) -> None:
    command = FitCommand(window, "")
    assert command.settings == FitSettings()
    choice = FitChoice(str(own), 2, "solid angle", "measured")
    heard = []
    command.changed.connect(heard.append)
    command.choose(choice)
    assert heard == [FitSettings(LobeBasis((2.0, 50.0)), "solid angle", "measured")]
    assert stored_choice() == choice
    assert FitCommand(window, "").settings == heard[0]


def test_the_command_line_makes_the_same_choice(own: Path) -> None:
    parser = argparse.ArgumentParser()
    add_fitting(parser)
    for choice in (
        FitChoice(),
        FitChoice(count=7),
        FitChoice(str(own), 2, "solid angle", "measured"),
        FitChoice(weighting="relative"),
    ):
        assert parse_fitting(parser.parse_args(choice.words())) == choice.settings()
    assert FitChoice().words() == ()


def test_a_stored_basis_that_has_gone_is_reported_and_the_default_used(window, own: Path) -> None:
    FitCommand(window, "").choose(FitChoice(str(own)))
    own.unlink()
    command = FitCommand(window, "")
    assert (command.choice, command.settings) == (FitChoice(), FitSettings())
    (message,) = window.messages.shown().values()
    assert message.what.startswith(f"{own.name}: ")
    assert message.where == str(own.parent)
    with pytest.raises(FileError, match="own basis"):  # asked for by name it is refused
        FitCommand(window, "", FitChoice(str(own)))
    settings("shared").setValue("fit/choice", "[1, 2]")
    assert stored_choice() == FitChoice()


def test_the_dialog_offers_what_is_chosen_and_refuses_a_count_that_is_not_there(window, own: Path) -> None:
    dialog = FitDialog(FitChoice(count=7, diffuse="measured"), "note", window)
    assert dialog.choice == FitChoice(count=7, diffuse="measured")
    assert dialog.choice.settings().basis == shipped_basis(7)
    chosen = []
    dialog.chosen.connect(chosen.append)
    dialog.add_file(str(own))
    dialog.buttons.accepted.emit()
    assert "no basis of 7 lobes" in dialog.message.text()
    assert chosen == []
    with pytest.raises(DocumentError):
        dialog.choice.settings()
    dialog.count.setValue(2)
    dialog.buttons.accepted.emit()
    assert chosen == [FitChoice(str(own), 2, "absolute", "measured")]
    dialog.buttons.button(dialog.buttons.StandardButton.RestoreDefaults).click()
    assert dialog.choice == FitChoice()
