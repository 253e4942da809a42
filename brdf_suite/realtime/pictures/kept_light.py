"""Precomputed look-ups of a captured form, shared by all paints, which only weight them.

Into which direction a lobe is looked up at a place, and through which exponent, depends on the lobe and on N·V
(:mod:`brdf_suite.realtime.environment.look_up_table`), never on the paint; and palettes share their lobes. So each
look-up is drawn once over the list of places, by the very shader that the renderer draws surfaces with, for a
material whose ramp is 1 in that one row. The lists lie one below the other in a texture of whole floats.
"""

from __future__ import annotations

from collections.abc import Mapping

import moderngl
import numpy as np

from brdf_suite.realtime.environment.look_up_table import RAMP_NODES
from brdf_suite.realtime.environment.textures import RAMP_UNIT, EnvironmentTextures
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import (
    CAPTURED,
    KEEPING,
    KEPT_UNIT,
    MATERIAL_BINDING,
    PLACES_UNIT,
    Features,
    LookUps,
    Programs,
    assign,
)
from brdf_suite.realtime.material.material_set import BLOCK_SIZE
from brdf_suite.realtime.material.ramp import MAX_BROAD, MAX_ROWS, MAX_SHARP, Ramp

MOST_LAYERS = 32
"""Designed paints ask for some twenty among them; a paint for which there is no room makes its own look-ups."""
_DIMMED = 2.0**-16
"""Keeps the light of a sun below the largest number that the shader lets pass; a power of two costs no digit."""
_NO_COLOUR = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

_Key = tuple[str, bytes]


class KeptLight:
    """Cached look-ups of one list of places."""

    def __init__(
        self,
        objects: GpuObjects,
        programs: Programs,
        environment: EnvironmentTextures,
        features: Features,
        common: Mapping[str, object],
        size: tuple[int, int],
    ) -> None:
        self._objects, self._programs, self._environment = objects, programs, environment
        self._features = features | {KEEPING, CAPTURED}
        self._width, self._rows = size
        # The light's colour and the exposure are the paint's to take: once, and of the sum.
        self._common = {
            **common,
            "light_colour": _NO_COLOUR,
            "exposure": _DIMMED,
            "places": PLACES_UNIT,
            "place_rows": self._rows,
        }
        self._layers: dict[_Key, int] = {}
        self._made: list[moderngl.Texture | moderngl.Framebuffer | moderngl.Buffer] = []
        self._texture: moderngl.Texture | None = None

    @staticmethod
    def fits(context: moderngl.Context, rows: int) -> bool:
        """Whether the look-ups of a list of so many rows go into one texture."""
        return rows * MOST_LAYERS <= int(context.info["GL_MAX_TEXTURE_SIZE"])

    def uniforms(self, ramp: Ramp) -> dict[str, object] | None:
        """Return those of kept_light.glsl for a material, and bind the texture; None: it has too many look-ups.

        Look-ups that are not there yet are drawn, into a target of their own.
        """
        layers = [0] * (1 + MAX_SHARP + MAX_BROAD)
        wanted = [(0, "diffuse"), *((1 + k, "sharp") for k in range(len(ramp.sharp)))]
        wanted += [(1 + MAX_SHARP + k, "broad") for k in range(ramp.base + ramp.coat)]
        for row, kind in wanted:
            layer = self._layer(kind, row, ramp)
            if layer is None:
                return None
            layers[row] = layer
        if self._texture is not None:
            self._texture.use(KEPT_UNIT)
        return {"kept_layers": tuple(layers), "kept_scale": 1.0 / _DIMMED}

    def release(self) -> None:
        """Give everything back."""
        for made in reversed(self._made):
            self._objects.release(made)
        self._made, self._layers, self._texture = [], {}, None

    def _layer(self, kind: str, row: int, ramp: Ramp) -> int | None:
        broad = ramp.toward_normal[row - 1 - MAX_SHARP] if kind == "broad" else np.zeros(4, np.float32)
        if kind == "sharp":
            key = (kind, np.float64(ramp.sharp[row - 1]).tobytes())
        else:
            key = (kind, broad.tobytes() + np.ascontiguousarray(ramp.rows[row, :, 3]).tobytes())
        if key not in self._layers:
            if len(self._layers) >= MOST_LAYERS:
                return None
            sharp = (ramp.sharp[row - 1],) if kind == "sharp" else ()
            self._draw(len(self._layers), kind, ramp.rows[row, :, 3], broad, sharp)
            self._layers[key] = len(self._layers)
        return self._layers[key]

    def _draw(
        self,
        layer: int,
        kind: str,
        levels: np.ndarray[tuple[int], np.dtype[np.float32]],
        broad: np.ndarray[tuple[int], np.dtype[np.float32]],
        sharp: tuple[float, ...],
    ) -> None:
        """Draw one look-up over the list, with a weight of 1."""
        framebuffer, ramp, buffer = self._targets()
        rows = np.zeros((MAX_ROWS, RAMP_NODES, 4), np.float32)
        row = {"diffuse": 0, "sharp": 1, "broad": 1 + MAX_SHARP}[kind]
        rows[row, :, :3] = 1.0
        rows[row, :, 3] = levels
        block = np.zeros((BLOCK_SIZE // 16, 4), np.float32)
        block[3] = broad
        with graphics_errors(self._objects.context, "looking the light of a form up"):
            ramp.write(rows.tobytes())
            buffer.write(block.tobytes())
            framebuffer.use()
            self._objects.context.viewport = (0, layer * self._rows, self._width, self._rows)
            program, screen = self._programs.without_mesh(LookUps(1, 1), self._features)
            assign(program, self._common | {"first_row": layer * self._rows})
            assign(program, self._environment.use_sharp(sharp))
            ramp.use(RAMP_UNIT)
            buffer.bind_to_uniform_block(MATERIAL_BINDING)
            screen.render(moderngl.TRIANGLES, vertices=3)

    def _targets(self) -> tuple[moderngl.Framebuffer, moderngl.Texture, moderngl.Buffer]:
        if not self._made:
            texture = self._objects.texture((self._width, self._rows * MOST_LAYERS), "f4")
            texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
            self._texture = texture
            self._made = [
                texture,
                self._objects.framebuffer(texture),
                self._objects.ramp((RAMP_NODES, MAX_ROWS)),
                self._objects.buffer(reserve=BLOCK_SIZE, dynamic=True),
            ]
        _, framebuffer, ramp, buffer = self._made
        if not (
            isinstance(framebuffer, moderngl.Framebuffer)
            and isinstance(ramp, moderngl.Texture)
            and isinstance(buffer, moderngl.Buffer)
        ):
            raise AssertionError("they were made in this order")
        return framebuffer, ramp, buffer
