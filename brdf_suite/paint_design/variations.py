"""The neighbours of a paint: a step lighter, darker, cleaner, dirtier, deeper, warmer, in flop, hue or size of flakes.

A step is in units of CIELAB at every angle alike: ΔL* for lightness, ΔC*ab for chroma. A hue turns all angles by one
angle, such that ΔH*ab is the step where the chroma is largest. Flop adds ΔL* at the reading nearest to the mirror
direction and takes it away at the farthest one; the face, nearest to 45°, stays, and between them the share is linear
in the aspecular angle.

Deeper goes away from white in the plane of L* and C*, as the depth √((100 - L*)² + C*²) of Berns (Color Research and
Application 39, 2014) grows fastest; above L* 100 only the chroma grows. Warmer turns the hue as above towards 50°, the
warmest of all in the model of Ou et al. (Color Research and Application 29, 2004), 0.02 C*^1.07 cos(h - 50°), and not
past it; a grey moves the step along that hue. Finer and coarser flakes change their diameter by a factor of
:data:`FLAKE_RATIO` and keep the area that they cover: their density goes with the inverse square.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np

from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.appearance.difference.words import hue_word
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import PARAMETERS, Measurement, Paint
from brdf_suite.errors import SuiteError, ValueRangeError
from brdf_suite.pipeline.lobe_fit import PaintFitter

Direction = Literal[
    "lighter",
    "darker",
    "cleaner",
    "dirtier",
    "more_flop",
    "less_flop",
    "hue_forward",
    "hue_back",
    "deeper",
    "warmer",
    "finer_flakes",
    "coarser_flakes",
]
DIRECTIONS: tuple[Direction, ...] = get_args(Direction)

LEAST_STEP, USUAL_STEP, MOST_STEP = 0.1, 2.0, 20.0
GREY_BELOW = 0.5
"""The largest C*ab of a paint that is taken for a grey, without a hue or a chroma that could be changed."""
MISSED_FROM = 0.5
"""ΔE00 between what is asked and what a paint and its lobes can give, from which it is reported."""
FLAKE_RATIO = 1.25

_FACE_DEG = 45.0
_WARMEST_DEG, _WARM_DEG = 50.0, 1.0
_DECIMALS = 2


@dataclass(frozen=True)
class Variation:
    """A neighbour. ``word`` is what it is more of; ``paint`` is ``None`` where there is none, and ``reason`` why.

    ``missed`` is the largest ΔE00 by which the picture of it would miss its colours, once it was fitted.
    """

    direction: Direction
    word: str
    paint: Paint | None
    reason: str = ""
    missed: float | None = None

    @property
    def is_missed(self) -> bool:
        """Whether no paint of this kind quite gives its colours."""
        return self.missed is not None and self.missed >= MISSED_FROM


def variations(paint: Paint, step: float = USUAL_STEP) -> tuple[Variation, ...]:
    """Return the neighbours at a distance of ``step``, in the order of :data:`DIRECTIONS`.

    Each changes the colours alone, or the flakes alone, by a factor that is not of the step. A neighbour that cannot
    be is without a paint.

    >>> from brdf_suite.documents.paint import solid_paint
    >>> found = {one.direction: one for one in variations(solid_paint("grey", (50.0, 0.0, 0.0)))}
    >>> found["lighter"].paint.lab_at(45.0), found["cleaner"].paint
    ((52.0, 0.0, 0.0), None)

    Raises :class:`ValueRangeError`: the step is not between 0.1 and 20.
    """
    if not LEAST_STEP <= step <= MOST_STEP:
        raise ValueRangeError("step", f"from {LEAST_STEP:g} to {MOST_STEP:g} is wanted, not {step:g}")
    return tuple(_varied(paint, direction, step) for direction in DIRECTIONS)


def examined(variation: Variation, fitter: PaintFitter) -> Variation:
    """Return the neighbour with what a fit says of it: that there is no such paint, or by how much it is missed."""
    if variation.paint is None:
        return variation
    try:
        fit = fitter.fit(variation.paint)
    except SuiteError as error:
        return replace(variation, paint=None, reason=str(error))
    return replace(variation, missed=fit.worst_delta_e)


def _varied(paint: Paint, direction: Direction, step: float) -> Variation:
    if direction in _FLAKES:
        return _other_flakes(paint, direction)
    lch = lab_to_lch([m.lab for m in paint.measurements])
    strongest = int(np.argmax(lch[:, 1]))
    if direction in ("hue_forward", "hue_back"):
        word = hue_word(float(lch[strongest, 2]), 1.0 if direction == "hue_forward" else -1.0)
    else:
        word = direction.replace("_", " ")
    move, sign = _MOVES[direction]
    try:
        moved = move(paint, lch, sign * step)
    except _NoneError as reason:
        return Variation(direction, word, None, str(reason))
    lab = np.round(lch_to_lab(moved), _DECIMALS) + 0.0
    measurements = []
    for old, row in zip(paint.measurements, lab.tolist(), strict=True):
        beyond = _beyond(old, row)
        if beyond:
            return Variation(direction, word, None, beyond)
        measurements.append(replace(old, lab=(row[0], row[1], row[2])))
    return Variation(direction, word, replace(paint, measurements=tuple(measurements)))


def _other_flakes(paint: Paint, direction: Direction) -> Variation:
    word, flakes = direction.replace("_", " "), paint.flakes
    if flakes is None:
        return Variation(direction, word, None, "This paint has no flakes.")
    ratio = FLAKE_RATIO ** _FLAKES[direction]
    size, density = flakes.size_um * ratio, flakes.density_per_mm2 / ratio**2
    for name, value in (("size_um", size), ("density_per_mm2", density)):
        known = PARAMETERS[f"flakes.{name}"]
        if not known.low <= value <= known.high:
            reason = f"{known.label} would be {value:.3g}, beyond {known.low:g} to {known.high:g}."
            return Variation(direction, word, None, reason)
    changed = replace(flakes, size_um=round(size, _DECIMALS), density_per_mm2=round(density, _DECIMALS))
    return Variation(direction, word, replace(paint, flakes=changed))


class _NoneError(Exception):
    """There is no such neighbour; the message says why."""


def _lighter(_paint: Paint, lch: Floats, step: float) -> Floats:
    return np.asarray(lch + np.array([step, 0.0, 0.0]))


def _cleaner(_paint: Paint, lch: Floats, step: float) -> Floats:
    if lch[:, 1].max() < GREY_BELOW:
        raise _NoneError("A grey has no chroma to change.")
    if lch[:, 1].max() + step < 0.0:
        raise _NoneError(f"Its largest chroma is {lch[:, 1].max():.1f}, less than the step.")
    moved = lch.copy()
    # What is a grey beside coloured angles stays one: it has no hue to become cleaner in.
    coloured = lch[:, 1] >= GREY_BELOW
    moved[coloured, 1] = np.maximum(lch[coloured, 1] + step, 0.0)
    return moved


def _turned(_paint: Paint, lch: Floats, step: float) -> Floats:
    chroma = float(lch[:, 1].max())
    if chroma < GREY_BELOW:
        raise _NoneError("A grey has no hue to turn.")
    return np.asarray(lch + np.array([0.0, 0.0, _turn(chroma, step)]))


def _deeper(_paint: Paint, lch: Floats, step: float) -> Floats:
    moved = lch.copy()
    below = np.maximum(100.0 - lch[:, 0], 0.0)
    # A grey has no hue in which it could get chroma.
    chroma = np.where(lch[:, 1] < GREY_BELOW, 0.0, lch[:, 1])
    depth = np.hypot(below, chroma)
    if depth.min() == 0.0:
        raise _NoneError("A white has no depth.")
    moved[:, 0] -= step * below / depth
    moved[:, 1] += step * chroma / depth
    return moved


def _warmer(_paint: Paint, lch: Floats, step: float) -> Floats:
    strongest = int(np.argmax(lch[:, 1]))
    if lch[strongest, 1] < GREY_BELOW:
        lab = lch_to_lab(lch) + lch_to_lab([0.0, step, _WARMEST_DEG])
        return np.asarray(lab_to_lch(lab))
    away = (_WARMEST_DEG - float(lch[strongest, 2]) + 180.0) % 360.0 - 180.0
    if abs(away) < _WARM_DEG:
        raise _NoneError("It has the warmest hue already.")
    turn = min(_turn(float(lch[strongest, 1]), step), abs(away))
    return np.asarray(lch + np.array([0.0, 0.0, math.copysign(turn, away)]))


def _turn(chroma: float, step: float) -> float:
    """The angle, degrees, of a step ΔH*ab at a chroma; across the whole circle is the farthest there is."""
    # ΔH = 2 C sin(Δh / 2)
    return 2.0 * math.degrees(math.asin(min(1.0, max(-1.0, 0.5 * step / chroma))))


def _flopped(paint: Paint, lch: Floats, step: float) -> Floats:
    angles = np.abs([m.aspecular_deg for m in paint.measurements])
    moved = lch.copy()
    moved[:, 0] += step * flop_shares(angles)
    near, far = int(np.argmin(angles)), int(np.argmax(angles))
    if step < 0.0 and moved[near, 0] < moved[far, 0]:
        raise _NoneError("It has no flop left to take away.")
    return moved


def flop_shares(aspecular_deg: Floats) -> Floats:
    """Return by how much each reading takes part in a change of flop: 1 near, 0 at the face, -1 far; (n,).

    >>> flop_shares(np.array([15.0, 30.0, 45.0, 110.0])).tolist()
    [1.0, 0.5, 0.0, -1.0]
    """
    near, far = float(np.min(aspecular_deg)), float(np.max(aspecular_deg))
    face = float(aspecular_deg[int(np.argmin(np.abs(aspecular_deg - _FACE_DEG)))])
    if not near < face < far:
        face = 0.5 * (near + far)
    if near == far:
        return np.zeros_like(aspecular_deg)
    return np.asarray(np.interp(aspecular_deg, [near, face, far], [1.0, 0.0, -1.0]))


def _beyond(measurement: Measurement, lab: list[float]) -> str:
    """Say which value no paint can have; empty where all are fine."""
    where = f"{measurement.aspecular_deg:g}°"
    if measurement.illumination_deg != _FACE_DEG:
        where += f" with the light at {measurement.illumination_deg:g}°"
    if lab[0] < 0.0:
        return f"L* at {where} would be {lab[0]:.1f}, darker than black."
    for index, value in enumerate(lab):
        known = PARAMETERS[f"lab[{index}]"]
        if not known.low <= value <= known.high:
            return f"{known.label} at {where} would be {value:.1f}, beyond {known.low:g} to {known.high:g}."
    return ""


_MOVES: dict[Direction, tuple[Callable[[Paint, Floats, float], Floats], float]] = {
    "lighter": (_lighter, 1.0),
    "darker": (_lighter, -1.0),
    "cleaner": (_cleaner, 1.0),
    "dirtier": (_cleaner, -1.0),
    "more_flop": (_flopped, 1.0),
    "less_flop": (_flopped, -1.0),
    "hue_forward": (_turned, 1.0),
    "hue_back": (_turned, -1.0),
    "deeper": (_deeper, 1.0),
    "warmer": (_warmer, 1.0),
}
"""What moves the colours, and the sign of its step."""

_FLAKES: dict[Direction, int] = {"finer_flakes": -1, "coarser_flakes": 1}
"""The power of the factor on their diameter."""
