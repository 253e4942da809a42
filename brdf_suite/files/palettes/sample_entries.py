"""Entries of a palette for samples that an instrument read at several angles."""

from __future__ import annotations

import json

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Foreign
from brdf_suite.errors import SuiteError
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import FACE_DEG
from brdf_suite.files.samples import AngleSample, SampleFile

SPECTRA = "cxf.spectra"
"""Under this name an entry keeps the spectra of a multi-angle sample, so that they can go back."""
EFFECTS = "instrument.effects"
"""Under this name an entry keeps sparkle and graininess as an instrument read them, on its own scale."""

ANGLES_FOR_A_PAINT = 3


def add_samples(collector: Collector, file: SampleFile, place: str) -> None:
    """Add the samples of a file, with its notices; one with fewer than three angles becomes a flat colour."""
    for note in file.notes:
        collector.note(note)
    for reason in file.refused:
        collector.note(f"{reason}.")
    for sample in file.samples:
        collector.add(place, sample_content(collector, sample, place), foreign=sample_fields(sample))


def sample_content(collector: Collector, sample: AngleSample, place: str) -> Paint | FlatColour:
    """Return a sample as a paint, or as the flat colour nearest to 45° where it has fewer than three angles.

    Raises :class:`FileError`: a value is beyond a paint's range.
    """
    if len(sample.readings) >= ANGLES_FOR_A_PAINT:
        try:
            return sample.paint()
        except SuiteError as error:
            raise collector.fail(str(error).rstrip("."), place) from error
    collector.note("{n} sample[|s] [has|have] fewer than three angles and became flat colours.")
    reading = min(sample.readings, key=lambda one: abs(one.aspecular_deg - FACE_DEG))
    name = collector.name(sample.name)
    return collector.colour(place, name, "Lab", reading.lab, illuminant="D65", observer_deg=10)


def sample_fields(sample: AngleSample) -> Foreign:
    """Return what an entry keeps of a sample beside its content: spectra, sparkle and graininess."""
    effects = ((EFFECTS, json.dumps(dict(sample.effects))),) if sample.effects else ()
    rows = [(reading.wavelengths_nm, reading.reflectance) for reading in sample.readings]
    first = rows[0][0]
    if (
        len(rows) < ANGLES_FOR_A_PAINT
        or first is None
        or any(bands != first or not values for bands, values in rows)
    ):
        return effects
    spectra = json.dumps({"bands": list(first), "rows": [list(row or ()) for _, row in rows]})
    return ((SPECTRA, spectra), *effects)


def kept_effects(entry: Entry) -> dict[str, float]:
    """Return sparkle and graininess that an entry keeps; empty where it has none, or they are no numbers."""
    try:
        found = json.loads(dict(entry.foreign).get(EFFECTS, "{}"))
    except (ValueError, RecursionError):
        return {}
    pairs = found.items() if isinstance(found, dict) else ()
    return {what: float(value) for what, value in pairs if type(value) in (int, float) and abs(value) < 1e300}
