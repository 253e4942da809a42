"""The camera: its rays through pixels, and the spacing of neighbouring ones on a surface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Real, Vector
from brdf_suite.reference.mitsuba_modules import dr, mi


@dataclass(frozen=True, eq=False)
class PinholeCamera:
    """A pinhole: its place (3,), right, up and backward axes as columns (3, 3), tangent of half the width.

    Or a thin lens: ``aperture`` is the radius of its opening, ``focus`` the distance of the sharp plane, metres.
    """

    place: npt.NDArray[np.float64]
    axes: npt.NDArray[np.float64]
    half_width_tangent: float
    aperture: float = 0.0
    focus: float = 1.0


@dataclass(frozen=True, eq=False)
class Pinhole:
    """An eye and its picture size in device memory, so that a change needs no recompilation."""

    place: Vector
    right: Vector
    up: Vector
    ahead: Vector
    width: Any
    height: Any

    @classmethod
    def of(cls, eye: PinholeCamera, size: tuple[int, int]) -> Pinhole:
        """Return the pinhole; ``right`` and ``up`` are half a pixel long at the distance 1."""
        half = eye.half_width_tangent / size[0]
        place, right, up, ahead = (
            mi.Vector3f(*(d.number(float(x)) for x in v))
            for v in (eye.place, half * eye.axes[:, 0], half * eye.axes[:, 1], -eye.axes[:, 2])
        )
        return cls(place, right, up, ahead, *(dr.opaque(mi.UInt32, n) for n in size))

    def ray(self, column: Any, row: Any, within: Any) -> tuple[Vector, Vector]:
        """Return origin and unit direction through places ``within`` (0, 1)² of pixels."""
        x = 2.0 * (mi.Float(column) + within.x) - mi.Float(self.width)
        y = mi.Float(self.height) - 2.0 * (mi.Float(row) + within.y)
        return self.place, dr.normalize(self.ahead + x * self.right + y * self.up)

    def footprint(self, direction: Vector, far: Real, flat: Vector) -> tuple[Vector, Vector]:
        """Return how the place on a plane of normal ``flat`` changes from pixel to pixel, across and down, metres."""
        long = far * dr.dot(direction, self.ahead)

        def moved(by: Vector) -> Vector:
            # The ray to the next pixel meets the plane where the part along the normal is the same.
            facing = dr.dot(direction, flat)
            facing = dr.select(dr.abs(facing) < 1e-4, dr.copysign(1e-4, facing), facing)
            step = long * by
            return step - direction * (dr.dot(step, flat) / facing)

        return moved(2.0 * self.right), moved(-2.0 * self.up)
