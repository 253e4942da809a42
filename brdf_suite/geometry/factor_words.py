"""Text notation for the factors of a product: ``p:wo q:h p:wi``, a map and its projection each.

A word may end in ``@n``, the texels along that map: ``q:sqrt|h|@64``.
"""

from __future__ import annotations

from dataclasses import dataclass

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_projections import PROJECTIONS, Projection


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
COSINE_FACTORS = "p:w.h,h.n q:wi.n,wo.n"
"""p(h·ω, h·n) q(ωi·n, ωo·n), equation 21: for isotropic reflectances."""
RADIAL_FACTORS = "p:|wo| q:|h| p:|wi|"
"""Equation 9 where its maps are radially symmetric, as of isotropic reflectances: one number a ring."""
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
