"""Finishing pass of a frame: from samples of exposed radiance to output codes."""

from __future__ import annotations

from typing import Any

import moderngl
import numpy as np

from brdf_suite.appearance.colour.spaces import DisplaySpace
from brdf_suite.appearance.glare import WHITE
from brdf_suite.documents.view import View
from brdf_suite.realtime.gl.objects import GpuObjects, ScreenProgram
from brdf_suite.realtime.gl.programs import CAPTURED, assign
from brdf_suite.realtime.pictures.display import Display, Unshowable
from brdf_suite.realtime.pictures.glare import Veil
from brdf_suite.realtime.pictures.tone_curves import TONE_CURVE_NUMBERS

_LIGHT_UNIT, _CODES_UNIT, _GLARE_UNIT = 0, 1, 2
_COUNTED = ("pixels", "too_bright", "too_colourful")


class FinishPass:
    """Pass of finish.frag.glsl; keeps the screen's code table while the screen stays the same."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._codes: moderngl.Texture | None = None
        self._codes_of: object = None
        self._query: Any = None

    def draw(
        self,
        light: moderngl.Texture,
        view: View,
        display: Display,
        corner: tuple[int, int] = (0, 0),
        *,
        transparent: bool = False,
        veil: Veil | None = None,
    ) -> None:
        """Finish into the bound framebuffer; ``corner`` is its lower left pixel in the whole picture."""
        program, screen = self.program(
            view, display, light.samples, transparent=transparent, glares=veil is not None
        )
        assign(program, {"frame": (*corner, 0.0, 0.0)})
        if veil is not None:
            of_veil = {"glare": _GLARE_UNIT, "glare_size": veil.size, "glare_share": veil.share}
            assign(program, of_veil | {"glare_white": WHITE})
            veil.texture.use(_GLARE_UNIT)
        light.use(_LIGHT_UNIT)
        screen.render(moderngl.TRIANGLES, vertices=3)

    def program(
        self,
        view: View,
        display: Display,
        samples: int,
        *,
        captured: bool = False,
        transparent: bool = False,
        glares: bool = False,
    ) -> ScreenProgram:
        """Return the program that takes ``samples`` to the screen, ready but for the light and the frame's corner.

        ``captured``: the samples are those of a list that was shaded apart (samples.glsl); ``glares``: a veil is laid
        over them.
        """
        words = {"SAMPLES": str(samples)} | ({CAPTURED: "1"} if captured else {})
        words |= {"GLARE": "1"} if glares else {}
        program, screen = self._objects.screen("finish.frag.glsl", words)
        values = {
            "exposure": 2.0**view.exposure_ev,
            "as_radiance": display.linear,
            "dithered": display.dithered,
            "transparent": transparent,
        }
        assign(program, values | self._display_uniforms(view, display))
        return program, screen

    def count(self, light: moderngl.Texture, view: View, display: Display) -> Unshowable:
        """Count the object's pixels that ``display`` cannot show, by occlusion queries into the bound framebuffer."""
        program, screen = self._objects.screen("count.frag.glsl", {"SAMPLES": str(light.samples)})
        assign(program, self._display_uniforms(view, display))
        light.use(_LIGHT_UNIT)
        if self._query is None:
            self._query = self._objects.query()
        found = {}
        for number, name in enumerate(_COUNTED):
            assign(program, {"counted": number})
            with self._query:
                screen.render(moderngl.TRIANGLES, vertices=3)
            found[name] = int(self._query.samples)
        return Unshowable(**found)

    def _display_uniforms(self, view: View, display: Display) -> dict[str, object]:
        self._bind_codes(display.space)
        codes, table = display.space.codes, display.space.table
        return {
            "light": _LIGHT_UNIT,
            "device_codes": _CODES_UNIT,
            "device_steps": 0 if codes is None else len(codes),
            "device_cells": 0 if table is None else len(table),
            "tone_curve_kind": TONE_CURVE_NUMBERS[view.tone_curve],
            "working_to_display": tuple(display.space.from_working.T.ravel().tolist()),
            "marks": (float(view.clipping_marks), float(view.gamut_marks)),
            "mark_in_colour": view.mark_style == "colour",
        }

    def _bind_codes(self, space: DisplaySpace) -> None:
        """Have the codes of a space, or its table as columns of red and rows of green and blue, in a texture."""
        if space.table is not None:
            n = len(space.table)
            rows = space.table.transpose(1, 2, 0, 3).reshape(n * n, n, 3)
        elif space.codes is not None:
            rows = space.codes[None]
        else:
            return
        if self._codes_of is not space or self._codes is None:
            self._objects.release(self._codes)
            self._codes = self._objects.texture((rows.shape[1], rows.shape[0]), "f4")
            opaque = np.ones((*rows.shape[:2], 1), np.float32)
            self._codes.write(np.concatenate([rows, opaque], axis=2).tobytes())
            self._objects.counters.texture_uploads += 1
            self._codes_of = space
        self._codes.use(_CODES_UNIT)
