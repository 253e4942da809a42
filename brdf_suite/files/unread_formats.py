"""Formats that are known and not read: refused by name, with another way to what is in them."""

from __future__ import annotations

import re
from pathlib import Path

from brdf_suite.errors import PathLike, UnreadFormatError

_HDF5 = b"\x89HDF\r\n\x1a\n"
_SECTION = re.compile(rb"(?:\xef\xbb\xbf)?(?:\s*[;#][^\r\n]*[\r\n])*\s*\[[^\W\d][^\]\r\n]*\]\s*[\r\n]")
"""The first lines of settings: comments, and the name of a section in brackets on a line of its own."""


def refuse_axf(head: bytes, path: PathLike) -> None:
    """Raise :class:`UnreadFormatError` where a file is AxF, by the start of an HDF5 container or by its ending."""
    if head.startswith(_HDF5) or Path(path).suffix.lower() == ".axf":
        raise UnreadFormatError(
            path,
            "is an AxF material or another HDF5 container, which is not read; export its measurements as CxF3 (see "
            "the page “AxF” of the manual)",
            "byte 0",
        )


def refuse_theme(head: bytes, path: PathLike) -> None:
    """Raise :class:`UnreadFormatError` where a file holds settings in sections, as desktop themes do."""
    if _SECTION.match(head):
        raise UnreadFormatError(
            path,
            "is a desktop theme or a colour scheme of windows (settings in sections), which is not read; write its "
            "colours as hex codes, one a line",
            "line 1",
        )
