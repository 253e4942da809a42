"""Cache of shader programs: one per feature set or sample count, compiled at first use."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import moderngl

from brdf_suite.realtime.environment.look_up_table import RAMP_NODES
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.shader_source import SHADERS, ShaderSource, compose, look_up_defines
from brdf_suite.realtime.lights.lobes import COLUMNS
from brdf_suite.realtime.material.ramp import MAX_BROAD, MAX_ROWS, MAX_SHARP

MATERIAL_BINDING = 0
LIGHTS_BINDING = 3
_BLOCKS = {"Material": MATERIAL_BINDING, "Lights": LIGHTS_BINDING}
LIGHT_LOBES_UNIT = 15
PLACES_UNIT = 12
"""Of a captured form's list; a form is captured without a normal map, whose unit it is otherwise."""
KEPT_UNIT = 13
"""Of the look-ups that are kept for such a list; its form has no orange peel either."""
RELIEF_UNITS = {"normal_slopes": 12, "peel_slopes": 13, "paint_mask": 14, "tangent_turns": 28}
FIRST_FACTOR_UNIT, FIRST_CUBE_FACTOR_UNIT = 16, 22
"""Of factored materials' maps, six flat ones and six cubes: OpenGL 3.3 has 48 units, though one shader may use 16."""
_FACTOR_UNITS: dict[str, object] = {
    "factor_maps": tuple(range(FIRST_FACTOR_UNIT, FIRST_CUBE_FACTOR_UNIT)),
    "factor_cubes": tuple(range(FIRST_CUBE_FACTOR_UNIT, FIRST_CUBE_FACTOR_UNIT + 6)),
}

ScreenProgram = tuple[moderngl.Program, moderngl.VertexArray]


def assign(program: moderngl.Program, values: Mapping[str, object]) -> None:
    """Set uniforms by name; those that the compiler removed as unused are skipped.

    Arrays are tuples with a value per element; of an array whose end is unused the rest is set.
    """
    for name, value in values.items():
        uniform = program.get(name, None)
        if not isinstance(uniform, moderngl.Uniform):
            continue
        is_array = isinstance(value, tuple) and len(value) > uniform.dimension * uniform.array_length
        if isinstance(value, tuple) and (is_array or isinstance(value[0], tuple)):
            value = value[: uniform.array_length]
        # An array of one is a plain value to moderngl.
        uniform.value = value[0] if isinstance(value, tuple) and len(value) == 1 else value


Features = frozenset[str]
"""What of the surface shader is compiled in, by the words that its files test with ``#ifdef``; ``NAME=text`` is a word
that has a text."""

CAPTURED, KEEPING, KEPT_LIGHT = "CAPTURED", "KEEPING", "KEPT_LIGHT"
"""Features of programs that shade a list of places instead of a mesh (:mod:`brdf_suite.realtime.pictures.captured`):
with look-ups of their own, with look-ups that are made to be kept, and with those that were
(:mod:`brdf_suite.realtime.pictures.kept_light`)."""


BALL = "BALL"
"""Feature of programs that draw a ball of a material instead of a mesh (:mod:`brdf_suite.realtime.factors.ball`)."""
BALL_UNIT = 29
BALL_SHARE = 0.98
"""Of the picture of a ball, its own: past its edge a look-up between pixels still finds the edge."""


@dataclass(frozen=True)
class LookUps:
    """Numbers of broad and sharp lobes of a surface program; 0 broad: the material's number, in a loop."""

    broad: int
    sharp: int

    @staticmethod
    def enough_for(broad: int, sharp: int) -> LookUps:
        """Return the smallest numbers that there is a program for.

        Fitted paints have weights on three to five broad lobes and one sharp one, glass on one sharp alone. A loop
        costs a software renderer half as much again as the look-ups written out, but serves any material.

        >>> LookUps.enough_for(3, 1), LookUps.enough_for(7, 3)
        (LookUps(broad=4, sharp=1), LookUps(broad=0, sharp=4))
        """
        return LookUps(
            next((count for count in _WRITTEN_OUT if count >= broad), 0),
            next(count for count in (1, 2, 4, MAX_SHARP) if count >= sharp),
        )


_WRITTEN_OUT = (1, 4, 6)

PAINTS = (LookUps(4, 1), LookUps(6, 1), LookUps(4, 2), LookUps(6, 2))
"""What most paints need: made ready before the first frame, so that an edit which adds a lobe does not wait."""


class Programs:
    """Shader programs of one context; ``surface_shader`` replaces mesh.frag.glsl."""

    def __init__(self, objects: GpuObjects, surface_shader: Path | None = None) -> None:
        self._objects = objects
        self._surface_shader = surface_shader or SHADERS / "mesh.frag.glsl"
        self._surfaces: dict[tuple[LookUps, Features], moderngl.Program] = {}
        self._captured: dict[tuple[LookUps, Features], ScreenProgram] = {}
        self._screen: dict[tuple[str, int, bool], ScreenProgram] = {}

    def surface(self, look_ups: LookUps, features: Features = frozenset()) -> moderngl.Program:
        """Return the program that shades surfaces with so many look-ups and these features."""
        key = (look_ups, features)
        if key not in self._surfaces:
            words = _defines(features)
            flat = features & {CAPTURED, BALL}
            vertex = compose("screen.vert.glsl" if flat else "mesh.vert.glsl", words)
            self._surfaces[key] = self._shading(vertex, look_ups, words)
        return self._surfaces[key]

    def _shading(self, vertex: ShaderSource, look_ups: LookUps, words: Mapping[str, str]) -> moderngl.Program:
        limits = {
            "MAX_BROAD": str(MAX_BROAD),
            "MAX_SHARP": str(MAX_SHARP),
            "RAMP_ROWS": str(MAX_ROWS),
            "RAMP_NODES": str(RAMP_NODES),
            "LIGHT_LOBE_COLUMNS": str(COLUMNS),
            "BALL_SHARE": str(BALL_SHARE),
        }
        fragment = compose(
            self._surface_shader.name,
            look_up_defines(look_ups.broad, look_ups.sharp) | limits | dict(words),
            (self._surface_shader.parent, SHADERS),
        )
        program = self._objects.program(vertex, fragment)
        for name, binding in _BLOCKS.items():
            block = program.get(name, None)
            if isinstance(block, moderngl.UniformBlock):
                block.binding = binding
        # At once: two kinds of samplers must never stand at one unit, not even while a program warms up.
        own = {
            "light_lobes": LIGHT_LOBES_UNIT,
            "places": PLACES_UNIT,
            "kept_light": KEPT_UNIT,
            "lamp_ball": BALL_UNIT,
        }
        assign(program, own | RELIEF_UNITS | _FACTOR_UNITS)
        return program

    def capture(self, features: Features) -> moderngl.Program:
        """Return the program that draws what shading asks of a surface's places, for those features."""
        key = (LookUps(0, 0), features)
        if key not in self._surfaces:
            words = _defines(features)
            self._surfaces[key] = self._objects.program(
                compose("mesh.vert.glsl", words), compose("capture.frag.glsl", words)
            )
        return self._surfaces[key]

    def captured(self, look_ups: LookUps, features: Features) -> ScreenProgram:
        """Return the program that shades a list of captured places, and its vertex array."""
        key = (look_ups, features)
        if key not in self._captured:
            program = self.surface(look_ups, features | {CAPTURED})
            self._captured[key] = (program, self._objects.vertex_array(program))
        return self._captured[key]

    def ball(self, look_ups: LookUps, features: Features) -> ScreenProgram:
        """Return the program that draws a ball with :data:`BALL` among its features, and its vertex array."""
        key = (look_ups, features)
        if key not in self._captured:
            program = self.surface(look_ups, features)
            self._captured[key] = (program, self._objects.vertex_array(program))
        return self._captured[key]

    def unpack(self, samples: int) -> ScreenProgram:
        """Return the program that lays the ``samples`` of each pixel side by side, and its vertex array."""
        return self._full_screen("unpack.frag.glsl", samples)

    def background(self) -> ScreenProgram:
        """Return the program of the background and the vertex array to draw it with."""
        return self._full_screen("background.frag.glsl", 0)

    def finish(self, samples: int, *, captured: bool = False) -> ScreenProgram:
        """Return the program that takes ``samples`` to the screen, and its vertex array.

        ``captured``: the samples are those of a list that was shaded apart (samples.glsl).
        """
        return self._full_screen("finish.frag.glsl", samples, captured)

    def count(self, samples: int) -> ScreenProgram:
        """Return the program whose fragments are counted, and its vertex array."""
        return self._full_screen("count.frag.glsl", samples)

    def _full_screen(self, fragment: str, samples: int, captured: bool = False) -> ScreenProgram:
        key = (fragment, samples, captured)
        if key not in self._screen:
            words = {"SAMPLES": str(samples)} | ({CAPTURED: "1"} if captured else {})
            program = self._objects.program(compose("screen.vert.glsl"), compose(fragment, words))
            self._screen[key] = (program, self._objects.vertex_array(program))
        return self._screen[key]


def _defines(features: Features) -> dict[str, str]:
    parted = (word.partition("=") for word in sorted(features))
    return {name: text or "1" for name, _, text in parted}
