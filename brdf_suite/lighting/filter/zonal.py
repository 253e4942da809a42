"""Zonal harmonics of the cosine lobe: coefficients and their cut-off degree.

The unit-gain lobe ``(n+1)/(2π)·max(0, cosδ)^n`` is zonal, so convolving with it multiplies every coefficient
of degree l by ``k_l``, the lobe's Legendre coefficient ``(n+1)·∫₀¹ x^n P_l(x) dx``. Integrating by parts with
the recurrence of P_l gives ``k_0 = 1, k_1 = (n+1)/(n+2), k_l = k_(l-2)·(n-l+2)/(n+l+1)`` for any real n > -1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.filter.harmonics import MAX_BANDLIMIT

SIGMAS = 6.0
"""Bandlimit in units of √n: right to 1e-5 of the sky beside a sun 10⁵ times as bright."""

MIN_BANDLIMIT = 32
BROAD_BANDLIMIT = 255
"""Bandlimit of lobes with a slow tail (small n), and the most that the first, broad pass needs."""


def lobe_coefficients(exponent: float, bandlimit: int) -> NDArray[np.float64]:
    """Return k_l, l = 0…bandlimit, of the unit-gain cosine lobe.

    >>> lobe_coefficients(1.0, 2)
    array([1.        , 0.66666667, 0.25      ])
    """
    k = np.empty(bandlimit + 1)
    for start, first in ((0, 1.0), (1, (exponent + 1.0) / (exponent + 2.0))):
        degrees = np.arange(start + 2, bandlimit + 1, 2)
        ratios = (exponent - degrees + 2.0) / (exponent + degrees + 1.0)
        if start <= bandlimit:
            k[start::2] = first * np.concatenate([[1.0], np.cumprod(ratios)])
    return k


def lobe_bandlimit(exponent: float, tolerance: float = 1e-6) -> int:
    """Return the degree above which the lobe of an exponent is left out.

    6√n for sharp lobes. For small n the lobe has a kink at its rim, and its coefficients fall only like
    l^-(n+1.5): then the smallest degree whose whole tail, ``Σ (2l+1)/4π·|k_l|``, is below ``tolerance`` of
    the lobe's peak ``(n+1)/2π``, at most ``BROAD_BANDLIMIT``.
    """
    sharp = max(MIN_BANDLIMIT, int(np.ceil(SIGMAS * np.sqrt(exponent))))
    if sharp >= BROAD_BANDLIMIT:
        return sharp
    degrees = np.arange(4 * BROAD_BANDLIMIT)
    terms = (2.0 * degrees + 1.0) / (4.0 * np.pi) * np.abs(lobe_coefficients(exponent, degrees.size - 1))
    tail = np.cumsum(terms[::-1])[::-1]
    below = np.nonzero(tail[1:] <= tolerance * (exponent + 1.0) / (2.0 * np.pi))[0]
    by_tail = int(below[0]) if below.size else BROAD_BANDLIMIT
    return min(max(sharp, by_tail), BROAD_BANDLIMIT)


def largest_exponent(rings: int) -> float:
    """Return the largest exponent that a map of so many rings can be filtered with: √n = rings / 4.3.

    A sharper lobe lies between the rings: Fejér's rule no longer integrates it, and a constant environment
    would come out 1.6 % wrong at four times this exponent. The environment itself is then the better lobe
    map. The transforms end at a bandlimit of 2,048, which no exponent above 116,508 keeps within.
    """
    return min(float((rings / 4.3) ** 2), (MAX_BANDLIMIT / SIGMAS) ** 2)


def lobe_tail(exponent: float, bandlimit: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return angles (n,) 0…π and, at each, the unit-gain lobe minus its sum up to ``bandlimit``."""
    angles = np.linspace(0.0, np.pi, 24 * (bandlimit + 1))
    cosine = np.cos(angles)
    lobe = (exponent + 1.0) / (2.0 * np.pi) * np.maximum(cosine, 0.0) ** exponent
    terms = lobe_coefficients(exponent, bandlimit) * (2.0 * np.arange(bandlimit + 1) + 1.0) / (4.0 * np.pi)
    return angles, lobe - np.polynomial.legendre.legval(cosine, terms)
