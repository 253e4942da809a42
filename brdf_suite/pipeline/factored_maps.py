"""A factored reflectance as the plain arrays that the renderer shades lamps with."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from brdf_suite.realtime.factored_values import FactorCoat, FactoredMaps, FactorMap, FactorTerm
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.reflectance.factored import Factored

_OVER_LARGEST = 4.0
"""A product may be as much above the largest sample before it is bent; there it still loses only 0.1 %."""
_HIGHEST_CEILING = 1e4


def is_factored(reflectance: Reflectance) -> bool:
    """Whether lamps on it are shaded by its factors: it is factored, with a clearcoat or without."""
    from brdf_suite.reflectance.factored import Factored

    return isinstance(getattr(reflectance, "base", reflectance), Factored)


def maps_of(reflectance: Reflectance | None) -> FactoredMaps | None:
    """Return the maps of what is factored, with a clearcoat or without; None of all else, which its lobes shade."""
    # Not on the start-up path: a paint without factors has no need of them.
    from brdf_suite.reflectance.factored import Factored
    from brdf_suite.reflectance.models.coated import Coated, mean_fresnel

    if isinstance(reflectance, Coated) and isinstance(reflectance.base, Factored):
        even = mean_fresnel(reflectance.ior)
        red, green, blue = reflectance.base_albedo.tolist()
        inner = 1.0 - (1.0 - even) / reflectance.ior**2
        coat = FactorCoat(reflectance.ior, reflectance.spread, inner, even, (red, green, blue))
        return replace(factored_maps(reflectance.base), coat=coat)
    return factored_maps(reflectance) if isinstance(reflectance, Factored) else None


def factored_maps(value: Factored) -> FactoredMaps:
    """Return the products of ``value`` with one map for each array, as logarithms where they are read as such.

    The ceiling is four times the largest sample that was factored, or 10⁴/sr where that is not known.
    """
    names: dict[tuple[int, bool, int], str] = {}
    maps: dict[str, FactorMap] = {}
    terms = []
    for alpha, factors in value.terms:
        read = []
        for factor in factors:
            # Factors that share an array share a texture; the arrays live as long as ``value``.
            key = (id(factor.values), factor.logarithmic, factor.values.ndim)
            if key not in names:
                names[key] = f"map_{len(names)}"
                held = np.log(factor.values) if factor.logarithmic else factor.values
                maps[names[key]] = FactorMap(held, factor.logarithmic)
            read.append((names[key], factor.projection))
        terms.append(FactorTerm(np.asarray(alpha), tuple(read)))
    largest = value.facts.get("largest")
    ceiling = _HIGHEST_CEILING
    if isinstance(largest, (int, float)) and np.isfinite(largest) and largest > 0.0:
        ceiling = min(_OVER_LARGEST * float(largest), _HIGHEST_CEILING)
    return FactoredMaps(maps, tuple(terms), ceiling)
