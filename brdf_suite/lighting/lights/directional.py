"""Directional lights, each representing a cell of the sphere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError


@dataclass(frozen=True, eq=False)
class DirectionalLights:
    """Directional lights of an environment; reflected radiance is ``Σ_d f_r(ω_d, ω_o)·strength_d·max(0, N·ω_d)``.

    (Günther et al. 2005, equation 4.) The cells cover the sphere once; the strongest light comes first.

    Attributes
    ----------
    directions
        (l, 3) unit vectors towards the lights, world space.
    strengths
        (l, 3), ∫L dω over the light's cell: the irradiance on a surface that faces it, in the working space.
        Divided by the solid angle it is the cell's mean radiance.
    solid_angles
        (l,) steradians of the cells; they sum to 4π.

    Raises
    ------
    ValueRangeError
        The shapes do not belong together, or a value is not finite or negative where it may not be.
    """

    directions: Floats
    strengths: Floats
    solid_angles: Floats

    def __post_init__(self) -> None:
        count = len(self.solid_angles)
        for name, shape in (
            ("directions", (count, 3)),
            ("strengths", (count, 3)),
            ("solid_angles", (count,)),
        ):
            values = np.ascontiguousarray(getattr(self, name), dtype=np.float64)
            if values.shape != shape:
                raise ValueRangeError(name, f"must have the shape {shape}, not {values.shape}")
            if not np.isfinite(values).all() or (name != "directions" and values.min(initial=0.0) < 0.0):
                raise ValueRangeError(name, "must be finite, and never negative")
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        lengths = np.linalg.norm(self.directions, axis=1)
        if np.abs(lengths - 1.0).max(initial=0.0) > 1e-9:
            raise ValueRangeError("directions", "must have length 1")

    def __len__(self) -> int:
        return len(self.solid_angles)

    def brightest(self, count: int) -> DirectionalLights:
        """Return the ``count`` strongest lights; the others' light is left out."""
        return DirectionalLights(self.directions[:count], self.strengths[:count], self.solid_angles[:count])

    def turned(self, angle: float) -> DirectionalLights:
        """Return the lights turned by ``angle`` (radians) about +y, counter-clockwise seen from above."""
        cosine, sine = np.cos(angle), np.sin(angle)
        turn = np.array([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]])
        return DirectionalLights(self.directions @ turn.T, self.strengths, self.solid_angles)

    def irradiance(self, normals: Floats) -> Floats:
        """Return the irradiance (..., 3) on surfaces of unit ``normals`` (..., 3)."""
        return np.asarray(np.maximum(normals @ self.directions.T, 0.0) @ self.strengths)
