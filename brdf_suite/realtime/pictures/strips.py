"""Pictures of any size drawn in GPU-sized tiles and delivered in strips."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.realtime.gl.objects import Size, Target
from brdf_suite.realtime.pictures.display import Display

DrawTile = Callable[[moderngl.Framebuffer, Size, Size], None]
"""Draws a tile: into which framebuffer, of which size, its lower left pixel in the whole picture."""

LARGEST_TILE = 2048
"""Pixels along an edge; 4 samples of colour and depth are then 200 MB, at any size of the picture."""

LARGEST_STRIP = 64 << 20
"""Bytes, about, of the rows that are drawn before they are handed out."""


def tile_limit(context: moderngl.Context, wanted: int) -> int:
    """Return the longest edge of a tile, at most ``wanted``, that the GPU draws."""
    info = context.info
    limits = [info[key] for key in ("GL_MAX_RENDERBUFFER_SIZE", "GL_MAX_TEXTURE_SIZE")]
    # Even tiles keep the 2x2 blocks, in which derivatives are taken, where they are in the whole picture.
    return max(2, int(min(wanted, *limits, *info["GL_MAX_VIEWPORT_DIMS"])) // 2 * 2)


def draw_strips(
    draw: DrawTile, target: Target, size: Size, limit: int, display: Display, channels: int
) -> Iterator[NDArray[Any]]:
    """Yield the strips (rows, w, channels) of a picture from the top, in the type that ``display`` asks for.

    uint8 where it is dithered, float32 where it is linear, otherwise uint16. ``limit`` is the longest edge of a
    tile, in pixels.
    """
    dtype = "f1" if display.dithered else "f4"
    stored = np.uint8 if display.dithered else np.float32
    row_bytes = size[0] * 4 * np.dtype(stored).itemsize
    rows = max(2, min(limit, LARGEST_STRIP // row_bytes) // 2 * 2)
    tile = (min(limit, size[0]), min(rows, size[1]))
    # Counted from the lower edge, as OpenGL does: all corners are even.
    for bottom in range((size[1] - 1) // rows * rows, -1, -rows):
        height = min(rows, size[1] - bottom)
        strip = np.empty((height, size[0], channels), stored)
        for left in range(0, size[0], limit):
            width = min(limit, size[0] - left)
            framebuffer, _ = target.prepare(tile, dtype)
            draw(framebuffer, tile, (left, bottom))
            read = framebuffer.read((0, 0, width, height), channels, dtype=dtype, alignment=1)
            pixels = np.frombuffer(read, stored).reshape(height, width, channels)
            strip[:, left : left + width] = pixels[::-1]
        if display.dithered or display.linear:
            yield strip
        else:
            yield np.rint(strip * 65535.0).astype(np.uint16)
