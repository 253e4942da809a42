"""The mosaic of flakes that ``flake_grain.glsl`` reads: drawn once, filtered by its mip levels."""

from __future__ import annotations

import math

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.flakes.visible import flake_coverage
from brdf_suite.documents.paint import Flakes
from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.lights.tilt_light import SIZE

GRAIN_EXPONENT = 60.0
"""Of the lobes through which a flake sees the environment."""
CELLS = 256
"""Flakes along an edge of the tile, which repeats."""
MOSAIC_TEXELS = 4 * CELLS
"""Along an edge of the tile."""
_SECOND_MOMENT = 1.5625
"""Of a flake's brightness, 2.5 u^1.5: the mean of its square over that of itself squared."""


class FlakeMosaic:
    """The tile: its channels are four tilts, its values the brightness of the flake that has them."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._texture: moderngl.Texture | None = None
        self._light: moderngl.Texture3D | None = None
        self._mean = (0.25, 0.25, 0.25, 0.25)

    def prepare(self) -> None:
        """Draw the tile where that has not been done; another framebuffer is bound afterwards."""
        if self._texture is not None:
            return
        size = MOSAIC_TEXELS
        with graphics_errors(self._objects.context, "drawing the flakes"):
            texture = self._objects.texture((size, size), "f4")
            framebuffer = self._objects.framebuffer(texture)
            program, screen = self._objects.screen("mosaic.frag.glsl", {"CELLS": str(CELLS)})
            self._objects.bind(framebuffer, (size, size))
            program["size"] = float(size)
            screen.render(moderngl.TRIANGLES, vertices=3)
            texture.build_mipmaps()
            texture.repeat_x = texture.repeat_y = True
            texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
            smallest = np.frombuffer(texture.read(level=int(math.log2(size))), np.float32)
        self._objects.release(framebuffer)
        self._mean = (float(smallest[0]), float(smallest[1]), float(smallest[2]), float(smallest[3]))
        self._texture = texture

    def light(self, moments: NDArray[np.float32]) -> None:
        """Write what :func:`~brdf_suite.realtime.lights.tilt_light.tilt_light` found in an environment."""
        count, size, _, _ = moments.shape
        if self._light is None:
            self._light = self._objects.texture_3d((size, size, count), channels=2, dtype="f4")
        with graphics_errors(self._objects.context, "writing the light that flakes mirror"):
            self._light.write(moments.tobytes())
        self._objects.counters.texture_uploads += 1

    def use(self, unit: int, light_unit: int) -> None:
        """Bind the tile, and the light that flakes mirror."""
        if self._texture is not None:
            self._texture.use(unit)
        if self._light is not None:
            self._light.use(light_unit)

    def uniforms(self, flakes: Flakes, ladder: Ladder) -> dict[str, object]:
        """Return those of flake_grain.glsl for a paint's flakes, in the light of a stack of maps."""
        exponent = min(GRAIN_EXPONENT, ladder.exponents[-1])
        cells_per_mm = 2.0 / (math.sqrt(math.pi) * 1e-3 * flakes.size_um)
        return {
            "mosaic_mean": self._mean,
            "tilt_square": (0.5 * (SIZE - 1) / SIZE, 0.5),
            "grain": (
                cells_per_mm / CELLS,
                thinned_contrast(flake_coverage(flakes)),
                float(ladder.level(exponent)),
                exponent,
            ),
        }


def thinned_contrast(coverage: float) -> float:
    """Return the contrast of flakes that cover a share of the surface, over that of full coverage.

    A channel holds the flakes of one tilt of four; where only a share c of all is there, each is 1/c as bright, and the
    variance is (E/c - 1/4) / (E - 1/4) times as large, E the second moment of their brightness.

    >>> thinned_contrast(1.0)
    1.0
    """
    return math.sqrt((_SECOND_MOMENT / max(coverage, 1e-6) - 0.25) / (_SECOND_MOMENT - 0.25))
