"""Off-screen pictures of any size, as codes or radiance, in tiles, with out-of-range counts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.programs import Features
from brdf_suite.realtime.gl.target import LightTarget, PictureTarget
from brdf_suite.realtime.gl.view_uniforms import surface_features
from brdf_suite.realtime.pictures.captured import LARGEST_EDGE, CapturedForm, DrawContext, capture
from brdf_suite.realtime.pictures.display import LINEAR, SRGB, Display, Unshowable
from brdf_suite.realtime.pictures.finish import FinishPass
from brdf_suite.realtime.pictures.strips import LARGEST_TILE, draw_strips, tile_limit

DEFAULT_SAMPLES = 4

PAINT, SECOND_PAINT = "paint", "paint_two"
"""The material that relief and masks belong to, and the one that is blended over it."""

Size = tuple[int, int]
Corner = tuple[int, int]
Region = tuple[int, int, int, int]

AS_THEY_ARE: Mapping[str, str] = MappingProxyType({})
"""No part is drawn with another material."""


class OffscreenPictures:
    """Off-screen drawing of the renderer, with its first pass and targets."""

    context: moderngl.Context
    _tile: LightTarget
    _picture: PictureTarget
    _finish: FinishPass
    _draw_light: Callable[..., moderngl.Texture]

    _drawing: DrawContext
    _drawn_parts: Callable[..., list[tuple[int, str, Features]]]

    def _bind(self, target: moderngl.Framebuffer, size: Size, region: Region | None = None) -> None:
        """Make ``target`` the one that the second pass writes into."""
        target.use()
        self.context.viewport = (0, 0, *size)
        self.context.scissor = region
        self.context.enable_only(moderngl.NOTHING)

    def count_unshowable(self, view: View, size: Size, display: Display = SRGB) -> Unshowable:
        """Count the object's pixels that a screen cannot show, in a picture of ``size``, one sample a pixel.

        A size beyond the GPU's limits is counted in a picture that is as much smaller.
        """
        width, height = check_size(size)
        scale = min(1.0, tile_limit(self.context, LARGEST_TILE) / max(width, height))
        size = (max(1, int(width * scale)), max(1, int(height * scale)))
        with graphics_errors(self.context, "counting pixels"):
            light = self._draw_light(view, self._tile, size, 1, size)
            self._bind(self._picture.prepare(size), size)
            return self._finish.count(light, view, display)

    def render_image(
        self,
        view: View,
        size: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        display: Display = SRGB,
        transparent: bool = False,
        largest_tile: int = LARGEST_TILE,
    ) -> NDArray[Any]:
        """Return a picture of any size, top row first, as :meth:`strips` gives it: (h, w, 3) uint8 sRGB by default."""
        strips = self.strips(
            view, size, samples, display=display, transparent=transparent, largest_tile=largest_tile
        )
        return np.concatenate(list(strips))

    def linear_image(self, view: View, size: Size, samples: int = DEFAULT_SAMPLES) -> NDArray[Any]:
        """Return radiance of the working space and the object's share of each pixel, (h, w, 4) float32."""
        return self.render_image(view, size, samples, display=LINEAR)

    def capture(self, view: View, size: Size, samples: int = DEFAULT_SAMPLES) -> CapturedForm:
        """Return the mesh as this view shows it, to be shaded with many paints at little cost each.

        Its pictures are those of :meth:`render_image` at the same size. It is sound until mesh or light change, and
        the caller releases it.

        Raises
        ------
        ValueRangeError
            The picture is larger than 512 pixels, or the view has what belongs to one paint's picture: lamps, a
            normal map, orange peel, a second paint.
        """
        size = check_size(size)
        if max(size) > LARGEST_EDGE:
            raise ValueRangeError("size", f"at most {LARGEST_EDGE} pixels along an edge are captured")
        if view.lamps or view.relief.normal_map is not None or view.relief.orange_peel > 0.0:
            raise ValueRangeError(
                "view", "lamps and relief are not captured; draw such a view paint by paint"
            )
        if view.two_tone.mask is not None and view.two_tone.paint is not None:
            raise ValueRangeError("view", "two paints on one form are not captured")
        with graphics_errors(self.context, "capturing a form"):
            light = self._draw_light(view, self._tile, size, min(samples, 4), size)
            features = surface_features(
                view, knows_light=self._drawing.mesh.knows_light, smooth=light.samples > 1
            )
            drawn = self._drawn_parts(view, features)
            parts = [(part, name == PAINT) for part, name, _ in drawn]
            return capture(self._drawing, view, size, features, parts, light)

    def linear_tile(
        self,
        view: View,
        size: Size,
        corner: Corner,
        tile: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        materials: Mapping[str, str] = AS_THEY_ARE,
    ) -> NDArray[np.float32]:
        """Return a small part of :meth:`linear_image`, with the very samples that :meth:`render` takes there.

        ``corner`` is the part's lower left pixel, counted from the lower left, even for equal derivatives.
        """
        with graphics_errors(self.context, "reading a pixel"):
            light = self._draw_light(view, self._tile, tile, samples, size, corner, materials=materials)
            framebuffer = self._picture.prepare(tile, "f4")
            self._bind(framebuffer, tile)
            self._finish.draw(light, view, LINEAR, corner)
            read = np.frombuffer(framebuffer.read(components=4, dtype="f4"), np.float32)
        return read.reshape(tile[1], tile[0], 4)[::-1].copy()

    def strips(
        self,
        view: View,
        size: Size,
        samples: int = DEFAULT_SAMPLES,
        *,
        display: Display = SRGB,
        transparent: bool = False,
        largest_tile: int = LARGEST_TILE,
    ) -> Iterator[NDArray[Any]]:
        """Draw a picture of any size in tiles and yield it in strips, from the top: memory is that of one strip.

        The scene must not change in between. A strip is (rows, w, channels): uint8 where ``display`` is dithered,
        otherwise uint16; three channels, or four with ``transparent``, which leaves the background out and gives
        the object's share of the pixel as alpha, not multiplied in. ``LINEAR`` gives float32 and always four: with
        ``transparent`` the radiance of the object alone, multiplied by its share.
        """
        size = check_size(size)
        dtype = "f4" if display.linear else "f2"

        def draw(framebuffer: moderngl.Framebuffer, tile: Size, corner: Corner) -> None:
            with graphics_errors(self.context, "drawing a picture"):
                light = self._draw_light(
                    view, self._tile, tile, samples, size, corner, dtype=dtype, transparent=transparent
                )
                self._bind(framebuffer, tile)
                self._finish.draw(light, view, display, corner, transparent=transparent)

        channels = 4 if transparent or display.linear else 3
        limit = tile_limit(self.context, largest_tile)
        return draw_strips(draw, self._picture, size, limit, display, channels)


def check_size(size: Size) -> Size:
    """Return width and height as whole numbers of 1 to 65,536 pixels, or raise :class:`ValueRangeError`."""
    width, height = (int(n) for n in size)
    if not (1 <= width <= 65536 and 1 <= height <= 65536):
        raise ValueRangeError("size", f"1 to 65,536 pixels along each edge are drawn, not {width}x{height}")
    return width, height
