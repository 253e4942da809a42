"""Samples at several incidences, and the joint program of a part over all: its residuals and its weights' variation.

For incidence k with matrix M_k, weights w_k and targets b_k, and unknowns x_k ≥ 0,

    min  Σ_k Σ_j w_kj |M_k x_k - b_k|_j  +  μ Σ_k Σ_i |x_(k+1),i - x_k,i|.

Each |x_(k+1),i - x_k,i| is one more row with the target 0, so the joint program has the form of a single one and
is solved in the same way: an edit changes the targets of the data rows and nothing else. An L1 penalty charges a
lobe for the total it rises and falls: a lobe that goes out at one angle and comes back at the next is charged
twice, one that fades steadily once.

The x are *relative* weights: what the layer's Fresnel factor does over the incidence is divided out of the targets
first, and multiplied in again where the weights are made. The weights of a paint whose flop has one shape at all
angles are then constant, and cost nothing.

**The coat's rest.** What a coat shows beyond its fitted lobes where colours are read, in the plane of incidence on
the normal's side from the first angle on, is left to the base: a basis has exponents, and coats lie between them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles.weights import AngleGrid, crossing, gloss_brdf, gloss_lobes, leaving
from brdf_suite.fitting.lobes.checks import check_targets
from brdf_suite.fitting.lobes.program import ENERGY_WEIGHT, SMALLEST_ENTRY, PartProgram, build_program
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS, COAT_FIRST_RING_RAD
from brdf_suite.geometry.fresnel import fresnel_dielectric

#: Largest polar angle of a base sample's view, but for those of the measured incidence.
HORIZON_DEG = 75.0
#: The same for a base looked up halfway, whose pairs divide γ between light and view.
HALFWAY_HORIZON_DEG = 82.0
#: How much more pairs with the light at 45° weigh than the others, where they lie between the nodes of θd.
READ_WEIGHT = 3.0
COAT_RINGS = 22
COAT_AZIMUTHS = 8
#: From this ring on, radians, a residual weighs so many times as much: it is small beside the peak, not beside a base.
COAT_TAIL, COAT_TAIL_WEIGHT = np.deg2rad(8.0), 100.0
#: Smallest aspecular angle at which paints are read.
NEAREST_READING_RAD = np.deg2rad(15.0) - 1e-9


class AngleBaseSamples:
    """Samples of the base at K incidences, one after the other, N in all.

    At each incidence the aspecular angles of the single fit, with its weights, as far as their views stand higher than
    :data:`HORIZON_DEG`: towards grazing the angles beyond the mirror direction end, and those past the normal remain.
    Lower views are left out, because the coat lets out less and less there: a reading at 110° with the view at 84°,
    counted as one of those that are measured, would pull down what is seen at 75°. At 45° the samples are those of the
    single fit, all of them.

    Wide facet lobes (Cook-Torrance) are brighter beyond the mirror direction than on the normal's side, and a paint
    read under several lights has another colour there; lobes are even in γ. But at a fixed θd, half the angle between
    light and view, any reciprocal reflectance is. So the samples of a base that is looked up ``halfway`` stand at
    θ + γ/2 and θ - γ/2 about each θ. The pairs with the light at 45° are added, as instruments measure them. They lie
    between two θ: their rows are those of both, mixed as the table is when it is read.

    ``lights``, ``views`` (N, 3); ``gamma_rad``, ``weights`` (N,); ``angle`` (N,) the index of the incidence or of θd,
    ``share`` (N,) that of the one above.
    """

    def __init__(
        self,
        grid: AngleGrid,
        gammas_deg: tuple[float, ...] = BASE_GAMMAS_DEG,
        raw_weights: tuple[float, ...] = BASE_WEIGHTS,
        halfway: bool = False,
    ) -> None:
        self.grid, self.halfway = grid, halfway
        theta = np.arccos(grid.cosines)
        gamma = np.deg2rad(np.array(gammas_deg, np.float64))
        towards = 0.5 * gamma if halfway else np.zeros_like(gamma)
        above, below = theta[:, None] + towards, theta[:, None] + towards - gamma
        if halfway:
            # The mirror direction is always there, also where the angle itself is lower than the others may be.
            lowest = np.maximum(np.deg2rad(HALFWAY_HORIZON_DEG), theta + 1e-9)[:, None]
            kept = (np.maximum(above, np.abs(below)) <= lowest) & (gamma >= 0.0)
        else:
            kept = np.abs(below) <= np.deg2rad(HORIZON_DEG)
            kept[grid.measured] = np.abs(below[grid.measured]) < np.pi / 2.0
        angle, sample = np.nonzero(kept)
        seen, light = below[angle, sample], above[angle, sample]
        share, nodes = np.zeros(len(angle)), len(angle)
        if halfway:
            measured = float(theta[grid.measured])
            read = np.flatnonzero((gamma > 0.0) & (np.abs(measured - gamma) <= np.deg2rad(HORIZON_DEG)))
            leaves = measured - gamma[read]
            between, part = grid.shares(np.cos(0.5 * (measured + leaves)))
            angle, share = np.concatenate([angle, between]), np.concatenate([share, part])
            sample, seen = np.concatenate([sample, read]), np.concatenate([seen, leaves])
            light = np.concatenate([light, np.full(leaves.size, measured)])
        self.angle, self.share = angle, share
        self.weights = np.array(raw_weights, np.float64)[sample]
        self.weights[nodes:] *= READ_WEIGHT
        zero = np.zeros_like(seen)
        self.lights = np.stack([-np.sin(light), zero, np.cos(light)], -1)
        self.views = np.stack([np.sin(seen), zero, np.cos(seen)], -1)
        self.gamma_rad: Floats = gamma[sample]

    def columns(self, exponents: Floats) -> Floats:
        """Return ``(N, 1 + m)``: 1, and ``(R·V)^E``, 0 where the dot is negative."""
        lobes = np.clip(np.cos(self.gamma_rad), 0.0, None)[:, None] ** exponents
        return np.asarray(np.concatenate([np.ones((lobes.shape[0], 1)), lobes], axis=1))


class AngleCoatSamples:
    """Rings of lights around the mirror directions of K views, as in the single fit.

    A microfacet lobe seen at θ is narrower across the plane of incidence than in it by cosθ. Even azimuths would miss
    it at grazing, and the rings of the single fit would begin outside it: so the first ring lies at .001 cosθ, and the
    azimuths are denser towards the plane, φ = cosθ·sinh(s) with even s, each counted by dφ/ds. The energy of Beckmann
    coats then comes out within 1.5 % (docs/method/incidence.md).

    ``gamma_rad`` (K, n), the mirror direction first; ``views`` (K, 1, 1, 3); ``lights`` (K, n, a, 3); ``cosines``
    (K, n, a): N·L times what the azimuth adds to its ring's mean, 0 below the horizon; ``solid_angle`` (K, n) in sr, a
    trapezium rule over log γ up to 90°; ``weights`` (K, n) of the fit.
    """

    def __init__(
        self,
        grid: AngleGrid,
        first_ring_rad: float = COAT_FIRST_RING_RAD,
        rings: int = COAT_RINGS,
        azimuths: int = COAT_AZIMUTHS,
    ) -> None:
        self.grid = grid
        cosine = grid.cosines
        sine = np.sqrt(1.0 - cosine * cosine)
        zero = np.zeros_like(cosine)
        mirror = np.stack([sine, zero, cosine], -1)[:, None, None, :]
        towards_normal = np.stack([-cosine, zero, sine], -1)[:, None, None, :]
        # The rule's last cell ends at 90°, half a step beyond its ring.
        first = first_ring_rad * cosine[:, None]
        step = np.log(np.pi / 2.0 / first) / (rings - 0.5)
        angles = first * np.exp(step * np.arange(rings))
        inner = np.exp(-2.0 * step) / (1.0 - np.exp(-2.0 * step))
        ring_angle = 2.0 * np.pi * np.sin(angles) * angles * step
        self.solid_angle = np.concatenate([ring_angle[:, :1] * inner, ring_angle], axis=1)
        self.gamma_rad = np.concatenate([zero[:, None], angles], axis=1)
        self.weights = self.solid_angle * np.where(self.gamma_rad > COAT_TAIL, COAT_TAIL_WEIGHT, 1.0)
        self.views = np.stack([-sine, zero, cosine], -1)[:, None, None, :]
        phi, share = _azimuths(cosine, azimuths // 2)
        turned = np.cos(phi)[:, None, :, None] * towards_normal
        turned = turned + np.sin(phi)[:, None, :, None] * np.array([0.0, 1.0, 0.0])
        tilt = self.gamma_rad[:, :, None, None]
        self.lights: Floats = np.cos(tilt) * mirror + np.sin(tilt) * turned
        shares = np.where(self.lights[..., 2] > 0.0, share[:, None, :], 0.0)
        self.cosines: Floats = shares * self.lights[..., 2]
        self._lit: Floats = np.sqrt(shares * self.cosines / cosine[:, None, None])

    def cosine_lobes(self, exponents: Floats) -> Floats:
        """Return ``(K, n, m)``: ring means of the gloss lobes times √(N·L/N·V), above the horizon."""
        found = np.zeros((*self.gamma_rad.shape, exponents.size))
        for place in range(self.lights.shape[2]):
            lobes = gloss_lobes(exponents, self.lights[:, :, place], self.views[:, :, 0])
            found += self._lit[:, :, place, None] * lobes
        return found

    def lobe_energy(self, exponents: Floats) -> Floats:
        """Return ``(K, m)``: the gloss lobes integrated above the horizon, sr."""
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        whole = (self.solid_angle[..., None] * np.exp(log_cosine[..., None] * exponents)).sum(axis=1)
        lit = (self.solid_angle[..., None] * self.cosine_lobes(exponents)).sum(axis=1)
        return np.asarray(2.0 * np.pi / (exponents + 1.0) * lit / whole)


def _azimuths(cosine: Floats, quarter: int) -> tuple[Floats, Floats]:
    """Return φ and its share of the ring, each ``(K, 2 quarter)``, on half a ring, dense about 0 and π.

    Half a ring is enough: an isotropic reflectance is symmetric about the plane of incidence.
    """
    end = np.arcsinh(np.pi / 2.0 / cosine)[:, None]
    s = (np.arange(quarter) + 0.5) / quarter * end
    phi = cosine[:, None] * np.sinh(s)
    share = 0.5 * np.cosh(s) / np.sinh(end) * (end / quarter)
    # The midpoint rule is exact for a lobe that ends within the quarter, not for a constant: the little that its
    # shares miss of the whole goes farthest from the plane, where a narrow lobe has nothing.
    share[:, -1] += 0.5 - share.sum(axis=1)
    return np.concatenate([phi, np.pi - phi], axis=1), np.concatenate([share, share], axis=1)


def base_program(samples: AngleBaseSamples, exponents: Floats, smoothness: float) -> PartProgram:
    """Return the base's joint program; unknowns angle by angle, KD and then KDD_i in each."""
    rows = Rows(samples.columns(exponents), samples.weights, samples.angle, samples.share)
    return joint_program(rows, samples.grid, smoothness)


def coat_program(samples: AngleCoatSamples, exponents: Floats, smoothness: float) -> PartProgram:
    """Return the coat's joint program; at each angle KG_i, the last data row the coat's energy."""
    rings, energy = samples.cosine_lobes(exponents), samples.lobe_energy(exponents)
    count = samples.grid.count
    # A lobe's energy, moved or lost, gains at most the tail's weight on the rings and 2 μ in smoothness: losing it
    # never pays.
    dominating = np.full((count, 1), COAT_TAIL_WEIGHT * ENERGY_WEIGHT * (1.0 + 2.0 * smoothness))
    matrix = np.concatenate([rings, energy[:, None, :]], axis=1)
    weights = np.concatenate([samples.weights, dominating], axis=1)
    angle = np.repeat(np.arange(count), matrix.shape[1])
    rows = Rows(matrix.reshape(-1, exponents.size), weights.ravel(), angle, np.zeros(angle.size))
    return joint_program(rows, samples.grid, smoothness, 1.0 / energy[samples.grid.measured])


class Rows(NamedTuple):
    """Rows ``matrix`` (n, m) of one incidence or of two, with ``weights``, ``angle`` and ``share`` (n,).

    ``angle`` is the incidence, ``share`` that of the one above, between 0 and 1.
    """

    matrix: Floats
    weights: Floats
    angle: NDArray[np.intp]
    share: Floats


def joint_program(
    rows: Rows, grid: AngleGrid, smoothness: float, column_scale: Floats | None = None
) -> PartProgram:
    """Join the rows of K systems by smoothness μ ≥ 0 in one scaled program.

    The columns of all incidences are scaled by one factor per lobe (m,), so that differences between incidences mean
    the same for each lobe: ``column_scale``, or what scales a column's weighted sum at 45° to 1.

    Raises
    ------
    FittingError
        μ is negative or not finite, or a system is not one that can be fitted.
    """
    if not (np.isfinite(smoothness) and smoothness >= 0.0):
        raise FittingError(f"The smoothness over the angles is {smoothness:g}; it must be 0 or more.")
    count, (samples, unknowns) = grid.count, rows.matrix.shape
    if not (np.isfinite(rows.matrix).all() and (rows.matrix >= 0.0).all() and (rows.weights > 0.0).all()):
        raise FittingError("The system of one incidence holds a negative or not finite entry.")
    measured = (rows.angle == grid.measured) & (rows.share == 0.0)
    scale = build_program(rows.matrix[measured], rows.weights[measured]).column_scale
    if column_scale is not None:
        scale = column_scale
    ties = (count - 1) * unknowns if smoothness > 0.0 else 0
    joint = np.zeros((samples + ties, count * unknowns))
    weighted = rows.weights[:, None] * rows.matrix * scale
    row = np.arange(samples)[:, None]
    column = rows.angle[:, None] * unknowns + np.arange(unknowns)
    joint[row, column] = (1.0 - rows.share)[:, None] * weighted
    between = rows.share > 0.0
    joint[row[between], column[between] + unknowns] = rows.share[between, None] * weighted[between]
    if ties:
        tie = np.arange(ties)
        joint[samples + tie, tie] = smoothness
        joint[samples + tie, tie + unknowns] = -smoothness
    joint[np.abs(joint) < SMALLEST_ENTRY] = 0.0
    return PartProgram(joint, np.concatenate([rows.weights, np.ones(ties)]), np.tile(scale, count))


@dataclass(frozen=True, eq=False)
class AngleSamples:
    """Samples of a fit: f_r of the base and of the coat at ``base_samples`` (N, 3), and the coat's ring means.

    ``rings`` ``(K, n, 3)`` are means of ``f_r·(N·L)`` at ``coat_samples``; ``seconds`` is what sampling took.
    """

    base: Floats
    coat: Floats
    rings: Floats
    ior: float
    base_under_coat: bool = True
    seconds: float = 0.0


def check_samples(samples: AngleSamples, flat: AngleBaseSamples, rings: AngleCoatSamples) -> AngleSamples:
    """Return ``samples`` as float64 of the right shapes, or raise a FittingError that names the first bad one."""
    theta = np.arccos(np.clip(flat.grid.cosines, 0.0, 1.0))

    def checked(part: str, values: Floats, gamma_rad: Floats, theta_rad: Floats) -> Floats:
        def where(place: tuple[int, ...]) -> str:
            gamma, light = np.rad2deg(gamma_rad[place]), np.rad2deg(theta_rad[place])
            return f"at the aspecular angle {gamma:.4g}° under light at {light:.4g}°"

        return check_targets(f"The {part}", values, (*gamma_rad.shape, 3), where)

    light = np.arccos(np.clip(flat.lights[:, 2], 0.0, 1.0))
    around = np.broadcast_to(theta[:, None], rings.gamma_rad.shape)
    return replace(
        samples,
        base=checked("base", samples.base, flat.gamma_rad, light),
        coat=checked("coat", samples.coat, flat.gamma_rad, light),
        rings=checked("coat", samples.rings, rings.gamma_rad, around),
    )


def coat_target(
    program: PartProgram, rings: AngleCoatSamples, samples: AngleSamples
) -> tuple[Floats, Floats]:
    """Return the coat's weighted relative target, and what its weights are multiplied by, (K,)."""
    energy = np.einsum("knc,kn->kc", samples.rings, rings.solid_angle)
    mean = energy.mean(axis=1)
    # Where a coat reflects nothing at an angle, any scale will do for its zeros.
    scale = np.where(mean > 1e-12 * max(float(mean.max()), 1e-300), mean, 1.0)
    joined = np.concatenate([samples.rings, energy[:, None, :]], axis=1) / scale[:, None, None]
    return _weighted(program, joined.reshape(-1, 3)), scale


def base_target(
    program: PartProgram,
    flat: AngleBaseSamples,
    samples: AngleSamples,
    exponents: Floats,
    kg: Floats,
) -> tuple[Floats, Floats]:
    """Return the base's weighted relative target, and what its weights are multiplied by, (K,)."""
    whole = samples.base.copy()
    # The coat's rest: see the module.
    gloss = gloss_brdf(flat.grid, exponents, kg, flat.lights, flat.views)
    read = flat.gamma_rad >= NEAREST_READING_RAD
    whole[read] = np.maximum(whole[read] + samples.coat[read] - gloss[read], 0.0)
    scale = np.ones(flat.grid.count)
    if samples.base_under_coat:
        # Relative targets: the share of the incidence that the coat lets pass, and of the other directions.
        scale = (1.0 - fresnel_dielectric(flat.grid.cosines, samples.ior)) ** 2
        there = (1.0 - flat.share) * scale[flat.angle]
        there += flat.share * scale[np.minimum(flat.angle + 1, flat.grid.count - 1)]
        if flat.halfway:
            passing = crossing(flat.lights, flat.views, samples.ior)
        else:
            entered = flat.grid.cosines[flat.angle]
            passing = leaving(entered, flat.views[:, 2], np.cos(flat.gamma_rad), samples.ior)
        whole /= (there * passing)[:, None]
    return _weighted(program, whole), scale


def _weighted(program: PartProgram, values: Floats) -> Floats:
    """Return the target (n, 3) of ``program``: weighted ``values`` of the data rows, 0 for those of smoothness."""
    target = np.zeros((program.shape[0], 3))
    target[: len(values)] = program.row_weights[: len(values), None] * values
    return target
