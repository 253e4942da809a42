"""Lobe weights as the uniform block that the shader reads, std140: vec4 only, so no padding rules bite."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime.values import MAX_LOBES, MaterialWeights

_KINDS = {"none": 0, "dielectric": 1, "metal": 2, "facets": 3}


BLOCK_SIZE = (3 + 2 * MAX_LOBES) * 16
"""Bytes of the block ``Material`` in material.glsl with room for the most lobes."""


@dataclass(frozen=True)
class PackedMaterial:
    """The block, :data:`BLOCK_SIZE` bytes, and which lobes of the basis its places stand for."""

    block: bytes
    lobes: tuple[int, ...]


def pack(weights: MaterialWeights) -> PackedMaterial:
    """Return the weights as float32 for the shader; lobes without any weight are left out.

    Weights are multiplied by the solid angle 2π/(E+1) of their lobe, so that they weigh unit-gain maps.
    """
    solid_angle = (2.0 * np.pi / (np.asarray(weights.exponents) + 1.0))[:, None]
    block = np.zeros((3 + 2 * MAX_LOBES, 4), np.float32)
    block[0, :3] = np.pi * weights.kd
    reflected = float(fresnel_dielectric(np.cos(weights.theta_fit_rad), weights.ior))
    kind = _KINDS[weights.coat]
    if weights.coat in ("dielectric", "facets") and reflected < 1e-6:
        kind = _KINDS["none"]  # no interface: its ratios would be 0/0
    block[1] = (kind, weights.ior, 1.0 / max(reflected, 1e-6), 1.0 / (1.0 - reflected) ** 2)
    albedo = (weights.kg * solid_angle).sum(axis=0)
    block[2, :3] = albedo
    block[2, 3] = 1.0 / max(float(albedo.max()), 1e-6)
    lobes = np.flatnonzero((weights.kdd > 0).any(axis=1) | (weights.kg > 0).any(axis=1))
    end = 3 + 2 * len(lobes)
    block[3:end:2, :3] = (weights.kdd * solid_angle)[lobes]
    block[4:end:2, :3] = (weights.kg * solid_angle)[lobes]
    return PackedMaterial(block.tobytes(), tuple(lobes.tolist()))
