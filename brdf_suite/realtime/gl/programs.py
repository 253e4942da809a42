"""Cache of shader programs: one per feature set or sample count, compiled at first use."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.documents.view import View
from brdf_suite.realtime.environment.look_up_table import RAMP_NODES
from brdf_suite.realtime.gl.objects import GpuObjects, ScreenProgram
from brdf_suite.realtime.gl.shader_source import SHADERS, compose, look_up_defines
from brdf_suite.realtime.lights.block import COLUMNS
from brdf_suite.realtime.lights.mosaic import MOSAIC_TEXELS
from brdf_suite.realtime.lights.tilt_light import EXPONENTS
from brdf_suite.realtime.material.ramp import MAX_BROAD, MAX_ROWS, MAX_SHARP

MATERIAL_BINDING = 0
LIGHTS_BINDING = 3
_BLOCKS = {"Material": MATERIAL_BINDING, "Lights": LIGHTS_BINDING}
LIGHT_LOBES_UNIT = 15
SHADOW_UNIT, PANE_UNIT = 30, 35
MOSAIC_UNIT, TILT_LIGHT_UNIT = 33, 34
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

        Fitted paints have weights on three to five broad lobes and one sharp one, weights by the view on up to eight
        and four, glass on one sharp alone. A loop costs a software renderer half as much again as the look-ups written
        out, but serves any material.

        >>> LookUps.enough_for(3, 1), LookUps.enough_for(9, 3)
        (LookUps(broad=4, sharp=1), LookUps(broad=0, sharp=4))
        """
        return LookUps(
            next((count for count in _WRITTEN_OUT if count >= broad), 0),
            next(count for count in (1, 2, 4, MAX_SHARP) if count >= sharp),
        )


_WRITTEN_OUT = (1, 4, 6, 8)

PAINTS = (LookUps(4, 1), LookUps(6, 1), LookUps(4, 2), LookUps(6, 2))
"""What most paints need: made ready before the first frame, so that an edit which adds a lobe does not wait."""


class Programs:
    """Shader programs of one context; ``surface_shader`` replaces mesh.frag.glsl."""

    def __init__(self, objects: GpuObjects, surface_shader: Path | None = None) -> None:
        self._objects = objects
        self._surface_shader = surface_shader or SHADERS / "mesh.frag.glsl"
        self._surfaces: dict[tuple[LookUps, Features], moderngl.Program] = {}
        self._without_mesh: dict[tuple[LookUps, Features], ScreenProgram] = {}

    def surface(self, look_ups: LookUps, features: Features = frozenset()) -> moderngl.Program:
        """Return the program that shades surfaces with so many look-ups and these features."""
        key = (look_ups, features)
        if key not in self._surfaces:
            self._surfaces[key] = self._shading(look_ups, features)
        return self._surfaces[key]

    def _shading(self, look_ups: LookUps, features: Features) -> moderngl.Program:
        words = _defines(features)
        vertex = compose("screen.vert.glsl" if features & {CAPTURED, BALL} else "mesh.vert.glsl", words)
        limits = {
            "MAX_BROAD": str(MAX_BROAD),
            "MAX_SHARP": str(MAX_SHARP),
            "RAMP_ROWS": str(MAX_ROWS),
            "RAMP_NODES": str(RAMP_NODES),
            "LIGHT_LOBE_COLUMNS": str(COLUMNS),
            "BALL_SHARE": str(BALL_SHARE),
            "TILT_SLICES": str(len(EXPONENTS)),
            "MOSAIC_TEXELS": str(MOSAIC_TEXELS),
        }
        fragment = compose(
            self._surface_shader.name,
            look_up_defines(look_ups.broad, look_ups.sharp) | limits | words,
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
            "shadow_map": SHADOW_UNIT,
            "pane_map": PANE_UNIT,
            "flake_mosaic": MOSAIC_UNIT,
            "tilt_light": TILT_LIGHT_UNIT,
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

    def shadow_map(self, *, panes: bool = False) -> moderngl.Program:
        """Return the program that draws how far a light sees, or what ``panes`` leave of it."""
        name = "pane_map" if panes else "shadow_map"
        key = (LookUps(0, 0), frozenset({name}))
        if key not in self._surfaces:
            vertex, fragment = compose(f"{name}.vert.glsl"), compose(f"{name}.frag.glsl")
            self._surfaces[key] = self._objects.program(vertex, fragment)
        return self._surfaces[key]

    def gap_line(self) -> moderngl.Program:
        """Return the program that draws the gaps of a mesh as lines."""
        key = (LookUps(0, 0), frozenset({"GAP_LINE"}))
        if key not in self._surfaces:
            vertex, fragment = compose("gap.vert.glsl"), compose("gap.frag.glsl")
            self._surfaces[key] = self._objects.program(vertex, fragment)
        return self._surfaces[key]

    def without_mesh(self, look_ups: LookUps, features: Features) -> ScreenProgram:
        """Return the program that shades a list of places or a ball: its features hold ``CAPTURED`` or ``BALL``."""
        key = (look_ups, features)
        if key not in self._without_mesh:
            program = self.surface(look_ups, features)
            self._without_mesh[key] = (program, self._objects.vertex_array(program))
        return self._without_mesh[key]


def _defines(features: Features) -> dict[str, str]:
    parted = (word.partition("=") for word in sorted(features))
    return {name: text or "1" for name, _, text in parted}


def view_uniforms(view: View) -> dict[str, object]:
    """Return turn and colour of the light, and the exposure as a factor."""
    turn = np.radians(view.rotation_deg)
    return {
        "light_turn": (float(np.cos(turn)), float(np.sin(turn))),
        "light_colour": columns(environment_matrix(view.light_colour)),
        "exposure": 2.0**view.exposure_ev,
    }


def surface_features(view: View, *, knows_light: bool = False, smooth: bool = False) -> Features:
    """Return the words that the shader files test with ``#ifdef``, for one frame.

    ``knows_light`` says whether the mesh holds the light that arrives at it, ``smooth`` whether edges are to be.

    A word costs a program of its own, compiled at its first frame, so each represents what a user switches on
    or off, never for a number that is dragged.

    >>> sorted(surface_features(View(fresnel="off")))
    []
    """
    asked = {
        "SMOOTH_REFLECTIONS": smooth,
        "LOOK_UP_PAPER": view.look_up == "paper",
        "FRESNEL_RAISED": view.fresnel != "off",
        "OCCLUSION": knows_light and view.surface_look.occlusion,
    }
    return frozenset(word for word, wanted in asked.items() if wanted)


def columns(matrix: NDArray[np.float64]) -> tuple[float, ...]:
    """Return a matrix column by column, as OpenGL wants it."""
    return tuple(matrix.T.ravel().tolist())
