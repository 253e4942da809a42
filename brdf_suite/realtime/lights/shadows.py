"""Shadows of single lights: of the environment's sun and of lamps, in the tiles of one shadow map.

Each light has a square tile with the depth of what it sees of the mesh (``shadows.glsl``), and where there are panes a
second one, with the share of its light that those pass. A tile is drawn again only where its light or the mesh has
changed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import moderngl
import numpy as np

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import MOST_LAMPS, PANE_IOR, TRANSMITTANCE, Lamp
from brdf_suite.geometry.directions import about_y, from_horizon
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.mesh_buffers import MeshBuffers
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import PANE_UNIT, SHADOW_UNIT, Features, Programs, assign, columns
from brdf_suite.realtime.lights.single_lights import FindLights, no_lights
from brdf_suite.realtime.lights.sun import Sun, find_sun

MOST_SHADOWS = 1 + MOST_LAMPS

SUN_TILE, LAMP_TILE = 2048, 1024
"""Texels along the edge of a tile."""
WIDEST_TANGENT = 4.0
"""Of half the angle that a near lamp's tile covers, 76°: what is farther aside casts no shadow of that lamp."""
LONGEST_SHADOW = 20.0
_NEAREST = 1.0 / 2000.0
"""Of the farthest distance: depth keeps its resolution."""

_Tile = tuple[int, int, int]
"""Lower left corner and edge, texels."""


@dataclass(frozen=True, eq=False)
class ShadowFrame:
    """How a light sees a mesh.

    Attributes
    ----------
    to_tile
        (4, 4): world to the place in the tile, 0 to 1, times w; the distance along the axis, metres; w.
    source
        (3,): unit, to a distant light, or the place of a near one, metres.
    nearest, farthest
        Distances along the axis, metres.
    radius
        Of the light's disc: radians of a distant light, metres of a near one.
    width
        Of the tile, metres; of a near light at a distance of 1 m.
    near
        Whether the light is at a place, and sees in perspective.
    """

    to_tile: Floats
    source: Floats
    nearest: float
    farthest: float
    radius: float
    width: float
    near: bool

    @property
    def to_clip(self) -> Floats:
        """(4, 4): world to clip space of the tile."""
        x, y, z, w = self.to_tile
        low, high = self.nearest, self.farthest
        if self.near:
            one = np.array([0.0, 0.0, 0.0, 1.0])
            depth = ((high + low) * z - 2.0 * high * low * one) / (high - low)
        else:
            depth = 2.0 * (z - low * w) / (high - low) - w
        return np.stack([2.0 * x - w, 2.0 * y - w, depth, w])

    def shadows(self, points: Floats, height: float) -> Floats:
        """Return where the shadows (n, 2) of points (n, 3) fall on a ground at ``height``: x and z, metres.

        Those of a low light are cut off, where they are :data:`LONGEST_SHADOW` times as long as the point is high.
        """
        ways = points - self.source if self.near else np.broadcast_to(-self.source, points.shape)
        level = np.linalg.norm(ways[:, [0, 2]], axis=1)
        fall = np.maximum(-ways[:, 1], np.maximum(level / LONGEST_SHADOW, 1e-9))
        step = (points[:, 1] - height) / fall
        return np.asarray(points[:, [0, 2]] + step[:, None] * ways[:, [0, 2]])


def distant_frame(direction: Floats, radius: float, bounds: Bounds) -> ShadowFrame:
    """Return the frame of a light at infinity: unit ``direction`` (3,) to it, ``radius`` of its disc in radians."""
    axes = _axes_about(direction)
    low, high = np.array(bounds.minimum), np.array(bounds.maximum)
    half = 0.505 * max(float(np.linalg.norm(high - low)), 1e-6)
    to_tile = np.zeros((4, 4))
    to_tile[:2, :3] = axes[:2] / (2.0 * half)
    to_tile[2, :3] = -direction
    to_tile[:3, 3] = -to_tile[:3, :3] @ (0.5 * (low + high)) + [0.5, 0.5, half]
    to_tile[3, 3] = 1.0
    return ShadowFrame(to_tile, direction, 0.0, 2.0 * half, radius, 2.0 * half, near=False)


def near_frame(place: Floats, radius: float, bounds: Bounds) -> ShadowFrame:
    """Return the frame of a lamp at ``place`` (3,), metres, a ball of ``radius``, metres.

    It covers the mesh, as far as that is within :data:`WIDEST_TANGENT` of its axis.
    """
    ways = bounds.frame_points - place
    lengths = np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-9)
    ahead = (ways / lengths).mean(axis=0)
    if np.linalg.norm(ahead) < 1e-3:
        ahead = np.array([0.0, -1.0, 0.0])
    ahead /= np.linalg.norm(ahead)
    axes = _axes_about(-ahead)
    depth = ways @ ahead
    far = max(1.01 * float(depth.max()), 1e-4)
    low = max(0.99 * float(depth.min()), _NEAREST * far)
    aside = np.abs(ways @ axes[:2].T).max(axis=1) / np.maximum(depth, 1e-9)
    tangent = WIDEST_TANGENT if (depth <= 0.0).any() else min(1.01 * float(aside.max()), WIDEST_TANGENT)
    tangent = max(tangent, 1e-6)
    to_tile = np.zeros((4, 4))
    to_tile[:2, :3] = axes[:2] / (2.0 * tangent) + 0.5 * ahead
    to_tile[2, :3] = to_tile[3, :3] = ahead
    to_tile[:, 3] = -to_tile[:, :3] @ place
    return ShadowFrame(to_tile, place, low, far, radius, 2.0 * tangent, near=True)


def lamp_frame(lamp: Lamp, bounds: Bounds) -> ShadowFrame:
    """Return the frame of a lamp of a view."""
    if lamp.kind == "point":
        return near_frame(np.asarray(lamp.position, float), 0.5 * lamp.diameter, bounds)
    direction = from_horizon(lamp.azimuth_deg, lamp.elevation_deg)
    return distant_frame(direction, math.radians(0.5 * lamp.angle_deg), bounds)


def _axes_about(direction: Floats) -> Floats:
    """Return (2, 3): unit vectors to the right and up of who looks against a unit ``direction`` (3,)."""
    aside = np.array([1.0, 0.0, 0.0]) if abs(direction[0]) < 0.7 else np.array([0.0, 0.0, 1.0])
    right = np.cross(aside, direction)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(direction, right)])


class Shadows:
    """The environment's sun, the view's lamps, and the map of what they see of a mesh."""

    def __init__(self, objects: GpuObjects, programs: Programs, mesh: MeshBuffers) -> None:
        self._objects, self._programs, self._mesh = objects, programs, mesh
        self._map: tuple[moderngl.Framebuffer, moderngl.Texture] | None = None
        self._pane_map: tuple[moderngl.Framebuffer, moderngl.Texture] | None = None
        self._drawn: dict[_Tile, tuple[int, bytes, tuple[str, ...]]] = {}
        self._find: FindLights = no_lights
        self._mean: Floats = np.zeros(3)
        self._found: tuple[Sun | None] | None = None
        self._frames: list[ShadowFrame] = []

    def set_environment(self, find: FindLights, mean_radiance: Floats) -> None:
        """Take another environment: what finds its lights, and its mean radiance (3,)."""
        self._find, self._mean, self._found = find, mean_radiance, None

    @property
    def sun(self) -> Sun | None:
        """The environment's sun, looked for at the first call; None where it has none."""
        if self._found is None:
            self._found = (find_sun(self._find(), self._mean),)
        return self._found[0]

    def features(self, view: View, features: Features) -> Features:
        """Return the words of lit.glsl for frames whose programs have ``features``: which lights cast shadows."""
        words = set()
        if "OCCLUSION" in features:
            if "DARK" not in features and self.sun is not None:
                words.add("SUN")
            if view.lamps and (view.surface_look.ground or not self._mesh.hides_nothing):
                words.add("LAMP_SHADOWS")
        if words and any(self._panes(view)):
            words.add("PANE_SHADOWS")
        return frozenset(words)

    def _panes(self, view: View) -> tuple[str, ...]:
        """Return the material of each part that is a pane, "" of the others."""
        chosen = view.surface_look.chosen
        materials = zip(self._mesh.names, self._mesh.materials, strict=True)
        return tuple(
            name if name in TRANSMITTANCE else ""
            for name in (chosen.get(part, own) for part, own in materials)
        )

    def on_mesh(self, features: Features) -> Features:
        """Return the words for the mesh itself, which of an open place needs no look-up for lamps."""
        return features - {"LAMP_SHADOWS"} if self._mesh.hides_nothing else features

    def uniforms(self, view: View, features: Features) -> dict[str, object]:
        """Return the inputs of shadows.glsl for the lights of ``view``, the map drawn and bound.

        Nothing where no light casts shadows in programs with ``features``. Bind the framebuffer of the picture
        afterwards.
        """
        values: dict[str, object] = {}
        frames: list[tuple[ShadowFrame, int]] = []
        sun = self.sun if "SUN" in features else None
        if sun is not None:
            direction = sun.direction @ about_y(math.radians(view.rotation_deg)).T
            values["sun_direction"] = triple(direction)
            values["sun_irradiance"] = triple(sun.irradiance @ environment_matrix(view.light_colour).T)
            # An even disc has twice its standard deviation along an axis as radius.
            frames.append((distant_frame(direction, 2.0 * sun.spread, self._mesh.bounds), SUN_TILE))
        if "LAMP_SHADOWS" in features:
            frames += [(lamp_frame(lamp, self._mesh.bounds), LAMP_TILE) for lamp in view.lamps]
        self._frames = [frame for frame, _ in frames]
        if not frames:
            return {}
        tiles = _tiles([size for _, size in frames])
        texture, passed = self._draw(
            self._frames, tiles, self._panes(view), glazed="PANE_SHADOWS" in features
        )
        texture.use(SHADOW_UNIT)
        if passed is not None:
            passed.use(PANE_UNIT)
            values["pane_map"] = PANE_UNIT
        each = list(zip(self._frames, tiles, strict=True))
        # A whole array is written: a part of one is none to moderngl.
        each += [each[-1]] * (MOST_SHADOWS - len(each))
        return values | {
            "shadow_map": SHADOW_UNIT,
            "shadow_to_tile": tuple(columns(frame.to_tile) for frame, _ in each),
            "shadow_tile": tuple((*map(float, tile), float(frame.near)) for frame, tile in each),
            "shadow_from": tuple((*triple(frame.source), 0.0) for frame, _ in each),
            "shadow_range": tuple((f.nearest, f.farthest, f.radius, f.width) for f, _ in each),
        }

    def reach_on(self, height: float) -> tuple[Floats, Floats]:
        """Return the lowest and the highest (x, z) of the shadows on a ground at ``height``, metres, as last drawn."""
        points = self._mesh.bounds.frame_points
        met = np.concatenate([points[:, [0, 2]], *(frame.shadows(points, height) for frame in self._frames)])
        return met.min(axis=0), met.max(axis=0)

    def _draw(
        self, frames: Sequence[ShadowFrame], tiles: Sequence[_Tile], panes: tuple[str, ...], *, glazed: bool
    ) -> tuple[moderngl.Texture, moderngl.Texture | None]:
        """Return the maps with these frames of what hides light, and of panes; drawn is what is not there yet.

        ``panes`` has the material of each part that is one, "" of the others. There is no map of panes unless
        ``glazed``.
        """
        size = max(x + edge for x, _, edge in tiles), max(y + edge for _, y, edge in tiles)
        if self._map is None or self._map[1].size != size:
            for made in (*(self._map or ()), *(self._pane_map or ())):
                self._objects.release(made)
            texture = self._objects.depth_texture(size)
            self._map = self._objects.framebuffer(depth=texture), texture
            self._pane_map = None
            self._drawn = {}
        if glazed and self._pane_map is None:
            passed = self._objects.texture(size, "f2")
            passed.filter = (moderngl.LINEAR, moderngl.LINEAR)
            passed.repeat_x = passed.repeat_y = False
            self._pane_map = self._objects.framebuffer(passed, depth=self._map[1]), passed
            self._drawn = {}
        for frame, tile in zip(frames, tiles, strict=True):
            wanted = (self._mesh.generation, frame.to_clip.tobytes(), panes)
            if self._drawn.get(tile) == wanted:
                continue
            with graphics_errors(self._objects.context, "drawing the shadow of a light"):
                self._draw_tile(self._map[0], size, frame, tile, panes)
                if glazed and self._pane_map is not None:
                    self._draw_panes(self._pane_map[0], size, frame, tile, panes)
            self._drawn[tile] = wanted
        return self._map[1], self._pane_map[1] if glazed and self._pane_map is not None else None

    def _draw_tile(
        self,
        framebuffer: moderngl.Framebuffer,
        size: tuple[int, int],
        frame: ShadowFrame,
        tile: _Tile,
        panes: tuple[str, ...],
    ) -> None:
        program = self._programs.shadow_map()
        self._objects.bind(framebuffer, size, depth=True)
        viewport = (tile[0], tile[1], tile[2], tile[2])
        framebuffer.clear(depth=1.0, viewport=viewport)
        self._objects.context.viewport = viewport
        assign(program, {"light_to_clip": columns(frame.to_clip)})
        for array, pane in zip(self._mesh.arrays(program), panes, strict=True):
            if not pane:
                array.render(moderngl.TRIANGLES)

    def _draw_panes(
        self,
        framebuffer: moderngl.Framebuffer,
        size: tuple[int, int],
        frame: ShadowFrame,
        tile: _Tile,
        panes: tuple[str, ...],
    ) -> None:
        """Draw what panes in front of all else leave of the light, over the depths that are drawn already."""
        context, program = self._objects.context, self._programs.shadow_map(panes=True)
        self._objects.bind(framebuffer, size, depth=True)
        viewport = (tile[0], tile[1], tile[2], tile[2])
        framebuffer.depth_mask = False
        framebuffer.clear(1.0, 1.0, 1.0, 1.0, viewport=viewport)
        context.viewport = viewport
        context.enable_only(moderngl.DEPTH_TEST | moderngl.BLEND)
        context.blend_func = moderngl.ZERO, moderngl.SRC_COLOR
        context.blend_equation = moderngl.FUNC_ADD, moderngl.MIN
        source = (*triple(frame.source), float(frame.near))
        for array, pane in zip(self._mesh.arrays(program), panes, strict=True):
            if pane:
                own = {"ior": PANE_IOR[pane], "transmittance": TRANSMITTANCE[pane]}
                assign(program, {"light_to_clip": columns(frame.to_clip), "light_from": source, **own})
                array.render(moderngl.TRIANGLES)
        context.blend_equation = moderngl.FUNC_ADD, moderngl.FUNC_ADD
        context.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA
        context.enable_only(moderngl.DEPTH_TEST)
        framebuffer.depth_mask = True


def _tiles(edges: Sequence[int]) -> list[_Tile]:
    """Return a tile for each edge: those of the sun first, lamps in columns of two beside it.

    >>> _tiles([2048, 1024, 1024, 1024])
    [(0, 0, 2048), (2048, 0, 1024), (2048, 1024, 1024), (3072, 0, 1024)]
    """
    tiles: list[_Tile] = []
    across = row = 0
    for edge in edges:
        tiles.append((across, row, edge))
        row += edge
        if row >= SUN_TILE or edge == SUN_TILE:
            across, row = across + edge, 0
    return tiles
