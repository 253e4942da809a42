"""Virtual glossmeter: the flux of any reflectance in the standard's receptor at 20, 60 or 85°.

A reading compares flux in the receptor with that of polished black glass (see
:mod:`brdf_suite.appearance.clearcoat_gloss`). Every direction of the source's image sends equal flux:

    GU = 100 / F(θ; 1.567) · ∫∫ f_r cosθo dωo dωs / ∫ dωs,   ωs in the source's rectangle, ωo in the receptor's,

weighted by luminance. With ωo as the mirror direction of ωs turned by (u, v), the source directions whose light
arrives form a rectangle for each (u, v). Its share of the source is the product of two trapezoids, the convolution of
source and receptor. f_r varies little over it at the same (u, v), so it is read once, at the rectangle's centre.

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
    black_glass,
    gloss_units,
    half_widths,
)
from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.protocol import Reflectance

GLOSS_ANGLES_DEG: tuple[int, ...] = tuple(RECEPTORS_DEG)

_FIRST_PANEL = 1e-4
_POINTS = 4


def gloss_reading(reflectance: Reflectance, angle_deg: int) -> float:
    """Return the gloss units of a whole reflectance at 20, 60 or 85°."""
    wi, wo, weights = _receptor(angle_deg)
    return float(weights @ (reflectance.eval(wi, wo) @ LUMINANCE))


@cache
def _receptor(angle_deg: int) -> tuple[Floats, Floats, Floats]:
    """wi and wo (n, 3), and the weight (n,) of f_r in gloss units."""
    (u, su, du), (v, sv, dv) = (_turns(*widths) for widths in half_widths(angle_deg))
    u, v = (grid.ravel() for grid in np.meshgrid(u, v, indexing="ij"))
    su, sv = (grid.ravel() for grid in np.meshgrid(su, sv, indexing="ij"))
    return _seen(angle_deg, su, sv, su + u, sv + v, np.outer(du, dv).ravel())


def _seen(
    angle_deg: int, su: Floats, sv: Floats, u: Floats, v: Floats, share: Floats
) -> tuple[Floats, Floats, Floats]:
    """wi and wo (n, 3), and weights (n,) in GU of shares (n,) of du dv.

    ``u`` and ``v`` are the view's angles off the mirror direction in the plane of incidence and across it, ``su`` and
    ``sv`` those of the light's own mirror direction, radians.
    """
    theta = math.radians(angle_deg)
    wi = np.stack((-np.cos(sv) * np.sin(theta + su), -np.sin(sv), np.cos(sv) * np.cos(theta + su)), axis=-1)
    wo = np.stack((np.cos(v) * np.sin(theta + u), np.sin(v), np.cos(v) * np.cos(theta + u)), axis=-1)
    # dω = cos v du dv.
    return wi, wo, share * np.cos(v) * np.maximum(wo[:, 2], 0.0) * 100.0 / black_glass(angle_deg)


def _turns(receptor: float, source: float) -> tuple[Floats, Floats, Floats]:
    """Turns (n,) off the mirror direction along one side, the source's mean angle there, and the weights (n,).

    The weight holds the share of the source whose light arrives. Panels double outwards from 0 on both sides; one
    ends where that share begins to fall, the last where it reaches 0.
    """
    inner, outer = receptor - source, receptor + source
    doubling = _FIRST_PANEL * 2.0 ** np.arange(math.ceil(math.log2(outer / _FIRST_PANEL)))
    edges = np.sort([0.0, inner, outer, *doubling])
    nodes, shares = np.polynomial.legendre.leggauss(_POINTS)
    low, high = edges[:-1, None], edges[1:, None]
    x = (0.5 * (low + high) + 0.5 * (high - low) * nodes).ravel()
    weight = (0.5 * (high - low) * shares).ravel()
    # Of the source [-s, s] the part up to r - x arrives.
    last = np.minimum(source, receptor - x)
    weight *= (last + source) / (2.0 * source)
    mean = 0.5 * (last - source)
    return (
        np.concatenate((-x[::-1], x)),
        np.concatenate((-mean[::-1], mean)),
        np.concatenate((weight[::-1], weight)),
    )


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
    """wi and wo (2, 9, 3) and weights (2, 9) in GU sr: Gauss-Legendre, 3 by 3 over each receptor and source."""
    nodes, shares = np.polynomial.legendre.leggauss(3)
    u, v = (grid.ravel() for grid in np.meshgrid(nodes, nodes, indexing="ij"))
    share = np.outer(shares, shares).ravel()
    both = []
    for angle in _ANGLES:
        (a, s), (b, t) = half_widths(angle)
        # The convolution with the source keeps the receptor's area and adds the squares of the widths.
        side, up = np.hypot(a, s) * u, np.hypot(b, t) * v
        both.append(_seen(angle, 0.0 * u, 0.0 * v, side, up, share * a * b))
    wi, wo, weights = (np.array(part) for part in zip(*both, strict=True))
    return wi, wo, weights
