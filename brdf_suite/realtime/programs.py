"""The shader programs, compiled at first use and kept: one per number of lobes or samples."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import moderngl

from brdf_suite.realtime.gpu_objects import GpuObjects
from brdf_suite.realtime.shader_source import SHADERS, compose, lobe_defines

MATERIAL_BINDING = 0

ScreenProgram = tuple[moderngl.Program, moderngl.VertexArray]


def assign(program: moderngl.Program, values: Mapping[str, object]) -> None:
    """Set uniforms by name; those that the compiler found unused, and dropped, are passed over."""
    for name, value in values.items():
        if name in program:
            # An array of one is a plain number to moderngl.
            program[name] = value[0] if isinstance(value, tuple) and len(value) == 1 else value


class Programs:
    """Programs of one context; ``surface_shader`` takes the place of mesh.frag.glsl."""

    def __init__(self, objects: GpuObjects, surface_shader: Path | None = None) -> None:
        self._objects = objects
        self._surface = surface_shader or SHADERS / "mesh.frag.glsl"
        self._mesh: dict[int, moderngl.Program] = {}
        self._screen: dict[tuple[str, int], ScreenProgram] = {}

    def mesh(self, lobes: int) -> moderngl.Program:
        """Return the program that shades surfaces with so many lobes."""
        if lobes not in self._mesh:
            fragment = compose(self._surface.name, lobe_defines(lobes), (self._surface.parent, SHADERS))
            program = self._objects.program(compose("mesh.vert.glsl"), fragment)
            block = program.get("Material", None)
            if isinstance(block, moderngl.UniformBlock):
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
