"""Ground under the object: receives the object's shadow and otherwise shows the background.

The shadow is the ratio of the light that arrives beside the object to the light on an open ground, both in the
environment's own light, its low harmonics times the baked transfer of the ground, and in that of sun and lamps, whose
shadows are looked up (:mod:`~brdf_suite.realtime.lights.shadows`). A pixel of background is multiplied by it. Nothing
is drawn where nothing is in the way, so the ground has no edge.
"""

from __future__ import annotations

from collections.abc import Mapping

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, triple
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.geometry.low_harmonics import low_harmonics, rotate_harmonics
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import LIGHTS_BINDING, assign
from brdf_suite.realtime.lights.sun import Sun
from brdf_suite.realtime.values import CubeFaces, GroundField

GROUND_UNIT = 12
_DEPTH_CLAMP = 0x864F  # GL_DEPTH_CLAMP, core since OpenGL 3.2
_COARSE = 32
"""Texels along an edge of the faces that the harmonics are taken from: far finer than harmonics of degree 6."""


def environment_harmonics(faces: CubeFaces, degree: int) -> Floats:
    """Return ∫ L Y_lm dω of a cube map, ((degree + 1)², 3), working space."""
    pixels = np.asarray(faces.faces, np.float32)
    step = max(1, faces.size // _COARSE)
    size = faces.size // step
    trimmed = pixels[:, : size * step, : size * step]
    pooled = trimmed.reshape(6, size, step, size, step, 3).mean(axis=(2, 4)).astype(np.float64)
    directions = texel_directions(size)
    # A face lies at the distance 1, so the largest component is one over the texel's distance.
    solid_angle = np.abs(directions).max(axis=-1) ** 3
    solid_angle *= 4.0 * np.pi / solid_angle.sum()
    harmonics = low_harmonics(directions, degree)
    return np.asarray(np.einsum("fij,fijh,fijc->hc", solid_angle, harmonics, pooled) * faces.scale)


def ground_ratio(
    transfer: NDArray[np.float32], light: Floats, sun: Floats | None = None
) -> tuple[Floats, Floats, Floats]:
    """Return what of the light arrives (rows, columns, 3), 0…1; of open ground the sun's share (3,) and its light (3,).

    ``transfer`` (rows, columns, h) as in :class:`GroundField`, ``light`` (h, 3) the light's harmonics and ``sun``
    (h, 3) those of a sun in it, which is then left out of what arrives. The corner of the field is open ground.
    """
    degrees = np.arange(round(len(light) ** 0.5))
    # Lanczos' sinc keeps a small bright light from ringing.
    soft = np.sinc(np.repeat(degrees, 2 * degrees + 1) / len(degrees))
    rest = light if sun is None else light - sun
    arriving = transfer.astype(np.float64) @ (soft[:, None] * rest)
    full = transfer[0, 0].astype(np.float64) @ (soft[:, None] * light)
    ratio = np.divide(arriving, full, out=np.ones_like(arriving), where=full > 0.0)
    open_share = np.clip(ratio[0, 0], 0.0, 1.0)
    shares = np.asarray(np.clip(ratio, 0.0, open_share)), np.asarray(1.0 - open_share)
    return *shares, np.maximum(full, 0.0)


class GroundShadow:
    """The baked ground of one mesh in the light of one environment, as a texture updated with both."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._field: GroundField | None = None
        self._light: Floats | None = None
        self._background: CubeFaces | None = None
        self._texture: moderngl.Texture | None = None
        self._shown: tuple[float, bytes, Sun | None] | None = None
        self._sun_share = self._open_light = (0.0, 0.0, 0.0)

    @property
    def height(self) -> float | None:
        """Height of the ground, metres; None where there is none."""
        return None if self._field is None else self._field.height

    def set_field(self, field: GroundField | None) -> None:
        """Take the ground of another mesh, or none."""
        self._field = field
        self._shown = None
        self._light = None

    def set_environment(self, background: CubeFaces) -> None:
        """Take another environment."""
        self._background = background
        self._shown = None
        self._light = None

    def draw(
        self,
        world_to_clip: tuple[float, ...],
        turn: float,
        colours: Floats,
        sun: Sun | None,
        lamps: bool,
        cast: Mapping[str, object],
        reach: tuple[Floats, Floats],
    ) -> None:
        """Multiply what is drawn already, where the object is not in front, by the shadow.

        Parameters
        ----------
        world_to_clip
            Column by column.
        turn, colours
            How far the light is turned about y, radians, and the (3, 3) that its colours are mixed by.
        sun
            The environment's sun where it casts a shadow of its own.
        lamps
            Whether lamps light the ground, and cast shadows there.
        cast
            Inputs of shadows.glsl; nothing where neither sun nor lamps cast shadows. Lamps are bound by the caller.
        reach
            Lowest and highest (x, z) of these shadows, metres.
        """
        if self._field is None or self._background is None:
            return
        texture = self._brought_up_to_date(self._field, self._background, turn, colours, sun)
        words = {"SUN": "1"} if sun is not None else {}
        if lamps:
            words["LAMP_SHADOWS"] = "1"
        if "pane_map" in cast:
            words["PANE_SHADOWS"] = "1"
        program, corners = self._objects.screen("ground.frag.glsl", words, vertex="ground.vert.glsl")
        texture.use(GROUND_UNIT)
        block = program.get("Lights", None)
        if isinstance(block, moderngl.UniformBlock):
            block.binding = LIGHTS_BINDING
        low, high = np.array(self._field.low), np.array(self._field.high)
        values = {
            "world_to_clip": world_to_clip,
            "ground_shadow": GROUND_UNIT,
            "ground_field": (*self._field.low, *self._field.high),
            "ground_height": self._field.height,
            "ground_beyond": float(np.concatenate([[0.0], low - reach[0], reach[1] - high]).max()),
            "sun_share": self._sun_share,
            "open_light": self._open_light,
        }
        assign(program, values | dict(cast))
        context = self._objects.context
        context.enable_only(moderngl.DEPTH_TEST | moderngl.BLEND)
        # The near and far planes enclose the object; the ground goes on beyond them.
        context.enable_direct(_DEPTH_CLAMP)
        context.blend_func = moderngl.DST_COLOR, moderngl.ZERO
        corners.render(moderngl.TRIANGLE_STRIP, vertices=4)
        context.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA
        context.disable_direct(_DEPTH_CLAMP)
        context.enable_only(moderngl.DEPTH_TEST)

    def _brought_up_to_date(
        self, field: GroundField, background: CubeFaces, turn: float, colours: Floats, sun: Sun | None
    ) -> moderngl.Texture:
        """Return the texture; written only where field, light, turn or colours are others than before."""
        wanted = (turn, colours.tobytes(), sun)
        if self._texture is not None and wanted == self._shown:
            return self._texture
        degree = round(field.transfer.shape[2] ** 0.5) - 1
        if self._light is None:
            self._light = environment_harmonics(background, degree)

        def turned(light: Floats) -> Floats:
            return np.asarray(rotate_harmonics(light.T, turn).T @ colours.T)

        of_sun = None
        if sun is not None:
            of_sun = turned(low_harmonics(sun.direction, degree)[:, None] * sun.irradiance)
        ratio, share, full = ground_ratio(field.transfer, turned(self._light), of_sun)
        self._sun_share, self._open_light = triple(share), triple(full)
        rows, columns = ratio.shape[:2]
        if self._texture is None or self._texture.size != (columns, rows):
            self.release()
            self._texture = self._objects.texture((columns, rows), "f2")
            self._texture.repeat_x = self._texture.repeat_y = False
            self._texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        pixels = np.ones((rows, columns, 4), np.float16)
        pixels[..., :3] = ratio
        self._texture.write(pixels.tobytes())
        self._objects.counters.texture_uploads += 1
        self._shown = wanted
        return self._texture

    def release(self) -> None:
        """Give the texture back."""
        self._objects.release(self._texture)
        self._texture = self._shown = None
