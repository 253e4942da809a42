"""Registry entry of a palette format, that of our own, and the results of reading and writing one."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from brdf_suite.documents.flat_colour import MODELS
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, encode_palette, palette_from_bytes
from brdf_suite.errors import PathLike

_OWN_HEAD = re.compile(rb'\s*\{\s*"format"\s*:\s*"brdfpalette"')

Groups = Literal["none", "flat", "nested"]

Order = Literal["kept", "by groups", "none first"]

LARGEST = 64 << 20
"""Bytes of a foreign palette; a hundred thousand colours with names have about five million."""


@dataclass(frozen=True)
class ReadPalette:
    """A palette read from a file, with notices of repairs, assumptions and omissions."""

    palette: Palette
    notes: tuple[str, ...]
    format: PaletteFormat


@dataclass(frozen=True)
class WrittenPalette:
    """Result of writing a palette: the format, the number of bytes, and the losses, in sentences."""

    format: PaletteFormat
    size: int
    losses: tuple[str, ...]


@dataclass(frozen=True)
class PaletteFormat:
    """A palette format.

    Parameters
    ----------
    name
        Short, as a command-line word.
    title
        For lists and dialogs.
    endings
        Lower case, with the dot; the first is the usual one.
    models
        The models of flat colours that keep their own numbers.
    holds
        What it carries, a sentence for the user.
    sniff
        ``(head, size) -> bool``: whether the first bytes (up to 64 KiB) of a file of ``size`` bytes are of this format.
        It may not raise.
    read
        ``(content, path) -> (palette, notes)``; a :class:`~brdf_suite.errors.FileError` with the place where it is
        damaged. ``path`` is what messages call it, and where a file says no name its stem is the palette's.
    write
        ``palette -> content``, or None where the format is only read. What it cannot hold is found by reading the
        content back (:mod:`brdf_suite.files.palettes.losses`).
    groups
        Whether there are groups, and groups within groups.
    unique_names
        Whether no two colours may have one name there, and none no name: such names are written with a number.
    paints
        Whether it holds the readings of a paint at several angles.
    order
        In which order entries are written: as they stand, by groups (:meth:`Palette.sections`), or by groups with those
        in none before all others.
    """

    name: str
    title: str
    endings: tuple[str, ...]
    models: tuple[str, ...]
    holds: str
    sniff: Callable[[bytes, int], bool]
    read: Callable[[bytes, PathLike], tuple[Palette, tuple[str, ...]]]
    write: Callable[[Palette], bytes] | None = None
    groups: Groups = "none"
    unique_names: bool = False
    paints: bool = False
    order: Order = "kept"


OWN = PaletteFormat(
    name="brdfpalette",
    title="BRDF Suite palette",
    endings=(PALETTE_ENDING,),
    models=MODELS,
    holds="Everything.",
    sniff=lambda head, _size: bool(_OWN_HEAD.match(head.removeprefix(b"\xef\xbb\xbf"))),
    read=lambda content, path: (palette_from_bytes(content, path), ()),
    write=encode_palette,
    groups="nested",
    paints=True,
)
"""``.brdfpalette``: lossless."""
