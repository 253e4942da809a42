"""Robust Gauss-Newton fit of the rig to highlights and stated values, with detection of outlier highlights.

With x the changes of the ten numbers, S the slopes of the highlights' places, w Huber's weights over their standard
errors and P the covariance of the statements, each step solves

    minimize |w (off + S Δ)|² + (x + Δ)·P⁻¹ (x + Δ)

for Δ. The inverse of the same matrix at the end is the covariance of what was found.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.refinement.parameters import PARAMETERS, apply
from brdf_suite.acquisition.geometry.sphere.highlight import Highlight
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry
from brdf_suite.arrays import Bools, Floats
from brdf_suite.progress import Progress, report

_STEPS = 40
_SPREAD = 1.4826  # of a normal distribution, over the median absolute deviation
_HUBER = 1.5
_OUTLIER = 5.0
_OUTLIER_PX = 0.5
_STEADY = 1e-4  # of a standard deviation


@dataclass(frozen=True)
class HighlightSeries:
    """The highlights as arrays, and the rig as stated."""

    start: RigGeometry
    positions: npt.NDArray[np.intp]
    angles: Floats
    seen: Floats
    sigma: Floats

    @classmethod
    def of(cls, start: RigGeometry, highlights: Sequence[Highlight]) -> HighlightSeries:
        """Return the highlights in order of their positions."""
        rows = sorted(highlights, key=lambda row: row.position)
        positions = np.array([row.position for row in rows], np.intp)
        return cls(
            start,
            positions,
            np.array(start.angles_deg)[positions],
            np.array([row.pixel for row in rows]),
            np.array([row.sigma_px for row in rows]),
        )

    def residuals(self, x: Floats) -> Floats:
        """Return seen less expected (n, 2), pixels, with the rig's numbers changed by ``x``."""
        expected = apply(self.start, x).highlights(self.angles)
        # Out of sight at a step too far: as wrong as the sphere is large.
        lost = math.tan(self.start.outline_angle) * self.start.lens.fx
        return np.where(np.isfinite(expected), self.seen - expected, lost)


@dataclass(frozen=True)
class RigFit:
    """Fitted changes ``x`` (p,) of the parameters, residuals ``off`` (n, 2), and their ``slopes`` (n, 2, p).

    ``posterior`` (p, p): covariance of the numbers, metres² and degrees².
    """

    x: Floats
    off: Floats
    slopes: Floats
    posterior: Floats


def fit_rig(series: HighlightSeries, prior: Floats, kept: Bools, progress: Progress | None) -> RigFit:
    """Return the numbers that the highlights ``kept`` and the statements (covariance ``prior``) agree with best."""
    lower = np.linalg.inv(np.linalg.cholesky(prior))  # whitens the statements' errors
    scale = np.sqrt(np.diag(prior))
    x = np.zeros(len(PARAMETERS))
    for step in range(_STEPS):
        report(progress, step / _STEPS, "refining the light's position")
        off, slopes = series.residuals(x), _slopes(series.residuals, x, scale)
        weight = _weights(off, series.sigma, kept)
        system = np.concatenate(((slopes * weight[:, None, None]).reshape(-1, len(x)), lower))
        wanted = np.concatenate((-(off * weight[:, None]).ravel(), -lower @ x))
        change = np.linalg.lstsq(system, wanted)[0]
        x = x + change
        if float(np.abs(change / scale).max()) < _STEADY:
            break
    off, slopes = series.residuals(x), _slopes(series.residuals, x, scale)
    white = (slopes * _weights(off, series.sigma, kept)[:, None, None]).reshape(-1, len(x))
    return RigFit(x, off, slopes, np.linalg.inv(white.T @ white + lower.T @ lower))


def _weights(off: Floats, sigma: Floats, kept: Bools) -> Floats:
    """Return Huber's weights (n,) over the standard errors, these as large as the residuals show them to be."""
    length = np.linalg.norm(off, axis=-1) / sigma
    spread = max(_SPREAD * float(np.median(length[kept])), 1.0)
    weight: Floats = np.sqrt(np.minimum(1.0, _HUBER * spread / np.maximum(length, 1e-12)))
    return weight * kept / (sigma * spread)


def stray(off: Floats, sigma: Floats) -> Bools:
    """Return the highlights (n,) that are far from where both of their neighbours in the series say.

    Where the sphere has moved a highlight still agrees with one of them.
    """
    step = np.linalg.norm(np.diff(off, axis=0), axis=-1)
    usual = _SPREAD * float(np.median(step))
    # The first and the last are compared with the two next to them.
    before = np.concatenate((np.linalg.norm(off[:1] - off[2:3], axis=-1), step))
    after = np.concatenate((step, np.linalg.norm(off[-1:] - off[-3:-2], axis=-1)))
    stray: Bools = np.minimum(before, after) > np.maximum(_OUTLIER * np.maximum(usual, sigma), _OUTLIER_PX)
    return stray


def find_outliers(off: Floats, sigma: Floats, kept: Bools) -> Bools:
    """Return the highlights (n,) that are off by far more than those ``kept`` usually are."""
    length = np.linalg.norm(off, axis=-1)
    middle = _SPREAD * float(np.median(length[kept]))
    far: Bools = length > np.maximum(_OUTLIER * np.maximum(middle, sigma), _OUTLIER_PX)
    return far


def _slopes(residuals: Callable[[Floats], Floats], x: Floats, scale: Floats) -> Floats:
    """Return the derivatives (n, 2, parameters) of the residuals."""
    steps = 0.01 * scale * np.eye(len(x))
    columns = [(residuals(x + e) - residuals(x - e)) / (2.0 * e.sum()) for e in steps]
    return np.stack(columns, axis=-1)
