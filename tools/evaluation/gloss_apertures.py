"""Gloss by the apertures of ISO 2813 and ASTM D523, integrated over source and receptor one by one.

It shares no step with the virtual glossmeter: rectangles are those of plane stops behind lenses, the source is
sampled, and for each of its directions the receptor is integrated about that direction's own mirror direction, from
which its edges lie differently far on the four sides::

    GU = 100 Σs ∫ f_r cosθo dωo / Σs F(θs; 1.567)
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.protocol import Reflectance

_RECEPTOR_DEG = {20: (1.8, 3.6), 60: (4.4, 11.7), 85: (4.0, 6.0)}
_SOURCE_DEG = (0.75, 2.5)
_GLASS = 1.567
_FINEST = 5e-5


def aperture_gloss(reflectance: Reflectance, angle_deg: int, nodes: int = 5) -> float:
    """Return the gloss units at 20, 60 or 85°, from ``nodes`` × ``nodes`` directions of the source."""
    receptor, source = (
        [math.tan(math.radians(0.5 * width)) for width in widths]
        for widths in (_RECEPTOR_DEG[angle_deg], _SOURCE_DEG)
    )
    x, weight = np.polynomial.legendre.leggauss(nodes)
    flux = glass = 0.0
    for i in range(nodes):
        for j in range(nodes):
            p, q = source[0] * x[i], source[1] * x[j]
            mirrored = _direction(angle_deg, p, q)
            light = mirrored * (-1.0, -1.0, 1.0)
            (a, da), (b, db) = _side(receptor[0], p, nodes), _side(receptor[1], q, nodes)
            views = _direction(angle_deg, a[:, None], b[None, :])
            # A plane's element at distance 1 spans dA / (1 + a² + b²)^(3/2).
            solid = np.outer(da, db) * (1.0 + a[:, None] ** 2 + b[None, :] ** 2) ** -1.5
            values = reflectance.eval(light, views) @ LUMINANCE
            # Likewise for the source.
            share = weight[i] * weight[j] * (1.0 + p * p + q * q) ** -1.5
            flux += share * float(np.sum(solid * np.maximum(views[..., 2], 0.0) * values))
            glass += share * float(fresnel_dielectric(light[2], _GLASS))
    return float(100.0 * flux / glass)


def _direction(angle_deg: int, a: npt.ArrayLike, b: npt.ArrayLike) -> Floats:
    """Return unit directions (..., 3) through the point (a, b) of a plane at distance 1 across the mirror direction."""
    theta = math.radians(angle_deg)
    a, b = np.broadcast_arrays(np.asarray(a, float), np.asarray(b, float))
    across = (np.sin(theta) + a * np.cos(theta), b, np.cos(theta) - a * np.sin(theta))
    found = np.stack(across, axis=-1)
    return np.asarray(found / np.linalg.norm(found, axis=-1, keepdims=True))


def _side(half: float, centre: float, nodes: int) -> tuple[Floats, Floats]:
    """Return points and weights from -half to half, ever denser towards ``centre`` on both sides of it."""
    x, weight = np.polynomial.legendre.leggauss(nodes)
    points: list[Floats] = []
    weights: list[Floats] = []
    for end in (-half, half):
        edges = [end]
        while abs(edges[-1] - centre) > 2.0 * _FINEST:
            edges.append(centre + (edges[-1] - centre) / 2.0)
        edges.append(centre)
        for low, high in zip(edges[1:], edges[:-1], strict=True):
            points.append(0.5 * (low + high) + 0.5 * (high - low) * x)
            weights.append(0.5 * abs(high - low) * weight)
    return np.concatenate(points), np.concatenate(weights)
