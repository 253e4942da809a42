"""Compiled filter from a map's pixels to coefficients, and from coefficients to a cube map.

The same steps as :mod:`brdf_suite.lighting.filter.harmonics` and :mod:`brdf_suite.lighting.filter.ring_to_cube`,
which are plain numpy and serve where no kernels are available. Pixels are read and transformed in blocks of rings,
so that a large map needs no second copy.
Importing this module imports numba.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Singles
from brdf_suite.lighting.filter.face_array import FaceArray, choose_scale
from brdf_suite.lighting.filter.harmonics import legendre_starts, run_all, worker_count
from brdf_suite.lighting.filter.kernels import cube as compiled_cube
from brdf_suite.lighting.filter.kernels import legendre as compiled_legendre
from brdf_suite.lighting.filter.kernels.cube import MARGIN
from brdf_suite.lighting.filter.ring_to_cube import WIDTH, fast_even, kernel, kernel_transform, rings_for
from brdf_suite.lighting.latlong import column_angles, ring_angles
from brdf_suite.progress import Progress, subrange

_RING_PAIRS = 128  # read at once: 50 MB with their spectrum where the map is 8,192 wide
_BLOCK_RINGS = 192  # ring pairs at once in a synthesis: what stays in the nearest cache
_ORDERS = 16  # orders of one piece of work, an even number: neighbours share lines of memory
_BAND = 24  # rings of the fine grid at once, and their mirror images: they stay in the last cache
_ROWS = 16  # of a face's upper half at once
_PACKED_ROWS = 64
_DEGREE = 12  # of the polynomials in place of the interpolating kernel: 1e-9


def analyse(
    pixels: NDArray[np.float32], weights: Floats, bandlimit: int, progress: Progress | None = None
) -> NDArray[np.complex128]:
    """Return the coefficients of a map (rings, columns, 3) up to a bandlimit, for :func:`cube`.

    They are those of :func:`brdf_suite.lighting.filter.harmonics.analyse`, one order after the other without the
    empty half of that table.
    """
    rings, columns = pixels.shape[:2]
    half = (rings + 1) // 2
    theta = ring_angles(rings)
    result = np.zeros((_count(bandlimit), 6))
    starts = legendre_starts(bandlimit)
    size = _RING_PAIRS
    first_angle = float(column_angles(columns)[0])
    with ThreadPoolExecutor(worker_count()) as pool:
        for begin in range(0, half, size):
            # From the equator outwards; on an odd number of rings the equator is its own mirror image.
            north = np.arange(half - 1 - begin, max(half - 1 - begin - size, -1), -1)
            weight = 2.0 * np.pi * weights[north]
            weight[north == rings - 1 - north] *= 0.5
            spectrum = np.empty((3, 2, north.size, columns // 2 + 1), dtype=np.complex128)

            def transform(item: int, north: NDArray[np.int64] = north, target: Any = spectrum) -> None:
                channel, side = divmod(item, 2)
                rows = pixels[north if side == 0 else rings - 1 - north, :, channel]
                np.fft.rfft(rows.astype(np.float64), axis=-1, norm="forward", out=target[channel, side])

            def sum_up(
                first: int, spectrum: Any = spectrum, weight: Any = weight, north: Any = north
            ) -> None:
                cosines = np.cos(theta[north])
                end = first + _ORDERS
                compiled_legendre.analyse_rings(
                    spectrum, weight, cosines, columns, first_angle, starts, first, end, bandlimit, result
                )

            run_all(pool, transform, range(6))
            step = subrange(progress, begin / half, min(1.0, (begin + size) / half))
            run_all(pool, sum_up, range(0, bandlimit + 1, _ORDERS), step, "analysing the environment")
    return result.view(np.complex128)


def cube(
    coefficients: NDArray[np.complex128],
    gains: Floats,
    size: int,
    progress: Progress | None = None,
    room: Singles | None = None,
) -> Singles:
    """Return the cube map (6, size, size, 3) of coefficients times a gain for each degree.

    The error is 2e-7 of the largest value: what is interpolated is float32. ``room`` (≥ 18·size²,) is memory for the
    result: what is used again need not be fetched from the system for every map.
    """
    with ThreadPoolExecutor(worker_count()) as pool:
        orders = _fine_rings(pool, coefficients, gains, subrange(progress, 0.0, 0.5))
        return _faces(pool, orders, _within(room, size), subrange(progress, 0.5, 1.0))


def resample_to_cube(pixels: Singles, size: int, room: Singles | None = None) -> Singles:
    """Return a map (h, w, 3) itself as a cube map (6, size, size, 3), looked up bilinearly; ``room`` as above."""
    faces = _within(room, size)
    readable = pixels.view()
    readable.flags.writeable = False  # kernels are compiled for each kind of array: one will do

    def work(first: int) -> None:
        compiled_cube.resample_rows(readable, first, min(first + _ROWS, size // 2), faces)

    with ThreadPoolExecutor(worker_count()) as pool:
        run_all(pool, work, range(0, size // 2, _ROWS))
    return faces


def pack_faces(faces: Singles, bend_share: float, changes: Singles | None) -> FaceArray:
    """Return faces (6, F, F, 3) as half floats, less a share of their second differences and less ``changes``.

    ``changes``: see :func:`brdf_suite.lighting.filter.texel_values.edge_changes`.
    """
    size = faces.shape[1]
    halves = np.empty(faces.shape, dtype=np.float16)
    bits = halves.view(np.uint16).reshape(6, size, 3 * size)
    if changes is None:
        changes = np.zeros((6, 4, size, 3), dtype=np.float32)
    with ThreadPoolExecutor(worker_count()) as pool:
        scale = choose_scale(max(pool.map(lambda face: float(face.max()), faces)))

        def work(first: int, less: Singles = changes) -> None:
            compiled_cube.pack_rows(
                faces, bend_share, less, scale, first, min(first + _PACKED_ROWS, 6 * size), bits
            )

        run_all(pool, work, range(0, 6 * size, _PACKED_ROWS))
    return FaceArray(halves, scale)


def _within(room: Singles | None, size: int) -> Singles:
    """Return memory for faces (6, size, size, 3)."""
    if room is None:
        return np.empty((6, size, size, 3), dtype=np.float32)
    return room[: 18 * size * size].reshape(6, size, size, 3)


def _fine_rings(
    pool: ThreadPoolExecutor, coefficients: NDArray[np.complex128], gains: Floats, progress: Progress | None
) -> NDArray[np.complex64]:
    """Return F_m (M, 3, bandlimit+1) on the M rings θ = (i+½)π/M of the fine grid, its kernel divided out.

    On a ring, order m is a cosine series in θ where m is even and a sine series where it is odd, so that cosine and
    sine transforms bring it from as many rings as the Legendre sums need to the finer ones.
    """
    from scipy.fft import dct, dst  # here, because only prefiltering needs scipy

    bandlimit = gains.size - 1
    rings = rings_for(bandlimit)
    half = rings // 2
    fine = fast_even(2 * rings)
    cosines = np.cos(ring_angles(rings))[half - 1 :: -1]
    starts = legendre_starts(bandlimit)
    pairs = coefficients.view(np.float64)
    analysed = _bandlimit(len(pairs))
    bounds = np.linspace(0, half, -(-half // _BLOCK_RINGS) + 1).astype(int).tolist()
    divided = np.zeros(rings + 1)
    frequencies = np.arange(bandlimit + 1, dtype=np.float64)
    divided[: bandlimit + 1] = 1.0 / kernel_transform(frequencies, 2 * fine)
    result = np.empty((fine, 3, bandlimit + 1), dtype=np.complex64)
    # Taken once for each thread: memory from the system for every piece of work took a quarter of the time.
    room = [
        (np.empty((2, rings, 3, _ORDERS // 2, 2)), np.empty((fine, 3, _ORDERS // 2, 2)))
        for _ in range(worker_count())
    ]

    def work(first: int) -> None:
        end = min(first + _ORDERS, bandlimit + 1)
        orders, finer = mine = room.pop()
        for begin, stop in pairwise(bounds):
            compiled_legendre.synthesise_rings(
                pairs, analysed, gains, cosines[begin:stop].copy(), begin, starts, first, end, orders
            )
        for odd, (there, back) in enumerate(((dct, dct), (dst, dst))):
            along = divided[first + odd : end : 2, None]
            series = there(orders[odd, :, :, : along.size], type=2, axis=0, overwrite_x=True)
            # Row i of a cosine series is frequency i, of a sine series frequency i + 1.
            factors = divided[odd : rings + odd, None, None, None] * along / (2.0 * rings)
            np.multiply(series, factors, out=finer[:rings, :, : along.size])
            finer[rings:] = 0.0
            found = back(finer[:, :, : along.size], type=3, axis=0, overwrite_x=True)
            result[:, :, first + odd : end : 2] = found.view(np.complex128)[..., 0]
        room.append(mine)

    run_all(pool, work, range(0, bandlimit + 1, _ORDERS), progress, "filtering")
    return result


def _count(bandlimit: int) -> int:
    """Return how many coefficients there are up to a bandlimit, orders from 0 on."""
    return (bandlimit + 1) * (bandlimit + 2) // 2


def _bandlimit(count: int) -> int:
    """Return the bandlimit of so many coefficients."""
    return int(np.sqrt(2.0 * count)) - 1


def _faces(
    pool: ThreadPoolExecutor, orders: NDArray[np.complex64], faces: Singles, progress: Progress | None
) -> Singles:
    """Fill the cube map (6, F, F, 3) of a function given by F_m (M, 3, m) on the rings of a fine grid."""
    rings, _, count = orders.shape
    period = 2 * rings
    table = _polynomials()
    # The eight rings of a texel north of the equator begin at -5 … M/2 - 4; those below zero lie beyond the pole.
    sections = np.linspace(-5, rings // 2, min(4 * worker_count(), -(-rings // (4 * _BAND))) + 1)

    def fill(bounds: tuple[int, int]) -> None:
        folded = np.empty((2, _BAND + WIDTH - 1, period // 8 + 2 * MARGIN + 1, 24), dtype=np.float32)
        spectrum = np.empty((_BAND + WIDTH - 1, 3, count), dtype=np.complex128)
        values = np.empty((_BAND + WIDTH - 1, 3, period))
        held = 0
        for first in range(*bounds, _BAND):
            end = min(first + _BAND, bounds[1])
            wanted = range(first + held, end + WIDTH - 1)
            for side in (0, 1):
                for place, ring in enumerate(wanted):
                    north = ring if ring >= 0 else -1 - ring
                    spectrum[place] = orders[rings - 1 - north if side else north]
                new = slice(0, len(wanted))
                np.fft.irfft(spectrum[new], period, axis=-1, norm="forward", out=values[new])
                for place, ring in enumerate(wanted):
                    compiled_cube.fold_ring(values[place], 2 if ring < 0 else 0, folded[side, held + place])
            band = (folded[0], folded[1], first, end, rings, period, table, faces)
            compiled_cube.side_band(*band)
            compiled_cube.polar_band(*band)
            held = WIDTH - 1
            folded[:, :held] = folded[:, end - first : end - first + held]

    run_all(pool, fill, pairwise(sections.astype(int).tolist()), progress, "filling the cube")
    return faces


@lru_cache(maxsize=1)
def _polynomials() -> Floats:
    """Return (13, 8): for each of the kernel's eight taps a polynomial in 2u-1, highest power first.

    u, 0…1, is how far the position lies beyond the third grid point from the first.
    """
    z = np.cos((np.arange(64) + 0.5) * np.pi / 64)
    x = 3.0 + 0.5 * (z + 1.0)
    columns = []
    for tap in range(WIDTH):
        series = np.polynomial.chebyshev.chebfit(z, kernel(x - tap), _DEGREE)
        columns.append(np.polynomial.chebyshev.cheb2poly(series)[::-1])
    return np.ascontiguousarray(np.array(columns).T)
