"""Exports to other programs: any material into any format, with a list of the losses before."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import FileError, FittingError, PathLike, SuiteError, UnreachableError, ValueRangeError
from brdf_suite.files.exports import FORMATS
from brdf_suite.files.exports import read_paints as read_known_paints
from brdf_suite.files.exports.format import ExportFormat, ExportItem, ImportedPaints, Spectra, paint_of_report
from brdf_suite.inspection.texture.readings import texture_of
from brdf_suite.pipeline.material import Material, load_document, load_material, material_of
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.instruments.aperture import POINT
from brdf_suite.reflectance.instruments.spectrophotometer import measure
from brdf_suite.reflectance.instruments.under_light import spectrum_at
from brdf_suite.reflectance.protocol import has_spectra
from brdf_suite.reports.paint_report.document import ReportOptions
from brdf_suite.reports.paint_report.formats import report_formats

READ_AT = GEOMETRY_SETS["five"]
"""What the virtual instrument reads of a paint that is not designed by readings."""


def formats(options: ReportOptions | None = None) -> tuple[ExportFormat, ...]:
    """Return every format in the order in which they are offered, the reports with these options."""
    return (*FORMATS.built_in, *report_formats(options or ReportOptions()), *FORMATS.added)


def format_named(name: str, options: ReportOptions | None = None) -> ExportFormat:
    """Return the format called ``name``; raise :class:`SuiteError` naming those that there are."""
    for known in formats(options):
        if known.name == name:
            return known
    raise SuiteError(
        f"There is no format {name!r}; there are {', '.join(known.name for known in formats())}."
    )


def format_of(path: PathLike, options: ReportOptions | None = None) -> ExportFormat:
    """Return the format that the ending of ``path`` names; raise :class:`FileError` where none does."""
    ending = Path(path).suffix.lower()
    for known in formats(options):
        if known.ending == ending:
            return known
    endings = ", ".join(known.ending for known in formats())
    raise FileError(
        path, f"the ending {ending or '(none)'} names no format ({endings}); name one by --format"
    )


def item_of(name_or_path: str | os.PathLike[str]) -> ExportItem:
    """Return a material by name or file as it is exported.

    Raises
    ------
    SuiteError
        There is nothing of that name, the file is not valid, or what is read of it makes no paint.
    """
    document = load_document(name_or_path)
    if document is not None:
        return item_of_paint(document)
    return item_of_material(load_material(name_or_path))


def item_of_material(material: Material) -> ExportItem:
    """Return a material as it is exported; errors as :func:`item_of`."""
    if material.document is not None:
        return item_of_paint(material.document)
    if not material.facts:
        return _read_by_instruments(material, material.name, f"Model {material.name}.")
    return _read_by_instruments(material, Path(material.name).stem, f"Measured file {material.name}.")


def item_of_paint(paint: AnyPaint) -> ExportItem:
    """Return a paint's document as it is exported; errors as :func:`item_of`."""
    if isinstance(paint, Paint):
        return ExportItem(paint)
    return _read_by_instruments(material_of(paint), paint.name, paint.source)


def _read_by_instruments(material: Material, name: str, source: str) -> ExportItem:
    """What the virtual instruments read, as a paint; its gloss held to what a paint's can be."""
    reflectance, document = material.reflectance, material.document
    found = measure(reflectance, READ_AT)
    flakes, notes = (None, "") if document is None else (document.flakes, document.notes)
    try:
        paint = paint_of_report(found, name[:200].strip() or "measured", source, flakes, notes)
    except ValueRangeError as error:
        raise SuiteError(f"{name}: what is read of it makes no paint: {error}") from error
    spectra = None
    if has_spectra(reflectance):
        rows = (spectrum_at(reflectance, reading.geometry, POINT) for reading in found.readings)
        bands = np.asarray(reflectance.wavelengths_nm, float).tolist()
        spectra = Spectra(tuple(bands), tuple(tuple(row.tolist()) for row in rows))
    return ExportItem(paint, material, spectra)


def with_texture(item: ExportItem) -> ExportItem:
    """Return an item with what the texture instrument reads of its flakes, where there is such a paint."""
    try:
        return replace(item, texture=texture_of(item.material or material_of(item.paint)))
    except (UnreachableError, FittingError):
        return item


def export_losses(known: ExportFormat, item: ExportItem) -> tuple[str, ...]:
    """Return what a format cannot hold of a paint, with the paint's name before what makes it impossible."""
    try:
        return known.losses(item)
    except UnreachableError as error:
        raise UnreachableError(f"{item.name}: {error}") from error


@dataclass(frozen=True)
class Exported:
    """A file that was written: by which format, of how many paints, what was lost and what else is to be said."""

    path: Path
    format: str
    paints: int
    losses: tuple[str, ...]
    notes: tuple[str, ...]


def export(
    known: ExportFormat, items: Sequence[ExportItem], path: PathLike, *, progress: Progress | None = None
) -> Exported:
    """Write paints in one file, whole or not at all.

    Raises
    ------
    ValueRangeError
        There is no paint, or more than the format takes.
    UnreachableError
        A format that holds how the paint reflects is asked for a paint that cannot be; the message names it.
    FileError
        The disk refuses.
    Cancelled
        The progress callback asked for it; an old file stays.
    """
    if not items:
        raise ValueRangeError("paints", "at least one is wanted")
    if len(items) > 1 and not known.many:
        raise ValueRangeError("paints", f"a file of {known.title} takes one paint, not {len(items)}")
    report(progress, 0.0, "reading")
    # All losses before anything is written: what cannot be handed over at all is found here, too.
    losses = tuple(dict.fromkeys(loss for item in items for loss in export_losses(known, item)))
    start = 0.0
    if known.texture:
        start, plain, items = 0.5, items, []
        for number, item in enumerate(plain):
            report(progress, start * number / len(plain), "reading texture")
            items.append(with_texture(item))
    notes = known.write(items, path, subrange(progress, start, 1.0))
    report(progress, 1.0, "written")
    return Exported(Path(path), known.name, len(items), losses, notes)


def read_paints(path: PathLike) -> ImportedPaints:
    """Return the paints in a file of any format that is read back, reports among them; errors as the core's."""
    return read_known_paints(path, formats())
