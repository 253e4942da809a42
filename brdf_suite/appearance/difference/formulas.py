"""Colour differences between L*a*b* values."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

_TWENTY_FIVE_7 = 25.0**7


def delta_e_76(lab1: npt.ArrayLike, lab2: npt.ArrayLike) -> Floats:
    """Return ΔE*ab (...) of CIE 1976, the distance in L*a*b*; arrays (..., 3) broadcast.

    >>> float(delta_e_76([50.0, 3.0, 0.0], [50.0, 0.0, 4.0]))
    5.0
    """
    difference = np.asarray(lab1, float) - np.asarray(lab2, float)
    return np.asarray(np.sqrt(np.einsum("...i,...i", difference, difference)))


def delta_e_cmc(
    reference: npt.ArrayLike, sample: npt.ArrayLike, lightness: float = 2.0, chroma: float = 1.0
) -> Floats:
    """Return ΔE CMC(l:c) (...) of samples against references, L*a*b* (..., 3) that broadcast.

    The weights come from the reference alone, so it is not symmetric. CMC(2:1) judges acceptability, CMC(1:1)
    perceptibility (Clarke, McDonald and Rigg 1984; BS 6923).
    """
    if not (lightness > 0.0 and chroma > 0.0):
        raise ValueRangeError("lightness:chroma", f"CMC({lightness:g}:{chroma:g}) needs two positive weights")
    first, second = np.asarray(reference, float), np.asarray(sample, float)
    l1, a1, b1 = first[..., 0], first[..., 1], first[..., 2]
    delta_l, delta_a, delta_b = (second[..., i] - first[..., i] for i in range(3))
    c1 = np.hypot(a1, b1)
    delta_c = np.hypot(second[..., 1], second[..., 2]) - c1
    delta_h2 = np.maximum(delta_a**2 + delta_b**2 - delta_c**2, 0.0)
    hue = np.degrees(np.arctan2(b1, a1)) % 360.0
    blue_side = (hue >= 164.0) & (hue <= 345.0)
    t = np.where(
        blue_side,
        0.56 + np.abs(0.2 * np.cos(np.radians(hue + 168.0))),
        0.36 + np.abs(0.4 * np.cos(np.radians(hue + 35.0))),
    )
    c4 = c1**4
    f = np.sqrt(c4 / (c4 + 1900.0))
    s_l = np.where(l1 < 16.0, 0.511, 0.040975 * l1 / (1.0 + 0.01765 * l1))
    s_c = 0.0638 * c1 / (1.0 + 0.0131 * c1) + 0.638
    s_h = s_c * (f * t + 1.0 - f)
    squared = (delta_l / (lightness * s_l)) ** 2 + (delta_c / (chroma * s_c)) ** 2 + delta_h2 / s_h**2
    return np.asarray(np.sqrt(squared))


def delta_e_2000(lab1: npt.ArrayLike, lab2: npt.ArrayLike) -> Floats:
    """Return CIEDE2000 (...) between L*a*b* arrays (..., 3) that broadcast; kL = kC = kH = 1.

    ISO/CIE 11664-6; the hue conventions are those of Sharma, Wu and Dalal 2005, equations 2 to 22.

    >>> round(float(delta_e_2000([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485])), 4)
    2.0425
    """
    lightness, chroma, hue, weights, mean_c, mean_h = _terms_2000(lab1, lab2)
    lightness, chroma, hue = lightness / weights[0], chroma / weights[1], hue / weights[2]
    swing = np.radians(30.0) * np.exp(-(((np.degrees(mean_h) - 275.0) / 25.0) ** 2))
    mean_c7 = mean_c**7
    rotation = -np.sin(2.0 * swing) * 2.0 * np.sqrt(mean_c7 / (mean_c7 + _TWENTY_FIVE_7))
    squared = lightness**2 + chroma**2 + hue**2 + rotation * chroma * hue
    # The rotation term may leave a rounding error below zero where the colours are the same.
    return np.asarray(np.sqrt(np.maximum(squared, 0.0)))


def weights_2000(lab1: npt.ArrayLike, lab2: npt.ArrayLike) -> Floats:
    """Return S_L, S_C and S_H (..., 3) of CIEDE2000 between L*a*b* arrays (..., 3) that broadcast.

    What a difference of lightness, chroma or hue is divided by, so that 1 of each is about alike to the eye.

    >>> weights_2000([50.0, 0.0, 0.0], [50.0, 0.0, 0.0]).tolist()
    [1.0, 1.0, 1.0]
    """
    return np.stack(np.broadcast_arrays(*_terms_2000(lab1, lab2)[3]), axis=-1)


def _terms_2000(
    lab1: npt.ArrayLike, lab2: npt.ArrayLike
) -> tuple[Floats, Floats, Floats, tuple[Floats, Floats, Floats], Floats, Floats]:
    """Return ΔL', ΔC', ΔH', their weights, and the means of C' and of h' (radians)."""
    first, second = np.asarray(lab1, float), np.asarray(lab2, float)
    l1, a1, b1 = first[..., 0], first[..., 1], first[..., 2]
    l2, a2, b2 = second[..., 0], second[..., 1], second[..., 2]

    chroma7 = (0.5 * (np.hypot(a1, b1) + np.hypot(a2, b2))) ** 7
    stretch = 1.5 - 0.5 * np.sqrt(chroma7 / (chroma7 + _TWENTY_FIVE_7))
    a1, a2 = a1 * stretch, a2 * stretch
    c1, c2 = np.hypot(a1, b1), np.hypot(a2, b2)
    h1, h2 = np.arctan2(b1, a1) % (2.0 * np.pi), np.arctan2(b2, a2) % (2.0 * np.pi)

    grey = c1 * c2 == 0.0
    turn = h2 - h1
    turn = np.where(turn > np.pi, turn - 2.0 * np.pi, np.where(turn < -np.pi, turn + 2.0 * np.pi, turn))
    delta_h = 2.0 * np.sqrt(c1 * c2) * np.sin(0.5 * np.where(grey, 0.0, turn))
    total = h1 + h2
    far = np.abs(h1 - h2) > np.pi
    mean_h = 0.5 * np.where(
        far, np.where(total < 2.0 * np.pi, total + 2.0 * np.pi, total - 2.0 * np.pi), total
    )
    mean_h = np.where(grey, total, mean_h)

    mean_l, mean_c = 0.5 * (l1 + l2), 0.5 * (c1 + c2)
    t = (
        1.0
        - 0.17 * np.cos(mean_h - np.radians(30.0))
        + 0.24 * np.cos(2.0 * mean_h)
        + 0.32 * np.cos(3.0 * mean_h + np.radians(6.0))
        - 0.20 * np.cos(4.0 * mean_h - np.radians(63.0))
    )
    middle = (mean_l - 50.0) ** 2
    s_l = 1.0 + 0.015 * middle / np.sqrt(20.0 + middle)
    weights = (np.asarray(s_l), np.asarray(1.0 + 0.045 * mean_c), np.asarray(1.0 + 0.015 * mean_c * t))
    return np.asarray(l2 - l1), np.asarray(c2 - c1), np.asarray(delta_h), weights, mean_c, mean_h
