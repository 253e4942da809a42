"""Samplers for a reflectance known by its values only: a fitted mixture of diffuse and fixed-slope facets."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import nnls

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.reference.bsdfs.terms import Diffuse, Facets, Sampler
from brdf_suite.reflectance.protocol import Reflectance

SLOPES = (0.004, 0.012, 0.035, 0.1, 0.25, 0.6)
LEAST_MATT = 0.08
_VIEWS_DEG = (15.0, 45.0, 70.0)
_PER_PART = 400


def fitted_samplers(reflectance: Reflectance, seed: int = 1) -> tuple[Sampler, ...]:
    """Return samplers whose mixture follows f_r cosθ of ``reflectance`` for views of some polar angles.

    The shares are non-negative least squares of the luminance over directions drawn from all parts, each weighed by one
    over the density, so that bright and dim parts of the light count alike. Some matt is always in it.
    """
    rng = np.random.default_rng(seed)
    rows, wanted = [], []
    for theta_deg in _VIEWS_DEG:
        view = spherical(math.radians(theta_deg), 0.0)[None]
        drawn = [warps.cosine_hemisphere(rng.random((_PER_PART, 2)))]
        drawn += [warps.mirror_at(view, warps.beckmann_normal(rng.random((_PER_PART, 2)), m)) for m in SLOPES]
        light = np.concatenate(drawn)
        light = light[light[:, 2] > 1e-3]
        views = np.broadcast_to(view, light.shape)
        half = warps.half_vector(light, views)
        parts = [warps.cosine_hemisphere_pdf(light)]
        parts += [warps.mirrored_pdf(warps.beckmann_normal_pdf(half, m), views, half) for m in SLOPES]
        densities = np.stack(parts, axis=1)
        value = reflectance.eval(light, views) @ LUMINANCE * light[:, 2]
        weight = 1.0 / np.sqrt(densities.mean(axis=1) * (densities.mean(axis=1) + value.mean()))
        rows.append(densities * weight[:, None])
        wanted.append(value * weight)
    shares, _ = nnls(np.concatenate(rows), np.concatenate(wanted))
    total = float(shares.sum()) or 1.0
    facets = [
        Facets(float(share) / total, slope)
        for share, slope in zip(shares[1:], SLOPES, strict=True)
        if share > 1e-3 * total
    ]
    return (Diffuse(max(float(shares[0]) / total, LEAST_MATT)), *facets)
