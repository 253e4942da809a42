"""Pictures as the mean of several exposures: through places of a lens, of an object that turns.

The mean is taken of light, before the tone curve and what else makes a picture for a screen of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import moderngl

from brdf_suite.documents.view import View
from brdf_suite.realtime.camera import MIDDLE, LensPoint
from brdf_suite.realtime.gl.objects import GpuObjects, Size, Target
from brdf_suite.realtime.gl.programs import assign

_LIGHT_UNIT = 0


@dataclass(frozen=True)
class Exposure:
    """A view, seen from a place of the lens."""

    view: View
    lens: LensPoint = MIDDLE


class Accumulator:
    """Adds the light of exposures up, in whole floats."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._sum = Target(objects)

    def mean(
        self, exposures: Sequence[Exposure], size: Size, draw: Callable[[Exposure], moderngl.Texture]
    ) -> moderngl.Texture:
        """Return the mean of what ``draw`` returns, exposed radiance of ``size`` and any number of samples."""
        framebuffer, texture = self._sum.prepare(size, "f4")
        framebuffer.clear()
        context = self._objects.context
        for exposure in exposures:
            light = draw(exposure)
            program, screen = self._objects.screen("accumulate.frag.glsl", {"SAMPLES": str(light.samples)})
            self._objects.bind(framebuffer, size)
            context.enable_only(moderngl.BLEND)
            context.blend_func = moderngl.ONE, moderngl.ONE
            light.use(_LIGHT_UNIT)
            assign(program, {"light": _LIGHT_UNIT, "weight": 1.0 / len(exposures)})
            screen.render(moderngl.TRIANGLES, vertices=3)
            context.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA
            context.enable_only(moderngl.NOTHING)
        return texture
