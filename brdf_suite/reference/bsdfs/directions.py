"""Directions, Fresnel and sampling warps on arrays of the renderer, single precision; z is the normal.

The formulas are those of ``geometry.fresnel`` and ``geometry.warps``; here they are written for arrays that live where
the renderer computes. Angles are never taken from a cosine near 1, where single precision has no digits left: tan²θh
comes from the sum of two directions, and 1 - R·V from their difference.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from brdf_suite.reference.mitsuba_modules import dr, mi

Real = Any  # mi.Float of the variant that was chosen
Vector = Any  # mi.Vector3f
Square = Any  # mi.Point2f
Colour = Any  # mi.Color3f

TINY = 1e-20


def number(value: float) -> Real:
    """Return a number of a paint as one that the renderer reads from memory.

    Written into the program it would be recompiled for every paint; so, an edit takes milliseconds.
    """
    return dr.opaque(mi.Float, float(value))


def colour(values: Sequence[float]) -> Colour:
    """Return a colour of a paint, as :func:`number`."""
    return mi.Color3f(*(number(value) for value in values))


def fresnel(cosine: Real, ior: float) -> Real:
    """Return the share that a clear dielectric of index ``ior`` reflects; see :mod:`brdf_suite.geometry.fresnel`."""
    c = dr.clip(cosine, 0.0, 1.0)
    n, n2 = number(ior), number(1.0 / (ior * ior))
    t = dr.sqrt(dr.maximum(1.0 - dr.fma(-c, c, 1.0) * n2, 0.0))
    s = (c - n * t) / dr.maximum(c + n * t, TINY)
    p = (n * c - t) / dr.maximum(n * c + t, TINY)
    return 0.5 * (s * s + p * p)


def mirrored(direction: Vector) -> Vector:
    """Return the mirror direction about the normal."""
    return mi.Vector3f(-direction.x, -direction.y, direction.z)


def one_minus_mirror_cosine(light: Vector, view: Vector) -> Real:
    """Return 1 - R·V, exact also where the two are nearly the same."""
    return 0.5 * dr.squared_norm(mirrored(light) - view)


@dataclass(frozen=True)
class Half:
    """Terms of the half vector of two directions above the horizon: cos θd, cos θh, tan² θh."""

    cos_d: Real
    cos_h: Real
    tan2_h: Real

    @classmethod
    def of(cls, light: Vector, view: Vector) -> Half:
        """Return the terms of a pair."""
        total = light + view
        across = total.x * total.x + total.y * total.y
        up = dr.maximum(total.z * total.z, TINY)
        cos_d = dr.maximum(0.5 * dr.sqrt(across + up), 1e-10)
        return cls(cos_d, 0.5 * total.z / cos_d, across / up)


def beckmann_mirrored(view: Vector, u: Square, slope: float) -> Vector:
    """Return the view mirrored at facets whose normals are spread as a Beckmann surface of ``slope``."""
    return mirrored_at(view, number(-slope * slope) * dr.log(dr.maximum(1.0 - u.x, 1e-30)), u.y)


def mirrored_at(view: Vector, tan2: Real, turn: Real) -> Vector:
    """Return the view mirrored at half vectors of ``tan2`` θh, at a ``turn`` 0…1 about the normal."""
    cos_h = dr.rsqrt(1.0 + tan2)
    sin_h = dr.sqrt(tan2) * cos_h
    sine, cosine = dr.sincos(2.0 * math.pi * turn)
    half = mi.Vector3f(sin_h * cosine, sin_h * sine, cos_h)
    return dr.fma(2.0 * dr.dot(view, half), half, -view)


def beckmann_pdf(half: Half, slope: float) -> Real:
    """Return the density of :func:`beckmann_mirrored` per solid angle."""
    steep = 1.0 / (slope * slope)
    tan2 = half.tan2_h
    # D cosθh / (4 wo·h), with 1/cos⁴θh = (1 + tan²θh)².
    facets = dr.exp(-tan2 * number(steep)) * number(steep / math.pi) * dr.square(1.0 + tan2)
    return facets * half.cos_h / (4.0 * half.cos_d)


def lobe_about_mirror(view: Vector, u: Square, exponent: float) -> Vector:
    """Return directions of the cosine lobe of ``exponent`` about the view's mirror direction."""
    # The cosine is (1 - u)^(1/(E+1)); its complement is worked with, which has the digits.
    away = -exp_minus_one(dr.log(dr.maximum(1.0 - u.x, 1e-30)) * number(1.0 / (exponent + 1.0)))
    sine = dr.sqrt(dr.maximum(away * (2.0 - away), 0.0))
    y, x = dr.sincos(2.0 * math.pi * u.y)
    axis = mirrored(view)
    frame = mi.Frame3f(axis)
    return frame.to_world(mi.Vector3f(sine * x, sine * y, 1.0 - away))


def mirror_lobe(away: Real, exponent: float) -> Real:
    """Return (1 - ``away``)^E without loss for narrow lobes; 0 beyond a right angle."""
    inside = away < 1.0
    power = dr.exp(number(exponent) * log_one_plus(dr.select(inside, -away, 0.0)))
    return dr.select(inside, power, 0.0)


def slope_between(light: Vector, view: Vector, ior: float) -> Any:
    """Return the slope of the flake that mirrors one to the other; see ``flakes.tilt.flake_slope``."""
    n2 = number(ior * ior)
    up = dr.sqrt(n2 - (light.x**2 + light.y**2)) + dr.sqrt(n2 - (view.x**2 + view.y**2))
    return mi.Vector2f(light.x + view.x, light.y + view.y) / dr.maximum(up, 1e-6)


def log_one_plus(x: Real) -> Real:
    """Return ln(1 + x) for x > -1, exact to single precision also for small x."""
    # For small x the series; ln(1 + x) itself loses the digits of x.
    series = x * (1.0 - x * (0.5 - x * (1.0 / 3.0 - x * (0.25 - x * 0.2))))
    return dr.select(abs(x) < 0.02, series, dr.log(dr.maximum(1.0 + x, 1e-30)))


def exp_minus_one(x: Real) -> Real:
    """Return exp(x) - 1, exact to single precision also for small x; never infinite."""
    series = x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0))))
    return dr.select(abs(x) < 0.02, series, dr.exp(dr.minimum(x, 60.0)) - 1.0)


def luminance(colour: Colour) -> Real:
    """Return the luminance Y of the working space, to weigh samplers with."""
    return 0.2627 * colour.x + 0.678 * colour.y + 0.0593 * colour.z
