"""Weighted, relative targets of the joint programs from samples of a paint.

Relative, because smoothness compares the weights of neighbouring incidences: what Fresnel's equations do to all of
them alike is divided out here, and multiplied in again where the weights are made.

**The coat's rest.** Round lobes cannot be as wide in the plane of incidence as a coat's facets are there and narrow
across. They hold the coat's energy, and so a matte coat (Beckmann α = .08) comes out a quarter too dark at 15° in the
plane, where colours are read: 1.3 to 2.1 ΔE00. What the coat shows there beyond its fitted lobes, on the normal's
side from the first angle at which paints are read, is therefore left to the base. A glossy coat has no such rest.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.angles.samples import AngleBaseSamples, AngleCoatSamples
from brdf_suite.fitting.lobes.angles.weights import gloss_brdf, leaving
from brdf_suite.fitting.lobes.checks import check_targets
from brdf_suite.fitting.lobes.program import PartProgram
from brdf_suite.geometry.fresnel import fresnel_dielectric

#: Smallest aspecular angle at which paints are read.
NEAREST_READING_RAD = np.deg2rad(15.0) - 1e-9


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
