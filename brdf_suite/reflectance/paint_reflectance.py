"""A designed paint as a reflectance: the base under its clearcoat, and the coat's own lobe."""

from __future__ import annotations

from dataclasses import dataclass

import numpy.typing as npt

from brdf_suite.geometry.directions import Floats
from brdf_suite.reflectance.aspecular_base import AspecularBase
from brdf_suite.reflectance.coat_lobe import CoatLobe


@dataclass(frozen=True)
class PaintReflectance:
    """Base and coat of a paint; ``notices`` are sentences for the user about how it was built."""

    base: AspecularBase
    coat: CoatLobe
    notices: tuple[str, ...] = ()

    @property
    def ior(self) -> float:
        """Return the index of refraction of the coat."""
        return self.coat.ior

    @property
    def roughness(self) -> float:
        """Return the Beckmann roughness of the coat."""
        return self.coat.roughness

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine, of base and coat; 0 below the horizon."""
        value = self.base.eval(wi, wo)
        value += self.coat.eval_grey(wi, wo)[..., None]
        return value
