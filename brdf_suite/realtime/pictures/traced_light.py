"""Display of a path-traced picture with the same background and finish as a drawn one.

The traced picture is the object's light alone. What is seen past it is drawn as in every frame, with the ground's
shadow there, be it the traced one or, where the tracer has none, that of every frame; exposure, tone curve, marks and
the screen's colours are those of the finishing pass. A traced pixel is one mean value, so a highlight's edge is taken
through the curve once a pixel, where a drawn frame does it for each sample.
"""

from __future__ import annotations

from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.errors import GraphicsError, ValueRangeError
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import Size, Target
from brdf_suite.realtime.gl.programs import assign
from brdf_suite.realtime.pictures.display import LINEAR, SRGB, Display, Unshowable
from brdf_suite.realtime.pictures.light_pass import Region
from brdf_suite.realtime.pictures.renderer import Renderer

_TRACED_UNIT = 0


class TracedLight:
    """Shows one traced picture in the context of a renderer; the context must be current in every call."""

    def __init__(self, renderer: Renderer) -> None:
        self._renderer = renderer
        self._context = renderer.context
        self._objects = renderer.objects
        self._light, self._read = Target(self._objects, has_depth=True), Target(self._objects)
        self._texture: moderngl.Texture | None = None
        self._left: moderngl.Texture | None = None

    @property
    def size(self) -> Size | None:
        """Width and height of the picture; None while there is none."""
        return None if self._texture is None else (self._texture.width, self._texture.height)

    def set_picture(self, pixels: NDArray[np.float32] | None) -> None:
        """Show this picture from the next frame on, or none.

        ``pixels`` is (h, w, 4), top row first: radiance of the working space before exposure, multiplied by the
        object's share of the pixel, and that share. (h, w, 7) has after them the darkness of the ground, which the
        tracer has found itself: the share of the background's light that is missing beside the object. A picture of
        the same size is written over the old one.

        Raises
        ------
        GraphicsError
            The graphics card does not take one of this size.
        ValueRangeError
            The array has another shape.
        """
        if pixels is None:
            self._drop()
            return
        if pixels.ndim != 3 or pixels.shape[2] not in (4, 7):
            raise ValueRangeError("pixels", f"shape {pixels.shape}, not (h, w, 4) or (h, w, 7)")
        height, width = pixels.shape[:2]
        if self.size != (width, height):
            self._drop()
            limit = int(self._context.info["GL_MAX_TEXTURE_SIZE"])
            if max(width, height) > limit:
                raise GraphicsError(
                    f"The picture has {width}x{height} pixels; this graphics card takes {limit} along an edge."
                )
            self._texture = self._objects.texture((width, height), "f4")
        assert self._texture is not None
        with graphics_errors(self._context, "uploading the traced picture"):
            self._texture.write(np.ascontiguousarray(pixels[::-1, :, :4], np.float32).tobytes())
        self._objects.counters.texture_uploads += 1
        self._set_left(pixels)

    def _set_left(self, pixels: NDArray[np.float32]) -> None:
        """Upload the transmitted fraction of the background light, where the picture has it per channel."""
        if pixels.shape[2] == 4:
            self._objects.release(self._left)
            self._left = None
            return
        if self._left is None:
            self._left = self._objects.texture((pixels.shape[1], pixels.shape[0]), "f2")
        left = np.ones((*pixels.shape[:2], 4), np.float16)
        left[..., :3] = np.clip(1.0 - pixels[..., 3:4] - pixels[..., 4:], 0.0, 1.0)
        with graphics_errors(self._context, "uploading the shadow on the ground"):
            self._left.write(left[::-1].tobytes())
        self._objects.counters.texture_uploads += 1

    def render(
        self,
        view: View,
        framebuffer: moderngl.Framebuffer,
        size: Size,
        *,
        region: Region | None = None,
        display: Display | None = None,
    ) -> None:
        """Draw one frame of the picture's very size; arguments and errors as of :meth:`Renderer.render`."""
        self._renderer.finish(
            view, self._composed(view, size, region), framebuffer, size, region=region, display=display
        )

    def pixel(self, view: View, size: Size, pixel: tuple[int, int]) -> NDArray[np.float32]:
        """Return (4,) of the pixel (column, row from the top): radiance before exposure, and the object's share."""
        column = min(max(pixel[0], 0), size[0] - 1)
        row = size[1] - 1 - min(max(pixel[1], 0), size[1] - 1)
        region = (column, row, 1, 1)
        framebuffer, _ = self._read.prepare(size, "f4")
        self.render(view, framebuffer, size, region=region, display=LINEAR)
        found: Any = framebuffer.read(viewport=region, components=4, dtype="f4")
        return np.frombuffer(found, np.float32).copy()

    def count_unshowable(self, view: View, size: Size, display: Display = SRGB) -> Unshowable:
        """Count the object's pixels that a screen cannot show, in the whole picture."""
        with graphics_errors(self._context, "counting pixels"):
            return self._renderer.count_in(self._composed(view, size, None), view, size, display)

    def _composed(self, view: View, size: Size, region: Region | None) -> moderngl.Texture:
        """Return the exposed light of the whole picture: the background, and the traced object over it."""
        if self._texture is None or self.size != size:
            raise AssertionError("a traced picture is drawn in its own size")
        with graphics_errors(self._context, "drawing the traced picture"):
            light = self._renderer.draw_backdrop(view, self._light, size, region, grounded=self._left is None)
            program, screen = self._objects.screen("traced.frag.glsl")
            self._context.enable_only(moderngl.BLEND)
            if self._left is None:
                # The colours are weighted already; coverage adds up as the colours do.
                self._context.blend_func = (moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA)
            else:
                self._context.blend_func = (moderngl.ZERO, moderngl.SRC_COLOR)
                assign(program, {"traced": _TRACED_UNIT, "exposure": 1.0})
                self._left.use(_TRACED_UNIT)
                screen.render(moderngl.TRIANGLES, vertices=3)
                self._context.blend_func = (moderngl.ONE, moderngl.ONE)
            assign(program, {"traced": _TRACED_UNIT, "exposure": 2.0**view.exposure_ev})
            self._texture.use(_TRACED_UNIT)
            screen.render(moderngl.TRIANGLES, vertices=3)
            self._context.blend_func = (moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA)
            self._context.disable(moderngl.BLEND)
            self._context.scissor = None
        return light

    def _drop(self) -> None:
        self._objects.release(self._texture)
        self._objects.release(self._left)
        self._texture = self._left = None
