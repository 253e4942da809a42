"""Linear system of a factorization: the texels of each sample, and the smoothness terms.

The unknowns are the logarithms of all maps, one after the other, row by row (McCool, Ang and Ahmad 2001, equation 15).
A row of a sample holds the bilinear weights of the texels that its factors read (equation 14); where two factors
read one texel, their weights are summed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import sparse

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_words import LEAST_SIZE, MOST_SIZE, Factor
from brdf_suite.geometry.parabolic import bilinear


@dataclass(frozen=True)
class MapLayout:
    """Index ranges of the maps among the unknowns.

    ``shapes``: map name to (n,) or (n, n); ``starts``: to its first unknown; ``count``: of all unknowns.
    """

    factors: tuple[Factor, ...]
    shapes: Mapping[str, tuple[int, ...]]
    starts: Mapping[str, int]
    count: int

    @classmethod
    def of(cls, factors: Sequence[Factor], resolution: int) -> MapLayout:
        """Lay out maps of ``resolution`` texels along each axis, or of as many as a factor asks for."""
        if not LEAST_SIZE <= resolution <= MOST_SIZE:
            raise ValueRangeError(
                "resolution", f"expected {LEAST_SIZE} to {MOST_SIZE} texels, not {resolution}"
            )
        shapes: dict[str, tuple[int, ...]] = {}
        starts: dict[str, int] = {}
        count = 0
        for factor in factors:
            if factor.name not in shapes:
                size = resolution if factor.size is None else factor.size
                shapes[factor.name] = (size,) * factor.projection.axes
                starts[factor.name] = count
                count += size**factor.projection.axes
        return cls(tuple(factors), shapes, starts, count)

    def maps(self, unknowns: Floats) -> dict[str, Floats]:
        """Return each map of ``unknowns`` (count, channels) as (n, channels) or (n, n, channels)."""
        channels = unknowns.shape[1]
        found = {}
        for name, shape in self.shapes.items():
            start = self.starts[name]
            found[name] = unknowns[start : start + int(np.prod(shape))].reshape(*shape, channels)
        return found

    def unknowns(self, maps: Mapping[str, Floats]) -> Floats:
        """Return the unknowns (count, channels) of maps: what :meth:`maps` takes apart."""
        return np.concatenate([maps[name].reshape(-1, maps[name].shape[-1]) for name in self.shapes])


def constraints(layout: MapLayout, wi: Floats, wo: Floats) -> sparse.csr_array:
    """Return the matrix A (samples, unknowns) of equation 16, float32, coincident coefficients summed."""
    texels, weights = [], []
    for factor in layout.factors:
        index, weight = bilinear(factor.projection.places(wi, wo), layout.shapes[factor.name])
        texels.append(index + np.int32(layout.starts[factor.name]))
        weights.append(weight)
    columns, values = np.concatenate(texels, axis=1), np.concatenate(weights, axis=1)
    rows = np.arange(len(wi) + 1, dtype=np.int32) * np.int32(columns.shape[1])
    found = sparse.csr_array((values.ravel(), columns.ravel(), rows), shape=(len(wi), layout.count))
    found.sum_duplicates()
    return found


def smoothness(layout: MapLayout) -> sparse.csr_array:
    """Return the Laplacian of every texel of every map (unknowns, unknowns), float32: the masks of Figure 3.

    A texel less its neighbours, as many as there are: 4 inside of a map of two axes, 3 on its edges, 2 in its corners.
    """
    blocks: list[sparse.csr_array] = []
    for shape in layout.shapes.values():
        size = shape[0]
        beside = sparse.diags_array(np.ones(size - 1), offsets=1, shape=(size, size))
        neighbours = sparse.csr_array(beside + beside.T)
        line = sparse.csr_array(sparse.diags_array(neighbours.sum(axis=1)) - neighbours)
        if len(shape) == 1:
            blocks.append(line)
        else:
            one = sparse.csr_array(sparse.eye_array(size))
            blocks.append(sparse.csr_array(sparse.kron(line, one) + sparse.kron(one, line)))
    return sparse.csr_array(sparse.block_diag(blocks, format="csr").astype(np.float32))


FLATNESS = 0.5
"""Of the differences beside the Laplacian: a slope at the rim of the samples is carried on for 1/FLATNESS texels."""


def regularization(layout: MapLayout) -> sparse.csr_array:
    """Return what keeps the maps smooth (rows, unknowns), float32: the Laplacian, and less of it the first differences.

    The Laplacian alone carries the slope at the rim of the samples on and on: where a gap is ten texels wide, a trend
    of the last two is exponentiated ten times over. With the differences a gap ends flat.
    """
    blocks: list[sparse.csr_array] = []
    for shape in layout.shapes.values():
        size = shape[0]
        step = sparse.csr_array(sparse.eye_array(size - 1, size, k=1) - sparse.eye_array(size - 1, size))
        if len(shape) == 1:
            blocks.append(step)
        else:
            one = sparse.csr_array(sparse.eye_array(size))
            blocks.append(sparse.csr_array(sparse.vstack((sparse.kron(step, one), sparse.kron(one, step)))))
    differences = FLATNESS * sparse.csr_array(sparse.block_diag(blocks, format="csr"))
    return sparse.csr_array(sparse.vstack((smoothness(layout), differences)).astype(np.float32))
