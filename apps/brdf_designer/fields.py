"""What can be edited in a paint: each field has a key, an edit that gives a new paint, and a name for Undo.

Keys are tuples: ``("lab", index, component)``, ``("colour", index)``, ``("gloss", "gu_20")``,
``("flakes", "size_um")``, or the field itself, as in ``("near_specular",)``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from brdf_suite.documents.paint import PARAMETERS, Flakes, Paint

Key = tuple[str | int, ...]
COMPONENTS = ("L*", "a*", "b*")
DEFAULT_FLAKES = Flakes()


def edited(paint: Paint, key: Key, value: Any) -> Paint:
    """Return ``paint`` with the field ``key`` set to ``value``.

    Raises
    ------
    ValueRangeError
        The value is out of its range; the message names the field.
    KeyError
        There is no such field.
    """
    return _EDITS[key[0]](paint, key, value)


def step_name(paint: Paint, key: Key) -> str:
    """Return what Undo calls a change of ``key``, as in ``Change L* at 15°``."""
    kind = key[0]
    if kind == "lab":
        return f"Change {COMPONENTS[int(key[2])]} at {angle_text(paint, int(key[1]))}"
    if kind == "colour":
        return f"Pick Colour at {angle_text(paint, int(key[1]))}"
    if kind in ("gloss", "flakes") and len(key) == 2:
        return f"Change {PARAMETERS[f'{kind}.{key[1]}'].label}"
    return _NAMES[kind]


def angle_text(paint: Paint, index: int) -> str:
    """Return the angle of a measurement, as in ``15°``; with its light where that is not at 45°."""
    measurement = paint.measurements[index]
    text = f"{measurement.aspecular_deg:g}°"
    light = measurement.illumination_deg
    return text if light == 45.0 else f"{text}, light {light:g}°"


def by_angle(paint: Paint) -> tuple[int, ...]:
    """Return the indices of the measurements in the order in which they are shown: by light, then angle."""
    items = paint.measurements
    return tuple(sorted(range(len(items)), key=lambda i: (items[i].illumination_deg, items[i].aspecular_deg)))


def _with_lab(paint: Paint, index: int, lab: tuple[float, float, float]) -> Paint:
    items = list(paint.measurements)
    items[index] = replace(items[index], lab=lab)
    return replace(paint, measurements=tuple(items))


def _lab(paint: Paint, key: Key, value: float) -> Paint:
    index, component = int(key[1]), int(key[2])
    lab = list(paint.measurements[index].lab)
    lab[component] = float(value)
    return _with_lab(paint, index, (lab[0], lab[1], lab[2]))


def _colour(paint: Paint, key: Key, value: tuple[float, float, float]) -> Paint:
    return _with_lab(paint, int(key[1]), value)


def _gloss(paint: Paint, key: Key, value: float | None) -> Paint:
    return replace(paint, gloss=replace(paint.gloss, **{str(key[1]): value}))


def _flakes(paint: Paint, key: Key, value: Any) -> Paint:
    if len(key) == 1:
        return replace(paint, flakes=value)
    return replace(paint, flakes=replace(paint.flakes or DEFAULT_FLAKES, **{str(key[1]): value}))


def _plain(paint: Paint, key: Key, value: Any) -> Paint:
    return replace(paint, **{str(key[0]): value})


def _solid(paint: Paint, _key: Key, value: int) -> Paint:
    lab = paint.measurements[value].lab
    return replace(paint, measurements=tuple(replace(item, lab=lab) for item in paint.measurements))


_EDITS: dict[str | int, Callable[[Paint, Key, Any], Paint]] = {
    "lab": _lab,
    "colour": _colour,
    "gloss": _gloss,
    "flakes": _flakes,
    "solid": _solid,
    "interpolation": _plain,
    "near_specular": _plain,
    "name": _plain,
    "notes": _plain,
    "source": _plain,
}
_NAMES: dict[str | int, str] = {
    "flakes": "Switch Flakes",
    "solid": "Make Solid",
    "interpolation": "Change Interpolation",
    "near_specular": "Change Near-Specular Factor",
    "name": "Rename Paint",
    "notes": "Edit Notes",
    "source": "Edit Source",
}
