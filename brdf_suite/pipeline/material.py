"""A name or a file of any kind becomes a :class:`Material`: the one place that decides by content what it is.

A name is of a shipped paint, of a paint of Table 1, or of a model with an example. A file is a paint document, a
palette (of which one entry is named as ``summer.brdfpalette#12``), or measured data of any format.
"""

from __future__ import annotations

import json
import os
import re
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.appearance.light.matrix import ILLUMINANT_OF
from brdf_suite.documents.atomic import documents_in
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.palette_store import LARGEST_PALETTE, PALETTE_ENDING
from brdf_suite.documents.store import PAINT_ENDING, AnyPaint, load_any_paint, load_paint
from brdf_suite.documents.view_settings import LightColour
from brdf_suite.errors import FileError, UnreachableError, UnreadFormatError
from brdf_suite.foreign_text import file_title
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance, interpolation_notices
from brdf_suite.reflectance.instruments.through_aperture import build_through
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance, has_spectra
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.regular_files import is_file, is_folder, open_regular, read_bytes, within_memory
from brdf_suite.resources import check_exists, packaged_name, resource, resource_names

if TYPE_CHECKING:
    from brdf_suite.files.palettes.format import ReadPalette
    from brdf_suite.reflectance.instruments.aperture import Aperture

__all__ = ["Material"]

FileKind = Literal["paint", "palette", "measured"]

ENTRY_MARK = "#"
"""Between a palette's file and the id of an entry: ``summer.brdfpalette#12``."""
FLAT = "A flat colour has no gloss and no angles; it is shown as a solid paint of that colour."
SCATTERED = (
    "Scattered samples are interpolated: gloss, and colours far from any sample, are only as good as the "
    "samples near them."
)
_HEAD = 1 << 12
_DOCUMENT = re.compile(rb'"format"\s*:\s*"(brdfpaint|brdfpalette)"')


def paint_names() -> list[str]:
    """Return the names of the shipped paints, sorted."""
    return list(_shipped_paints())


@cache
def _shipped_paints() -> tuple[str, ...]:
    return tuple(resource_names("paints", PAINT_ENDING))


@cache
def paint_titles() -> dict[str, str]:
    """Return what the shipped paints are called, by their names, in the order of these."""
    files = {name: resource("paints", name + PAINT_ENDING) for name in paint_names()}
    return {name: json.loads(file.read_bytes())["name"] for name, file in files.items()}


def default_paint_name() -> str:
    """Return the name of the paint that a new user sees first."""
    return "blue"


def load_shipped_paint(name: str) -> Paint:
    """Return the packaged paint ``name``; :class:`FileError` where there is none."""
    return load_paint(resource("paints", name + PAINT_ENDING))


def default_paint() -> Paint:
    """Return the paint that a new user sees first."""
    return load_shipped_paint(default_paint_name())


def file_kind(path: str | os.PathLike[str]) -> FileKind:
    """Return what a file is, by its content.

    Raises :class:`FileError`: it cannot be read, or its content is of no known format;
    :class:`~brdf_suite.errors.UnreadFormatError`: it is of one that is known and not read.
    """
    known = document_kind(path)
    if known is None and is_file(path):
        with open_regular(path) as stream:
            if not stream.read(1):
                raise FileError(path, "is empty", "byte 0")
    return known or _foreign_kind(path)


def document_kind(path: str | os.PathLike[str]) -> Literal["paint", "palette"] | None:
    """Return which document of ours a file is, by its content; None for files of other programs, and for no file."""
    try:
        with open_regular(path) as stream:
            head = stream.read(_HEAD)
    except FileError:
        return None
    found = _DOCUMENT.search(head) if head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{") else None
    if found is not None:
        return "paint" if found[1] == b"brdfpaint" else "palette"
    # Fields in another order, or a document that is cut off: the ending says what it is meant to be.
    ending = Path(path).suffix.lower()
    if ending in (PAINT_ENDING, PALETTE_ENDING):
        return "paint" if ending == PAINT_ENDING else "palette"
    return None


@within_memory
def load_material(
    name_or_path: str | os.PathLike[str],
    *,
    observer_deg: int = 10,
    solved_through: Aperture | None = None,
    cmyk_profile: str | os.PathLike[str] | None = None,
) -> Material:
    """Return what a name or a file of any kind stands for.

    Parameters
    ----------
    name_or_path
        The name of a shipped paint, a paint of Table 1 or a model; the path of a paint, a measured file or a palette
        with one entry; or ``PALETTE#ID``.
    observer_deg
        2 or 10: the observer through which the spectra of a measured file become colour.
    solved_through
        The aperture with which a designed paint's own colours were read; None for none.
    cmyk_profile
        An ICC profile through which an entry in CMYK is seen whose palette brings none of its own.

    Raises
    ------
    FileError, DocumentError
        There is nothing of that name, or the file is not valid; the message says where.
    UnreachableError
        No such paint can have the gloss or colours that the document asks for.
    """
    text = os.fspath(name_or_path)
    found = _find(text, cmyk_profile)
    if isinstance(found, Entry):
        palette = text if is_file(text) else text.rpartition(ENTRY_MARK)[0]
        known = load_palette_file(palette, cmyk_profile=cmyk_profile)
        entry = material_of_entry(found, text)
        return replace(entry, notices=(*entry.notices, *known.notes))
    if found is None:
        if is_file(text):
            return load_measured(text, observer_deg)
        model = MODELS[text]
        return Material(model.title, model.make(), text, notices=(f"{model.source}.",))
    if isinstance(found, Paint) and solved_through is not None:
        solved = build_through(found, solved_through)
        return _designed(found, text, solved.reflectance, solved.notices)
    return material_of(found, text)


def load_document(
    name_or_path: str | os.PathLike[str], *, cmyk_profile: str | os.PathLike[str] | None = None
) -> AnyPaint | None:
    """Return the paint document that a name or a file stands for, not built; None for measured data and models.

    ``cmyk_profile`` and errors as in :func:`load_material`, but for paints that cannot be built.
    """
    found = _find(os.fspath(name_or_path), cmyk_profile)
    return to_paint(found.content) if isinstance(found, Entry) else found


def material_of(document: AnyPaint, origin: str = "") -> Material:
    """Return a paint document as a material; ``origin`` is the name or path that messages call it by.

    Raises :class:`UnreachableError`: no such paint can have the gloss or colours that the document asks for.
    """
    try:
        if isinstance(document, Paint):
            reflectance = build_paint(document)
            notices = reflectance.notices + interpolation_notices(document, reflectance)
            return _designed(document, origin, reflectance, notices)
        return Material(document.name, build_reflectance(document), origin, document, flakes=document.flakes)
    except UnreachableError as error:
        if not origin:
            raise
        raise type(error)(f"{Path(origin).name}: {error}") from error


def material_of_entry(entry: Entry, origin: str = "") -> Material:
    """Return a palette's entry as a material, a flat colour as a solid paint; errors as :func:`material_of`."""
    if not entry.is_flat:
        return material_of(entry.content, origin)  # type: ignore[arg-type]  # what is not flat is a paint
    found = material_of(to_paint(entry.content), origin)
    return replace(found, name=entry.name or entry.id, notices=(FLAT, *found.notices))


def load_measured(path: str | os.PathLike[str], observer_deg: int = 10) -> Material:
    """Return the material of a measured file; raise :class:`FileError` where it is none."""
    # 14 to 30 ms at the start of each program.
    from brdf_suite.files.measured import read_measured
    from brdf_suite.files.measured.format import ReadOptions

    value = read_measured(path, options=ReadOptions(observer_deg=observer_deg))
    notes = value.facts.get("notes", ())
    notices = [str(note) for note in notes] if isinstance(notes, (tuple, list)) else [str(notes)]
    if observer_deg != 10 and has_spectra(value):
        notices.append(
            f"Its spectra are seen through the {observer_deg}° observer; L*a*b* follows from the working space, as for "
            "every reading."
        )
    if isinstance(value, ScatteredSamples):
        notices.append(SCATTERED)
    return Material(
        file_title(Path(path).name),
        value,
        os.fspath(path),
        notices=tuple(notices),
        facts=dict(value.facts),
        observer_deg=observer_deg,
    )


def load_palette_file(
    path: str | os.PathLike[str], *, cmyk_profile: str | os.PathLike[str] | None = None
) -> ReadPalette:
    """Return a palette of any format; raise :class:`FileError` with the place where it cannot be read.

    ``cmyk_profile`` is an ICC profile through which colours in CMYK are seen that bring none of their own.
    """
    name, profile = os.fspath(path), None if cmyk_profile is None else os.fspath(cmyk_profile)
    try:
        state = Path(path).stat()
    except (OSError, ValueError):
        return _read_palette(name, 0, 0, profile)  # its reader says what is wrong
    return _read_palette(name, state.st_mtime_ns, state.st_size, profile)


@lru_cache(maxsize=1)
def _read_palette(path: str, _changed_ns: int, _size: int, profile: str | None) -> ReadPalette:
    """Read a palette; the last one is kept, since its entries are asked for one after the other."""
    from brdf_suite.files.palettes import read_palette  # 60 to 90 ms at the start of each program

    return read_palette(path, cmyk_profile=profile)


def paints_of(name_or_path: str | os.PathLike[str]) -> tuple[str, ...]:
    """Return a name for each paint of a palette or a folder, as :func:`load_material` takes them.

    What is neither is one paint, and its name is returned as it is. Raises :class:`FileError`: a palette cannot be
    read, or there is no paint in it or in the folder.
    """
    text = os.fspath(name_or_path)
    if packaged_name(text, [*paint_names(), *TABLE_1]) is not None:
        return (text,)
    if is_folder(text):
        found = tuple(sorted(map(str, documents_in(Path(text), PAINT_ENDING)), key=str.casefold))
        if not found:
            raise FileError(text, f"holds no {PAINT_ENDING} file")
        return found
    if not is_file(text) or file_kind(text) != "palette":
        return (text,)
    entries = load_palette_file(text).palette.entries
    if not entries:
        raise FileError(text, "is a palette without a paint")
    if len(entries) == 1:
        return (text,)
    return tuple(f"{text}{ENTRY_MARK}{entry.id}" for entry in entries)


def under_illuminant(material: Material, colour: LightColour) -> Material:
    """Return a material as it looks in a light to an adapted eye; the very same where nothing differs.

    Without spectra nothing is known, and under D65 or in the environment's own light nothing changes.
    """
    illuminant = ILLUMINANT_OF.get(colour.illuminant, "D65")
    if illuminant == "D65" or not has_spectra(material.reflectance):
        return material
    from brdf_suite.reflectance.instruments.under_light import relit  # 15 ms at the start of each program

    return replace(material, reflectance=relit(material.reflectance, illuminant))


def _designed(paint: Paint, origin: str, reflectance: Reflectance, notices: tuple[str, ...]) -> Material:
    return Material(paint.name, reflectance, origin, paint, paint.flakes, paint.orange_peel, notices)


def _find(text: str, cmyk_profile: str | os.PathLike[str] | None) -> AnyPaint | Entry | None:
    """Return the document of a name or a file, or the entry of a palette; None for models and measured files."""
    names = paint_names()
    if text in names:  # without Table 1, which most starts do not need
        return load_shipped_paint(text)
    name = packaged_name(text, [*names, *TABLE_1])
    if name is not None:
        return TABLE_1[name] if name in TABLE_1 else load_shipped_paint(name)
    if is_file(text):
        kind = file_kind(text)
        if kind == "palette":
            entries = load_palette_file(text, cmyk_profile=cmyk_profile).palette.entries
            if not entries:
                raise FileError(text, "is a palette without a paint")
            if len(entries) > 1:
                example = f"{text}{ENTRY_MARK}{entries[0].id}"
                raise FileError(
                    text, f"is a palette of {len(entries):,} paints; name one of them, as in {example}"
                )
            return entries[0]
        return load_any_paint(text) if kind == "paint" else None
    path, _, entry_id = text.rpartition(ENTRY_MARK)
    if path and is_file(path):
        palette = load_palette_file(path, cmyk_profile=cmyk_profile).palette
        if entry_id not in palette.by_id:
            raise FileError(path, f"has no entry {entry_id!r}")
        return palette.entry(entry_id)
    if text in MODELS:
        return None
    check_exists(text, "paint", [*names, *TABLE_1])
    return load_any_paint(text)


def _foreign_kind(path: str | os.PathLike[str]) -> FileKind:
    from brdf_suite.files import measured, palettes  # see load_measured and load_palette_file

    try:
        measured.sniff(path)
    except UnreadFormatError:
        raise
    except FileError as no_measurement:
        try:
            content = read_bytes(path, LARGEST_PALETTE)
            palettes.sniff(content, path)
        except UnreadFormatError:
            raise
        except FileError:
            reason = (
                "is neither a paint nor a palette nor measured data of a format that is known here (the pages "
                "measured_files and formats of the documents list them)"
            )
            raise FileError(path, reason, no_measurement.place) from no_measurement
        return "palette"
    return "measured"
