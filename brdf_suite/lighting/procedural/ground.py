"""The ground: a paved yard around the object, grass beyond it, fading into the horizon."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import edge, mix

_EYE_M = 1.0
_YARD_M, _YARD_EDGE_M = 11.0, 0.8
_SLAB_M = 3.0
# Albedos, given in Rec. 709 as references have them.
_PAVING = REC709_TO_WORKING @ [0.235, 0.230, 0.222]
_GRASS = REC709_TO_WORKING @ [0.072, 0.090, 0.042]


def ground_radiance(toward: Floats, light: Floats, haze: Floats) -> Floats:
    """Return the ground's radiance (..., 3) for directions below the horizon.

    Parameters
    ----------
    toward
        Unit directions (..., 3).
    light
        (3,) illuminance of the ground over π, working space.
    haze
        (..., 3) radiance of the horizon above each place.
    """
    down = np.maximum(-toward[..., 1], 1e-4)
    x, z = toward[..., 0] / down * _EYE_M, toward[..., 2] / down * _EYE_M
    distance = np.hypot(x, z)
    tone = 1.0 + 0.06 * np.sin(0.9 * x + 0.4 * z) * np.sin(0.7 * z - 0.3 * x) / (1.0 + 0.02 * distance**2)
    # Joints between slabs, which blur out with distance.
    fine = np.exp(-((distance / 5.0) ** 2))
    joint = np.maximum(_joint(x), _joint(z)) * fine
    paving = _PAVING * (tone * (1.0 - 0.35 * joint))[..., None]
    grass = _GRASS * (1.0 + 0.12 * np.sin(0.23 * x) * np.sin(0.31 * z))[..., None]
    albedo = mix(paving, grass, edge(distance - _YARD_M, _YARD_EDGE_M))
    far = 0.10 * (1.0 - np.exp(-distance / 400.0))
    return mix(albedo * light, haze, far)


def _joint(place: Floats) -> Floats:
    off = np.abs((place / _SLAB_M) % 1.0 - 0.5) * _SLAB_M
    return np.asarray(1.0 - edge(off - 0.012, 0.02))
