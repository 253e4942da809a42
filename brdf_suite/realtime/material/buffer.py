"""Uniform block of a material's values that do not depend on N·V.

std140 with four-component members only, so no padding rules bite. The rest is the ramp
(:mod:`brdf_suite.realtime.material.ramp`).
"""

from __future__ import annotations

import numpy as np

from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime.material.ramp import MAX_BROAD, Ramp
from brdf_suite.realtime.values import MaterialWeights

_KINDS = {"none": 0, "dielectric": 1, "metal": 2, "facets": 3}


BLOCK_SIZE = (3 + MAX_BROAD) * 16
"""Bytes of the block ``Material`` in material.glsl."""


def pack(weights: MaterialWeights, ramp: Ramp) -> bytes:
    """Return the block: counts of look-ups, coat, the gloss lobes' albedo, the look-ups' directions."""
    block = np.zeros((3 + MAX_BROAD, 4), np.float32)
    counts = (ramp.base, ramp.base + ramp.coat, len(ramp.sharp), 0)
    block[0] = np.array(counts, np.int32).view(np.float32)
    reflected = float(fresnel_dielectric(np.cos(weights.theta_fit_rad), weights.ior))
    kind = _KINDS[weights.coat]
    if weights.coat in ("dielectric", "facets") and reflected < 1e-6:
        kind = _KINDS["none"]  # no interface: its ratios would be 0/0
    block[1] = (kind, weights.ior, 1.0 / max(reflected, 1e-6), 1.0 / (1.0 - reflected) ** 2)
    solid_angle = 2.0 * np.pi / (np.asarray(weights.exponents) + 1.0)
    albedo = solid_angle @ weights.kg
    block[2, :3] = albedo
    block[2, 3] = 1.0 / max(float(albedo.max()), 1e-6)
    block[3 : 3 + len(ramp.toward_normal)] = ramp.toward_normal
    return block.tobytes()
