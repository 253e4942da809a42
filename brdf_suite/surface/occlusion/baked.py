"""Result of baking: a mesh with occlusion at its vertices, and the floor under it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Singles


@dataclass(frozen=True, eq=False)
class BakedPart:
    """A part of a mesh with occlusion; its first vertices are those of the part, those after lie on its edges.

    Attributes
    ----------
    positions, normals, uvs, triangles
        As in :class:`~brdf_suite.surface.mesh.PartGeometry`, but normals of new vertices are shorter than 1 (see
        :mod:`.refine`).
    light
        (n, 8) float16: x, y, z of the mean direction of the light that arrives, for an open place 2/3 of the
        normal; the share of a uniform light's irradiance that arrives, 0…1; and the same four with the floor.
    """

    positions: Singles
    normals: Singles
    uvs: Singles
    triangles: NDArray[np.uint32]
    light: NDArray[np.float16]


@dataclass(frozen=True, eq=False)
class GroundLight:
    """The floor's view of the light around the mesh.

    Attributes
    ----------
    height
        Of the floor, metres.
    low, high
        Lowest and highest (x, z) of the texels' outer edges, metres.
    transfer
        (rows along z, columns along x, (degree + 1)²) float32: ∫ V cosθ Y_lm dω, V = 0 where the mesh is in the
        way, for the real harmonics of :mod:`brdf_suite.geometry.low_harmonics`, y up. Far from the mesh it is
        that of an open floor.
    """

    height: float
    low: tuple[float, float]
    high: tuple[float, float]
    transfer: Singles

    @property
    def share(self) -> Singles:
        """Return the share of a uniform light's irradiance, (rows, columns), 0…1."""
        # A uniform light has only the first harmonic, and an open floor's coefficient of it is √π / 2.
        return np.asarray(np.clip(self.transfer[..., 0] / (0.5 * np.sqrt(np.pi)), 0.0, 1.0), np.float32)


@dataclass(frozen=True, eq=False)
class BakedMesh:
    """A baked mesh: its parts in the order of the mesh's, and the floor."""

    parts: tuple[BakedPart, ...]
    ground: GroundLight
