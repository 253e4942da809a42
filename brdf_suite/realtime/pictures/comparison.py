"""Two paints, or a paint and a picture, in one frame: side by side, split, alternating, or as difference.

Side by side each has half the width and is framed for itself. A line parts one picture, and each side of it is drawn
for itself, so that it costs no more than one picture. The difference is CIEDE2000 of each pixel's mean colour, of
the exposed light (a white of radiance 1 has L* = 100) or of the picture as shown.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, RELATIVE_TO_WORKING
from brdf_suite.appearance.colour.spaces import SRGB_SPACE
from brdf_suite.appearance.difference.colour_scale import STEPS, scale_table
from brdf_suite.documents.view import View
from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import ScreenProgram, Size, Target
from brdf_suite.realtime.gl.programs import assign
from brdf_suite.realtime.pictures.display import LINEAR, SRGB, Display
from brdf_suite.realtime.pictures.light_pass import DEFAULT_SAMPLES, Region, check_size
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.pictures.traced_light import TracedLight

_WORKING_TO_RELATIVE = np.asarray(np.linalg.inv(RELATIVE_TO_WORKING.T), np.float64)


@dataclass(frozen=True, eq=False)
class ComparedPicture:
    """A picture in place of the second paint.

    ``pixels`` is (h, w, 3), top row first: float, radiance in the working space, where it ``is_light``; otherwise
    uint8, encoded sRGB after a tone curve of its own.
    """

    pixels: NDArray[Any]
    is_light: bool


class ComparisonRenderer:
    """Renderer of :class:`~brdf_suite.documents.view_settings.Compare` settings, in the renderer's context.

    Parameters
    ----------
    materials
        The names of the second paint's materials by those of the first.
    """

    def __init__(self, renderer: Renderer, materials: Mapping[str, str]) -> None:
        self._renderer = renderer
        self._context = renderer.context
        self._objects = renderer.objects
        self._materials = dict(materials)
        self._first, self._second = Target(self._objects), Target(self._objects)
        self._light, self._side, self._numbers = (Target(self._objects) for _ in range(3))
        self._picture: ComparedPicture | None = None
        self._picture_texture: moderngl.Texture | None = None
        self.traced: TracedLight | None = None
        """What is shown as the first where its size is the first's: a traced picture instead of a drawn one."""

    def set_picture(self, picture: ComparedPicture | None) -> None:
        """Set a picture for the comparison instead of a second paint; None restores the paint."""
        if picture is self._picture:
            return
        self._objects.release(self._picture_texture)
        self._picture, self._picture_texture = picture, None
        if picture is None:
            return
        rows = picture.pixels[::-1]
        rgba = np.ones((*rows.shape[:2], 4), np.float32 if picture.is_light else np.uint8)
        rgba[..., :3] = rows
        height, width = rows.shape[:2]
        limit = int(self._context.info["GL_MAX_TEXTURE_SIZE"])
        if max(width, height) > limit:
            raise GraphicsError(
                f"The picture has {width}x{height} pixels; this graphics card takes {limit} along an edge."
            )
        texture = self._objects.texture((width, height), "f4" if picture.is_light else "f1")
        with graphics_errors(self._context, "uploading the picture"):
            texture.write(rgba.tobytes())
        self._objects.counters.texture_uploads += 1
        self._picture_texture = texture

    def draw(
        self,
        view: View,
        target: moderngl.Framebuffer,
        size: Size,
        *,
        show_second: bool = False,
        samples: int = DEFAULT_SAMPLES,
    ) -> None:
        """Draw one frame; ``show_second`` says which of the two a blink shows now. Errors as of the renderer."""
        size, mode = check_size(size), view.compare.mode
        width, height = size
        if mode == "off" or (mode == "blink" and not show_second):
            self._draw_first(view, target, size, samples)
        elif mode == "blink":
            self._draw_second(view, target, size, samples, (0, 0, width, height))
        elif mode == "swipe":
            split = divider_px(view.compare.divider, width)
            if split > 0:
                self._draw_first(view, target, size, samples, region=(0, 0, split, height))
            if split < width:
                self._draw_second(view, target, size, samples, (split, 0, width - split, height))
        elif mode == "side":
            self._draw_side_by_side(view, target, size, samples)
        else:
            self._bring_both(view, size, samples)
            self._compare(view, target, size, numbers=False)

    def differences(self, view: View, size: Size, samples: int = DEFAULT_SAMPLES) -> NDArray[np.float32]:
        """Return ΔE00 (h, w) of each pixel, top row first: the numbers behind the picture of differences."""
        size = check_size(size)
        self._bring_both(view, size, samples)
        target, _ = self._numbers.prepare(size, "f4")
        self._compare(view, target, size, numbers=True)
        values = np.frombuffer(target.read(components=1, dtype="f4"), np.float32)
        return values.reshape(size[1], size[0])[::-1].copy()

    def _draw_first(
        self,
        view: View,
        target: moderngl.Framebuffer,
        size: Size,
        samples: int,
        *,
        region: Region | None = None,
        display: Display | None = None,
    ) -> None:
        if self.traced is not None and self.traced.size == size:
            self.traced.render(view, target, size, region=region, display=display)
        else:
            self._renderer.render(view, target, size, samples, region=region, display=display)

    def _draw_second(
        self,
        view: View,
        target: moderngl.Framebuffer,
        size: Size,
        samples: int,
        region: Region,
        display: Display | None = None,
    ) -> None:
        if self._picture is None:
            self._renderer.render(
                view, target, size, samples, materials=self._materials, region=region, display=display
            )
        elif self._picture.is_light:
            framebuffer, light = self._light.prepare(size, "f2")
            self._draw_picture(framebuffer, size, 2.0**view.exposure_ev, (0, 0, *size))
            self._renderer.finish(view, light, target, size, region=region, display=display)
        elif (display or self._renderer.screen).space is SRGB_SPACE:
            self._draw_picture(target, size, 1.0, region)
        else:
            # Its colours, and not its codes, are what another screen is to show: through no curve, without marks.
            framebuffer, light = self._light.prepare(size, "f2")
            self._draw_picture(framebuffer, size, 1.0, (0, 0, *size), decoded=True)
            plain = replace(
                view,
                exposure_ev=0.0,
                tone_curve="linear",
                glare="off",
                clipping_marks=False,
                gamut_marks=False,
            )
            self._renderer.finish(plain, light, target, size, region=region, display=display)

    def _draw_side_by_side(self, view: View, target: moderngl.Framebuffer, size: Size, samples: int) -> None:
        left, right = sides(size)
        self._draw_first(view, target, (left[2], left[3]), samples)
        half = (right[2], right[3])
        made, texture = self._side.prepare(half)
        self._draw_second(view, made, half, samples, (0, 0, *half))
        program, screen = self._program("picture.frag.glsl")
        target.use()
        self._context.viewport = right
        self._context.enable_only(moderngl.NOTHING)
        assign(program, _placed(half, (right[0], right[1]), 1.0))
        texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
        texture.use(0)
        screen.render(moderngl.TRIANGLES, vertices=3)

    def compares_light(self, view: View) -> bool:
        """Whether the difference is of light; a picture that has a tone curve of its own can be compared only so."""
        return view.compare.basis == "light" and (self._picture is None or self._picture.is_light)

    def _bring_both(self, view: View, size: Size, samples: int) -> None:
        """Draw both pictures to textures, without a scale: as light, or as shown."""
        light = self.compares_light(view)
        kind = "f2" if light else "f1"
        first, second = self._first.prepare(size, kind)[0], self._second.prepare(size, kind)[0]
        if not light:
            # In sRGB, which the difference decodes, whatever the monitor is; marks and glare are no part of colours.
            view = replace(view, glare="off", clipping_marks=False, gamut_marks=False)
            self._draw_first(view, first, size, samples, display=SRGB)
            self._draw_second(view, second, size, samples, (0, 0, *size), SRGB)
            return
        self._draw_first(view, first, size, samples, display=LINEAR)
        if self._picture is None:
            self._renderer.render(view, second, size, samples, materials=self._materials, display=LINEAR)
        else:
            self._draw_picture(second, size, 1.0, (0, 0, *size))

    def _compare(self, view: View, target: moderngl.Framebuffer, size: Size, *, numbers: bool) -> None:
        light = self.compares_light(view)
        to_relative = _WORKING_TO_RELATIVE if light else _WORKING_TO_RELATIVE @ REC709_TO_WORKING
        program, screen = self._program("difference.frag.glsl", numbers=numbers)
        self._objects.bind(target, size)
        assign(
            program,
            {
                "first": 0,
                "second": 1,
                "encoded": not light,
                "to_relative": tuple(to_relative.T.ravel().tolist()),
                "gain": 2.0**view.exposure_ev if light else 1.0,
                "scale_end": view.compare.scale_delta_e,
                "scale_colours": [tuple(colour) for colour in scale_table().tolist()],
            },
        )
        kind = "f2" if light else "f1"
        for unit, compared in enumerate((self._first, self._second)):
            compared.prepare(size, kind)[1].use(unit)
        screen.render(moderngl.TRIANGLES, vertices=3)

    def _draw_picture(
        self,
        target: moderngl.Framebuffer,
        size: Size,
        gain: float,
        region: Region,
        *,
        decoded: bool = False,
    ) -> None:
        texture = self._picture_texture
        if texture is None:
            raise AssertionError("a picture is drawn only where there is one")
        same = texture.width == size[0]
        filtering = moderngl.NEAREST if same else moderngl.LINEAR
        texture.filter = (filtering, filtering)
        texture.repeat_x = texture.repeat_y = False
        program, screen = self._program("picture.frag.glsl", decoded=decoded)
        self._objects.bind(target, size, region)
        to_working = {"to_working": tuple(REC709_TO_WORKING.T.ravel().tolist())}
        assign(program, _placed(size, (0, 0), gain) | to_working)
        texture.use(0)
        screen.render(moderngl.TRIANGLES, vertices=3)
        self._context.scissor = None

    def _program(self, fragment: str, *, numbers: bool = False, decoded: bool = False) -> ScreenProgram:
        asked = {"AS_NUMBERS": numbers, "AS_LIGHT": decoded}
        words = {"SCALE_STEPS": str(STEPS)} | {word: "1" for word, wanted in asked.items() if wanted}
        return self._objects.screen(fragment, words)


def divider_px(share: float, width: int) -> int:
    """Return how many columns of a picture of ``width`` show the first paint.

    >>> divider_px(0.5, 801), divider_px(0.0, 801), divider_px(1.0, 801)
    (400, 0, 801)
    """
    return min(width, max(0, round(share * width)))


def sides(size: Size) -> tuple[Region, Region]:
    """Return the two halves of a picture, left and right; an odd column is the right one's.

    >>> sides((801, 600))
    ((0, 0, 400, 600), (400, 0, 401, 600))
    """
    width, height = size
    left = max(1, width // 2)
    return (0, 0, left, height), (left, 0, max(1, width - left), height)


def _placed(size: Size, corner: tuple[int, int], gain: float) -> dict[str, object]:
    return {
        "picture": 0,
        "frame_size": (float(size[0]), float(size[1])),
        "frame_corner": (float(corner[0]), float(corner[1])),
        "beyond": (0.0, 0.0, 0.0, 1.0),
        "gain": gain,
    }
