""".brdfpalette as a palette format: lossless."""

from __future__ import annotations

import re

from brdf_suite.documents.flat_colour import MODELS
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, encode_palette, palette_from_bytes
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.format import PaletteFormat

_HEAD = re.compile(rb'\s*\{\s*"format"\s*:\s*"brdfpalette"')


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a ``.brdfpalette`` file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    return palette_from_bytes(content, path), ()


FORMAT = PaletteFormat(
    name="brdfpalette",
    title="BRDF Suite palette",
    endings=(PALETTE_ENDING,),
    models=MODELS,
    groups="nested",
    paints=True,
    holds="Everything.",
    sniff=lambda head, _size: bool(_HEAD.match(head.removeprefix(b"\xef\xbb\xbf"))),
    read=read,
    write=encode_palette,
)
