"""Lobe weights as the uniform block that the shader reads, std140: vec4 only, so no padding rules bite."""

from __future__ import annotations

import numpy as np

from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime.values import MaterialWeights

_KINDS = {"none": 0, "dielectric": 1, "metal": 2}


def block_size(lobes: int) -> int:
    """Return the bytes of the block ``Material`` in material.glsl for so many lobes."""
    return (3 + 2 * lobes) * 16


def pack(weights: MaterialWeights) -> bytes:
    """Return the block of :func:`block_size` bytes, float32.

    Weights are multiplied by the solid angle 2π/(E+1) of their lobe, so that they weigh unit-gain maps.
    """
    lobes = len(weights.exponents)
    solid_angle = (2.0 * np.pi / (np.asarray(weights.exponents) + 1.0))[:, None]
    block = np.zeros((3 + 2 * lobes, 4), np.float32)
    block[0, :3] = np.pi * weights.kd
    reflected = float(fresnel_dielectric(np.cos(weights.theta_fit_rad), weights.ior))
    kind = _KINDS[weights.coat]
    if kind == _KINDS["dielectric"] and reflected < 1e-6:
        kind = _KINDS["none"]  # no interface: its ratios would be 0/0
    block[1] = (kind, weights.ior, 1.0 / max(reflected, 1e-6), 1.0 / (1.0 - reflected) ** 2)
    albedo = (weights.kg * solid_angle).sum(axis=0)
    block[2, :3] = albedo
    block[2, 3] = 1.0 / max(float(albedo.max()), 1e-6)
    block[3 : 3 + lobes, :3] = weights.kdd * solid_angle
    block[3 + lobes :, :3] = weights.kg * solid_angle
    block[3:, 3] = block[3:, :3].max(axis=1)
    return block.tobytes()
