"""What all programs share: features started and ended together, options set by scripts, milestones of the start."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from brdf_qt.program.feature import Feature
from brdf_qt.program.program import Program
from brdf_qt.program.settings import state_folder
from brdf_qt.window.main_window import SuiteWindow

from brdf_suite import variables


class Recorder(Feature):
    """Writes down what is asked of it."""

    def __init__(self, name: str, log: list[str]) -> None:
        self.name, self.log, self.idle = name, log, True

    def start(self) -> None:
        self.log.append(f"start {self.name}")

    @property
    def is_idle(self) -> bool:
        return self.idle

    def run_script(self, key: str, value: str) -> bool:
        if key == self.name:
            self.log.append(f"{key} = {value}")
        return key == self.name

    def close(self) -> None:
        self.log.append(f"close {self.name}")


@pytest.fixture
def log() -> list[str]:
    return []


@pytest.fixture
def program(qtbot, log) -> Program:
    window = SuiteWindow("Test")
    window.restore_layout()
    qtbot.addWidget(window)
    return Program(window, [Feature(), Recorder("a", log), Recorder("b", log)])


def test_features_start_once_the_window_is_painted_and_close_once(program, log, qtbot) -> None:
    program.start_when_painted()
    program.start_when_painted()
    reached: list[str] = []
    program.reached.connect(reached.append)
    program.window.show()
    qtbot.waitUntil(lambda: "complete" in reached)
    assert (log, reached) == (["start a", "start b"], ["ready", "complete"])
    log.clear()
    program.close()
    program.close()
    assert log == ["close b", "close a"]


def test_it_is_idle_where_every_feature_is(program) -> None:
    assert program.is_idle
    program.feature(Recorder).idle = False
    assert not program.is_idle


def test_scripts_set_options_and_trigger_commands(program, log) -> None:
    assert program.do("b=1=2")
    assert not program.do("c=1")
    action = program.window.add_command("view", "Do It", None, lambda: log.append("done"), "do_it")
    assert program.do("do_it")
    action.setEnabled(False)
    assert not program.do("do_it")
    assert not program.do("nothing")
    assert log == ["b = 1=2", "done"]


def test_without_a_place_for_settings_states_are_kept_in_the_temporary_folder(
    qapp, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv(variables.SETTINGS, str(tmp_path / "file"))
    folders = {kind: state_folder(kind, "Designer") for kind in ("autosave", "log")}
    assert all(folder.is_dir() for folder in folders.values())
    assert all(Path(tempfile.gettempdir()) in folder.parents for folder in folders.values())
    assert len({folder.parent for folder in folders.values()}) == 1
    (said,) = caplog.messages
    assert "Settings cannot be kept in" in said
    assert str(folders["log"].parents[1]) in said
