"""Ray casting against the triangles of a mesh by Embree, and the unoccluded light at places.

Places are sampled with cosine-distributed directions, so that a share of the directions is a share of the
irradiance: stratified in the polar coordinate, by the golden ratio in the azimuth, shifted for every place by a hash
of its number (Cranley and Patterson 1976) so that neighbours do not err alike.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Singles
from brdf_suite.geometry.fresnel import sheet_reflectance
from brdf_suite.progress import Progress, report

_PLACES_AT_ONCE = 1024
"""Places in one step of a thread: about 20 ms, so that a cancel takes effect soon."""
_BELOW = 1e-3
"""A direction whose cosine to the triangle's plane is less looks into the body and is not counted."""
_GOLDEN = 0.6180339887498949
_MOST_PANES = 8
"""On the way of a ray; what comes through more is nothing."""


class RayScene:
    """The triangles of a mesh, ready for rays.

    Parameters
    ----------
    triangles
        Corners (k, 3, 3), metres, k ≥ 1.
    passing, iors
        (k,): of a pane's triangles which share passes of the light that they do not mirror, and their index; 0 and
        any number of the others. Left out, there are no panes.

    Raises
    ------
    ImportError
        There is no Embree for this machine.
    """

    def __init__(
        self,
        triangles: NDArray[Any],
        passing: NDArray[Any] | None = None,
        iors: NDArray[Any] | None = None,
    ) -> None:
        # Embree's library takes 40 ms to load, and only baking needs it.
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        passing = np.zeros(len(triangles)) if passing is None else passing
        panes = passing > 0.0
        self._passing = passing[panes]
        self._iors = np.ones(0) if iors is None else iors[panes]
        a, b, c = np.moveaxis(np.asarray(triangles, float)[panes], 1, 0)
        across = np.cross(b - a, c - a)
        self._facing = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-30)
        self._step = 1e-5 * float(np.ptp(np.asarray(triangles).reshape(-1, 3), axis=0).max())
        self._scenes = []
        for kept in (~panes, panes):
            # Robust: a ray through the edge between two triangles hits one of them.
            scene = EmbreeScene(robust=True) if kept.any() else None
            mesh = None
            if scene is not None:
                mesh = TriangleMesh(scene, np.ascontiguousarray(triangles[kept], np.float32))
            self._scenes.append((scene, mesh))
        # The first rays sort the triangles, which threads must not do at once.
        self.free(np.zeros((1, 3), np.float32), np.array([[0.0, 1.0, 0.0]], np.float32))

    def free(self, origins: Singles, directions: Singles) -> Singles:
        """Return (n,): which share of the light comes along each ray (n, 3), (n, 3) to its origin.

        0 where it hits what is no pane, else what the panes on its way let pass, or 1.
        """
        (opaque, _), (panes, _) = self._scenes
        share = np.ones(len(origins), np.float32)
        going, starts = np.arange(len(origins)), origins
        for _ in range(_MOST_PANES):
            if panes is None:
                break
            found = panes.run(starts, directions[going], query="INTERSECT", output=True)
            met = found["primID"] >= 0
            if not met.any():
                break
            pane, going = found["primID"][met], going[met]
            cosine = np.abs(np.einsum("nk,nk->n", self._facing[pane], directions[going]))
            for ior in np.unique(self._iors[pane]):
                of_it = self._iors[pane] == ior
                clear = 1.0 - sheet_reflectance(cosine[of_it], float(ior))
                share[going[of_it]] *= (self._passing[pane[of_it]] * clear).astype(np.float32)
            beyond = (found["tfar"][met] + self._step)[:, None] * directions[going]
            starts = (starts[met] + beyond).astype(np.float32)
        if opaque is not None:
            share = np.where(opaque.run(origins, directions, query="OCCLUDED") < 0, share, np.float32(0.0))
        return share

    def gather(
        self,
        points: Singles,
        normals: Singles,
        planes: Singles,
        rays: int,
        ground: GroundLight | None = None,
        progress: Progress | None = None,
        what: str = "occlusion",
    ) -> Singles:
        """Cast ``rays`` from each place and add up those that leave.

        Parameters
        ----------
        points, normals, planes
            (n, 3): where, about which unit normal, and the unit normal of the plane there.
        ground
            A floor; a ray that meets it counts by the light that it sees.

        Returns
        -------
        (n, 9): share of light that leaves and the sum of those, over the number cast, alone (4) and with the
        ground (4); last the share of directions above the plane, 0 where the place is no use.

        Raises
        ------
        Cancelled
            ``progress`` asked for it; what runs ends within some hundredths of a second.
        """
        count = len(points)
        result = np.empty((count, 9), np.float32)

        def step(first: int) -> int:
            part = slice(first, min(first + _PLACES_AT_ONCE, count))
            directions = _cosine_directions(normals[part], first, rays)
            cosines = np.einsum("nkd,nd->nk", directions, planes[part])
            counted = cosines >= _BELOW
            origins = np.repeat(points[part], rays, axis=0)
            share = self.free(origins, directions.reshape(-1, 3)).reshape(counted.shape) * counted
            over = 1.0 / np.maximum(counted.sum(axis=1), 1)
            result[part, :4] = _sums(share, directions) * over[:, None]
            if ground is not None:
                drop = points[part, 1] - np.float32(ground.height)
                met = (share > 0.0) & (directions[..., 1] < 0.0) & (drop > 0.0)[:, None]
                place, ray = np.nonzero(met)
                towards = directions[place, ray]
                distance = drop[place] / -towards[:, 1]
                at = points[part][place] + distance[:, None] * towards
                share[place, ray] *= ground.share_at(at[:, 0], at[:, 2])
            result[part, 4:8] = _sums(share, directions) * over[:, None]
            result[part, 8] = counted.mean(axis=1)
            return part.stop - part.start

        _in_threads(step, count, progress, what)
        return result

    def leaves(
        self,
        points: Singles,
        directions: NDArray[np.float64],
        turns: NDArray[np.float64],
        progress: Progress | None = None,
        what: str = "occlusion",
    ) -> NDArray[np.uint8]:
        """Return (n, m): which share of the light comes along a direction, turned for a point, to that; 255 is all.

        ``points`` (n, 3); ``directions`` (m, 3), turned about y by ``turns`` (n,), radians.
        """
        result = np.empty((len(points), len(directions)), np.uint8)
        x, y, z = directions.T

        def step(first: int) -> int:
            part = slice(first, min(first + _PLACES_AT_ONCE, len(points)))
            cosine, sine = np.cos(turns[part])[:, None], np.sin(turns[part])[:, None]
            turned = np.empty((part.stop - first, len(directions), 3), np.float32)
            turned[..., 0], turned[..., 1] = cosine * x + sine * z, y
            turned[..., 2] = cosine * z - sine * x
            origins = np.repeat(points[part], len(directions), axis=0)
            free = self.free(origins, turned.reshape(-1, 3)).reshape(result[part].shape)
            result[part] = np.rint(255.0 * free)
            return part.stop - first

        _in_threads(step, len(points), progress, what)
        return result


def _cosine_directions(normals: Singles, first: int, rays: int) -> Singles:
    """Return directions (n, rays, 3), dense as the cosine about normals (n, 3); ``first``: the first one's number."""
    shift_x, shift_y = _shifts(np.arange(first, first + len(normals), dtype=np.uint64))
    k = np.arange(rays)
    # The first coordinate is stratified exactly, the second by the golden ratio.
    u = ((k + shift_x[:, None]) / rays).astype(np.float32)
    turn = ((k * _GOLDEN + shift_y[:, None]) % 1.0 * (2.0 * np.pi)).astype(np.float32)
    radius = np.sqrt(u)
    across, along, up = radius * np.cos(turn), radius * np.sin(turn), np.sqrt(1.0 - u)
    # A frame about the normal (Duff et al. 2017).
    nx, ny, nz = normals.T
    sign = np.copysign(np.float32(1.0), nz)
    a = -1.0 / (sign + nz)
    b = nx * ny * a
    tangent = np.stack([1.0 + sign * nx * nx * a, sign * b, -sign * nx], axis=1)
    second = np.stack([b, sign + ny * ny * a, -ny], axis=1)
    frame = np.stack([tangent, second, normals], axis=1)
    return np.ascontiguousarray(np.stack([across, along, up], axis=2) @ frame, np.float32)


def _shifts(numbers: NDArray[np.uint64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return two numbers of 0…1 (n,) that belong to whole numbers and look like chance (a 64-bit mixer)."""
    z = numbers * np.uint64(0x9E3779B97F4A7C15) + np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    z = z ^ (z >> np.uint64(31))
    high, low = (z >> np.uint64(32)).astype(np.float64), (z & np.uint64(0xFFFFFFFF)).astype(np.float64)
    return high / 2.0**32, low / 2.0**32


def _sums(share: Singles, directions: Singles) -> Singles:
    """Return (n, 4): the sum of shares (n, k), and of directions (n, k, 3) times them."""
    return np.concatenate([share.sum(axis=1)[:, None], (share[:, None] @ directions)[:, 0]], axis=1)


def _in_threads(step: Callable[[int], int], count: int, progress: Progress | None, what: str) -> None:
    """Run ``step(first)`` for all firsts on as many threads as there are processors."""
    done = 0
    with ThreadPoolExecutor(max(1, os.cpu_count() or 1)) as threads:
        steps = [threads.submit(step, first) for first in range(0, count, _PLACES_AT_ONCE)]
        try:
            for waiting in steps:
                done += waiting.result()
                report(progress, done / count, what)
        except BaseException:
            threads.shutdown(cancel_futures=True)
            raise


@dataclass(frozen=True, eq=False)
class BakedPart:
    """A part of a mesh with occlusion; its first vertices are those of the part, those after lie on its edges.

    Attributes
    ----------
    positions, normals, uvs, triangles
        As in :class:`~brdf_suite.surface.mesh.PartGeometry`, but normals of new vertices are shorter than 1 (see
        :class:`~brdf_suite.surface.occlusion.places.Cut`).
    light
        (n, 8) float16: x, y, z of the mean direction of the light that arrives, for an open place 2/3 of the
        normal; the share of a uniform light's irradiance that arrives, 0…1; and the same four with the floor. (n, 16)
        where the part is no solid: then the same eight for its back.
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

    @cached_property
    def share(self) -> Singles:
        """Return the share of a uniform light's irradiance, (rows, columns), 0…1."""
        # A uniform light has only the first harmonic, and an open floor's coefficient of it is √π / 2.
        return np.asarray(np.clip(self.transfer[..., 0] / (0.5 * np.sqrt(np.pi)), 0.0, 1.0), np.float32)

    def share_at(self, x: Singles, z: Singles) -> Singles:
        """Return how much light the floor sees at (x, z), metres, between its texels; 1 outside."""
        rows, columns = self.share.shape
        column = (x - self.low[0]) * (columns / (self.high[0] - self.low[0])) - 0.5
        row = (z - self.low[1]) * (rows / (self.high[1] - self.low[1])) - 0.5
        found = np.ones(x.shape, np.float32)
        inside = (column >= 0.0) & (row >= 0.0) & (column < columns - 1) & (row < rows - 1)
        i, j = row[inside].astype(np.int64), column[inside].astype(np.int64)
        s, t = row[inside] - i, column[inside] - j
        upper = self.share[i, j] * (1.0 - t) + self.share[i, j + 1] * t
        lower = self.share[i + 1, j] * (1.0 - t) + self.share[i + 1, j + 1] * t
        found[inside] = upper * (1.0 - s) + lower * s
        return found


@dataclass(frozen=True, eq=False)
class BakedMesh:
    """A baked mesh: its parts in the order of the mesh's, and the floor."""

    parts: tuple[BakedPart, ...]
    ground: GroundLight
