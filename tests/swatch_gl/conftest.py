"""A screen for the map in three dimensions: Qt's offscreen platform has no OpenGL."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

_path = Path(__file__).resolve().parent.parent / "qt_gl" / "xvfb.py"
_spec = importlib.util.spec_from_file_location("xvfb", _path)
xvfb = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(xvfb)


@pytest.fixture(scope="session", autouse=True)
def screen() -> None:
    """The display on which this session's widgets are shown."""
    xvfb.use_screen()
