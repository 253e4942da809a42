"""Model of the visible flakes shared by all renderers: slightly wavy aluminium mirrors.

A paint's flakes lie in many layers; visible are those that can be seen one by one (docs/method/sparkle.md).
"""

from __future__ import annotations

import math

from brdf_suite.documents.paint import Flakes

FLAKE_REFLECTANCE = 0.9
"""Of an aluminium flake, the most common kind; published values are 0.87 to 0.92 over the visible range."""
FLAKE_WAVINESS = 0.01
"""Radians: standard deviation of the tilt within one flake, which is no perfect mirror (docs/method/sparkle.md)."""
LARGEST_SHARE = 0.9
"""Of the base; the rest is finer flakes and pigment between them."""


def flake_coverage(flakes: Flakes) -> float:
    """Return the share of the surface, 0 to 1, that the visible flakes cover, overlapping at random."""
    millimetres = flakes.size_um * 1e-3
    return -math.expm1(-flakes.density_per_mm2 * math.pi / 4.0 * millimetres**2)
