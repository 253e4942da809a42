"""An environment without optional packages, for real processes."""

from __future__ import annotations

import importlib.util
import os
import shutil
import uuid
from pathlib import Path

import numpy as np
import pytest
from filelock import FileLock

from brdf_suite.cli.main import main
from brdf_suite.files.images.environments import write_exr

_CHECKOUT = Path(__file__).resolve().parents[2]
_SOURCE = (_CHECKOUT, _CHECKOUT / "apps")
_FILE = Path(__file__).parent.parent / "qt_gl" / "xvfb.py"
_spec = importlib.util.spec_from_file_location("xvfb", _FILE)
xvfb = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(xvfb)


@pytest.fixture(scope="session")
def screen() -> None:
    """The display on which the programs open their windows."""
    xvfb.use_screen()


@pytest.fixture(scope="session")
def session(cache_folder: Path) -> Path:
    """Photographs of a sphere and of a board: made once for all workers, which only copy them."""
    place = cache_folder / "tests" / "session"
    place.parent.mkdir(parents=True, exist_ok=True)
    with FileLock(f"{place}.lock"):
        if not place.exists():
            made = place.with_name("session in work")
            rig = ["--size", "48x48", "--positions", "4", "--exposures", "3"]
            assert main(["acquire", str(made), "--simulate", "blue", *rig]) == 0
            made.rename(place)
    return place


@pytest.fixture
def folder(tmp_path: Path, session: Path) -> Path:
    """A light, a palette and photographs."""
    write_exr(tmp_path / "light.exr", np.ones((8, 16, 3), np.float32))
    (tmp_path / "list.gpl").write_text("GIMP Palette\nName: List\n#\n 80  20  40\tOne\n")
    shutil.copytree(session, tmp_path / "session")
    return tmp_path


@pytest.fixture
def without_extras(shared_cache: Path, tmp_path: Path) -> dict[str, str]:
    """Variables of a process in which no optional package is installed, with settings of its own."""
    return {
        **os.environ,
        # With the source, too, so that child processes keep the variable.
        "PYTHONPATH": os.pathsep.join(map(str, (Path(__file__).parent / "blocked", *_SOURCE))),
        "PYTHONWARNINGS": "default",
        "BRDF_SUITE_SETTINGS": str(tmp_path / "settings"),
        "BRDF_SUITE_LINK": f"test-{uuid.uuid4().hex[:12]}",
    }
