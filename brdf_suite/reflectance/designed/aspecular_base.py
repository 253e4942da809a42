"""Base of a paint from its aspecular readings, below the clearcoat.

A reading ρ(γ) at the light's polar angle θ0 has passed the coat twice, in with T(θ0) and out with T(θ0 - γ), T being
what the coat does not reflect (:func:`~brdf_suite.reflectance.facet_albedo.entering`). At other directions with the
same aspecular angle the light passes with other transmissions:

    f_r(wi, wo) = ρ(γ)/π · T(θi) T(θo) / (T(θ0) T(θ0 - γ)).

ρ(γ) is that of the normal's side; a reading beyond the mirror direction, at -γ, is referred to it by the same
transmissions before it becomes part of the rule. So a reading is returned as it was taken, and towards grazing
the base dims as the coat reflects more. γ is the unsigned angle between the view and the light's mirror
direction, also out of the plane of incidence
(Westlund and Meyer 2001). Or, for the flake rule, ρ is taken at the tilt of the flake that mirrors the light to
the view, which is what flakes do; in the readings' plane and light the two agree. Both are reciprocal.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import angle_between, aspecular_angle
from brdf_suite.reflectance.designed.rules import FlakeRule, squared_tilt, squared_tilt_between
from brdf_suite.reflectance.facet_albedo import entering

Rule = Callable[[Floats], Floats]


@dataclass(frozen=True)
class AspecularBase:
    """A base from a rule over the aspecular angle.

    Parameters
    ----------
    rule
        ρ (..., 3) at γ (...), radians, without the coat's own share but through the coat.
    nearest, farthest
        The smallest and the largest measured γ, radians. Beyond the farthest the value there is held.
    near_specular
        Scales the rule at γ = 0; fades to 1 at ``nearest``.
    illumination
        Polar angle of the light that the readings were taken with, radians.
    ior
        Index of the coat.
    by_half_vector
        Take the flake rule at the flake's tilt instead of at γ. Needs a :class:`FlakeRule`.
    roughness
        At which light crosses the coat; 0: a smooth coat, T = 1 - F.
    """

    rule: Rule
    nearest: float
    farthest: float
    near_specular: float
    illumination: float
    ior: float
    by_half_vector: bool = False
    roughness: float = 0.0

    def entering(self, cosine: npt.ArrayLike) -> Floats:
        """Return T (...), what the coat lets through at cosines (...)."""
        return entering(cosine, self.ior, self.roughness)

    def reflectance_factor(self, gamma: npt.ArrayLike) -> Floats:
        """Return ρ (..., 3), never negative, at γ (...), radians, under the readings' light."""
        held = np.minimum(np.abs(np.asarray(gamma, float)), self.farthest)
        return self._near_specular(self.rule(held), held)

    def _near_specular(self, rho: Floats, held: Floats) -> Floats:
        """``rho`` (..., 3) at ``held`` γ (...) with the factor of the mirror direction, never negative."""
        if self.near_specular != 1.0 and self.nearest > 0.0:
            # 1 at the mirror direction, 0 from the first reading on, with level ends: no kink appears.
            t = np.maximum(1.0 - held / self.nearest, 0.0)
            rho = rho * (1.0 + (self.near_specular - 1.0) * (t * t * (3.0 - 2.0 * t)))[..., None]
        return np.maximum(rho, 0.0)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        product = wi * wo
        cos_i, cos_o = wi[..., 2], wo[..., 2]
        cos_gamma = product[..., 2] - product[..., 0] - product[..., 1]
        gamma = np.minimum(np.arccos(np.minimum(np.maximum(cos_gamma, -1.0), 1.0)), self.farthest)
        above = (cos_i > 0.0) & (cos_o > 0.0)
        scale = np.where(above, self._crossing(cos_i, cos_o, gamma), 0.0)
        if self.by_half_vector and isinstance(self.rule, FlakeRule):
            # Beyond the farthest reading its value is held, here too.
            farthest = squared_tilt(np.array(self.farthest), self.illumination, self.ior)
            tilt = np.minimum(squared_tilt_between(wi, wo, self.ior), farthest)
            rho = self._near_specular(self.rule.at_squared_tilt(tilt), gamma)
        else:
            rho = self._near_specular(self.rule(gamma), gamma)
        return np.asarray(rho * scale[..., None])

    def _crossing(self, cos_i: Floats, cos_o: Floats, gamma: Floats) -> Floats:
        """Return T(θi) T(θo) / (π T(θ0) T(θ0 - γ)) (...); all four in one look-up, which few numbers take long for."""
        views = np.cos(self.illumination - gamma)
        here = [math.cos(self.illumination)]
        passed = self.entering(np.concatenate((here, views.ravel(), cos_i.ravel(), cos_o.ravel())))
        there, lit = 1 + views.size, 1 + views.size + cos_i.size
        both = passed[there:lit].reshape(cos_i.shape) * passed[lit:].reshape(cos_o.shape)
        return np.asarray(both / (math.pi * passed[0] * passed[1:there].reshape(views.shape)))


# Radians of θd: lights nearer than this are mixed. Instruments' readings lie farther apart.
MEETING = np.radians(4.0)


@dataclass(frozen=True)
class SeveralLights:
    """A base whose colour also depends on the light's angle: readings under two or more lights.

    Interference pigments shift in colour with the angle between light and view. Each light's readings give a base of
    their own over γ; between them the value is interpolated over θd, half the angle between light and view, which in
    the readings' plane is |θ0 - γ/2| for a light at θ0. Beyond the outermost it is held.

    Two lights may meet: the pair (15°, γ) is the pair (45°, γ) with light and view exchanged where γ/2 is 30°, so
    there their θd are equal and, by reciprocity, so are their readings. Where their θd differ by less than a few
    degrees the two are mixed, evenly where they meet, so that readings that disagree give no seam.
    """

    bases: tuple[AspecularBase, ...]

    @property
    def ior(self) -> float:
        """Return the index of the coat."""
        return self.bases[0].ior

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        gamma, theta_d = np.abs(aspecular_angle(wi, wo)), 0.5 * angle_between(wi, wo)
        values = np.stack([base.eval(wi, wo) for base in self.bases])
        return np.asarray(np.sum(self.shares(gamma, theta_d)[..., None] * values, axis=0))

    def shares(self, gamma: Floats, theta_d: Floats) -> Floats:
        """Return the share (k, ...) of each of k bases at γ and θd (...), radians; they sum to 1."""
        lights = np.array([base.illumination for base in self.bases]).reshape((-1,) + (1,) * np.ndim(gamma))
        measured = np.abs(lights - 0.5 * gamma)
        order = np.argsort(measured, axis=0, kind="stable")
        along = np.take_along_axis(measured, order, axis=0)
        ranked = np.zeros(along.shape)
        ranked[0] = 1.0
        for k in range(len(self.bases) - 1):
            span = np.maximum(along[k + 1] - along[k], 1e-12)
            passed = np.clip((theta_d - along[k]) / span, 0.0, 1.0)
            # Everything nearer gives way to the next light by this share.
            ranked[: k + 1] *= 1.0 - passed
            ranked[k + 1] = passed
        for k in range(len(self.bases) - 1):
            mixed = np.clip(1.0 - (along[k + 1] - along[k]) / MEETING, 0.0, 1.0)
            move = 0.5 * mixed * (ranked[k + 1] - ranked[k])
            ranked[k] += move
            ranked[k + 1] -= move
        shares = np.empty_like(ranked)
        np.put_along_axis(shares, order, ranked, axis=0)
        return shares


@dataclass(frozen=True)
class BorrowedRule:
    """The rule of another light, scaled so that it passes through one or two readings of its own.

    Two readings do not determine a curve. They determine how the colour differs from the other light's, so the
    ratio is interpolated over γ and held outside; where the other light's value is next to nothing, the
    difference is. Where the two lights meet (:class:`SeveralLights`) they are equal by reciprocity.
    """

    rule: Rule
    gamma: Floats
    ratio: Floats
    offset: Floats

    def __call__(self, gamma: Floats) -> Floats:
        """Return ρ (..., 3) at aspecular angles (...), radians."""
        channels = [
            rho * np.interp(gamma, self.gamma, self.ratio[:, c])
            + np.interp(gamma, self.gamma, self.offset[:, c])
            for c, rho in enumerate(np.moveaxis(self.rule(gamma), -1, 0))
        ]
        return np.stack(channels, axis=-1)

    @classmethod
    def through(cls, rule: Rule, gamma: Floats, rho: Floats, meeting: float) -> BorrowedRule:
        """Return the rule through readings ``rho`` (n, 3) at rising ``gamma`` (n,), n ≥ 1, and equal at ``meeting``.

        A reading that is as near to ``meeting`` as lights are mixed stands for itself.
        """
        lent = rule(gamma)
        ratio = np.where(lent > 1e-4, rho / np.maximum(lent, 1e-4), 1.0)
        offset = rho - ratio * lent
        if np.abs(gamma - meeting).min() > MEETING:
            place = int(np.searchsorted(gamma, meeting))
            ratio, offset = np.insert(ratio, place, 1.0, axis=0), np.insert(offset, place, 0.0, axis=0)
            gamma = np.insert(gamma, place, meeting)
        return cls(rule, gamma, ratio, offset)
