"""Median cut: recursive division of the map into halves of equal light.

Debevec, "A Median Cut Algorithm for Light Probe Sampling", SIGGRAPH 2005 Posters. There all regions are cut in
every round, which gives powers of two; here the brightest region is cut next, which gives any number and
isolates a sun sooner. The axis is the longer one, a column's width taken at the region's middle row.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.lighting.lights.cells import Cells

_NEXT_TO_NOTHING = 1e-12


@dataclass(frozen=True)
class _Region:
    top: int
    bottom: int
    left: int
    right: int

    @property
    def cells(self) -> int:
        return (self.bottom - self.top) * (self.right - self.left)


class _Sums:
    """Sums over any rectangle of cells, from a table of running sums."""

    def __init__(self, values: Floats) -> None:
        self._table = np.zeros((values.shape[0] + 1, values.shape[1] + 1))
        np.cumsum(np.cumsum(values, axis=0), axis=1, out=self._table[1:, 1:])

    def over(self, region: _Region) -> float:
        table = self._table
        below = table[region.bottom, region.right] - table[region.bottom, region.left]
        return float(below - (table[region.top, region.right] - table[region.top, region.left]))

    def along_columns(self, region: _Region) -> Floats:
        """Return the sums left of each edge between the region's columns, (columns - 1,)."""
        inner = slice(region.left + 1, region.right)
        strip = self._table[region.bottom, inner] - self._table[region.top, inner]
        return np.asarray(
            strip - (self._table[region.bottom, region.left] - self._table[region.top, region.left])
        )

    def along_rows(self, region: _Region) -> Floats:
        """Return the sums above each edge between the region's rows, (rows - 1,)."""
        inner = slice(region.top + 1, region.bottom)
        strip = self._table[inner, region.right] - self._table[inner, region.left]
        return np.asarray(
            strip - (self._table[region.top, region.right] - self._table[region.top, region.left])
        )


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
        if region.cells == 1:
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
        return (
            _Region(region.top, region.bottom, region.left, at),
            _Region(region.top, region.bottom, at, region.right),
        )
    at = region.top + 1 + int(np.argmin(np.abs(sums.along_rows(region) - half)))
    return _Region(region.top, at, region.left, region.right), _Region(
        at, region.bottom, region.left, region.right
    )
