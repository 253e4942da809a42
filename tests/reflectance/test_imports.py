"""What importing the rooms below the programs brings with it."""

from __future__ import annotations

import subprocess
import sys

import pytest

SCRIPT = """
import importlib, pkgutil, sys
for room in ("documents", "geometry", "appearance", "reflectance"):
    package = importlib.import_module(f"brdf_suite.{room}")
    for module in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        importlib.import_module(module.name)
from brdf_suite.documents.paint import solid_paint
from brdf_suite.reflectance.designed.build import build_paint
build_paint(solid_paint("white", (95.0, 0.0, 0.0)))
print("\\n".join(sys.modules))
"""


@pytest.fixture(scope="module")
def loaded() -> set[str]:
    """The modules of a fresh process that imported every module of the rooms and built a paint."""
    result = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT], capture_output=True, text=True, timeout=240, check=True
    )
    return set(result.stdout.split())


@pytest.mark.parametrize(
    "unwanted",
    ["PySide6", "shiboken6", "qtpy", "moderngl", "scipy", "highspy", "trimesh", "OpenImageIO", "colour"],
)
def test_nothing_heavy_comes_along(loaded: set[str], unwanted: str) -> None:
    assert "brdf_suite.reflectance.designed.build" in loaded
    assert unwanted not in {name.partition(".")[0] for name in loaded}


def test_no_room_above_is_needed(loaded: set[str]) -> None:
    rooms = {name.split(".")[1] for name in loaded if name.startswith("brdf_suite.")}
    assert rooms <= {
        "documents",
        "geometry",
        "appearance",
        "reflectance",
        "errors",
        "resources",
        "progress",
        "arrays",
        "notebook",
        "release",
        "plugins",
        "processes",
        "regular_files",
    }
