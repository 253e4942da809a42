"""The view in three dimensions: draws a :class:`Scene` in one or several panels from one camera.

It is pyqtgraph's view with drawing of its own: its buffers are written again instead of made anew, panels share a
picture, and words are painted over it. Intents go out as signals; who owns the view sets scene and camera.
"""

from __future__ import annotations

import logging
import math
import time
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from brdf_qt.application import surface_format
from brdf_qt.translation import tr
from OpenGL import GL
from pyqtgraph.opengl import GLViewWidget
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QMatrix4x4, QPainter, QPalette, QTransform, QVector3D
from PySide6.QtOpenGL import QOpenGLFramebufferObject, QOpenGLFramebufferObjectFormat, QOpenGLPaintDevice
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.camera import Camera
from brdf_lobe_visualizer.space_frame import LIGHT_REACH, Frame, frame_of
from brdf_lobe_visualizer.space_gl import Program
from brdf_lobe_visualizer.space_items import PointItem, SegmentItem, Sight, SurfaceItem, points
from brdf_lobe_visualizer.space_overlay import Overlay
from brdf_lobe_visualizer.space_scene import Layer, Panel, Rgba, Scene
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.lobe_surface import LobeSurface
from brdf_suite.pipeline.lobe_surface_grid import LobeGrid
from brdf_suite.pipeline.lobe_surface_hiding import hidden, met

log = logging.getLogger(__name__)

_TILE = 1024
"""Device pixels of a part of an exported picture; larger buffers may not be had."""
_SUPERSAMPLED = 2
_POINT_PX = 5.0
_HANDLE_PX = 15.0


@dataclass(frozen=True, eq=False)
class Probe:
    """A point (3,) of a lobe that is looked at, in the panel ``room``."""

    place: npt.NDArray[np.float64]
    surface: LobeSurface
    grid: LobeGrid
    room: QRectF


class SpaceView(GLViewWidget):
    """The view. Signals: ``failed(text)`` where nothing can be drawn, ``drawn(ms)`` after each frame."""

    failed = Signal(str)
    drawn = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFormat(surface_format(4))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setMinimumSize(200, 160)
        self.setAccessibleName(tr("Lobes in three dimensions"))
        self.setObjectName("space_view")
        self.scene = Scene()
        self.camera = Camera()
        self.hot = False
        self._programs: dict[str, Program] = {}
        self._surfaces: list[SurfaceItem] = []
        self._segments: list[SegmentItem] = []
        self._points: list[PointItem] = []
        self._frame: Frame | None = None
        self._rows: dict[int, npt.NDArray[np.void]] = {}
        self._failure = ""
        self._probe: Probe | None = None
        self._probe_text = ""

    # What is shown.

    def set_scene(self, scene: Scene) -> None:
        """Show ``scene`` from the next frame on; its surfaces go to the card at once where it is there."""
        before = self.scene
        self.scene = scene
        alike = (before.scale, before.frame) == (scene.scale, scene.frame)
        if not alike or before.light is not scene.light:
            self._frame = None
        self._rows.clear()
        self._probe = None
        self.hand_over()
        self.update()

    def hand_over(self) -> None:
        """Write the scene's surfaces to the card, as far as they are not there."""
        if not self._programs or not self.isValid():
            return
        self.makeCurrent()
        try:
            self._write()
        finally:
            self.doneCurrent()

    def set_camera(self, camera: Camera) -> None:
        """See from there."""
        self.camera = camera
        self.update()

    def set_hot(self, hot: bool) -> None:
        """Show the light's handle as taken, or as one that can be."""
        if hot != self.hot:
            self.hot = hot
            self.update()

    # Where things are.

    def rooms(self, size: QSize | None = None) -> list[QRectF]:
        """Return the panels' rectangles, logical pixels, for a picture of the view's size or another."""
        size = size or self.size()
        count = max(1, len(self.scene.panels))
        width, height = float(size.width()), float(size.height())
        # The rows and columns in which the smaller side of a panel is largest.
        best = max(
            range(1, count + 1), key=lambda n: (round(min(width / n, height / math.ceil(count / n)), 3), n)
        )
        rows = math.ceil(count / best)
        wide, high = width / best, height / rows
        return [QRectF((i % best) * wide, (i // best) * high, wide, high) for i in range(count)]

    def to_clip(self, room: QRectF) -> QMatrix4x4:
        """Return the matrix from the local frame to clip coordinates of a panel."""
        return self.camera.to_screen(room.width(), room.height()) * self.camera.to_eye()

    def project(self, place: tuple[float, float, float], room: QRectF) -> QPointF | None:
        """Return where a place of the local frame is on the widget; None behind the eye."""
        return _projected(self.to_clip(room), place, room)

    def ray(self, at: QPointF) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], QRectF]:
        """Return start and direction of the ray through a point of the widget, and the panel that it is in."""
        rooms = self.rooms()
        room = next((r for r in rooms if r.contains(at)), rooms[0])
        inverse, _ = self.to_clip(room).inverted()
        x = 2.0 * (at.x() - room.left()) / room.width() - 1.0
        y = 1.0 - 2.0 * (at.y() - room.top()) / room.height()
        near, far = (inverse.map(QVector3D(x, y, z)) for z in (-1.0, 1.0))
        start = np.array([near.x(), near.y(), near.z()])
        along = np.array([far.x(), far.y(), far.z()]) - start
        return start, along / np.linalg.norm(along), room

    def handle_at(self, at: QPointF) -> bool:
        """Whether the light's handle is under a point of the widget."""
        if self.scene.light is None or not self.scene.frame.arrows:
            return False
        place = LIGHT_REACH * self.scene.light
        for room in self.rooms():
            spot = self.project((float(place[0]), float(place[1]), float(place[2])), room)
            if spot is not None and math.hypot(spot.x() - at.x(), spot.y() - at.y()) <= _HANDLE_PX:
                return True
        return False

    # Drawing.

    def initializeGL(self) -> None:
        self._forget()
        try:
            self.context().aboutToBeDestroyed.connect(self._forget, Qt.ConnectionType.UniqueConnection)
            self._programs = {name: Program(name) for name in ("surface", "segment", "point")}
            self._segments = [SegmentItem(), SegmentItem()]
            self._points = [PointItem()]
            self._failure = ""
        except Exception as error:  # noqa: BLE001 - raised into Qt it would be lost, and the picture black
            self._fail(error)

    def paintGL(self) -> None:
        if self._failure:
            return
        start = time.perf_counter()
        ratio = self.devicePixelRatioF()
        width, height = self.deviceWidth(), self.deviceHeight()
        try:
            self._draw(self.size(), QRectF(0, 0, width, height), ratio)
            # Not on the widget itself, which a picture of the window (QWidget.grab) sends elsewhere.
            device = QOpenGLPaintDevice(QSize(width, height))
            device.setDevicePixelRatio(ratio)
            painter = QPainter(device)
            try:
                self._paint_words(painter, self.size())
            finally:
                painter.end()
        except Exception as error:  # noqa: BLE001 - as above
            self._fail(error)
            return
        self.drawn.emit((time.perf_counter() - start) * 1e3)

    def resizeGL(self, width: int, height: int) -> None:
        """Nothing hangs on the size but what every frame asks anew."""

    def picture(self, width: int, height: int) -> QImage:
        """Return the scene as a picture of any size in pixels, four times sampled in both directions, with its words.

        It is drawn in parts, so that neither the card's nor the screen's size limits it.
        """
        # Words and lines keep their share of the picture: as if the view were as high as it is now.
        scale = max(1.0, min(width, height) / max(1, min(self.width(), self.height())))
        logical = QSize(max(1, round(width / scale)), max(1, round(height / scale)))
        image = QImage(width, height, QImage.Format.Format_RGB32)
        self.makeCurrent()
        try:
            painter = QPainter(image)
            try:
                self._tiles(painter, logical, width, height, scale)
                painter.scale(width / logical.width(), height / logical.height())
                self._paint_words(painter, logical)
            finally:
                painter.end()
        finally:
            self.doneCurrent()
            self.update()
        return image

    def _tiles(self, painter: QPainter, logical: QSize, width: int, height: int, scale: float) -> None:
        form = QOpenGLFramebufferObjectFormat()
        form.setAttachment(QOpenGLFramebufferObject.Attachment.CombinedDepthStencil)
        form.setSamples(4)
        tile = _TILE // _SUPERSAMPLED
        for top in range(0, height, tile):
            for left in range(0, width, tile):
                wide, high = min(tile, width - left), min(tile, height - top)
                size = QSize(wide * _SUPERSAMPLED, high * _SUPERSAMPLED)
                target = QOpenGLFramebufferObject(size, form)
                target.bind()
                part = QRectF(left, top, wide, high)
                whole = QRectF(-left, -(height - top - high), width, height)
                grown = QTransform.fromScale(_SUPERSAMPLED, _SUPERSAMPLED).mapRect(whole)
                self._draw(logical, grown, scale * _SUPERSAMPLED, size)
                target.release()
                drawn = target.toImage().convertToFormat(QImage.Format.Format_RGB32)
                smooth = drawn.scaled(
                    wide,
                    high,
                    Qt.AspectRatioMode.IgnoreAspectRatio,
                    Qt.TransformationMode.SmoothTransformation,
                )
                painter.drawImage(part, smooth)

    def _draw(self, logical: QSize, whole: QRectF, ratio: float, tile: QSize | None = None) -> None:
        """Draw all panels into the bound frame buffer; ``whole`` is where all of the picture lies in its pixels."""
        self._write()
        ground = self.palette().color(QPalette.ColorRole.Base)
        GL.glDepthMask(True)
        GL.glColorMask(True, True, True, True)
        GL.glDisable(GL.GL_SCISSOR_TEST)
        GL.glDisable(GL.GL_CULL_FACE)
        GL.glDisable(GL.GL_STENCIL_TEST)
        GL.glEnable(GL.GL_MULTISAMPLE)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)
        GL.glClearColor(ground.redF(), ground.greenF(), ground.blueF(), 1.0)
        GL.glClearDepth(1.0)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        self.frame()
        item = 0
        for number, (panel, room) in enumerate(zip(self.scene.panels, self.rooms(logical), strict=False)):
            across, down = whole.width() / logical.width(), whole.height() / logical.height()
            view = (
                round(whole.left() + room.left() * across),
                round(whole.top() + (logical.height() - room.bottom()) * down),
                max(1, round(room.width() * across)),
                max(1, round(room.height() * down)),
            )
            limit = tile or QSize(round(whole.width()), round(whole.height()))
            if (
                view[0] < limit.width()
                and view[1] < limit.height()
                and view[0] + view[2] > 0
                and view[1] + view[3] > 0
            ):
                GL.glViewport(*view)
                eye = self.camera.to_eye()
                sight = Sight(
                    self.camera.to_screen(room.width(), room.height()) * eye,
                    eye,
                    (float(view[2]), float(view[3])),
                    ratio,
                )
                self._draw_panel(panel, number, sight, item)
            item += len(panel.layers)
        GL.glUseProgram(0)
        GL.glDisable(GL.GL_DEPTH_TEST)
        GL.glDisable(GL.GL_BLEND)
        GL.glDisable(GL.GL_PROGRAM_POINT_SIZE)

    def frame(self) -> Frame:
        """Return the lines and labels about the lobes, in the theme's colours."""
        if self._frame is None:
            ink = self.palette().color(QPalette.ColorRole.Text)
            colour = (ink.redF(), ink.greenF(), ink.blueF(), 1.0)
            self._frame = frame_of(self.scene.light, self.scene.scale, self.scene.frame, colour)
        return self._frame

    def _draw_panel(self, panel: Panel, number: int, sight: Sight, first: int) -> None:
        frame = self.frame()
        surface = self._programs["surface"]
        rows = list(enumerate(panel.layers, first))
        text = self.palette().color(QPalette.ColorRole.Text)

        def tint(layer: Layer) -> Rgba:
            return (text.redF(), text.greenF(), text.blueF(), float(layer.ink))

        for item, layer in rows:
            if layer.style == "solid":
                self._surfaces[item].draw(surface, sight, "solid", layer.opacity, tint(layer))
        self._segments[0].draw(self._programs["segment"], sight, frame.behind)
        if panel.points is not None and len(panel.points.places):
            ink = self.palette().color(QPalette.ColorRole.Base)
            self._points[0].draw(
                self._programs["point"],
                sight,
                self._rows.setdefault(number, points(panel.points.places, panel.points.colours)),
                _POINT_PX,
                (ink.redF(), ink.greenF(), ink.blueF(), 1.0),
            )
        for item, layer in rows:
            if layer.style != "solid":
                self._surfaces[item].draw(
                    surface, sight, "glass" if layer.style == "glass" else "lines", layer.opacity, tint(layer)
                )
        self._segments[1].draw(self._programs["segment"], sight, frame.before)
        if frame.handle is not None and self.scene.frame.arrows:
            colour = (1.0, 0.90, 0.55, 1.0) if self.hot else (0.95, 0.78, 0.25, 1.0)
            self._points[0].draw(
                self._programs["point"],
                sight,
                points(frame.handle, colour),
                13.0 if self.hot else 11.0,
                (0.15, 0.15, 0.15, 1.0),
                behind=False,
            )

    def _write(self) -> None:
        layers = [layer for panel in self.scene.panels for layer in panel.layers]
        while len(self._surfaces) < len(layers):
            self._surfaces.append(SurfaceItem())
        for item, layer in zip(self._surfaces, layers, strict=False):
            item.write(layer.surface)
        for item in self._surfaces[len(layers) + 4 :]:
            item.free()
        del self._surfaces[len(layers) + 4 :]

    def _paint_words(self, painter: QPainter, size: QSize) -> None:
        palette = self.palette()
        ink, paper = palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base)
        overlay = Overlay(painter, self.font(), QColor(ink), QColor(paper))
        rooms = self.rooms(size)
        for panel, room in zip(self.scene.panels, rooms, strict=False):
            matrix = self.to_clip(room)
            if self._frame is not None:
                labels = self._frame.labels
                behind = self._behind(panel, [label.place for label in labels])
                overlay.labels(labels, lambda place, m=matrix, r=room: _projected(m, place, r), room, behind)
            overlay.panel(panel, room, bordered=len(rooms) > 1)
        if self.scene.bar is not None:
            overlay.bar(self.scene.bar, QRectF(0.0, 0.0, size.width(), size.height()))
        probe = self._probe
        if probe is not None and probe.room in rooms:
            x, y, z = (float(value) for value in probe.place)
            spot = _projected(self.to_clip(probe.room), (x, y, z), probe.room)
            if spot is not None:
                overlay.probe(spot, self._probe_text, probe.room)
        if not self.scene.panels:
            overlay.words(
                tr("Nothing to show: add a reflectance, or show one in the legend."),
                QRectF(0.0, 0.0, size.width(), size.height()),
            )

    def _behind(self, panel: Panel, places: list[tuple[float, float, float]]) -> list[bool]:
        """Which places a solid lobe of the panel hides."""
        result = np.zeros(len(places), bool)
        for layer in panel.layers:
            if layer.style == "solid" and layer.grid is not None and places:
                result |= hidden(layer.surface, layer.grid, self.camera.eye(), places)
        return [bool(value) for value in result]

    def probe_at(self, at: QPointF) -> Probe | None:
        """Return the first solid lobe that the ray through a point of the widget meets; None where there is none."""
        start, along, room = self.ray(at)
        rooms = self.rooms()
        for panel, other in zip(self.scene.panels, rooms, strict=False):
            if other != room:
                continue
            for layer in panel.layers:
                if layer.style != "solid" or layer.grid is None or layer.surface.dark:
                    continue
                place = met(layer.surface, layer.grid, start, along)
                if place is not None:
                    return Probe(place, layer.surface, layer.grid, room)
        return None

    def set_probe(self, probe: Probe | None, text: str = "") -> None:
        """Mark a point of a lobe with words, or none."""
        if probe is None and self._probe is None:
            return
        self._probe, self._probe_text = probe, text
        self.update()

    def changeEvent(self, event: object) -> None:
        super().changeEvent(event)
        self._frame = None  # its lines have the theme's colour
        self.update()

    def _forget(self) -> None:
        """Everything that was made in a context goes with it."""
        self._programs, self._surfaces, self._segments, self._points = {}, [], [], []

    def _fail(self, error: Exception) -> None:
        if not isinstance(error, SuiteError):
            log.error("the view in three dimensions", exc_info=error)
        self._failure = tr("The lobes cannot be drawn: {reason}").format(reason=error)
        QTimer.singleShot(0, self, lambda: self.failed.emit(self._failure))


def _projected(matrix: QMatrix4x4, place: tuple[float, float, float], room: QRectF) -> QPointF | None:
    x, y, z = place
    row = matrix.row(3)
    depth = row.x() * x + row.y() * y + row.z() * z + row.w()
    if depth <= 1e-4:
        return None
    at = matrix.map(QVector3D(x, y, z))
    return QPointF(
        room.left() + 0.5 * (at.x() + 1.0) * room.width(), room.top() + 0.5 * (1.0 - at.y()) * room.height()
    )
