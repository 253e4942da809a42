"""Samples of a reflectance for factorization: measured ones, or pairs uniform over both hemispheres."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

DEFAULT_PAIRS = 57_600
"""As many as Table 1 of McCool, Ang and Ahmad 2001 has."""
DEFAULT_SEED = 2001
MOST_PAIRS = 4_000_000


@dataclass(frozen=True, eq=False)
class FactorizationSamples:
    """f_r ``values`` (n, 3) in 1/sr at unit directions ``wi``, ``wo`` (n, 3), local frame, working space.

    ``even``: whether the pairs are even over both hemispheres, so that a mean over them is one over directions.
    """

    wi: Floats
    wo: Floats
    values: Floats
    even: bool = False

    def __len__(self) -> int:
        return len(self.values)

    def part(self, keep: npt.ArrayLike) -> FactorizationSamples:
        """Return some of them: a mask (n,) or indices."""
        at = np.asarray(keep)
        return FactorizationSamples(self.wi[at], self.wo[at], self.values[at], self.even)

    def and_those(self, others: FactorizationSamples) -> FactorizationSamples:
        """Return these and ``others`` after them; no longer even."""
        pairs = ((self.wi, others.wi), (self.wo, others.wo), (self.values, others.values))
        wi, wo, values = (np.concatenate(pair) for pair in pairs)
        return FactorizationSamples(wi, wo, values)

    def held_out(
        self, share: float, seed: int = DEFAULT_SEED
    ) -> tuple[FactorizationSamples, FactorizationSamples]:
        """Return those to fit and those held out, drawn without order: ``share`` of all, 0 to 1."""
        order = np.random.default_rng(seed).permutation(len(self))
        count = round(share * len(self))
        return self.part(order[count:]), self.part(order[:count])


def even_directions(count: int, rng: np.random.Generator) -> Floats:
    """Return directions (count, 3) drawn evenly per solid angle over the upper hemisphere."""
    height, azimuth = rng.random((2, count))
    return spherical(np.arccos(height), 2.0 * np.pi * azimuth)


def sample_reflectance(
    reflectance: Reflectance, pairs: int = DEFAULT_PAIRS, seed: int = DEFAULT_SEED
) -> FactorizationSamples:
    """Return the samples of anything that reflects: measured ones of measured data, else ``pairs`` even ones.

    Samples of isotropic data say nothing of where their tangent lay: each is turned about the normal by an angle drawn
    from ``seed``, so that the maps have texels all around to be read.

    Raises
    ------
    ValueRangeError
        ``pairs`` is not 1 to 4,000,000.
    """
    rng = np.random.default_rng(seed)
    if isinstance(reflectance, IsotropicTable):
        return rotate_pairs(_of_table(reflectance), rng)
    if isinstance(reflectance, ScatteredSamples):
        found = FactorizationSamples(reflectance.wi, reflectance.wo, reflectance.values)
        return rotate_pairs(found, rng) if reflectance.isotropic else found
    if not 1 <= pairs <= MOST_PAIRS:
        raise ValueRangeError("pairs", f"expected 1 to {MOST_PAIRS:,}, not {pairs}")
    wi, wo = even_directions(pairs, rng), even_directions(pairs, rng)
    return FactorizationSamples(wi, wo, np.asarray(reflectance.eval(wi, wo)), even=True)


def samples_near_peak(reflectance: Reflectance, pairs: int, seed: int = DEFAULT_SEED) -> FactorizationSamples:
    """Return pairs whose half vectors lie about the normal, even in the root of their parabolic radius.

    Of pairs that are even over both hemispheres hardly one falls into the peak of a clearcoat.
    """
    rng = np.random.default_rng(seed + 1)
    root, turn, height, azimuth = rng.random((4, max(pairs, 1)))
    h = spherical(2.0 * np.arctan(root**2), 2.0 * np.pi * turn)
    wi = spherical(np.arccos(height), 2.0 * np.pi * azimuth)
    wo = warps.mirror_at(wi, h)
    above = wo[:, 2] > 0.0
    wi, wo = wi[above], wo[above]
    return FactorizationSamples(wi, wo, np.asarray(reflectance.eval(wi, wo)))


def rotate_pairs(samples: FactorizationSamples, rng: np.random.Generator) -> FactorizationSamples:
    """Return every pair turned about the normal by an angle of its own."""
    angle = rng.uniform(0.0, 2.0 * np.pi, len(samples))
    cos, sin = np.cos(angle), np.sin(angle)

    def turn(w: Floats) -> Floats:
        return np.stack((cos * w[:, 0] - sin * w[:, 1], sin * w[:, 0] + cos * w[:, 1], w[:, 2]), axis=-1)

    return FactorizationSamples(turn(samples.wi), turn(samples.wo), samples.values, samples.even)


def _of_table(table: IsotropicTable) -> FactorizationSamples:
    """Return the bins that were measured, at their centres."""
    mask = table.measured_mask()
    light, view = [], []
    for h in range(table.grid.theta_h):
        wi, wo = table.grid.pairs(h)
        light.append(wi[mask[h]])
        view.append(wo[mask[h]])
    return FactorizationSamples(
        np.concatenate(light), np.concatenate(view), table.values[mask].astype(np.float64)
    )
