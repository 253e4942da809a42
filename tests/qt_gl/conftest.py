"""A screen for OpenGL widgets, which Qt's offscreen platform cannot show: an Xvfb where there is none."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest


def _xvfb() -> subprocess.Popen[bytes] | None:
    """Start an X server on a free display and point Qt at it; before any QApplication exists."""
    os.environ["QT_QPA_PLATFORM"] = "xcb"
    os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
    if os.environ.get("DISPLAY"):
        return None
    program = shutil.which("Xvfb")
    if program is None:
        pytest.skip("no screen and no Xvfb: install the package xvfb", allow_module_level=True)
    reader, writer = os.pipe()
    server = subprocess.Popen(
        [program, "-displayfd", str(writer), "-screen", "0", "1600x1100x24", "-nolisten", "tcp"],
        pass_fds=[writer],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    os.close(writer)
    with os.fdopen(reader) as answer:
        number = answer.readline().strip()
    if not number:
        server.wait()
        pytest.skip(f"Xvfb ended with {server.returncode}", allow_module_level=True)
    os.environ["DISPLAY"] = f":{number}"
    return server


@pytest.fixture(scope="session", autouse=True)
def screen():
    """The display on which this session's widgets are shown."""
    if sys.platform != "linux":
        yield
        return
    server = _xvfb()
    yield
    if server is not None:
        os.environ.pop("DISPLAY", None)
        server.terminate()
        server.wait()
