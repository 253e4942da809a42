"""What both maps share: a point for each swatch that is shown, with its colour; and the lasso that selects points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_color_swatch.grid.model import VisibleRows

PLANES = ("flop", "ab", "gloss")
"""Flop over lightness, b* over a*, gloss over flop."""

_NO_FLOP = 1e-3
"""A flop index below it is rounding: one step of an instrument's reading makes more."""


@dataclass(frozen=True, eq=False)
class MapPoints:
    """Points of the swatches of a pane: ids (n), L*a*b* (n, 3) at 45°, flop and gloss (n,), sRGB codes (n, 3)."""

    ids: tuple[str, ...]
    names: tuple[str, ...]
    lab: np.ndarray
    flop: np.ndarray
    gloss: np.ndarray
    codes: np.ndarray

    @staticmethod
    def of(shown: VisibleRows) -> MapPoints:
        rows, places = shown.rows, np.asarray(shown.places, int)
        return MapPoints(
            tuple(rows.ids[place] for place in shown.places),
            tuple(rows.name(place) for place in shown.places),
            rows.lab[places, 1],
            rows.columns.flop[places],
            rows.columns.gloss[places],
            rows.codes[places, 1],
        )

    @property
    def are_flat(self) -> bool:
        """Whether there are points, and none of them has a flop."""
        return len(self) > 0 and not (np.abs(self.flop) > _NO_FLOP).any()

    def plane(self, which: str) -> np.ndarray:
        """Return x and y (n, 2) of a plane of :data:`PLANES`."""
        if which == "flop":
            return np.stack([self.lab[:, 0], self.flop], axis=1)
        if which == "ab":
            return self.lab[:, 1:]
        return np.stack([self.flop, self.gloss], axis=1)

    def __len__(self) -> int:
        return len(self.ids)


LEAST_PX = 6.0
"""A shorter way is a click."""
REACH_PX = 10.0
"""How far from a point a click finds it."""


def inside(points: npt.ArrayLike, polygon: npt.ArrayLike) -> npt.NDArray[np.bool_]:
    """Return which points (n, 2) lie inside a closed polygon (m, 2), by the even-odd rule; NaN lies nowhere.

    Crossings of a ray to the right are counted (Shimrat 1962), half open at the ends of each side, so that a
    vertex counts once.

    >>> inside([[0.5, 0.5], [2.0, 0.5]], [[0, 0], [1, 0], [1, 1], [0, 1]]).tolist()
    [True, False]
    """
    points, corners = np.asarray(points, float), np.asarray(polygon, float)
    found = np.zeros(len(points), bool)
    if len(corners) < 3:
        return found
    x, y = points[:, 0], points[:, 1]
    # A hand draws a few hundred corners: a pass over the points for each.
    for (x1, y1), (x2, y2) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        between = (y1 > y) != (y2 > y)
        # On which side of the line a point lies; without a division, which a flat side would make overflow.
        side = (y - y1) * (x2 - x1) - (x - x1) * (y2 - y1)
        found ^= between & ((side > 0.0) if y2 > y1 else (side < 0.0))
    return found


def nearest(points: npt.ArrayLike, at: tuple[float, float], depth: npt.ArrayLike | None = None) -> int | None:
    """Return which point (n, 2) in pixels a click at ``at`` means; ``None`` where none is within reach.

    Of several within a few pixels the one nearest to the eye is meant, where ``depth`` (n,) says which that is.
    """
    points = np.asarray(points, float)
    if not len(points):
        return None
    away = np.hypot(points[:, 0] - at[0], points[:, 1] - at[1])
    away = np.where(np.isfinite(away), away, np.inf)
    best = float(away.min())
    if best > REACH_PX:
        return None
    if depth is None:
        return int(away.argmin())
    close = np.flatnonzero(away <= best + 3.0)
    return int(close[np.argmin(np.asarray(depth, float)[close])])


class LassoLine:
    """The line while it is drawn, in pixels."""

    def __init__(self) -> None:
        self.points: list[tuple[float, float]] = []

    @property
    def is_drawn(self) -> bool:
        """Whether a line is being drawn."""
        return bool(self.points)

    @property
    def is_click(self) -> bool:
        """Whether the way is so short that a point is meant and no area."""
        first = np.asarray(self.points[0])
        return bool(np.hypot(*(np.asarray(self.points) - first).T).max() < LEAST_PX)

    def begin(self, x: float, y: float) -> None:
        self.points = [(x, y)]

    def extend(self, x: float, y: float) -> None:
        """Go on to a point; a step of less than a pixel is left out."""
        last = self.points[-1]
        if abs(x - last[0]) + abs(y - last[1]) >= 1.0:
            self.points.append((x, y))

    def end(self) -> None:
        """The line is closed, or given up."""
        self.points = []
