"""Fit of the metal under a clearcoat shared by OpenPBR and glTF to a designed paint.

One base colour c, a share μ of metal and one roughness make

    base = (1 - μ) ((1 - F_d) c / π + F_d D V) + μ (c + (1 - c) (1 - wo·h)^5) D V,

with D of Trowbridge and Reitz for α = roughness², V the height-correlated visibility of Smith, F_d the interface
between base and coat (0.04 in glTF; none where the indices agree, as in the OpenPBR written here). The clearcoat takes
F(wo·n) from the base on the way to the view, and adds its own lobe, as the reference implementations layer them; that
of MaterialX also makes up for the light that meets a second facet, by the factor 1 + F0 (1 - E) / E (Turquin 2019). E
is the share of the light from one direction that one bounce reflects where every facet reflects all
(:mod:`brdf_suite.reflectance.facet_albedo`).

c enters each channel linearly: for each pair (μ, roughness) of a grid it follows by least squares, and from the best
pair all five parameters are found together, so that the mean square of ΔE00 is least. One colour for every angle is
what such a model has: a flop of hue cannot be held.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint
from brdf_suite.files.exports.model_fit import (
    ModelFitSamples,
    ggx,
    half_vector,
    leaves_rec_709,
    normal_reflectance,
    sample_paint,
    schlick,
)
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.facet_albedo import single_scattering_albedo

_METALS = np.linspace(0.0, 1.0, 11)
_ROUGHNESSES = np.linspace(0.2, 1.0, 17)
_MOST_STEPS = 400
_FLOOR = 0.01
GLTF_IOR = 1.5
"""The index that glTF's clearcoat has, whatever the paint's."""

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class MetalRough:
    """Fitted metal-rough parameters, colour in linear Rec. 709; ``differences`` are ΔE00 at the paint's readings."""

    colour: Rgb
    metalness: float
    roughness: float
    interface: float
    coat_ior: float
    coat_roughness: float
    compensated: bool = False
    differences: tuple[float, ...] = ()
    clipped: bool = False

    def eval(self, wi: Floats, wo: Floats) -> Floats:
        """Return f_r (n, 3) in 1/sr, linear Rec. 709, without the cosine, at directions above the horizon."""
        slope, offset = self._linear(wi, wo)
        colour = np.asarray(self.colour)
        value = np.asarray(slope[:, None] * colour + offset[:, None])
        if self.compensated:
            edge = ((1.0 - half_vector(wi, wo)[1]) ** 5)[:, None]
            value = value + self._further(wi, wo)[:, None] * colour * (colour + edge * (1.0 - colour))
        return value

    def _further(self, wi: Floats, wo: Floats) -> Floats:
        """Return the multiple-scattering term (n,) for a metal whose colour is 1."""
        cos_h, _ = half_vector(wi, wo)
        cos_i, cos_o = wi[:, 2], wo[:, 2]
        once = single_scattering_albedo("ggx", self.roughness**2, cos_o)
        left = 1.0 - fresnel_dielectric(cos_o, self.coat_ior)
        lobe = _lobe(cos_h, cos_i, cos_o, self.roughness**2)
        return np.asarray(left * self.metalness * lobe * (1.0 - once) / once)

    def _linear(self, wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
        """f_r = slope · c + offset, each (n,)."""
        cos_h, cos_d = half_vector(wi, wo)
        cos_i, cos_o = wi[:, 2], wo[:, 2]
        lobe = _lobe(cos_h, cos_i, cos_o, self.roughness**2)
        edge = (1.0 - cos_d) ** 5
        inner = schlick(cos_d, self.interface) if self.interface > 0.0 else np.zeros(len(wi))
        matt, metal = 1.0 - self.metalness, self.metalness
        left = 1.0 - fresnel_dielectric(cos_o, self.coat_ior)
        outer = schlick(cos_d, normal_reflectance(self.coat_ior))
        slope = left * (matt * (1.0 - inner) / math.pi + metal * (1.0 - edge) * lobe)
        offset = left * (matt * inner * lobe + metal * edge * lobe)
        offset = offset + outer * _lobe(cos_h, cos_i, cos_o, self.coat_roughness**2)
        return slope, offset


def _lobe(cos_h: Floats, cos_i: Floats, cos_o: Floats, alpha: float) -> Floats:
    """D V (n,): the visibility is G / (4 cosθi cosθo)."""
    a2 = alpha * alpha
    across = cos_o * np.sqrt(cos_i * cos_i * (1.0 - a2) + a2) + cos_i * np.sqrt(
        cos_o * cos_o * (1.0 - a2) + a2
    )
    return np.asarray(ggx(cos_h, alpha) * 0.5 / across)


def fit_openpbr(paint: Paint) -> MetalRough:
    """Return the OpenPBR that is nearest to a designed paint; :class:`UnreachableError` where none can be."""
    return _fit(paint, gltf=False)


def fit_gltf(paint: Paint) -> MetalRough:
    """Return the glTF clearcoat that is nearest to a designed paint; errors as :func:`fit_openpbr`."""
    return _fit(paint, gltf=True)


@lru_cache(maxsize=64)
def _fit(paint: Paint, *, gltf: bool) -> MetalRough:
    from scipy.optimize import minimize  # much to import, and only these exports fit

    layers = build_paint(paint)
    samples = sample_paint(paint, layers)
    start = MetalRough(
        (0.5, 0.5, 0.5),
        0.5,
        0.5,
        interface=0.04 if gltf else 0.0,
        coat_ior=GLTF_IOR if gltf else layers.ior,
        coat_roughness=math.sqrt(min(layers.roughness, 1.0)),
        compensated=not gltf,
    )
    found = min(
        (
            _coloured(replace(start, metalness=float(metal), roughness=float(roughness)), samples)
            for metal in _METALS
            for roughness in _ROUGHNESSES
        ),
        key=lambda item: samples.score(item.eval(samples.wi, samples.wo)),
    )

    def model(x: Floats) -> MetalRough:
        c = np.clip(x, [0.0, 0.0, 0.0, 0.0, 0.05], 1.0).tolist()
        return replace(found, colour=(c[0], c[1], c[2]), metalness=c[3], roughness=c[4])

    def score(x: Floats) -> float:
        outside = float(np.abs(x - np.clip(x, 0.0, 1.0)).sum())
        return samples.score(model(x).eval(samples.wi, samples.wo)) * (1.0 + outside) + outside

    begin = np.array([*found.colour, found.metalness, found.roughness])
    simplex = np.vstack([begin, begin + np.diag(np.where(begin > 0.5, -0.05, 0.05))])
    # Its options are not typed one by one for this method.
    options: Any = {"maxiter": _MOST_STEPS, "initial_simplex": simplex, "xatol": 1e-5, "fatol": 1e-7}
    best = model(minimize(score, begin, method="Nelder-Mead", options=options).x)
    differences = samples.at_readings(best.eval(samples.wi, samples.wo))
    return replace(best, differences=differences, clipped=leaves_rec_709(samples))


def _coloured(model: MetalRough, samples: ModelFitSamples) -> MetalRough:
    """Return the model with the colour of the least relative error."""
    slope, offset = model._linear(samples.wi, samples.wo)
    scale = samples.weight[:, None] / (np.maximum(samples.f, 0.0) + _FLOOR * float(samples.f.max())) ** 2
    top = (scale * slope[:, None] * (samples.f - offset[:, None])).sum(axis=0)
    below = (scale * (slope * slope)[:, None]).sum(axis=0)
    red, green, blue = np.clip(top / np.maximum(below, 1e-12), 0.0, 1.0).tolist()
    return replace(model, colour=(red, green, blue))
