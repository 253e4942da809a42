"""Textures of one environment: the stack of broad lobes, a cube map per sharp lobe, diffuse, background.

The stack is a 3-D texture: each slice is the map of one exponent on the octahedral square, and the texture unit mixes
linearly between slices. (OpenGL 3.3 has no arrays of cube maps, and the levels of one cube map force a factor of four
between exponents.) The last slice is the map of diffuse light through a coat.

A map that serves several purposes (the background is the map of the lobes too sharp to be filtered) is uploaded
once. A new environment of the same sizes is written into the textures that are there. Maps of sharp lobes can wait
until a material asks for them, and their textures with them: those are most of the bytes, and few paints look all of
them up.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import moderngl
import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.realtime.environment.ladder import BROADEST_SHARP, Ladder
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects, Target
from brdf_suite.realtime.material.ramp import MAX_SHARP
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps

_SMALLEST, _LARGEST = 33, 255  # OpenGL 3.3 grants 256 texels along the edge of a 3-D texture


class LobeStack:
    """The lobe stack texture and its uniforms."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._texture: moderngl.Texture3D | None = None
        self._target = Target(objects)
        self._staging: dict[int, moderngl.TextureCube] = {}
        self._scale = 1.0
        self.ladder = Ladder((1.0,))

    def load(self, exponents: Sequence[float], maps: Sequence[CubeFaces]) -> None:
        """Make the slices from the cube maps of ``exponents``, rising, and the one of diffuse light through a coat."""
        size = min(_LARGEST, max(_SMALLEST, round(2.3 * max(faces.size for faces in maps)) | 1))
        shape = (size, size, len(maps))
        if self._texture is None or self._texture.size != shape:
            self.release()
            self._texture = self._objects.texture_3d(shape)
        if {faces.size for faces in maps} != set(self._staging):
            self._release_staging()
        self._scale = max(faces.scale for faces in maps)
        # Slices are drawn into a plain image and copied: a slice cannot be drawn into through moderngl.
        framebuffer, texture = self._target.prepare((size, size), "f2")
        program, screen = self._objects.screen("stack.frag.glsl")
        slices = []
        with graphics_errors(self._objects.context, "loading the broad lobes' maps"):
            self._objects.bind(framebuffer, (size, size))
            for faces in maps:
                self._stage(faces).use(0)
                program["cube"], program["gain"] = 0, faces.scale / self._scale
                program["last_texel"] = float(size - 1)
                screen.render(moderngl.TRIANGLES, vertices=3)
                slices.append(texture.read())
            self._texture.write(b"".join(slices))
        self._objects.counters.texture_uploads += len(slices)
        self.ladder = Ladder(tuple(exponents))

    def use(self, unit: int) -> None:
        """Bind the texture."""
        if self._texture is not None:
            self._texture.use(unit)

    def uniforms(self, unit: int) -> dict[str, object]:
        """Return the values of lobe_stack.glsl's uniforms."""
        size = self._texture.size[0] if self._texture is not None else 1
        return {
            "lobe_stack": unit,
            "stack_scale": self._scale,
            "stack_square": (0.5 * (size - 1) / size, 0.5),
            "stack_octave": self.ladder.octave,
        }

    def release(self) -> None:
        """Give texture and framebuffer back."""
        self._target.release()
        self._objects.release(self._texture)
        self._release_staging()
        self._texture = None

    def _stage(self, faces: CubeFaces) -> moderngl.TextureCube:
        if faces.size not in self._staging:
            self._staging[faces.size] = self._objects.cube(faces.size)
        cube = self._staging[faces.size]
        for face in range(6):
            cube.write(face, np.ascontiguousarray(faces.faces[face]))
        cube.filter = (moderngl.LINEAR, moderngl.LINEAR)
        return cube

    def _release_staging(self) -> None:
        for cube in self._staging.values():
            self._objects.release(cube)
        self._staging = {}


_SEAMLESS = 0x884F  # GL_TEXTURE_CUBE_MAP_SEAMLESS, core since OpenGL 3.2

MIPMAPPED_FROM = 256
"""Faces this large get mip levels: a tightly curved surface squeezes a sharp lobe's map into few pixels."""

DIFFUSE_UNIT, BACKGROUND_UNIT, STACK_UNIT, RAMP_UNIT, FIRST_SHARP_UNIT = range(5)
"""The texture units of all that shading reads; sharp lobes take 4 to 11 of the 16 that OpenGL 3.3 grants."""

_DIFFUSE_EXPONENT = 1.0


@dataclass(frozen=True)
class _Map:
    place: int
    size: int
    scale: float

    @property
    def level(self) -> float:
        # A face of F texels is 2 wide at distance 1: F / 2 texels per radian in its middle.
        return math.log2(self.size / 2)


class EnvironmentTextures:
    """The textures of one environment, and the uniforms that describe them to the shader.

    Attributes
    ----------
    on_demand
        Whether a sharp lobe's map gets its texture only when a material first looks it up, for a picture that is drawn
        once, or for the first one; else :meth:`load` writes all, so that no edit waits for one.
    """

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self.on_demand = False
        self._sizes: list[int] = []
        self._textures: dict[int, moderngl.TextureCube] = {}
        self._unwritten: dict[int, CubeFaces] = {}
        self._stack = LobeStack(objects)
        self._diffuse: _Map | None = None
        self._background: _Map | None = None
        self._sharp: dict[float, _Map] = {}
        self.exponents: tuple[float, ...] = ()
        self.mean_radiance: Floats = np.zeros(3)
        """(3,), working space, about: texels count alike."""
        self.is_dark = False
        """Whether no light comes from the environment, so that nothing of it need be looked up."""

    @property
    def ladder(self) -> Ladder:
        """The exponents of the stack's slices."""
        return self._stack.ladder

    def load(self, maps: EnvironmentMaps) -> None:
        """Write all maps; :class:`GraphicsError` where the GPU's memory or size limit is exceeded."""
        by_exponent = dict(zip(maps.exponents, maps.lobes, strict=True))
        sharp = {e: faces for e, faces in by_exponent.items() if e > BROADEST_SHARP}
        broad = {e: faces for e, faces in by_exponent.items() if e <= BROADEST_SHARP}
        broad.setdefault(_DIFFUSE_EXPONENT, maps.diffuse)
        whole = (maps.diffuse, maps.background, *sharp.values())
        # The same numbers under another scale are the same texture: scales are uniforms.
        distinct = {id(faces.faces): faces for faces in whole}
        sizes = [faces.size for faces in distinct.values()]
        if sizes != self._sizes:
            self._release_cubes()
            self._sizes = sizes
        self._unwritten = dict(enumerate(distinct.values()))
        shared = {id(maps.diffuse.faces), id(maps.background.faces)}
        for place, identity in enumerate(distinct):
            if identity in shared or not self.on_demand:
                self._written(place)
        rising = sorted(broad)
        self._stack.load(rising, [*(broad[exponent] for exponent in rising), maps.through_coat])
        places = {identity: place for place, identity in enumerate(distinct)}
        diffuse, background, *others = (_Map(places[id(f.faces)], f.size, f.scale) for f in whole)
        self._diffuse, self._background = diffuse, background
        self._sharp = dict(zip(sharp, others, strict=True))
        self.exponents = maps.exponents
        self.mean_radiance = maps.diffuse.faces.mean(axis=(0, 1, 2), dtype=np.float64) * maps.diffuse.scale
        # Light from anywhere is in the diffuse map everywhere.
        self.is_dark = not maps.diffuse.faces.any()

    def write_rest(self) -> None:
        """Write the maps that no material has looked up yet."""
        for place in range(len(self._sizes)):
            self._written(place)

    def bind(self) -> None:
        """Bind what all materials share and switch filtering across the edges of faces on."""
        self._objects.context.enable_direct(_SEAMLESS)
        if self._diffuse is not None and self._background is not None:
            background = self._textures[self._background.place]
            self._textures[self._diffuse.place].use(DIFFUSE_UNIT)
            background.use(BACKGROUND_UNIT)
            self._stack.use(STACK_UNIT)
            # Whatever a material does not look up must be bound to something of its kind all the same.
            for unit in range(MAX_SHARP):
                background.use(FIRST_SHARP_UNIT + unit)

    def uniforms(self) -> dict[str, object]:
        """Return what all materials share, by the names of environment.glsl, lobe_stack.glsl and lobes.glsl."""
        if self._diffuse is None or self._background is None:
            return {}
        return {
            "diffuse_map": DIFFUSE_UNIT,
            "background_map": BACKGROUND_UNIT,
            "diffuse_scale": self._diffuse.scale,
            "background_scale": self._background.scale,
            "ramp": RAMP_UNIT,
            "sharp_maps": tuple(range(FIRST_SHARP_UNIT, FIRST_SHARP_UNIT + MAX_SHARP)),
        } | self._stack.uniforms(STACK_UNIT)

    def use_sharp(self, exponents: tuple[float, ...]) -> dict[str, object]:
        """Bind the maps of a material's sharp lobes; return ``sharp_lobes`` of lobes.glsl: scale, level, exponent."""
        lobes = []
        for unit, exponent in enumerate(exponents):
            own = self._sharp[exponent]
            self._written(own.place).use(FIRST_SHARP_UNIT + unit)
            lobes.append((own.scale, own.level, exponent))
        lobes += [(0.0, 0.0, 1.0)] * (MAX_SHARP - len(lobes))
        return {"sharp_lobes": tuple(lobes)}

    def release(self) -> None:
        """Give the textures back."""
        self._release_cubes()
        self._stack.release()

    def _release_cubes(self) -> None:
        for texture in self._textures.values():
            self._objects.release(texture)
        self._sizes, self._textures, self._unwritten = [], {}, {}

    def _written(self, place: int) -> moderngl.TextureCube:
        """Return the texture of a map, made and written where that has not been done."""
        if place not in self._textures:
            self._textures[place] = self._objects.cube(self._sizes[place])
        texture, faces = self._textures[place], self._unwritten.pop(place, None)
        if faces is None:
            return texture
        with graphics_errors(self._objects.context, "loading the environment's maps"):
            for face in range(6):
                texture.write(face, np.ascontiguousarray(faces.faces[face]))
            self._objects.counters.texture_uploads += 6
            if faces.size >= MIPMAPPED_FROM:
                texture.build_mipmaps()
                texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
            else:
                texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        return texture
