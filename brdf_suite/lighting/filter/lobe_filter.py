"""Harmonics of one environment, and cosine lobes convolved with it."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.filter.harmonics import (
    BROAD_BANDLIMIT,
    analyse,
    coated_coefficients,
    coated_tail,
    largest_exponent,
    lobe_bandlimit,
    lobe_coefficients,
    lobe_tail,
    synthesise,
    worker_count,
)
from brdf_suite.lighting.filter.kernels.compilation import kernels
from brdf_suite.lighting.filter.ring_to_cube import cube_from_rings, rings_for
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles, sample
from brdf_suite.progress import Progress, subrange

_BRIGHT_TEXELS = 16
_MIN_RINGS = 256
_LINES = 32  # rings, and lines of the environment's own faces, at once
_WAIT_RINGS = 2048  # maps that are worth waiting for the kernels


class LobeFilter:
    """Convolves an environment (h, w, 3) with cosine lobes of unit gain, in float64.

    The environment is taken as what its texels' centres say, weighted by Fejér's rule in latitude: constant
    light comes out constant. Maps of fewer than 256 rings are first enlarged, because a broad lobe needs that
    many.

    Lobes are cut off at the degree of :func:`brdf_suite.lighting.filter.harmonics.lobe_bandlimit`. Where that is cut
    short (exponents below about 8, whose rim is a kink) the tail of the 16 strongest texels is added
    directly.

    Kernels compiled by :mod:`brdf_suite.lighting.filter.kernels.compilation` do the work where they are available,
    plain numpy where they are not or ``plain`` asks for it. A large map waits for them (``progress`` says so): they
    take less memory, too.
    """

    def __init__(
        self, radiance: NDArray[np.float32], progress: Progress | None = None, *, plain: bool = False
    ) -> None:
        self._radiance = radiance
        self._pixels = _enlarge(radiance)
        self.rings: int = self._pixels.shape[0]
        self._theta = ring_angles(self.rings)
        self._weights = fejer_weights(self.rings)
        self._bright: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
        self._coefficients: NDArray[np.complex128] | None = None
        self._bandlimit = -1
        self._kernels = None if plain else kernels(progress, wait=self.rings >= _WAIT_RINGS)

    @property
    def largest_exponent(self) -> float:
        """The sharpest lobe that this map can be filtered with."""
        return largest_exponent(self.rings)

    @property
    def compiled(self) -> bool:
        """Whether compiled kernels do the work: then one analysis of all degrees is the shortest way."""
        return self._kernels is not None

    @property
    def bandlimit(self) -> int:
        """The degree up to which the environment has been analysed, -1 before that."""
        return self._bandlimit

    def analyse(self, bandlimit: int, progress: Progress | None = None) -> None:
        """Analyse the environment up to a degree, where that has not been done."""
        if bandlimit <= self.bandlimit:
            return
        if self._kernels is not None:
            self._coefficients = self._kernels.analyse(self._pixels, self._weights, bandlimit, progress)
        else:
            orders = self._orders(bandlimit)
            self._coefficients = analyse(orders, self._weights, np.cos(self._theta), bandlimit, progress)
        self._bandlimit = bandlimit

    def lobe(
        self,
        exponent: float,
        size: int,
        progress: Progress | None = None,
        room: NDArray[np.float32] | None = None,
    ) -> NDArray[np.float32] | NDArray[np.float64]:
        """Return the lobe map (6, size, size, 3), not clipped; large ones, and those of kernels, are float32.

        Compiled kernels put it into ``room`` (≥ 18·size²,) where that is given.
        """
        if not 0.0 <= exponent <= self.largest_exponent:
            limit = self.largest_exponent
            raise ValueError(f"the exponent must be 0…{limit:.0f} for {self.rings} rings, not {exponent}")
        bandlimit = lobe_bandlimit(exponent)
        faces = self._convolved(lobe_coefficients(exponent, bandlimit), size, progress, room)
        if bandlimit == BROAD_BANDLIMIT and exponent < BROAD_BANDLIMIT / 8.0:
            faces += self._bright_tail(lobe_tail(exponent, bandlimit), size)
        return faces

    def through_coat(
        self, size: int, room: NDArray[np.float32] | None = None
    ) -> NDArray[np.float32] | NDArray[np.float64]:
        """Return the map of diffuse light through a coat (6, size, size, 3); ``room`` as for :meth:`lobe`."""
        faces = self._convolved(coated_coefficients(BROAD_BANDLIMIT), size, None, room)
        faces += self._bright_tail(coated_tail(BROAD_BANDLIMIT), size)
        return faces

    def _convolved(
        self,
        gains: Floats,
        size: int,
        progress: Progress | None,
        room: NDArray[np.float32] | None,
    ) -> NDArray[np.float32] | NDArray[np.float64]:
        """Return the environment times ``gains`` (l,) at each degree, (6, size, size, 3)."""
        bandlimit = len(gains) - 1
        self.analyse(bandlimit, subrange(progress, 0.0, 0.5))
        assert self._coefficients is not None
        faces: NDArray[np.float32] | NDArray[np.float64]
        if self._kernels is not None:
            faces = self._kernels.cube(self._coefficients, gains, size, subrange(progress, 0.5, 1.0), room)
        else:
            degree = np.arange(bandlimit + 1)
            total = degree[:, None] + degree[None, :]
            of_total = np.where(total <= bandlimit, gains[np.minimum(total, bandlimit)], 0.0)
            scaled = self._coefficients[: bandlimit + 1, : bandlimit + 1] * of_total[:, :, None]
            cosines = np.cos(ring_angles(rings_for(bandlimit)))
            faces = cube_from_rings(synthesise(scaled, cosines, subrange(progress, 0.5, 0.9)), size)
        return faces

    def background(self, size: int, room: NDArray[np.float32] | None = None) -> NDArray[np.float32]:
        """Return the environment itself as a cube map (6, size, size, 3); ``room`` as for :meth:`lobe`."""
        if self._kernels is not None:
            faces: NDArray[np.float32] = self._kernels.resample_to_cube(self._radiance, size, room)
            return faces
        towards = texel_directions(size).reshape(-1, size, 3)
        faces = np.empty(towards.shape, np.float32)

        def fill(first: int) -> None:
            lines = slice(first, first + _LINES)
            faces[lines] = sample(self._radiance, towards[lines])

        with ThreadPoolExecutor(worker_count()) as pool:
            list(pool.map(fill, range(0, len(towards), _LINES)))
        return faces.reshape(6, size, size, 3)

    def _orders(self, bandlimit: int) -> NDArray[np.complex128]:
        """Return F_m (rings, bandlimit+1, 3); orders above half the columns repeat, as those of points do."""
        columns = self._pixels.shape[1]
        m = np.arange(bandlimit + 1)
        folded = m % columns
        mirrored = folded > columns // 2
        source = np.where(mirrored, columns - folded, folded)
        turned = np.exp(-1j * m * column_angles(columns)[0])[:, None] / columns
        orders = np.empty((self.rings, bandlimit + 1, 3), dtype=np.complex128)

        def fill(first: int) -> None:
            # A few rings at a time: large maps shall not need much memory beside them.
            lines = slice(first, first + _LINES)
            values = np.fft.rfft(self._pixels[lines].astype(np.float64), axis=1)[:, source]
            values[:, mirrored] = values[:, mirrored].conj()
            np.multiply(values, turned, out=orders[lines])

        with ThreadPoolExecutor(worker_count()) as pool:
            list(pool.map(fill, range(0, self.rings, _LINES)))
        return orders

    def _bright_tail(self, left_out: tuple[Floats, Floats], size: int) -> NDArray[np.float64]:
        """Return what the cut-off left out of the brightest texels' light, (6, size, size, 3)."""
        towards, flux = self._brightest()
        angles, tail = left_out
        texels = texel_directions(size).reshape(-1, 3)
        between = np.arccos(np.clip(texels @ towards.T, -1.0, 1.0))
        # The angles are evenly spaced: no search for the two beside each.
        steps = between * ((angles.size - 1) / np.pi)
        below = np.minimum(steps.astype(np.int64), angles.size - 2)
        values = tail[below] + (steps - below) * np.diff(tail)[below]
        added: NDArray[np.float64] = values @ flux
        return added.reshape(6, size, size, 3)

    def _brightest(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return directions (n, 3) and flux (n, 3) of the brightest texels."""
        if self._bright is None:
            columns = self._pixels.shape[1]
            strongest = np.maximum(
                np.maximum(self._pixels[..., 0], self._pixels[..., 1]), self._pixels[..., 2]
            )
            strength = strongest * self._weights[:, None].astype(np.float32)
            count = min(_BRIGHT_TEXELS, strength.size - 1)
            chosen = np.argpartition(strength.ravel(), -count)[-count:]
            rows, places = np.divmod(chosen, columns)
            towards = direction(self._theta[rows], column_angles(columns)[places])
            flux = self._pixels[rows, places] * (self._weights[rows] * (2.0 * np.pi / columns))[:, None]
            self._bright = towards, flux
        return self._bright


def ring_count(height: int) -> int:
    """Return the number of rings that a map of so many rows is filtered with: a multiple of at least 256."""
    return height if height >= _MIN_RINGS else height * -(-_MIN_RINGS // height)


def _enlarge(radiance: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the map with at least 256 rings, by bilinear interpolation where it has fewer."""
    rings = ring_count(radiance.shape[0])
    if rings == radiance.shape[0]:
        return radiance
    theta, phi = ring_angles(rings)[:, None], column_angles(2 * rings)[None, :]
    return sample(radiance, direction(theta, phi))
