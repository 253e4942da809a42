"""Baking of a mesh's occlusion: rays from places on its triangles, fitted by values at its vertices.

1. The triangles, made ready for rays by Embree (:mod:`.rays`); panes let their share of the light pass.
2. The floor under the mesh (:mod:`.floor`).
3. Places spread over the triangles (:mod:`.places`), 32 rays each. A ray that leaves counts as light; with the
   floor, one that meets it counts by the light that the floor sees there. Parts that are no solids are seen from both
   sides, and have places on both.
4. Values at the vertices by least squares (:mod:`.fit`); triangles that they fit badly are cut and looked at again, up
   to eight times.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Integers, Singles
from brdf_suite.documents.view_settings import PANE_IOR, TRANSMITTANCE
from brdf_suite.errors import SuiteError
from brdf_suite.geometry.closed_surface import is_closed_outward
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.floor import bake_floor
from brdf_suite.surface.occlusion.places import Places, cut, spread
from brdf_suite.surface.occlusion.rays import BakedMesh, BakedPart, RayScene

Look: TypeAlias = Callable[[Places, NDArray[np.bool_], Progress | None], Singles]

ALGORITHM_VERSION = 3
"""Part of the key of what is kept: to be raised with every change of what baking gives."""

RAYS = 32
_FEWEST_PLACES, _MOST_PLACES = 40_000, 400_000
_PLACES_A_TRIANGLE = 1.5
_ROUNDS = 8
_MISFIT = 0.07
"""Triangles that miss what is seen on them by more than this share of the light, in root mean square, are cut."""
_PATCH = 0.02
"""... on a patch of this share of the mesh's size: a small shadow in the middle of a large triangle counts."""
_NOISE = 0.002
"""Variance of what 32 rays see."""
_SHORTEST = 0.004
"""... unless their longest edge is less than this share of the mesh's size: 2 cm on a car."""
_PLACES_A_PIECE = 4
_ADDED_SHARE, _ADDED_FEWEST = 0.5, 40_000


@dataclass(frozen=True, eq=False)
class _Surface:
    """All parts in one: vertices, triangles, the part of each triangle, and whether that is seen from behind too."""

    positions: Singles
    normals: Singles
    uvs: Singles
    triangles: Integers
    part: Integers
    open_parts: NDArray[np.bool_]

    @property
    def two_sided(self) -> NDArray[np.bool_]:
        """(k,): whether each triangle is seen from behind too."""
        return np.asarray(self.open_parts[self.part])


def bake(mesh: Mesh, progress: Progress | None = None) -> BakedMesh:
    """Return ``mesh`` with occlusion at its vertices. The same mesh gives the same numbers on the same machine.

    Raises
    ------
    Cancelled
        ``progress`` asked for it.
    SuiteError
        There is no Embree, which traces the rays, for this machine.
    """
    surface = _joined(mesh)
    report(progress, 0.0, "occlusion: sorting the triangles")
    try:
        passing = np.array([TRANSMITTANCE.get(part.material, 0.0) for part in mesh.parts])
        iors = np.array([PANE_IOR.get(part.material, 1.0) for part in mesh.parts])
        scene = RayScene(surface.positions[surface.triangles], passing[surface.part], iors[surface.part])
    except ImportError as error:
        raise SuiteError(
            f"Occlusion cannot be baked: the ray tracer Embree is not there for this machine ({error})."
        ) from error
    low, high = mesh.bounds()
    ground = bake_floor(scene, low, high, subrange(progress, 0.02, 0.3))

    def look(places: Places, behind: NDArray[np.bool_], progress: Progress | None) -> Singles:
        """What is seen at places (n, 18): from the front, and from the back of those that have one."""
        what = "occlusion of the surface"
        found = np.zeros((len(places.points), 18), np.float32)
        share = 0.5 if behind.any() else 1.0
        first, second = subrange(progress, 0.0, share), subrange(progress, share, 1.0)
        found[:, :9] = scene.gather(places.points, places.normals, places.planes, RAYS, ground, first, what)
        if behind.any():
            points, normals, planes = (v[behind] for v in places.behind())
            found[behind, 9:] = scene.gather(points, normals, planes, RAYS, ground, second, what)
        return found

    count = int(np.clip(_PLACES_A_TRIANGLE * len(surface.triangles), _FEWEST_PLACES, _MOST_PLACES))
    places = spread(surface.positions, surface.normals, surface.triangles, count)
    seen = look(places, surface.two_sided[places.triangle], subrange(progress, 0.3, 0.85))
    limit = len(surface.triangles) + max(_ADDED_FEWEST, int(_ADDED_SHARE * mesh.triangle_count))
    for number in range(_ROUNDS + 1):
        report(progress, 0.85 + 0.15 * number / (_ROUNDS + 1), "fitting the occlusion")
        values = _values(surface, places, seen[:, :9])
        chosen = _misfits(surface, places, seen[:, :9], values)
        if surface.open_parts.any():
            back = _values(surface, places, seen[:, 9:])
            chosen |= _misfits(surface, places, seen[:, 9:], back)
            values = np.hstack([values, back])
        if number == _ROUNDS or not chosen.any() or len(surface.triangles) + 3 * chosen.sum() > limit:
            break
        surface, places, seen = _refined(surface, places, seen, chosen, look)
    report(progress, 1.0, "occlusion")
    return BakedMesh(_separated(mesh, surface, values), ground)


def _joined(mesh: Mesh) -> _Surface:
    starts = np.cumsum([0, *(len(p.positions) for p in mesh.parts)])
    return _Surface(
        np.concatenate([p.positions for p in mesh.parts]),
        np.concatenate([p.normals for p in mesh.parts]),
        np.concatenate([p.uvs for p in mesh.parts]),
        np.concatenate([p.triangles.astype(np.int64) + s for p, s in zip(mesh.parts, starts, strict=False)]),
        np.repeat(np.arange(len(mesh.parts)), [len(p.triangles) for p in mesh.parts]),
        np.array([not is_closed_outward(p.positions, p.triangles) for p in mesh.parts]),
    )


def _values(surface: _Surface, places: Places, seen: Singles) -> Singles:
    """Return (n, 8) at the vertices: direction and share of the light, without and with the floor."""
    # Columns of what was seen: share, x, y, z, alone and then with the floor.
    useful = replace(places, area=places.area * (seen[:, 8] > 0.5))
    # scipy.sparse takes a quarter of a second to import, and a start needs what is baked already.
    from brdf_suite.surface.occlusion.fit import shared_places, vertex_values

    shared = shared_places(surface.positions, surface.normals)
    found = vertex_values(surface.positions, surface.triangles, shared, useful, seen[:, :8])
    values = found[:, [1, 2, 3, 0, 5, 6, 7, 4]]
    values[:, [3, 7]] = np.clip(values[:, [3, 7]], 0.0, 1.0)
    return values.astype(np.float32)


def _misfits(surface: _Surface, places: Places, seen: Singles, values: Singles) -> NDArray[np.bool_]:
    corners = values[surface.triangles[places.triangle]][:, :, [3, 7]]
    error = np.einsum("nk,nkc->nc", places.weights, corners) - seen[:, [0, 4]]
    counted = (seen[:, 0] > 0.0) & (seen[:, 8] > 0.5)
    weight = np.where(counted, places.area, 0.0)
    count = len(surface.triangles)
    total = np.bincount(places.triangle, weight, count)
    excess = np.maximum((error**2).max(axis=1) - _NOISE, 0.0)
    squared = np.bincount(places.triangle, weight * excess, count)
    size = float(np.ptp(surface.positions, axis=0).max())
    patch = np.minimum(total, (_PATCH * size) ** 2)
    misfit = np.sqrt(np.divide(squared, patch, out=np.zeros(count), where=total > 0.0))
    edges = surface.positions[surface.triangles]
    longest = np.linalg.norm(edges - np.roll(edges, 1, axis=1), axis=2).max(axis=1)
    return np.asarray((misfit > _MISFIT) & (longest > _SHORTEST * size))


def _refined(
    surface: _Surface, places: Places, seen: Singles, chosen: NDArray[np.bool_], look: Look
) -> tuple[_Surface, Places, Singles]:
    """Cut the chosen triangles and sample the pieces; samples on uncut triangles are kept."""
    made = cut(surface.positions, surface.triangles, chosen)
    new = _Surface(
        made.extended(surface.positions),
        made.extended(surface.normals),
        made.extended(surface.uvs),
        made.triangles,
        surface.part[made.origin],
        surface.open_parts,
    )
    number = np.full(len(surface.triangles), -1)
    whole = np.flatnonzero(made.whole)
    number[made.origin[whole]] = whole
    kept = number[places.triangle] >= 0
    pieces = np.flatnonzero(~made.whole)
    # Large triangles must not be looked at more loosely than before.
    count = max(_PLACES_A_PIECE * len(pieces), len(kept) - int(kept.sum()))
    more = spread(new.positions, new.normals, new.triangles[pieces], count)
    more = replace(more, triangle=pieces[more.triangle])
    found = look(more, new.two_sided[more.triangle], None)
    old = replace(places, triangle=number[places.triangle])
    fields = ("triangle", "weights", "area", "points", "normals", "planes", "lifts")
    both = (np.concatenate([getattr(old, name)[kept], getattr(more, name)]) for name in fields)
    return new, Places(*both), np.concatenate([seen[kept], found])


def _separated(mesh: Mesh, surface: _Surface, values: Singles) -> tuple[BakedPart, ...]:
    """Take the parts apart again: each keeps its vertices in their order, with those made on its edges after."""
    starts = np.cumsum([0, *(len(p.positions) for p in mesh.parts)])
    parts = []
    for number in range(len(mesh.parts)):
        triangles = surface.triangles[surface.part == number]
        new = np.unique(triangles[triangles >= starts[-1]])
        kept = np.concatenate([np.arange(starts[number], starts[number + 1]), new])
        own = len(mesh.parts[number].positions)
        local = np.where(
            triangles < starts[-1], triangles - starts[number], own + np.searchsorted(new, triangles)
        )
        parts.append(
            BakedPart(
                surface.positions[kept],
                surface.normals[kept],
                surface.uvs[kept],
                local.astype(np.uint32),
                values[kept, : 16 if surface.open_parts[number] else 8].astype(np.float16),
            )
        )
    return tuple(parts)
