"""Palette files of other programs: a registry of formats, each with the losses of its conversion."""

from brdf_suite.files.palettes.format import PaletteFormat, ReadPalette, WrittenPalette
from brdf_suite.files.palettes.registry import (
    FORMATS,
    find_format,
    format_for,
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
    "find_format",
    "format_for",
    "losses",
    "read_content",
    "read_palette",
    "sniff",
    "write_palette",
]
