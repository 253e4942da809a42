"""Paints and views as JSON files: ``.brdfpaint`` and ``.brdfview``.

Each file is ``{"format": ..., "version": ..., fields}`` with the fields named as in the values. Fields with a
default may be left out; unknown ones are refused. The same JSON travels between the programs.

The usual reader names the place of whatever is wrong, and takes half a millisecond a paint. For large palettes
:func:`quick_paint` builds a paint of the present version whose every field is as it should be at once; of
anything else nothing is said but that the usual reader must look at it.
"""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from brdf_suite.documents.atomic import encode, with_lists, write_atomically
from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.documents.paint import (
    INTERPOLATIONS,
    OUT_OF_PLANE,
    PARAMETERS,
    SCATTERINGS,
    Flakes,
    Gloss,
    Measurement,
    OrangePeel,
    Paint,
    TextureTargets,
)
from brdf_suite.documents.reading import VERSIONS, FieldReader, fill, open_envelope, read_json
from brdf_suite.documents.view import PARTS, Camera, View
from brdf_suite.documents.view_settings import Lamp, PartMaterial, SurfaceLook
from brdf_suite.errors import DocumentError, PathLike, ValueRangeError
from brdf_suite.regular_files import within_memory

_FIELDS = {
    "format", "version", "kind", "name", "measurements", "gloss", "flakes", "interpolation", "near_specular",
    "illuminant", "observer_deg", "notes", "source", "out_of_plane", "orange_peel", "scattering",
    "texture",
}  # fmt: skip
_READING = {"illumination_deg", "aspecular_deg", "lab"}


_LIGHT, _ASPECULAR, _L, _A, _B, _NEAR = (
    (PARAMETERS[name].low, PARAMETERS[name].high)
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
        and get("scattering", "multiple") in SCATTERINGS
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
        texture = None if value.get("texture") is None else TextureTargets(**value["texture"])
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
        # Most paints of a palette have the same words here: one copy of each is kept.
        interpolation=sys.intern(get("interpolation", "flake")),
        near_specular=near,
        illuminant="D65",
        observer_deg=10,
        notes=sys.intern(notes),
        source=sys.intern(source),
        out_of_plane=sys.intern(get("out_of_plane", "aspecular")),
        orange_peel=peel,
        texture=texture,
        scattering=sys.intern(get("scattering", "multiple")),
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
    for name, field in fields.items():
        object.__setattr__(value, name, field)
    return value


PAINT_ENDING = ".brdfpaint"
VIEW_ENDING = ".brdfview"

AnyPaint = Paint | CookTorrancePaint | FactoredPaint
"""Every kind of paint; the field ``kind`` of a file distinguishes them."""

_KINDS: dict[type, str] = {Paint: "aspecular", CookTorrancePaint: "cook_torrance", FactoredPaint: "factored"}
_T = TypeVar("_T")


@within_memory
def load_paint(path: PathLike) -> Paint:
    """Read a ``.brdfpaint`` file that must be an aspecular paint, the kind that is designed by its readings.

    Raises
    ------
    DocumentError
        Its content is not valid, or it is a paint of another kind; with the place.
    FileError
        It cannot be read.
    """
    return paint_from_json(read_json(path), path)


@within_memory
def load_any_paint(path: PathLike) -> AnyPaint:
    """Read a ``.brdfpaint`` file of any kind; errors as :func:`load_paint`."""
    return any_paint_from_json(read_json(path), path)


def save_paint(paint: AnyPaint, path: PathLike) -> None:
    """Write a ``.brdfpaint`` file, whole or not at all; raise :class:`FileError` where that fails.

    The textures of a factored paint are copied beside it, unless they lie there.
    """
    if isinstance(paint, FactoredPaint):
        # Only such a paint needs what reads EXR files.
        from brdf_suite.documents.factor_textures import save_beside

        paint = dataclasses.replace(paint, textures=save_beside(paint.textures, path))
    write_atomically(path, encode(paint_to_json(paint)))


@within_memory
def load_view(path: PathLike) -> View:
    """Read a ``.brdfview`` file; raise :class:`DocumentError` or :class:`FileError` with the place."""
    return view_from_json(read_json(path), path)


def save_view(view: View, path: PathLike) -> None:
    """Write a ``.brdfview`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, encode(view_to_json(view)))


def paint_to_json(paint: AnyPaint) -> dict[str, object]:
    """Return the JSON object of a paint; :func:`any_paint_from_json` is its inverse."""
    kind = _KINDS[type(paint)]
    fields = {name: _plain(getattr(paint, name)) for name in paint.__dataclass_fields__}
    return {"format": "brdfpaint", "version": VERSIONS["brdfpaint"], "kind": kind, **fields}


def _plain(value: object) -> object:
    """Return a field as JSON data. Ten times as fast as ``dataclasses.asdict``, which copies every number deeply."""
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    names = getattr(value, "__dataclass_fields__", None)
    return value if names is None else {name: _plain(getattr(value, name)) for name in names}


def any_paint_from_json(value: object, path: PathLike = "the message") -> AnyPaint:
    """Return the paint in a JSON value; ``path`` is what error messages call its origin.

    Raises :class:`DocumentError`: a field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, "brdfpaint", path)
    kind = reader.take("kind")
    if kind == "aspecular":
        return _aspecular(reader)
    if kind == "cook_torrance":
        name, kd = reader.take("name"), reader.take("kd")
        items = reader.take_objects("lobes")
        parts = {
            "lobes": tuple(fill(item, CookTorranceLobe, required=("ks", "m", "r")) for item in items),
            "clearcoat": _optional(reader, "clearcoat", Clearcoat),
            "flakes": _optional(reader, "flakes", Flakes),
        }
        return fill(reader, CookTorrancePaint, taken={"name": name, "kd": kd, **parts})
    if kind != "factored":
        reader.fail('the kinds known to this version are "aspecular", "cook_torrance" and "factored"', "kind")
    return _factored(reader, path)


def paint_from_json(value: object, path: PathLike = "the message") -> Paint:
    """Return the aspecular paint in a JSON value; errors as :func:`any_paint_from_json`, other kinds too."""
    paint = any_paint_from_json(value, path)
    if not isinstance(paint, Paint):
        what = "a Cook-Torrance paint" if isinstance(paint, CookTorrancePaint) else "a factored paint"
        raise DocumentError(
            path,
            f"holds {what}; expected a paint of aspecular readings, which can be edited "
            "(brdf-suite render and fit take every kind)",
            "kind",
        )
    return paint


def _aspecular(reader: FieldReader) -> Paint:
    name = reader.take("name")
    angles = ("illumination_deg", "aspecular_deg", "lab")
    measurements = tuple(
        fill(item, Measurement, required=angles) for item in reader.take_objects("measurements")
    )
    gloss = fill(reader.take_object("gloss"), Gloss, required=("gu_20",))
    parts = {
        "flakes": _optional(reader, "flakes", Flakes),
        "orange_peel": _optional(reader, "orange_peel", OrangePeel),
        "texture": _optional(reader, "texture", TextureTargets),
    }
    return fill(reader, Paint, taken={"name": name, "measurements": measurements, "gloss": gloss, **parts})


def _factored(reader: FieldReader, path: PathLike) -> FactoredPaint:
    inside = reader.take_object("textures")
    textures = fill(inside, TextureFile, required=("path", "sha256"))
    # The document names it from its own folder; a paint in memory has no folder.
    absolute = str(Path(path).absolute().parent / textures.path)
    with inside.naming():
        textures = TextureFile(absolute, textures.sha256)
    parts = {
        "clearcoat": _optional(reader, "clearcoat", Clearcoat),
        "flakes": _optional(reader, "flakes", Flakes),
        "textures": textures,
    }
    names = {name: reader.take(name) for name in ("name", "factors", "alpha")}
    return fill(reader, FactoredPaint, taken={**names, **parts})


def _optional(reader: FieldReader, name: str, kind: Callable[..., _T]) -> _T | None:
    """Return the object in field ``name``, or None where it is absent or null."""
    value = reader.take_or(name, None)
    return None if value is None else fill(FieldReader(value, reader.path, name), kind)


def view_to_json(view: View) -> dict[str, object]:
    """Return the JSON object of a view; :func:`view_from_json` is its inverse."""
    fields: dict[str, object] = dataclasses.asdict(view, dict_factory=with_lists)
    return {"format": "brdfview", "version": VERSIONS["brdfview"], **fields}


def view_from_json(value: object, path: PathLike = "the message") -> View:
    """Return the view in a JSON value; errors as :func:`paint_from_json`."""
    reader = open_envelope(value, "brdfview", path)
    taken: dict[str, object] = {"camera": fill(reader.take_object("camera"), Camera)}
    for name, kind in PARTS.items():
        if name not in taken and reader.has(name):
            part = reader.take_object(name)
            within: dict[str, object] = {}
            if kind is SurfaceLook and part.has("materials"):
                items = part.take_objects("materials")
                within["materials"] = tuple(
                    fill(item, PartMaterial, required=("part", "material")) for item in items
                )
            taken[name] = fill(part, kind, taken=within)
    if reader.has("lamps"):
        taken["lamps"] = tuple(fill(item, Lamp) for item in reader.take_objects("lamps"))
    return fill(reader, View, taken=taken)
