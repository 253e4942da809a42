"""Factored material as plain arrays: sums of products of maps, as input of the renderer.

    f_r = Σ_terms α Π_factors map(projection(wi, wo)),        1/sr, working space, without the cosine

A map is kept as natural logarithms, which are interpolated and added, and exponentiated at the end (McCool, Ang and
Ahmad 2001, section 4.1); or, where it may be zero, as its values. Terms are the product of a homomorphic
factorization, and what is kept apart from it, as a specular peak over the half vector.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_words import PROJECTIONS

MOST_MAPS = 6
"""Of a material: with the light's own textures sixteen are bound, which is what OpenGL 3.3 grants a shader."""
MOST_FACTORS = 12
LARGEST_MAP = 4096
LARGEST_LOG = 80.0
"""Beyond e to this power a single-precision number has no room."""

MapForm = Literal["hemisphere", "square", "line"]
"""How a map lies: parabolic over directions, over two cosines, or over one number."""


def map_form(projection: str) -> MapForm:
    """Return the form of the maps that a projection of :mod:`brdf_suite.geometry.factor_words` reads."""
    found = PROJECTIONS[projection]
    return "hemisphere" if found.hemisphere else "square" if found.axes == 2 else "line"


@dataclass(frozen=True, eq=False)
class FactorMap:
    """One map: ``values`` (n, 3), or (rows, columns, 3), texel i of n at (i + ½)/n, the outermost held to the edge.

    ``logarithmic``: natural logarithms, within ±80; otherwise the values themselves, finite and not negative.
    """

    values: NDArray[Any]
    logarithmic: bool = True

    def __post_init__(self) -> None:
        array: NDArray[Any] = np.ascontiguousarray(self.values, np.float32)
        if array.ndim not in (2, 3) or array.shape[-1] != 3 or min(array.shape[:-1]) < 1:
            raise ValueRangeError("map", f"expected (n, 3) or (rows, columns, 3), not {array.shape}")
        if max(array.shape[:-1]) > LARGEST_MAP:
            raise ValueRangeError(
                "map", f"at most {LARGEST_MAP} texels along an edge, not {array.shape[:-1]}"
            )
        if not np.isfinite(array).all():
            raise ValueRangeError("map", "not every number is finite")
        if self.logarithmic and np.abs(array).max() > LARGEST_LOG:
            raise ValueRangeError("map", f"expected logarithms within ±{LARGEST_LOG:g}")
        if not self.logarithmic and array.min() < 0.0:
            raise ValueRangeError("map", "must not be negative")
        object.__setattr__(self, "values", array)


@dataclass(frozen=True, eq=False)
class FactorTerm:
    """One product: ``alpha`` (3,) in 1/sr, not negative, and its factors as (name of the map, projection).

    Projections are those of :mod:`brdf_suite.geometry.factor_words`.
    """

    alpha: NDArray[Any]
    factors: tuple[tuple[str, str], ...]

    def __post_init__(self) -> None:
        alpha = np.array(np.broadcast_to(np.asarray(self.alpha, np.float64), (3,)))
        if not np.isfinite(alpha).all() or (alpha < 0.0).any():
            raise ValueRangeError("alpha", "expected finite numbers that are not negative")
        object.__setattr__(self, "alpha", alpha)
        object.__setattr__(self, "factors", tuple((str(m), str(p)) for m, p in self.factors))
        for _, projection in self.factors:
            if projection not in PROJECTIONS:
                raise ValueRangeError("factors", f"{projection!r} is none of {', '.join(PROJECTIONS)}")


@dataclass(frozen=True)
class FactorCoat:
    """A clearcoat over factored terms: they are multiplied by T(θi) T(θo) / T̄ · (1 - K) / (1 - K E_b).

    ``ior`` of the coat, ``spread`` of the base (0 mirror, 1 matt), ``inner`` and ``even``: what of matt light the coat
    keeps inside, and reflects from outside; ``albedo`` (3,) of the base without the coat, 0 to 1. The coat's own
    highlight is that of the lobes.
    """

    ior: float
    spread: float
    inner: float
    even: float
    albedo: tuple[float, float, float]

    def __post_init__(self) -> None:
        shares = (self.spread, self.inner, self.even, *self.albedo)
        if not (1.0 <= self.ior <= 100.0 and all(0.0 <= share <= 1.0 for share in shares)):
            raise ValueRangeError("coat", f"expected an index of 1 to 100 and shares of 0 to 1, not {self}")


@dataclass(frozen=True, eq=False)
class FactoredMaps:
    """f_r = Σ of ``terms``, below the ``coat`` where there is one.

    Attributes
    ----------
    maps
        By name; each is read by one factor at least.
    terms
        One or more, with at most :data:`MOST_FACTORS` factors in all.
    ceiling
        1/sr: values bend softly towards it (f / (1 + (f/c)⁴)^¼), all channels by the largest one's share, so that a
        product that nothing was measured for cannot burn out a picture. 0.1 % is lost at a quarter of it.
    """

    maps: Mapping[str, FactorMap]
    terms: tuple[FactorTerm, ...]
    ceiling: float = field(default=1e4)
    coat: FactorCoat | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "maps", MappingProxyType(dict(self.maps)))
        object.__setattr__(self, "terms", tuple(self.terms))
        if not 1 <= len(self.maps) <= MOST_MAPS:
            raise ValueRangeError("maps", f"1 to {MOST_MAPS} maps are drawn, not {len(self.maps)}")
        count = sum(len(term.factors) for term in self.terms)
        if not self.terms or count > MOST_FACTORS:
            raise ValueRangeError("terms", f"1 or more with {MOST_FACTORS} factors in all, not {count}")
        if not (np.isfinite(self.ceiling) and 0.0 < self.ceiling <= 1e8):
            raise ValueRangeError("ceiling", f"expected a number above 0, to 10⁸, not {self.ceiling!r}")
        used: dict[str, MapForm] = {}
        for term in self.terms:
            for name, projection in term.factors:
                if name not in self.maps:
                    raise ValueRangeError("terms", f"there is no map {name!r}")
                form = map_form(projection)
                if used.setdefault(name, form) != form:
                    raise ValueRangeError("terms", f"the map {name!r} is read in two forms")
                if (form == "line") != (self.maps[name].values.ndim == 2):
                    raise ValueRangeError("terms", f"the map {name!r} is not of the form of {projection!r}")
        if set(used) != set(self.maps):
            raise ValueRangeError("maps", f"nothing reads {min(set(self.maps) - set(used))!r}")

    def form(self, name: str) -> MapForm:
        """Return the form of a map."""
        return next(map_form(p) for term in self.terms for m, p in term.factors if m == name)

    def radial_power(self, name: str) -> float | None:
        """Return the power of a map's place that is the radius of a parabolic map; None of what is over no radius."""
        read = {p for term in self.terms for m, p in term.factors if m == name}
        if read & {"sqrt|h|"}:
            return 2.0
        return 1.0 if read & {"|wi|", "|wo|", "|h|"} else None

    @property
    def has_directions(self) -> bool:
        """Whether any map is over directions, so that it matters how the surface's tangent lies."""
        return any(self.form(name) == "hemisphere" for name in self.maps)
