"""Fixed sample directions of fits at several incidences, evaluated in one call each.

**Base.** At each incidence the aspecular angles of the single fit, with its weights, as far as their views stand
higher than :data:`HORIZON_DEG`: towards grazing the angles beyond the mirror direction end, and those past the
normal remain. Lower views are left out, because the coat lets out less and less there: a reading at 110° with
the view at 84°, counted as one of those that are measured, would pull down what is seen at 75°. At 45° the samples
are those of the single fit, all of them.

**Base of facets.** Wide facet lobes (Cook-Torrance) take no light's way through a coat; they are brighter beyond the
mirror direction than on the normal's side, which lobes cannot be. But at a fixed θd, half the angle between light and
view, any reciprocal reflectance is even in γ. So their samples stand at θ + γ/2 and θ - γ/2 about each θ.

**Coat.** At each view angle rings of lights around the mirror direction, as in the single fit. A microfacet lobe
seen at θ is narrower across the plane of incidence than in it by cosθ. Even azimuths would miss it at grazing, and
the rings of the single fit would begin outside it: so the first ring lies at .001 cosθ, and the azimuths are denser
towards the plane, φ = cosθ·sinh(s) with even s, each counted by dφ/ds. The energy of Beckmann coats then comes out
within 1.5 % (docs/method/incidence.md).
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.angles.grid import AngleGrid
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS, COAT_FIRST_RING_RAD

#: Largest polar angle of a base sample's view, but for those of the measured incidence.
HORIZON_DEG = 75.0
#: The same for a base of facets, whose pairs divide γ between light and view, and that no coat darkens there.
FACET_HORIZON_DEG = 82.0
COAT_RINGS = 22
COAT_AZIMUTHS = 8


@dataclass(frozen=True, eq=False)
class AngleBaseSamples:
    """Samples of the base at K incidences, one after the other, N in all.

    ``lights``, ``views`` (N, 3); ``gamma_rad``, ``weights`` (N,); ``angle`` (N,) the index of the incidence, or of
    θd for a base of ``facets``.
    """

    grid: AngleGrid
    gammas_deg: tuple[float, ...] = BASE_GAMMAS_DEG
    raw_weights: tuple[float, ...] = BASE_WEIGHTS
    facets: bool = False
    lights: Floats = field(init=False)
    views: Floats = field(init=False)
    gamma_rad: Floats = field(init=False)
    weights: Floats = field(init=False)
    angle: NDArray[np.intp] = field(init=False)

    def __post_init__(self) -> None:
        theta = np.arccos(self.grid.cosines)
        gamma = np.deg2rad(np.array(self.gammas_deg, np.float64))
        towards = 0.5 * gamma if self.facets else np.zeros_like(gamma)
        above, below = theta[:, None] + towards, theta[:, None] + towards - gamma
        if self.facets:
            # The mirror direction is always there, also where the angle itself is lower than the others may be.
            lowest = np.maximum(np.deg2rad(FACET_HORIZON_DEG), theta + 1e-9)[:, None]
            kept = (np.maximum(above, np.abs(below)) <= lowest) & (gamma >= 0.0)
        else:
            kept = np.abs(below) <= np.deg2rad(HORIZON_DEG)
            kept[self.grid.measured] = np.abs(below[self.grid.measured]) < np.pi / 2.0
        angle, sample = np.nonzero(kept)
        seen, light = below[angle, sample], above[angle, sample]
        zero = np.zeros_like(seen)
        for name, value in {
            "lights": np.stack([-np.sin(light), zero, np.cos(light)], -1),
            "views": np.stack([np.sin(seen), zero, np.cos(seen)], -1),
            "gamma_rad": gamma[sample],
            "weights": np.array(self.raw_weights, np.float64)[sample],
            "angle": angle,
        }.items():
            object.__setattr__(self, name, value)

    def columns(self, exponents: Floats) -> Floats:
        """Return ``(N, 1 + m)``: 1, and ``(R·V)^E``, 0 where the dot is negative."""
        lobes = np.clip(np.cos(self.gamma_rad), 0.0, None)[:, None] ** exponents
        result: Floats = np.concatenate([np.ones((lobes.shape[0], 1)), lobes], axis=1)
        return result


@dataclass(frozen=True, eq=False)
class AngleCoatSamples:
    """Rings of lights around the mirror directions of K views.

    ``gamma_rad`` (K, n), the mirror direction first; ``views`` (K, 1, 1, 3); ``lights`` (K, n, a, 3); ``cosines``
    (K, n, a): N·L times what the azimuth adds to its ring's mean, 0 below the horizon; ``lit`` (K, n) the share of
    each ring above the horizon; ``solid_angle`` (K, n) in sr, a trapezium rule over log γ up to 90°.
    """

    grid: AngleGrid
    first_ring_rad: float = COAT_FIRST_RING_RAD
    rings: int = COAT_RINGS
    azimuths: int = COAT_AZIMUTHS
    gamma_rad: Floats = field(init=False)
    views: Floats = field(init=False)
    lights: Floats = field(init=False)
    cosines: Floats = field(init=False)
    lit: Floats = field(init=False)
    solid_angle: Floats = field(init=False)

    def __post_init__(self) -> None:
        cosine = self.grid.cosines
        sine = np.sqrt(1.0 - cosine * cosine)
        zero = np.zeros_like(cosine)
        mirror = np.stack([sine, zero, cosine], -1)[:, None, None, :]
        towards_normal = np.stack([-cosine, zero, sine], -1)[:, None, None, :]
        # The rule's last cell ends at 90°, half a step beyond its ring.
        first = self.first_ring_rad * cosine[:, None]
        step = np.log(np.pi / 2.0 / first) / (self.rings - 0.5)
        rings = first * np.exp(step * np.arange(self.rings))
        inner = np.exp(-2.0 * step) / (1.0 - np.exp(-2.0 * step))
        ring_angle = 2.0 * np.pi * np.sin(rings) * rings * step
        gamma = np.concatenate([zero[:, None], rings], axis=1)
        phi, share = self._azimuths(cosine)
        turned = np.cos(phi)[:, None, :, None] * towards_normal
        turned = turned + np.sin(phi)[:, None, :, None] * np.array([0.0, 1.0, 0.0])
        tilt = gamma[:, :, None, None]
        lights = np.cos(tilt) * mirror + np.sin(tilt) * turned
        shares = np.where(lights[..., 2] > 0.0, share[:, None, :], 0.0)
        for name, value in {
            "gamma_rad": gamma,
            "views": np.stack([-sine, zero, cosine], -1)[:, None, None, :],
            "lights": lights,
            "cosines": shares * lights[..., 2],
            "lit": shares.sum(axis=2),
            "solid_angle": np.concatenate([ring_angle[:, :1] * inner, ring_angle], axis=1),
        }.items():
            object.__setattr__(self, name, value)

    def _azimuths(self, cosine: Floats) -> tuple[Floats, Floats]:
        """Return φ and its share of the ring, each ``(K, azimuths)``, on half a ring, dense about 0 and π.

        Half a ring is enough: an isotropic reflectance is symmetric about the plane of incidence.
        """
        quarter = self.azimuths // 2
        end = np.arcsinh(np.pi / 2.0 / cosine)[:, None]
        s = (np.arange(quarter) + 0.5) / quarter * end
        phi = cosine[:, None] * np.sinh(s)
        share = 0.5 * np.cosh(s) / np.sinh(end) * (end / quarter)
        # The midpoint rule is exact for a lobe that ends within the quarter, not for a constant: the little that its
        # shares miss of the whole goes farthest from the plane, where a narrow lobe has nothing.
        share[:, -1] += 0.5 - share.sum(axis=1)
        return np.concatenate([phi, np.pi - phi], axis=1), np.concatenate([share, share], axis=1)

    def cosine_lobes(self, exponents: Floats) -> Floats:
        """Return ``(K, n, m)``: ring means of ``(R·L)^E`` above the horizon, exact for sharp lobes."""
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        lobes: Floats = self.lit[..., None] * np.exp(log_cosine[..., None] * exponents)
        return lobes

    def lobe_energy(self, exponents: Floats) -> Floats:
        """Return ``(K, m)``: ``(R·L)^E`` integrated above the horizon, sr."""
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        whole = self.solid_angle[..., None] * np.exp(log_cosine[..., None] * exponents)
        share = (self.lit[..., None] * whole).sum(axis=1) / whole.sum(axis=1)
        energy: Floats = 2.0 * np.pi / (exponents + 1.0) * share
        return energy
