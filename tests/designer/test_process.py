"""Designer as a process: start-up, pictures, signals, and what a kill leaves."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from brdf_designer.assembly import Designer
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage

from brdf_suite.pipeline.material import load_shipped_paint

HERE = Path(__file__).parent
SLOW = {
    "trimesh",
    "moderngl",
    "colour",
    "OpenImageIO",
    "scipy.optimize",
    "mitsuba",
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
    # The modules are looked at in the first turn after the start, before what waits for a pause of the edits begins.
    code = (
        "import sys; from brdf_designer.command_line import main; from brdf_designer.assembly import Designer;"
        "from PySide6.QtCore import QTimer; look = lambda: print(sorted(sys.modules));"
        "start = Designer.start; Designer.start = lambda self: (start(self), QTimer.singleShot(0, look));"
        "sys.exit(main(['--quit-after', '0']))"
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


@pytest.mark.usefixtures("shared_cache")
def test_a_screenshot_shows_the_paint(tmp_path):
    words = ("--report-startup", "--screenshot", str(tmp_path / "a.png"))
    done = run("red", "--theme", "light", "--size", "900x600", *words)
    assert done.returncode == 0, done.stderr
    times = json.loads(done.stdout.splitlines()[-1])
    assert times["complete_s"] <= times["finished_s"]
    picture = QImage(str(tmp_path / "a.png"))
    assert (picture.width(), picture.height()) == (900, 600)
    reds = sum(
        picture.pixelColor(x, y).red() > 2 * picture.pixelColor(x, y).green() + 20
        for x in range(0, 500, 10)
        for y in range(400, 600, 2)
    )
    assert reds > 400


def test_a_missing_file_is_reported_and_the_program_runs(tmp_path):
    done = run(str(tmp_path / "none.brdfpaint"), "--quit-after", "0")
    assert done.returncode == 0
    assert "Traceback" not in done.stderr


@contextmanager
def dragging() -> Iterator[Callable[[str], None]]:
    """Yield what gives the program an order and waits until it says that it has done it."""
    with subprocess.Popen(
        [sys.executable, str(HERE / "edit_and_wait.py")],
        env=environment(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None

        def order(line: str) -> None:
            process.stdin.write(line + "\n")
            process.stdin.flush()
            answers = {"edit": "edited", "tab": "opened"}
            word, what = line.split()
            assert process.stdout.readline() == f"{answers[word]} {what}\n"

        order.process = process
        try:
            assert process.stdout.readline() == "ready\n"
            yield order
        finally:
            process.kill()


def kept(session: Path) -> dict[str, float]:
    """Return the L* at 15° of every autosaved paint, by its name."""
    found = {}
    for file in session.rglob("*.recovery.json"):
        document = json.loads(file.read_text())["document"]
        found[document["name"]] = document["measurements"][0]["lab"][0]
    return found


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system has no kill -9")
def test_a_kill_in_the_middle_of_a_drag_keeps_the_work_of_every_tab(qtbot, dialogs, monkeypatch, own_session):
    with dragging() as order:
        order("edit 77.5")
        order("tab red")
        order("edit 40.0")
        # The autosaves come while the drag goes on, by their own timer: nothing is let go, saved or closed.
        qtbot.waitUntil(lambda: kept(own_session) == {"Blue": 77.5, "Red": 40.0})
        # What is edited from here on is younger than the last autosave, and may be lost with it.
        order("edit 41.0")
        order.process.send_signal(signal.SIGKILL)
        order.process.wait(120)
    assert kept(own_session)["Red"] >= 40.0
    # The settings are named after the program; this test's own process is another one.
    monkeypatch.setattr("brdf_qt.program.settings.QCoreApplication.applicationName", lambda: "Designer")
    designer = Designer(dialogs=lambda _window: dialogs)
    qtbot.addWidget(designer.window)
    designer.window.show()
    qtbot.waitUntil(lambda: "recovery" in designer.window.messages.shown())
    offer = designer.window.messages.shown()["recovery"].what
    assert "2 paints" in offer
    # The newest is named first.
    assert offer.index("Red") < offer.index("Blue")
    button = designer.window.messages.findChild(object, "message_action_Recover All")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    row = designer.documents.row
    assert {d.title: d.store.value.lab_at(15.0)[0] for d in row}["Blue"] == 77.5
    assert [d.title for d in row] == ["Blue", "Red"]
    assert designer.documents.front.title == "Red"
    assert designer.store.value.lab_at(15.0)[0] in (40.0, 41.0)
    assert not any(document.store.is_clean for document in row)
    assert designer.window.isWindowModified()
    # Each has its history: the drag is one step, and before it is the shipped paint.
    for document in row:
        edited = document.store.value
        document.store.undo()
        assert document.store.value == load_shipped_paint(edited.name.lower())
        document.store.redo()
        assert document.store.value == edited
    designer.close()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_program_at_once_and_keeps_the_work(number, own_session):
    with dragging() as order:
        order("edit 77.5")
        order.process.send_signal(number)
        assert order.process.wait(120) == 0
    assert kept(own_session) == {"Blue": 77.5}
