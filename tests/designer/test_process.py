"""Designer as a process: start-up, pictures, signals, and what a kill leaves."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from brdf_designer.assembly import Designer
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage

HERE = Path(__file__).parent
SLOW = {
    "trimesh",
    "moderngl",
    "colour",
    "OpenImageIO",
    "scipy.optimize",
    "mitsuba",
    "qtawesome",
    "superqt",
    "PIL",
}


def environment() -> dict[str, str]:
    return {**os.environ, "QT_QPA_PLATFORM": "offscreen"}


def designer_command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "brdf_designer", *arguments]


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        designer_command(*arguments),
        env=environment(),
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )


def test_start_up_is_reported():
    """How long it takes is measured by ``brdf-suite bench startup``."""
    done = run("--quit-after", "0", "--report-startup")
    assert done.returncode == 0, done.stderr
    times = json.loads(done.stdout.splitlines()[-1])
    assert 0.0 < times["ready_s"] < times["complete_s"]


def test_start_up_imports_nothing_slow():
    code = (
        "import sys; from brdf_designer.__main__ import main; status = main(['--quit-after', '0']);"
        "print(sorted(sys.modules)); sys.exit(status)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=environment(),
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    modules = set(done.stdout.replace("'", "").strip("[]\n").split(", "))
    assert "pyqtgraph" in modules
    assert modules & SLOW == set()


def test_a_screenshot_shows_the_paint(tmp_path):
    done = run("red", "--theme", "light", "--size", "900x600", "--screenshot", str(tmp_path / "a.png"))
    assert done.returncode == 0, done.stderr
    picture = QImage(str(tmp_path / "a.png"))
    assert (picture.width(), picture.height()) == (900, 600)
    reds = sum(
        picture.pixelColor(x, y).red() > 2 * picture.pixelColor(x, y).green() + 20
        for x in range(0, 500, 10)
        for y in range(100, 400, 10)
    )
    assert reds > 400


def test_a_missing_file_is_told_and_the_program_runs(tmp_path):
    done = run(str(tmp_path / "none.brdfpaint"), "--quit-after", "0")
    assert done.returncode == 0
    assert "Traceback" not in done.stderr


@contextmanager
def dragging() -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [sys.executable, str(HERE / "edit_and_wait.py")], env=environment(), stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline() == "dragging\n"
            yield process
        finally:
            process.kill()


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system has no kill -9")
def test_a_kill_in_the_middle_of_a_drag_keeps_the_work(qtbot, dialogs, monkeypatch, own_session):
    with dragging() as process:
        # The autosave comes while the drag goes on, by its own timer.
        qtbot.waitUntil(lambda: list(own_session.rglob("*.recovery.json")) != [])
        process.send_signal(signal.SIGKILL)
        process.wait(120)
    # The settings are named after the program; this test's own process is another one.
    monkeypatch.setattr("brdf_qt.settings.QCoreApplication.applicationName", lambda: "Designer")
    designer = Designer(dialogs=lambda _window: dialogs)
    qtbot.addWidget(designer.window)
    designer.window.show()
    qtbot.waitUntil(lambda: "recovery" in designer.window.messages.shown())
    assert "Blue" in designer.window.messages.shown()["recovery"].what
    button = designer.window.messages.findChild(object, "message_action_Recover")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert designer.store.value.lab_at(15.0)[0] == 77.5
    assert not designer.store.is_clean
    assert designer.window.isWindowModified()
    designer.close()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_program_at_once_and_keeps_the_work(number, own_session):
    with dragging() as process:
        process.send_signal(number)
        assert process.wait(120) == 0
    (file,) = own_session.rglob("*.recovery.json")
    assert json.loads(file.read_text())["document"]["measurements"][0]["lab"][0] == 77.5
