"""3-D texture of an environment's broad lobe maps, read at a continuous exponent.

Each slice is the map of one exponent on the octahedral square; between slices the texture unit mixes linearly. (OpenGL
3.3 has no arrays of cube maps, and the levels of one cube map force a factor of four between exponents.)
"""

from __future__ import annotations

from collections.abc import Sequence

import moderngl
import numpy as np

from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.shader_source import compose
from brdf_suite.realtime.values import CubeFaces

_SMALLEST, _LARGEST = 33, 255  # OpenGL 3.3 grants 256 texels along the edge of a 3-D texture


class LobeStack:
    """The lobe stack texture and its uniforms."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._texture: moderngl.Texture3D | None = None
        self._target: tuple[moderngl.Texture, moderngl.Framebuffer] | None = None
        self._program: tuple[moderngl.Program, moderngl.VertexArray] | None = None
        self._staging: dict[int, moderngl.TextureCube] = {}
        self._scale = 1.0
        self.ladder = Ladder((1.0,))

    def load(self, maps: Sequence[tuple[float, CubeFaces]]) -> None:
        """Make the slices from cube maps by exponent, rising."""
        size = min(_LARGEST, max(_SMALLEST, round(2.3 * max(faces.size for _, faces in maps)) | 1))
        shape = (size, size, len(maps))
        if self._texture is None or self._texture.size != shape:
            self._make(shape)
        if self._texture is None or self._target is None:
            raise AssertionError("_make() makes both")
        if {faces.size for _, faces in maps} != set(self._staging):
            self._release_staging()
        self._scale = max(faces.scale for _, faces in maps)
        texture, framebuffer = self._target
        program, screen = self._converter()
        context = self._objects.context
        slices = []
        with graphics_errors(context, "loading the broad lobes' maps"):
            framebuffer.use()
            context.viewport = (0, 0, size, size)
            context.scissor = None
            context.enable_only(moderngl.NOTHING)
            for _, faces in maps:
                self._stage(faces).use(0)
                program["cube"], program["gain"] = 0, faces.scale / self._scale
                program["last_texel"] = float(size - 1)
                screen.render(moderngl.TRIANGLES, vertices=3)
                slices.append(texture.read())
            self._texture.write(b"".join(slices))
        self._objects.counters.texture_uploads += len(slices)
        self.ladder = Ladder(tuple(exponent for exponent, _ in maps))

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
        if self._target is not None:
            texture, framebuffer = self._target
            self._objects.release(framebuffer)
            self._objects.release(texture)
        if self._texture is not None:
            self._objects.release(self._texture)
        self._release_staging()
        self._texture = self._target = None

    def _make(self, shape: tuple[int, int, int]) -> None:
        self.release()
        self._texture = self._objects.texture_3d(shape)
        # Slices are drawn into a plain image and copied: a slice cannot be drawn into through moderngl.
        image = self._objects.texture(shape[:2], "f2")
        self._target = (image, self._objects.framebuffer(image))

    def _converter(self) -> tuple[moderngl.Program, moderngl.VertexArray]:
        if self._program is None:
            program = self._objects.program(compose("screen.vert.glsl"), compose("stack.frag.glsl"))
            self._program = (program, self._objects.vertex_array(program))
        return self._program

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
