"""Median cut: recursive division of the map into halves of equal light, and its relaxation.


Debevec, "A Median Cut Algorithm for Light Probe Sampling", SIGGRAPH 2005 Posters. There all regions are cut in
every round, which gives powers of two; here the brightest region is cut next, which gives any number and
isolates a sun sooner. The axis is the longer one, a column's width taken at the region's middle row.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Indices
from brdf_suite.lighting.lights.cells import Cells

_NEXT_TO_NOTHING = 1e-12


@dataclass(frozen=True)
class _Region:
    top: int
    bottom: int
    left: int
    right: int


class _Sums:
    """Sums over any rectangle of cells, from a table of running sums."""

    def __init__(self, values: Floats) -> None:
        self._table = np.zeros((values.shape[0] + 1, values.shape[1] + 1))
        np.cumsum(np.cumsum(values, axis=0), axis=1, out=self._table[1:, 1:])

    def over(self, region: _Region) -> float:
        return float(self._between(region.top, region.bottom, region.left, region.right))

    def along_columns(self, region: _Region) -> Floats:
        """Return the sums left of each edge between the region's columns, (columns - 1,)."""
        return self._between(region.top, region.bottom, region.left, slice(region.left + 1, region.right))

    def along_rows(self, region: _Region) -> Floats:
        """Return the sums above each edge between the region's rows, (rows - 1,)."""
        inner = slice(region.top + 1, region.bottom)
        strip = self._table[inner, region.right] - self._table[inner, region.left]
        return np.asarray(
            strip - (self._table[region.top, region.right] - self._table[region.top, region.left])
        )

    def _between(self, top: int, bottom: int, left: int, right: int | slice) -> Floats:
        table = self._table
        strip = table[bottom, right] - table[top, right]
        return np.asarray(strip - (table[bottom, left] - table[top, left]))


def median_cut(cells: Cells, count: int) -> NDArray[np.intp]:
    """Return for each cell (h, w) which of ``count`` regions it belongs to; fewer where there are fewer cells."""
    rows, columns = cells.shape
    light = _Sums(cells.luminous)
    area = _Sums(cells.areas())
    least = _NEXT_TO_NOTHING * max(float(cells.luminous.sum()), 0.0)
    whole = _Region(0, rows, 0, columns)
    # The heap gives the smallest first: light, then size where there is no light, then the order of making.
    heap: list[tuple[float, float, int, _Region]] = []
    done: list[_Region] = []
    made = 0

    def put(region: _Region) -> None:
        nonlocal made
        made += 1
        if region.bottom - region.top == region.right - region.left == 1:
            done.append(region)
        else:
            bright = light.over(region)
            heapq.heappush(heap, (-bright if bright > least else 0.0, -area.over(region), made, region))

    put(whole)
    while heap and len(heap) + len(done) < count:
        dark, _, _, region = heapq.heappop(heap)
        for half in _cut(region, area if dark == 0.0 else light, cells.theta, float(cells.widths[0])):
            put(half)
    labels = np.empty((rows, columns), dtype=np.intp)
    for index, region in enumerate([*done, *(item[3] for item in heap)]):
        labels[region.top : region.bottom, region.left : region.right] = index
    return labels


def _cut(region: _Region, sums: _Sums, theta: Floats, width: float) -> tuple[_Region, _Region]:
    """Cut a region of two or more cells across its longer axis where the sums come closest to one half."""
    across = region.bottom - region.top
    along = region.right - region.left
    high = float(theta[region.bottom] - theta[region.top])
    wide = along * width * float(np.sin(0.5 * (theta[region.bottom] + theta[region.top])))
    half = 0.5 * sums.over(region)
    if along > 1 and (wide >= high or across == 1):
        at = region.left + 1 + int(np.argmin(np.abs(sums.along_columns(region) - half)))
        return replace(region, right=at), replace(region, left=at)
    at = region.top + 1 + int(np.argmin(np.abs(sums.along_rows(region) - half)))
    return replace(region, bottom=at), replace(region, top=at)


_COLUMNS = 512  # larger maps are joined: strata of a degree need no finer edges
_STEPS = 10  # error against steps: docs/method/lights.md
_DARK = 1e-9  # weight of a black cell against the same area of mean light


def relaxed_strata(cells: Cells, count: int) -> Indices:
    """Return for each cell (h, w) which of ``count`` strata it belongs to; fewer where there are fewer cells.

    Relaxed median cut: each light moves to its cell's centroid, each texel joins the nearest light. The weighted
    relaxation of Kollig and Keller, "Efficient Illumination by High Dynamic Range Images", EGWR 2003 (Lloyd's, with
    luminance as weight), started from a median cut instead of from a few points that are split. What it lowers is
    ``Σ Y·|ω - ω_light|²``, the leading term of the error of everything that varies smoothly with direction. A light
    that lost all its cells takes one side of the brightest stratum, as theirs splits the brightest.
    """
    from scipy.spatial import cKDTree

    step = max(1, -(-cells.shape[1] // _COLUMNS))
    # A small map keeps its cells: joined ones could be fewer than the lights.
    coarse = cells.joined(step) if step > 1 else cells
    labels: Indices = median_cut(coarse, count).ravel()
    number = int(labels.max()) + 1
    areas = coarse.areas().ravel()
    weights = coarse.luminous.ravel() + _DARK * areas * max(float(coarse.luminous.sum()), 1.0) / areas.sum()
    towards = coarse.moments.reshape(-1, 3)
    lengths = np.linalg.norm(towards, axis=1, keepdims=True)
    towards = np.where(lengths > 0.0, towards / np.maximum(lengths, 1e-300), coarse.centres().reshape(-1, 3))
    for _ in range(_STEPS):
        light = np.bincount(labels, weights, number)
        sums = [np.bincount(labels, weights * towards[:, k], number) for k in range(3)]
        middles: Floats = np.stack(sums, axis=1) / light[:, None]
        # Not brought to length 1: where light comes from all around, no direction is right, and the middle is.
        moved = np.asarray(cKDTree(middles).query(towards, workers=-1)[1], dtype=np.intp)
        _fill_empty(moved, number, weights, towards)
        if np.array_equal(moved, labels):
            break
        labels = moved
    rows, columns = cells.shape
    wide = labels.reshape(coarse.shape)
    return np.repeat(np.repeat(wide, step, axis=0)[:rows], step, axis=1)[:, :columns]


def _fill_empty(labels: Indices, number: int, weights: Floats, towards: Floats) -> None:
    """Give each of ``number`` labels at least one cell, in place."""
    held = np.bincount(labels, minlength=number)
    for empty in np.flatnonzero(held == 0):
        light = np.bincount(labels, weights, number)
        brightest = int(np.argmax(np.where(held > 1, light, -1.0)))
        mine = np.flatnonzero(labels == brightest)
        offset = towards[mine] - np.average(towards[mine], axis=0, weights=weights[mine])
        axis = np.linalg.eigh((offset * weights[mine, None]).T @ offset)[1][:, -1]
        along = offset @ axis
        side = along > 0.0
        if side.all() or not side.any():
            side = np.arange(len(mine)) == int(np.argmax(along))
        labels[mine[side]] = empty
        held = np.bincount(labels, minlength=number)
