"""Compiled loops over the texels of cube maps: from a fine grid on the sphere, from a map's pixels, to half floats.

From the fine grid they are the sums of
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


@compiled
def pack_rows(
    faces: Array, share: float, changes: Array, scale: float, first: int, end: int, halves: Array
) -> None:
    """Set rows ``first`` … ``end - 1`` of every face, first to last of 6·F rows counted through, as half floats.

    The formulas of :mod:`brdf_suite.lighting.filter.texel_values` in one pass. The machine's own conversion is not
    available on every processor; that by whole numbers gives the same bits.

    Parameters
    ----------
    faces
        (6, F, F, 3) float32.
    share
        How much of the second differences is taken off; 0 leaves the values as they are.
    changes
        (6, 4, F, 3) float32: taken off the columns 0 and F-1 and the rows 0 and F-1.
    scale
        What the values are divided by; negative ones become 0, and none may exceed 65,504 afterwards.
    halves
        (6, F, 3·F) uint16: the bits of the half floats.
    """
    size = faces.shape[1]
    count = 3 * size
    row = np.empty(count, dtype=np.float32)
    raised = np.empty(count, dtype=np.float32)
    bits = row.view(np.uint32)
    small = raised.view(np.uint32)
    inverse = np.float32(1.0 / scale)
    part = np.float32(share)
    zero = np.float32(0.0)
    half = np.float32(0.5)
    for index in range(first, end):
        face, j = index // size, index % size
        middle = min(max(j, 1), size - 2)  # at the rim the second difference is that of the next texel
        here = faces[face, j].reshape(count)
        above = faces[face, middle - 1].reshape(count)
        centre = faces[face, middle].reshape(count)
        below = faces[face, middle + 1].reshape(count)
        if part > zero:
            for k in range(count):
                row[k] = here[k] - part * (above[k] - centre[k] - centre[k] + below[k])
            for k in range(3, count - 3):
                row[k] -= part * (here[k - 3] - here[k] - here[k] + here[k + 3])
            for c in range(3):
                row[c] -= part * (here[c] - here[3 + c] - here[3 + c] + here[6 + c])
                k = count - 3 + c
                row[k] -= part * (here[k] - here[k - 3] - here[k - 3] + here[k - 6])
        else:
            for k in range(count):
                row[k] = here[k]
        for c in range(3):
            row[c] -= changes[face, 0, j, c]
            row[count - 3 + c] -= changes[face, 1, j, c]
        if j == 0:
            row -= changes[face, 2].reshape(count)
        if j == size - 1:
            row -= changes[face, 3].reshape(count)
        for k in range(count):
            row[k] = max(row[k] * inverse, zero)
            raised[k] = row[k] + half  # in this sum the last bit is the last bit of a small half float
        target = halves[face, j]
        for k in range(count):
            value = bits[k]
            normal = (value + np.uint32(0xFFF) + ((value >> np.uint32(13)) & np.uint32(1))) >> np.uint32(13)
            if value < np.uint32(0x38800000):  # below 2^-14
                target[k] = small[k] - np.uint32(0x3F000000)
            else:
                target[k] = normal - np.uint32(0x1C000)


@compiled
def _look_up(pixels: Array, theta: float, phi: float, target: Array, at: int) -> None:
    """Set target[at : at + 3] to the map (h, w, 3) at θ 0…π and φ (-2π…2π), over the seam and the poles."""
    height, width = pixels.shape[0], pixels.shape[1]
    row = theta * height / math.pi - 0.5
    column = (phi + math.pi) * width / (2.0 * math.pi) - 0.5
    above = math.floor(row)
    left = math.floor(column)
    down = np.float32(row - above)
    right = np.float32(column - left)
    row_0, row_1 = int(above), int(above) + 1
    a = int(left)
    if a < 0:
        a += width
    elif a >= width:
        a -= width
    b = a + 1 if a + 1 < width else 0
    d, e = a, b
    turn = width - width // 2  # beyond the pole lies the same ring, half a turn further
    if row_0 < 0:
        row_0 = 0
        a, b = (a + turn) % width, (b + turn) % width
    if row_1 > height - 1:
        row_1 = height - 1
        d, e = (d + turn) % width, (e + turn) % width
    one = np.float32(1.0)
    for c in range(3):
        top = pixels[row_0, a, c] * (one - right) + pixels[row_0, b, c] * right
        bottom = pixels[row_1, d, c] * (one - right) + pixels[row_1, e, c] * right
        target[at + c] = top * (one - down) + bottom * down


@compiled
def resample_rows(pixels: Array, first: int, end: int, faces: Array) -> None:
    """Fill rows ``first`` … ``end - 1`` ≤ F/2 of all faces (6, F, F, 3), and their mirror images from below.

    By bilinear look-up in an environment's own pixels. The cube's symmetry saves nearly all of the arc tangents:
    sixteen texels have their longitudes and latitudes in common, up to quarter turns and mirrors.

    Both are float32, F is even; the same look-up as :func:`brdf_suite.lighting.latlong.sample`.
    """
    size = faces.shape[1]
    half = size // 2
    flat = faces.reshape(faces.size)  # to cut a texel out of the faces takes longer than to fill it
    longitudes = np.empty(half)
    latitudes = np.empty(half)
    for j in range(first, end):
        t = 1.0 - (2.0 * j + 1.0) / size
        for i in range(half):
            s = (2.0 * i + 1.0) / size
            longitudes[i] = math.atan(s)
            latitudes[i] = math.atan(t / math.sqrt(1.0 + s * s))
        for turn in range(4):
            upper = 3 * size * (size * _SIDES[turn] + j)
            lower = 3 * size * (size * _SIDES[turn] + size - 1 - j)
            centre = turn * 0.5 * math.pi
            if turn > 1:
                centre -= 2.0 * math.pi  # the map runs from φ = -π to π
            for i in range(size):
                inner = half - 1 - i if i < half else i - half
                # φ = φ_f - atan(s): columns right of the middle lie at smaller φ.
                phi = centre + (longitudes[inner] if i < half else -longitudes[inner])
                _look_up(pixels, 0.5 * math.pi - latitudes[inner], phi, flat, upper + 3 * i)
                _look_up(pixels, 0.5 * math.pi + latitudes[inner], phi, flat, lower + 3 * i)
        for i in range(half):
            s = (2.0 * i + 1.0) / size
            longitudes[i] = math.atan(s / t)  # from the nearest of φ = 0 and 180°
            latitudes[i] = math.atan(math.sqrt(s * s + t * t))  # from the pole
        upper = 3 * size * (2 * size + j)
        lower = 3 * size * (3 * size - 1 - j)
        face = 3 * size * size
        for i in range(size):
            inner = half - 1 - i if i < half else i - half
            turned = longitudes[inner] if i < half else -longitudes[inner]
            # On +Y rows run from z = -1 (φ = 180°) to z = 1 (φ = 0); on -Y the other way.
            _look_up(pixels, latitudes[inner], -math.pi - turned, flat, upper + 3 * i)
            _look_up(pixels, latitudes[inner], turned, flat, lower + 3 * i)
            _look_up(pixels, math.pi - latitudes[inner], turned, flat, face + upper + 3 * i)
            _look_up(pixels, math.pi - latitudes[inner], -math.pi - turned, flat, face + lower + 3 * i)
