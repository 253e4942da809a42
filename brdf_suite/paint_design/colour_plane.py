"""The plane of a* and b* at one L*, as a picture: its colours on a device, where they end, and what a paint reaches.

What a paint reaches at one reading while its others stay is, in the working space, a box. The lobes give a channel as
ρ = s + M x with x ≥ 0 (:func:`~brdf_suite.paint_design.feasible.cone_of_lobes`), the same system for every channel; so
the least and the greatest ρ at the reading, with the other readings met within :data:`HELD`, are two linear programs
for each channel, and the three channels do not depend on one another.

Boundaries are where a function that is positive inside becomes 0, found on the lattice of the picture and joined cell
by cell with straight lines (marching squares).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import lab_to_working
from brdf_suite.appearance.colour.spaces import SRGB_SPACE, DisplaySpace, lch_to_lab
from brdf_suite.arrays import Bytes, Floats
from brdf_suite.paint_design.feasible import cone_of_lobes, judged
from brdf_suite.pipeline.lobe_fit import LobeFit

SIZE = 97
"""Points of the lattice in each direction; the middle one is grey."""
HELD = 0.02
"""Share of their reflectance factor by which the other readings may be missed: about half a unit of ΔE00."""

_LEAST_HELD = 2e-4
_TOLERANCE = 1e-4
_FADED, _UNREACHED = 0.4, 0.8
_RING_LIGHTNESS, _RING_CHROMA = 65.0, 45.0


@dataclass(frozen=True)
class ReachableBox:
    """The least and the greatest reflectance factor of each channel, working space, that a paint gives at a reading."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class ColourPlane:
    """The plane at one L*.

    Attributes
    ----------
    codes
        (SIZE, SIZE, 3), codes of the device; a* grows from left to right, b* from the last row to the first. Colours
        that the device cannot show are clipped and faded, those that the paint does not reach are nearly grey.
    gamut
        (n, 2, 2), lines from (a*, b*) to (a*, b*) where the device's colours end.
    reachable
        The same of what the paint reaches; None where that is not known.
    """

    codes: Bytes
    gamut: Floats
    reachable: Floats | None


def colour_plane(
    lightness: float,
    most_chroma: float,
    box: ReachableBox | None = None,
    space: DisplaySpace = SRGB_SPACE,
) -> ColourPlane:
    """Return the plane at an L*, from -``most_chroma`` to ``most_chroma`` in a* and b*.

    >>> plane = colour_plane(50.0, 100.0)
    >>> plane.codes[SIZE // 2, SIZE // 2].tolist()
    [119, 119, 119]
    """
    axis = np.linspace(-most_chroma, most_chroma, SIZE)
    lab = np.empty((SIZE, SIZE, 3))
    lab[..., 0] = lightness
    lab[..., 1] = axis
    lab[..., 2] = axis[::-1, None]
    rho = lab_to_working(lab)
    linear = space.of_working(rho)
    inside = np.minimum(linear, 1.0 - linear).min(axis=-1) + _TOLERANCE
    codes = 255.0 * space.encode(linear)
    # What the screen shows in place of an outside colour is another colour, and is not to be judged.
    grey = 255.0 * space.encode(space.of_working(lab_to_working([lightness, 0.0, 0.0])))
    fading = np.where(inside >= 0.0, 0.0, _FADED)
    reachable = None
    if box is not None:
        low, high = np.array(box.low), np.array(box.high)
        margin = (np.minimum(rho - low, high - rho) / np.maximum(low, _LEAST_HELD)).min(axis=-1)
        reachable = _boundary(margin, axis)
        fading = np.where(margin >= 0.0, fading, _UNREACHED)
    codes += fading[..., None] * (grey - codes)
    return ColourPlane(np.rint(codes).astype(np.uint8), _boundary(inside, axis), reachable)


def is_reachable(box: ReachableBox, lab: tuple[float, float, float]) -> bool:
    """Return whether a colour lies in the box."""
    rho = lab_to_working(lab)
    return bool(np.all((rho >= np.array(box.low)) & (rho <= np.array(box.high))))


def hue_codes(count: int, space: DisplaySpace = SRGB_SPACE) -> Bytes:
    """Return codes (count, 3) of hues from 0° in equal steps, at one L* and C*, for a ring around a plane."""
    hues = np.arange(count) * 360.0 / count
    lch = np.stack((np.full(count, _RING_LIGHTNESS), np.full(count, _RING_CHROMA), hues), axis=-1)
    codes = 255.0 * space.encode(space.of_working(lab_to_working(lch_to_lab(lch))))
    return np.asarray(np.rint(codes).astype(np.uint8))


def reachable_box(fit: LobeFit, index: int) -> ReachableBox | None:
    """Return what the fit's kind of paint reaches at the reading ``index`` while the other ones stay.

    None where the reading has another light than the lobes are fitted with, or where no lobes meet the others.
    """
    rows = judged(fit)
    if index not in rows:
        return None
    columns, share = cone_of_lobes(fit)
    place = rows.index(index)
    others = np.arange(len(rows)) != place
    asked = lab_to_working([fit.readings[row].lab for row in rows])[others]
    reached = [_reach(columns, share, place, others, asked[:, channel]) for channel in range(3)]
    if any(ends is None for ends in reached):
        return None
    ends = np.array(reached)
    low, high = (tuple(float(value) for value in ends[:, side]) for side in range(2))
    return ReachableBox((low[0], low[1], low[2]), (high[0], high[1], high[2]))


def _reach(
    columns: Floats, share: Floats, place: int, others: npt.NDArray[np.bool_], asked: Floats
) -> tuple[float, float] | None:
    """The least and the greatest ρ of one channel at a reading, with the ``asked`` of the others held."""
    from scipy.optimize import linprog  # 0.2 s to import, and nothing on the edit path asks for it

    room = np.maximum(HELD * asked, _LEAST_HELD)
    # Lobes are of very different sizes: columns of one greatest value are solved better.
    scaled = columns / np.maximum(columns.max(axis=0), 1e-300)
    held = scaled[others]
    matrix = np.concatenate((held, -held))
    limits = np.concatenate((asked + room - share[others], share[others] - asked + room))
    ends: list[float] = []
    for sign in (1.0, -1.0):
        answer = linprog(sign * scaled[place], A_ub=matrix, b_ub=limits, bounds=(0.0, None), method="highs")
        if answer.status == 3:  # without a bound
            ends.append(math.inf)
        elif answer.fun is None:
            return None
        else:
            ends.append(float(share[place] + sign * answer.fun))
    return ends[0], ends[1]


def _boundary(inside: Floats, axis: Floats) -> Floats:
    """Return lines (n, 2, 2) along which ``inside`` (SIZE, SIZE), of rows from the greatest b* on, is 0."""
    # A cell's corners in turn: upper left, upper right, lower right, lower left, and the first again.
    corners = np.stack((inside[:-1, :-1], inside[:-1, 1:], inside[1:, 1:], inside[1:, :-1]), axis=-1)
    before, after = corners, np.roll(corners, -1, axis=-1)
    crossed = (before >= 0.0) != (after >= 0.0)
    row, column = np.nonzero(crossed.sum(axis=-1) >= 2)
    if not len(row):
        return np.zeros((0, 2, 2))
    step = axis[1] - axis[0]
    left_top = np.stack((axis[column], axis[::-1][row]), axis=-1)
    starts = step * np.array(((0.0, 0.0), (1.0, 0.0), (1.0, -1.0), (0.0, -1.0)))
    ways = step * np.array(((1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0)))
    first, second = before[row, column], after[row, column]
    share = first / np.where(first == second, 1.0, first - second)
    points = left_top[:, None] + starts + share[..., None] * ways
    # The edges that are crossed come first, in their order; of a saddle's four the first two pairs are joined.
    order = np.argsort(~crossed[row, column], axis=-1, kind="stable")
    points = np.take_along_axis(points, order[..., None], axis=1)
    saddle = crossed[row, column].sum(axis=-1) == 4
    return np.concatenate((points[:, :2], points[saddle, 2:]))
