"""The shader programs, compiled at first use and kept: one per number of lobes or samples."""

from __future__ import annotations

import moderngl

from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.gpu_objects import GpuObjects
from brdf_suite.realtime.shader_source import compose, lobe_defines

MATERIAL_BINDING = 0

ScreenProgram = tuple[moderngl.Program, moderngl.VertexArray]


class Programs:
    """Programs of one context."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._mesh: dict[int, moderngl.Program] = {}
        self._screen: dict[tuple[str, int], ScreenProgram] = {}

    def mesh(self, lobes: int) -> moderngl.Program:
        """Return the program that shades surfaces with so many lobes."""
        if lobes not in self._mesh:
            program = self._objects.program(
                compose("mesh.vert.glsl"), compose("mesh.frag.glsl", lobe_defines(lobes))
            )
            block = program["Material"]
            if not isinstance(block, moderngl.UniformBlock):
                raise GraphicsError("The shader material.glsl has lost its block Material.")
            block.binding = MATERIAL_BINDING
            self._mesh[lobes] = program
        return self._mesh[lobes]

    def background(self) -> ScreenProgram:
        """Return the program of the background and the vertex array to draw it with."""
        return self._full_screen("background.frag.glsl", 0)

    def finish(self, samples: int) -> ScreenProgram:
        """Return the program that averages ``samples`` and encodes, and its vertex array."""
        return self._full_screen("finish.frag.glsl", samples)

    def _full_screen(self, fragment: str, samples: int) -> ScreenProgram:
        key = (fragment, samples)
        if key not in self._screen:
            program = self._objects.program(
                compose("screen.vert.glsl"), compose(fragment, {"SAMPLES": str(samples)})
            )
            self._screen[key] = (program, self._objects.vertex_array(program))
        return self._screen[key]
