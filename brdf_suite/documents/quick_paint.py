"""Fast construction of paints from JSON objects, for palettes of ten thousand entries.

The usual reader names the place of whatever is wrong, and takes half a millisecond a paint. Here an aspecular paint of
the present version whose every field is as it should be is built at once; of anything else nothing is said but that
the usual reader must look at it.
"""

from __future__ import annotations

from typing import Any, TypeVar

from brdf_suite.documents.migrations import VERSIONS
from brdf_suite.documents.paint import (
    INTERPOLATIONS,
    OUT_OF_PLANE,
    PARAMETERS,
    Flakes,
    Gloss,
    Measurement,
    OrangePeel,
    Paint,
)
from brdf_suite.errors import ValueRangeError

_T = TypeVar("_T")
_FIELDS = {
    "format", "version", "kind", "name", "measurements", "gloss", "flakes", "interpolation", "near_specular",
    "illuminant", "observer_deg", "notes", "source", "out_of_plane", "orange_peel",
}  # fmt: skip
_READING = {"illumination_deg", "aspecular_deg", "lab"}


def _bounds(name: str) -> tuple[float, float]:
    return PARAMETERS[name].low, PARAMETERS[name].high


_LIGHT, _ASPECULAR, _L, _A, _B, _NEAR = (
    _bounds(name)
    for name in ("illumination_deg", "aspecular_deg", "lab[0]", "lab[1]", "lab[2]", "near_specular")
)


def quick_paint(value: object) -> Paint | None:
    """Return the paint in a JSON object, or None where the usual reader must look at it.

    Only floats count as numbers here, as this program writes them; NaN passes no comparison.
    """
    if type(value) is not dict or not value.keys() <= _FIELDS:
        return None
    get = value.get
    name, notes, source = get("name"), get("notes", ""), get("source", "")
    near = get("near_specular", 1.0)
    if not (
        get("format") == "brdfpaint"
        and get("version") == VERSIONS["brdfpaint"]
        and get("kind") == "aspecular"
        and type(name) is str
        and 0 < len(name) <= 200
        and name.isprintable()
        and not name.isspace()
        and type(notes) is str
        and len(notes) <= 100_000
        and notes.isprintable()
        and type(source) is str
        and len(source) <= 10_000
        and source.isprintable()
        and get("interpolation", "flake") in INTERPOLATIONS
        and get("out_of_plane", "aspecular") in OUT_OF_PLANE
        and get("illuminant", "D65") == "D65"
        and type(get("observer_deg", 10)) is int
        and get("observer_deg", 10) == 10
        and type(near) is float
        and _NEAR[0] <= near <= _NEAR[1]
    ):
        return None
    measurements = _measurements(get("measurements"))
    try:
        gloss = Gloss(**get("gloss", {}))
        flakes = None if value.get("flakes") is None else Flakes(**value["flakes"])
        peel = None if value.get("orange_peel") is None else OrangePeel(**value["orange_peel"])
    except (TypeError, ValueRangeError):
        return None
    if measurements is None:
        return None
    return _made(
        Paint,
        name=name,
        measurements=measurements,
        gloss=gloss,
        flakes=flakes,
        interpolation=get("interpolation", "flake"),
        near_specular=near,
        illuminant="D65",
        observer_deg=10,
        notes=notes,
        source=source,
        out_of_plane=get("out_of_plane", "aspecular"),
        orange_peel=peel,
    )


def _measurements(items: object) -> tuple[Measurement, ...] | None:
    if type(items) is not list or not 3 <= len(items) <= 100:
        return None
    found, angles = [], []
    for item in items:
        if type(item) is not dict or item.keys() != _READING:
            return None
        light, aspecular, lab = item["illumination_deg"], item["aspecular_deg"], item["lab"]
        if not (
            type(light) is float
            and type(aspecular) is float
            and _LIGHT[0] <= light <= _LIGHT[1]
            and _ASPECULAR[0] <= aspecular <= _ASPECULAR[1]
            and -90.0 < light - aspecular < 90.0
            and type(lab) is list
            and len(lab) == 3
        ):
            return None
        lightness, a, b = lab
        if not (
            type(lightness) is float
            and type(a) is float
            and type(b) is float
            and _L[0] <= lightness <= _L[1]
            and _A[0] <= a <= _A[1]
            and _B[0] <= b <= _B[1]
        ):
            return None
        found.append(
            _made(Measurement, illumination_deg=light, aspecular_deg=aspecular, lab=(lightness, a, b))
        )
        angles.append((round(light, 6), round(aspecular, 6)))
    # Angles that agree to a millionth of a degree may be the same one: the usual reader knows.
    return tuple(found) if len(set(angles)) == len(angles) else None


def _made(kind: type[_T], **fields: Any) -> _T:
    """Return a frozen value of fields that are already checked; every field must be given."""
    value = object.__new__(kind)
    value.__dict__.update(fields)
    return value
