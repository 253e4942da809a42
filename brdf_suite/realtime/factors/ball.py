"""Reflectance balls: a factored material's ball in the lamps' light, drawn once a frame and read by the normal.

However many lamps there are, a place then costs one look-up (McCool, Ang and Ahmad 2001, section 5). It is an
approximation: the view is taken for orthographic and the lamps for as far away as they are from the middle of the
surface, and the material has to look alike from all sides (docs/method/factorization.md shows the error).
"""

from __future__ import annotations

from collections.abc import Iterable

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.realtime.camera import CameraMatrices
from brdf_suite.realtime.environment.textures import RAMP_UNIT
from brdf_suite.realtime.factors.textures import FactorTextures
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.programs import (
    BALL,
    BALL_UNIT,
    MATERIAL_BINDING,
    Features,
    assign,
    columns,
    surface_features,
)
from brdf_suite.realtime.material.material_set import Modes
from brdf_suite.realtime.pictures.captured import DrawContext

BALL_EDGE = 384
"""Pixels along an edge of a ball's picture; a normal turns by a third of a degree from one to the next."""


class ReflectanceBalls:
    """Reflectance balls of one renderer, redrawn when view direction, lamps or material change."""

    def __init__(self, drawing: DrawContext, factors: FactorTextures) -> None:
        self._drawing, self._factors = drawing, factors
        self._pictures: dict[str, tuple[moderngl.Texture, moderngl.Framebuffer]] = {}
        self._drawn: dict[str, object] = {}

    def draw(self, view: View, camera: CameraMatrices, materials: Iterable[str]) -> None:
        """Draw the balls of those materials that are factored; another framebuffer is bound after it."""
        if view.lamp_shading != "ball" or not view.lamps:
            return
        for name in set(materials):
            words = self._factors.features(name)
            if words:
                self._draw(view, camera, name, words)

    def words(self, view: View, material: str) -> Features:
        """Return the words of a material's surface program; none where it is not shaded by a ball."""
        ball = view.lamp_shading == "ball" and bool(self._factors.features(material))
        return frozenset({"FACTOR_BALL"}) if ball else frozenset()

    def uniforms(self, material: str, words: Features, camera: CameraMatrices) -> dict[str, object]:
        """Bind a material's maps or its ball, whichever its program has, and return the uniforms of that."""
        if "FACTOR_BALL" in words:
            self._pictures[material][0].use(BALL_UNIT)
            return {"ball_axes": columns(camera.view_to_world)}
        return self._factors.use(material) if "FACTORS" in words else {}

    def picture(self, material: str) -> NDArray[np.float32]:
        """Return the ball of a material as it was last drawn, (n, n, 3) radiance, top row first; KeyError: none was."""
        read = self._pictures[material][1].read(components=3, dtype="f4")
        return np.frombuffer(read, np.float32).reshape(BALL_EDGE, BALL_EDGE, 3)[::-1].copy()

    def _draw(self, view: View, camera: CameraMatrices, name: str, words: Features) -> None:
        drawing = self._drawing
        material = drawing.materials.find(name, Modes(view.fresnel, view.look_up), drawing.environment.ladder)
        made_of = (self._factors.made(name), material.made_for, view.lamps, view.fresnel)
        middle = 0.5 * (np.asarray(drawing.mesh.bounds.minimum) + np.asarray(drawing.mesh.bounds.maximum))
        key = (*made_of, camera.view_to_world.tobytes(), middle.tobytes())
        if self._drawn.get(name) == key:
            return
        words = words | {BALL, "LAMPS", "DARK"} | (surface_features(view) & {"FRESNEL_RAISED"})
        with graphics_errors(drawing.objects.context, f"drawing a ball of {name}"):
            texture, framebuffer = self._picture(name)
            drawing.objects.bind(framebuffer, (BALL_EDGE, BALL_EDGE))
            program, screen = drawing.programs.without_mesh(material.look_ups, words)
            assign(program, drawing.single_lights.uniforms(name, view, has_uv=False))
            assign(program, self._factors.use(name))
            assign(
                program,
                {
                    "ball_axes": columns(camera.view_to_world),
                    "ball_place": tuple(middle.tolist()),
                    "ball_pixels": float(BALL_EDGE),
                    "exposure": 1.0,
                    "ramp": RAMP_UNIT,
                },
            )
            material.ramp.use(RAMP_UNIT)
            material.buffer.bind_to_uniform_block(MATERIAL_BINDING)
            screen.render(moderngl.TRIANGLES, vertices=3)
            texture.build_mipmaps()
            texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        self._drawn[name] = key

    def _picture(self, name: str) -> tuple[moderngl.Texture, moderngl.Framebuffer]:
        if name not in self._pictures:
            texture = self._drawing.objects.texture((BALL_EDGE, BALL_EDGE), "f2")
            texture.repeat_x = texture.repeat_y = False
            self._pictures[name] = (texture, self._drawing.objects.framebuffer(texture))
        return self._pictures[name]
