"""What flakes that can be counted are taken for, by every renderer: mirrors of aluminium, a little wavy.

A paint's flakes lie in many layers; countable are those that can be seen one by one (docs/method/sparkle.md).
"""

from __future__ import annotations

import math

from brdf_suite.documents.paint import Flakes

FLAKE_REFLECTANCE = 0.9
"""Of an aluminium flake, the usual one; published values of the metal are 0.87 to 0.92 over the visible."""
FLAKE_WAVINESS = 0.01
"""Radians: standard deviation of the tilt within one flake, which is no perfect mirror (docs/method/sparkle.md)."""
LARGEST_SHARE = 0.9
"""Of the base: finer flakes and pigment between them are never absent."""


def covered_share(flakes: Flakes) -> float:
    """Return the share of the surface, 0 to 1, that the countable flakes cover, overlapping at random."""
    millimetres = flakes.size_um * 1e-3
    return -math.expm1(-flakes.density_per_mm2 * math.pi / 4.0 * millimetres**2)
