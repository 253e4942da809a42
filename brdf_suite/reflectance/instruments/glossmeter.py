"""Virtual glossmeter: the flux of any reflectance in the standard's receptor at 20, 60 or 85°.

A reading compares flux in the receptor with that of polished black glass (see
:mod:`brdf_suite.appearance.clearcoat_gloss`):

    GU = 100 / F(θ; 1.567) · ∫ f_r cosθo W dω,

weighted by luminance. W is 1 in the mirror direction and falls off at the receptor's edges: the receptor's box, blurred
by a source of variance s²/12 in each direction, the very instrument that the formulas for a coat assume; so the two
agree but for what those formulas leave out (shadowing, the change of Fresnel's factor over the lobe).

The mirror lobe of a clearcoat is a thousand times narrower than the receptor. Both axes, in the plane of incidence and
across it, are therefore cut into panels that halve towards the mirror direction, with four Gauss points in each:
a lobe of any width between a tenth of a milliradian and the receptor is met.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from brdf_suite.appearance.clearcoat_gloss import (
    RECEPTORS_DEG,
    SOURCE_DEG,
    black_glass,
    gloss_units,
    receptor_deg,
)
from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.protocol import Reflectance

GLOSS_ANGLES_DEG: tuple[int, ...] = tuple(RECEPTORS_DEG)

_FIRST_PANEL = 1e-4
_POINTS = 4
# Where the blurred edge of the receptor has fallen to nothing, in standard deviations of the blur.
_EDGE_REACH = 5.0
_PANEL_PER_BLUR = 1.5
_ERF = np.vectorize(math.erf, otypes=[float])


def gloss_reading(reflectance: Reflectance, angle_deg: int) -> float:
    """Return the gloss units of a whole reflectance at 20, 60 or 85°."""
    wi, wo, weights = _receptor(angle_deg)
    return float(weights @ (reflectance.eval(wi, wo) @ LUMINANCE))


@cache
def _receptor(angle_deg: int) -> tuple[Floats, Floats, Floats]:
    """wi (1, 3), wo (n, 3), and the weight (n,) of f_r in gloss units."""
    blurs = [math.radians(width) / math.sqrt(12.0) for width in SOURCE_DEG]
    halves = [0.5 * math.radians(width) for width in receptor_deg(angle_deg)]
    (u, du), (v, dv) = (_graded(half, blur) for half, blur in zip(halves, blurs, strict=True))
    window = np.outer(
        du * _blurred_box(u, halves[0], blurs[0]), dv * _blurred_box(v, halves[1], blurs[1])
    ).ravel()
    u, v = (grid.ravel() for grid in np.meshgrid(u, v, indexing="ij"))
    return _seen(angle_deg, u, v, window)


def _seen(angle_deg: int, u: Floats, v: Floats, share: Floats) -> tuple[Floats, Floats, Floats]:
    """wi (1, 3); wo (n, 3) and weights (n,) in GU of shares (n,) of du dv, (u, v) radians off the mirror direction."""
    theta = math.radians(angle_deg)
    wo = np.stack((np.cos(v) * np.sin(theta + u), np.sin(v), np.cos(v) * np.cos(theta + u)), axis=-1)
    # dω = cos v du dv.
    weights = share * np.cos(v) * np.maximum(wo[:, 2], 0.0) * 100.0 / black_glass(angle_deg)
    return np.array([[-math.sin(theta), 0.0, math.cos(theta)]]), wo, weights


def _blurred_box(x: Floats, half: float, blur: float) -> Floats:
    """The box of half-width ``half`` blurred by a Gaussian, 1 at 0."""
    scale = math.sqrt(2.0) * blur
    return np.asarray((_ERF((half - x) / scale) + _ERF((half + x) / scale)) / (2.0 * math.erf(half / scale)))


def _graded(half: float, blur: float) -> tuple[Floats, Floats]:
    """Nodes and weights on both sides of 0: panels that double outwards until they are as wide as the blur."""
    widest, end = _PANEL_PER_BLUR * blur, half + _EDGE_REACH * blur
    edges = [0.0, _FIRST_PANEL]
    while edges[-1] < widest:
        edges.append(2.0 * edges[-1])
    edges += np.linspace(edges[-1], end, 1 + math.ceil((end - edges[-1]) / widest))[1:].tolist()
    nodes, shares = np.polynomial.legendre.leggauss(_POINTS)
    low, high = np.array(edges[:-1])[:, None], np.array(edges[1:])[:, None]
    x = (0.5 * (low + high) + 0.5 * (high - low) * nodes).ravel()
    weight = (0.5 * (high - low) * shares).ravel()
    return np.concatenate((-x[::-1], x)), np.concatenate((weight[::-1], weight))


_ANGLES = (20, 60)


def base_gloss(base: Reflectance) -> tuple[float, float]:
    """Return the gloss units that ``base`` alone adds at 20° and at 60°.

    The base is nearly even over the receptor, so its flux is an integral of f_r cosθo over the receptor's solid
    angle by few points; relative to black glass, which sends F of the flux there. Weighted by luminance.
    """
    wi, wo, weights = _receptors()
    luminance = base.eval(wi, wo) @ LUMINANCE
    at_20, at_60 = (weights * luminance).sum(axis=-1).tolist()
    return at_20, at_60


def total_gloss(base: Reflectance, coat: CoatLobe) -> tuple[float, float]:
    """Return the gloss units at 20° and at 60° of a base under a coat, as a glossmeter reads them."""
    at_20, at_60 = base_gloss(base)
    return (
        at_20 + gloss_units(20, coat.ior, coat.roughness),
        at_60 + gloss_units(60, coat.ior, coat.roughness),
    )


@cache
def _receptors() -> tuple[Floats, Floats, Floats]:
    """wi (2, 1, 3), wo (2, 9, 3) and weights (2, 9) in GU sr: Gauss-Legendre, 3 by 3 over each receptor."""
    nodes, shares = np.polynomial.legendre.leggauss(3)
    u, v = (grid.ravel() for grid in np.meshgrid(nodes, nodes, indexing="ij"))
    share = np.outer(shares, shares).ravel()
    both = []
    for angle in _ANGLES:
        a, b = (0.5 * math.radians(width) for width in receptor_deg(angle))
        both.append(_seen(angle, a * u, b * v, share * a * b))
    wi, wo, weights = (np.array(part) for part in zip(*both, strict=True))
    return wi, wo, weights
