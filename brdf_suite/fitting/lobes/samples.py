"""Fixed sample directions of a designed paint, so that the program's matrix never changes.

The base (flakes and pigment, seen through the coat) is sampled as paints are measured: light at 45°, view in
the plane of incidence over the aspecular angle γ.

The coat is sampled as an environment shows it: view at 45°, lights on rings around the view's mirror
direction, spaced evenly in log γ, each ring's value the mean over its azimuths of ``f_r·(N·L)``. Rings rather
than the plane of incidence alone, because a microfacet coat at 45° is narrower across the plane than in it: a
round lobe fitted in the plane holds 1/cos 45° = 1.41 times the energy. The ring mean is what a round lobe can
follow, and the weighted sum over rings is the coat's directional reflectance.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats

#: Incidence of the fit: 45°, where paints are measured (ASTM E2194).
THETA_FIT_RAD = np.pi / 4.0

#: Aspecular angles of the base's samples in degrees, and their weights. The three angles at which paints are
#: measured (15, 45, 110) count so much that an L1 fit passes through them wherever the lobes can; the dark
#: flank counts four times the bright one, because the eye judges ratios. 75°, where six-angle instruments measure
#: too, counts 10: that halves the error there and costs three-angle paints nothing. 25° does not: from a weight of
#: 20 on, it is met at the cost of 45° (docs/method/fit.md).
BASE_GAMMAS_DEG = (-30.0, -15.0, 0.0, 8.0, 15.0, 20.0, 25.0, 35.0, 45.0, 60.0, 75.0, 92.0, 110.0, 130.0)
BASE_WEIGHTS = (0.1, 0.3, 0.5, 0.5, 50.0, 1.0, 1.0, 1.0, 50.0, 4.0, 10.0, 4.0, 50.0, 0.3)

#: How high above the horizon a view is that is sampled at another incidence.
LEAST_ELEVATION_RAD = np.deg2rad(5.0)

#: Rings of the coat: the first, in radians, and the step in log γ; the last lies at or below 90°.
COAT_FIRST_RING_RAD = 0.001
COAT_LOG_STEP = 0.4
COAT_AZIMUTHS = 6


def _incidence(theta: float) -> tuple[Floats, Floats, Floats]:
    """Return light, its mirror direction, and the in-plane unit vector from there towards the normal."""
    light = np.array([-np.sin(theta), 0.0, np.cos(theta)])
    mirror = np.array([np.sin(theta), 0.0, np.cos(theta)])
    towards_normal = np.array([-np.cos(theta), 0.0, np.sin(theta)])
    return light, mirror, towards_normal


class BaseSamples:
    """Samples of the base: ``light`` (3,), ``views`` (n, 3), ``gamma_rad`` (n,), ``weights`` (n,)."""

    def __init__(
        self,
        theta_rad: float = THETA_FIT_RAD,
        gammas_deg: tuple[float, ...] = BASE_GAMMAS_DEG,
        raw_weights: tuple[float, ...] = BASE_WEIGHTS,
    ) -> None:
        self.theta_rad, self.gammas_deg = theta_rad, gammas_deg
        self.light, mirror, towards_normal = _incidence(theta_rad)
        self.gamma_rad: Floats = np.deg2rad(np.array(gammas_deg, np.float64))
        tilt = self.gamma_rad[:, None]
        self.views: Floats = np.cos(tilt) * mirror + np.sin(tilt) * towards_normal
        self.weights = np.array(raw_weights, np.float64)

    @classmethod
    def at(cls, theta_rad: float) -> BaseSamples:
        """Return the default samples for light at ``theta_rad``, those left out whose view would lie too low."""
        lowest = np.degrees(np.pi / 2.0 - LEAST_ELEVATION_RAD)
        pairs = zip(BASE_GAMMAS_DEG, BASE_WEIGHTS, strict=True)
        seen = [pair for pair in pairs if abs(np.degrees(theta_rad) - pair[0]) < lowest]
        gammas, weights = zip(*seen, strict=True)
        return cls(theta_rad, gammas, weights)

    def cosine_lobes(self, exponents: Floats) -> Floats:
        """Return ``(n, m)``: ``(R·V)^E``, 0 where the dot is negative."""
        return np.asarray(np.clip(np.cos(self.gamma_rad), 0.0, None)[:, None] ** exponents)


class CoatSamples:
    """Ring samples of the coat around the mirror direction of a view at ``theta_rad``.

    ``gamma_rad`` (n,) with the mirror direction itself first; ``view`` (3,); ``lights`` (n, azimuths, 3);
    ``cosines`` (n, azimuths) their ``N·L``, 0 below the horizon; ``lit`` (n,) the share of each ring above
    the horizon; ``solid_angle`` (n,) in sr, the weights of a trapezium rule over log γ, so that
    ``solid_angle @ ring_means`` is an integral over the directions above the horizon and within 90° of the
    mirror direction.
    """

    def __init__(
        self,
        theta_rad: float = THETA_FIT_RAD,
        first_ring_rad: float = COAT_FIRST_RING_RAD,
        log_step: float = COAT_LOG_STEP,
        azimuths: int = COAT_AZIMUTHS,
    ) -> None:
        self.view, mirror, towards_normal = _incidence(theta_rad)
        count = int(np.floor(np.log(np.pi / 2.0 / first_ring_rad) / log_step)) + 1
        rings = first_ring_rad * np.exp(log_step * np.arange(count))
        # The rings that the rule would have inside the first one, all with the value of the mirror direction.
        inner = np.exp(-2.0 * log_step) / (1.0 - np.exp(-2.0 * log_step))
        ring_angle = 2.0 * np.pi * np.sin(rings) * rings * log_step
        self.solid_angle = np.concatenate([[ring_angle[0] * inner], ring_angle])
        self.gamma_rad = np.concatenate([[0.0], rings])
        # Half a ring is enough: every isotropic reflectance is symmetric about the plane of incidence.
        azimuth = (np.arange(azimuths) + 0.5) * np.pi / azimuths
        around = np.cos(azimuth)[:, None] * towards_normal + np.sin(azimuth)[:, None] * [0.0, 1.0, 0.0]
        tilt = self.gamma_rad[:, None, None]
        self.lights: Floats = np.cos(tilt) * mirror + np.sin(tilt) * around
        self.cosines: Floats = np.clip(self.lights[..., 2], 0.0, None)
        self.lit: Floats = (self.lights[..., 2] > 0.0).mean(axis=1)

    def cosine_lobes(self, exponents: Floats) -> Floats:
        """Return ``(n, m)``: ring means of ``(R·L)^E`` above the horizon.

        Computed as ``exp(E·log1p(-2 sin²(γ/2)))``, which is exact for sharp lobes.
        """
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        return np.asarray(self.lit[:, None] * np.exp(log_cosine[:, None] * exponents))

    def lobe_energy(self, exponents: Floats) -> Floats:
        """Return ``(m,)``: ``(R·L)^E`` integrated above the horizon, sr: ``2π/(E+1)`` times the lit share."""
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        whole = np.exp(log_cosine[:, None] * exponents)
        share = (self.solid_angle * self.lit) @ whole / (self.solid_angle @ whole)
        return np.asarray(2.0 * np.pi / (exponents + 1.0) * share)
