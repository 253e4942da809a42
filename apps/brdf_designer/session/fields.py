"""What can be edited in a paint: each field has a key, an edit that gives a new paint, and a name for Undo.

Keys are tuples: ``("lab", index, component)``, ``("colour", index)``, ``("gloss", "gu_20")``, ``("coat", "ior")``,
``("flakes", "size_um")``, ``("orange_peel", "amplitude_um")``, or the field itself, as in ``("near_specular",)``.
Those of several readings at once are worked out from the paint ``base`` with which the gesture began, so that a drag
there and back ends where it began:

- ``("lch", index, component)``: ``(base, amount, hue)``, the hue of a grey, degrees
- ``("together", space, component)``: ``(base, index, amount, hue)``, a reading's new L*a*b* or LCh; all move in step
- ``("flop", what)``: ``(base, amount)`` with ``index``, ``lightness``, ``chroma`` or ``hue``
- ``("angles", what)``: ``set`` with a name of :data:`GEOMETRY_SETS`, ``add`` with a :class:`Geometry`, ``remove`` with
  an index
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from brdf_qt.program.translation import mark, tr

from brdf_suite.appearance.clearcoat_gloss import HIGHEST_ROUGHNESS, LOWEST_ROUGHNESS
from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.appearance.flop.edits import (
    GREY_CHROMA,
    hue_difference,
    shift_labs,
    shift_lchs,
    with_flop_index,
    with_flop_travel,
)
from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.documents.paint import PARAMETERS, Flakes, Lab, OrangePeel, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.paint_design.angle_sets import at_geometries, with_angle, without_angle
from brdf_suite.reflectance.designed.build import DarkerThanCoatError, gloss_of_coat

Key = tuple[str | int, ...]
COMPONENTS = ("L*", "a*", "b*")
LCH_COMPONENTS = ("L*", "C*", "h")
DEFAULT_FLAKES = Flakes()
DEFAULT_PEEL = OrangePeel()
# Of L*a*b* that comes of angles: as fine as the numbers are shown, and a little more.
_DIGITS = 4
_GLOSS_DIGITS = 3
_HALVINGS = 14


def apply_edit(paint: Paint, key: Key, value: Any) -> Paint:
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
    if kind in ("lab", "lch"):
        names = COMPONENTS if kind == "lab" else LCH_COMPONENTS
        return tr("Change {name} at {angle}").format(
            name=names[int(key[2])], angle=angle_text(paint, int(key[1]))
        )
    if kind == "together":
        names = COMPONENTS if key[1] == "lab" else LCH_COMPONENTS
        return tr("Change {name} at All Angles").format(name=names[int(key[2])])
    if kind == "colour":
        return tr("Pick Colour at {angle}").format(angle=angle_text(paint, int(key[1])))
    if len(key) == 2 and f"{kind}.{key[1]}" in PARAMETERS:
        return tr("Change {name}").format(name=PARAMETERS[f"{kind}.{key[1]}"].label)
    return tr(_NAMES[".".join(map(str, key))])


def angle_text(paint: Paint, index: int) -> str:
    """Return the angle of a measurement, as in ``15°``; with its light where that is not at 45°."""
    measurement = paint.measurements[index]
    text = f"{measurement.aspecular_deg:g}°".replace("-", "−")
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
    if key[1] == "gu_60":
        return replace(paint, gloss=replace(paint.gloss, gu_60=value))
    if value is None:
        raise TypeError("a paint always has a gloss reading at 20°")
    return replace(paint, gloss=replace(paint.gloss, gu_20=value))


def _flakes(paint: Paint, key: Key, value: Any) -> Paint:
    if len(key) == 1:
        return replace(paint, flakes=value)
    return replace(paint, flakes=replace(paint.flakes or DEFAULT_FLAKES, **{str(key[1]): value}))


def _lch(paint: Paint, key: Key, value: tuple[Paint, float, float]) -> Paint:
    base, amount, hue = value
    index = int(key[1])
    return _with_lab(paint, index, lab_with(base.measurements[index].lab, int(key[2]), amount, hue))


def lab_with(lab: Lab, component: int, amount: float, hue: float) -> Lab:
    """Return a colour with L*, C* or h (degrees) set to ``amount``; ``hue`` is what a grey has."""
    lch = lab_to_lch(lab)
    if lch[1] < GREY_CHROMA:
        lch[2] = hue
    lch[component] = amount
    return _rounded(lch_to_lab(lch))


def _together(paint: Paint, key: Key, value: tuple[Paint, int, float, float]) -> Paint:
    base, index, amount, hue = value
    labs = np.array([item.lab for item in base.measurements])
    component = int(key[2])
    delta = np.zeros(3)
    if key[1] == "lab":
        delta[component] = amount - labs[index, component]
        moved = shift_labs(labs, delta)
    else:
        now = lab_to_lch(labs[index])
        if now[1] < GREY_CHROMA:
            now[2] = hue
        delta[component] = hue_difference(now[2], amount) if component == 2 else amount - now[component]
        moved = shift_lchs(labs, delta, hue)
    kept = labs[:, component] if key[1] == "lab" else None
    result = _with_labs(paint, moved)
    if kept is None:
        return result
    # The colour that is edited gets the very number that was asked for.
    return _lab(result, ("lab", index, component), amount)


def _flop(paint: Paint, key: Key, value: tuple[Paint, float]) -> Paint:
    base, amount = value
    angles = [item.aspecular_deg for item in base.measurements]
    labs = [item.lab for item in base.measurements]
    if key[1] == "index":
        return _with_labs(paint, with_flop_index(angles, labs, amount))
    component = ("lightness", "chroma", "hue").index(str(key[1]))
    return _with_labs(paint, with_flop_travel(angles, labs, component, amount))


def _angles(paint: Paint, key: Key, value: Any) -> Paint:
    if key[1] == "set":
        return at_geometries(paint, GEOMETRY_SETS[value].geometries)
    return with_angle(paint, value) if key[1] == "add" else without_angle(paint, value)


def _with_labs(paint: Paint, labs: np.ndarray[Any, Any]) -> Paint:
    return replace(
        paint,
        measurements=tuple(
            item if tuple(row.tolist()) == item.lab else replace(item, lab=_rounded(row))
            for item, row in zip(paint.measurements, labs, strict=True)
        ),
    )


def _rounded(row: Any) -> Lab:
    lightness, a, b = (round(float(value), _DIGITS) + 0.0 for value in row)
    return lightness, a, b


def _coat(paint: Paint, _key: Key, value: tuple[float, float]) -> Paint:
    ior, roughness = value
    try:
        gloss = gloss_of_coat(paint, ior, roughness)
    except DarkerThanCoatError as error:
        raise _too_rough(paint, ior, error) from error
    assert gloss.gu_60 is not None
    return replace(
        paint,
        gloss=replace(
            gloss, gu_20=round(gloss.gu_20, _GLOSS_DIGITS), gu_60=round(gloss.gu_60, _GLOSS_DIGITS)
        ),
    )


class TooRoughError(UnreachableError):
    """A coat too rough for the colours under it; ``nearest`` is the roughest that can be: index and roughness."""

    nearest: tuple[float, float] = (math.nan, math.nan)


def _too_rough(paint: Paint, ior: float, error: DarkerThanCoatError) -> TooRoughError:
    """Say why the coat cannot be, and how rough one of that index can be at most over these colours."""
    _, angle = error.measurement
    low, high = LOWEST_ROUGHNESS, HIGHEST_ROUGHNESS
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high)
        try:
            gloss_of_coat(paint, ior, middle)
        except DarkerThanCoatError:
            high = middle
        else:
            low = middle
    most = math.floor(1e4 * low) / 1e4
    text = tr(
        "With this roughness the coat alone reflects {share:.4f} of the light at "
        "{angle:g}°, more than the colour there. With index {ior:.3f} the roughness "
        "can be up to {most:.4f}."
    ).format(share=error.share, angle=angle, ior=ior, most=most)
    refusal = TooRoughError(text)
    refusal.nearest = (ior, most)
    return refusal


def _orange_peel(paint: Paint, key: Key, value: Any) -> Paint:
    if len(key) == 1:
        return replace(paint, orange_peel=value)
    peel = paint.orange_peel or DEFAULT_PEEL
    return replace(paint, orange_peel=replace(peel, **{str(key[1]): value}))


def _nearest(_paint: Paint, _key: Key, value: Paint) -> Paint:
    return value


def _plain(paint: Paint, key: Key, value: Any) -> Paint:
    return replace(paint, **{str(key[0]): value})


def _solid(paint: Paint, _key: Key, value: int) -> Paint:
    lab = paint.measurements[value].lab
    return replace(paint, measurements=tuple(replace(item, lab=lab) for item in paint.measurements))


_EDITS: dict[str | int, Callable[[Paint, Key, Any], Paint]] = {
    "lab": _lab,
    "lch": _lch,
    "together": _together,
    "flop": _flop,
    "angles": _angles,
    "colour": _colour,
    "gloss": _gloss,
    "coat": _coat,
    "orange_peel": _orange_peel,
    "flakes": _flakes,
    "solid": _solid,
    "nearest": _nearest,
    "interpolation": _plain,
    "near_specular": _plain,
    "name": _plain,
    "notes": _plain,
    "source": _plain,
}
_NAMES: dict[str, str] = {
    "flop.index": mark("Change Flop Index"),
    "flop.lightness": mark("Change Lightness Travel"),
    "flop.chroma": mark("Change Chroma Travel"),
    "flop.hue": mark("Change Hue Travel"),
    "angles.set": mark("Change Angles"),
    "angles.add": mark("Add Angle"),
    "angles.remove": mark("Remove Angle"),
    "coat.ior": mark("Change Coat Index"),
    "coat.roughness": mark("Change Coat Roughness"),
    "orange_peel": mark("Orange Peel On"),
    "flakes": mark("Flakes On"),
    "solid": mark("Make Solid"),
    "nearest": mark("Use Closest Paint"),
    "interpolation": mark("Change Interpolation"),
    "near_specular": mark("Change Near-Specular Factor"),
    "name": mark("Rename Paint"),
    "notes": mark("Edit Notes"),
    "source": mark("Edit Source"),
}
