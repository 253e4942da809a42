"""L1 program of one part, scaled to numbers of order one.

For n samples with targets b and weights w, and m columns M, find ``x ≥ 0`` that minimizes
``Σ_j w_j·|M x - b|_j``. Here rows are multiplied by their weights and columns by a scale, which leaves the
optimum where it is and gives the solver entries near 1: a gloss column of E = 50,000 otherwise differs from
one of E = 2 by five orders in what it means.

Weights that depend on the target are given beside it, as factors on the fixed ones: in the dual form they bound
the columns, so that the matrix stays (``solver``).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError

#: Entries below this are dropped: they are under the solver's own smallest matrix value.
SMALLEST_ENTRY = 1e-9


@dataclass(frozen=True, eq=False)
class PartProgram:
    """One part (base or coat) of the fit, the same for each colour channel.

    Attributes
    ----------
    matrix
        ``(n, m)`` scaled system: rows times weights, columns times ``column_scale``. Entries of a sampled
        lobe are ≥ 0; rows that tie unknowns together, as a smoothness term does, may hold any sign.
    row_weights
        ``(n,)`` > 0: what a target is multiplied by.
    column_scale
        ``(m,)`` > 0: what a scaled solution is multiplied by to become lobe weights.
    """

    matrix: Floats
    row_weights: Floats
    column_scale: Floats

    @property
    def shape(self) -> tuple[int, int]:
        """Number of samples and number of columns."""
        return self.matrix.shape[0], self.matrix.shape[1]

    def residual_l1(self, solution: Floats, scaled_target: Floats, factors: Floats | None = None) -> Floats:
        """Return ``(channels,)``: ``Σ_j w_j·|M x - b|_j`` of scaled columns ``(m, channels)``.

        ``factors`` ``(n, channels)`` > 0 multiply the weights.
        """
        rest = np.abs(self.matrix @ solution - scaled_target)
        if factors is not None:
            rest *= factors
        result: Floats = rest.sum(axis=0)
        return result


def build_program(matrix: Floats, row_weights: Floats) -> PartProgram:
    """Scale ``matrix`` (n, m), entries ≥ 0, by ``row_weights`` (n,) > 0 and each column to a sum of 1.

    Raises
    ------
    FittingError
        A shape that does not fit, a value that is not finite or negative, or a weight that is not positive.
    """
    if matrix.ndim != 2 or row_weights.shape != matrix.shape[:1] or 0 in matrix.shape:
        raise FittingError(
            f"The fitting system of shape {matrix.shape} does not match {row_weights.shape} sample weights."
        )
    if not (np.isfinite(matrix).all() and (matrix >= 0.0).all()):
        raise FittingError("The fitting system holds a negative or not finite entry.")
    if not (np.isfinite(row_weights).all() and (row_weights > 0.0).all()):
        raise FittingError("A sample weight is not a positive finite number.")
    weighted = row_weights[:, None] * matrix
    sums = weighted.sum(axis=0)
    # A column that no sample sees must get no weight; scale 1 keeps it, and its zero entries leave it at 0.
    scale = 1.0 / np.where(sums > 0.0, sums, 1.0)
    scaled = weighted * scale
    scaled[scaled < SMALLEST_ENTRY] = 0.0
    return PartProgram(scaled, row_weights.copy(), scale)
