"""A save that fails leaves the old file whole and nothing beside it."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import load_paint, save_paint
from brdf_suite.errors import FileError

OLD = solid_paint("old", (50.0, 0.0, 0.0))

SAVE_NEW = """
import dataclasses, sys
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError
new = dataclasses.replace(solid_paint("new", (60.0, 0.0, 0.0)), notes="n" * 90_000)
try:
    save_paint(new, sys.argv[1])
except FileError as error:
    print(error)
    sys.exit(3)
"""


def run(prelude: str, path: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", prelude + SAVE_NEW, str(path)]
    return subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "paint.brdfpaint"
    save_paint(OLD, path)
    return path


@pytest.mark.parametrize("step", ["os.fsync", "os.replace"])
def test_a_kill_before_the_last_step_keeps_the_old_file(path: Path, step: str) -> None:
    kill = f"import os, signal\n{step} = lambda *a: os.kill(os.getpid(), signal.SIGKILL)\n"
    assert run(kill, path).returncode == -signal.SIGKILL
    assert load_paint(path) == OLD
    assert len(list(path.parent.iterdir())) == 2, "the process died in the middle of a save"
    assert run("", path).returncode == 0
    assert load_paint(path).name == "new", "what the dead one left is no obstacle"


def test_a_full_disk_keeps_the_old_file(path: Path) -> None:
    # The limit makes the system refuse to let a file grow past 20,000 bytes, in the middle of the writing.
    full = "import resource\nresource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))\n"
    result = run(full, path)
    assert (result.returncode, result.stderr) == (3, "")
    assert f"{path}: cannot be written: File too large." in result.stdout
    assert load_paint(path) == OLD
    assert list(path.parent.iterdir()) == [path]


def test_a_failing_replace_keeps_the_old_file(path: Path, full_disk: None) -> None:
    with pytest.raises(FileError, match="No space left on device"):
        save_paint(solid_paint("new", (60.0, 0.0, 0.0)), path)
    assert load_paint(path) == OLD
    assert list(path.parent.iterdir()) == [path]


def test_places_that_cannot_be_written_are_named(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"none.*cannot be written: No such file"):
        save_paint(OLD, tmp_path / "none" / "a.brdfpaint")
    with pytest.raises(FileError, match="not a plain file"):
        save_paint(OLD, tmp_path)
