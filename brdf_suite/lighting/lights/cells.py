"""Latitude-longitude map as cells with summed light, shared by the extraction methods.

A texel's radiance holds over its whole solid angle, Δφ·(cosθ_top - cosθ_bottom), so the cells cover 4π exactly
and sums over them are the map's. Maps of more than 2,048 columns are joined into larger cells, whose sums and
mean directions are still those of the single texels.

The first column is opposite to where the light comes from on the whole, and directions are those of a map that
begins there: so a turned environment gives the same cells to the last bit, and the same lights, turned.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles

MAX_COLUMNS = 2048
_BLOCK_TEXELS = 1 << 20


@dataclass(frozen=True, eq=False)
class Cells:
    """Sums over the cells of a map, row 0 up, columns in the map's order but from another one on.

    Attributes
    ----------
    energy
        (h, w, 3) ∫L dω, linear working space.
    luminous
        (h, w) the same as luminance: what decides where lights go.
    moments
        (h, w, 3) ∫Y(L)·ω dω: along the mean direction of a cell's light.
    solid_angles
        (h,) steradians of a cell in each row.
    theta
        (h + 1,) the rows' edges, radians from +y.
    widths
        (w,) the columns' widths, radians; they sum to 2π.
    turn
        Radians about +y, as :meth:`.DirectionalLights.turned` takes them, from these directions to the map's.
    """

    energy: Floats
    luminous: Floats
    moments: Floats
    solid_angles: Floats
    theta: Floats
    widths: Floats
    turn: float

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.luminous.shape[0], self.luminous.shape[1]

    def areas(self) -> Floats:
        """Return the solid angles (h, w) in steradians."""
        return np.asarray(self.solid_angles[:, None] * (self.widths / (2.0 * np.pi))[None, :])

    def centres(self) -> Floats:
        """Return the unit directions (h, w, 3) of the cells' middles."""
        theta = 0.5 * (self.theta[1:] + self.theta[:-1])
        phi = np.cumsum(self.widths) - 0.5 * self.widths - np.pi
        return direction(theta[:, None], phi[None, :])

    def joined(self, step: int) -> Cells:
        """Return larger cells, of ``step`` columns and rows each; what is remaining makes smaller ones at the end."""
        rows, columns = (np.arange(0, size, step) for size in self.shape)
        whole = step < 8 and not (self.shape[0] % step or self.shape[1] % step)

        def summed(values: Floats) -> Floats:
            if not whole:
                return np.asarray(np.add.reduceat(np.add.reduceat(values, rows, axis=0), columns, axis=1))
            # The same sums in the same order, in a fraction of the time.
            for axis in (0, 1):
                first, *others = (
                    values[(slice(None),) * axis + (slice(k, None, step),)] for k in range(step)
                )
                values = sum(others, start=first)
            return values

        return Cells(
            summed(self.energy),
            summed(self.luminous),
            summed(self.moments),
            np.add.reduceat(self.solid_angles, rows),
            self.theta[[*rows, -1]],
            np.add.reduceat(self.widths, columns),
            self.turn,
        )


def sum_cells(radiance: NDArray[np.float32], max_columns: int = MAX_COLUMNS) -> Cells:
    """Return the cells of a map (h, w, 3) of finite radiance that is not negative."""
    height, width = radiance.shape[:2]
    step = -(-width // max_columns)
    edges = np.arange(height + 1) * (np.pi / height)
    # cos a - cos b as a product, which keeps full precision at the poles.
    rings = 2.0 * np.sin(0.5 * (edges[1:] + edges[:-1])) * np.sin(0.5 * np.diff(edges))
    first = _seam(np.einsum("h,hwk->wk", rings, radiance, dtype=np.float64) @ LUMINANCE)
    phi = column_angles(width)
    widths = np.full(width, 2.0 * np.pi / width)
    turn = -first * (2.0 * np.pi / width)
    texel = rings * (2.0 * np.pi / width)
    blocks = []
    rows = step * max(1, _BLOCK_TEXELS // (width * step))
    for top in range(0, height, rows):
        here = slice(top, min(top + rows, height))
        energy = np.roll(radiance[here], -first, axis=1) * texel[here, None, None]
        luminous = energy @ LUMINANCE
        moments = luminous[..., None] * direction(ring_angles(height)[here, None], phi[None, :])
        sizes = 2.0 * np.pi * rings[here], edges[here.start : here.stop + 1], widths
        part = Cells(energy, luminous, moments, *sizes, turn)
        blocks.append(part if step == 1 else part.joined(step))
    sums = [(block.energy, block.luminous, block.moments, block.solid_angles) for block in blocks]
    theta = np.concatenate([blocks[0].theta[:1], *(block.theta[1:] for block in blocks)])
    energy, luminous, moments, solid_angles = (np.concatenate(part) for part in zip(*sums, strict=True))
    return Cells(energy, luminous, moments, solid_angles, theta, blocks[0].widths, turn)


def sum_by_label(labels: NDArray[np.intp], values: Floats) -> Floats:
    """Return the sums (k, c) of cells' values (h, w, ...) for each of ``labels`` (h·w,), 0 to k - 1."""
    flat = values.reshape(labels.size, -1)
    count = int(labels.max()) + 1
    return np.stack([np.bincount(labels, flat[:, k], count) for k in range(flat.shape[1])], axis=1)


def _seam(profile: Floats) -> int:
    """Return the column opposite to the mean direction of the light (w,), or to the brightest where there is none."""
    columns = len(profile)
    harmonic = profile @ np.exp(2j * np.pi * np.arange(columns) / columns)
    if abs(harmonic) > 1e-9 * float(profile.sum()):
        middle = float(np.angle(harmonic)) * columns / (2.0 * np.pi)
    else:
        middle = float(np.argmax(profile))
    return int(np.round(middle + 0.5 * columns)) % columns
