"""A factored reflectance as the plain arrays that the renderer shades lamps with."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from brdf_suite.realtime.factors.values import (
    LARGEST_LOG,
    MOST_FACTORS,
    MOST_MAPS,
    FactorCoat,
    FactoredMaps,
    FactorMap,
    FactorTerm,
)
from brdf_suite.reflectance.facet_albedo import mean_reflected
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.arrays import Singles
    from brdf_suite.reflectance.factored.model import Factored

_OVER_LARGEST = 4.0
"""A product may be as much above the largest sample before it is bent; there it still loses only 0.1 %."""
_HIGHEST_CEILING = 1e4
TOO_MANY = (
    f"Its product has more than {MOST_MAPS} maps, too many to be drawn by: lamps light the lobes instead."
)


def is_factored(reflectance: Reflectance) -> bool:
    """Whether lamps on it are shaded by its factors: it is factored, with a clearcoat or without."""
    return _factored_part(reflectance) is not None and not too_many_maps(reflectance)


def maps_of(reflectance: Reflectance | None) -> FactoredMaps | None:
    """Return the maps of what is factored, with a clearcoat or without; None of all else, which its lobes shade.

    So they do where there are more maps than a shader has textures for (:func:`too_many_maps`).
    """
    factored = _factored_part(reflectance)
    if factored is None or too_many_maps(reflectance):
        return None
    if isinstance(reflectance, Coated):
        even = mean_reflected(reflectance.ior)  # of a smooth coat, as the shader takes it
        red, green, blue = reflectance.base_albedo.tolist()
        inner = 1.0 - (1.0 - even) / reflectance.ior**2
        coat = FactorCoat(reflectance.ior, reflectance.spread, inner, even, (red, green, blue))
        return replace(factored_maps(factored), coat=coat)
    return factored_maps(factored)


def too_many_maps(reflectance: object) -> bool:
    """Whether it is factored, with a clearcoat or without, into more maps than a shader has textures for."""
    factored = _factored_part(reflectance)
    if factored is None:
        return False
    maps, terms = _read(factored)
    return len(maps) > MOST_MAPS or sum(len(term.factors) for term in terms) > MOST_FACTORS


def _factored_part(reflectance: object) -> Factored | None:
    from brdf_suite.reflectance.factored.model import Factored  # 8 ms at the start of the Viewer

    base = getattr(reflectance, "base", reflectance)
    return base if isinstance(base, Factored) else None


def factored_maps(value: Factored) -> FactoredMaps:
    """Return the products of ``value`` with one map for each array, as logarithms where they are read as such.

    The ceiling is four times the largest sample that was factored, or 10⁴/sr where that is not known.

    Raises :class:`ValueRangeError`: there are more maps than are drawn (:func:`too_many_maps`).
    """
    maps, terms = _read(value)
    largest = value.facts.get("largest")
    ceiling = _HIGHEST_CEILING
    if isinstance(largest, (int, float)) and np.isfinite(largest) and largest > 0.0:
        ceiling = min(_OVER_LARGEST * float(largest), _HIGHEST_CEILING)
    return FactoredMaps(maps, terms, ceiling)


def _read(value: Factored) -> tuple[dict[str, FactorMap], tuple[FactorTerm, ...]]:
    """Return the maps by name and the terms. A map that is the same everywhere goes into α: it needs no texture."""
    names: dict[tuple[int, bool, int], str] = {}
    maps: dict[str, FactorMap] = {}
    terms = []
    even = all(_is_even(factor.values) for _, factors in value.terms for factor in factors)
    for scale, factors in value.terms:
        alpha, read = np.asarray(scale, np.float64), []
        for factor in factors:
            if not even and _is_even(factor.values):
                alpha = alpha * factor.values.reshape(-1, 3)[0]
                continue
            # Factors that share an array share a texture; the arrays live as long as ``value``.
            key = (id(factor.values), factor.logarithmic, factor.values.ndim)
            if key not in names:
                names[key] = f"map_{len(names)}"
                # What is darker than single precision resolves is black.
                held = factor.values
                if factor.logarithmic:
                    held = np.clip(np.log(held), -LARGEST_LOG, LARGEST_LOG)
                maps[names[key]] = FactorMap(held, factor.logarithmic)
            read.append((names[key], factor.projection))
        terms.append(FactorTerm(alpha, tuple(read)))
    return maps, tuple(terms)


def _is_even(values: Singles) -> bool:
    flat = values.reshape(-1, 3)
    return bool((flat == flat[0]).all())
