"""Correction of a bin's mean reading to the reflectance at the bin's centre.

A table's value belongs to its bin's centre. The mean of a few readings belongs elsewhere: to where the readings
happen to lie, and, where the reflectance bends within the bin as in a highlight, to no one place at all. With the
logarithm of the reflectance taken as a parabola about the centre, slopes g and bends c along the three axes (index
space), the mean of readings with mean place x and spread s² in each axis is

    f₀ · exp(g·x + ½ Σ c x²) · (1 + ½ Σ (g² + c) s²),

to second order; s² is that of an even spread, 1/12, times 1 - 1/n. Slopes and bends are those of the table with its
holes filled, since around a highlight few bins have readings: there a ring is far narrower than a pixel. Two rounds:
the second takes its slopes from corrected values.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.table.hole_filling import fill_table_holes
from brdf_suite.acquisition.table.parameterization import Parameterization
from brdf_suite.arrays import Singles

ROUNDS = 2
_MOST = 1.0
"""No value is changed by more than a factor of e: beyond that no parabola holds."""

_STEEPEST = 2.0
"""ln f per bin. A steeper neighbour is noise, or the horizon."""


def centre_means(
    means: Singles,
    samples: Singles,
    trust: Singles,
    offsets: Singles,
    parameterization: Parameterization,
    rounds: int = ROUNDS,
) -> Singles:
    """Return values (a, b, c, 3) at the centres of the bins, for ``means`` of the same shape.

    ``samples`` (a, b, c) are the readings in each bin, 0 where there are none, and ``trust`` what they weigh as
    neighbours; ``offsets`` (a, b, c, 3) the readings' mean places less the bins' centres, in bins. Where there are no
    readings, the means are returned.
    """
    at = np.nonzero((samples > 0.0) & (means > 0.0).all(axis=3))
    x = offsets[at]
    spread = ((1.0 - 1.0 / samples[at]) / 12.0)[:, None]
    first = np.log(means[at])
    values = means.copy()
    for _ in range(rounds):
        whole, _known = fill_table_holes(values, trust, parameterization)
        np.log(whole, out=whole, where=whole > 0.0)
        moved, bent = np.zeros_like(first), np.zeros_like(first)
        for axis in range(3):
            slope, bend = _slope_and_bend(whole, at, axis, parameterization)
            place = x[:, axis, None]
            moved += (slope + 0.5 * bend * place) * place
            bent += 0.5 * (slope * slope + bend) * spread
        values[at] = np.exp(first - np.clip(moved + np.log1p(np.clip(bent, -0.5, 1.0)), -_MOST, _MOST))
    return values


def _slope_and_bend(
    logs: Singles, at: tuple[npt.NDArray[np.intp], ...], axis: int, parameterization: Parameterization
) -> tuple[Singles, Singles]:
    """Return d/dx and d²/dx² (m, 3) of the logarithms (a, b, c, 3) along an axis at bins; one-sided at its ends."""
    last = parameterization.shape[axis] - 1
    before, after = list(at), list(at)
    before[axis], after[axis] = at[axis] - 1, at[axis] + 1
    if axis == 2 and parameterization.goes_round:
        after[axis] %= last + 1  # -1 is the last bin already
    else:
        before[axis], after[axis] = np.maximum(before[axis], 0), np.minimum(after[axis], last)
    here = logs[at]
    down, up = here - logs[tuple(before)], logs[tuple(after)] - here
    # The end of an axis is as a mirror: the single difference gives the slope and no curvature.
    ends = ((at[axis] == 0) | (at[axis] == last))[:, None] & (axis != 2 or not parameterization.goes_round)
    slope = np.where(ends, down + up, 0.5 * (down + up))
    bend = np.where(ends, 0.0, up - down)
    # A neighbour of 0 has no logarithm and is one that nothing is known of.
    lit = np.isfinite(slope) & (np.abs(slope) < 2.0 * _STEEPEST)
    slope, bend = np.where(lit, slope, 0.0), np.where(lit, bend, 0.0)
    return (
        np.clip(slope, -_STEEPEST, _STEEPEST).astype(np.float32),
        np.clip(bend, -_STEEPEST, _STEEPEST).astype(np.float32),
    )
