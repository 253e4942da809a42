"""The X server goes while a program draws: the process ends at once."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest

_PROGRAM = """
import ctypes, os, subprocess, sys
reader, writer = os.pipe()
server = subprocess.Popen(
    ["Xvfb", "-displayfd", str(writer), "-nolisten", "tcp"], pass_fds=[writer], stderr=subprocess.DEVNULL
)
os.environ["DISPLAY"] = ":" + os.read(reader, 20).decode().strip()
x11 = ctypes.CDLL("libX11.so.6")
x11.XOpenDisplay.restype = ctypes.c_void_p
from brdf_qt.program.application import create_application
app = create_application("Screen", ["screen"], theme_name="dark")
at_exit = ctypes.CFUNCTYPE(None)(lambda: os.write(1, b"destroyed"))
ctypes.CDLL(None).__cxa_atexit(at_exit, None, None)
display = ctypes.c_void_p(x11.XOpenDisplay(None))
server.kill()
server.wait()
x11.XSync(display, 0)
os.write(1, b"still there")
"""


@pytest.mark.skipif(sys.platform != "linux", reason="X11 is of Linux")
@pytest.mark.skipif(shutil.which("Xvfb") is None, reason="no Xvfb: install the package xvfb")
def test_the_process_ends_with_its_x_server_and_destroys_nothing_that_threads_use() -> None:
    """Xlib would call ``exit`` of C; with threads at work the process then breaks down or stays for ever."""
    done = subprocess.run(
        [sys.executable, "-c", _PROGRAM],
        env={**os.environ, "QT_QPA_PLATFORM": "xcb"},
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    said = "The connection to the X server broke.\n"
    assert (done.returncode, done.stdout, done.stderr) == (1, "", said)
