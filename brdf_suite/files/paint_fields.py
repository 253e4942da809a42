"""Scalar fields of a paint beside readings and texts, as flat name-value pairs.

Formats of readings (CxF3, CSV) have no place of their own for them and keep them as tags or columns. They are found
from the document itself, so that a field that paints get in future is kept, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from brdf_suite.documents.paint import Gloss, Lab, Paint
from brdf_suite.documents.reading import VERSIONS
from brdf_suite.documents.store import paint_from_json, paint_to_json, quick_paint
from brdf_suite.errors import DocumentError

Setting = str | float | bool
Reading = tuple[float, float, Lab]
"""Illumination and aspecular angle in degrees, and L*a*b* of D65 and 10°."""

_OWN_PLACE = {
    "format", "version", "kind", "name", "measurements", "gloss", "illuminant", "observer_deg", "notes", "source",
}  # fmt: skip


def flatten_paint(paint: Paint) -> dict[str, Setting]:
    """Return the fields by their names in the paint's file, those of parts after a dot; what is not there is left out.

    >>> from brdf_suite.documents.paint import solid_paint
    >>> flatten_paint(solid_paint("white", (95.0, 0.0, 1.0)))["interpolation"]
    'flake'
    """
    found: dict[str, Setting] = {}
    for name, value in paint_to_json(paint).items():
        if name in _OWN_PLACE or value is None:
            continue
        parts = (
            {f"{name}.{part}": item for part, item in value.items()}
            if isinstance(value, dict)
            else {name: value}
        )
        found.update({key: item for key, item in parts.items() if isinstance(item, (str, float, int))})
    return found


def setting_from_text(text: str) -> Setting:
    """Return the value that a tag or a cell holds: a number where it is one, else true, false or the text itself."""
    if text in ("true", "false"):
        return text == "true"
    try:
        return float(text)
    except ValueError:
        return text


def setting_text(value: Setting) -> str:
    """Return a setting as a tag or a cell holds it; numbers with every digit."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(float(value))


def build_paint(
    name: str,
    readings: Sequence[Reading],
    gloss: Gloss,
    settings: Mapping[str, Setting],
    notes: str = "",
    source: str = "",
    *,
    path: str = "the paint",
    version: int | None = None,
) -> Paint:
    """Return the paint of readings and flat settings; ``path`` is what messages call it.

    Raises :class:`DocumentError`: a value is out of range, or a setting is unknown; ``place`` names the field.
    """
    fields: dict[str, object] = {}
    for key, value in settings.items():
        part, dot, field = key.partition(".")
        if not dot:
            fields[part] = value
            continue
        inner = fields.setdefault(part, {})
        if not isinstance(inner, dict):
            raise DocumentError(path, "is both a value and a part", part)
        inner[field] = value
    measurements = [
        {"illumination_deg": light, "aspecular_deg": aspecular, "lab": list(lab)}
        for light, aspecular, lab in readings
    ]
    reserved = _OWN_PLACE & fields.keys()
    if reserved:
        raise DocumentError(path, "is no setting", min(reserved))
    document: dict[str, object] = {
        "format": "brdfpaint",
        "version": VERSIONS["brdfpaint"] if version is None else version,
        "kind": "aspecular",
        "name": name,
        "measurements": measurements,
        "gloss": {"gu_20": gloss.gu_20, "gu_60": gloss.gu_60},
        "notes": notes,
        "source": source,
        **fields,
    }
    return quick_paint(document) or paint_from_json(document, path)
