"""What both maps show: a point for each swatch that is shown, with its colour; which are selected."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_color_swatch.grid.model import VisibleRows
from brdf_color_swatch.grid.rows import Rows

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
        """Return the points of what a pane shows."""
        rows: Rows = shown.rows
        places = np.asarray(shown.places, int)
        ids = rows.ids
        return MapPoints(
            tuple(ids[place] for place in shown.places),
            tuple(rows.name(place) for place in shown.places),
            rows.lab[places, 1] if len(places) else np.zeros((0, 3)),
            rows.flop[places] if len(places) else np.zeros(0),
            rows.gloss[places] if len(places) else np.zeros(0),
            rows.codes[places, 1] if len(places) else np.zeros((0, 3), np.uint8),
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
        """Return the number of points."""
        return len(self.ids)
