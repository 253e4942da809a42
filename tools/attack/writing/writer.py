"""What the harness knows of one writer, and versions of paints and palettes to be written."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.pipeline.material import load_shipped_paint

VERSIONS = 200
FILL = "x" * 60_000
"""Notes that make a document long enough for kills to hit its writing."""


@dataclass(frozen=True)
class Writer:
    """What writes one kind of file.

    ``write(folder, number)`` writes version ``number``, below :data:`VERSIONS`; ``read(folder)`` returns the version
    that is there and raises where it is damaged. ``optional``: a cache, which may lose anything and serves no wrong
    value; ``read`` then returns -1, and ``write`` may report with a ValueError that it cannot keep anything.
    ``is_forced``: it promises to outlive a power loss; the list of open tabs does not, but the work in them.
    ``in_slices``: killed in the tests and short runs, too, and not in the long run alone.
    """

    name: str
    write: Callable[[Path, int], object]
    read: Callable[[Path], int]
    optional: bool = False
    is_forced: bool = True
    in_slices: bool = True


def paint(number: int) -> Any:
    """Return a paint that is named after a version, long enough for kills to hit its writing."""
    return replace(load_shipped_paint("blue"), name=f"v{number}", notes=FILL)


def version_of(name: str) -> int:
    """Return the version that a name stands for."""
    return int(name.removeprefix("v"))


def palette(number: int) -> Palette:
    """Return a palette whose entries have the names and colours of one version."""
    entries = tuple(Entry(FlatColour(f"v{number}", "RGB", (number / 255.0, 0.4, 0.6))) for _ in range(300))
    return Palette(f"v{number}", entries)


def read_one(names: Iterable[str]) -> int:
    """Return the version that all of these names stand for; :class:`ValueError` where there are several or none."""
    found = set(names)
    if len(found) != 1:
        raise ValueError(f"versions are mixed: {sorted(found)[:4]}")
    return version_of(found.pop())
