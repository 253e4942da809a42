"""Split of a reflectance into a sharp coat and a base, as input of the lobe fit.

A designed paint is built of the two. A model of facet lobes has no coat by name, but its sharp lobes *are* what a
colourist calls the coat: the first surface's reflection. They are analytic, so they can be evaluated apart:

- Cook-Torrance: lobes of slope m ≤ :data:`SHARP_SLOPE` are the coat, kd and the other lobes the base. The coat's
  index is the one that reflects r along the normal, n = (1 + √r)/(1 - √r), since the model's F is that of a clear
  dielectric of this index. Nothing in the model takes light from the base for it: ``base_under_coat`` is False.
  Without a sharp lobe there is no coat: black, of index 1.
- A clearcoat over anything: the clearcoat is the coat, and what lies below is seen through it. Sharp lobes of
  Cook-Torrance below it go with it, for their energy (they are narrower than the base is sampled).

What no formula divides (a measured table) has no layers; its lobes are fitted undivided.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorranceLobe
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.designed.aspecular_base import SeveralLights
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.models.channels import luminance
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance, index_from_reflectance
from brdf_suite.reflectance.protocol import Layered, Reflectance

#: Largest facet slope m of a lobe that counts as coat.
SHARP_SLOPE = 0.1
#: Largest index that is given: F of a higher one hardly depends on the angle. It represents r = 1, F = 1.
LARGEST_IOR = 100.0
_FIT_COSINE = math.cos(math.pi / 4.0)


@dataclass(frozen=True)
class Layers:
    """Two layers and the coat's index. ``base_under_coat``: light for the base crosses the coat, so T² applies."""

    base: Reflectance
    coat: Reflectance
    ior: float
    base_under_coat: bool = True


@dataclass(frozen=True)
class Sum:
    """The sum of several reflectances."""

    terms: tuple[Reflectance, ...]

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        first, *others = (term.eval(wi, wo) for term in self.terms)
        return np.asarray(sum(others, first))


@dataclass(frozen=True)
class SeenThrough:
    """``part``, a fraction of the base of ``coated``, seen through the clearcoat."""

    coated: Coated
    part: Reflectance

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return np.asarray(self.part.eval(wi, wo) * self.coated.base_factor(wi, wo))


def has_cook_torrance_base(reflectance: Reflectance) -> bool:
    """Whether it is a sum of Cook-Torrance lobes, with a clearcoat or without."""
    return isinstance(reflectance.base if isinstance(reflectance, Coated) else reflectance, CookTorrance)


def depends_on_halfway(layers: Layered) -> bool:
    """Whether the base depends on the angle between light and view: wide facet lobes, or several lights."""
    return not layers.base_under_coat or isinstance(layers.base, SeveralLights)


def split_layers(reflectance: object, *, sharp_slope: float = SHARP_SLOPE) -> Layered | None:
    """Return the layers of ``reflectance``, or None where nothing divides it (measured data, other models).

    A designed paint is returned as it is. ``sharp_slope`` is the largest slope m of a Cook-Torrance lobe that
    counts as coat.

    >>> from brdf_suite.reflectance.models.table_1 import TABLE_1
    >>> layers = split_layers(CookTorrance(TABLE_1["table1_white"]))
    >>> round(layers.ior, 2)
    2.4
    """
    if isinstance(reflectance, PaintReflectance):
        return reflectance
    if isinstance(reflectance, CookTorrance):
        wide, sharp, ior = divide_lobes(reflectance, sharp_slope)
        return Layers(wide, sharp, ior, base_under_coat=False)
    if isinstance(reflectance, Coated):
        if not isinstance(reflectance.base, CookTorrance):
            return Layers(SeenThrough(reflectance, reflectance.base), reflectance.coat, reflectance.ior)
        wide, sharp, _ = divide_lobes(reflectance.base, sharp_slope)
        coat: Reflectance = reflectance.coat
        if sharp.paint.lobes:
            coat = Sum((coat, SeenThrough(reflectance, sharp)))
        return Layers(SeenThrough(reflectance, wide), coat, reflectance.ior)
    return None


def divide_lobes(
    model: CookTorrance, sharp_slope: float = SHARP_SLOPE
) -> tuple[CookTorrance, CookTorrance, float]:
    """Return (kd and wide lobes, sharp lobes, the sharp lobes' index); the index is 1 where there is none."""
    paint = model.paint
    wide = tuple(lobe for lobe in paint.lobes if lobe.m > sharp_slope)
    sharp = tuple(lobe for lobe in paint.lobes if lobe.m <= sharp_slope)
    return (
        CookTorrance(replace(paint, lobes=wide)),
        CookTorrance(replace(paint, kd=(0.0, 0.0, 0.0), lobes=sharp)),
        _common_index(sharp),
    )


def _common_index(lobes: Sequence[CookTorranceLobe]) -> float:
    """The index of the mean r of ``lobes``, each counted by what it reflects at 45°; 1 where that is nothing."""
    fresnel = [float(fresnel_dielectric(_FIT_COSINE, _index(lobe.r))) for lobe in lobes]
    shares = np.array([luminance(np.array(lobe.ks)) * f for lobe, f in zip(lobes, fresnel, strict=True)])
    if not lobes or shares.sum() <= 0.0:
        return 1.0
    return _index(float(shares @ np.array([lobe.r for lobe in lobes]) / shares.sum()))


def _index(r: float) -> float:
    return LARGEST_IOR if r >= 1.0 else min(index_from_reflectance(r), LARGEST_IOR)
