"""An X server without a screen, for tests of OpenGL widgets: Qt's offscreen platform has none."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest
from PySide6.QtGui import QGuiApplication

_servers: list[subprocess.Popen[bytes]] = []
_OWNER = "BRDF_SUITE_TESTS_SCREEN_OF"
_HOLD = '"$@" & server=$!; read -r _; kill $server'
"""The server lives as long as the pipe to this process, so it also ends when the tests are killed."""


def use_screen() -> None:
    """Point Qt at an X server, started where there is none; before any QApplication exists."""
    if sys.platform != "linux":
        return
    application = QGuiApplication.instance()
    if application is not None and application.platformName() != "xcb":
        pytest.fail(
            f"windows are on {application.platformName()!r} in this process already: run this test in another"
        )
    os.environ["QT_QPA_PLATFORM"] = "xcb"
    os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
    if os.environ.get(_OWNER) == str(os.getpid()):
        return  # another folder of tests has started one in this process
    # Windows of two workers on one screen would take the focus from each other.
    if os.environ.get("DISPLAY") and "PYTEST_XDIST_WORKER" not in os.environ:
        return
    program = shutil.which("Xvfb")
    if program is None:
        pytest.skip("no screen and no Xvfb: install the package xvfb")
    reader, writer = os.pipe()
    command = [program, "-displayfd", str(writer), "-screen", "0", "2000x1300x24", "-nolisten", "tcp"]
    # A server begins anew when its last client has gone, and refuses those that come meanwhile.
    command.append("-noreset")
    server = subprocess.Popen(
        ["sh", "-c", _HOLD, "sh", *command],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        pass_fds=[writer],
    )
    os.close(writer)
    _servers.append(server)
    with os.fdopen(reader) as answer:
        number = answer.readline().strip()
    if not number:
        pytest.skip("Xvfb did not start")
    os.environ["DISPLAY"] = f":{number}"
    os.environ[_OWNER] = str(os.getpid())
