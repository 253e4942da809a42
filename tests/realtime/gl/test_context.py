"""Where OpenGL is missing or too old, a sentence says so; each in a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from brdf_suite.realtime.gl.context import draws_in_software

SCRIPT = """
from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.gl.context import create_context
try:
    print("made", create_context().version_code)
except GraphicsError as error:
    print("refused:", error)
"""

linux = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="changes EGL's and Mesa's own variables"
)


def start(**variables: str) -> str:
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"} | variables
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT],
        env=environment,
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    return done.stdout


@pytest.fixture
def software(context):
    """Whether Mesa draws here."""
    return draws_in_software(context)


def test_without_a_display():
    assert start().startswith("made 3") or start().startswith("made 4")


@linux
def test_no_driver(tmp_path):
    nothing = str(tmp_path)
    said = start(
        __EGL_VENDOR_LIBRARY_DIRS=nothing, __EGL_VENDOR_LIBRARY_FILENAMES="", LIBGL_DRIVERS_PATH=nothing
    )
    assert said.startswith("refused: No OpenGL 3.3 context could be made (")
    assert "Install" in said


@linux
def test_too_old(software):
    if not software:
        pytest.skip("the version of this driver cannot be lowered")
    said = start(MESA_GL_VERSION_OVERRIDE="2.1", LIBGL_ALWAYS_SOFTWARE="1")
    assert said.startswith("refused: ")
    assert "OpenGL 3.3" in said


@linux
def test_no_current_context_to_adopt():
    script = SCRIPT.replace("create_context", "adopt_context")
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=240, check=True
    )
    assert "no usable OpenGL context" in done.stdout


def test_import_is_cheap_and_without_qt():
    code = "import sys, brdf_suite.realtime.pictures.renderer\n"
    code += "print([m for m in ('PySide6', 'scipy', 'OpenGL', 'PIL') if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=240, check=True
    )
    assert done.stdout.strip() == "[]"
