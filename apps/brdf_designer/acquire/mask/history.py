"""The mask being corrected: strokes of a brush, each one step of undo and redo.

A step keeps only the rectangle that it changed, packed to bits: a hundred strokes over a megapixel take some megabytes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Bools

MOST_STEPS = 200


@dataclass(frozen=True, eq=False)
class _Step:
    """What a rectangle was before and after a stroke."""

    rows: slice
    columns: slice
    before: NDArray[np.uint8]
    after: NDArray[np.uint8]


class MaskHistory:
    """A mask, true where pixels are used, and its steps."""

    def __init__(self, used: Bools) -> None:
        self.used: Bools = np.array(used, dtype=bool)
        """The mask as it is now (rows, columns); not to be written to."""
        self._undo: list[_Step] = []
        self._redo: list[_Step] = []
        self._stroke: Bools | None = None
        self._box: tuple[int, int, int, int] | None = None

    @property
    def can_undo(self) -> bool:
        """Whether there is a step to take back."""
        return bool(self._undo)

    @property
    def can_redo(self) -> bool:
        """Whether a step was taken back."""
        return bool(self._redo)

    @property
    def share(self) -> float:
        """The share of pixels that are used."""
        return float(self.used.mean()) if self.used.size else 0.0

    def begin(self) -> None:
        """Begin a stroke."""
        self.end()
        self._stroke = self.used.copy()
        self._box = None

    def dab(self, start: tuple[float, float], end: tuple[float, float], radius: float, *, use: bool) -> bool:
        """Paint from one place to another (x, y in pixels) with a round brush; True where anything changed.

        Part of the stroke that was begun; without one it is a stroke of its own.
        """
        alone = self._stroke is None
        if alone:
            self.begin()
        found = self._paint(start, end, max(radius, 0.5), use)
        if alone:
            self.end()
        return found

    def end(self) -> bool:
        """End the stroke; True where it is a step."""
        before, box = self._stroke, self._box
        self._stroke, self._box = None, None
        if before is None or box is None:
            return False
        return self._push(slice(*box[:2]), slice(*box[2:]), before)

    def put(self, used: Bools) -> bool:
        """Put another mask of the same size in its place, as one step."""
        self.end()
        before = self.used.copy()
        self.used[:] = used
        return self._push(slice(0, before.shape[0]), slice(0, before.shape[1]), before)

    def undo(self) -> bool:
        """Take the newest step back."""
        return self._move(self._undo, self._redo, after=False)

    def redo(self) -> bool:
        """Do again what was taken back last."""
        return self._move(self._redo, self._undo, after=True)

    def _paint(self, start: tuple[float, float], end: tuple[float, float], radius: float, use: bool) -> bool:
        rows, columns = self.used.shape
        left, right = sorted((start[0], end[0]))
        top, bottom = sorted((start[1], end[1]))
        first_row, last_row = max(0, int(top - radius)), min(rows, int(np.ceil(bottom + radius)) + 1)
        first, last = max(0, int(left - radius)), min(columns, int(np.ceil(right + radius)) + 1)
        if first_row >= last_row or first >= last:
            return False
        y, x = np.mgrid[first_row:last_row, first:last] + 0.5
        along = np.subtract(end, start)
        length = float(along @ along)
        share = np.clip(((x - start[0]) * along[0] + (y - start[1]) * along[1]) / (length or 1.0), 0.0, 1.0)
        away = (x - start[0] - share * along[0]) ** 2 + (y - start[1] - share * along[1]) ** 2
        part = self.used[first_row:last_row, first:last]
        hit = (away <= radius * radius) & (part != use)
        if not hit.any():
            return False
        part[hit] = use
        top, foot, left, right = self._box or (first_row, last_row, first, last)
        self._box = (min(top, first_row), max(foot, last_row), min(left, first), max(right, last))
        return True

    def _push(self, rows: slice, columns: slice, before: Bools) -> bool:
        old, new = before[rows, columns], self.used[rows, columns]
        if np.array_equal(old, new):
            return False
        self._undo = [*self._undo, _Step(rows, columns, np.packbits(old), np.packbits(new))][-MOST_STEPS:]
        self._redo.clear()
        return True

    def _move(self, source: list[_Step], target: list[_Step], *, after: bool) -> bool:
        self.end()
        if not source:
            return False
        step = source.pop()
        part = self.used[step.rows, step.columns]
        bits = step.after if after else step.before
        part[:] = np.unpackbits(bits, count=part.size).astype(bool).reshape(part.shape)
        target.append(step)
        return True
