"""A palette file read in the background: what it holds, its rows, and what the user is to know about it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from brdf_qt.documents.stamp import FileStamp, stamp_of

from brdf_color_swatch.grid.columns import rows_of
from brdf_color_swatch.grid.rows import Rows
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, load_palette
from brdf_suite.errors import DocumentError, FileError
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
    # Before the content: a change in between is then asked about once too often, never lost.
    stamp = stamp_of(path)
    progress(0.0, path.name)
    palette, notes, ours = _content(path)
    progress(0.8, path.name)
    return Read(path.absolute(), palette, rows_of(palette.entries), stamp, ours, notes)


def _content(path: Path) -> tuple[Palette, tuple[str, ...], bool]:
    own: DocumentError | None = None
    if path.suffix.lower() == PALETTE_ENDING:
        try:
            return load_palette(path), (), True
        except DocumentError as error:
            # Perhaps another program's file under our ending; otherwise this is the error to report.
            own = error
    # With it come the parsers of every format, which our own palettes need not wait for.
    from brdf_suite.files.palettes import read_palette

    try:
        read = read_palette(path)
    except FileError:
        if own is not None:
            raise own from None
        raise
    return read.palette, tuple(read.notes), read.format.name == OURS
