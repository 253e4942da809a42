"""The concentric map: squares about the middle of the unit square become circles about the disc's middle.

After Shirley and Chiu, "A Low Distortion Map between Disk and Square" (1997). The square is cut along its diagonals;
in each quarter the larger coordinate becomes the radius and the ratio of the two the azimuth, which keeps shares of
area: a region's share of the square is its share of the disc. Lambert's azimuthal equal-area projection takes the
disc on to the hemisphere, where r² = 1 - cosθ, so that equal areas of the square are equal solid angles:
2π sr times the share. Neighbours stay neighbours, and both maps can be turned back.

The square's +u is the x axis, its +v the y axis; (½, ½) is the normal.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats

_QUARTER = math.pi / 4.0


def square_to_hemisphere(u: npt.ArrayLike) -> Floats:
    """Return unit directions (..., 3) above the horizon for points ``u`` (..., 2) of the unit square.

    The square's edge is the horizon. A share s of the square has the solid angle 2π·s.
    """
    radius, azimuth = _polar(np.asarray(u, float))
    # sinθ = r √(2 - r²), from cosθ = 1 - r².
    along = radius * np.sqrt(np.maximum(2.0 - radius * radius, 0.0))
    return np.stack((along * np.cos(azimuth), along * np.sin(azimuth), 1.0 - radius * radius), axis=-1)


def hemisphere_to_square(w: npt.ArrayLike) -> Floats:
    """Return points (..., 2) of the unit square for unit directions ``w`` (..., 3) at or above the horizon."""
    x, y, z = np.moveaxis(np.asarray(w, float), -1, 0)
    # r = √(1 - cosθ) = sinθ/√(1 + cosθ), exact also beside the normal.
    return _from_polar(np.hypot(x, y) / np.sqrt(1.0 + np.maximum(z, 0.0)), x, y)


def _polar(u: Floats) -> tuple[Floats, Floats]:
    """Return the signed radius (...) and azimuth (...) of points of the square: equations of the paper's quarters."""
    a, b = 2.0 * u[..., 0] - 1.0, 2.0 * u[..., 1] - 1.0
    wide = np.abs(a) > np.abs(b)
    radius = np.where(wide, a, b)
    across = np.where(wide, b, a)
    safe = np.where(radius == 0.0, 1.0, radius)
    turn = _QUARTER * across / safe
    # A negative radius points the other way, so two quarters serve for four.
    return radius, np.where(wide, turn, 2.0 * _QUARTER - turn)


def _from_polar(radius: Floats, x: Floats, y: Floats) -> Floats:
    """Return points (..., 2) of the square for a radius (...) in 0…1 in the direction (x, y)."""
    wide = np.abs(x) > np.abs(y)
    main, across = np.where(wide, x, y), np.where(wide, y, x)
    long = np.copysign(radius, main)
    short = long * np.arctan2(across * np.sign(main), np.abs(main)) / _QUARTER
    a, b = np.where(wide, long, short), np.where(wide, short, long)
    return np.stack((0.5 * (a + 1.0), 0.5 * (b + 1.0)), axis=-1)
