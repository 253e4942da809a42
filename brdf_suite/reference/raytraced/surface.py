"""Surface as one mesh of all parts, and its intersection with rays.

One mesh instead of one for each part: where a ray meets it, everything is looked up in plain arrays, and only the
materials are distinguished.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.bsdfs.directions import Real, Vector
from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.numbers import in_cube
from brdf_suite.reference.scene.place import aligned

EPSILON = 1.5e-4
"""Of a place's distance from the origin, and of its ray's length: how far off the surface rays begin."""
_LEAST_FACING = 1e-3
MOST_PANES = 8
"""One behind the other; what lies behind more is not seen."""


@dataclass(frozen=True, eq=False)
class SurfaceArrays:
    """Triangles of all parts: positions, normals (n, 3), texture coordinates (n, 2) mm, triangles (k, 3), and (k,)
    which of the materials each is of.
    """

    positions: npt.NDArray[np.float32]
    normals: npt.NDArray[np.float32]
    uvs: npt.NDArray[np.float32]
    triangles: npt.NDArray[np.uint32]
    materials: npt.NDArray[np.uint32]

    @classmethod
    def of(cls, parts: Sequence[Any], numbers: dict[str, int]) -> SurfaceArrays:
        """Return the arrays of parts of a mesh; ``numbers`` maps each material to its number."""
        starts = np.cumsum([0, *(len(p.positions) for p in parts)])
        return cls(
            np.concatenate([p.positions for p in parts]).astype(np.float32),
            np.concatenate([p.normals for p in parts]).astype(np.float32),
            np.concatenate([p.uvs for p in parts]).astype(np.float32),
            np.concatenate([p.triangles + start for p, start in zip(parts, starts, strict=False)]).astype(
                np.uint32
            ),
            np.concatenate([np.full(len(p.triangles), numbers[p.material]) for p in parts]).astype(np.uint32),
        )


@dataclass
class SurfaceHit:
    """Where rays met the surface: ``place``; ``normal`` towards the viewer, shading; ``view`` back along the ray;
    ``off`` a place a little in front of the triangle; the ``triangle`` and ``u``, ``v`` on it.
    """

    place: Vector
    normal: Vector
    view: Vector
    off: Vector
    triangle: Any
    u: Real
    v: Real


class Surface:
    """The Mitsuba mesh with its arrays; ``panes`` are the terms of materials seen through, by their numbers."""

    def __init__(self, arrays: SurfaceArrays, panes: Mapping[int, LobeWeightsTerm] | None = None) -> None:
        self._panes = dict(panes or {})
        self._scene = _scene(arrays.positions, arrays.triangles)
        self._opaque, self._glazing = self._scene, None
        if self._panes:
            is_pane = np.isin(arrays.materials, list(self._panes))
            self._opaque = None if is_pane.all() else _scene(arrays.positions, arrays.triangles[~is_pane])
            self._glazing = _scene(arrays.positions, arrays.triangles[is_pane])
            self._glazed = mi.UInt32(np.flatnonzero(is_pane).astype(np.uint32))
        self._positions, self._normals, self._uvs = (
            mi.Float(aligned(a).ravel()) for a in (arrays.positions, arrays.normals, arrays.uvs)
        )
        self._triangles = mi.UInt32(aligned(arrays.triangles, np.uint32).ravel())
        self._materials = mi.UInt32(np.ascontiguousarray(arrays.materials))
        dr.eval(self._positions, self._normals, self._uvs, self._triangles, self._materials)

    def meet(
        self, origin: Vector, direction: Vector, active: Any, *, coherent: bool
    ) -> tuple[Real, SurfaceHit]:
        """Return how far the nearest meeting is, infinity for none, and the hit, which then means nothing."""
        ray = mi.Ray3f(mi.Point3f(origin), direction)
        found = self._scene.ray_intersect_preliminary(ray, coherent=mi.Bool(coherent), active=active)
        met = active & found.is_valid()
        triangle, u, v = found.prim_index, found.prim_uv.x, found.prim_uv.y
        corners = self._corners(triangle, met)
        a, b, c = (dr.gather(mi.Vector3f, self._positions, k, met) for k in corners)
        along, beside = b - a, c - a
        place = dr.fma(u, along, dr.fma(v, beside, a))
        flat = dr.normalize(dr.cross(along, beside))
        na, nb, nc = (dr.gather(mi.Vector3f, self._normals, k, met) for k in corners)
        normal = dr.normalize(dr.fma(u, nb - na, dr.fma(v, nc - na, na)))
        view = -direction
        flat = dr.select(dr.dot(flat, view) < 0.0, -flat, flat)
        # Both sides are painted. Near an outline the shading normal may look away from the viewer, though its
        # triangle does not: there it is bent until it is just seen.
        normal = dr.select(dr.dot(normal, flat) < 0.0, -normal, normal)
        facing = dr.dot(normal, view)
        bent = dr.normalize(normal + (_LEAST_FACING - facing) * view)
        normal = dr.select(facing < _LEAST_FACING, bent, normal)
        reach = EPSILON * (0.05 + dr.max(dr.abs(place)))
        far = dr.select(met, found.t, dr.inf)
        return far, SurfaceHit(place, normal, view, dr.fma(reach, flat, place), triangle, u, v)

    def arriving(self, origin: Vector, direction: Vector, length: Real, active: Any) -> Real:
        """Return which share of the light comes along a ray of ``length``: 0 where something hides it."""
        ray = mi.Ray3f(mi.Point3f(origin), direction)
        ray.maxt = length
        free = mi.Bool(active)
        if self._opaque is not None:
            free &= ~self._opaque.ray_test(ray, coherent=mi.Bool(True), active=active)
        glazing = self._glazing
        if glazing is None:
            return dr.select(free, mi.Float(1.0), 0.0)

        def one_more(k: Any, going: Any, share: Real, start: Real) -> tuple[Any, ...]:
            rest = mi.Ray3f(mi.Point3f(dr.fma(start, direction, origin)), direction)
            rest.maxt = length - start
            found = glazing.ray_intersect_preliminary(rest, coherent=mi.Bool(True), active=going)
            going = going & found.is_valid()
            triangle = dr.gather(mi.UInt32, self._glazed, found.prim_index, going)
            share = share * dr.select(going, self._passing(triangle, found.prim_uv, direction, going), 1.0)
            return k + 1, going, share, start + found.t + EPSILON * (0.05 + dr.max(dr.abs(origin)))

        state = (
            mi.UInt32(0),
            mi.Bool(free),
            dr.select(free, mi.Float(1.0), 0.0),
            dr.zeros(mi.Float, dr.width(free)),
        )
        _, _, share, _ = dr.while_loop(
            state, lambda k, going, *_: going & (k < MOST_PANES), one_more, label="panes before a light"
        )
        return share

    def beyond_panes(self, origin: Vector, direction: Vector, number: Any, turn: Any, active: Any) -> Vector:
        """Return where rays begin anew behind the panes that they pass, each by the chance of its share.

        ``number`` and ``turn`` are those of :func:`.numbers.in_cube`.
        """
        if not self._panes:
            return origin

        def one_more(k: Any, going: Any, start: Vector) -> tuple[Any, ...]:
            ray = mi.Ray3f(mi.Point3f(start), direction)
            found = self._scene.ray_intersect_preliminary(ray, coherent=mi.Bool(False), active=going)
            going = going & found.is_valid()
            share = self._passing(found.prim_index, found.prim_uv, direction, going)
            # Three panes take the three numbers of a sample, which are even together; the next three others.
            a, pair = in_cube(number, turn + (k // 3 + 1) * mi.UInt32(0x632BE59B))
            choice = dr.select(k % 3 == 0, a, dr.select(k % 3 == 1, pair.x, pair.y))
            going &= choice < share
            past = found.t + EPSILON * (0.05 + dr.max(dr.abs(start)))
            return k + 1, going, dr.select(going, dr.fma(past, direction, start), start)

        state = (mi.UInt32(0), mi.Bool(active), mi.Vector3f(origin))
        found: Vector = dr.while_loop(
            state, lambda k, going, _: going & (k < MOST_PANES), one_more, label="panes before a surface"
        )[2]
        return found

    def _passing(self, triangle: Any, uv: Any, direction: Vector, active: Any) -> Real:
        """Return the share of light along a ray that passes a triangle, 0 where it is no pane's."""
        material = dr.gather(mi.UInt32, self._materials, triangle, active)
        corners = self._corners(triangle, active)
        a, b, c = (dr.gather(mi.Vector3f, self._normals, k, active) for k in corners)
        normal = dr.normalize(dr.fma(uv.x, b - a, dr.fma(uv.y, c - a, a)))
        cosine = dr.abs(dr.dot(normal, direction))
        share = mi.Float(0.0)
        for number, term in self._panes.items():
            share = dr.select(material == number, term.passing(cosine), share)
        return share

    def material(self, hit: SurfaceHit, active: Any) -> Any:
        """Return the number of the hit's material."""
        return dr.gather(mi.UInt32, self._materials, hit.triangle, active)

    def texture_place(
        self, hit: SurfaceHit, across: Vector, down: Vector, active: Any
    ) -> tuple[Any, Any, Any]:
        """Return where a hit is in texture coordinates, mm, and how that changes by ``across`` and ``down``.

        Those are changes of the place in the triangle's plane, metres; the answers are mm.
        """
        ia, ib, ic = self._corners(hit.triangle, active)
        a, b, c = (dr.gather(mi.Vector3f, self._positions, k, active) for k in (ia, ib, ic))
        ta, tb, tc = (dr.gather(mi.Point2f, self._uvs, k, active) for k in (ia, ib, ic))
        e, f = b - a, c - a
        te, tf = mi.Vector2f(tb - ta), mi.Vector2f(tc - ta)
        ee, ef, ff = dr.dot(e, e), dr.dot(e, f), dr.dot(f, f)
        det = dr.maximum(ee * ff - ef * ef, 1e-30)

        def moved(by: Vector) -> Any:
            be, bf = dr.dot(by, e), dr.dot(by, f)
            return ((ff * be - ef * bf) * te + (ee * bf - ef * be) * tf) / det

        at = ta + hit.u * te + hit.v * tf
        return at, moved(across), moved(down)

    def _corners(self, triangle: Any, active: Any) -> list[Any]:
        return [dr.gather(mi.UInt32, self._triangles, 3 * triangle + k, active) for k in range(3)]


def _scene(positions: npt.NDArray[np.float32], triangles: npt.NDArray[np.uint32]) -> Any:
    mesh = mi.Mesh("surface", len(positions), len(triangles))
    values = mi.traverse(mesh)
    values["vertex_positions"] = aligned(positions).ravel()
    values["faces"] = aligned(triangles, np.uint32).ravel()
    values.update()
    # Without it some rays slip through between two triangles, and a black dot is left of them.
    return mi.load_dict({"type": "scene", "surface": mesh, "embree_use_robust_intersections": True})
