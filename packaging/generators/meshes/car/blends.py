"""Smooth building blocks: rounded polylines, blends of fields, rounded corners of outlines.

All are C-infinity or curvature-continuous, since a reflection shows a jump of curvature as a kink.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from brdf_suite.arrays import Floats

Field: TypeAlias = Callable[[Floats, Floats, Floats], Floats]
"""A scalar of position: f(x, y, z), arrays that broadcast, metres; negative inside."""


class SoftPolyline:
    """A function of one variable from a control polygon whose corners are rounded to hyperbolas.

    A corner at t₀ with change of slope s adds s·(t - t₀ + √((t - t₀)² + w²))/2: analytic everywhere,
    straight away from corners, with curvature s/(2w) at the corner itself. So a designer's curve keeps
    "accelerating" towards a corner and never wobbles, unlike an interpolating spline.

    Parameters
    ----------
    points
        (t, value) pairs, t increasing or decreasing; beyond both ends the end segments go on.
    rounding
        Width w in the unit of t, one number, or one per inner point.
    """

    def __init__(self, points: Sequence[tuple[float, float]], rounding: float | Sequence[float]) -> None:
        widths = np.array(np.broadcast_to(np.asarray(rounding, dtype=np.float64), (len(points) - 2,)))
        t, value = np.asarray(points, dtype=np.float64).T
        if t[0] > t[-1]:
            t, value, widths = t[::-1], value[::-1], widths[::-1]
        slope = np.diff(value) / np.diff(t)
        self._start, self._value, self._slope = float(t[0]), float(value[0]), float(slope[0])
        widths = np.broadcast_to(np.asarray(rounding, dtype=np.float64), (len(t) - 2,))
        self._corners = [
            (float(c), float(s), float(w)) for c, s, w in zip(t[1:-1], np.diff(slope), widths, strict=True)
        ]

    def __call__(self, t: Floats) -> Floats:
        """Return the value at ``t`` (any shape)."""
        result: Floats = self._value + self._slope * (t - self._start)
        for corner, change, width in self._corners:
            u = t - corner
            bent = np.asarray(u * u)
            bent += width * width
            np.sqrt(bent, out=bent)
            bent += u
            bent *= 0.5 * change
            result = result + bent
        return result


def smooth_max(a: Floats, b: Floats, width: float | Floats) -> Floats:
    """Return the greater of two fields, rounded where they differ by less than ``width`` (same unit).

    Curvature-continuous; for unit fields at a right angle the fillet's radius is about 0.57 ``width``.
    """
    overlap = np.maximum(width - np.abs(a - b), 0.0) / width
    some = overlap > 0.0
    overlap[some] **= 3  # few are, and powers take long
    result: Floats = np.maximum(a, b) + overlap * (width / 6.0)
    return result


def smooth_min(a: Floats, b: Floats, width: float | Floats) -> Floats:
    """Return the lesser of two fields, filleted; see :func:`smooth_max`."""
    return -smooth_max(-a, -b, width)


def rounded_max(radius: float, *terms: Floats) -> Floats:
    """Return the intersection of regions (negative inside) with corners rounded to ``radius``."""
    result = terms[0]
    for term in terms[1:]:
        outside = np.hypot(np.maximum(result + radius, 0.0), np.maximum(term + radius, 0.0))
        result = np.minimum(np.maximum(result, term), -radius) + outside
    return result


def bell(t: Floats, width: float) -> Floats:
    """Return exp(-(t/width)²): a swelling that fades without an edge."""
    result: Floats = np.exp(-((t / width) ** 2))
    return result


def ramp(t: Floats, start: float, end: float) -> Floats:
    """Return 0 before ``start``, 1 after ``end``, and between them a step with two continuous derivatives.

    ``start`` may be the greater one; then the ramp goes down.
    """
    u = np.clip((t - start) / (end - start), 0.0, 1.0)
    result: Floats = u * u * u * (u * (6.0 * u - 15.0) + 10.0)
    return result
