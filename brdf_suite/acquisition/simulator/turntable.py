"""The turntable's reflection in the sphere's coat, which limits photographs to their upper half."""

from __future__ import annotations

import numpy as np

from brdf_suite.acquisition.simulator.lamp import SimulatedLamp
from brdf_suite.arrays import Floats

_BELOW_M = 0.15
_RADIUS_M = 0.6
_ALBEDO = 0.06
_INDEX = 1.5


def turntable_reflection(lamp: SimulatedLamp, points: Floats, normals: Floats, views: Floats) -> Floats:
    """Return the radiance (n,), over the lamp's strength, of a matt disc below the sphere mirrored in its coat."""
    cosines = np.einsum("ij,ij->i", normals, views)
    mirrored = 2.0 * cosines[:, None] * normals - views
    down = mirrored[:, 1] < -1e-6
    reach = np.where(down, (-_BELOW_M - points[:, 1]) / np.where(down, mirrored[:, 1], -1.0), 0.0)
    feet = points + reach[:, None] * mirrored
    seen = down & (np.hypot(feet[:, 0], feet[:, 2]) < _RADIUS_M)
    lights, relative = lamp.at(feet)
    radiance = _ALBEDO / np.pi * np.maximum(lights[:, 1], 0.0) * relative
    return np.where(seen, _fresnel(cosines) * radiance, 0.0)


def _fresnel(cosines: Floats) -> Floats:
    """Return Fresnel's reflectance of a clear coat for unpolarized light."""
    inside = np.sqrt(1.0 - (1.0 - cosines**2) / _INDEX**2)
    across = (cosines - _INDEX * inside) / (cosines + _INDEX * inside)
    along = (_INDEX * cosines - inside) / (_INDEX * cosines + inside)
    return 0.5 * (across**2 + along**2)
