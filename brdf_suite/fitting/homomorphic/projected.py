"""Averaged projection: each texel is the mean of its samples.

It is the naive factorization of Table 1 of McCool, Ang and Ahmad 2001, and the initial guess of the other.
"""

from __future__ import annotations

import numpy as np
from scipy import sparse

from brdf_suite.arrays import Floats
from brdf_suite.fitting.homomorphic.constraints import MapLayout


def average_samples(matrix: sparse.csr_array, layout: MapLayout, wanted: Floats) -> Floats:
    """Return unknowns (n, channels): means of the logarithms ``wanted`` (samples, channels), shared by the factors.

    A texel takes the mean of its samples, by their bilinear weights, over the number of factors; one without a sample
    takes the mean of all.
    """
    mass = np.asarray(matrix.sum(axis=0)).ravel()
    everywhere = wanted.mean(axis=0)
    held = (matrix.T @ wanted) / np.maximum(mass, 1e-12)[:, None]
    means = np.where(mass[:, None] > 1e-9, held, everywhere)
    return np.asarray(means / len(layout.factors))


def enlarge_map(values: Floats, shape: tuple[int, ...]) -> Floats:
    """Return a map (n, channels) or (n, n, channels) interpolated to ``shape`` texels, centres over the same square."""
    for axis, size in enumerate(shape):
        old = values.shape[axis]
        at = np.clip((np.arange(size) + 0.5) * old / size - 0.5, 0.0, old - 1.0)
        low = np.minimum(at.astype(np.int64), max(old - 2, 0))
        share = (at - low).reshape([-1 if axis == i else 1 for i in range(values.ndim)])
        upper = np.minimum(low + 1, old - 1)
        values = np.take(values, low, axis=axis) * (1.0 - share) + np.take(values, upper, axis=axis) * share
    return values
