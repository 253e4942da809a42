"""The generator writes the packaged files again, and says what it does not know."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def generate(checkout: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(checkout / "packaging" / "generators" / "resources.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)


def contents(folder: Path) -> dict[str, bytes]:
    """The files of a folder and those below it, by their names from it."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def test_the_same_code_writes_the_same_files(checkout: Path, tmp_path: Path) -> None:
    """The paints, as the quickest kind; forms and environments are compared in their own rooms' tests."""
    done = generate(checkout, "paints", "--output", str(tmp_path))
    assert done.returncode == 0, done.stderr
    written, packaged = contents(tmp_path / "paints"), contents(checkout / "resources" / "paints")
    assert len(written) >= 30
    assert any(name.startswith("cook_torrance/") for name in written)
    assert written == packaged
    assert all(f"paints/{name}" in done.stdout for name in written)


def test_an_unknown_kind_is_named(checkout: Path) -> None:
    done = generate(checkout, "posters")
    assert done.returncode == 2
    assert (
        "'posters' is none of paints, meshes, environments, occlusion, lobe_maps, thumbnails" in done.stderr
    )
