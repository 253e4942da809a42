"""Compiled resampling from a fine grid on the sphere to cube map texels: the sums of
:mod:`brdf_suite.lighting.filter.ring_to_cube`.

Imported by :mod:`brdf_suite.lighting.filter.kernels.compilation` alone. The grid has M rings at θ = (i+½)π/M and P
columns at φ = 2πi/P, P a multiple of 4, and has had the interpolating kernel divided out. The cube's symmetry makes
eight texels of one point: four quarter turns, each with its mirror image. They have the same weights, and their 24
values (eight texels, three channels) lie side by side, so that each product is done for all of them in the machine's
vectors.

The grid is never whole: it comes in bands of rings, one north of the equator and its mirror image south of it, and a
band fills the texels whose first ring is among its own. So a large map needs no memory for its grid.

The convolution is over here, and texels are float32: so are the folded rings and these sums. Positions and the
kernel's weights are still found in float64.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.compilation import Array, compiled

_LANES = 24
MARGIN = 5
"""Columns that a folded ring holds beyond the eighth of a turn, on either side."""

# The faces whose centres lie at φ = 0, 90°, 180° and 270°: +Z, -X, -Z, +X.
_SIDES = (4, 1, 5, 0)


@compiled
def _taps(position: float, table: Array, weights: Array) -> int:
    """Fill the kernel's eight weights around a position in grid steps; return the first one's grid index."""
    first = math.ceil(position - 4.0)
    z = 2.0 * (position - first - 3.0) - 1.0
    for t in range(8):
        value = table[0, t]
        for power in range(1, 13):
            value = value * z + table[power, t]
        weights[t] = value
    return first


@compiled
def _along(weights: Array, source: Array, at: int, target: Array, to: int) -> None:
    """Set target[to : to + 24] to the weighted sum of eight rows of 24 of source (n,), the first at ``at``.

    Flat arrays and unsigned places: with rows cut out of arrays, and places that may be negative, it takes 28 ns
    instead of 8.
    """
    w_0, w_1, w_2, w_3 = weights[0], weights[1], weights[2], weights[3]
    w_4, w_5, w_6, w_7 = weights[4], weights[5], weights[6], weights[7]
    first, goal = np.uint64(at), np.uint64(to)
    for lane in range(_LANES):
        q = np.uint64(lane)
        p = first + q
        target[goal + q] = (
            w_0 * source[p]
            + w_1 * source[p + np.uint64(24)]
            + w_2 * source[p + np.uint64(48)]
            + w_3 * source[p + np.uint64(72)]
            + w_4 * source[p + np.uint64(96)]
            + w_5 * source[p + np.uint64(120)]
            + w_6 * source[p + np.uint64(144)]
            + w_7 * source[p + np.uint64(168)]
        )


@compiled
def fold_ring(values: Array, shift: int, target: Array) -> None:
    """Lay a ring (3, P) side by side for the eight turned and mirrored points: target (P//8 + 2·MARGIN + 1, 24).

    ``shift`` is in quarter turns: 2 for a ring that lies beyond the pole.
    """
    period = values.shape[1]
    count = target.shape[0]
    for begin in range(
        0, count, 32
    ):  # few rows of the target at a time, so that they stay in the nearest cache
        end = min(begin + 32, count)
        for c in range(3):
            for turn in range(4):
                for side in range(2):
                    step = 1 - 2 * side
                    lane = 8 * c + 2 * turn + side
                    place = ((turn + shift) * (period // 4) + step * (begin - MARGIN)) % period
                    for p in range(begin, end):
                        target[p, lane] = values[c, place]
                        place += step  # round the ring without a division for each value
                        if place == period:
                            place = 0
                        elif place < 0:
                            place = period - 1


@compiled
def _side_ring(s: float, j: int, size: int, rings: int) -> float:
    """Return where a texel of a side face lies between the rings: column at s, row j."""
    t = 1.0 - (2.0 * j + 1.0) / size
    return (0.5 * math.pi - math.atan(t / math.sqrt(1.0 + s * s))) * rings / math.pi - 0.5


@compiled
def _polar_ring(p: float, inner: int, size: int, rings: int) -> float:
    """Return where a texel of the upper face lies between the rings: p and q from its middle."""
    q = (2.0 * inner + 1.0) / size
    return math.atan(math.sqrt(p * p + q * q)) * rings / math.pi - 0.5


@compiled
def _side_first(s: float, first: int, size: int, rings: int) -> int:
    """Return the first row 0 … size/2 of a column at s whose texel's eight rings begin at ``first`` or after."""
    theta = (first + 3.5) * math.pi / rings
    t = math.tan(min(max(0.5 * math.pi - theta, 0.0), 1.5)) * math.sqrt(1.0 + s * s)
    half = size // 2
    j = int(min(max(0.5 * size * (1.0 - t) - 0.5, 0.0), float(half)))
    while j > 0 and math.ceil(_side_ring(s, j - 1, size, rings) - 4.0) >= first:
        j -= 1
    while j < half and math.ceil(_side_ring(s, j, size, rings) - 4.0) < first:
        j += 1
    return j


@compiled
def _polar_first(p: float, outer: int, first: int, size: int, rings: int) -> int:
    """Return the first of the texels 0 … outer + 1 in a line at p whose eight rings begin at ``first`` or after."""
    tangent = math.tan(min(max((first + 3.5) * math.pi / rings, 0.0), 1.5))
    q = math.sqrt(max(tangent * tangent - p * p, 0.0))
    inner = int(min(max(0.5 * (q * size - 1.0), 0.0), float(outer + 1)))
    while inner > 0 and math.ceil(_polar_ring(p, inner - 1, size, rings) - 4.0) >= first:
        inner -= 1
    while inner <= outer and math.ceil(_polar_ring(p, inner, size, rings) - 4.0) < first:
        inner += 1
    return inner


@compiled
def side_band(
    north: Array, south: Array, first: int, end: int, rings: int, period: int, table: Array, faces: Array
) -> None:
    """Fill the texels of the four side faces whose eight rings begin at ``first`` … ``end - 1``, and their mirrors.

    Parameters
    ----------
    north, south
        (≥ end - first + 7, columns, 24) folded rings: ``first`` and the next ones, and their mirror images.
    rings, period
        M and P of the grid.
    table
        (13, 8) the polynomials of the interpolating kernel.
    faces
        (6, F, F, 3) float32, F even.
    """
    size = faces.shape[1]
    half = size // 2
    width = north.shape[1]
    flat_north, flat_south = north.reshape(north.size), south.reshape(south.size)
    across = np.empty(8, dtype=np.float32)
    down = np.empty(8, dtype=np.float32)
    upper = np.empty(north.shape[0] * _LANES, dtype=np.float32)
    lower = np.empty(north.shape[0] * _LANES, dtype=np.float32)
    above = np.empty(_LANES, dtype=np.float32)
    below = np.empty(_LANES, dtype=np.float32)
    for i in range(half):
        s = (2.0 * i + 1.0) / size
        begin = _side_first(s, first, size, rings)
        stop = _side_first(s, end, size, rings)
        if begin >= stop:
            continue
        column = _taps(math.atan(s) * period / (2.0 * math.pi), table, across) + MARGIN
        lowest = math.ceil(_side_ring(s, begin, size, rings) - 4.0) - first
        highest = math.ceil(_side_ring(s, stop - 1, size, rings) - 4.0) - first
        for ring in range(lowest, highest + 8):
            at = (ring * width + column) * _LANES
            _along(across, flat_north, at, upper, ring * _LANES)
            _along(across, flat_south, at, lower, ring * _LANES)
        for j in range(begin, stop):
            ring = _taps(_side_ring(s, j, size, rings), table, down) - first
            _along(down, upper, ring * _LANES, above, 0)
            _along(down, lower, ring * _LANES, below, 0)
            for turn in range(4):
                face = _SIDES[turn]
                for c in range(3):
                    # φ = φ_f - atan(s): what is mirrored, φ < φ_f, lies right of the middle.
                    lane = 8 * c + 2 * turn
                    faces[face, j, half - 1 - i, c] = above[lane]
                    faces[face, j, half + i, c] = above[lane + 1]
                    faces[face, size - 1 - j, half - 1 - i, c] = below[lane]
                    faces[face, size - 1 - j, half + i, c] = below[lane + 1]


@compiled
def polar_band(
    north: Array, south: Array, first: int, end: int, rings: int, period: int, table: Array, faces: Array
) -> None:
    """Fill the texels of +Y and -Y whose eight rings begin at ``first`` … ``end - 1``; all as for :func:`side_band`.

    An octant of each face is found, with its seven images.
    """
    size = faces.shape[1]
    half = size // 2
    width = north.shape[1]
    flat_north, flat_south = north.reshape(north.size), south.reshape(south.size)
    across = np.empty(8, dtype=np.float32)
    along = np.empty(8, dtype=np.float32)
    upper = np.empty(8 * _LANES, dtype=np.float32)
    lower = np.empty(8 * _LANES, dtype=np.float32)
    above = np.empty(_LANES, dtype=np.float32)
    below = np.empty(_LANES, dtype=np.float32)
    for outer in range(half):
        p = (2.0 * outer + 1.0) / size
        begin = _polar_first(p, outer, first, size, rings)
        stop = _polar_first(p, outer, end, size, rings)
        for inner in range(begin, stop):
            q = (2.0 * inner + 1.0) / size
            ring = _taps(_polar_ring(p, inner, size, rings), table, along) - first
            column = _taps(math.atan(q / p) * period / (2.0 * math.pi), table, across) + MARGIN
            for t in range(8):
                at = ((ring + t) * width + column) * _LANES
                _along(across, flat_north, at, upper, t * _LANES)
                _along(across, flat_south, at, lower, t * _LANES)
            _along(along, upper, 0, above, 0)
            _along(along, lower, 0, below, 0)
            for turn in range(4):
                for side in range(2):
                    # x = -sinθ sinφ and z = sinθ cosφ, in half texels; a quarter turn takes (x, z) to (-z, x).
                    x = (2 * inner + 1) * (2 * side - 1)
                    z = 2 * outer + 1
                    for _ in range(turn):
                        x, z = -z, x
                    i = (x + size - 1) // 2
                    j = (z + size - 1) // 2
                    for c in range(3):
                        lane = 8 * c + 2 * turn + side
                        faces[2, j, i, c] = above[lane]
                        faces[3, size - 1 - j, i, c] = below[lane]
