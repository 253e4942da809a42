"""Colour differences between L*a*b* values."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.geometry.directions import Floats

_TWENTY_FIVE_7 = 25.0**7


def delta_e_2000(lab1: npt.ArrayLike, lab2: npt.ArrayLike) -> Floats:
    """Return CIEDE2000 (...) between L*a*b* arrays (..., 3) that broadcast; kL = kC = kH = 1.

    ISO/CIE 11664-6; the hue conventions are those of Sharma, Wu and Dalal 2005, equations 2 to 22.

    >>> round(float(delta_e_2000([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485])), 4)
    2.0425
    """
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
    swing = np.radians(30.0) * np.exp(-(((np.degrees(mean_h) - 275.0) / 25.0) ** 2))
    mean_c7 = mean_c**7
    rotation = -np.sin(2.0 * swing) * 2.0 * np.sqrt(mean_c7 / (mean_c7 + _TWENTY_FIVE_7))
    middle = (mean_l - 50.0) ** 2
    s_l = 1.0 + 0.015 * middle / np.sqrt(20.0 + middle)
    lightness = (l2 - l1) / s_l
    chroma = (c2 - c1) / (1.0 + 0.045 * mean_c)
    hue = delta_h / (1.0 + 0.015 * mean_c * t)
    squared = lightness**2 + chroma**2 + hue**2 + rotation * chroma * hue
    # The rotation term may leave a rounding error below zero where the colours are the same.
    return np.asarray(np.sqrt(np.maximum(squared, 0.0)))
