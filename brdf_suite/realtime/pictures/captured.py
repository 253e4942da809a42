"""G-buffer of a form, drawn once and shaded with many paints, for pictures of whole palettes.

A small picture of a finely meshed form costs its triangles, not its pixels: several cover each pixel, and each of them
is shaded. For one view and size they are the same for every paint. So they are drawn once (``capture.frag.glsl``):
place, normal, arriving light and the derivatives of each fragment of the paint are kept as a list, those that several
samples of a pixel share once. A paint then shades the list, a plain rectangle without a triangle more
(``mesh.frag.glsl`` with CAPTURED: the same look-ups, gains and flakes), and the finishing pass gathers each pixel's
samples from it. What is not the paint's (other parts, ground, background, panes and gaps before the paint) is kept as
it was drawn. Many paints go into
one image and are read back at once. A picture is the one that
:meth:`~brdf_suite.realtime.pictures.renderer.Renderer.render_image` gives, code for code, but for what a
driver computes otherwise in
another shader.

Not captured, since they belong to one paint's picture: lamps, a normal map, orange peel, a second paint.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.realtime.camera import matrices
from brdf_suite.realtime.environment.textures import RAMP_UNIT, EnvironmentTextures
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.mesh_buffers import MeshBuffers
from brdf_suite.realtime.gl.objects import GpuObjects, Size, Target
from brdf_suite.realtime.gl.programs import (
    CAPTURED,
    KEPT_LIGHT,
    MATERIAL_BINDING,
    PLACES_UNIT,
    Features,
    LookUps,
    Programs,
    assign,
    columns,
    view_uniforms,
)
from brdf_suite.realtime.lights.shadows import Shadows
from brdf_suite.realtime.lights.single_lights import SingleLights
from brdf_suite.realtime.material.material_set import MaterialSet, Modes
from brdf_suite.realtime.pictures.display import SRGB, Display
from brdf_suite.realtime.pictures.finish import FinishPass
from brdf_suite.realtime.pictures.kept_light import KeptLight
from brdf_suite.realtime.values import MaterialWeights

LIST_WIDTH = 256
LARGEST_EDGE = 512
"""Of a captured picture, pixels: eight numbers of four floats are kept for each of its samples."""
MOST_ROWS = 8192
_TEXELS = 8
_PLACE_TARGETS = 8
_LIGHT_UNIT, _CODES_UNIT, _SAMPLE_UNIT, _OTHER_UNIT = 0, 1, 2, 3
_MATERIAL = "swatch"


@dataclass(frozen=True, eq=False)
class CapturedPaint:
    """A paint of a batch: its weights and visible flakes."""

    weights: MaterialWeights
    flakes: Flakes | None = None


@dataclass(frozen=True, eq=False)
class DrawContext:
    """The renderer's resources needed to draw a captured form."""

    objects: GpuObjects
    programs: Programs
    environment: EnvironmentTextures
    mesh: MeshBuffers
    materials: MaterialSet
    single_lights: SingleLights
    shadows: Shadows
    finish: FinishPass


class CapturedForm:
    """The G-buffer of one view of the renderer's mesh, with the paints for shading it.

    Made by :meth:`~brdf_suite.realtime.pictures.renderer.Renderer.capture`; sound until the renderer's
    mesh, light or relief changes.
    """

    def __init__(
        self,
        drawing: DrawContext,
        view: View,
        size: Size,
        features: Features,
        common: dict[str, object],
        places: NDArray[np.float32],
        other: moderngl.Texture,
    ) -> None:
        self._drawing, self._view, self.size = drawing, view, size
        self._features, self._common = features, common
        self._other = other
        self._samples = int(places.shape[3])
        rows, index = unique_places(places)
        self.places = len(rows)
        objects = drawing.objects
        self._rows = max(1, -(-len(rows) // LIST_WIDTH))
        padded = np.zeros((_TEXELS, self._rows * LIST_WIDTH, 4), np.float32)
        padded[:, : len(rows)] = rows.transpose(1, 0, 2)
        if len(rows):
            # The rest of the last row is shaded too, and never used.
            padded[:, len(rows) :] = rows[0][:, None]
        self._list = objects.ramp((LIST_WIDTH, _TEXELS * self._rows))
        self._list.write(padded.tobytes())
        self._index = objects.ramp(size)
        self._index.write(np.ascontiguousarray(index).tobytes())
        self._kept: KeptLight | None = None
        if KeptLight.fits(objects.context, self._rows):
            self._kept = KeptLight(
                objects, drawing.programs, drawing.environment, features, common, (LIST_WIDTH, self._rows)
            )
        self._shaded, self._pictures = Target(objects), Target(objects)

    @property
    def most(self) -> int:
        """How many paints are drawn at once."""
        return max(1, min(32, MOST_ROWS // max(self._rows, self.size[1])))

    def draw(self, swatches: Iterable[CapturedPaint], display: Display = SRGB) -> NDArray[np.uint8]:
        """Return the pictures (n, h, w, 3) of paints, top row first; ``display`` must be one of 8 bits.

        Paints may come one by one: a driver with threads of its own shades one while the next is got ready. Who gets
        them ready must leave the graphics context alone.

        Raises
        ------
        GraphicsError
            A paint is fitted to lobes that the light has no maps of, or the driver failed.
        """
        if not display.dithered:
            raise ValueRangeError("display", "pictures of palettes have 8 bits")
        found = [np.empty((0, self.size[1], self.size[0], 3), np.uint8)]
        waiting = iter(swatches)
        while len(pictures := self._batch(islice(waiting, self.most), display)):
            found.append(pictures)
        return np.concatenate(found)

    def release(self) -> None:
        """Give the textures back."""
        objects = self._drawing.objects
        if self._kept is not None:
            self._kept.release()
        self._shaded.release()
        self._pictures.release()
        for texture in (self._list, self._index, self._other):
            objects.release(texture)

    def _batch(self, swatches: Iterable[CapturedPaint], display: Display) -> NDArray[np.uint8]:
        width, height = self.size
        count = 0
        context = self._drawing.objects.context
        with graphics_errors(context, "drawing pictures of paints"):
            # Half floats, as a frame's own target has them.
            target, light = self._shaded.prepare((LIST_WIDTH, self._rows * self.most), "f2")
            light.filter = (moderngl.NEAREST, moderngl.NEAREST)
            context.scissor = None
            context.enable_only(moderngl.NOTHING)
            self._drawing.environment.bind()
            self._list.use(PLACES_UNIT)
            ready: set[tuple[LookUps, Features]] = set()
            for swatch in swatches:
                self._shade(count, swatch, target, ready)
                count += 1
            if count == 0:
                return np.empty((0, height, width, 3), np.uint8)
            framebuffer, _ = self._pictures.prepare((width, height * self.most))
            framebuffer.use()
            program, screen = self._drawing.finish.program(self._view, display, self._samples, captured=True)
            light.use(_LIGHT_UNIT)
            self._index.use(_SAMPLE_UNIT)
            self._other.use(_OTHER_UNIT)
            assign(
                program,
                {"sample_places": _SAMPLE_UNIT, "other_light": _OTHER_UNIT, "list_width": LIST_WIDTH},
            )
            for number in range(count):
                corner = number * height
                context.viewport = (0, corner, width, height)
                # The dither is a function of the pixel in its own picture.
                program["frame"] = (0.0, -float(corner), 0.0, 0.0)
                program["picture_corner"] = (0, corner)
                program["list_corner"] = (0, number * self._rows)
                screen.render(moderngl.TRIANGLES, vertices=3)
            read = framebuffer.read((0, 0, width, count * height), 3, dtype="f1", alignment=1)
        return np.frombuffer(read, np.uint8).reshape(count, height, width, 3)[:, ::-1].copy()

    def _shade(
        self,
        number: int,
        swatch: CapturedPaint,
        target: moderngl.Framebuffer,
        ready: set[tuple[LookUps, Features]],
    ) -> None:
        """Shade the list with one paint into its part of ``target``."""
        drawing, view = self._drawing, self._view
        name = f"{_MATERIAL} {number}"
        drawing.materials.set(name, swatch.weights)
        drawing.single_lights.set_material(name, swatch.weights)
        drawing.single_lights.set_flakes(name, swatch.flakes)
        material = drawing.materials.find(name, Modes(view.fresnel, view.look_up), drawing.environment.ladder)
        words = self._features | drawing.single_lights.features(view, name)
        words |= drawing.shadows.features(view, words)
        cast = drawing.shadows.uniforms(view, words)
        lit = words != self._features
        kept = None
        if self._kept is not None and material.numbers is not None:
            kept = self._kept.uniforms(material.numbers)
        if kept is not None:
            words |= {KEPT_LIGHT}
        if lit:
            drawing.single_lights.prepare(view)
        target.use()
        drawing.objects.context.viewport = (0, number * self._rows, LIST_WIDTH, self._rows)
        program, screen = drawing.programs.without_mesh(material.look_ups, words | {CAPTURED})
        if (material.look_ups, words) not in ready:
            assign(program, self._common | {"place_rows": self._rows})
            ready.add((material.look_ups, words))
        assign(program, drawing.environment.use_sharp(material.sharp) if kept is None else kept)
        if lit:
            assign(program, drawing.single_lights.uniforms(name, view, has_uv=True) | cast)
        program["first_row"] = number * self._rows
        material.ramp.use(RAMP_UNIT)
        material.buffer.bind_to_uniform_block(MATERIAL_BINDING)
        screen.render(moderngl.TRIANGLES, vertices=3)


def capture(
    drawing: DrawContext,
    view: View,
    size: Size,
    features: Features,
    parts: Sequence[tuple[int, bool]],
    other: moderngl.Texture,
) -> CapturedForm:
    """Draw the places of ``parts``, each with whether it is the paint's; ``other`` is the picture without it."""
    width, height = size
    objects = drawing.objects
    samples = max(1, other.samples)
    camera = matrices(view.camera, drawing.mesh.bounds, size)
    common = (
        drawing.environment.uniforms()
        | view_uniforms(view)
        | {
            "world_to_clip": columns(camera.world_to_clip),
            "eye": tuple(camera.eye),
            "grounded": view.surface_look.ground,
        }
    )
    _, flat = read_samples(objects, other, "f2")
    several = other.samples if samples > 1 else 0
    colours = [objects.texture(size, "f4", several) for _ in range(_PLACE_TARGETS)]
    depth = objects.depth(size, several)
    with graphics_errors(objects.context, "capturing a form"):
        framebuffer = objects.framebuffer(*colours, depth=depth)
        objects.bind(framebuffer, size, depth=True)
        framebuffer.clear(depth=1.0)
        for part, painted in parts:
            sides = drawing.mesh.side_words(part) if "OCCLUSION" in features else frozenset()
            program = drawing.programs.capture(features | sides)
            assign(program, common)
            assign(program, {"kept": 1.0 if painted else 2.0, "has_uv": drawing.mesh.has_uv[part]})
            drawing.mesh.arrays(program)[part].render(moderngl.TRIANGLES)
        places = np.empty((_PLACE_TARGETS, height, width, samples, 4), np.float32)
        for target, colour in enumerate(colours):
            places[target], kept = read_samples(objects, colour)
            objects.release(kept)
    for made in (framebuffer, depth, *colours):
        objects.release(made)
    return CapturedForm(drawing, view, size, features, common, places, flat)


def unique_places(places: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the paint's places (m, 8, 4), and for each pixel and sample which it is, (h, w, 4), below 0: none.

    ``places`` (8, h, w, s, 4) are capture.frag.glsl's colours of all samples. Samples of one pixel that show the same
    fragment share a place.
    """
    height, width, samples = places.shape[1:4]
    painted = places[0, ..., 3] == 1.0
    each = np.ascontiguousarray(places.transpose(1, 2, 3, 0, 4)).reshape(height, width, samples, -1)
    first = np.arange(samples)[None, None].repeat(height, 0).repeat(width, 1)
    for later in range(1, samples):
        for earlier in range(later - 1, -1, -1):
            same = (each[:, :, later] == each[:, :, earlier]).all(axis=-1)
            first[..., later] = np.where(same, first[..., earlier], first[..., later])
    own = painted & (first == np.arange(samples))
    number = np.full(own.shape, -1, np.int64)
    number[own] = np.arange(int(own.sum()))
    index = np.full((height, width, 4), -1.0, np.float32)
    gathered = np.take_along_axis(number, first, axis=2)
    index[..., :samples] = np.where(painted, gathered, -1)
    return each[own].reshape(-1, _TEXELS, 4), index


def read_samples(
    objects: GpuObjects, source: moderngl.Texture, dtype: str = "f4"
) -> tuple[NDArray[np.float32], moderngl.Texture]:
    """Return all samples (h, w, s, 4) of an image, lowest row first, and them side by side as a texture."""
    program, screen = objects.screen("unpack.frag.glsl", {"SAMPLES": str(source.samples)})
    samples = max(1, source.samples)
    width, height = source.size
    flat = objects.texture((width * samples, height), dtype)
    flat.filter = (moderngl.NEAREST, moderngl.NEAREST)
    framebuffer = objects.framebuffer(flat)
    objects.bind(framebuffer, (width * samples, height))
    source.use(0)
    program["packed_samples"] = 0
    screen.render(moderngl.TRIANGLES, vertices=3)
    read: Any = framebuffer.read(components=4, dtype="f4")
    objects.release(framebuffer)
    return np.frombuffer(read, np.float32).reshape(height, width, samples, 4), flat
