"""Spherical harmonics of functions of the light's direction about the mirror direction of a view.

What a picture gathers at a pixel is ``∫ L(ω) T(ω) dω`` with T(ω) = f_r·(N·ω) for the pixel's view, and what it draws
instead is a sum of cosine lobes. The expected square of the difference, in light whose power per degree falls as it
does in pictures of surroundings (:func:`typical_power`, C_l), is

    Σ_l C_l Σ_m |t_lm - a_lm|²

with the coefficients t of T and a of the sum. Here are both, times √C_l, so that fitting lobes to T in that measure is
least squares of vectors. The axis is the mirror direction R: sharp lobes about it have the order m = 0 alone, and what
a facet model adds to them few more. All orders are taken up to degree 48, orders up to 4 beyond.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.special import sph_legendre_p_all

from brdf_suite.arrays import Floats
from brdf_suite.lighting.filter.harmonics import lobe_coefficients
from brdf_suite.lighting.filter.shading_table import typical_power

BROAD_DEGREES = 48
SHARP_DEGREES = 320
SHARP_ORDERS = 4
COAT_ORDERS = 24
"""Orders that a clearcoat's peak has, but for the narrow ellipse at grazing of one that is nearly smooth."""

#: Panels of rings about R: narrow where peaks are, then so that a sharp degree turns once in five rings, as far as
#: there is anything sharp; beyond, for the broad degrees.
_PEAK_EDGES = (0.0, 0.0015, 0.004, 0.01, 0.02)
_SHARP_EDGE, _SHARP_STEP = 0.65, 0.03
_BROAD_PANELS = 20
_POINTS = 5
#: Exponent from which on nothing sharp is expected: the sharp degrees are not constrained there.
_TAPER = (0.3, 0.6)
#: Angle from R, radians, below which nothing counts as away from it, and beyond which all does.
_AWAY = (np.radians(5.0), np.radians(15.0))


class MirrorHarmonics:
    """Rings about R with quadrature weights, and the transform from their values to coefficients.

    ``gamma`` (rings,) angles from R, ``azimuth`` (azimuths,) in 0 … π, from the normal's side; functions are even
    about the plane of incidence. Without ``sharp`` there are less than half the rings, and the broad degrees alone.
    ``orders`` is the highest that is looked at; there are a third more azimuths, 48 at most. ``away``: what lies about
    R is left out, with a smooth edge.
    """

    def __init__(self, sharp: bool = True, orders: int = BROAD_DEGREES, away: bool = False) -> None:
        edges = np.zeros(1)
        if sharp:
            fine = np.arange(_PEAK_EDGES[-1] + _SHARP_STEP, _SHARP_EDGE + 1e-9, _SHARP_STEP)
            edges = np.concatenate((_PEAK_EDGES, fine))
        edges = np.concatenate((edges, np.linspace(edges[-1], np.pi, _BROAD_PANELS + 1)[1:]))
        x, w = np.polynomial.legendre.leggauss(_POINTS)
        half = 0.5 * np.diff(edges)
        self.gamma: Floats = (edges[:-1, None] + half[:, None] * (1.0 + x)).ravel()
        azimuths = min(orders * 4 // 3, 48)
        self.azimuth: Floats = (np.arange(azimuths) + 0.5) * np.pi / azimuths
        area = (half[:, None] * w).ravel() * np.sin(self.gamma)
        self._away = away
        if away:
            share = np.clip((self.gamma - _AWAY[0]) / (_AWAY[1] - _AWAY[0]), 0.0, 1.0)
            area *= share * share * (3.0 - 2.0 * share)
        order = np.arange(orders + 1)
        norm = np.where(order == 0, 1.0, np.sqrt(2.0))
        self._cosines: Floats = np.cos(np.outer(self.azimuth, order)) * (2.0 * np.pi / azimuths * norm)
        power = np.sqrt(typical_power(SHARP_DEGREES))
        self._root_power: Floats = power
        broad = _legendre(BROAD_DEGREES, orders, self.gamma)
        broad = broad * area * power[: BROAD_DEGREES + 1, None, None]
        self._broad = [_some_rings(broad[m:, m]) for m in range(orders + 1)]
        self._norm = norm
        # There is no order beyond its degree.
        self._there = (np.arange(BROAD_DEGREES + 1)[:, None] >= order).ravel()
        near = _fading(self.gamma) if sharp else np.zeros(0)
        self._near = int(np.count_nonzero(near))
        self._sharp: Floats = np.zeros((0, 0, 0))
        if sharp:
            values = _legendre(SHARP_DEGREES, SHARP_ORDERS, self.gamma)[BROAD_DEGREES + 1 :]
            values = values * (area * near) * power[BROAD_DEGREES + 1 :, None, None]
            self._sharp = np.ascontiguousarray(values[..., : self._near].transpose(1, 0, 2))

    @property
    def shape(self) -> tuple[int, int]:
        """Rings and azimuths."""
        return len(self.gamma), len(self.azimuth)

    def lights(self, cosine: float) -> Floats:
        """Return the directions (rings, azimuths, 3) for a view at -x whose N·V is ``cosine``: R lies at +x."""
        sine = float(np.sqrt(max(1.0 - cosine * cosine, 0.0)))
        mirrored = np.array([sine, 0.0, cosine])
        towards_normal = np.array([-cosine, 0.0, sine])
        across = np.array([0.0, 1.0, 0.0])
        around = np.cos(self.azimuth)[:, None] * towards_normal + np.sin(self.azimuth)[:, None] * across
        return np.asarray(
            np.cos(self.gamma)[:, None, None] * mirrored + np.sin(self.gamma)[:, None, None] * around
        )

    def analyse(self, values: Floats) -> Floats:
        """Return the coefficients (n, k, c) of n functions' values (n, rings, azimuths, c), times √C_l.

        The first coefficient is that of the mean.
        """
        count, rings, _, channels = values.shape
        orders = np.einsum("ngac,am->mgnc", values, self._cosines, optimize=True)
        orders = orders.reshape(-1, rings, count * channels)
        broad = np.zeros((BROAD_DEGREES + 1, len(self._broad), count * channels))
        for order, (some, degrees) in enumerate(self._broad):
            broad[order:, order] = degrees @ orders[order, some]
        sharp = np.zeros((len(self._sharp), self._sharp.shape[1], count * channels))
        for order, degrees in enumerate(self._sharp):
            sharp[order] = degrees @ orders[order, : self._near]
        broad = broad.reshape(-1, count, channels)[self._there]
        found = np.concatenate((broad, sharp.reshape(-1, count, channels)))
        return np.ascontiguousarray(np.moveaxis(found, 1, 0))

    def lobes(self, towards_normal: Floats, exponents: Floats) -> Floats:
        """Return the coefficients (k, n) of unit-gain lobes of ``exponents`` (n,), times √C_l.

        ``towards_normal`` (n,): radians by which a lobe's direction is turned from R to the normal.
        """
        if self._away:
            along, across = np.cos(self.gamma)[:, None, None], np.sin(self.gamma)[:, None, None]
            cosine = along * np.cos(towards_normal)
            cosine = cosine + across * np.cos(self.azimuth)[:, None] * np.sin(towards_normal)
            values = (exponents + 1.0) / (2.0 * np.pi) * np.maximum(cosine, 0.0) ** exponents
            return np.asarray(self.analyse(np.where(values > 1e-100, values, 0.0)[None])[0])
        k = np.stack([lobe_coefficients(float(e), SHARP_DEGREES) for e in exponents], axis=-1)
        k *= self._root_power[:, None]
        angle = np.abs(towards_normal)
        # A direction beyond R lies at the azimuth π, where odd orders change their sign.
        sign = np.where(towards_normal[None] < 0.0, (-1.0) ** np.arange(len(self._norm))[:, None], 1.0)
        turned = sign * self._norm[:, None]
        broad = _legendre(BROAD_DEGREES, len(self._norm) - 1, angle) * turned * k[: BROAD_DEGREES + 1, None]
        count = len(exponents)
        if not self._near:
            return np.asarray(broad.reshape(-1, count)[self._there])
        sharp = _legendre(SHARP_DEGREES, SHARP_ORDERS, angle)[BROAD_DEGREES + 1 :]
        sharp = (sharp * turned[: SHARP_ORDERS + 1] * k[BROAD_DEGREES + 1 :, None]).transpose(1, 0, 2)
        return np.concatenate((broad.reshape(-1, count)[self._there], sharp.reshape(-1, count)))


@lru_cache(maxsize=4)
def mirror_harmonics(sharp: bool = True, orders: int = BROAD_DEGREES, away: bool = False) -> MirrorHarmonics:
    """Return the rings for what has sharp lobes, or has none; made when first asked for (0.1 s)."""
    return MirrorHarmonics(sharp, orders, away)


def _some_rings(values: Floats) -> tuple[slice, Floats]:
    """Return where on the rings values (degrees, rings) are not next to nothing, and those."""
    size = np.abs(values).max(axis=0)
    there = np.flatnonzero(size > 1e-9 * size.max())
    some = slice(int(there[0]), int(there[-1]) + 1)
    return some, np.ascontiguousarray(values[:, some])


def _fading(gamma: Floats) -> Floats:
    share = np.clip((gamma - _TAPER[0]) / (_TAPER[1] - _TAPER[0]), 0.0, 1.0)
    return np.asarray(0.5 + 0.5 * np.cos(np.pi * share)) * (share < 1.0)


def _legendre(degrees: int, orders: int, angles: Floats) -> Floats:
    """Return Y_lm(angle, 0) as (degrees + 1, orders + 1, angles)."""
    found = sph_legendre_p_all(degrees, orders, angles)
    return np.asarray(found[0, :, : orders + 1], np.float64)
