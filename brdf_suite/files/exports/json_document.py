"""JSON export: paints as stored by this suite, with all figures computed from their readings.

    {"format": "brdf-suite-paints", "version": 1, "creator": …, "created": …, "paints": [
      {"paint": the document as in a .brdfpaint file,
       "readings": [{"geometry": "45as15", "illumination_deg", "aspecular_deg", "lab", "lch", "xyz",
                     "nearest_sample_deg": angle to the nearest sample of a scattered file, else 0}, …],
       "illuminant": "D65", "observer_deg": 10,
       "gloss": {"gu_20", "gu_60"}, "flop_index": number or null, "travel": {…} or null,
       "texture": {"scale", "sparkle": [{"light_deg", "points_per_mm2", "area", "intensity", "grade"}, …],
                   "graininess"} or null where it was not read; on the suite's own scale,
       "computed": whether the readings are the virtual instruments',
       "original": the document of a paint that is not designed by readings, else null,
       "spectra": {"wavelengths_nm": […], "values": [[…], …]} or null}, …]}

``paint`` is what is read back; all else is there for other programs and follows from it. Reports carry the same object.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import asdict
from datetime import UTC, datetime

from brdf_suite.appearance.colour.colorimetry import lab_to_xyz
from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.flop.travel import flop_index, travel
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.reading import FieldReader, read_json
from brdf_suite.documents.store import AnyPaint, any_paint_from_json, paint_to_json
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.exports.format import ExportFormat, ExportItem, ImportedPaints
from brdf_suite.progress import Progress
from brdf_suite.release import __version__

NAME = "brdf-suite-paints"
_VERSION = 1
_MOST_PAINTS = 100_000
_LIGHT_DEG = 45.0


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what the object cannot hold of a paint: the table of a measured file."""
    if not item.computed or item.document is not None:
        return ()
    return ("The measured table itself is left out: what the virtual instruments read of it goes in.",)


def document(items: Sequence[ExportItem]) -> dict[str, object]:
    """Return the JSON object of paints, as the module describes it."""
    return {
        "format": NAME,
        "version": _VERSION,
        "creator": f"BRDF Suite {__version__}",
        "created": datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z"),
        "paints": [_item(item) for item in items],
    }


def _item(item: ExportItem) -> dict[str, object]:
    paint = item.paint
    spectra = item.spectra
    return {
        "paint": paint_to_json(paint),
        "illuminant": paint.illuminant,
        "observer_deg": paint.observer_deg,
        "readings": [
            {
                "geometry": geometry.name,
                "illumination_deg": m.illumination_deg,
                "aspecular_deg": m.aspecular_deg,
                "lab": list(m.lab),
                "lch": lab_to_lch(m.lab).tolist(),
                "xyz": lab_to_xyz(m.lab).tolist(),
                "nearest_sample_deg": item.nearest_sample_deg(geometry),
            }
            for m in paint.measurements
            for geometry in [Geometry(m.illumination_deg, m.aspecular_deg)]
        ],
        "gloss": {"gu_20": paint.gloss.gu_20, "gu_60": paint.gloss.gu_60},
        "flop_index": compute_flop(paint),
        "travel": _travel_of(paint),
        "texture": None if item.texture is None else item.texture.to_json(),
        "computed": item.computed,
        "original": paint_to_json(item.document) if item.computed and item.document else None,
        "spectra": None
        if spectra is None
        else {
            "wavelengths_nm": list(spectra.wavelengths_nm),
            "values": [list(row) for row in spectra.values],
        },
    }


def compute_flop(paint: Paint) -> float | None:
    """Return the flop index of the readings at 15, 45 and 110° with the light at 45°, or None."""
    try:
        found = flop_index(*(paint.lab_at(angle, _LIGHT_DEG)[0] for angle in (15.0, 45.0, 110.0)))
    except ValueRangeError:
        return None
    return found.value if math.isfinite(found.value) else None


def _travel_of(paint: Paint) -> dict[str, float] | None:
    used = [m for m in paint.measurements if m.illumination_deg == _LIGHT_DEG]
    try:
        found = travel([m.aspecular_deg for m in used], [m.lab for m in used])
    except ValueRangeError:
        return None
    return {name: value for name, value in asdict(found).items() if name != "notice"}


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write paints as one JSON file; raise :class:`FileError` where the disk refuses."""
    write_atomically(path, encode(document(items)))
    return ()


def is_json(head: bytes) -> bool:
    """Return whether the first bytes of a file are those of paints in JSON."""
    found = head.find(f'"{NAME}"'.encode())
    # A glTF that carries such an object in its extras begins with its asset.
    return (
        found >= 0 and head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{") and b'"asset"' not in head[:found]
    )


def read(path: PathLike) -> ImportedPaints:
    """Return the paints of a JSON file; raise :class:`FileError` with the place where one is not valid."""
    return import_paints(read_json(path), path)


def import_paints(value: object, path: PathLike) -> ImportedPaints:
    """Return the paints of a JSON object; errors as :func:`read`."""
    reader = FieldReader(value, path)
    if reader.take("format") != NAME:
        reader.fail(f'expected "{NAME}"', "format")
    found = reader.take("version")
    if found != _VERSION or isinstance(found, bool):
        reader.fail(f"version {_VERSION} is known here, not {json.dumps(found)[:40]}", "version")
    items = reader.take_objects("paints")
    if not 1 <= len(items) <= _MOST_PAINTS:
        reader.fail(f"expected 1 to {_MOST_PAINTS:,} paints, found {len(items)}", "paints")
    return ImportedPaints(tuple(_paint(item, path) for item in items))


def import_text(text: bytes, path: PathLike) -> ImportedPaints:
    """Return the paints of a JSON text that was found in another file; errors as :func:`read`."""
    try:
        value: object = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise FileError(
            path, f"holds data that are damaged ({type(error).__name__})", "the paint in it"
        ) from error
    return import_paints(value, path)


def _paint(item: FieldReader, path: PathLike) -> AnyPaint:
    original = item.take_or("original", None)
    chosen = item.take("paint") if original is None else original
    try:
        return any_paint_from_json(chosen, path)
    except FileError as error:
        where = item.where("paint" if original is None else "original")
        raise FileError(path, error.reason, f"{where}.{error.place}") from error


FORMAT = ExportFormat(
    name="json",
    title="JSON, paints with computed values",
    ending=".json",
    holds="Everything of the paint's document; L*a*b*, LCh and XYZ at every angle, flop, travel, spectra where known.",
    losses=losses,
    write=write,
    read=read,
    sniff=is_json,
    many=True,
    texture=True,
)
