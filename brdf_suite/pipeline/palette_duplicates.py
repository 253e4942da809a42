"""Paints of a palette that are alike: within a tolerance of ΔE00 at every angle.

Being alike does not carry over: A may be within the tolerance of B and B of C, and A not of C. A group holds all that
hang together by such steps, and says whether it is a chain, and how far its two farthest are apart.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.difference import delta_e_2000
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import Floats
from brdf_suite.pipeline.palette_columns import Columns
from brdf_suite.pipeline.palette_search import lower_bound
from brdf_suite.progress import Progress, report

LARGEST_TOLERANCE = 20.0
_ROWS = 256
_MOST_MEASURED = 1000
_ROUNDING = 1e-9


@dataclass(frozen=True)
class DuplicateGroup:
    """Entries that hang together: their places in the palette's order.

    ``widest`` is the largest ΔE00 at any angle between two of them (NaN where the group is too large to say), and
    ``chained`` whether some two of them are farther apart than the tolerance.
    """

    indices: tuple[int, ...]
    widest: float
    chained: bool


def duplicates(
    columns: Columns, tolerance: float = 1.0, progress: Progress | None = None
) -> tuple[DuplicateGroup, ...]:
    """Return the groups of alike entries, by their first; entries that are not known at an angle are in none.

    Raises
    ------
    ValueRangeError
        The tolerance is not a number from 0 to 20.
    Cancelled
        The progress callback asked for it.
    """
    if not 0.0 <= tolerance <= LARGEST_TOLERANCE:
        raise ValueRangeError("tolerance", f"0 to {LARGEST_TOLERANCE:g} ΔE00 is wanted, not {tolerance:g}")
    places = np.flatnonzero(np.isfinite(columns.lab).all(axis=(1, 2)))
    if len(places) == 0:
        return ()
    labs = columns.lab[places].reshape(len(places), -1)
    # Copies of one paint are one row: nothing is compared with itself a thousand times.
    rows, row_of = np.unique(labs, axis=0, return_inverse=True)
    row_of = row_of.reshape(-1)
    order = np.argsort(rows[:, 0], kind="stable")
    rank = np.empty(len(order), np.intp)
    rank[order] = np.arange(len(order))
    rows, row_of = rows[order].reshape(len(order), -1, 3), rank[row_of]
    parents = np.arange(len(rows))
    pairs = list(_pairs(rows, tolerance, progress))
    for one, other in pairs:
        for first, second in zip(one.tolist(), other.tolist(), strict=True):
            _join(parents, first, second)
    roots = np.array([_root(parents, row) for row in range(len(rows))], np.intp)
    edges = np.zeros(len(rows), np.intp)
    for one, _ in pairs:
        np.add.at(edges, roots[one], 1)
    members: dict[int, list[int]] = {}
    for place, root in zip(places.tolist(), roots[row_of].tolist(), strict=True):
        members.setdefault(root, []).append(place)
    report(progress, 1.0, "compared")
    found = []
    for root, group in members.items():
        if len(group) > 1:
            own = np.flatnonzero(roots == root)
            chained = int(edges[root]) < len(own) * (len(own) - 1) // 2
            found.append(DuplicateGroup(tuple(group), _widest(rows[own]), chained))
    return tuple(sorted(found, key=lambda group: group.indices))


def _pairs(
    rows: Floats, tolerance: float, progress: Progress | None
) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp]]]:
    """Yield pairs of rows (n, k, 3), sorted by their first L*, that are within the tolerance at every angle."""
    lightness = rows[:, 0, 0]
    # S_L is largest where L* is farthest from 50.
    far = max(
        (abs(float(value) - 50.0) for value in (lightness[:1].min(initial=50.0), *lightness[-1:])),
        default=0.0,
    )
    reach = tolerance * (1.0 + 0.015 * far) + _ROUNDING
    ends = np.searchsorted(lightness, lightness + reach, side="right")
    for start in range(0, len(rows), _ROWS):
        report(progress, start / len(rows), f"comparing {start:,} of {len(rows):,}")
        block = rows[start : start + _ROWS]
        window = rows[start : int(ends[min(start + _ROWS, len(rows)) - 1])]
        bound = lower_bound(block[:, None], window[None]).max(axis=-1)
        one, other = np.nonzero(bound <= tolerance * (1.0 + _ROUNDING) + _ROUNDING)
        later = other > one
        one, other = one[later], other[later]
        exact = delta_e_2000(block[one], window[other]).max(axis=-1)
        alike = exact <= tolerance
        yield start + one[alike], start + other[alike]


def _root(parents: NDArray[np.intp], row: int) -> int:
    while parents[row] != row:
        parents[row] = parents[parents[row]]
        row = int(parents[row])
    return row


def _join(parents: NDArray[np.intp], one: int, other: int) -> None:
    first, second = _root(parents, one), _root(parents, other)
    if first != second:
        parents[max(first, second)] = min(first, second)


def _widest(rows: Floats) -> float:
    if len(rows) > _MOST_MEASURED:
        return float("nan")
    return max((float(delta_e_2000(row, rows).max()) for row in rows), default=0.0)
