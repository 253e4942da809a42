"""A palette file read in the background: what it holds, its rows, and what the user is to know about it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from brdf_qt.file_stamp import FileStamp, stamp_of

from brdf_color_swatch.columns import rows_of
from brdf_color_swatch.rows import Rows
from brdf_suite.documents.palette import Palette
from brdf_suite.progress import Progress

OURS = "brdfpalette"


@dataclass(frozen=True, eq=False)
class Read:
    """What a file held. ``is_ours``: it is a ``.brdfpalette``, which holds all that a palette has."""

    path: Path
    palette: Palette
    rows: Rows
    stamp: FileStamp | None
    is_ours: bool
    notices: tuple[str, ...] = ()


def read_palette_file(path: Path, progress: Progress) -> Read:
    """Read ``path`` of any format; raise :class:`~brdf_suite.errors.FileError` where it cannot be."""
    # With it come the parsers of every format: not at the start of the program.
    from brdf_suite.files.palettes import read_palette

    # Before the content: a change in between is then asked about once too often, never lost.
    stamp = stamp_of(path)
    progress(0.0, path.name)
    read = read_palette(path)
    progress(0.8, path.name)
    rows = rows_of(read.palette.entries)
    return Read(path.absolute(), read.palette, rows, stamp, read.format.name == OURS, tuple(read.notes))
