"""Fit of a matt layer and a lobe under a clearcoat: glTF, OpenPBR and USD Preview Surface.

The width of the lobe and OpenPBR's reflectance along the normal are searched; for each the colours are found by linear
least squares, and from the best few all parameters together. A paint that a matt layer matches as well, a solid one,
has no lobe, or is no metal.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.model_fit import FitTarget, Fitted, first_weights, fitted, target_of
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.renderers.coated_facets import GLTF_COAT_IOR, CoatedFacets, Kind, matt_term
from brdf_suite.reflectance.renderers.facet_lobe import RendererLobe

_WIDTHS = np.geomspace(0.08, 1.0, 10)
_GREYS = (0.15, 0.35, 0.6)
_NARROWEST, _WIDEST, _BRIGHTEST = 0.02, 1.0, 0.95
_TRIED = 2
_SOLID_GAIN = 0.85
"""A lobe is kept where it brings the mean squared error below this share of that without."""


def fit_coated_facets(item: ExportItem, kind: Kind) -> Fitted[CoatedFacets]:
    """Return the model that is nearest to what is exported.

    Raises :class:`~brdf_suite.errors.UnreachableError` where no paint has its readings.
    """
    return _fit(item.modelled, item.material, kind)


@lru_cache(maxsize=64)
def _fit(paint: Paint, material: Material | None, kind: Kind) -> Fitted[CoatedFacets]:
    target = target_of(paint, material)
    coat_ior = GLTF_COAT_IOR if kind == "gltf" else target.coat.ior
    black = (0.0, 0.0, 0.0)
    start = CoatedFacets(kind, black, black, 1.0, coat_ior, min(max(target.coat.roughness, 1e-3), 1.0))
    integrals = _Integrals(target, start)
    solid, solid_score = _refine(_coloured(start, integrals), integrals)
    wide = [replace(start, alpha=float(alpha), specular=(0.5, 0.5, 0.5)) for alpha in _WIDTHS]
    if kind == "openpbr":
        wide = [replace(model, grey=grey) for model in wide for grey in _GREYS]
    elif kind == "usd":
        wide = [replace(model, specular=black, metal=True) for model in wide]
    trials = [_coloured(model, integrals) for model in wide]
    trials.sort(key=lambda model: target.score(integrals.values(model)))
    best, score = min((_refine(model, integrals) for model in trials[:_TRIED]), key=lambda pair: pair[1])
    if score > _SOLID_GAIN * solid_score:
        best = solid
    return fitted(target, best, integrals.values(best))


class _Integrals:
    """Integrals of a model's terms, kept: those of the lobe depend on its width and grey, the others on no colour."""

    def __init__(self, target: FitTarget, model: CoatedFacets) -> None:
        self.target = target
        self._matt = target.integrals(matt_term)
        self._coat = target.integrals(model.coat.terms)
        self._lobes: dict[RendererLobe, Floats] = {}

    def values(self, model: CoatedFacets) -> Floats:
        """Return the model's values (n, 3)."""
        return model.sum_terms(self.terms(model), self.target.cos_o)

    def terms(self, model: CoatedFacets) -> Floats:
        """Return the integrals (n, 7)."""
        lobe = model.lobe
        if lobe not in self._lobes:
            self._lobes[lobe] = self.target.integrals(lobe.terms)
        return np.concatenate((self._matt, self._lobes[lobe], self._coat), axis=-1)


def _coloured(model: CoatedFacets, integrals: _Integrals) -> CoatedFacets:
    """Return the model with the colours of the least relative error; those of ``specular`` are the first guess."""
    terms, target, black = integrals.terms(model), integrals.target, (0.0, 0.0, 0.0)
    bare = replace(model, diffuse=black, specular=black, grey=0.0)
    fixed = bare.sum_terms(terms, target.cos_o)
    rest = target.value / target.scale[:, None] - fixed
    two = model.kind != "usd" and model.has_lobe
    for _ in range(3 if two else 1):  # what the lobe takes from the matt layer depends on its colour
        white = replace(model, diffuse=(1.0, 1.0, 1.0)).sum_terms(terms, target.cos_o)
        dark = replace(model, diffuse=black).sum_terms(terms, target.cos_o)
        columns = [(white - dark)[:, 0]]
        if two:
            level = np.maximum(np.asarray(model.specular), 1e-3)
            columns.append(((dark - fixed) / level)[:, int(np.argmax(level))])
        found = first_weights(np.stack(columns, axis=-1), target, rest)
        model = replace(model, diffuse=_rgb(found[0]))
        if two:
            model = replace(model, specular=_rgb(np.maximum(found[1], 1e-3)))
    return model


def _refine(model: CoatedFacets, integrals: _Integrals) -> tuple[CoatedFacets, float]:
    """Return the model of the least error near ``model``, and the error."""
    kind, colours = model.kind, 3 if model.kind == "usd" or not model.has_lobe else 6
    start = [*model.diffuse, *model.specular][:colours]
    low, high = [0.0] * 3 + [1e-4] * (colours - 3), [1.0] * colours
    if model.has_lobe:
        start, low, high = (
            [*start, math.log(model.alpha)],
            [*low, math.log(_NARROWEST)],
            [*high, math.log(_WIDEST)],
        )
    if kind == "openpbr" and model.has_lobe:
        start, low, high = [*start, model.grey], [*low, 0.01], [*high, _BRIGHTEST]

    def made(x: Floats) -> CoatedFacets:
        found = replace(model, diffuse=_rgb(x[:3]))
        if colours == 6:
            found = replace(found, specular=_rgb(x[3:6]))
        if len(x) > colours:
            found = replace(found, alpha=math.exp(float(x[colours])))
        if len(x) > colours + 1:
            found = replace(found, grey=float(x[colours + 1]))
        return found

    x, error = integrals.target.least(lambda x: integrals.values(made(x)), *map(np.array, (start, low, high)))
    return made(x), error


def _rgb(values: Floats) -> tuple[float, float, float]:
    red, green, blue = np.clip(values, 0.0, 1.0).tolist()
    return red, green, blue
