"""Relaxed median cut: each light moves to its cell's centroid, each texel joins the nearest light.

The weighted relaxation of Kollig and Keller, "Efficient Illumination by High Dynamic Range Images", EGWR 2003
(Lloyd's, with luminance as weight), started from a median cut instead of from a few points that are split. What
it lowers is ``Σ Y·|ω - ω_light|²``, the leading term of the error of everything that varies smoothly with direction.
A light that lost all its cells takes one side of the brightest stratum, as theirs splits the brightest.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats, Indices
from brdf_suite.lighting.lights.cells import Cells
from brdf_suite.lighting.lights.median_cut import median_cut

_COLUMNS = 512  # larger maps are joined: strata of a degree need no finer edges
_STEPS = 10  # error against steps: docs/method/lights.md
_DARK = 1e-9  # weight of a black cell against the same area of mean light


def relaxed_strata(cells: Cells, count: int) -> Indices:
    """Return for each cell (h, w) which of ``count`` strata it belongs to; fewer where there are fewer cells."""
    from scipy.spatial import cKDTree

    step = max(1, -(-cells.shape[1] // _COLUMNS))
    # A small map keeps its cells: joined ones could be fewer than the lights.
    coarse = cells.joined(step) if step > 1 else cells
    labels: Indices = median_cut(coarse, count).ravel()
    number = int(labels.max()) + 1
    areas = coarse.areas().ravel()
    weights = coarse.luminous.ravel() + _DARK * areas * max(float(coarse.luminous.sum()), 1.0) / areas.sum()
    towards = coarse.moments.reshape(-1, 3)
    lengths = np.linalg.norm(towards, axis=1, keepdims=True)
    towards = np.where(lengths > 0.0, towards / np.maximum(lengths, 1e-300), coarse.centres().reshape(-1, 3))
    for _ in range(_STEPS):
        light = np.bincount(labels, weights, number)
        sums = [np.bincount(labels, weights * towards[:, k], number) for k in range(3)]
        middles: Floats = np.stack(sums, axis=1) / light[:, None]
        # Not brought to length 1: where light comes from all around, no direction is right, and the middle is.
        moved = np.asarray(cKDTree(middles).query(towards, workers=-1)[1], dtype=np.intp)
        _fill_empty(moved, number, weights, towards)
        if np.array_equal(moved, labels):
            break
        labels = moved
    rows, columns = cells.shape
    wide = labels.reshape(coarse.shape)
    return np.repeat(np.repeat(wide, step, axis=0)[:rows], step, axis=1)[:, :columns]


def _fill_empty(labels: Indices, number: int, weights: Floats, towards: Floats) -> None:
    """Give each of ``number`` labels at least one cell, in place."""
    held = np.bincount(labels, minlength=number)
    for empty in np.flatnonzero(held == 0):
        light = np.bincount(labels, weights, number)
        brightest = int(np.argmax(np.where(held > 1, light, -1.0)))
        mine = np.flatnonzero(labels == brightest)
        offset = towards[mine] - np.average(towards[mine], axis=0, weights=weights[mine])
        axis = np.linalg.eigh((offset * weights[mine, None]).T @ offset)[1][:, -1]
        along = offset @ axis
        side = along > 0.0
        if side.all() or not side.any():
            side = np.arange(len(mine)) == int(np.argmax(along))
        labels[mine[side]] = empty
        held = np.bincount(labels, minlength=number)
