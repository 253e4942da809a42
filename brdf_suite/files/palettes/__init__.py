"""Palette files of other programs: a registry of formats, each with the losses of its conversion.

A file is known by its content; only where several formats could be meant does its ending decide. A new format is one
module and one line here: every check of the formats goes over this list.
"""

from __future__ import annotations

from pathlib import Path

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import LARGEST_PALETTE, without_collection
from brdf_suite.errors import FileError, PathLike, SuiteError
from brdf_suite.files.palettes.archive import kpl, sbz
from brdf_suite.files.palettes.binary import acb, aco, act, apple_clr, ase, cpl, riff_pal
from brdf_suite.files.palettes.cmyk_profile import profile_note, read_profile, seen_through
from brdf_suite.files.palettes.conversions import split_angles as split_angles
from brdf_suite.files.palettes.format import LARGEST, OWN, PaletteFormat, ReadPalette, WrittenPalette
from brdf_suite.files.palettes.losses import encode_palette, find_losses
from brdf_suite.files.palettes.text import (
    css,
    csv_table,
    gpl,
    hex_list,
    jasc_pal,
    json_tokens,
    scss,
    sketch,
    table,
)
from brdf_suite.files.palettes.xml import autocad, corel, cxf3, instrument, scribus, soc
from brdf_suite.files.unread_formats import refuse_axf, refuse_theme
from brdf_suite.plugins import Call, Registry
from brdf_suite.regular_files import open_regular, read_bytes, within_memory

_BUILT_IN = (
    OWN,
    ase.FORMAT,
    acb.FORMAT,
    gpl.FORMAT,
    kpl.FORMAT,
    sbz.FORMAT,
    cxf3.FORMAT,
    scribus.FORMAT,
    soc.FORMAT,
    corel.FORMAT,
    autocad.FORMAT,
    instrument.FORMAT,
    cpl.FORMAT,
    apple_clr.FORMAT,
    riff_pal.FORMAT,
    jasc_pal.FORMAT,
    csv_table.FORMAT,
    css.FORMAT,
    scss.FORMAT,
    sketch.FORMAT,
    json_tokens.FORMAT,
    table.FORMAT,
    hex_list.FORMAT,
    aco.FORMAT,
    act.FORMAT,
)


def _is_palette_with_notes(found: object) -> bool:
    if not isinstance(found, tuple) or len(found) != 2 or not isinstance(found[0], Palette):
        return False
    return isinstance(found[1], tuple) and all(isinstance(note, str) for note in found[1])


FORMATS = Registry(
    "brdf_suite.palette_formats",
    PaletteFormat,
    _BUILT_IN,
    calls={
        "sniff": Call(lambda found: isinstance(found, bool), "True or False", False),
        "read": Call(_is_palette_with_notes, "(palette, notes)"),
        "write": Call(lambda found: isinstance(found, bytes), "bytes"),
    },
    endings=lambda known: known.endings,
)
"""In the order in which they are tried; those with the weakest signatures come last, and then those of plug-ins."""

_HEAD = 1 << 16


def find_format(name: str) -> PaletteFormat:
    """Return the format of a short name; :class:`SuiteError` where there is none."""
    for known in FORMATS:
        if known.name == name:
            return known
    raise SuiteError(f"No palette format is called {name!r}; there are {', '.join(f.name for f in FORMATS)}.")


def format_for(path: PathLike) -> PaletteFormat:
    """Return the format that a file is written in by its ending; :class:`FileError` where there is none."""
    ending = Path(path).suffix.lower()
    for known in FORMATS:
        if ending in known.endings and known.write is not None:
            return known
    endings = ", ".join(
        sorted({end for known in FORMATS if known.write is not None for end in known.endings})
    )
    raise FileError(
        path, f"the ending {ending or '(none)'} names no palette format that is written here ({endings})"
    )


def sniff(content: bytes, path: PathLike) -> PaletteFormat:
    """Return the format of a file's content.

    Raises :class:`FileError`: it is empty, or of no known format; :class:`~brdf_suite.errors.UnreadFormatError`: it is
    of one that is known and not read.
    """
    if not content:
        raise FileError(path, "is empty", "byte 0")
    head, size = content[:_HEAD], len(content)
    if OWN.sniff(head, size):
        return OWN  # without a look at plug-ins
    found = [known for known in FORMATS if known.sniff(head, size)]
    if not any(known in FORMATS.added for known in found):
        refuse_axf(head, path)
    ending = Path(path).suffix.lower()
    # A format of a plug-in is found before one that is built in only where the ending is the plug-in's alone.
    if found and ending not in found[0].endings:
        for known in FORMATS.added:
            if known in found and ending in known.endings:
                return known
    # Formats with a signature are certain; the last two are recognised by a few numbers or the size alone.
    named = [known for known in found if ending in known.endings]
    if found and found[0] in (aco.FORMAT, act.FORMAT) and named:
        return named[0]
    if found:
        return found[0]
    if ending in (".csv", ".tsv") and b"\0" not in content[:_HEAD]:
        return table.FORMAT  # its reader says which columns there are and which are wanted
    refuse_theme(head, path)
    titles = ", ".join(known.title for known in FORMATS)
    raise FileError(path, f"is of no palette format that is known here ({titles})", "byte 0")


@within_memory
def read_palette(path: PathLike, *, cmyk_profile: PathLike | None = None) -> ReadPalette:
    """Return the palette in a file of any known format, whatever its name.

    ``cmyk_profile`` is an ICC profile through which colours in CMYK are seen that bring none of their own.

    Raises
    ------
    FileError
        It cannot be read, is of no known format, or is damaged; with the place: byte, line or field. Nothing is partly
        read.
    """
    with open_regular(path) as stream:
        head = stream.read(_HEAD)
        if stream.seek(0, 2) > LARGEST_PALETTE:
            refuse_axf(head, path)
    read = read_content(read_bytes(path, LARGEST_PALETTE), path)
    if cmyk_profile is None:
        return read
    profile = read_profile(cmyk_profile)
    palette, count = seen_through(read.palette, {"": profile}, cmyk_profile)
    notes = (profile_note(count, Path(cmyk_profile).name),) if count else ()
    return ReadPalette(palette, (*read.notes, *notes), read.format)


def read_content(content: bytes, path: PathLike, known: PaletteFormat | None = None) -> ReadPalette:
    """Return the palette in the content of a file, of a format where that is known; errors as :func:`read_palette`."""
    if known is None:
        known = sniff(content, path)
    if known is not OWN and len(content) > LARGEST:
        raise FileError(
            path, f"has {len(content):,} bytes, more than the {LARGEST:,} allowed", f"byte {LARGEST}"
        )
    with without_collection():
        palette, notes = known.read(content, path)
    return ReadPalette(palette, notes, known)


def losses(palette: Palette, known: PaletteFormat, path: PathLike = "") -> tuple[str, ...]:
    """Return what a format cannot hold of a palette, in sentences, without writing anything to the disk.

    A file that says no name has its own, so whether the palette's is lost depends on ``path``.

    Raises :class:`SuiteError`: it cannot be written in that format at all.
    """
    return find_losses(palette, known, encode_palette(palette, known), path or f"the {known.title} file")


def write_palette(palette: Palette, path: PathLike, known: PaletteFormat | None = None) -> WrittenPalette:
    """Write a palette, whole or not at all, in the format given or that the ending names.

    Raises :class:`SuiteError`: the ending names no format, the format cannot hold the palette, or the disk refuses.
    """
    if known is None:
        known = format_for(path)
    content = encode_palette(palette, known)
    lost = find_losses(palette, known, content, path)
    write_atomically(path, content)
    return WrittenPalette(known, len(content), lost)
