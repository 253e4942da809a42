"""Wiener shrinkage (1949) of sensor maps, which removes the noise of the photographs they were measured from.

A flat field or a dark frame is applied to every photograph, so its own noise is a pattern that no averaging removes.
Differences between neighbours are kept by the share of them that noise does not explain.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.ndimage import gaussian_filter, median_filter

from brdf_suite.arrays import Floats

_OUTLYING = 6.0
_TO_DEVIATION = 1.4826


def shrunk(plane: Floats, noise_variance: float, sigma_px: float) -> tuple[Floats, npt.NDArray[np.bool_]]:
    """Return ``smooth + k·(plane - smooth)``, and where a value stands out so far that it is kept as it is.

    ``plane`` (h, w); ``noise_variance`` is that of one value; smooth is a Gaussian's mean of ``sigma_px``; k, 0…1, is
    one less the noise over the variance about the smooth plane.

    >>> shrunk(np.full((4, 5), 2.0), 1.0, 1.0)[0].mean()
    np.float64(2.0)
    """
    rough = plane - _local_level(plane)
    spread = _TO_DEVIATION * float(np.median(np.abs(rough - np.median(rough))))
    limit = _OUTLYING * max(spread, float(np.sqrt(noise_variance)))
    standing_out = np.abs(rough - np.median(rough)) > limit
    usual = np.where(standing_out, plane - rough, plane)
    # A straight continuation at the borders: reflection or repetition would flatten what rises there.
    edge = min(int(4.0 * sigma_px + 0.5), min(plane.shape) - 1)
    padded = np.pad(usual, edge, mode="reflect", reflect_type="odd")
    smooth = gaussian_filter(padded, sigma_px)[edge : padded.shape[0] - edge, edge : padded.shape[1] - edge]
    apart = usual - smooth
    seen = float(np.mean(apart[~standing_out] ** 2)) if not standing_out.all() else 0.0
    kept = min(1.0, max(0.0, 1.0 - noise_variance / seen)) if seen > 0.0 else 0.0
    return np.where(standing_out, plane, smooth + kept * apart), standing_out


def _local_level(plane: Floats) -> Floats:
    """Return the median of 5 × 5 neighbours, which one hot pixel does not move."""
    edge = min(2, min(plane.shape) - 1)
    padded = np.pad(plane, edge, mode="reflect", reflect_type="odd")
    level = median_filter(padded, 5)
    return np.asarray(level[edge : level.shape[0] - edge, edge : level.shape[1] - edge])
