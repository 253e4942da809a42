"""From a fine grid on the sphere to the texels of a cube map, compiled: the sums of :mod:`.ring_to_cube`.

Imported by :mod:`.compiled` alone. The grid has M rings at θ = (i+½)π/M and P columns at φ = 2πi/P, P a
multiple of 4, and has had the interpolating kernel divided out. The cube's symmetry makes eight texels of one
point: four quarter turns, each with its mirror image. They have the same weights, and their 24 values (eight
texels, three channels) lie side by side, so that each product is done for all of them in the machine's vectors.

The convolution is over here, and texels are float32: so are the grid and these sums, in half the time and memory.
Positions and the kernel's weights are still found in float64.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.lighting.compiled_decorator import Array, compiled

_LANES = 24
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
def _along(weights: Array, source: Array, first: int, step: int, target: Array) -> None:
    """Set target (24) to the weighted sum of eight rows of source (n, 24), ``step`` (1 or -1) apart."""
    w_0, w_1, w_2, w_3 = weights[0], weights[1], weights[2], weights[3]
    w_4, w_5, w_6, w_7 = weights[4], weights[5], weights[6], weights[7]
    for q in range(_LANES):
        target[q] = (
            w_0 * source[first, q]
            + w_1 * source[first + step, q]
            + w_2 * source[first + 2 * step, q]
            + w_3 * source[first + 3 * step, q]
            + w_4 * source[first + 4 * step, q]
            + w_5 * source[first + 5 * step, q]
            + w_6 * source[first + 6 * step, q]
            + w_7 * source[first + 7 * step, q]
        )


@compiled
def _fold(grid: Array, ring: int, low: int, shift: int, target: Array) -> None:
    """Lay columns low … of one ring side by side for the eight turned and mirrored points: target (n, 24)."""
    period = grid.shape[2]
    for c in range(3):
        for turn in range(4):
            for side in range(2):
                at = (turn + shift) * (period // 4)
                step = 1 - 2 * side
                lane = 8 * c + 2 * turn + side
                place = (at + step * low) % period
                for p in range(target.shape[0]):
                    target[p, lane] = grid[c, ring, place]
                    place += step  # round the ring without a division for each value
                    if place == period:
                        place = 0
                    elif place < 0:
                        place = period - 1


@compiled
def side_columns(grid: Array, table: Array, first: int, end: int, faces: Array) -> None:
    """Fill columns of the four side faces: those ``first`` … ``end - 1`` right of the middle and their mirrors.

    ``grid`` (3, M, P) float32, ``faces`` (6, F, F, 3) float32, F even; ``table`` (13, 8): the polynomials of
    the interpolating kernel.
    """
    rings, period = grid.shape[1], grid.shape[2]
    size = faces.shape[1]
    half = size // 2
    count = end - first
    # Rings that the side faces need: symmetric about the equator.
    top = math.floor(math.atan(math.sqrt(0.5)) * rings / math.pi) - 5
    span = rings - 2 * top
    starts = np.empty(count, dtype=np.int64)
    weights = np.empty((count, 8), dtype=np.float32)
    for i in range(count):
        angle = math.atan((2.0 * (first + i) + 1.0) / size)
        starts[i] = _taps(angle * period / (2.0 * math.pi), table, weights[i])
    low = starts[0]
    folded = np.empty((starts[count - 1] + 8 - low, _LANES), dtype=np.float32)
    columns = np.empty((count, span, _LANES), dtype=np.float32)
    for ring in range(span):
        _fold(grid, top + ring, low, 0, folded)
        for i in range(count):
            _along(weights[i], folded, starts[i] - low, 1, columns[i, ring])
    down = np.empty(8, dtype=np.float32)
    north = np.empty(_LANES, dtype=np.float32)
    south = np.empty(_LANES, dtype=np.float32)
    for j in range(half):
        t = 1.0 - (2.0 * j + 1.0) / size
        for i in range(count):
            s = (2.0 * (first + i) + 1.0) / size
            theta = 0.5 * math.pi - math.atan(t / math.sqrt(1.0 + s * s))
            ring = _taps(theta * rings / math.pi - 0.5, table, down) - top
            _along(down, columns[i], ring, 1, north)
            _along(down, columns[i], span - 1 - ring, -1, south)
            for turn in range(4):
                face = _SIDES[turn]
                for c in range(3):
                    # φ = φ_f - atan(s): what is mirrored, φ < φ_f, lies right of the middle.
                    lane = 8 * c + 2 * turn
                    faces[face, j, half - 1 - first - i, c] = north[lane]
                    faces[face, j, half + first + i, c] = north[lane + 1]
                    faces[face, size - 1 - j, half - 1 - first - i, c] = south[lane]
                    faces[face, size - 1 - j, half + first + i, c] = south[lane + 1]


@compiled
def polar_rings(grid: Array, south: bool, margin: int, first: int, end: int, cap: Array) -> None:
    """Lay rings ``first`` … ``end - 1`` of a cap (n, columns, 24) side by side; row ``margin`` is ring 0.

    Rows before it lie beyond the pole: the same rings, half a turn further.
    """
    for row in range(first, end):
        ring = row - margin
        shift = 0
        if ring < 0:
            ring = -1 - ring
            shift = 2
        if south:
            ring = grid.shape[1] - 1 - ring
        _fold(grid, ring, -margin, shift, cap[row])


@compiled
def polar_points(
    cap: Array,
    rings: int,
    period: int,
    margin: int,
    south: bool,
    table: Array,
    first: int,
    end: int,
    faces: Array,
) -> None:
    """Fill rows ``first`` … ``end - 1`` of an octant of the face +Y or -Y, and their seven images."""
    size = faces.shape[1]
    face = 3 if south else 2
    across = np.empty(8, dtype=np.float32)
    along = np.empty(8, dtype=np.float32)
    rows = np.empty((8, _LANES), dtype=np.float32)
    values = np.empty(_LANES, dtype=np.float32)
    for outer in range(first, end):
        p = (2.0 * outer + 1.0) / size
        for inner in range(outer + 1):
            q = (2.0 * inner + 1.0) / size
            theta = math.atan(math.sqrt(p * p + q * q))
            ring = _taps(theta * rings / math.pi - 0.5, table, along) + margin
            column = _taps(math.atan(q / p) * period / (2.0 * math.pi), table, across) + margin
            for t in range(8):
                _along(across, cap[ring + t], column, 1, rows[t])
            _along(along, rows, 0, 1, values)
            for turn in range(4):
                for side in range(2):
                    # x = -sinθ sinφ and z = sinθ cosφ, in half texels; a quarter turn takes (x, z) to (-z, x).
                    x = (2 * inner + 1) * (2 * side - 1)
                    z = 2 * outer + 1
                    for _ in range(turn):
                        x, z = -z, x
                    if south:
                        z = -z
                    i = (x + size - 1) // 2
                    j = (z + size - 1) // 2
                    for c in range(3):
                        faces[face, j, i, c] = values[8 * c + 2 * turn + side]


@compiled
def resample_rows(pixels: Array, first: int, end: int, faces: Array) -> None:
    """Fill rows ``first`` … ``end - 1`` of all faces (6, F, F, 3) with a map (h, w, 3) looked up bilinearly.

    Both are float32; the same look-up as :func:`.latlong.sample`, over the seam and the poles.
    """
    height, width = pixels.shape[0], pixels.shape[1]
    size = faces.shape[1]
    for face in range(6):
        axis = face // 2
        positive = face % 2 == 0
        for j in range(first, end):
            t = (2.0 * j + 1.0) / size - 1.0
            for i in range(size):
                s = (2.0 * i + 1.0) / size - 1.0
                if axis == 0:
                    x, y, z = (1.0, -t, -s) if positive else (-1.0, -t, s)
                elif axis == 1:
                    x, y, z = (s, 1.0, t) if positive else (s, -1.0, -t)
                else:
                    x, y, z = (s, -t, 1.0) if positive else (-s, -t, -1.0)
                theta = math.atan2(math.sqrt(x * x + z * z), y)
                phi = math.atan2(-x, z)
                row = theta * height / math.pi - 0.5
                column = (phi + math.pi) * width / (2.0 * math.pi) - 0.5
                above = math.floor(row)
                left = math.floor(column)
                down = np.float32(row - above)
                right = np.float32(column - left)
                row_0, row_1 = int(above), int(above) + 1
                column_0 = int(left) % width
                column_1 = (column_0 + 1) % width
                shift_0 = shift_1 = 0
                if row_0 < 0:
                    row_0, shift_0 = 0, width // 2
                if row_1 > height - 1:
                    row_1, shift_1 = height - 1, width // 2
                a, b = (column_0 + shift_0) % width, (column_1 + shift_0) % width
                d, e = (column_0 + shift_1) % width, (column_1 + shift_1) % width
                for c in range(3):
                    top = pixels[row_0, a, c] * (np.float32(1.0) - right) + pixels[row_0, b, c] * right
                    bottom = pixels[row_1, d, c] * (np.float32(1.0) - right) + pixels[row_1, e, c] * right
                    faces[face, j, i, c] = top * (np.float32(1.0) - down) + bottom * down
