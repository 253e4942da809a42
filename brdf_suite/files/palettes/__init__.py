"""Palette files of other programs: a registry of formats, each with the losses of its conversion."""

from brdf_suite.files.palettes.format import PaletteFormat, ReadPalette, WrittenPalette
from brdf_suite.files.palettes.registry import (
    FORMATS,
    format_for,
    format_named,
    losses,
    read_content,
    read_palette,
    sniff,
    write_palette,
)

__all__ = [
    "FORMATS",
    "PaletteFormat",
    "ReadPalette",
    "WrittenPalette",
    "format_for",
    "format_named",
    "losses",
    "read_content",
    "read_palette",
    "sniff",
    "write_palette",
]
