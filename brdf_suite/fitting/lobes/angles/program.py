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

**The coat's rest.** Round lobes cannot be as wide in the plane of incidence as a coat's facets are there and narrow
across. They hold the coat's energy, and so a matte coat (Beckmann α = .08) comes out a quarter too dark at 15° in the
plane, where colours are read: 1.3 to 2.1 ΔE00. What the coat shows there beyond its fitted lobes, on the normal's
side from the first angle at which paints are read, is therefore left to the base. A glossy coat has no such rest.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles.weights import AngleGrid, gloss_brdf, leaving
from brdf_suite.fitting.lobes.checks import check_targets
from brdf_suite.fitting.lobes.program import ENERGY_WEIGHT, SMALLEST_ENTRY, PartProgram, build_program
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS, COAT_FIRST_RING_RAD
from brdf_suite.geometry.fresnel import fresnel_dielectric

#: Largest polar angle of a base sample's view, but for those of the measured incidence.
HORIZON_DEG = 75.0
#: The same for a base of facets, whose pairs divide γ between light and view, and that no coat darkens there.
FACET_HORIZON_DEG = 82.0
COAT_RINGS = 22
COAT_AZIMUTHS = 8
#: Smallest aspecular angle at which paints are read.
NEAREST_READING_RAD = np.deg2rad(15.0) - 1e-9


class AngleBaseSamples:
    """Samples of the base at K incidences, one after the other, N in all.

    At each incidence the aspecular angles of the single fit, with its weights, as far as their views stand higher than
    :data:`HORIZON_DEG`: towards grazing the angles beyond the mirror direction end, and those past the normal remain.
    Lower views are left out, because the coat lets out less and less there: a reading at 110° with the view at 84°,
    counted as one of those that are measured, would pull down what is seen at 75°. At 45° the samples are those of the
    single fit, all of them.

    Wide facet lobes (Cook-Torrance) take no light's way through a coat; they are brighter beyond the mirror direction
    than on the normal's side, which lobes cannot be. But at a fixed θd, half the angle between light and view, any
    reciprocal reflectance is even in γ. So the samples of a base of ``facets`` stand at θ + γ/2 and θ - γ/2 about
    each θ.

    ``lights``, ``views`` (N, 3); ``gamma_rad``, ``weights`` (N,); ``angle`` (N,) the index of the incidence, or of
    θd for a base of ``facets``.
    """

    def __init__(
        self,
        grid: AngleGrid,
        gammas_deg: tuple[float, ...] = BASE_GAMMAS_DEG,
        raw_weights: tuple[float, ...] = BASE_WEIGHTS,
        facets: bool = False,
    ) -> None:
        self.grid, self.facets = grid, facets
        theta = np.arccos(grid.cosines)
        gamma = np.deg2rad(np.array(gammas_deg, np.float64))
        towards = 0.5 * gamma if facets else np.zeros_like(gamma)
        above, below = theta[:, None] + towards, theta[:, None] + towards - gamma
        if facets:
            # The mirror direction is always there, also where the angle itself is lower than the others may be.
            lowest = np.maximum(np.deg2rad(FACET_HORIZON_DEG), theta + 1e-9)[:, None]
            kept = (np.maximum(above, np.abs(below)) <= lowest) & (gamma >= 0.0)
        else:
            kept = np.abs(below) <= np.deg2rad(HORIZON_DEG)
            kept[grid.measured] = np.abs(below[grid.measured]) < np.pi / 2.0
        self.angle, sample = np.nonzero(kept)
        seen, light = below[self.angle, sample], above[self.angle, sample]
        zero = np.zeros_like(seen)
        self.lights = np.stack([-np.sin(light), zero, np.cos(light)], -1)
        self.views = np.stack([np.sin(seen), zero, np.cos(seen)], -1)
        self.gamma_rad: Floats = gamma[sample]
        self.weights = np.array(raw_weights, np.float64)[sample]

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
    (K, n, a): N·L times what the azimuth adds to its ring's mean, 0 below the horizon; ``lit`` (K, n) the share of
    each ring above the horizon; ``solid_angle`` (K, n) in sr, a trapezium rule over log γ up to 90°.
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
        self.views = np.stack([-sine, zero, cosine], -1)[:, None, None, :]
        phi, share = _azimuths(cosine, azimuths // 2)
        turned = np.cos(phi)[:, None, :, None] * towards_normal
        turned = turned + np.sin(phi)[:, None, :, None] * np.array([0.0, 1.0, 0.0])
        tilt = self.gamma_rad[:, :, None, None]
        self.lights: Floats = np.cos(tilt) * mirror + np.sin(tilt) * turned
        shares = np.where(self.lights[..., 2] > 0.0, share[:, None, :], 0.0)
        self.cosines: Floats = shares * self.lights[..., 2]
        self.lit: Floats = shares.sum(axis=2)

    def cosine_lobes(self, exponents: Floats) -> Floats:
        """Return ``(K, n, m)``: ring means of ``(R·L)^E`` above the horizon, exact for sharp lobes."""
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        return np.asarray(self.lit[..., None] * np.exp(log_cosine[..., None] * exponents))

    def lobe_energy(self, exponents: Floats) -> Floats:
        """Return ``(K, m)``: ``(R·L)^E`` integrated above the horizon, sr."""
        log_cosine = np.log1p(-2.0 * np.sin(self.gamma_rad / 2.0) ** 2)
        whole = self.solid_angle[..., None] * np.exp(log_cosine[..., None] * exponents)
        share = (self.lit[..., None] * whole).sum(axis=1) / whole.sum(axis=1)
        return np.asarray(2.0 * np.pi / (exponents + 1.0) * share)


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
    columns = samples.columns(exponents)
    blocks = [samples.angle == k for k in range(samples.grid.count)]
    matrices, weights = [columns[rows] for rows in blocks], [samples.weights[rows] for rows in blocks]
    return joint_program(matrices, weights, samples.grid, smoothness)


def coat_program(samples: AngleCoatSamples, exponents: Floats, smoothness: float) -> PartProgram:
    """Return the coat's joint program; at each angle KG_i, the last data row the coat's energy."""
    rings, energy = samples.cosine_lobes(exponents), samples.lobe_energy(exponents)
    # A lobe's energy, moved or lost, gains at most 1 on the rings and 2 μ in smoothness: losing it never pays.
    weight = [ENERGY_WEIGHT * (1.0 + 2.0 * smoothness)]
    return joint_program(
        [np.concatenate([rings[k], energy[k][None, :]]) for k in range(samples.grid.count)],
        [np.concatenate([angle, weight]) for angle in samples.solid_angle],
        samples.grid,
        smoothness,
        1.0 / energy[samples.grid.measured],
    )


def joint_program(
    matrices: list[Floats],
    weights: list[Floats],
    grid: AngleGrid,
    smoothness: float,
    column_scale: Floats | None = None,
) -> PartProgram:
    """Join K systems (n_k, m) with row weights (n_k,) by smoothness μ ≥ 0 in one scaled program.

    The columns of all incidences are scaled by one factor per lobe (m,), so that differences between incidences mean
    the same for each lobe: ``column_scale``, or what scales a column's weighted sum at 45° to 1.

    Raises
    ------
    FittingError
        μ is negative or not finite, or a system is not one that can be fitted.
    """
    if not (np.isfinite(smoothness) and smoothness >= 0.0):
        raise FittingError(f"The smoothness over the angles is {smoothness:g}; it must be 0 or more.")
    count, unknowns = len(matrices), matrices[0].shape[1]
    measured = build_program(matrices[grid.measured], weights[grid.measured])
    scale = measured.column_scale if column_scale is None else column_scale
    samples = sum(matrix.shape[0] for matrix in matrices)
    ties = (count - 1) * unknowns if smoothness > 0.0 else 0
    joint = np.zeros((samples + ties, count * unknowns))
    row_weights = np.ones(samples + ties)
    row = 0
    for k, (matrix, weight) in enumerate(zip(matrices, weights, strict=True)):
        if not (np.isfinite(matrix).all() and (matrix >= 0.0).all() and (weight > 0.0).all()):
            raise FittingError("The system of one incidence holds a negative or not finite entry.")
        rows = slice(row, row + len(weight))
        joint[rows, k * unknowns : (k + 1) * unknowns] = weight[:, None] * matrix * scale
        row_weights[rows] = weight
        row = rows.stop
    if ties:
        tie = np.arange(ties)
        joint[samples + tie, tie] = smoothness
        joint[samples + tie, tie + unknowns] = -smoothness
    joint[np.abs(joint) < SMALLEST_ENTRY] = 0.0
    return PartProgram(joint, row_weights, np.tile(scale, count))


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

    around = np.broadcast_to(theta[:, None], rings.gamma_rad.shape)
    return replace(
        samples,
        base=checked("base", samples.base, flat.gamma_rad, theta[flat.angle]),
        coat=checked("coat", samples.coat, flat.gamma_rad, theta[flat.angle]),
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
    entered = flat.grid.cosines[flat.angle]
    whole = samples.base.copy()
    # The coat's rest: see the module.
    gloss = gloss_brdf(flat.grid, exponents, kg, flat.lights, flat.views)
    read = flat.gamma_rad >= NEAREST_READING_RAD
    whole[read] = np.maximum(whole[read] + samples.coat[read] - gloss[read], 0.0)
    scale = np.ones(flat.grid.count)
    if samples.base_under_coat:
        # Relative targets: the share of the incidence that the coat lets pass, and of the view beyond the mirror.
        scale = (1.0 - fresnel_dielectric(flat.grid.cosines, samples.ior)) ** 2
        beyond = leaving(entered, flat.views[:, 2], np.cos(flat.gamma_rad), samples.ior)
        whole /= (scale[flat.angle] * beyond)[:, None]
    return _weighted(program, whole), scale


def _weighted(program: PartProgram, values: Floats) -> Floats:
    """Return the target (n, 3) of ``program``: weighted ``values`` of the data rows, 0 for those of smoothness."""
    target = np.zeros((program.shape[0], 3))
    target[: len(values)] = program.row_weights[: len(values), None] * values
    return target
