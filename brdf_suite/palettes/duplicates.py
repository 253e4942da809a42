"""Paints of a palette that are alike: within a tolerance of ΔE00 at every angle.

Being alike does not carry over: A may be within the tolerance of B and B of C, and A not of C. A group holds all that
hang together by such steps, and says whether it is a chain, and how far its two farthest are apart.

Pairs are never stored: rows are compared block by block, those that hang together already are not compared again, and
what is in memory at once has a bound however many are alike.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats, Indices
from brdf_suite.errors import ValueRangeError
from brdf_suite.palettes.columns import Columns
from brdf_suite.palettes.search import lower_bound
from brdf_suite.progress import Progress, report, subrange

LARGEST_TOLERANCE = 20.0
_ROWS = 32
_WINDOW = 1024
"""So many rows are compared with so many at once: some ten megabytes."""
_MOST_MEASURED = 1000
_ROUNDING = 1e-9
_JOINED = 0.8
"""Share of the work that finding the groups is, for the progress."""
_WEIGHTS = np.array((1.0, 1.5 * np.sqrt(1.0 + np.sqrt(0.75)), np.sqrt(1.0 + np.sqrt(0.75))))
"""L*, a* and b* times these: their distance is never below ΔE00.

S_L, S_C and S_H are never below 1, a' never above 1.5 a*, and the rotation adds at most sin 60° of chroma and hue.
"""


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
    roots = _roots(rows, tolerance, subrange(progress, 0.0, _JOINED))
    # Each group's entries together, by its root, in the palette's order.
    of_place = roots[row_of]
    members = np.split(places[np.argsort(of_place, kind="stable")], _steps(np.sort(of_place)))
    own_rows = np.split(np.argsort(roots, kind="stable"), _steps(np.sort(roots)))
    found, rest, done = [], subrange(progress, _JOINED, 1.0), 0
    for group, own in zip(members, own_rows, strict=True):
        if len(group) > 1:
            low, high = done / len(rows), (done + len(own)) / len(rows)
            widest, chained = _spread(rows[own], tolerance, subrange(rest, low, high))
            found.append(DuplicateGroup(tuple(group.tolist()), widest, chained))
        done += len(own)
    report(progress, 1.0, "compared")
    return tuple(sorted(found, key=lambda group: group.indices))


def _steps(values: Indices) -> Indices:
    """Where a sorted array goes on to another value."""
    return np.flatnonzero(np.diff(values)) + 1


def _roots(rows: Floats, tolerance: float, progress: Progress | None) -> Indices:
    """For each row (n, k, 3), sorted by the first L*, the first of those that it hangs together with."""
    lightness = rows[:, 0, 0]
    # S_L is largest where L* is farthest from 50.
    far = max(abs(float(lightness[0]) - 50.0), abs(float(lightness[-1]) - 50.0))
    reach = tolerance * (1.0 + 0.015 * far) + _ROUNDING
    ends = np.searchsorted(lightness, lightness + reach, side="right")
    roots = np.arange(len(rows))
    for start in range(0, len(rows), _ROWS):
        stop = min(start + _ROWS, len(rows))
        end = int(ends[stop - 1])
        for left in range(start, end, _WINDOW):
            report(progress, start / len(rows), f"comparing {start:,} of {len(rows):,}")
            right = min(left + _WINDOW, end)
            # Most pairs of a thick place hang together already, by its first few.
            wanted = roots[start:stop, None] != roots[left:right]
            if wanted.any():
                bound = lower_bound(rows[start:stop, None], rows[None, left:right]).max(axis=-1)
                wanted &= bound <= tolerance * (1.0 + _ROUNDING) + _ROUNDING
                one, other = np.nonzero(wanted)
                one, other = one + start, other + left
                later = other > one
                one, other = one[later], other[later]
                alike = _difference(rows[one], rows[other]) <= tolerance
                roots = _joined(roots, one[alike], other[alike])
    return roots


def _difference(one: Floats, other: Floats) -> Floats:
    """The largest ΔE00 (n,) of pairs (n, k, 3) at any angle."""
    return np.asarray(delta_e_2000(one, other).max(axis=-1))


def _joined(roots: Indices, one: Indices, other: Indices) -> Indices:
    """Return the roots after the rows of these pairs were put together."""
    if len(one) == 0:
        return roots
    from scipy.sparse import coo_array, csgraph  # for this alone: 0.5 s at the start of Color Swatch

    known, at = np.unique(np.concatenate((roots[one], roots[other])), return_inverse=True)
    first, second = at.reshape(2, -1)
    edges = coo_array((np.ones(len(first), np.int8), (first, second)), shape=(len(known), len(known)))
    count, part_of = csgraph.connected_components(edges, directed=False)
    least = np.full(count, len(roots), np.intp)
    np.minimum.at(least, part_of, known)
    now = np.arange(len(roots))
    now[known] = least[part_of]
    return now[roots]


def _spread(rows: Floats, tolerance: float, progress: Progress | None) -> tuple[float, bool]:
    """Return the largest difference of rows that hang together, NaN for many, and whether it is over the tolerance."""
    report(progress, 0.0, "measuring groups")
    if len(rows) <= _MOST_MEASURED:
        # One row with those behind it: the same pairs, in the same order, as were compared.
        widest = max(
            (float(_difference(row, rows[i + 1 :]).max()) for i, row in enumerate(rows[:-1])), default=0.0
        )
        return widest, widest > tolerance
    # Two that are far apart are mostly found among those at the ends of some axis.
    flat = rows.reshape(len(rows), -1)
    for end in np.unique(np.concatenate((flat.argmin(axis=0), flat.argmax(axis=0)))).tolist():
        if (_difference(rows[end], rows) > tolerance).any():
            return float("nan"), True
    # Here they are most likely all within it; the plain distance shows that of nearly all pairs.
    weighted = rows * _WEIGHTS
    for i in range(len(rows) - 1):
        report(progress, i / len(rows), f"measuring a group, {i:,} of {len(rows):,}")
        steps = weighted[i + 1 :] - weighted[i]
        bound = np.sqrt(np.einsum("ijk,ijk->ij", steps, steps).max(axis=-1))
        left = np.flatnonzero(bound > tolerance * (1.0 - _ROUNDING)) + i + 1
        if len(left) and (_difference(rows[i], rows[left]) > tolerance).any():
            return float("nan"), True
    return float("nan"), False
