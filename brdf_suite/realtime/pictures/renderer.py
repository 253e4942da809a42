"""Renderer of surfaces with lobe weights in prefiltered light, for the Viewer and the command line.

One frame is two passes. The first draws surface and background into half floats, multisampled: radiance of the
working space times the exposure. The second takes each sample through the tone curve to the light of the screen, so
that a bright highlight's edge is smooth too, averages them, encodes, dithers, and writes into the caller's
framebuffer, a widget's or its own.

    renderer = Renderer(create_context())
    renderer.set_environment(maps)
    renderer.set_mesh(parts)
    renderer.set_material("paint", weights)
    picture = renderer.render_image(View(), (1280, 720))      # (720, 1280, 3) uint8, top row first
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import View
from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.camera import Bounds, CameraMatrices, crop, matrices
from brdf_suite.realtime.environment.backdrop import backdrop
from brdf_suite.realtime.environment.ground import GroundShadow
from brdf_suite.realtime.environment.textures import RAMP_UNIT, EnvironmentTextures
from brdf_suite.realtime.factors.ball import ReflectanceBalls
from brdf_suite.realtime.factors.textures import FactorTextures
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.mesh_buffers import MeshBuffers
from brdf_suite.realtime.gl.objects import Counters, GpuObjects
from brdf_suite.realtime.gl.programs import MATERIAL_BINDING, PAINTS, Features, LookUps, Programs, assign
from brdf_suite.realtime.gl.target import LightTarget, PictureTarget
from brdf_suite.realtime.gl.view_uniforms import columns, surface_features, view_uniforms
from brdf_suite.realtime.lights.single_lights import FindLights, SingleLights, no_lights
from brdf_suite.realtime.material.material_set import MaterialSet, Modes
from brdf_suite.realtime.pictures.captured import DrawContext
from brdf_suite.realtime.pictures.display import SRGB, Display, Unshowable
from brdf_suite.realtime.pictures.finish import FinishPass
from brdf_suite.realtime.pictures.offscreen import (
    AS_THEY_ARE,
    DEFAULT_SAMPLES,
    PAINT,
    SECOND_PAINT,
    Corner,
    OffscreenPictures,
    Region,
    Size,
    check_size,
)
from brdf_suite.realtime.relief.textures import ReliefTextures
from brdf_suite.realtime.relief.values import PeelTile
from brdf_suite.realtime.values import EnvironmentMaps, GroundField, MaterialWeights, MeshPart


class Renderer(OffscreenPictures):
    """All state of one OpenGL context; every call must come with that context current, from one thread.

    ``surface_shader`` is a fragment shader file to draw surfaces with instead of ours: for measurements. ``screen`` is
    what frames are drawn for: sRGB until it is set to the monitor that they are seen on. ``balls`` has the reflectance
    balls of factored materials. ``make_peel`` makes the tile of the orange peel when one is first drawn.

    ``objects`` makes this context's objects, and :meth:`release` releases all that it made; ``mesh`` has the parts of
    the surface, ``relief`` the paint's normal map, orange peel and mask, ``factors`` the maps of factored materials,
    by which lamps are shaded instead of by lobes.
    """

    def __init__(
        self,
        context: moderngl.Context,
        surface_shader: Path | None = None,
        *,
        make_peel: Callable[[], PeelTile] | None = None,
    ) -> None:
        self.context = context
        self.objects = GpuObjects(context)
        self._programs = Programs(self.objects, surface_shader)
        self._environment = EnvironmentTextures(self.objects)
        self.mesh = MeshBuffers(self.objects)
        self._materials = MaterialSet(self.objects)
        self._single_lights = SingleLights(self.objects)
        self._light = LightTarget(self.objects)
        self._tile = LightTarget(self.objects)
        self._picture = PictureTarget(self.objects)
        self._finish = FinishPass(self.objects, self._programs)
        self.screen: Display = SRGB
        self._ground = GroundShadow(self.objects)
        self.relief = ReliefTextures(self.objects, make_peel)
        self.factors = FactorTextures(self.objects)
        self._drawing = DrawContext(
            self.objects,
            self._programs,
            self._environment,
            self.mesh,
            self._materials,
            self._single_lights,
            self._finish,
        )
        self.balls = ReflectanceBalls(self._drawing, self.factors)
        self._warm: tuple[int, int, Features] | None = None

    @property
    def counters(self) -> Counters:
        """Objects made, textures and buffers written, since the start."""
        return self.objects.counters

    @property
    def only_needed(self) -> bool:
        """Whether nothing is uploaded and compiled but for the next picture; else all that an edit may ask for."""
        return self._environment.on_demand

    @only_needed.setter
    def only_needed(self, only: bool) -> None:
        self._environment.on_demand = only
        if not only:
            self._environment.write_rest()

    @property
    def bounds(self) -> Bounds:
        """The box around the mesh, metres."""
        return self.mesh.bounds

    def set_mesh(self, parts: Sequence[MeshPart]) -> None:
        """Replace the surface."""
        self.mesh.load(parts)

    def set_ground(self, field: GroundField | None) -> None:
        """Replace the ground that a view may ask for; None: there is none."""
        self._ground.set_field(field)

    def set_environment(self, maps: EnvironmentMaps, find_lights: FindLights = no_lights) -> None:
        """Replace the light. Materials must then have the same exponents; stock ones follow by themselves.

        ``find_lights`` returns those of its lights in which single flakes glint.
        """
        self._ground.set_environment(maps.background)
        self._environment.load(maps)
        self._materials.set_exponents(maps.exponents)
        self._single_lights.set_environment(find_lights, maps.exponents)

    def set_material(self, name: str, weights: MaterialWeights) -> None:
        """Give a material its weights; from the second time on this writes one small buffer and no more."""
        self._materials.set(name, weights)
        self._single_lights.set_material(name, weights)

    def set_flakes(self, name: str, flakes: Flakes | None) -> None:
        """Give a material the flakes that sparkle in it, or none."""
        self._single_lights.set_flakes(name, flakes)

    def camera_matrices(self, view: View, size: Size) -> CameraMatrices:
        """Return the matrices that :meth:`render` uses, for picking and gestures."""
        return matrices(view.camera, self.bounds, check_size(size))

    def render(
        self,
        view: View,
        framebuffer: moderngl.Framebuffer | int,
        size: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        materials: Mapping[str, str] = AS_THEY_ARE,
        region: Region | None = None,
        display: Display | None = None,
    ) -> None:
        """Draw one frame into ``framebuffer`` (an object of this context or its number, as Qt gives it).

        Parameters
        ----------
        size
            Width and height in device pixels; the lower left part of the framebuffer of that size is written.
        samples
            Wanted samples per pixel; the GPU may offer fewer.
        materials
            By the name of a part's material, the name of the one that it is drawn with instead.
        region
            Left, lower edge, width and height in pixels: nothing outside it is drawn, nor paid for.
        display
            What is written: codes of a screen, or (``LINEAR``) radiance; left out: codes of ``screen``.

        Raises
        ------
        GraphicsError
            No environment yet, a material fitted to other exponents, or the driver failed.
        """
        size = check_size(size)
        with graphics_errors(self.context, "drawing a frame"):
            if isinstance(framebuffer, int):
                framebuffer = self.context.detect_framebuffer(framebuffer)
            light = self._draw_light(
                view, self._light, size, samples, size, materials=materials, region=region
            )
            self._bind(framebuffer, size, region)
            self._finish.draw(light, view, display or self.screen)
            self.context.scissor = None

    def finish(
        self,
        view: View,
        light: moderngl.Texture,
        framebuffer: moderngl.Framebuffer,
        size: Size,
        *,
        region: Region | None = None,
        display: Display | None = None,
    ) -> None:
        """Finish ``light``, exposed radiance of any number of samples, as :meth:`render` finishes its own."""
        with graphics_errors(self.context, "finishing a picture"):
            self._bind(framebuffer, check_size(size), region)
            self._finish.draw(light, view, display or self.screen)
            self.context.scissor = None

    def draw_backdrop(
        self,
        view: View,
        target: LightTarget,
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
        camera = matrices(view.camera, self.bounds, size)
        framebuffer, light = target.prepare(size, 0)
        framebuffer.use()
        self.context.viewport = (0, 0, *size)
        self.context.scissor = region
        self.context.enable_only(moderngl.DEPTH_TEST)
        self.context.depth_func = "<="
        self._environment.bind()
        framebuffer.clear(depth=1.0)
        self._draw_background(view, camera, size, (0, 0))
        if grounded:
            self._draw_ground(view, camera, crop(size, (0, 0), size))
        return light

    def count_in(self, light: moderngl.Texture, view: View, size: Size, display: Display) -> Unshowable:
        """Count the pixels of ``light``, exposed radiance of a picture of ``size``, that a screen cannot show."""
        self._bind(self._picture.prepare(size), size)
        return self._finish.count(light, view, display)

    def release(self) -> None:
        """Give every OpenGL object back; the renderer cannot be used after."""
        self.objects.release_all()

    def _draw_light(
        self,
        view: View,
        target: LightTarget,
        tile: Size,
        samples: int,
        size: Size,
        corner: Corner = (0, 0),
        *,
        materials: Mapping[str, str] = AS_THEY_ARE,
        region: Region | None = None,
        dtype: str = "f2",
        transparent: bool = False,
    ) -> moderngl.Texture:
        """Draw a tile of a picture of ``size`` into ``target`` and return its exposed radiance."""
        if not self._environment.exponents:
            raise GraphicsError("No environment has been chosen yet; choose one before drawing.")
        samples = min(samples, self.context.max_samples)
        # Graphics cards have powers of two of them.
        samples = 1 << (samples.bit_length() - 1) if samples > 1 else 0
        camera = matrices(view.camera, self.bounds, size)
        self.balls.draw(view, camera, (materials.get(n, n) for n in (PAINT, SECOND_PAINT)))
        framebuffer, light = target.prepare(tile, samples, dtype)
        framebuffer.use()
        self.context.viewport = (0, 0, *tile)
        self.context.scissor = region
        self.context.enable_only(moderngl.DEPTH_TEST)
        self.context.depth_func = "<="
        self._environment.bind()
        features = surface_features(view, knows_light=self.mesh.knows_light, smooth=samples > 1)
        features |= self._single_lights.features(view)
        if self._environment.is_dark or view.light_colour.brightness == 0.0:
            features |= {"DARK"}
        self._warm_up(samples, features)
        framebuffer.clear(depth=1.0)
        self._draw_mesh(view, features, camera, crop(size, corner, tile), materials)
        if not transparent:
            self._draw_background(view, camera, size, corner)
            self._draw_ground(view, camera, crop(size, corner, tile))
        return light

    def _draw_mesh(
        self,
        view: View,
        features: Features,
        camera: CameraMatrices,
        cropping: NDArray[np.float64],
        materials: Mapping[str, str],
    ) -> None:
        common = (
            self._environment.uniforms()
            | view_uniforms(view)
            | {
                "world_to_clip": columns(cropping @ camera.world_to_clip),
                "eye": tuple(camera.eye),
                "grounded": view.surface_look.ground,
            }
        )
        ready: set[tuple[LookUps, Features]] = set()
        lit = bool(self._single_lights.features(view))
        if lit:
            self._single_lights.bind(view)
        modes = Modes(view.fresnel, view.look_up)
        drawn = self._drawn_parts(view, features)
        self.context.front_face, self.context.cull_face = "ccw", "back"
        common |= self.relief.bind(view, self.bounds)
        for part, name, words in drawn:
            name = materials.get(name, name)
            if view.lamps:
                words |= self.balls.words(view, name) or self.factors.features(
                    name, has_uv=self.mesh.has_uv[part]
                )
            material = self._materials.find(name, modes, self._environment.ladder)
            program = self._programs.surface(material.look_ups, words)
            if (material.look_ups, words) not in ready:
                assign(program, common)
                ready.add((material.look_ups, words))
            assign(program, self._environment.use_sharp(material.sharp))
            if "COAT_RELIEF" in words:
                assign(program, self.relief.peel_uniforms(view, name))
            assign(program, self.balls.uniforms(name, words, camera))
            if lit:
                assign(program, self._single_lights.uniforms(name, view, has_uv=self.mesh.has_uv[part]))
            material.ramp.use(RAMP_UNIT)
            material.buffer.bind_to_uniform_block(MATERIAL_BINDING)
            # Multisampling software renderers shade what is hidden too: the backs of a solid are left out.
            solid = camera.outside and self.mesh.closed[part]
            self.context.enable_only(
                moderngl.DEPTH_TEST | (moderngl.CULL_FACE if solid else moderngl.NOTHING)
            )
            _blend_over(self.context, "SECOND_PAINT" in words)
            self.mesh.arrays(program)[part].render(moderngl.TRIANGLES)
        self.context.enable_only(moderngl.DEPTH_TEST)
        _blend_over(self.context, False)

    def _drawn_parts(self, view: View, features: Features) -> list[tuple[int, str, Features]]:
        """Return what is drawn in order: a part's number, its material, and the features of its program.

        Relief belongs to the paint. A second paint is drawn over the first, by its share at each place.
        """
        chosen = {item.part: item.material for item in view.surface_look.materials}
        owned = zip(self.mesh.names, self.mesh.materials, strict=True)
        names = [chosen.get(part, own) for part, own in owned]
        painted = features | self.relief.features(view)
        drawn = [(part, name, painted if name == PAINT else features) for part, name in enumerate(names)]
        if self.relief.has_second_paint(view):
            over = painted | {"SECOND_PAINT"}
            drawn += [(part, SECOND_PAINT, over) for part, name in enumerate(names) if name == PAINT]
        return drawn

    def _draw_ground(self, view: View, camera: CameraMatrices, cropping: NDArray[np.float64]) -> None:
        """Darken the background by the shadow on the ground, which is visible from above only."""
        height = self._ground.height
        if view.surface_look.ground and height is not None and camera.eye[1] > height:
            self._ground.draw(
                columns(cropping @ camera.world_to_clip),
                float(np.radians(view.rotation_deg)),
                environment_matrix(view.light_colour),
            )

    def _warm_up(self, samples: int, features: Features) -> None:
        """Draw one triangle with each program: drivers finish compiling at the first draw, not in an edit."""
        key = (samples, self.mesh.generation, features)
        if self._warm == key or self.only_needed or not self.mesh.materials:
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
        program, screen = self._programs.background()
        own = {
            "view_to_world": columns(camera.view_to_world),
            "half_tangents": camera.half_tangents,
            "frame": (*corner, 1.0 / size[0], 1.0 / size[1]),
            **backdrop(view, self._environment.ladder),
        }
        assign(program, self._environment.uniforms() | view_uniforms(view) | own)
        screen.render(moderngl.TRIANGLES, vertices=3)


def _blend_over(context: moderngl.Context, on: bool) -> None:
    """Enable or disable blending of the drawn paint by its alpha; the object's coverage stays unchanged."""
    if not on:
        context.disable(moderngl.BLEND)
        return
    context.enable(moderngl.BLEND)
    # moderngl's types know two factors; four set those of alpha apart.
    factors: Any = (moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ZERO, moderngl.ONE)
    context.blend_func = factors
