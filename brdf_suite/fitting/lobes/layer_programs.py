"""Linear programs of a paint's two layers at one incidence: base to KD and KDD, coat to KG."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.program import PartProgram, build_program
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples

#: Weight of the row that holds the coat's energy against the rings' (columns sum to about 1): above 1 the
#: optimum keeps the energy exactly, because no gain on the rings can pay for losing it.
ENERGY_WEIGHT = 2.0


def base_program(
    samples: BaseSamples,
    exponents: Floats,
    *,
    weights: Floats | None = None,
    with_diffuse: bool = True,
) -> PartProgram:
    """Return the base's program for exponents ``(m,)``: columns KD, KDD_1 …, or without KD.

    ``weights`` ``(n,)`` > 0 of the rows; those of the samples where left out.
    """
    columns = samples.cosine_lobes(exponents)
    if with_diffuse:
        columns = np.concatenate([np.ones((samples.gamma_rad.size, 1)), columns], axis=1)
    cosine = float(np.cos(samples.theta_rad))
    return build_program(cosine * columns, samples.weights if weights is None else weights)


def coat_program(samples: CoatSamples, exponents: Floats) -> PartProgram:
    """Return the coat's program: columns KG_1 …, a row for each ring, and last the coat's energy."""
    rings, energy = samples.cosine_lobes(exponents), samples.lobe_energy(exponents)
    weights = np.concatenate([samples.solid_angle, [ENERGY_WEIGHT]])
    return build_program(np.concatenate([rings, energy[None, :]], axis=0), weights)


def with_energy(samples: CoatSamples, rings: Floats) -> Floats:
    """Return ring means ``(k, channels)`` of ``f_r·(N·L)`` and, in a last row, the energy that they add up to."""
    energy = samples.solid_angle @ rings
    result: Floats = np.concatenate([rings, energy[None, :]], axis=0)
    return result
