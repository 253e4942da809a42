"""A clearcoat over any term, as :class:`brdf_suite.reflectance.models.coated.Coated`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Vector
from brdf_suite.reference.bsdfs.terms import CoatLobeTerm, Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.models.coated import Coated, mean_fresnel


@dataclass(frozen=True, eq=False)
class UnderCoat:
    """``base`` seen through the coat of ``model``, and the coat."""

    model: Coated
    base: Any

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of the base and of the coat."""
        return (*self.base.samplers, *self.coat.samplers)

    @property
    def coat(self) -> CoatLobeTerm:
        """The coat's own lobe."""
        return CoatLobeTerm(self.model.ior, self.model.roughness)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.base.eval(light, view) * self.factor(light, view) + self.coat.eval(light, view)

    def factor(self, light: Vector, view: Vector) -> Colour:
        """Return what the base's f_r is multiplied by, seen through the coat."""
        m = self.model
        through = (1.0 - d.fresnel(light.z, m.ior)) * (1.0 - d.fresnel(view.z, m.ior))
        even = mean_fresnel(m.ior)
        one_way = dr.sqrt(dr.maximum(through, 1e-30))
        inner = 1.0 - (1.0 - even) / m.ior**2
        direct = d.number(1.0 - m.spread)
        stays = direct * (1.0 - one_way) + d.number(m.spread * inner)
        mean = direct * one_way + d.number(m.spread * (1.0 - even))
        albedo = d.colour(m.base_albedo.tolist())
        return (through / mean * (1.0 - stays)) / (1.0 - mi.Color3f(stays) * albedo)


@dataclass(frozen=True, eq=False)
class SeenThroughTerm:
    """A base seen through a coat, without the coat."""

    under: UnderCoat

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of the base."""
        return tuple(self.under.base.samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.under.base.eval(light, view) * self.under.factor(light, view)
