"""Table of a material's lobes over the angle from the mirror direction, for light_lobes.glsl.

A light from one direction needs Σ KDD_i cos^E_i γ and Σ KG_i cos^E_i γ. Both are tabulated over sqrt(sin γ/2), which
gives the narrow lobes most of the columns, up to 90°, where every lobe ends; so a light costs one look-up however many
lobes there are.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.realtime.material.flake_share import visible_flake_lobe
from brdf_suite.realtime.values import MaterialWeights

COLUMNS = 160
"""A lobe of exponent 50,000 is then right to 0.5 % of its peak between columns."""
ROWS = 3


def column_angles() -> Floats:
    """Return γ (:data:`COLUMNS`,) of the columns, radians, 0 to π/2."""
    along = np.linspace(0.0, 1.0, COLUMNS)
    return np.asarray(2.0 * np.arcsin(math.sqrt(0.5) * along**2))


def light_lobes(
    weights: MaterialWeights, flakes: Flakes | None = None, strength: float = 1.0
) -> NDArray[np.float32]:
    """Return the table (3, :data:`COLUMNS`, 4): base, gloss, visible flakes; KD's channels in the alphas."""
    gamma = column_angles()
    # 1 - cos γ = 2 sin²(γ/2) keeps its digits for narrow lobes; at 90° every lobe is 0.
    logarithm = np.log1p(-2.0 * np.sin(0.5 * gamma[:-1]) ** 2)
    powers = np.zeros((COLUMNS, len(weights.exponents)))
    powers[:-1] = np.exp(logarithm[:, None] * np.asarray(weights.exponents)[None, :])
    table = np.zeros((ROWS, COLUMNS, 4), np.float32)
    base = powers @ weights.kdd
    table[0, :, :3] = base
    table[1, :, :3] = powers @ weights.kg
    if flakes is not None and flakes.density_per_mm2 > 0.0:
        table[2, :, :3] = visible_flake_lobe(
            flakes, gamma, base, weights.theta_fit_rad, weights.ior, strength
        )
    table[:, :, 3] = weights.kd[:, None]
    return table
