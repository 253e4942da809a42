"""The shader programs, compiled at first use and kept: one per number of look-ups or samples."""

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


def look_up_counts(lobes: int) -> tuple[int, ...]:
    """Return the numbers of look-ups that there are programs for, ascending, the last being ``lobes``.

    Fitted paints have weights on three or four lobes of ten, so most surfaces read less than half of the maps.

    >>> look_up_counts(10), look_up_counts(3)
    ((4, 7, 10), (3,))
    """
    return tuple(sorted({min(count, lobes) for count in (4, 7, lobes)}))


Features = frozenset[str]
"""What of the surface shader is compiled in, by the words that its files test with ``#ifdef``."""


class Programs:
    """Programs of one context; ``surface_shader`` takes the place of mesh.frag.glsl."""

    def __init__(self, objects: GpuObjects, surface_shader: Path | None = None) -> None:
        self._objects = objects
        self._surface_shader = surface_shader or SHADERS / "mesh.frag.glsl"
        self._surfaces: dict[tuple[int, Features], moderngl.Program] = {}
        self._screen: dict[tuple[str, int], ScreenProgram] = {}

    def surface(self, look_ups: int, features: Features = frozenset()) -> moderngl.Program:
        """Return the program that shades surfaces with so many look-ups of lobes and these features."""
        key = (look_ups, features)
        if key not in self._surfaces:
            words = dict.fromkeys(sorted(features), "1")
            fragment = compose(
                self._surface_shader.name,
                lobe_defines(look_ups) | words,
                (self._surface_shader.parent, SHADERS),
            )
            program = self._objects.program(compose("mesh.vert.glsl", words), fragment)
            block = program.get("Material", None)
            if isinstance(block, moderngl.UniformBlock):
                block.binding = MATERIAL_BINDING
            self._surfaces[key] = program
        return self._surfaces[key]

    def background(self) -> ScreenProgram:
        """Return the program of the background and the vertex array to draw it with."""
        return self._full_screen("background.frag.glsl", 0)

    def finish(self, samples: int) -> ScreenProgram:
        """Return the program that takes ``samples`` to the screen, and its vertex array."""
        return self._full_screen("finish.frag.glsl", samples)

    def count(self, samples: int) -> ScreenProgram:
        """Return the program whose fragments are counted, and its vertex array."""
        return self._full_screen("count.frag.glsl", samples)

    def _full_screen(self, fragment: str, samples: int) -> ScreenProgram:
        key = (fragment, samples)
        if key not in self._screen:
            program = self._objects.program(
                compose("screen.vert.glsl"), compose(fragment, {"SAMPLES": str(samples)})
            )
            self._screen[key] = (program, self._objects.vertex_array(program))
        return self._screen[key]
