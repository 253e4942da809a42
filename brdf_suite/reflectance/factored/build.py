"""Construction of a factored reflectance from named maps and their projections as text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Singles
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.geometry.factor_words import Factor
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored

_LIGHTS_AND_VIEWS = (("wi", "wo"), ("|wi|", "|wo|"))


def build_factored(
    factors: tuple[Factor, ...],
    maps: Mapping[str, Singles],
    alpha: npt.ArrayLike,
    *,
    peak: tuple[Factor, ...] = (),
    logarithmic: bool = True,
    source: str = "",
    facts: Mapping[str, Any] | None = None,
) -> Factored:
    """Return the product of ``factors`` and the added one of ``peak``, from maps (n, 3) or (n, n, 3) by their names.

    A map over both light and view becomes p, one over the half vector q; the others stand beside them.

    Raises
    ------
    ValueRangeError
        A map is missing or is not of the form that its factors read.
    """
    kept: dict[str, Singles] = {}
    for name, values in maps.items():
        kept[name] = np.array(values, np.float32, order="C")
        kept[name].flags.writeable = False
    rest = list(factors)
    p = q = np.ones((2, 3), np.float32)
    for light, view in _LIGHTS_AND_VIEWS:
        pair = next(
            (
                (one, other)
                for one in rest
                for other in rest
                if one.name == other.name and (one.projection.name, other.projection.name) == (light, view)
            ),
            None,
        )
        if pair is not None and len(rest) == len(factors):
            p = kept[pair[0].name]
            # One of each: a map that is read twice by the light stays once beside p.
            for factor in pair:
                rest.remove(factor)
    half = next((factor for factor in rest if factor.projection.name in ("h", "|h|")), None)
    if half is not None:
        q = kept[half.name]
        rest.remove(half)

    def read(some: list[Factor]) -> tuple[MapFactor, ...]:
        return tuple(
            MapFactor(factor.projection.name, kept[factor.name], logarithmic, factor.name) for factor in some
        )

    return Factored(
        p,
        q,
        alpha,
        source=source,
        facts=facts or {},
        more=read(rest),
        peak=read(list(peak)),
        logarithmic=logarithmic,
    )


def factored_paint_reflectance(paint: FactoredPaint) -> Factored:
    """Return the reflectance of a factored paint without its clearcoat; its textures are read.

    Raises
    ------
    FileError, DocumentError
        The textures cannot be read, or are not the ones that are meant.
    """
    # What reads EXR files is loaded for such a paint alone.
    from brdf_suite.documents.factor_textures import read_textures

    factors, peak = paint.terms
    facts: dict[str, Any] = {"format": "product of textures", "factors": paint.factors}
    if paint.peak:
        facts["peak"] = paint.peak
    if paint.largest > 0.0:
        facts["largest"] = paint.largest
    return build_factored(
        factors,
        read_textures(paint),
        paint.alpha,
        peak=peak,
        logarithmic=paint.logarithmic,
        source=paint.source,
        facts=facts,
    )
