"""Bilinear densities on the unit square, one per incident direction, with forward and inverse warps.

A grid of (ny, nx) non-negative values stands at the nodes of the unit square, x along the last axis, and is
bilinear in between. There is one such grid for each node (φi, θi) of the incident directions; between nodes
the normalised grids are blended linearly. Each blend is again a density that integrates to 1, because every
grid does.

The map from the square to itself is the usual one by the two cumulative distributions: first y by the
marginal, then x by the conditional distribution at that y. In a cell both are quadratic, so both directions
have closed forms (Dupuy & Jakob 2018, "An adaptive parameterization for efficient material acquisition and
rendering", section 4 and its supplement).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats, Indices

Blend = Sequence[tuple[Indices, Floats]]
"""For each of n queries: which grids take part (flat index over φi and θi), and with what weight."""


def blend_weights(axes: Sequence[Floats], values: Sequence[Floats]) -> list[tuple[Indices, Floats]]:
    """Return the grids and weights of a multilinear blend over ``axes`` at ``values`` (n,) each.

    Beyond the first and last node the nearest node holds. An axis of one node does not interpolate.
    """
    n = len(values[0])
    blend: list[tuple[Indices, Floats]] = [(np.zeros(n, np.intp), np.ones(n))]
    for axis, value in zip(axes, values, strict=True):
        if len(axis) == 1:
            continue
        low = np.clip(np.searchsorted(axis, value, side="right") - 1, 0, len(axis) - 2)
        weight = np.clip((value - axis[low]) / (axis[low + 1] - axis[low]), 0.0, 1.0)
        blend = [
            (index * len(axis) + low + step, part * share)
            for index, part in blend
            for step, share in ((0, 1.0 - weight), (1, weight))
        ]
    return blend


def cells(count: int, position: Floats) -> tuple[Indices, Floats]:
    """Return the cell (n,) and the place 0…1 in it of ``position`` 0…1 along ``count`` nodes."""
    place = np.clip(position, 0.0, 1.0) * (count - 1)
    cell = np.minimum(place.astype(np.intp), count - 2)
    return cell, place - cell


def bilinear(grids: npt.NDArray[np.floating], u: Floats, blend: Blend) -> Floats:
    """Return (n,) the blended bilinear values of ``grids`` (g, ny, nx) at ``u`` (n, 2) = (x, y)."""
    ny, nx = grids.shape[-2:]
    column, x = cells(nx, u[:, 0])
    row, y = cells(ny, u[:, 1])
    flat = grids.reshape(-1)
    corner = row * nx + column
    total = np.zeros(len(u))
    for grid, weight in blend:
        at = grid * (ny * nx) + corner
        low = flat[at] * (1.0 - x) + flat[at + 1] * x
        high = flat[at + nx] * (1.0 - x) + flat[at + nx + 1] * x
        total += weight * (low * (1.0 - y) + high * y)
    return total


class GridDensity:
    """Normalised bilinear densities with their warps.

    Parameters
    ----------
    grids
        Non-negative values (..., ny, nx), the leading axes being those of the incident directions; each grid
        has a positive sum. ny, nx ≥ 2.
    """

    def __init__(self, grids: npt.NDArray[np.floating]) -> None:
        self.shape = grids.shape[-2:]
        ny, nx = self.shape
        values = grids.reshape(-1, ny, nx).astype(np.float64)
        conditional = np.cumsum(0.5 * (values[:, :, :-1] + values[:, :, 1:]), axis=2) / (nx - 1)
        rows = conditional[:, :, -1]
        marginal = np.cumsum(0.5 * (rows[:, :-1] + rows[:, 1:]), axis=1) / (ny - 1)
        scale = 1.0 / marginal[:, -1]
        self.values: Floats = values * scale[:, None, None]
        # With a leading 0, so that entry k is the distribution up to node k.
        self._conditional = np.zeros((len(values), ny, nx))
        self._conditional[:, :, 1:] = conditional * scale[:, None, None]
        self._marginal = np.zeros((len(values), ny))
        self._marginal[:, 1:] = marginal * scale[:, None]

    def density(self, u: Floats, blend: Blend) -> Floats:
        """Return (n,) the density at ``u`` (n, 2)."""
        return bilinear(self.values, u, blend)

    def _at(self, table: Floats, place: Indices, blend: Blend) -> Floats:
        size = table[0].size
        flat = table.reshape(-1)
        total = np.zeros(len(place))
        for grid, weight in blend:
            total += weight * flat[grid * size + place]
        return total

    def _between(self, table: Floats, place: Indices, y: Floats, blend: Blend) -> Floats:
        """Return a table (n,) at nodes ``place``, between their row and the next by ``y``."""
        return (1.0 - y) * self._at(table, place, blend) + y * self._at(table, place + self.shape[1], blend)

    def invert(self, u: Floats, blend: Blend) -> tuple[Floats, Floats]:
        """Return the point (n, 2) of the unit square that :meth:`sample` takes to ``u``, and the density."""
        ny, nx = self.shape
        column, x = cells(nx, u[:, 0])
        row, y = cells(ny, u[:, 1])
        corner = row * nx + column
        left, right = (self._between(self.values, corner + step, y, blend) for step in (0, 1))
        density = (1.0 - x) * left + x * right
        # Along x at this y: what lies in the columns before, and the part of this one.
        before = self._between(self._conditional, corner, y, blend)
        low = self._at(self._conditional, row * nx + nx - 1, blend)
        high = self._at(self._conditional, (row + 1) * nx + nx - 1, blend)
        whole = (1.0 - y) * low + y * high
        part = before + x * (left + 0.5 * x * (right - left)) / (nx - 1)
        out = np.empty_like(u)
        out[:, 0] = np.divide(part, whole, out=np.zeros_like(part), where=whole > 0.0)
        out[:, 1] = self._at(self._marginal, row, blend) + y * (low + 0.5 * y * (high - low)) / (ny - 1)
        return np.clip(out, 0.0, 1.0), density

    def sample(self, u: Floats, blend: Blend) -> tuple[Floats, Floats]:
        """Return the point (n, 2) distributed by the density for uniform ``u`` (n, 2), and the density there."""
        ny, nx = self.shape
        u = np.clip(u, 1e-12, 1.0 - 1e-12)
        row = _search(lambda middle: self._at(self._marginal, middle, blend) <= u[:, 1], ny, len(u))
        low = self._at(self._conditional, row * nx + nx - 1, blend)
        high = self._at(self._conditional, (row + 1) * nx + nx - 1, blend)
        y = _within((u[:, 1] - self._at(self._marginal, row, blend)) * (ny - 1), low, high)
        start = row * nx

        goal = u[:, 0] * ((1.0 - y) * low + y * high)
        column = _search(
            lambda middle: self._between(self._conditional, start + middle, y, blend) <= goal, nx, len(u)
        )
        at = start + column
        before = self._between(self._conditional, at, y, blend)
        left, right = (self._between(self.values, at + step, y, blend) for step in (0, 1))
        x = _within((goal - before) * (nx - 1), left, right)
        out = np.stack(((column + x) / (nx - 1), (row + y) / (ny - 1)), axis=1)
        return out, (1.0 - x) * left + x * right


def _search(is_below: Callable[[Indices], Bools], nodes: int, count: int) -> Indices:
    """Return the last cell (count,) of ``nodes`` - 1 whose first node is below the goal, by bisection."""
    lower, upper = np.zeros(count, np.intp), np.full(count, nodes - 1, np.intp)
    for _ in range(int(nodes).bit_length()):
        middle = (lower + upper) // 2
        below = is_below(middle)
        lower, upper = np.where(below, middle, lower), np.where(below, upper, middle)
    return np.minimum(lower, nodes - 2)


def _within(area: Floats, low: Floats, high: Floats) -> Floats:
    """Return x, 0…1, with ``low`` x + (``high`` - ``low``) x²/2 = ``area``; the root is in the stable form."""
    root = np.sqrt(np.maximum(low * low + 2.0 * area * (high - low), 0.0))
    below = low + root
    x = np.divide(2.0 * area, below, out=np.zeros_like(area), where=below > 0.0)
    return np.clip(x, 0.0, 1.0)
