"""Files of a file manager go to the program that runs already."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from brdf_qt.link.address import LinkAddress, link_name
from brdf_qt.link.open_files import OpenFiles, hand_over
from brdf_qt.program.suite import MEMBERS
from PySide6.QtNetwork import QLocalSocket
from PySide6.QtWidgets import QWidget

from brdf_suite import variables
from brdf_suite.processes import child_command
from brdf_suite.resources import resource


@pytest.fixture
def listening(qtbot, monkeypatch, tmp_path):
    monkeypatch.setenv(variables.LINK, f"open-{tmp_path.name}")
    window = QWidget()
    qtbot.addWidget(window)
    made = OpenFiles("viewer", window)
    yield made
    made.close()


def started(role: str, files: list[Path], folder: Path | None = None) -> subprocess.Popen[str]:
    """A process that hands files over, and prints whether they were taken.

    Not a thread: waiting for the answer, it would hold the interpreter's lock and so the program that is to answer.
    """
    code = (
        "import sys\nfrom pathlib import Path\nfrom brdf_qt.link.open_files import hand_over\n"
        "print(hand_over(sys.argv[1], [Path(word) for word in sys.argv[2:]]))"
    )
    words = [sys.executable, "-P", "-c", code, role, *map(str, files)]
    return subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, text=True)


def test_the_running_program_gets_the_files(qtbot, listening, tmp_path) -> None:
    files = [tmp_path / "a.brdfview", tmp_path / "ä b.brdfview"]
    with qtbot.waitSignal(listening.requested) as got:
        other = started("viewer", files)
    assert got.args == [files]
    assert other.communicate()[0] == "True\n"


def test_the_answer_does_not_wait_for_the_files_to_be_opened(qtbot, listening, tmp_path) -> None:
    answers = []
    listening.requested.connect(lambda _files: answers.append(other.communicate()[0]))
    other = started("viewer", [tmp_path / "a.brdfview"])
    qtbot.waitUntil(lambda: answers == ["True\n"])


def test_names_are_made_absolute_where_they_are_given(qtbot, listening, tmp_path) -> None:
    with qtbot.waitSignal(listening.requested) as got:
        other = started("viewer", [Path("a.brdfview")], tmp_path)
    assert got.args == [[tmp_path / "a.brdfview"]]
    assert other.communicate()[0] == "True\n"


def test_a_file_that_macos_opens_is_taken(tmp_path) -> None:
    code = (
        "from brdf_qt.program.application import create_application\n"
        "from PySide6.QtGui import QFileOpenEvent\n"
        "app = create_application('Viewer')\n"
        "app.file_opened.connect(lambda file: print('opened', file))\n"
        "print(app.sendEvent(app, QFileOpenEvent('/a b.brdfview')))"
    )
    done = subprocess.run([sys.executable, "-P", "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split("\n")[:2] == ["opened /a b.brdfview", "True"]


def test_nobody_runs(listening, tmp_path) -> None:
    assert hand_over("designer", [tmp_path / "a.brdfpaint"]) is False
    listening.close()
    assert hand_over("viewer", [tmp_path / "a.brdfview"]) is False


def test_the_second_program_does_not_listen_until_the_first_has_ended(qtbot, listening, tmp_path) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    second = OpenFiles("viewer", window)
    with qtbot.waitSignal(listening.requested):
        first_files = started("viewer", [tmp_path / "a.brdfview"])
    assert first_files.communicate()[0] == "True\n"
    second.close()
    listening.close()
    third = OpenFiles("viewer", window)
    with qtbot.waitSignal(third.requested):
        second_files = started("viewer", [tmp_path / "b.brdfview"])
    assert second_files.communicate()[0] == "True\n"
    third.close()


@pytest.mark.parametrize(
    "line",
    [
        b"not json\n",
        b"[]\n",
        b'"a"\n',
        b"[1]\n",
        b'["relative.brdfview"]\n',
        b'["/a\\u0000b"]\n',
        b"[" * 30_000 + b"\n",
        b'["' + b"x" * 70_000 + b'"]\n',
        b'["/' + b"x" * 200_000,
    ],
)
def test_other_messages_are_dropped(qtbot, listening, line) -> None:
    seen = []
    listening.requested.connect(seen.append)
    socket = QLocalSocket()
    socket.connectToServer(LinkAddress(f"{link_name()}-viewer").socket_name)
    qtbot.waitUntil(lambda: socket.state() == QLocalSocket.LocalSocketState.ConnectedState)
    socket.write(line)
    qtbot.waitUntil(lambda: socket.state() == QLocalSocket.LocalSocketState.UnconnectedState)
    assert seen == []


def test_a_command_with_a_file_ends_where_the_program_runs(qtbot, listening) -> None:
    paint = str(resource("paints", "blue.brdfpaint"))
    command = child_command(MEMBERS["viewer"].package, "--open", paint)
    with qtbot.waitSignal(listening.requested) as got:
        child = subprocess.Popen(command)
    assert got.args == [[Path(paint)]]
    assert child.wait() == 0


def test_a_command_opens_the_file_itself_where_none_runs(tmp_path, monkeypatch) -> None:
    monkeypatch.setenv(variables.LINK, f"open-{tmp_path.name}")
    paint = resource("paints", "copper.brdfpaint")
    words = ["--open", str(paint), "--screenshot", str(tmp_path / "window.png")]
    done = subprocess.run(
        child_command(MEMBERS["designer"].package, *words), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "window.png").is_file()


def test_a_program_has_its_icon(tmp_path) -> None:
    code = (
        "from brdf_qt.program.application import create_application\n"
        "app = create_application('Color Swatch')\n"
        "assert not app.windowIcon().isNull() and app.windowIcon().availableSizes()\n"
        "assert app.desktopFileName() == 'brdf-swatch'\n"
    )
    subprocess.run([sys.executable, "-P", "-c", code], check=True)
