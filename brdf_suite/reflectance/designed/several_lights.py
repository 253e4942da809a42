"""Base whose colour also depends on the light's angle: readings under two or more lights.

Interference pigments shift in colour with the angle between light and view. Each light's readings give a base of
their own over γ; between them the value is interpolated over θd, half the angle between light and view, which in
the readings' plane is |θ0 - γ/2| for a light at θ0. Beyond the outermost it is held.

Two lights may meet: the pair (15°, γ) is the pair (45°, γ) with light and view exchanged where γ/2 is 30°, so
there their θd are equal and, by reciprocity, so are their readings. Where their θd differ by less than a few
degrees the two are mixed, evenly where they meet, so that readings that disagree give no seam.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import angle_between, aspecular_angle
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase, Rule

# Radians of θd: lights nearer than this are mixed. Instruments' readings lie farther apart.
MEETING = np.radians(4.0)


@dataclass(frozen=True)
class SeveralLights:
    """Bases of the same paint, each from the readings of one light; interpolated over θd."""

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

    @cached_property
    def _lights(self) -> Floats:
        return np.array([base.illumination for base in self.bases])

    def shares(self, gamma: Floats, theta_d: Floats) -> Floats:
        """Return the share (k, ...) of each of k bases at γ and θd (...), radians; they sum to 1."""
        lights = self._lights.reshape((-1,) + (1,) * np.ndim(gamma))
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
    difference is.
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
    def through(cls, rule: Rule, gamma: Floats, rho: Floats) -> BorrowedRule:
        """Return the rule through readings ``rho`` (n, 3) at rising ``gamma`` (n,), n ≥ 1."""
        lent = rule(gamma)
        ratio = np.where(lent > 1e-4, rho / np.maximum(lent, 1e-4), 1.0)
        return cls(rule, gamma, ratio, rho - ratio * lent)
