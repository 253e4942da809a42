"""Conversion of ring harmonics F_m(θ_j) to cube map texels, to about 1e-7 of the map's largest value.

A band-limited function on the sphere, continued over the poles (``f(-θ, φ) = f(θ, φ+π)``), is a trigonometric
polynomial on a torus. It can be had anywhere from a grid twice as fine as its bandlimit needs, with a smooth
kernel of eight points whose transform was divided out beforehand (the "exponential of semicircle" kernel:
Barnett, Magland & af Klinteberg, "A parallel nonuniform fast Fourier transform library", SIAM J. Sci. Comput.
41, 2019).

- The four side faces have one longitude a column: the Fourier sum along φ is taken exactly, as matrix
products that
  share the mirror and quarter-turn symmetry of the columns; then one 1-D interpolation along θ.
- The top and bottom faces are interpolated in both directions, one octant of points standing for sixteen.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Complexes, Floats, Reals
from brdf_suite.geometry.cube_map import face_coordinates
from brdf_suite.lighting.filter.harmonics import worker_count

WIDTH = 8
_BETA = 2.30 * WIDTH

_LINES = 32  # orders, and lines of a side face, at once
_LARGEST_DOUBLE = 256  # texels along a face's side
_POINTS = 16384  # of a polar face's octant at once


def rings_for(bandlimit: int) -> int:
    """Return how many rings :func:`cube_from_rings` wants for a bandlimit: even, with a fast transform."""
    return fast_even(bandlimit + 2)


def fast_even(least: int) -> int:
    """Return the smallest even number ≥ ``least`` that is a product of 2, 3 and 5."""
    number = max(2, least + least % 2)
    while True:
        rest = number
        for prime in (2, 3, 5):
            while rest % prime == 0:
                rest //= prime
        if rest == 1:
            return number
        number += 2


def kernel(x: Floats) -> Floats:
    """Return the kernel at distances x in grid steps; it ends at ±WIDTH/2."""
    inside = np.maximum(1.0 - (2.0 * x / WIDTH) ** 2, 0.0)
    return np.exp(_BETA * (np.sqrt(inside) - 1.0))


def kernel_transform(frequencies: Floats, period: int) -> Floats:
    """Return ∫ kernel(x)·cos(2π·k·x/period) dx for whole frequencies k."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    x = 0.25 * WIDTH * (nodes + 1.0)  # half of the even kernel
    values = 0.5 * WIDTH * weights * kernel(x)
    return np.asarray(np.cos(np.outer(frequencies, x) * (2.0 * np.pi / period)) @ values, dtype=np.float64)


def _taps(position: Floats) -> tuple[NDArray[np.int64], Floats]:
    """Return the first grid index (...) and the kernel's weights (..., WIDTH) around positions in steps."""
    first = np.ceil(position - 0.5 * WIDTH).astype(np.int64)
    return first, kernel((position - first)[..., None] - np.arange(WIDTH))


def cube_from_rings(orders: Complexes, size: int) -> Reals:
    """Return the cube map (6, size, size, channels) of a real function given by its ring harmonics.

    Float64 up to faces of 256 texels, float32 above, where time and memory count; the error is then 2e-7.

    Parameters
    ----------
    orders
        F_m (bandlimit+1, rings, channels) on rings at (j+½)π/rings, more rings than the bandlimit.
    size
        Texels along a face's side, even.
    """
    bandlimit, rings, channels = orders.shape[0] - 1, orders.shape[1], orders.shape[2]
    if size % 2 or rings <= bandlimit:
        raise ValueError("the face size must be even and the rings more than the bandlimit")
    period = fast_even(2 * (2 * bandlimit + 1) // 4) * 4
    kind = np.float64 if size <= _LARGEST_DOUBLE else np.float32
    faces: NDArray[Any] = np.empty((6, size, size, channels), kind)
    with ThreadPoolExecutor(worker_count()) as pool:
        grid = _fine_grid(orders, period, pool)
        _side_faces(grid, period, faces, pool)
        _polar_faces(grid, period, faces, pool)
    return faces


def _fine_grid(orders: Complexes, period: int, pool: ThreadPoolExecutor) -> Complexes:
    """Return F_m (channels, period, m) at θ = 2πi/period round the torus, the kernel divided out along θ."""
    count, rings, channels = orders.shape
    bandlimit = count - 1
    frequencies = np.arange(-bandlimit, bandlimit + 1)
    sign = np.where(np.arange(count) % 2, -1.0, 1.0)
    shift = np.exp(-1j * np.pi * frequencies / (2.0 * rings)) / (2.0 * rings)
    factor = shift / kernel_transform(frequencies.astype(np.float64), period) * period
    result = np.empty((channels, period, count), dtype=np.complex128)

    def fill(channel: int) -> None:
        # A few orders at a time: what is turned over stays in the cache.
        for begin in range(0, count, _LINES):
            lines = slice(begin, min(begin + _LINES, count))
            plane = orders[lines, :, channel]
            whole = np.concatenate([plane, plane[:, ::-1] * sign[lines, None]], axis=1)
            spectrum = np.fft.fft(whole, axis=1)
            fine = np.zeros((len(plane), period), dtype=np.complex128)
            fine[:, : bandlimit + 1] = spectrum[:, : bandlimit + 1] * factor[bandlimit:]
            if bandlimit:
                fine[:, -bandlimit:] = spectrum[:, -bandlimit:] * factor[:bandlimit]
            result[channel, :, lines] = np.fft.ifft(fine, axis=1).T

    list(pool.map(fill, range(channels)))
    return result


def _side_faces(grid: Complexes, period: int, faces: NDArray[Any], pool: ThreadPoolExecutor) -> None:
    """Fill the faces +Z, -X, -Z, +X, whose centres are at φ = 0, 90°, 180°, 270°."""
    from scipy.sparse import csr_array  # here, because only prefiltering needs scipy

    channels, _, count = grid.shape
    size = faces.shape[1]
    half = size // 2
    step = 2.0 * np.pi / period
    s = face_coordinates(size)[half:]
    alpha = np.arctan(s)
    first_ring = int(np.floor(np.arctan(np.sqrt(0.5)) / step)) - WIDTH
    last_ring = int(np.ceil((np.pi - np.arctan(np.sqrt(0.5))) / step)) + WIDTH
    span = last_ring - first_ring + 1
    rows = np.arange(first_ring, last_ring + 1) % period
    near = grid[:, rows].reshape(channels * span, count)
    # Real (and, for odd m, imaginary) parts of Σ F_m e^(∓imα) over m = r, r+4, … . Face f, a quarter turn from the
    # face before, multiplies its terms by i^(r·f), so that all four are sums and differences of these.
    terms: dict[int, tuple[Floats, ...]] = {}

    def sum_up(residue: int) -> None:
        m = np.arange(residue, count, 4)
        twice = np.where(m == 0, 1.0, 2.0)[:, None]
        cosine, sine = twice * np.cos(np.outer(m, alpha)), twice * np.sin(np.outer(m, alpha))
        a, b = near.real[:, residue::4].copy(), near.imag[:, residue::4].copy()
        a_cos, b_sin = a @ cosine, b @ sine
        terms[residue] = (a_cos + b_sin, a_cos - b_sin)
        if residue % 2:
            b_cos, a_sin = b @ cosine, a @ sine
            terms[residue] += (b_cos - a_sin, b_cos + a_sin)

    list(pool.map(sum_up, range(4)))
    table = np.empty(
        (span, half, 4, 2, channels), faces.dtype
    )  # ring, column, quarter turn, side (-, +), channel

    def turn(side: int) -> None:
        even, odd = terms[0][side] + terms[2][side], terms[1][side] + terms[3][side]
        even_turned = terms[0][side] - terms[2][side]
        odd_turned = terms[1][2 + side] - terms[3][2 + side]
        turned = (even + odd, even_turned - odd_turned, even - odd, even_turned + odd_turned)
        for number, values in enumerate(turned):
            table[:, :, number, side] = values.reshape(channels, span, half).transpose(1, 2, 0)

    list(pool.map(turn, (0, 1)))
    flat = table.reshape(span * half, -1)
    t = face_coordinates(size)

    def fill(begin: int) -> None:
        lines = slice(begin, min(begin + _LINES, size))
        theta = 0.5 * np.pi + np.arctan2(t[lines, None], np.sqrt(1.0 + s[None, :] ** 2))
        first, weights = _taps(theta / step)
        source = (
            ((first - first_ring) * half + np.arange(half))[..., None] + half * np.arange(WIDTH)
        ).astype(np.int32)
        pointers = np.arange(0, source.size + 1, WIDTH, dtype=np.int32)
        weights = weights.astype(faces.dtype)
        matrix = csr_array((weights.ravel(), source.ravel(), pointers), shape=(theta.size, span * half))
        texels = np.asarray(matrix @ flat).reshape(*theta.shape, 4, 2, channels)
        for number, face in enumerate((4, 1, 5, 0)):
            # φ = φ_f - atan(s): the side "-" is s > 0.
            faces[face, lines, half:] = texels[:, :, number, 0]
            faces[face, lines, :half] = texels[:, ::-1, number, 1]

    list(pool.map(fill, range(0, size, _LINES)))


def _polar_faces(grid: Complexes, period: int, faces: NDArray[Any], pool: ThreadPoolExecutor) -> None:
    """Fill +Y and -Y from the octant 0 < φ ≤ 45° of points, its mirror image and its quarter turns."""
    from scipy.sparse import csr_array

    channels, _, count = grid.shape
    size = faces.shape[1]
    half = size // 2
    step = 2.0 * np.pi / period
    along = np.arctan(np.sqrt(2.0)) / step
    rings = np.arange(-WIDTH, int(np.ceil(along)) + WIDTH + 1)
    columns = np.arange(-WIDTH, period // 8 + WIDTH + 1)
    coordinates = face_coordinates(size)[half:]
    divided = 1.0 / kernel_transform(np.arange(count, dtype=np.float64), period)
    variants = [(sign, turn) for sign in (1, -1) for turn in range(4)]
    # ring, column, face, turned and mirrored point, channel
    table = np.empty((rings.size, columns.size, 2, len(variants), channels), faces.dtype)

    def unfold(item: int) -> None:
        face, channel = divmod(item, channels)
        rows = rings % period if face == 0 else (period // 2 - rings) % period
        spectrum = np.zeros((rings.size, period // 2 + 1), dtype=np.complex128)
        spectrum[:, :count] = grid[channel, rows] * divided
        plane = (np.fft.irfft(spectrum, period, axis=1) * period).astype(faces.dtype)
        for index, (sign, turn) in enumerate(variants):
            table[:, :, face, index, channel] = plane[:, (sign * columns + turn * (period // 4)) % period]

    list(pool.map(unfold, range(2 * channels)))
    flat = table.reshape(rings.size * columns.size, -1)
    outer, inner = np.tril_indices(half)
    reach = np.arange(WIDTH)

    def fill(begin: int) -> None:
        part = slice(begin, begin + _POINTS)
        p, q = coordinates[outer[part]], coordinates[inner[part]]
        ring, ring_weights = _taps(np.arctan(np.hypot(p, q)) / step)
        column, column_weights = _taps(np.arctan2(q, p) / step)
        source = (((ring + WIDTH)[:, None] + reach) * columns.size + (column + WIDTH)[:, None]).astype(
            np.int32
        )
        source = source[:, :, None] + reach.astype(np.int32)
        weights = (ring_weights[:, :, None] * column_weights[:, None, :]).astype(faces.dtype)
        pointers = np.arange(0, source.size + 1, WIDTH * WIDTH, dtype=np.int32)
        matrix = csr_array((weights.ravel(), source.ravel(), pointers), shape=(p.size, len(flat)))
        texels = np.asarray(matrix @ flat).reshape(p.size, 2, len(variants), channels)
        for index, (sign, turn) in enumerate(variants):
            # x = -sinθ sinφ and z = sinθ cosφ of the turned and mirrored point, before the y axis is divided
            # out.
            x, z = -sign * q, p
            for _ in range(turn):
                x, z = -z, x
            i = np.rint((x + 1.0) * half - 0.5).astype(np.int64)
            j = np.rint((z + 1.0) * half - 0.5).astype(np.int64)
            faces[2, j, i] = texels[:, 0, index]
            faces[3, size - 1 - j, i] = texels[:, 1, index]

    list(pool.map(fill, range(0, outer.size, _POINTS)))
