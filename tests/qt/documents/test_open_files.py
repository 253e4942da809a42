"""Files of a file manager go to the program that runs already."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
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


def test_the_running_program_gets_the_files(qtbot, listening, tmp_path) -> None:
    files = [tmp_path / "a.brdfview", tmp_path / "ä b.brdfview"]
    with ThreadPoolExecutor(1) as other, qtbot.waitSignal(listening.requested) as got:
        taken = other.submit(hand_over, "viewer", files)
    assert taken.result() is True
    assert got.args == [files]


def test_names_are_made_absolute_where_they_are_given(qtbot, listening, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    with ThreadPoolExecutor(1) as other, qtbot.waitSignal(listening.requested) as got:
        other.submit(hand_over, "viewer", [Path("a.brdfview")])
    assert got.args == [[tmp_path / "a.brdfview"]]


def test_nobody_runs(listening, tmp_path) -> None:
    assert hand_over("designer", [tmp_path / "a.brdfpaint"]) is False
    listening.close()
    assert hand_over("viewer", [tmp_path / "a.brdfview"]) is False


def test_the_second_program_does_not_listen_until_the_first_has_ended(qtbot, listening, tmp_path) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    second = OpenFiles("viewer", window)
    with ThreadPoolExecutor(1) as other, qtbot.waitSignal(listening.requested):
        other.submit(hand_over, "viewer", [tmp_path / "a.brdfview"])
    second.close()
    listening.close()
    third = OpenFiles("viewer", window)
    with ThreadPoolExecutor(1) as other, qtbot.waitSignal(third.requested):
        other.submit(hand_over, "viewer", [tmp_path / "b.brdfview"])
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
        started = subprocess.Popen(command)
    assert got.args == [[Path(paint)]]
    assert started.wait() == 0


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
