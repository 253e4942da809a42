"""Factors of a product: projections π of a direction pair to a factor's map, and the text notation for them.

A projection (McCool, Ang and Ahmad 2001, section 3.2) takes unit directions ``wi``, ``wo`` (n, 3) above the horizon to
places (n, d) in [0, 1]^d, d = 1 or 2, and says how a map over them is laid out. Two-dimensional ones over a hemisphere
are parabolic; the others are products of cosines. Texel i of a map of n lies at (i + 1/2)/n; between two it is
interpolated, and the outermost hold to the edge.

A text ``p:wo q:h p:wi`` names a map and its projection each. A word may end in ``@n``, the texels along that map:
``q:sqrt|h|@64``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.parabolic import parabolic_place
from brdf_suite.geometry.warps import half_vector


@dataclass(frozen=True)
class Projection:
    """A projection: its ``name``, the number of ``axes`` of its map, what it is, and ``places(wi, wo) -> (n, axes)``.

    ``hemisphere``: the map is a parabolic one over directions.
    """

    name: str
    axes: int
    what: str
    places: Callable[[Floats, Floats], Floats]
    hemisphere: bool = False


def _parabolic(w: Floats) -> Floats:
    return np.stack([0.5 * (place + 1.0) for place in parabolic_place(w)], axis=-1)


def _dot(a: Floats, b: Floats) -> Floats:
    return np.asarray(np.einsum("...i,...i->...", a, b))


def _half_pair(wi: Floats, wo: Floats) -> Floats:
    """The cosines from the half vector to the light (and to the view) and to the normal: no pair is past 90°."""
    h = half_vector(wi, wo)
    return np.clip(np.stack((_dot(wi, h), h[:, 2]), axis=-1), 0.0, 1.0)


def _radius(w: Floats) -> Floats:
    """How far from the middle of a parabolic map a direction lies, tan(θ/2), 1 at the horizon."""
    s, t = parabolic_place(w)
    return np.clip(np.hypot(s, t), 0.0, 1.0)[:, None]


def _elevations(wi: Floats, wo: Floats) -> Floats:
    """Return both cosines from the normal, the smaller first, so that light and view are exchangeable."""
    both = np.stack((wi[:, 2], wo[:, 2]), axis=-1)
    return np.sort(np.clip(both, 0.0, 1.0), axis=-1)


PROJECTIONS: Mapping[str, Projection] = MappingProxyType(
    {
        one.name: one
        for one in (
            Projection("wi", 2, "direction to the light", lambda wi, _wo: _parabolic(wi), hemisphere=True),
            Projection("wo", 2, "direction to the viewer", lambda _wi, wo: _parabolic(wo), hemisphere=True),
            Projection("h", 2, "half vector", lambda i, o: _parabolic(half_vector(i, o)), hemisphere=True),
            # A cosine from -1 to 1, in [0, 1].
            Projection(
                "wi.wo", 1, "cosine between light and view", lambda i, o: 0.5 * (_dot(i, o) + 1.0)[:, None]
            ),
            Projection(
                "w.h", 1, "cosine between light and half vector", lambda i, o: _half_pair(i, o)[:, :1]
            ),
            Projection("|wi|", 1, "radius of the light on a parabolic map", lambda wi, _wo: _radius(wi)),
            Projection("|wo|", 1, "radius of the view on a parabolic map", lambda _wi, wo: _radius(wo)),
            Projection("|h|", 1, "radius of the half vector there", lambda i, o: _radius(half_vector(i, o))),
            Projection(
                "sqrt|h|",
                1,
                "root of that radius, fine at a peak",
                lambda i, o: np.sqrt(_radius(half_vector(i, o))),
            ),
            Projection("w.h,h.n", 2, "cosines light to half vector, half vector to normal", _half_pair),
            Projection("wi.n,wo.n", 2, "cosines of light and view, the smaller first", _elevations),
        )
    }
)
"""Every projection by its name."""


@dataclass(frozen=True)
class Factor:
    """A factor of the product: the map ``name`` that it reads, and where. Two factors of one name share the map.

    ``size``: texels along each axis of the map, or ``None`` for as many as the others have.
    """

    name: str
    projection: Projection
    size: int | None = None


DEFAULT_FACTORS = "p:wo q:h p:wi"
"""p(ωo) q(h) p(ωi), equation 9."""
MEASURED_FACTORS = "p:|wo| q:sqrt|h| p:|wi| d:w.h@16"
"""Of isotropic measurements: radial maps, that of the half vector fine at the normal, and one over Fresnel's angle."""
MOST_FACTORS = 8
LEAST_SIZE, MOST_SIZE = 2, 512


def parse_factors(text: str) -> tuple[Factor, ...]:
    """Return the factors in a text of ``map:projection`` or ``map:projection@texels`` with spaces between them.

    >>> [(f.name, f.projection.name) for f in parse_factors("p:wo q:h p:wi")]
    [('p', 'wo'), ('q', 'h'), ('p', 'wi')]

    Raises
    ------
    ValueRangeError
        A projection or a number of texels is not known, a map is read by projections of two forms or has two sizes, or
        there are none or too many factors.
    """
    found: list[Factor] = []
    forms: dict[str, tuple[int, bool]] = {}
    sizes: dict[str, int] = {}
    for word in text.split():
        name, colon, rest = word.partition(":")
        key, at, digits = rest.partition("@")
        if not colon or not (name.isascii() and name.isidentifier()) or key not in PROJECTIONS:
            known = ", ".join(PROJECTIONS)
            raise ValueRangeError(
                "factors",
                f"{word[:80]!r} is not map:projection with a projection of {known}, as in {DEFAULT_FACTORS!r}",
            )
        projection = PROJECTIONS[key]
        form = (projection.axes, projection.hemisphere)
        if forms.setdefault(name, form) != form:
            raise ValueRangeError(
                "factors", f"the map {name!r} cannot be over {key} and over something of another form"
            )
        size = _size(word, digits) if at else None
        if size is not None and sizes.setdefault(name, size) != size:
            raise ValueRangeError("factors", f"the map {name!r} cannot have {sizes[name]} and {size} texels")
        found.append(Factor(name, projection, size))
    if not 1 <= len(found) <= MOST_FACTORS:
        raise ValueRangeError("factors", f"expected 1 to {MOST_FACTORS} factors, not {len(found)}")
    return tuple(Factor(one.name, one.projection, sizes.get(one.name)) for one in found)


def factor_words(factors: tuple[Factor, ...], *, sizes: bool = False) -> str:
    """Return the text of factors, which :func:`parse_factors` reads; with their ``sizes`` or without.

    >>> factor_words(parse_factors("p:wo q:h@64 p:wi"))
    'p:wo q:h p:wi'
    """
    return " ".join(
        f"{one.name}:{one.projection.name}" + (f"@{one.size}" if sizes and one.size is not None else "")
        for one in factors
    )


def _size(word: str, digits: str) -> int:
    if not (digits.isascii() and digits.isdecimal() and len(digits) <= 4) or not (
        LEAST_SIZE <= int(digits) <= MOST_SIZE
    ):
        raise ValueRangeError(
            "factors", f"{word[:80]!r}: after @ stands a number of texels, {LEAST_SIZE} to {MOST_SIZE}"
        )
    return int(digits)
