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

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.realtime.camera import Bounds, CameraMatrices, matrices
from brdf_suite.realtime.environment.textures import EnvironmentTextures
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.mesh_buffers import MeshBuffers
from brdf_suite.realtime.gl.objects import Counters, GpuObjects, Size, Target
from brdf_suite.realtime.gl.programs import (
    Programs,
    surface_features,
)
from brdf_suite.realtime.lights.shadows import Shadows
from brdf_suite.realtime.lights.single_lights import FindLights, SingleLights, no_lights
from brdf_suite.realtime.material.material_set import MaterialSet
from brdf_suite.realtime.pictures.captured import LARGEST_EDGE, CapturedForm, DrawContext, capture
from brdf_suite.realtime.pictures.display import LINEAR, SRGB, Display, Unshowable
from brdf_suite.realtime.pictures.exposures import Accumulator, Exposure
from brdf_suite.realtime.pictures.finish import FinishPass
from brdf_suite.realtime.pictures.glare import GlarePass, Veil, glares
from brdf_suite.realtime.pictures.light_pass import (
    AS_THEY_ARE,
    DEFAULT_SAMPLES,
    PAINT,
    Corner,
    LightPass,
    Region,
    check_size,
)
from brdf_suite.realtime.pictures.strips import LARGEST_TILE, draw_strips, tile_limit
from brdf_suite.realtime.relief.values import PeelTile
from brdf_suite.realtime.values import EnvironmentMaps, GroundField, MaterialWeights, MeshPart

_GLARING_EDGE = 1280
"""Pixels along the longer edge of the picture whose glare a larger one shows."""


class Renderer:
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
        self.objects = objects = GpuObjects(context)
        self.mesh = MeshBuffers(objects)
        self._environment, self._materials = EnvironmentTextures(objects), MaterialSet(objects)
        self._single_lights, self._finish = SingleLights(objects), FinishPass(objects)
        self._glare, self._accumulator = GlarePass(objects), Accumulator(objects)
        programs = Programs(objects, surface_shader)
        self._drawing = DrawContext(
            objects,
            programs,
            self._environment,
            self.mesh,
            self._materials,
            self._single_lights,
            Shadows(objects, programs, self.mesh),
            self._finish,
        )
        self._first_pass = LightPass(self._drawing, make_peel)
        self.relief, self.factors = self._first_pass.relief, self._first_pass.factors
        self.balls = self._first_pass.balls
        self.draw_backdrop = self._first_pass.draw_backdrop
        self._light, self._tile = Target(objects, has_depth=True), Target(objects, has_depth=True)
        self._picture = Target(objects)
        self.screen: Display = SRGB

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
        self._first_pass.ground.set_field(field)

    def set_environment(self, maps: EnvironmentMaps, find_lights: FindLights = no_lights) -> None:
        """Replace the light. Materials must then have the same exponents; stock ones follow by themselves.

        ``find_lights`` returns its small bright lights, in which single flakes glint and of which one casts a shadow.
        """
        self._first_pass.ground.set_environment(maps.background)
        self._environment.load(maps)
        self._materials.set_exponents(maps.exponents)
        self._single_lights.set_environment(find_lights, maps, self._environment.ladder)
        self._drawing.shadows.set_environment(find_lights, self._environment.mean_radiance)

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
            light = self._first_pass.draw(
                view, self._light, size, samples, size, materials=materials, region=region
            )
            self._show(light, view, framebuffer, size, region, display or self.screen)

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
            self._show(light, view, framebuffer, check_size(size), region, display or self.screen)

    def _show(
        self,
        light: moderngl.Texture,
        view: View,
        framebuffer: moderngl.Framebuffer | int,
        size: Size,
        region: Region | None,
        display: Display,
    ) -> None:
        veil = self._glare.spread(light, view, region) if glares(view, display) else None
        self.objects.bind(framebuffer, size, region)
        self._finish.draw(light, view, display, veil=veil)
        self.context.scissor = None

    def count_unshowable(self, view: View, size: Size, display: Display = SRGB) -> Unshowable:
        """Count the object's pixels that a screen cannot show, in a picture of ``size``, one sample a pixel.

        A size beyond the GPU's limits is counted in a picture that is as much smaller.
        """
        width, height = check_size(size)
        scale = min(1.0, tile_limit(self.context, LARGEST_TILE) / max(width, height))
        size = (max(1, int(width * scale)), max(1, int(height * scale)))
        with graphics_errors(self.context, "counting pixels"):
            light = self._first_pass.draw(view, self._tile, size, 1, size)
            self.objects.bind(self._picture.prepare(size)[0], size)
            return self._finish.count(light, view, display)

    def render_image(
        self,
        view: View,
        size: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        display: Display = SRGB,
        transparent: bool = False,
        largest_tile: int = LARGEST_TILE,
    ) -> NDArray[Any]:
        """Return a picture of any size, top row first, as :meth:`strips` gives it: (h, w, 3) uint8 sRGB by default."""
        strips = self.strips(
            view, size, samples, display=display, transparent=transparent, largest_tile=largest_tile
        )
        return np.concatenate(list(strips))

    def linear_image(self, view: View, size: Size, samples: int = DEFAULT_SAMPLES) -> NDArray[Any]:
        """Return radiance of the working space and the object's share of each pixel, (h, w, 4) float32."""
        return self.render_image(view, size, samples, display=LINEAR)

    def capture(self, view: View, size: Size, samples: int = DEFAULT_SAMPLES) -> CapturedForm:
        """Return the mesh as this view shows it, to be shaded with many paints at little cost each.

        Its pictures are those of :meth:`render_image` at the same size. It is sound until mesh or light change, and
        the caller releases it.

        Raises
        ------
        ValueRangeError
            The picture is larger than 512 pixels, or the view has what belongs to one paint's picture: lamps, a
            normal map, orange peel, a second paint, glare.
        """
        size = check_size(size)
        if max(size) > LARGEST_EDGE:
            raise ValueRangeError("size", f"at most {LARGEST_EDGE} pixels along an edge are captured")
        if view.lamps or view.relief.normal_map is not None or view.relief.orange_peel > 0.0:
            raise ValueRangeError(
                "view", "lamps and relief are not captured; draw such a view paint by paint"
            )
        two_tone = view.two_tone.mask is not None or view.surface_look.wears_second
        if two_tone and view.two_tone.paint is not None:
            raise ValueRangeError("view", "two paints on one form are not captured")
        if view.glare != "off":
            raise ValueRangeError("view", "glare is not captured; it depends on the whole picture")
        with graphics_errors(self.context, "capturing a form"):
            light = self._first_pass.draw(view, self._tile, size, min(samples, 4), size, without_paint=True)
            features = surface_features(
                view, knows_light=self._drawing.mesh.knows_light, smooth=light.samples > 1
            )
            drawn, _ = self._first_pass.divided(view, self._first_pass.drawn_parts(view, features))
            parts = [(part, name == PAINT) for part, name, _ in drawn]
            return capture(self._drawing, view, size, features, parts, light)

    def linear_tile(
        self,
        view: View,
        size: Size,
        corner: Corner,
        tile: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        materials: Mapping[str, str] = AS_THEY_ARE,
    ) -> NDArray[np.float32]:
        """Return a small part of :meth:`linear_image`, with the very samples that :meth:`render` takes there.

        ``corner`` is the part's lower left pixel, counted from the lower left, even for equal derivatives.
        """
        with graphics_errors(self.context, "reading a pixel"):
            light = self._first_pass.draw(view, self._tile, tile, samples, size, corner, materials=materials)
            framebuffer, _ = self._picture.prepare(tile, "f4")
            self.objects.bind(framebuffer, tile)
            self._finish.draw(light, view, LINEAR, corner)
            read = np.frombuffer(framebuffer.read(components=4, dtype="f4"), np.float32)
        return read.reshape(tile[1], tile[0], 4)[::-1].copy()

    def strips(
        self,
        view: View,
        size: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        display: Display = SRGB,
        transparent: bool = False,
        largest_tile: int = LARGEST_TILE,
        exposures: Sequence[Exposure] = (),
    ) -> Iterator[NDArray[Any]]:
        """Draw a picture of any size in tiles and yield it in strips, from the top: memory is that of one strip.

        The scene must not change in between. A strip is (rows, w, channels): uint8 where ``display`` is dithered,
        otherwise uint16; three channels, or four with ``transparent``, which leaves the background out and gives
        the object's share of the pixel as alpha, not multiplied in. ``LINEAR`` gives float32 and always four: with
        ``transparent`` the radiance of the object alone, multiplied by its share. With ``exposures`` the picture is
        that of their mean light; what else ``view`` says of a picture stays.
        """
        size = check_size(size)
        shots = tuple(exposures) or (Exposure(view),)
        dtype = "f4" if display.linear else "f2"
        limit = tile_limit(self.context, largest_tile)
        glaring = glares(view, display) and not transparent
        in_one = max(size) <= min(limit, _GLARING_EDGE)
        veil = self._veil(view, shots, size, samples) if glaring and not in_one else None

        def draw(framebuffer: moderngl.Framebuffer, tile: Size, corner: Corner) -> None:
            with graphics_errors(self.context, "drawing a picture"):
                light = self._light_of(shots, tile, samples, size, corner, dtype, transparent=transparent)
                laid = self._glare.spread(light, view) if glaring and in_one else veil
                self.objects.bind(framebuffer, tile)
                self._finish.draw(light, view, display, corner, transparent=transparent, veil=laid)

        channels = 4 if transparent or display.linear else 3
        return draw_strips(draw, self._picture, size, limit, display, channels)

    def _light_of(
        self,
        shots: Sequence[Exposure],
        tile: Size,
        samples: int,
        size: Size,
        corner: Corner = (0, 0),
        dtype: str = "f2",
        *,
        transparent: bool = False,
    ) -> moderngl.Texture:
        """Return the exposed radiance of a tile: of one exposure as it is drawn, of several their mean."""

        def draw(shot: Exposure) -> moderngl.Texture:
            return self._first_pass.draw(
                shot.view,
                self._tile,
                tile,
                samples,
                size,
                corner,
                dtype=dtype,
                transparent=transparent,
                lens=shot.lens,
            )

        return draw(shots[0]) if len(shots) == 1 else self._accumulator.mean(shots, tile, draw)

    def _veil(self, view: View, shots: Sequence[Exposure], size: Size, samples: int) -> Veil | None:
        """Return the veil of a picture of any size, from the whole of it in one tile."""
        scale = min(1.0, tile_limit(self.context, _GLARING_EDGE) / max(size))
        small = (max(1, round(size[0] * scale)), max(1, round(size[1] * scale)))
        with graphics_errors(self.context, "drawing a picture"):
            light = self._light_of(shots, small, samples, small)
            return self._glare.spread(light, view, whole=size)

    def count_in(self, light: moderngl.Texture, view: View, size: Size, display: Display) -> Unshowable:
        """Count the pixels of ``light``, exposed radiance of a picture of ``size``, that a screen cannot show."""
        self.objects.bind(self._picture.prepare(size)[0], size)
        return self._finish.count(light, view, display)

    def release(self) -> None:
        """Give every OpenGL object back; the renderer cannot be used after."""
        self.objects.release_all()
