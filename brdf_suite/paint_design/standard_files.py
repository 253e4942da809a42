"""Standards out of files: a paint, every paint of a palette or of a hand-over, every CxF3 sample, a measured BRDF."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, load_palette
from brdf_suite.documents.store import PAINT_ENDING, AnyPaint
from brdf_suite.errors import FileError, SuiteError, ValueRangeError
from brdf_suite.files.samples import AngleSample, SampleFile, effect_notes
from brdf_suite.paint_design.measured_start import estimated_gloss
from brdf_suite.paint_design.standard import Standard, standard_of
from brdf_suite.pipeline.material import (
    Material,
    file_kind,
    load_document,
    load_material,
    load_palette_file,
    material_of,
)
from brdf_suite.progress import Progress, report
from brdf_suite.regular_files import is_file, open_regular

_HEAD = 1 << 16
BY_INSTRUMENT = "Its colours are read by the virtual spectrophotometer."


def load_standards(
    name_or_path: str | os.PathLike[str], progress: Progress | None = None
) -> tuple[Standard, ...]:
    """Return the standards in a file, or the shipped or Table 1 paint of that name; never none.

    Raises
    ------
    SuiteError
        There is nothing of that name, or the file cannot be read or holds no standard; with file and place.
    Cancelled
        The progress callback asked for it.
    """
    path = Path(name_or_path)
    report(progress, 0.0, f"reading {path.name}")
    if path.suffix.lower() == PALETTE_ENDING:
        found = _of_palette(load_palette(path), path)
    elif handed := _of_handover(path):
        found = handed
    elif _is_foreign_palette(path):
        read = load_palette_file(path)
        found = _of_palette(read.palette, path, read.notes)
    else:
        document = load_document(name_or_path)
        if document is None:
            found = (_read_by_instrument(load_material(name_or_path), ""),)
        else:
            found = (_of_paint(document, path.name if path.suffix else ""),)
    report(progress, 1.0, "read")
    return found


def _is_foreign_palette(path: Path) -> bool:
    own = path.suffix.lower() == PAINT_ENDING
    return not own and is_file(path) and file_kind(path) == "palette"


def _of_paint(paint: AnyPaint, origin: str) -> Standard:
    if isinstance(paint, Paint):
        return standard_of(paint, origin)
    return _read_by_instrument(material_of(paint), origin)


def _read_by_instrument(material: Material, origin: str) -> Standard:
    gloss = estimated_gloss(material.reflectance).gloss
    notices = (BY_INSTRUMENT, *material.notices)
    return Standard(material.name, origin, (), gloss, None, material.reflectance, notices)


def _of_palette(palette: Palette, path: Path, notes: tuple[str, ...] = ()) -> tuple[Standard, ...]:
    found = [_of_paint(to_paint(entry.content), ", ".join((path.name, *entry.group))) for entry in palette]
    if not found:
        raise FileError(path, "holds no paint, so there is no standard in it")
    return tuple(replace(standard, notices=(*standard.notices, *notes)) for standard in found)


def _of_handover(path: Path) -> tuple[Standard, ...]:
    """The paints of a file that was handed over, known by its content; none where it is something else."""
    if path.suffix.lower() == PAINT_ENDING or not is_file(path):
        return ()
    with open_regular(path) as stream:
        head = stream.read(_HEAD)
    # With the readers 60 ms, which Designer's start does not wait for.
    from brdf_suite.files.exports import FORMATS
    from brdf_suite.files.instruments import read_instrument

    for known in FORMATS:
        if known.name != "cxf" and known.sniff is not None and known.read is not None and known.sniff(head):
            return tuple(_of_paint(paint, path.name) for paint in known.read(path).paints)
    # What is measured reflectance goes by that, whatever headings it has.
    file = read_instrument(path) if file_kind(path) == "palette" else None
    return () if file is None else _of_samples(file, path)


def _of_samples(file: SampleFile, path: Path) -> tuple[Standard, ...]:
    found: list[Standard] = []
    refused = [*file.refused]
    for sample in file.samples:
        try:
            readings = tuple(
                Measurement(reading.illumination_deg, reading.aspecular_deg, reading.lab)
                for reading in sample.readings
            )
        except ValueRangeError as error:
            refused.append(f"{sample.name}: {error}")
            continue
        gloss: Gloss | None = sample.gloss
        try:
            paint = sample.paint() if gloss is not None else None
        except ValueRangeError:  # too few angles for a paint; they are enough for a standard
            paint = None
        converted = tuple(
            dict.fromkeys(reading.converted for reading in sample.readings if reading.converted)
        )
        notices = (*converted, *_instrument_notes(sample), *refused)
        found.append(Standard(sample.name, path.name, readings, gloss, paint, None, notices))
    if not found:
        raise SuiteError(f"{path}: no sample can be a standard: {'; '.join(refused)}.")
    return tuple(found)


def _instrument_notes(sample: AngleSample) -> tuple[str, ...]:
    """Return the spread of repeated measurements, and sparkle and graininess as the instrument read them."""
    spread = f"mean of {sample.measurements} measurements, which differ from it by at most ΔE00 {sample.spread:.2f}"
    effects = effect_notes(sample.effects)
    return (*((spread,) if sample.measurements > 1 else ()), *((effects,) if effects else ()))
