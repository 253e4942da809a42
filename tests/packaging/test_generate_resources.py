"""The generator writes the packaged files again, and says what it does not know."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def generate(checkout: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(checkout / "packaging" / "generate_resources.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


def test_the_same_code_writes_the_same_files(checkout: Path, tmp_path: Path) -> None:
    """The paints, as the quickest kind; forms and environments are compared in their own rooms' tests."""
    done = generate(checkout, "paints", "--output", str(tmp_path))
    assert done.returncode == 0, done.stderr
    written = {path.name: path.read_bytes() for path in (tmp_path / "paints").iterdir()}
    packaged = {path.name: path.read_bytes() for path in (checkout / "resources" / "paints").iterdir()}
    assert len(written) >= 12
    assert written == packaged
    assert all(f"paints/{name}" in done.stdout for name in written)


def test_an_unknown_kind_is_named(checkout: Path) -> None:
    done = generate(checkout, "posters")
    assert done.returncode == 2
    assert "'posters' is none of paints, meshes, environments" in done.stderr
