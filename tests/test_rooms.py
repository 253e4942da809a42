"""What a room may import, seen in a fresh process."""

from __future__ import annotations

import subprocess
import sys

import pytest

QT = {"PySide6", "shiboken6", "pyqtgraph", "qtpy", "superqt"}
HEAVY = {"moderngl", "mitsuba", "trimesh", "OpenImageIO", "OpenEXR", "colour", "scipy.optimize"}


def modules_after(statement: str) -> set[str]:
    code = f"{statement}\nimport sys\nprint('\\n'.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=240
    )
    return set(done.stdout.split())


@pytest.mark.parametrize("room", ["documents", "geometry", "appearance", "reflectance", "fitting"])
def test_the_edit_path_rooms_import_neither_qt_nor_anything_heavy(room: str) -> None:
    assert not modules_after(f"import pkgutil, brdf_suite.{room} as r") & (QT | HEAVY)


def test_a_paint_is_fitted_without_qt_opengl_or_readers() -> None:
    loaded = modules_after(
        "from brdf_suite.pipeline.lobe_fit import PaintFitter\n"
        "from brdf_suite.pipeline.material import default_paint\n"
        "PaintFitter().fit(default_paint())"
    )
    assert not loaded & (QT | HEAVY)


def test_a_picture_is_rendered_without_qt() -> None:
    loaded = modules_after("import brdf_suite.pipeline.picture, brdf_suite.cli.main")
    assert not loaded & QT
    assert "moderngl" in loaded


SLOW_STARTS = {
    "pyqtgraph",
    "OpenGL",
    "scipy.special",
    "scipy.ndimage",
    "numpy.ma",
    "importlib.metadata",
    "xml.sax",
}


@pytest.mark.parametrize("program", ["brdf_designer", "brdf_lobe_visualizer"])
def test_the_first_painted_window_waits_for_nothing_that_it_does_not_show(program: str) -> None:
    assert not modules_after(f"import {program}.assembly") & (SLOW_STARTS | HEAVY)


def test_the_command_helps_without_the_core() -> None:
    assert not modules_after("from brdf_suite.cli.main import parser; parser()") & (QT | HEAVY | {"numpy"})
