"""A save that fails leaves the old file whole and nothing beside it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from brdf_suite.documents.atomic import documents_in, is_unfinished, remove_unfinished, replacing
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


def test_what_a_killed_writer_left_goes_with_the_next_save(path: Path) -> None:
    kill = "import os, signal\nos.fsync = lambda *a: os.kill(os.getpid(), signal.SIGKILL)\n"
    assert run(kill, path).returncode == -signal.SIGKILL
    other = path.with_name(".paint.brdfpaint")  # a document whose name is a hidden one
    save_paint(OLD, other)
    (left,) = [file for file in path.parent.iterdir() if is_unfinished(file)]
    assert list(documents_in(path.parent, ".brdfpaint")) != []
    assert left not in documents_in(path.parent, ".brdfpaint")
    save_paint(OLD, path)
    assert sorted(path.parent.iterdir()) == sorted([path, other])


def test_what_another_writer_is_writing_stays(path: Path) -> None:
    with replacing(path) as first:
        first.write_bytes(b"half")
        remove_unfinished(path)
        assert first.exists()
        save_paint(OLD, path)
        assert first.exists()
        first.write_bytes(path.read_bytes())
    assert list(path.parent.iterdir()) == [path]


def test_an_empty_one_is_forgotten_after_a_while(path: Path) -> None:
    empty = path.with_name(".paint.0123456789abcdef.brdfpaint")
    empty.touch()
    remove_unfinished(path)
    assert empty.exists()
    os.utime(empty, (0, 0))
    remove_unfinished(path)
    assert not empty.exists()
