"""What is published of the checkout, and what installed packages take on disk; the standard library alone."""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import distributions
from pathlib import Path

_SHOWN = 12


def build_wheel(folder: Path) -> Path:
    """Build the wheel of this checkout into an empty folder, without an environment of its own, and return it."""
    checkout = Path(__file__).resolve().parent.parent
    words = ["build", "--wheel", "--no-isolation", "--outdir", str(folder), str(checkout)]
    subprocess.run([sys.executable, "-m", *words], cwd=checkout, check=True, stdout=subprocess.DEVNULL)
    (wheel,) = folder.glob("*.whl")
    return wheel


def build_release(folder: Path) -> tuple[Path, Path]:
    """Build what is published into an empty folder: the source archive, and the wheel from it; return both."""
    checkout = Path(__file__).resolve().parent.parent
    words = ["build", "--no-isolation", "--outdir", str(folder), str(checkout)]
    subprocess.run([sys.executable, "-m", *words], cwd=checkout, check=True, stdout=subprocess.DEVNULL)
    (archive,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    return archive, wheel


def installed_sizes(site_packages: Path) -> dict[str, int]:
    """Return the bytes of each installed package by its name, the largest first, bytecode left out.

    Libraries and metadata of a package count with it. The sum is of files, without what a file system rounds up.
    """
    sizes: dict[str, int] = {}
    for found in distributions(path=[str(site_packages)]):
        paths = (Path(str(found.locate_file(file))) for file in found.files or () if file.suffix != ".pyc")
        sizes[found.name] = sum(path.stat().st_size for path in paths if path.is_file())
    return dict(sorted(sizes.items(), key=lambda item: -item[1]))


def size_lines(sizes: dict[str, int]) -> list[str]:
    """Return the whole size and the largest packages', in 10⁶ bytes, a line each."""
    largest = list(sizes.items())[:_SHOWN]
    rest = sum(sizes.values()) - sum(size for _, size in largest)
    lines = [f"installed: {sum(sizes.values()) / 1e6:.0f} MB in {len(sizes)} packages"]
    lines += [f"  {size / 1e6:6.1f} MB  {name}" for name, size in largest]
    return [*lines, f"  {rest / 1e6:6.1f} MB  the others"] if rest else lines
