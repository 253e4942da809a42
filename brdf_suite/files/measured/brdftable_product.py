"""A factored reflectance of any maps as the arrays and the header of a ``.brdftable`` of kind ``product``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import MOST_MORE, Factored

NEEDED = {"p", "q", "alpha"}
OPTIONAL = {f"{part}{number}" for part in ("more", "peak") for number in range(MOST_MORE)}


def is_plain(value: Factored) -> bool:
    """Whether it is α p q p of two parabolic maps, interpolated as they are: what kind ``factored`` holds."""
    return not (value.logarithmic or value.more or value.peak or value.p.ndim == 2 or value.q.ndim == 2)


def product_parts(value: Factored) -> tuple[dict[str, Any], dict[str, AnyArray]]:
    """Return the header's own field ``maps``, and the arrays."""
    arrays: dict[str, AnyArray] = {"p": value.p, "q": value.q, "alpha": np.asarray(value.alpha, np.float64)}
    maps: dict[str, Any] = {"logarithmic": value.logarithmic}
    for part in ("more", "peak"):
        factors: tuple[MapFactor, ...] = getattr(value, part)
        maps[part] = [[factor.name, factor.projection, factor.logarithmic] for factor in factors]
        arrays |= {f"{part}{number}": factor.values for number, factor in enumerate(factors)}
    return {"maps": maps}, arrays


def product_value(header: Mapping[str, Any], arrays: Mapping[str, AnyArray]) -> Factored:
    """Return what :func:`product_parts` took apart; ``header`` holds ``maps``, ``source`` and ``facts``.

    Raises
    ------
    ValueRangeError
        ``maps`` is not as it should be, or an array is missing or is no map.
    """
    maps = header["maps"]
    if set(maps) != {"logarithmic", "more", "peak"} or not isinstance(maps["logarithmic"], bool):
        raise ValueRangeError("maps", 'expected "logarithmic", "more" and "peak" in the header')
    found = {part: _factors(part, maps[part], arrays) for part in ("more", "peak")}
    if len(arrays) != len(NEEDED) + sum(len(factors) for factors in found.values()):
        raise ValueRangeError("maps", "there are arrays that no factor reads")
    return Factored(
        arrays["p"],
        arrays["q"],
        arrays["alpha"],
        header["source"],
        header["facts"],
        more=found["more"],
        peak=found["peak"],
        logarithmic=maps["logarithmic"],
    )


def _factors(part: str, listed: object, arrays: Mapping[str, AnyArray]) -> tuple[MapFactor, ...]:
    if not isinstance(listed, list) or len(listed) > MOST_MORE:
        raise ValueRangeError("maps", f"{part}: expected a list of at most {MOST_MORE} factors")
    factors = []
    for number, item in enumerate(listed):
        key = f"{part}{number}"
        formed = isinstance(item, list) and [type(one) for one in item] == [str, str, bool]
        if not formed or len(item[0]) > 80 or key not in arrays:
            raise ValueRangeError(key, "expected a name, a projection and true or false, and the array")
        factors.append(MapFactor(item[1], arrays[key], item[2], item[0]))
    return tuple(factors)
