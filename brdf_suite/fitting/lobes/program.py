"""L1 programs of a paint's layers, scaled to numbers of order one: base to KD and KDD, coat to KG.

For n samples with targets b and weights w, and m columns M, find ``x ≥ 0`` that minimizes
``Σ_j w_j·|M x - b|_j``. Here rows are multiplied by their weights and columns by a scale, which leaves the
optimum where it is and gives the solver entries near 1: a gloss column of E = 50,000 otherwise differs from
one of E = 2 by five orders in what it means.

Weights that depend on the target are given beside it, as factors on the fixed ones: in the dual form they bound
the columns, so that the matrix stays (``solver``).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples

#: Entries below this are dropped: they are under the solver's own smallest matrix value.
SMALLEST_ENTRY = 1e-9
#: Weight of the row that holds the coat's energy against the rings' (columns sum to about 1): above 1 the
#: optimum keeps the energy exactly, because no gain on the rings can pay for losing it.
ENERGY_WEIGHT = 2.0
#: Smallest target that relative weights resolve, over the channel's largest: weights differ by 20 at most.
SMALLEST_SHARE = 0.05


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
        return np.asarray(rest.sum(axis=0))


def build_program(matrix: Floats, row_weights: Floats) -> PartProgram:
    """Scale ``matrix`` (n, m), entries ≥ 0, by ``row_weights`` (n,) > 0 and each column to a sum of 1.

    Raises
    ------
    FittingError
        A shape that does not fit, a value that is not finite or negative, or a weight that is not positive.
    """
    if matrix.ndim != 2 or row_weights.shape != matrix.shape[:1] or 0 in matrix.shape:
        shapes = f"of shape {matrix.shape} does not match {row_weights.shape} sample weights"
        raise FittingError(f"The fitting system {shapes}.")
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
    return np.asarray(np.concatenate([rings, energy[None, :]], axis=0))


Weighting = Literal["absolute", "relative", "solid angle"]
"""Sample weights of a fit: three choices, all relative to the magnitude of the targets.

absolute
    The weights that come with the samples: the measured angles of the base, the solid angle of the coat's rings.
relative
    The same over the target, so that a miss of a tenth counts the same in a dark sample as in a bright one. A
    target below a twentieth of the channel's largest counts as that twentieth: rounding must not rule the fit.
    These weights depend on the target; they bound the dual's columns and leave its matrix alone.
solid angle
    The solid angle that a sample represents. Targets hold the cosine of incidence already, so that this is the
    cosine-weighted error of the whole lobe, the mean L1 kin of the usual cosine-weighted RMS.
"""


def check_weighting(weighting: str) -> None:
    """Raise a FittingError where there is no such weighting."""
    if weighting not in get_args(Weighting):
        known = ", ".join(repr(name) for name in get_args(Weighting))
        raise FittingError(f"There is no sample weighting {weighting!r}; choose one of {known}.")


def relative_factors(target: Floats) -> Floats:
    """Return factors ``(n, channels)`` from 1 to 20 for ``target`` of that shape: the largest over each.

    ``target`` is not weighted. A channel of zeros gets ones.
    """
    sizes = np.abs(target)
    largest = sizes.max(axis=0)
    whole = np.where(largest > 0.0, largest, 1.0)
    shares = np.where(largest > 0.0, sizes / whole, 1.0)
    return np.asarray(1.0 / np.maximum(shares, SMALLEST_SHARE))


def ring_solid_angles(gamma_rad: Floats) -> Floats:
    """Return ``(n,)`` sr for ascending signed angles ``gamma_rad`` ``(n,)`` from the mirror direction.

    Each sample represents the directions nearer to it than to its neighbours, on its own side of the mirror
    direction; the outermost reach as far outwards as inwards. A sample alone gets 1.
    """
    if gamma_rad.size == 1:
        return np.ones(1)
    middles = 0.5 * (gamma_rad[1:] + gamma_rad[:-1])
    first, last = 2.0 * gamma_rad[0] - middles[0], 2.0 * gamma_rad[-1] - middles[-1]
    edges = np.concatenate([[first], middles, [last]])
    # Half of a cap of angle γ, with the sign of γ: differences are the half rings between two edges.
    caps = np.sign(edges) * np.pi * (1.0 - np.cos(edges))
    return np.asarray(np.diff(caps))
