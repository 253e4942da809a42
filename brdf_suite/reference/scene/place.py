"""Surface point met by a path: its position in millimetres, and the footprint of a pixel.

Flakes, relief and masks ask for it. A pixel's footprint is known for places that the camera sees directly; at all
others, seen in a reflection, it is not known, and what depends on it is shown in its mean.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.bsdfs.directions import TINY, Real, Vector, number
from brdf_suite.reference.mitsuba_modules import dr, mi

_SAME_DIRECTION = 1e-9
"""Squared distance of two unit directions that are one but for rounding: 0.002°."""


@dataclass(frozen=True, eq=False)
class Viewpoint:
    """Camera data for surface evaluation, in device memory, so that a change needs no recompilation."""

    eye: Any
    right: Any
    up: Any
    back: Any
    step: Any

    @classmethod
    def of(
        cls,
        place: npt.NDArray[np.float64],
        axes: npt.NDArray[np.float64],
        half_width_tangent: float,
        size: tuple[int, int],
    ) -> Viewpoint:
        """Return that of an eye (3,), right, up and backward as columns (3, 3), and a picture's width and height."""
        eye, right, up, back = (_point(column) for column in (place, *axes.T))
        return cls(eye, right, up, back, number(2.0 * half_width_tangent / size[0]))


@dataclass(frozen=True, eq=False)
class Place:
    """A surface point met by a path.

    Attributes
    ----------
    uv
        Lengths on the surface, millimetres.
    position
        Metres, world.
    along_u, along_v
        Unit directions in which u and v grow, local.
    across, down
        How uv changes from pixel to pixel, millimetres.
    seen
        Whether the camera sees the place directly; ``across`` and ``down`` hold there only.
    frame, side
        The surface's frame, and 1 or -1: the side that is met.
    """

    uv: Any
    position: Any
    along_u: Vector
    along_v: Vector
    across: Any
    down: Any
    seen: Any
    frame: Any
    side: Any

    @classmethod
    def of(cls, si: Any, side: Real, viewpoint: Viewpoint) -> Place:
        """Return the place of an interaction."""
        n = si.sh_frame.n
        # The gradients of u and v: across the lines of the other one, on the plane.
        du, dv = dr.cross(si.dp_dv, n), dr.cross(n, si.dp_du)
        long_u, long_v = dr.dot(du, si.dp_du), dr.dot(dv, si.dp_dv)
        du, dv = du / _off_zero(long_u), dv / _off_zero(long_v)
        to_eye = viewpoint.eye - si.p
        ray = -dr.normalize(to_eye)
        seen = dr.squared_norm(si.to_world(si.wi) + ray) < _SAME_DIRECTION
        depth = dr.dot(to_eye, viewpoint.back)
        forward = -to_eye / depth
        across, down = (
            _moved(axis, viewpoint.step * depth, forward, si.n) for axis in (viewpoint.right, -viewpoint.up)
        )
        local_u, local_v = si.sh_frame.to_local(du), si.sh_frame.to_local(dv)
        return cls(
            si.uv,
            si.p,
            _unit(local_u),
            _unit(local_v),
            mi.Vector2f(dr.dot(du, across), dr.dot(dv, across)),
            mi.Vector2f(dr.dot(du, down), dr.dot(dv, down)),
            seen,
            si.sh_frame,
            side,
        )

    def to_world(self, direction: Vector) -> Vector:
        """Return a direction of the side that is met in the world."""
        return self.frame.to_world(mi.Vector3f(direction.x, direction.y, direction.z * self.side))


def _moved(axis: Vector, length: Real, forward: Vector, normal: Vector) -> Vector:
    """Return the displacement on the plane for a ray displaced by ``length`` along ``axis`` at the place's depth."""
    along = dr.dot(axis, normal) / _off_zero(dr.dot(forward, normal))
    return length * (axis - forward * along)


def _off_zero(x: Real) -> Real:
    return dr.select(abs(x) < TINY, mi.Float(TINY), x)


def _unit(v: Vector) -> Vector:
    across = mi.Vector3f(v.x, v.y, 0.0)
    return across * dr.rsqrt(dr.maximum(dr.squared_norm(across), TINY))


def _point(values: npt.NDArray[np.float64]) -> Any:
    return mi.Vector3f(*(number(float(v)) for v in values))


def footprint_of_sample(pixel: float) -> float:
    """Return the reach of one sample, in pixels, so that samples even over a pixel make up a reach of ``pixel``.

    Standard deviations along an axis: that of an even pixel is 1/√12.

    >>> round(footprint_of_sample(0.5), 3)
    0.408
    """
    return math.sqrt(pixel * pixel - 1.0 / 12.0)
