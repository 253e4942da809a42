"""The maps of a factored reflectance as pictures: each once, over its largest value, drawn over what it depends on.

A map along the radius is drawn as the round map that it stands for; one over another single number as a band.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.factor_words import PROJECTIONS
from brdf_suite.geometry.parabolic import look_up_map, parabolic_direction
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.coated import Coated

RADIAL = ("|wi|", "|wo|", "|h|", "sqrt|h|")
_SIZE = 128
Form = Literal["disc", "square", "band"]


@dataclass(frozen=True, eq=False)
class FactorPicture:
    """A map as a picture.

    ``values`` (size, size, 3): the factor over its ``largest`` (3,), linear working space, t upwards; ``outside``:
    where a round one has no direction. ``reads``: the projections by which it is read; ``part``: of the product, or of
    the peak that is added; ``texels``: along an axis of the map itself.
    """

    name: str
    part: Literal["product", "peak"]
    reads: tuple[str, ...]
    form: Form
    values: Floats
    outside: npt.NDArray[np.bool_]
    largest: Floats
    texels: int


def factored_in(reflectance: object) -> Factored | None:
    """Return the factored reflectance that something is, alone or under a clearcoat; None where it is none."""
    base = reflectance.base if isinstance(reflectance, Coated) else reflectance
    return base if isinstance(base, Factored) else None


def factor_pictures(value: Factored) -> tuple[FactorPicture, ...]:
    """Return a picture of every map that is not the same everywhere, those of the product before those of the peak."""
    found: list[FactorPicture] = []
    for number, (_, factors) in enumerate(value.terms):
        kept: dict[int, list[MapFactor]] = {}
        for factor in factors:
            kept.setdefault(id(factor.values), []).append(factor)
        for same in kept.values():
            if np.ptp(same[0].values.reshape(-1, 3), axis=0).max() > 0.0:
                found.append(_picture(same, "product" if number == 0 else "peak"))
    return tuple(found)


def _picture(factors: list[MapFactor], part: Literal["product", "peak"]) -> FactorPicture:
    one = factors[0]
    along = (np.arange(_SIZE) + 0.5) / _SIZE
    x, y = np.meshgrid(along, 1.0 - along)
    radius = np.hypot(2.0 * x - 1.0, 2.0 * y - 1.0)
    outside = np.zeros(x.shape, np.bool_)
    form: Form = "square"
    if one.radial and one.projection in RADIAL:
        form, outside = "disc", radius > 1.0
        places = (np.sqrt(radius) if one.projection == "sqrt|h|" else radius)[..., None]
    elif one.radial:
        form, places = "band", x[..., None]
    else:
        if PROJECTIONS[one.projection].hemisphere:
            form, outside = "disc", radius > 1.0
        places = np.stack((x, y), axis=-1)
    held = one.values.astype(np.float64)
    read = look_up_map(
        np.log(held) if one.logarithmic else held, np.clip(places, 0.0, 1.0).reshape(_SIZE**2, -1)
    )
    values = (np.exp(read) if one.logarithmic else read).reshape(_SIZE, _SIZE, 3)
    largest = np.where(outside[..., None], 0.0, values).reshape(-1, 3).max(axis=0)
    shown = np.where(outside[..., None], 0.0, values / np.maximum(largest, 1e-300))
    reads = tuple(dict.fromkeys(factor.projection for factor in factors))
    return FactorPicture(one.name, part, reads, form, shown, outside, largest, len(one.values))


def angles_at(x: float, y: float) -> tuple[float, float] | None:
    """Return polar angle and azimuth in degrees at shares of a disc's width and height, from above; None outside."""
    s, t = 2.0 * x - 1.0, 1.0 - 2.0 * y
    if np.hypot(s, t) > 1.0:
        return None
    w = parabolic_direction(s, t)
    return float(np.degrees(np.arccos(np.clip(w[2], -1.0, 1.0)))), float(np.degrees(np.arctan2(w[1], w[0])))
