"""Translation of a core reflectance to a BSDF term of the renderer."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import triple
from brdf_suite.reference.bsdfs.aspecular import AspecularBaseTerm, SeveralLightsTerm
from brdf_suite.reference.bsdfs.factored import FactoredTerm
from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm
from brdf_suite.reference.bsdfs.table import HalfAngleTable, MeasuredTerm, fitted_samplers
from brdf_suite.reference.bsdfs.terms import (
    CoatLobeTerm,
    FacetLobe,
    LambertianTerm,
    SeenThroughTerm,
    SumTerm,
    UnderCoat,
)
from brdf_suite.reflectance.designed import coat_lobe
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase, SeveralLights
from brdf_suite.reflectance.designed.layers import divide_lobes
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance, index_from_reflectance
from brdf_suite.reflectance.models.cosine_lobes import CosineLobes
from brdf_suite.reflectance.models.lambertian import Lambertian as CoreLambertian
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

TABULATED = (
    "The reference renderer has no formula for this reflectance; it renders a table of it in half-angle coordinates "
    "(90 × 90 × 180 bins, mean over azimuths assumed)."
)


@dataclass(frozen=True, eq=False)
class TranslatedTerm:
    """A translated term, with notices about its accuracy."""

    term: Any
    notices: tuple[str, ...] = ()


def translate(reflectance: Reflectance) -> TranslatedTerm:
    """Return the counterpart of any reflectance; of one without a formula here, that of its table."""
    term = _exact(reflectance)
    if term is not None:
        return TranslatedTerm(term)
    if isinstance(reflectance, ScatteredSamples | AnisotropicTable):
        table = _kept_table(reflectance)
    else:
        table = IsotropicTable.from_reflectance(reflectance)
    return TranslatedTerm(HalfAngleTable.of(table, fitted_samplers(reflectance)), (TABULATED,))


@lru_cache(maxsize=2)
def _kept_table(reflectance: ScatteredSamples | AnisotropicTable) -> IsotropicTable:
    """Return the table of samples, which takes seconds for many of them and is the same in every light and view."""
    return IsotropicTable.from_reflectance(reflectance)


@dataclass(frozen=True, eq=False)
class LayerTerms:
    """The terms of base and coat: None where absent, or where the layers cannot be separated."""

    base: Any
    coat: Any | None
    ior: float
    notices: tuple[str, ...] = ()


def divide(reflectance: Reflectance) -> LayerTerms:
    """Return the terms of base and coat, split as the layers of the lobe fit (:func:`~.layers.split_layers`)."""
    if isinstance(reflectance, PaintReflectance):
        coat = reflectance.coat
        return LayerTerms(_exact(reflectance.base), CoatLobeTerm(coat), coat.ior)
    if isinstance(reflectance, CookTorrance):
        wide, sharp, ior = divide_lobes(reflectance)
        return LayerTerms(_cook_torrance(wide), _cook_torrance(sharp) if sharp.paint.lobes else None, ior)
    if isinstance(reflectance, Coated):
        inner = divide(reflectance.base)
        under = UnderCoat(reflectance, inner.base)
        above: Any = under.coat
        if inner.coat is not None:
            above = SumTerm((under.coat, SeenThroughTerm(UnderCoat(reflectance, inner.coat))))
        return LayerTerms(SeenThroughTerm(under), above, reflectance.ior, inner.notices)
    whole = translate(reflectance)
    return LayerTerms(whole.term, None, 1.0, whole.notices)


def _exact(reflectance: object) -> Any | None:
    if isinstance(reflectance, PaintReflectance):
        return SumTerm((_exact(reflectance.base), CoatLobeTerm(reflectance.coat)))
    if isinstance(reflectance, AspecularBase):
        return AspecularBaseTerm.of(reflectance)
    if isinstance(reflectance, SeveralLights):
        return SeveralLightsTerm.of(reflectance)
    if isinstance(reflectance, coat_lobe.CoatLobe):
        return CoatLobeTerm(reflectance)
    if isinstance(reflectance, CookTorrance):
        return _cook_torrance(reflectance)
    if isinstance(reflectance, Coated):
        base = translate(reflectance.base)
        return UnderCoat(reflectance, base.term)
    if isinstance(reflectance, IsotropicTable):
        return HalfAngleTable.of(reflectance, fitted_samplers(reflectance))
    if isinstance(reflectance, TensorReflectance):
        return MeasuredTerm.of(reflectance)
    if isinstance(reflectance, Factored):
        return FactoredTerm(reflectance)
    if isinstance(reflectance, CosineLobes):
        return _cosine_lobes(reflectance)
    if isinstance(reflectance, CoreLambertian):
        return LambertianTerm(triple(reflectance.albedo))
    return None


def _cosine_lobes(model: CosineLobes) -> LobeWeightsTerm:
    kd, exponents, kdd, kg = (np.asarray(v, float) for v in (model.kd, model.exponents, model.kdd, model.kg))
    # The sum as it stands: no gains that follow the angle.
    return LobeWeightsTerm(exponents, kd, kdd, kg, "none", 0.0, 1.0, raised=False)


def _cook_torrance(model: CookTorrance) -> SumTerm:
    paint = model.paint
    full = 1.0 if paint.d_norm == "full" else 0.25
    lobes = []
    for lobe in paint.lobes:
        # The mean of F over the directions is a little above that along the normal.
        weight = 4.0 * full * _dot(lobe.ks)
        lobes.append(
            FacetLobe(
                triple(lobe.ks),
                lobe.m,
                full,
                index_from_reflectance(lobe.r) if lobe.r < 1.0 else None,
                weight * (lobe.r + 0.05 * (1.0 - lobe.r)),
            )
        )
    # The widest facets leave gaps towards grazing that a few even directions fill.
    least = 0.05 * (_dot(paint.kd) + sum(lobe.weight for lobe in lobes))
    return SumTerm((LambertianTerm(triple(paint.kd), max(_dot(paint.kd), least, 1e-6)), *lobes))


def _dot(colour: Any) -> float:
    return float(sum(c * y for c, y in zip(colour, LUMINANCE.tolist(), strict=True)))
