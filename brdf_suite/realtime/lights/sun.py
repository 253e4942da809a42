"""Shadow of the environment's sun: its strongest small light, and the mesh as it is seen from there.

Prefiltered maps hold the sun's light as if nothing were in its way; baked occlusion darkens all light alike. Where an
environment has a sun, its share is taken out of both and put in by what a place sees of it (``sun.glsl``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import moderngl
import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import TRANSMITTANCE
from brdf_suite.geometry.directions import about_y
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.mesh_buffers import MeshBuffers
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import SUN_UNIT, Features, Programs, assign
from brdf_suite.realtime.lights.block import DistantLights
from brdf_suite.realtime.lights.single_lights import FindLights, no_lights

MAP_SIZE = 2048
BROADEST = 0.06
"""Radians, standard deviation: broader lights cast shadows that baked occlusion shows as well."""
FAINTEST = 0.15
"""Of the irradiance of the environment's mean light: a fainter sun casts no shadow that is seen."""


@dataclass(frozen=True, eq=False)
class Sun:
    """A light of an environment before any turn: unit direction (3,), irradiance (3,) facing it, spread in radians."""

    direction: Floats
    irradiance: Floats
    spread: float


def find_sun(lights: DistantLights, mean_radiance: Floats) -> Sun | None:
    """Return the strongest light that is small and stands out of the mean radiance (3,); None where there is none."""
    luminous = lights.strengths @ LUMINANCE
    small = np.flatnonzero(lights.spreads <= BROADEST)
    if not len(small):
        return None
    strongest = int(small[np.argmax(luminous[small])])
    if luminous[strongest] < FAINTEST * math.pi * float(mean_radiance @ LUMINANCE):
        return None
    spread = float(lights.spreads[strongest])
    return Sun(lights.directions[strongest], lights.strengths[strongest], spread)


class SunShadow:
    """The environment's sun, and the map of what it sees of a mesh, drawn again where one of them has changed."""

    def __init__(self, objects: GpuObjects, programs: Programs, mesh: MeshBuffers) -> None:
        self._objects, self._programs, self._mesh = objects, programs, mesh
        self._map: tuple[moderngl.Framebuffer, moderngl.Texture] | None = None
        self._drawn: tuple[int, bytes] | None = None
        self._find: FindLights = no_lights
        self._mean: Floats = np.zeros(3)
        self._found: tuple[Sun | None] | None = None

    def set_environment(self, find: FindLights, mean_radiance: Floats) -> None:
        """Take another environment: what finds its lights, and its mean radiance (3,)."""
        self._find, self._mean, self._found = find, mean_radiance, None

    @property
    def sun(self) -> Sun | None:
        """The environment's sun, looked for at the first call; None where it has none."""
        if self._found is None:
            self._found = (find_sun(self._find(), self._mean),)
        return self._found[0]

    def features(self, features: Features) -> Features:
        """Return the word of lit.glsl for frames whose programs have ``features``, where the sun casts a shadow."""
        lit = "OCCLUSION" in features and "DARK" not in features
        return frozenset({"SUN"}) if lit and self.sun is not None else frozenset()

    def uniforms(self, view: View, features: Features) -> dict[str, object]:
        """Return the inputs of sun.glsl for the sun turned as in ``view``, its map bound.

        Nothing where the ``features`` of the frame's programs have no sun. Bind the framebuffer of the picture
        afterwards.
        """
        sun = self.sun if "SUN" in features else None
        if sun is None:
            return {}
        direction = sun.direction @ about_y(math.radians(view.rotation_deg)).T
        aside = np.array([1.0, 0.0, 0.0]) if abs(direction[0]) < 0.7 else np.array([0.0, 0.0, 1.0])
        right = np.cross(aside, direction)
        right /= np.linalg.norm(right)
        up = np.cross(direction, right)
        low, high = (np.array(corner) for corner in (self._mesh.bounds.minimum, self._mesh.bounds.maximum))
        half = 0.505 * max(float(np.linalg.norm(high - low)), 1e-6)
        values: dict[str, object] = {
            "sun_map": SUN_UNIT,
            "sun_direction": triple(direction),
            "sun_irradiance": triple(sun.irradiance @ environment_matrix(view.light_colour).T),
            "sun_spread": sun.spread,
            "sun_box": (*triple(0.5 * (low + high)), half),
            "sun_right": triple(right),
            "sun_up": triple(up),
        }
        wanted = (self._mesh.generation, direction.tobytes())
        if self._map is None:
            texture = self._objects.depth_texture((MAP_SIZE, MAP_SIZE))
            self._map = self._objects.framebuffer(depth=texture), texture
        framebuffer, texture = self._map
        if wanted != self._drawn:
            with graphics_errors(self._objects.context, "drawing the shadow of the sun"):
                self._draw(framebuffer, values)
            self._drawn = wanted
        texture.use(SUN_UNIT)
        return values

    def _draw(self, framebuffer: moderngl.Framebuffer, values: dict[str, object]) -> None:
        program = self._programs.sun_map()
        self._objects.bind(framebuffer, (MAP_SIZE, MAP_SIZE), depth=True)
        framebuffer.clear(depth=1.0)
        assign(program, values)
        for array, material in zip(self._mesh.arrays(program), self._mesh.materials, strict=True):
            if material not in TRANSMITTANCE:
                array.render(moderngl.TRIANGLES)
