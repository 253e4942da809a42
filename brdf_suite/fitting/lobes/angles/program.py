"""Joint program of one part over all incidences: the residuals at each, and the variation of the weights.

For incidence k with matrix M_k, weights w_k and targets b_k, and unknowns x_k ≥ 0,

    min  Σ_k Σ_j w_kj |M_k x_k - b_k|_j  +  μ Σ_k Σ_i |x_(k+1),i - x_k,i|.

Each |x_(k+1),i - x_k,i| is one more row with the target 0, so the joint program has the form of a single one and
is solved in the same way: an edit changes the targets of the data rows and nothing else. An L1 penalty charges a
lobe for the total it rises and falls: a lobe that goes out at one angle and comes back at the next is charged
twice, one that fades steadily once.

The x are *relative* weights: what the layer's Fresnel factor does over the incidence is divided out of the targets
first. The weights of a paint whose flop has one shape at all angles are then constant, and cost nothing.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles.grid import AngleGrid
from brdf_suite.fitting.lobes.angles.samples import AngleBaseSamples, AngleCoatSamples
from brdf_suite.fitting.lobes.layer_programs import ENERGY_WEIGHT
from brdf_suite.fitting.lobes.program import SMALLEST_ENTRY, PartProgram, build_program


def base_program(samples: AngleBaseSamples, exponents: Floats, smoothness: float) -> PartProgram:
    """Return the base's joint program; unknowns angle by angle, KD and then KDD_i in each."""
    matrix = samples.columns(exponents)
    blocks = [samples.angle == k for k in range(samples.grid.count)]
    return joint_program(
        [matrix[rows] for rows in blocks],
        [samples.weights[rows] for rows in blocks],
        samples.grid,
        smoothness,
    )


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
