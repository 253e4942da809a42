"""A clear dielectric coat over any base: Fresnel transmission, internal reflection, energy conservation.

    f_r = coat + base · T(θi) T(θo) / T̄ · (1 - K) / (1 - K E_b)

T is what the coat lets through: all that it does not reflect, 1 - F of a smooth one, and of a rough one 1 - E with
the albedo E of its facets (:mod:`~brdf_suite.reflectance.facet_albedo`; ``scattering`` "single" takes 1 - F always).
Light that the base sends up is reflected back down by the inside of the coat with the share K, falls on the base of
albedo E_b again, and so on: a geometric series.

A matt base (``spread`` 1) sends up light in all directions, of which K = K_r = 1 - (1 - E_F)/n² stays inside, E_F
being the share of even light that the coat reflects; T̄ = 1 - E_F, so that (1 - K)/T̄ = 1/n² is the widening of the
solid angle at the surface. A mirror below (``spread`` 0) sends up one direction, K = 1 - √(T(θi) T(θo)), which of a
smooth coat is F there, and T̄ = 1 - K: the sum over all bounces of a mirror pair, T²/(1 - F E_b). Between them K and
T̄ are mixed.
So a white base of either kind reflects all light; nothing is made and nothing lost (without T̄, which some
renderers leave out, a white matt base under n = 1.5 would lose 9 % of what enters). In between it is a model, and
``energy_conserving`` says where it is sure.

Not for a base that was measured through its coat: that one has been through all this.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import SCATTERINGS, Scattering
from brdf_suite.documents.parameter import Parameter, check_choices, set_numbers
from brdf_suite.geometry.directions import spherical
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.albedo import directional_albedo, hemispherical_albedo
from brdf_suite.reflectance.designed import coat_lobe
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.facet_albedo import entering, mean_reflected
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance
from brdf_suite.reflectance.protocol import Reflectance

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        **coat_lobe.PARAMETERS,
        "spread": Parameter("Spread", "", 0.0, 1.0, 1.0, "How far the base spreads light: 0 mirror, 1 matt"),
    }
)

_BOUND_DEG = np.array([0.0, 20.0, 40.0, 50.0, 60.0, 70.0, 75.0, 80.0, 85.0, 88.0])


@dataclass(frozen=True, eq=False)
class Coated(mixture.MixtureSampled):
    """``base`` under a clearcoat; reciprocal where the base is."""

    base: Reflectance
    ior: float = 1.5
    roughness: float = 0.005
    spread: float = 1.0
    scattering: Scattering = "multiple"
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "ior", "roughness", "spread")
        check_choices(self, scattering=SCATTERINGS)

    @property
    def reciprocal(self) -> bool:
        """Return whether light and view may be exchanged."""
        return bool(getattr(self.base, "reciprocal", False))

    @cached_property
    def energy_conserving(self) -> bool:
        """Return whether the whole certainly reflects no more than it gets.

        The series knows the base by its mean albedo and its spread only. Between a matt base and a mirror, or with
        the wrong spread, it may give a white base a few per cent too much. So this bounds the base's part: its
        factor grows with T(θi), which is largest along the normal, and multiplies the largest albedo of the base.
        """
        if not getattr(self.base, "energy_conserving", False):
            return False
        theta = np.radians(_BOUND_DEG)
        passed = self.entering(np.cos(theta))
        largest = directional_albedo(self.base, spherical(theta, math.pi), 32).max(axis=0)
        return bool(np.all(1.0 - passed[:, None] + self._series(passed * passed[0]) * largest <= 1.0))

    @cached_property
    def coat(self) -> CoatLobe:
        """The coat's own lobe."""
        return CoatLobe(self.ior, self.roughness, self.scattering)

    def entering(self, cosine: npt.ArrayLike) -> Floats:
        """Return T (...), what the coat lets through at cosines (...)."""
        return entering(cosine, self.ior, self.coat.crossing_roughness)

    @property
    def mean_reflected(self) -> float:
        """E_F, the share of even light that the coat reflects."""
        return mean_reflected(self.ior, self.coat.crossing_roughness)

    @cached_property
    def base_albedo(self) -> Floats:
        """E_b (3,), at most 1, of the base without its coat."""
        return np.minimum(hemispherical_albedo(self.base), 1.0)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        value = self.base.eval(wi, wo) * self.base_factor(wi, wo)
        return np.asarray(value + self.coat.eval_grey(wi, wo)[..., None])

    def base_factor(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return (..., 3) what the base's f_r is multiplied by, seen through the coat; 0 at the horizon."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        return self._series(self.entering(wi[..., 2]) * self.entering(wo[..., 2]))

    def _series(self, through: Floats) -> Floats:
        """Return the factor on the base (..., 3) for the product T(θi) T(θo) (...)."""
        even = self.mean_reflected
        one_way = np.sqrt(np.maximum(through, 1e-30))
        inner = 1.0 - (1.0 - even) / self.ior**2
        stays = (1.0 - self.spread) * (1.0 - one_way) + self.spread * inner
        mean = (1.0 - self.spread) * one_way + self.spread * (1.0 - even)
        return np.asarray(
            (through / mean * (1.0 - stays))[..., None] / (1.0 - stays[..., None] * self.base_albedo)
        )

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        base, coat = luminance(self.base_albedo), 0.02 + 2.0 * float(fresnel_dielectric(1.0, self.ior))
        draw, density = getattr(self.base, "sample", None), getattr(self.base, "pdf", None)
        own = mixture.diffuse(max(base, 0.05))
        if draw is not None and density is not None:
            # Two numbers are left for the base, which wants three: the second is spread over two.
            own = mixture.MixturePart(max(base, 0.05), lambda wo, u: draw(wo, _three(u)), density)
        # What several facets send back goes everywhere, whatever the base does.
        further = [mixture.diffuse(0.02)] if self.coat.multiple is not None else []
        return [own, mixture.beckmann(coat, self.roughness), *further]


def _three(u: Floats) -> Floats:
    """Return three uniform numbers (n, 3) from two: the choice uses the leading digits of the second."""
    cells = 4096.0
    scaled = u[:, 1] * cells
    choice = np.floor(scaled)
    return np.stack((u[:, 0], scaled - choice, (choice + 0.5) / cells), axis=-1)
