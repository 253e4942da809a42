"""Draws a scene with OpenGL: panels, in each the solid lobes, then the frame, then what is see-through.

Its buffers live in one context; :meth:`SpacePainter.draw` is called with that context current and a frame buffer bound.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QColor, QMatrix4x4

from brdf_lobe_visualizer.view3d.camera import Camera
from brdf_lobe_visualizer.view3d.frame import Frame
from brdf_lobe_visualizer.view3d.gl import Program
from brdf_lobe_visualizer.view3d.items import PointItem, SegmentItem, Sight, SurfaceItem, points
from brdf_lobe_visualizer.view3d.scene import Layer, Panel, Rgba, Scene

_POINT_PX = 7.0
_HIDDEN = 0.3
"""How much of a sample is seen through a lobe that lies before it."""
_HANDLE_PX, _HOT_PX = 11.0, 13.0
_SPARE = 4
"""Surfaces that are kept for the next scene with more of them."""


@dataclass(frozen=True, eq=False)
class Drawing:
    """All that a picture is drawn from; ``hot``: the light's handle is under the cursor."""

    scene: Scene
    frame: Frame
    camera: Camera
    rooms: Sequence[QRectF]
    ground: QColor
    ink: QColor
    hot: bool = False


@dataclass(frozen=True)
class Target:
    """Where it is drawn: ``whole`` is the picture in the pixels of the bound frame buffer, which is ``size`` large.

    A frame buffer may be a part of the picture; then ``whole`` reaches beyond it. Its origin is at the bottom.
    ``logical`` is the size of the picture in the units of the rooms, ``ratio`` device pixels for one of them.
    """

    whole: QRectF
    size: QSize
    logical: QSize
    ratio: float


class SpacePainter:
    """Keeps what is on the card; make it with the context current."""

    def __init__(self) -> None:
        self._programs = {name: Program(name) for name in ("surface", "segment", "point")}
        self._surfaces: list[SurfaceItem] = []
        self._segments = (SegmentItem(), SegmentItem())
        self._points = PointItem()
        self._rows: tuple[object, npt.NDArray[np.void]] | None = None

    def write(self, scene: Scene) -> None:
        """Hand over the scene's surfaces, as far as they are not there."""
        layers = [layer for panel in scene.panels for layer in panel.layers]
        while len(self._surfaces) < len(layers):
            self._surfaces.append(SurfaceItem())
        for item, layer in zip(self._surfaces, layers, strict=False):
            item.write(layer.surface)
        for item in self._surfaces[len(layers) + _SPARE :]:
            item.free()
        del self._surfaces[len(layers) + _SPARE :]

    def draw(self, drawing: Drawing, target: Target) -> None:
        """Clear the frame buffer and draw all panels that reach into it."""
        self.write(drawing.scene)
        ground = drawing.ground
        GL.glDepthMask(True)
        GL.glColorMask(True, True, True, True)
        for state in (GL.GL_SCISSOR_TEST, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST):
            GL.glDisable(state)
        GL.glEnable(GL.GL_MULTISAMPLE)
        GL.glClearColor(ground.redF(), ground.greenF(), ground.blueF(), 1.0)
        GL.glClearDepth(1.0)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        first = 0
        for panel, room in zip(drawing.scene.panels, drawing.rooms, strict=False):
            sight = _sight(drawing.camera, room, target)
            if sight is not None:
                self._panel(panel, drawing, sight, first)
            first += len(panel.layers)
        GL.glUseProgram(0)
        for state in (GL.GL_DEPTH_TEST, GL.GL_BLEND, GL.GL_PROGRAM_POINT_SIZE):
            GL.glDisable(state)

    def _panel(self, panel: Panel, drawing: Drawing, sight: Sight, first: int) -> None:
        frame, ink, ground = drawing.frame, _rgba(drawing.ink), _rgba(drawing.ground)
        rows = list(enumerate(panel.layers, first))
        for item, layer in rows:
            if layer.style == "solid":
                self._surface(item, layer, sight, ink, 0)
        self._segments[0].draw(self._programs["segment"], sight, frame.behind)
        if panel.points is not None and len(panel.points.places):
            if self._rows is None or self._rows[0] is not panel.points:
                self._rows = panel.points, points(panel.points.places, panel.points.colours)
            program, rows_of = self._programs["point"], self._rows[1]
            self._points.draw(program, sight, rows_of, _POINT_PX, ground, behind=False, opacity=_HIDDEN)
            self._points.draw(program, sight, rows_of, _POINT_PX, ground)
        for order, (item, layer) in enumerate(rows):
            if layer.style != "solid":
                self._surface(item, layer, sight, ink, order)
        self._segments[1].draw(self._programs["segment"], sight, frame.before)
        if frame.handle is not None and drawing.scene.frame.arrows:
            colour = (1.0, 0.90, 0.55, 1.0) if drawing.hot else (0.95, 0.78, 0.25, 1.0)
            size = _HOT_PX if drawing.hot else _HANDLE_PX
            handle = points(frame.handle, colour)
            self._points.draw(
                self._programs["point"], sight, handle, size, (0.15, 0.15, 0.15, 1.0), behind=False
            )

    def _surface(self, item: int, layer: Layer, sight: Sight, ink: Rgba, order: int) -> None:
        tint = (*ink[:3], float(layer.ink))
        self._surfaces[item].draw(self._programs["surface"], sight, layer.style, layer.opacity, tint, order)


def _sight(camera: Camera, room: QRectF, target: Target) -> Sight | None:
    """Set the viewport to the part of a room that lies in the frame buffer, and return from where it is seen.

    The part is cut out by the matrix: a viewport as large as a large picture is more than drivers allow.
    """
    across = target.whole.width() / target.logical.width()
    down = target.whole.height() / target.logical.height()
    # Of whole pixels, so that parts of a picture meet without a seam.
    left = round(target.whole.left() + room.left() * across)
    bottom = round(target.whole.top() + (target.logical.height() - room.bottom()) * down)
    wide, high = max(1, round(room.width() * across)), max(1, round(room.height() * down))
    x0, y0 = max(left, 0), max(bottom, 0)
    x1, y1 = min(left + wide, target.size.width()), min(bottom + high, target.size.height())
    if x0 >= x1 or y0 >= y1:
        return None
    GL.glViewport(x0, y0, x1 - x0, y1 - y0)
    part = QMatrix4x4()
    part.translate((2 * left + wide - x0 - x1) / (x1 - x0), (2 * bottom + high - y0 - y1) / (y1 - y0), 0.0)
    part.scale(wide / (x1 - x0), high / (y1 - y0), 1.0)
    eye = camera.to_eye()
    to_clip = part * camera.to_screen(room.width(), room.height()) * eye
    return Sight(to_clip, eye, (float(x1 - x0), float(y1 - y0)), target.ratio)


def _rgba(colour: QColor) -> Rgba:
    return (colour.redF(), colour.greenF(), colour.blueF(), 1.0)
