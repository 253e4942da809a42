"""Shader inputs for directional lights: the lights, each material's lobe table, its flakes.

Nothing is made or written before a view has lamps or flakes are drawn one by one; an edit of a paint then writes one
small table more.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import moderngl

from brdf_suite.appearance.flakes.visible import FLAKE_WAVINESS, visible_density
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import View
from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import (
    LIGHT_LOBES_UNIT,
    LIGHTS_BINDING,
    MOSAIC_UNIT,
    TILT_LIGHT_UNIT,
    Features,
)
from brdf_suite.realtime.lights.block import (
    BLOCK_SIZE,
    COLUMNS,
    NO_LIGHTS,
    ROWS,
    DistantLights,
    coat_index,
    flake_power,
    light_block,
    light_lobes,
)
from brdf_suite.realtime.lights.mosaic import FlakeMosaic
from brdf_suite.realtime.lights.tilt_light import tilt_light
from brdf_suite.realtime.material.stock_materials import stock_materials
from brdf_suite.realtime.values import EnvironmentMaps, MaterialWeights

LIT = frozenset({"LAMPS", "SUN", "SPARKLE_GLINTS", "SPARKLE_TEXTURE"})
"""Words of programs that read a material's table of lobes in single lights."""

FindLights = Callable[[], DistantLights]
"""Finds the small bright lights of an environment; called before a frame that shows flakes or occlusion."""


def no_lights() -> DistantLights:
    """Return the lights of an environment in which no flake glints."""
    return NO_LIGHTS


class SingleLights:
    """Lights of the environment and lamps, for all materials."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._find: FindLights = no_lights
        self._weights: dict[str, MaterialWeights] = {}
        self._stock: dict[str, MaterialWeights] = {}
        self._flakes: dict[str, Flakes] = {}
        self._tables: dict[str, moderngl.Texture] = {}
        self._written: dict[str, tuple[MaterialWeights, Flakes | None, float]] = {}
        self._buffer: moderngl.Buffer | None = None
        self._block = b""
        self._mosaic = FlakeMosaic(objects)
        self._ladder = Ladder((1.0,))
        self._maps: EnvironmentMaps | None = None

    def set_environment(self, find: FindLights, maps: EnvironmentMaps, ladder: Ladder) -> None:
        """Replace the environment's lights; stock materials follow its lobes, grain its broad ones."""
        self._find = find
        self._ladder = ladder
        self._maps = maps
        self._stock = stock_materials(maps.exponents)

    def set_material(self, name: str, weights: MaterialWeights) -> None:
        """Give a material its weights."""
        self._weights[name] = weights

    def set_flakes(self, name: str, flakes: Flakes | None) -> None:
        """Give a material its flakes, or none."""
        if flakes is None:
            self._flakes.pop(name, None)
        else:
            self._flakes[name] = flakes

    def prepare(self, view: View) -> None:
        """Draw what a frame with flakes reads, and bind its lights; another framebuffer may be bound afterwards."""
        if view.lamps or self._sparkles(view):
            self._bind(view)
        if self._sparkles(view) and view.sparkle.mode == "glints":
            self._mosaic.prepare()
            if self._maps is not None:
                self._mosaic.light(tilt_light(self._maps, self._find()))
                self._maps = None

    def features(self, view: View, material: str) -> Features:
        """Return the words of lit.glsl for a material: lamps, and how its flakes are drawn where it has some.

        A software renderer would carry out what flakes need for a material without any too.
        """
        words: set[str] = set()
        if view.lamps:
            words.add("LAMPS")
        if view.sparkle.mode != "off" and material in self._flakes:
            words.add("SPARKLE_GLINTS" if view.sparkle.mode == "glints" else "SPARKLE_TEXTURE")
        return frozenset(words)

    def _bind(self, view: View) -> None:
        """Bind the lights of this frame, written where they changed."""
        block = light_block(view, self._find() if self._sparkles(view) else NO_LIGHTS)
        if self._buffer is None:
            self._buffer = self._objects.buffer(reserve=BLOCK_SIZE, dynamic=True)
        if block != self._block:
            with graphics_errors(self._objects.context, "writing the lights"):
                self._buffer.write(block)
            self._objects.counters.buffer_writes += 1
            self._block = block
        self._buffer.bind_to_uniform_block(LIGHTS_BINDING)

    def _sparkles(self, view: View) -> bool:
        return view.sparkle.mode != "off" and bool(self._flakes)

    def uniforms(self, material: str, view: View, *, has_uv: bool) -> dict[str, object]:
        """Bind a material's table, and return its flakes by the names of lit.glsl."""
        weights = self._weights.get(material) or self._stock.get(material) or self._stock["neutral"]
        flakes = self._flakes.get(material) if view.sparkle.mode != "off" else None
        self._write(material, weights, flakes, view.sparkle.strength)
        self._tables[material].use(LIGHT_LOBES_UNIT)
        ior = coat_index(weights)
        population = (0.0, 1.0, 1.0, 0.0)
        own: dict[str, object] = {}
        if flakes is not None:
            size = flakes.size_um * 1e-3
            population = (visible_density(flakes), size, flakes.roughness, flakes.colour_spread)
            own = self._mosaic.uniforms(flakes, self._ladder)
            self._mosaic.use(MOSAIC_UNIT, TILT_LIGHT_UNIT)
        return own | {
            "light_lobes": LIGHT_LOBES_UNIT,
            "flakes": population,
            "flake_optics": (
                ior,
                FLAKE_WAVINESS,
                ior**2 - math.sin(weights.theta_fit_rad) ** 2,
                0.0 if flakes is None else flake_power(weights, flakes, view.sparkle.strength),
            ),
            "has_uv": has_uv,
        }

    def _write(self, name: str, weights: MaterialWeights, flakes: Flakes | None, strength: float) -> None:
        made = self._written.get(name)
        if made is not None and made[0] is weights and made[1:] == (flakes, strength):
            return
        if name not in self._tables:
            self._tables[name] = self._objects.ramp((COLUMNS, ROWS))
        with graphics_errors(self._objects.context, f"writing the lobes of {name}"):
            self._tables[name].write(light_lobes(weights, flakes, strength).tobytes())
        self._objects.counters.texture_uploads += 1
        self._written[name] = (weights, flakes, strength)
