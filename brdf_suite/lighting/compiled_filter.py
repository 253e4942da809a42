"""The compiled way from a map's pixels to coefficients, and from coefficients to a cube map.

The same steps as :mod:`.harmonics` and :mod:`.ring_to_cube`, which are plain numpy and serve where no kernels
are at hand. Pixels are read and transformed in blocks of rings, so that a large map needs no second copy.
Importing this module imports numba.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting import compiled_cube, compiled_legendre
from brdf_suite.lighting.harmonics import legendre_starts, worker_count
from brdf_suite.lighting.latlong import column_angles, ring_angles
from brdf_suite.lighting.ring_to_cube import WIDTH, fast_even, kernel, kernel_transform, rings_for
from brdf_suite.progress import Progress, part, report

_BLOCK_VALUES = 1 << 18  # pixels of one block of ring pairs: 50 MB with their spectrum
_BLOCK_RINGS = 192  # ring pairs at once in a synthesis: what stays in the nearest cache
_ORDERS = 8  # orders of one piece of work: neighbours share lines of memory
_COLUMNS = 16  # of a face at once: their rings stay in the second cache
_DEGREE = 12  # of the polynomials in place of the interpolating kernel: 1e-9

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
_Item = TypeVar("_Item")


def analyse(
    pixels: NDArray[np.float32], weights: Floats, bandlimit: int, progress: Progress | None = None
) -> NDArray[np.complex128]:
    """Return coefficients (m, k, 3) of a map (rings, columns, 3), as :func:`.harmonics.analyse` does."""
    rings, columns = pixels.shape[:2]
    half = (rings + 1) // 2
    theta = ring_angles(rings)
    result = np.zeros((bandlimit + 1, bandlimit + 1, 6))
    starts = legendre_starts(bandlimit)
    size = int(np.clip(_BLOCK_VALUES // columns, 32, 256))
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
                    spectrum, weight, cosines, columns, first_angle, starts, first, end, result
                )

            _all(pool, transform, range(6))
            step = part(progress, begin / half, min(1.0, (begin + size) / half))
            _all(pool, sum_up, range(0, bandlimit + 1, _ORDERS), step, "analysing the environment")
    return result.view(np.complex128)


def cube(
    coefficients: NDArray[np.complex128], gains: Floats, size: int, progress: Progress | None = None
) -> NDArray[np.float32]:
    """Return the cube map (6, size, size, 3) of coefficients (m, k, 3) times a gain for each degree.

    The error is 2e-7 of the largest value: what is interpolated is float32.
    """
    with ThreadPoolExecutor(worker_count()) as pool:
        orders = _synthesise(pool, coefficients, gains, part(progress, 0.0, 0.4))
        grid = _fine_grid(pool, orders, part(progress, 0.4, 0.7))
        return _faces(pool, grid, size, part(progress, 0.7, 1.0))


def resampled(pixels: NDArray[np.float32], size: int) -> NDArray[np.float32]:
    """Return a map (h, w, 3) itself as a cube map (6, size, size, 3), looked up bilinearly."""
    faces = np.empty((6, size, size, 3), dtype=np.float32)
    readable = pixels.view()
    readable.flags.writeable = False  # kernels are compiled for each kind of array: one will do

    def work(first: int) -> None:
        compiled_cube.resample_rows(readable, first, min(first + _COLUMNS, size), faces)

    with ThreadPoolExecutor(worker_count()) as pool:
        _all(pool, work, range(0, size, _COLUMNS))
    return faces


def _synthesise(
    pool: ThreadPoolExecutor, coefficients: NDArray[np.complex128], gains: Floats, progress: Progress | None
) -> Floats:
    """Return F_m (3, rings, bandlimit+1, 2) on the rings that :func:`_fine_grid` wants."""
    bandlimit = gains.size - 1
    rings = rings_for(bandlimit)
    half = rings // 2
    cosines = np.cos(ring_angles(rings))[half - 1 :: -1]
    starts = legendre_starts(bandlimit)
    pairs = coefficients.view(np.float64)
    orders = np.empty((3, rings, bandlimit + 1, 2))
    bounds = np.linspace(0, half, -(-half // _BLOCK_RINGS) + 1).astype(int)

    def work(item: tuple[int, tuple[int, int]]) -> None:
        first, (begin, end) = item
        compiled_legendre.synthesise_rings(
            pairs, gains, cosines[begin:end].copy(), begin, starts, first, first + _ORDERS, orders
        )

    _all(
        pool,
        work,
        [(first, block) for first in range(0, bandlimit + 1, _ORDERS) for block in pairwise(bounds.tolist())],
        progress,
        "filtering",
    )
    return orders


def _fine_grid(pool: ThreadPoolExecutor, orders: Floats, progress: Progress | None) -> Singles:
    """Return the function (3, M, P), float32, at θ = (i+½)π/M, φ = 2πi/P, the interpolating kernel divided out.

    On a ring, order m is a cosine series in θ where m is even and a sine series where it is odd, so that
    cosine and sine transforms bring it from its rings to finer ones.
    """
    from scipy.fft import dct, dst  # here, because only prefiltering needs scipy

    _, rings, count, _ = orders.shape
    fine = fast_even(2 * rings)
    period = 2 * fine
    frequency = np.arange(rings + 1)
    divided = np.zeros(rings + 1)
    divided[:count] = 1.0 / kernel_transform(frequency[:count].astype(np.float64), period)
    grid = np.empty((3, fine, period), dtype=np.float32)
    finer = np.empty((fine, count, 2))
    turning = finer.view(np.complex128)[:, :, 0]
    along = divided[:count]
    bounds = np.linspace(0, count, 2 * worker_count() + 1).astype(int) // 2 * 2
    bounds[-1] = count

    def refine(item: tuple[int, int, int]) -> None:
        channel, first, end = item
        for odd, (there, back) in enumerate(((dct, dct), (dst, dst))):
            if first + odd >= end:
                continue
            series = there(orders[channel, :, first + odd : end : 2], type=2, axis=0) / (2.0 * rings)
            # Row i of a cosine series is frequency i, of a sine series frequency i + 1.
            series *= divided[odd : rings + odd, None, None]
            padded = np.zeros((fine, *series.shape[1:]))
            padded[:rings] = series
            finer[:, first + odd : end : 2] = back(padded, type=3, axis=0, overwrite_x=True)

    for channel in range(3):
        _all(pool, refine, [(channel, first, end) for first, end in pairwise(bounds.tolist())])

        def round_rings(first: int, target: Singles = grid[channel]) -> None:
            rows = slice(first, first + 64)
            target[rows] = np.fft.irfft(turning[rows] * along, period, axis=1, norm="forward")

        _all(pool, round_rings, range(0, fine, 64))
        report(progress, (channel + 1) / 3, "filtering")
    return grid


def _faces(
    pool: ThreadPoolExecutor, grid: Singles, size: int, progress: Progress | None
) -> NDArray[np.float32]:
    """Return the cube map (6, size, size, 3) of a fine grid (3, M, P)."""
    _, rings, period = grid.shape
    half = size // 2
    table = _polynomials()
    faces = np.empty((6, size, size, 3), dtype=np.float32)

    def side(first: int) -> None:
        compiled_cube.side_columns(grid, table, first, min(first + _COLUMNS, half), faces)

    _all(pool, side, range(0, half, _COLUMNS), part(progress, 0.0, 0.6), "filling the cube")
    margin = WIDTH
    reach = int(np.ceil(np.arctan(np.sqrt(2.0)) / np.pi * rings)) + 2 * margin + 1
    cap = np.empty((reach, period // 8 + 2 * margin + 1, 24), dtype=np.float32)
    rows = np.linspace(0, reach, 8 * worker_count() + 1).astype(int).tolist()
    # Equal shares of the octant's triangle.
    shares = np.sqrt(np.linspace(0.0, 1.0, 8 * worker_count() + 1))
    outers = np.unique(np.rint(half * shares).astype(int)).tolist()
    for south in (False, True):

        def lay(bounds: tuple[int, int], south: bool = south) -> None:
            compiled_cube.polar_rings(grid, south, margin, *bounds, cap)

        def fill(bounds: tuple[int, int], south: bool = south) -> None:
            compiled_cube.polar_points(cap, rings, period, margin, south, table, *bounds, faces)

        _all(pool, lay, pairwise(rows))
        _all(pool, fill, pairwise(outers))
        report(progress, 0.8 + 0.2 * south, "filling the cube")
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


def _all(
    pool: ThreadPoolExecutor,
    work: Callable[[_Item], None],
    items: Iterable[_Item],
    progress: Progress | None = None,
    what: str = "",
) -> None:
    """Run ``work`` on every item in the pool; report and cancel between them."""
    futures = [pool.submit(work, item) for item in items]
    try:
        for done, future in enumerate(futures):
            future.result()
            report(progress, (done + 1) / len(futures), what)
    except BaseException:
        for future in futures:
            future.cancel()
        raise
