"""First pass of a frame: surface, background and ground as exposed radiance of the working space."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import MappingProxyType
from typing import Any, TypeAlias

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SECOND_PAINT
from brdf_suite.errors import GraphicsError, ValueRangeError
from brdf_suite.realtime.camera import MIDDLE, CameraMatrices, LensPoint, crop, matrices
from brdf_suite.realtime.environment.backdrop import backdrop
from brdf_suite.realtime.environment.ground import GroundShadow
from brdf_suite.realtime.environment.textures import RAMP_UNIT
from brdf_suite.realtime.factors.ball import ReflectanceBalls
from brdf_suite.realtime.factors.textures import FactorTextures
from brdf_suite.realtime.gl.objects import Size, Target
from brdf_suite.realtime.gl.programs import (
    MATERIAL_BINDING,
    PAINTS,
    Features,
    LookUps,
    assign,
    columns,
    surface_features,
    view_uniforms,
)
from brdf_suite.realtime.lights.single_lights import LIT
from brdf_suite.realtime.material.material_set import Modes
from brdf_suite.realtime.pictures.captured import DrawContext
from brdf_suite.realtime.relief.textures import ReliefTextures
from brdf_suite.realtime.relief.values import PeelTile

DEFAULT_SAMPLES = 4
PAINT = "paint"
"""The material that masks belong to; relief belongs to it and to the second paint."""
Corner = tuple[int, int]
Region = tuple[int, int, int, int]
Drawn: TypeAlias = tuple[int, str, Features]
"""A part's number, its material, and the features of the program that draws it."""
AS_THEY_ARE: Mapping[str, str] = MappingProxyType({})
"""No part is drawn with another material."""


class LightPass:
    """The first pass over the renderer's mesh, with the ground, relief, factors and reflectance balls drawn in it."""

    def __init__(self, drawing: DrawContext, make_peel: Callable[[], PeelTile] | None) -> None:
        self._objects, self._programs, self._environment = (
            drawing.objects,
            drawing.programs,
            drawing.environment,
        )
        self.mesh, self._materials = drawing.mesh, drawing.materials
        self._single_lights, self._shadows = drawing.single_lights, drawing.shadows
        self.ground = GroundShadow(drawing.objects)
        self.relief = ReliefTextures(drawing.objects, make_peel)
        self.factors = FactorTextures(drawing.objects)
        self.balls = ReflectanceBalls(drawing, self.factors)
        self._warm: tuple[int, int, Features] | None = None

    def draw(
        self,
        view: View,
        target: Target,
        tile: Size,
        samples: int,
        size: Size,
        corner: Corner = (0, 0),
        *,
        materials: Mapping[str, str] = AS_THEY_ARE,
        region: Region | None = None,
        dtype: str = "f2",
        transparent: bool = False,
        without_paint: bool = False,
        lens: LensPoint = MIDDLE,
    ) -> moderngl.Texture:
        """Draw a tile of a picture of ``size`` into ``target`` and return its exposed radiance, seen from ``lens``.

        ``without_paint`` leaves nothing where the paint is but what panes and gaps lay over it, with their alpha.
        """
        if not self._environment.exponents:
            raise GraphicsError("No environment has been chosen yet; choose one before drawing.")
        samples = min(samples, self._objects.context.max_samples)
        # Graphics cards have powers of two of them.
        samples = 1 << (samples.bit_length() - 1) if samples > 1 else 0
        camera = matrices(view.camera, self.mesh.bounds, size, lens)
        self._single_lights.prepare(view)
        self.balls.draw(view, camera, (materials.get(n, n) for n in (PAINT, SECOND_PAINT)))
        features = surface_features(view, knows_light=self.mesh.knows_light, smooth=samples > 1)
        features |= self._dark(view)
        features |= self._shadows.features(view, features)
        cast = self._shadows.uniforms(view, features)
        framebuffer, light = target.prepare(tile, dtype, samples)
        self._objects.bind(framebuffer, tile, region, depth=True)
        self._environment.bind()
        on_mesh = self._shadows.on_mesh(features)
        self._warm_up(samples, on_mesh | self._single_lights.features(view, PAINT))
        framebuffer.clear(depth=1.0)
        cropping = crop(size, corner, tile)
        opaque, panes = self.divided(view, self.drawn_parts(view, on_mesh), materials)
        if without_paint:
            opaque = [
                (part, name, words | {"LEFT_OUT"} if name == PAINT else words) for part, name, words in opaque
            ]
        common = self._common(view, camera, cropping, cast)
        self._draw_parts(view, self._in_turn(opaque, camera), camera, common, materials)
        self._draw_gaps(view, common, tile, framebuffer)
        if not transparent:
            self._draw_background(view, camera, size, corner)
            self._draw_ground(view, camera, cropping, features, cast)
        self._draw_panes(view, panes, camera, common, materials, framebuffer=framebuffer)
        return light

    def draw_backdrop(
        self,
        view: View,
        target: Target,
        size: Size,
        region: Region | None = None,
        *,
        grounded: bool = True,
    ) -> moderngl.Texture:
        """Draw what is seen past the surface, ``grounded`` with the shadow there, and leave ``target`` bound.

        Return its exposed light, one sample a pixel and without any object, for another's light to be laid over.
        """
        if not self._environment.exponents:
            raise GraphicsError("No environment has been chosen yet; choose one before drawing.")
        camera = matrices(view.camera, self.mesh.bounds, size)
        features = self._dark(view) | surface_features(view, knows_light=self.mesh.knows_light)
        if grounded and view.surface_look.ground:
            features |= self._shadows.features(view, features)
        cast = self._shadows.uniforms(view, features)
        if cast:
            self._single_lights.prepare(view)
        framebuffer, light = target.prepare(size, "f2")
        self._objects.bind(framebuffer, size, region, depth=True)
        self._environment.bind()
        framebuffer.clear(depth=1.0)
        self._draw_background(view, camera, size, (0, 0))
        if grounded:
            self._draw_ground(view, camera, crop(size, (0, 0), size), features, cast)
        return light

    def _dark(self, view: View) -> Features:
        """Return the word for frames in which the environment sends no light."""
        dark = self._environment.is_dark or view.light_colour.brightness == 0.0
        return frozenset({"DARK"}) if dark else frozenset()

    def _common(
        self,
        view: View,
        camera: CameraMatrices,
        cropping: NDArray[np.float64],
        cast: Mapping[str, object],
    ) -> Mapping[str, object]:
        """Return what all programs that draw the mesh are given."""
        return (
            self._environment.uniforms()
            | view_uniforms(view)
            | {
                "world_to_clip": columns(cropping @ camera.world_to_clip),
                "eye": tuple(camera.eye),
                "grounded": view.surface_look.ground,
            }
            | dict(cast)
            | self.relief.bind(view, self.mesh.bounds)
        )

    def divided(
        self, view: View, drawn: Sequence[Drawn], materials: Mapping[str, str] = AS_THEY_ARE
    ) -> tuple[list[Drawn], list[Drawn]]:
        """Return what hides all that is behind it, and what is seen through."""
        opaque: list[Drawn] = []
        panes: list[Drawn] = []
        modes = Modes(view.fresnel, view.look_up)
        for part, name, words in drawn:
            found = self._materials.find(materials.get(name, name), modes, self._environment.ladder)
            if found.transmittance > 0.0:
                panes.append((part, name, words | {"SEE_THROUGH"}))
            else:
                opaque.append((part, name, words))
        return opaque, panes

    def _in_turn(self, opaque: Sequence[Drawn], camera: CameraMatrices) -> list[Drawn]:
        """Return parts in the order that costs least: those drawn alike after each other, of them the near ones first.

        A second paint comes last, over the first.
        """
        far = self._distances(camera)
        return sorted(opaque, key=lambda drawn: ("SECOND_PAINT" in drawn[2], drawn[1], far[drawn[0]]))

    def _distances(self, camera: CameraMatrices) -> NDArray[np.float64]:
        return np.asarray(np.linalg.norm(self.mesh.middles - camera.eye, axis=1))

    def _draw_panes(
        self,
        view: View,
        panes: Sequence[Drawn],
        camera: CameraMatrices,
        common: Mapping[str, object],
        materials: Mapping[str, str],
        *,
        framebuffer: moderngl.Framebuffer,
    ) -> None:
        """Draw panes over what is behind them, which they leave in the depth buffer, from far to near.

        First the sheets that are seen from their backs: of a body with windows all round those are the far ones.
        """
        if not panes:
            return
        far = self._distances(camera)
        ordered = sorted(panes, key=lambda drawn: -far[drawn[0]])
        with _hiding_nothing(framebuffer):
            for hidden in ("front", "back"):
                self._draw_parts(view, ordered, camera, common, materials, hidden=hidden)
        self._objects.context.cull_face = "back"

    def _draw_gaps(
        self, view: View, common: Mapping[str, object], tile: Size, framebuffer: moderngl.Framebuffer
    ) -> None:
        """Draw the gaps between panels as lines that cover of each pixel what the gap does, and hide nothing."""
        context = self._objects.context
        chosen = view.surface_look.chosen
        gaps = [part for part in self.mesh.gaps if self.mesh.names[part] not in chosen]
        if not gaps:
            return
        program = self._programs.gap_line()
        context.enable_only(moderngl.DEPTH_TEST | moderngl.BLEND)
        context.blend_func = moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA
        with _hiding_nothing(framebuffer):
            for part in gaps:
                own = {"half_size": (0.5 * tile[0], 0.5 * tile[1]), "half_gap": self.mesh.gaps[part]}
                assign(program, {**common, **own})
                self.mesh.line(program, part).render(moderngl.TRIANGLES)
        context.enable_only(moderngl.DEPTH_TEST)

    def _draw_parts(
        self,
        view: View,
        drawn: Sequence[Drawn],
        camera: CameraMatrices,
        common: Mapping[str, object],
        materials: Mapping[str, str],
        *,
        hidden: str | None = None,
    ) -> None:
        """Draw parts; ``hidden`` is the side of panes that is left out."""
        ready: set[tuple[LookUps, Features]] = set()
        context = self._objects.context
        context.front_face, context.cull_face = "ccw", hidden or "back"
        used: tuple[str, Features, bool] | None = None
        for part, name, words in drawn:
            wanted = (materials.get(name, name), words, self.mesh.has_uv[part])
            if wanted != used:
                program, used = self._use(view, *wanted, camera, common, ready), wanted
            # Multisampling software renderers shade what is hidden too: the backs of a solid are left out.
            one_sided = hidden is not None or (camera.outside and self.mesh.closed[part])
            context.enable_only(moderngl.DEPTH_TEST | (moderngl.CULL_FACE if one_sided else moderngl.NOTHING))
            _blend_over(context, words)
            self.mesh.arrays(program)[part].render(moderngl.TRIANGLES)
        context.enable_only(moderngl.DEPTH_TEST)

    def _use(
        self,
        view: View,
        name: str,
        words: Features,
        has_uv: bool,
        camera: CameraMatrices,
        common: Mapping[str, object],
        ready: set[tuple[LookUps, Features]],
    ) -> moderngl.Program:
        """Return the program for a material, with its values; those of ``ready`` have the common ones already."""
        words |= self._single_lights.features(view, name)
        if view.lamps:
            words |= self.balls.words(view, name) or self.factors.features(name, has_uv=has_uv)
        modes = Modes(view.fresnel, view.look_up)
        material = self._materials.find(name, modes, self._environment.ladder)
        program = self._programs.surface(material.look_ups, words)
        if (material.look_ups, words) not in ready:
            assign(program, common)
            ready.add((material.look_ups, words))
        assign(program, self._environment.use_sharp(material.sharp))
        if "COAT_RELIEF" in words:
            assign(program, self.relief.peel_uniforms(view, name))
        assign(program, self.balls.uniforms(name, words, camera))
        if words & LIT:
            assign(program, self._single_lights.uniforms(name, view, has_uv=has_uv))
        assign(program, {"transmittance": material.transmittance})
        material.ramp.use(RAMP_UNIT)
        material.buffer.bind_to_uniform_block(MATERIAL_BINDING)
        return program

    def drawn_parts(self, view: View, features: Features) -> list[Drawn]:
        """Return what is drawn in order: a part's number, its material, and the features of its program.

        Relief belongs to the paints. By a mask, a second paint is drawn over the first, by its share at each place.
        What is drawn as a line over it, a gap, is painted through. A part of the second paint has the first where the
        view names no second.
        """
        chosen = view.surface_look.chosen
        owned = enumerate(zip(self.mesh.names, self.mesh.materials, strict=True))
        names = [
            chosen.get(part, PAINT if number in self.mesh.gaps else own) for number, (part, own) in owned
        ]
        if view.two_tone.paint is None or not self._materials.has(SECOND_PAINT):
            names = [PAINT if name == SECOND_PAINT else name for name in names]
        painted = features | self.relief.features(view)
        drawn = [
            (part, name, painted if name in (PAINT, SECOND_PAINT) else features)
            for part, name in enumerate(names)
        ]
        if self.relief.has_second_paint(view):
            over = painted | {"SECOND_PAINT"}
            drawn += [(part, SECOND_PAINT, over) for part, name in enumerate(names) if name == PAINT]
        if "OCCLUSION" not in features:
            return drawn
        return [(part, name, words | self.mesh.side_words(part)) for part, name, words in drawn]

    def _draw_ground(
        self,
        view: View,
        camera: CameraMatrices,
        cropping: NDArray[np.float64],
        features: Features,
        cast: Mapping[str, object],
    ) -> None:
        """Darken the background by the shadow on the ground, which is visible from above only."""
        height = self.ground.height
        if view.surface_look.ground and height is not None and camera.eye[1] > height:
            self.ground.draw(
                columns(cropping @ camera.world_to_clip),
                float(np.radians(view.rotation_deg)),
                environment_matrix(view.light_colour),
                self._shadows.sun if "SUN" in features else None,
                "LAMP_SHADOWS" in features,
                cast,
                self._shadows.reach_on(height),
            )

    def _warm_up(self, samples: int, features: Features) -> None:
        """Draw one triangle with each program: drivers finish compiling at the first draw, not in an edit."""
        key = (samples, self.mesh.generation, features)
        if self._warm == key or self._environment.on_demand or not self.mesh.materials:
            return
        material = self._materials.find("neutral", Modes(), self._environment.ladder)
        material.ramp.use(RAMP_UNIT)
        material.buffer.bind_to_uniform_block(MATERIAL_BINDING)
        for look_ups in PAINTS:
            program = self._programs.surface(look_ups, features)
            assign(program, self._environment.uniforms() | self._environment.use_sharp(()))
            self.mesh.arrays(program)[0].render(moderngl.TRIANGLES, vertices=3)
        self._warm = key

    def _draw_background(self, view: View, camera: CameraMatrices, size: Size, corner: Corner) -> None:
        program, screen = self._objects.screen("background.frag.glsl")
        own = {
            "view_to_world": columns(camera.view_to_world),
            "half_tangents": camera.half_tangents,
            "lens_shift": camera.shift,
            "frame": (*corner, 1.0 / size[0], 1.0 / size[1]),
            **backdrop(view, self._environment.ladder),
        }
        assign(program, self._environment.uniforms() | view_uniforms(view) | own)
        screen.render(moderngl.TRIANGLES, vertices=3)


@contextmanager
def _hiding_nothing(framebuffer: moderngl.Framebuffer) -> Iterator[None]:
    """Leave the depth buffer as it is."""
    framebuffer.depth_mask = False
    try:
        yield
    finally:
        framebuffer.depth_mask = True


def _blend_over(context: moderngl.Context, words: Features) -> None:
    """Blend panes over what they hide a share of, a second paint by its alpha; the rest not at all."""
    if not words & {"SECOND_PAINT", "SEE_THROUGH"}:
        context.disable(moderngl.BLEND)
        return
    context.enable(moderngl.BLEND)
    if "SEE_THROUGH" in words:
        context.blend_func = moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA
        return
    # The object's coverage stays.
    # moderngl's types know two factors; four set those of alpha apart.
    factors: Any = (moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ZERO, moderngl.ONE)
    context.blend_func = factors


def check_size(size: Size) -> Size:
    """Return width and height as whole numbers of 1 to 65,536 pixels, or raise :class:`ValueRangeError`."""
    width, height = (int(n) for n in size)
    if not (1 <= width <= 65536 and 1 <= height <= 65536):
        raise ValueRangeError("size", f"1 to 65,536 pixels along each edge are drawn, not {width}x{height}")
    return width, height
