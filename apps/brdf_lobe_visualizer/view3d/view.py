"""The view in three dimensions: shows a :class:`Scene` in one or several panels from one camera.

It is pyqtgraph's view with drawing of its own (:mod:`brdf_lobe_visualizer.view3d.painter`): buffers are written
again instead of made anew, panels share a picture, and words are painted over it. Who owns the view sets scene and
camera.
"""

from __future__ import annotations

import logging
import math
import time
from functools import partial

import numpy as np
from brdf_qt.program.application import surface_format
from brdf_qt.program.translation import tr
from pyqtgraph.opengl import GLViewWidget
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QMatrix4x4, QPainter, QPalette, QTransform, QVector3D
from PySide6.QtOpenGL import QOpenGLFramebufferObject, QOpenGLFramebufferObjectFormat, QOpenGLPaintDevice
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.view3d.camera import Camera
from brdf_lobe_visualizer.view3d.frame import LIGHT_REACH, Frame, frame_of
from brdf_lobe_visualizer.view3d.overlay import Overlay
from brdf_lobe_visualizer.view3d.painter import Drawing, SpacePainter, Target
from brdf_lobe_visualizer.view3d.scene import Panel, Probe, Scene
from brdf_suite.arrays import Floats
from brdf_suite.errors import SuiteError
from brdf_suite.inspection.lobe_surface.occlusion import hidden, met

log = logging.getLogger(__name__)

_TILE = 1024
"""Device pixels of a part of an exported picture; larger buffers may not be had."""
_SUPERSAMPLED = 2
_HANDLE_PX = 15.0
_CONTENT = (2.6, 1.9)
"""Width and height of hemisphere and labels beside each other."""


class SpaceView(GLViewWidget):  # type: ignore[misc]  # pyqtgraph has no types
    """The view. Signals: ``failed(text)`` where nothing can be drawn, ``drawn(ms)`` after each frame."""

    failed = Signal(str)
    drawn = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFormat(surface_format(4))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setMinimumSize(200, 160)
        self.setAccessibleName(tr("3-D lobe plot"))
        self.setObjectName("space_view")
        self.scene = Scene()
        self.camera = Camera()
        self.hot = False
        self._painter: SpacePainter | None = None
        self._frame: Frame | None = None
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
        self._probe = None
        if self._painter is not None and self.isValid():
            self.makeCurrent()
            try:
                self._painter.write(scene)
            finally:
                self.doneCurrent()
        self.update()

    def set_camera(self, camera: Camera) -> None:
        """See from there."""
        self.camera = camera
        self.update()

    def set_hot(self, hot: bool) -> None:
        """Show the light's handle as taken, or as one that can be."""
        if hot != self.hot:
            self.hot = hot
            self.update()

    def set_probe(self, probe: Probe | None, text: str = "") -> None:
        """Mark a point of a lobe with words, or none."""
        if probe is not None or self._probe is not None:
            self._probe, self._probe_text = probe, text
            self.update()

    # Where things are.

    def rooms(self, size: QSize | None = None) -> list[QRectF]:
        """Return the panels' rectangles, logical pixels, for a picture of the view's size or another."""
        size = size or self.size()
        count = max(1, len(self.scene.panels))
        width, height = float(size.width()), float(size.height())

        def share(columns: int) -> float:
            # How large hemisphere and labels are then.
            rows = math.ceil(count / columns)
            return min(width / columns / _CONTENT[0], height / rows / _CONTENT[1])

        best = max(range(1, count + 1), key=lambda columns: (round(share(columns), 3), columns))
        wide, high = width / best, height / math.ceil(count / best)
        return [QRectF((i % best) * wide, (i // best) * high, wide, high) for i in range(count)]

    def to_clip(self, room: QRectF) -> QMatrix4x4:
        """Return the matrix from the local frame to clip coordinates of a panel."""
        return self.camera.to_screen(room.width(), room.height()) * self.camera.to_eye()

    def project(self, place: tuple[float, float, float], room: QRectF) -> QPointF | None:
        """Return where a place of the local frame is on the widget; None behind the eye."""
        return _projected(self.to_clip(room), place, room)

    def ray(self, at: QPointF) -> tuple[Floats, Floats, QRectF]:
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
        x, y, z = (float(value) for value in LIGHT_REACH * self.scene.light)
        spots = [self.project((x, y, z), room) for room in self.rooms()]
        return any(s is not None and math.hypot(s.x() - at.x(), s.y() - at.y()) <= _HANDLE_PX for s in spots)

    def probe_at(self, at: QPointF) -> Probe | None:
        """Return the first solid lobe that the ray through a point of the widget meets; None where there is none."""
        start, along, room = self.ray(at)
        for panel, other in zip(self.scene.panels, self.rooms(), strict=False):
            for layer in panel.layers if other == room else ():
                if layer.style != "solid" or layer.grid is None or layer.surface.dark:
                    continue
                place = met(layer.surface, layer.grid, start, along)
                if place is not None:
                    return Probe(place, layer.surface, layer.grid, (room.left(), room.top()))
        return None

    # Drawing.

    def initializeGL(self) -> None:
        self._painter = None
        try:
            self.context().aboutToBeDestroyed.connect(self._forget, Qt.ConnectionType.UniqueConnection)
            self._painter = SpacePainter()
            self._failure = ""
        except Exception as error:  # noqa: BLE001 - raised into Qt it would be lost, and the picture black
            self._fail(error)

    def resizeGL(self, width: int, height: int) -> None:
        """Nothing hangs on the size but what every frame asks anew."""

    def paintGL(self) -> None:
        if self._failure or self._painter is None:
            return
        start = time.perf_counter()
        ratio, size = self.devicePixelRatioF(), QSize(self.deviceWidth(), self.deviceHeight())
        try:
            whole = QRectF(0, 0, size.width(), size.height())
            self._painter.draw(self._drawing(self.size()), Target(whole, size, self.size(), ratio))
            # Not on the widget itself, which a picture of the window (QWidget.grab) sends elsewhere.
            device = QOpenGLPaintDevice(size)
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

    def picture(self, width: int, height: int) -> QImage:
        """Return the scene as a picture of any size in pixels, sixteen samples each, with its words.

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
                self._paint_parts(painter, logical, width, height)
                painter.scale(width / logical.width(), height / logical.height())
                self._paint_words(painter, logical)
            finally:
                painter.end()
        finally:
            self.doneCurrent()
            self.update()
        return image

    def _paint_parts(self, painter: QPainter, logical: QSize, width: int, height: int) -> None:
        assert self._painter is not None, "asked only where the view is valid"
        form = QOpenGLFramebufferObjectFormat()
        form.setAttachment(QOpenGLFramebufferObject.Attachment.CombinedDepthStencil)
        form.setSamples(4)
        drawing = self._drawing(logical)
        grow = QTransform.fromScale(_SUPERSAMPLED, _SUPERSAMPLED)
        tile = _TILE // _SUPERSAMPLED
        for top in range(0, height, tile):
            for left in range(0, width, tile):
                wide, high = min(tile, width - left), min(tile, height - top)
                size = QSize(wide * _SUPERSAMPLED, high * _SUPERSAMPLED)
                buffer = QOpenGLFramebufferObject(size, form)
                buffer.bind()
                whole = grow.mapRect(QRectF(-left, -(height - top - high), width, height))
                ratio = whole.height() / logical.height()
                self._painter.draw(drawing, Target(whole, size, logical, ratio))
                buffer.release()
                drawn = buffer.toImage().convertToFormat(QImage.Format.Format_RGB32)
                smooth = drawn.scaled(
                    wide,
                    high,
                    Qt.AspectRatioMode.IgnoreAspectRatio,
                    Qt.TransformationMode.SmoothTransformation,
                )
                painter.drawImage(left, top, smooth)

    def frame(self) -> Frame:
        """Return the lines and labels about the lobes, in the theme's colours."""
        if self._frame is None:
            ink = self.palette().color(QPalette.ColorRole.Text)
            colour = (ink.redF(), ink.greenF(), ink.blueF(), 1.0)
            self._frame = frame_of(self.scene.light, self.scene.scale, self.scene.frame, colour)
        return self._frame

    def _drawing(self, size: QSize) -> Drawing:
        palette = self.palette()
        ground, ink = palette.color(QPalette.ColorRole.Base), palette.color(QPalette.ColorRole.Text)
        return Drawing(self.scene, self.frame(), self.camera, self.rooms(size), ground, ink, self.hot)

    def _paint_words(self, painter: QPainter, size: QSize) -> None:
        palette = self.palette()
        ink, paper = palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base)
        overlay = Overlay(painter, self.font(), QColor(ink), QColor(paper))
        rooms = self.rooms(size)
        labels = self.frame().labels
        everything = QRectF(0.0, 0.0, size.width(), size.height())
        taken = [] if self.scene.bar is None else [overlay.bar_room(self.scene.bar, everything)]
        for panel, room in zip(self.scene.panels, rooms, strict=False):
            matrix = self.to_clip(room)
            behind = self._behind(panel, [label.place for label in labels])
            overlay.labels(labels, partial(_projected, matrix, room=room), room, behind, taken)
            overlay.panel(panel, room, bordered=len(rooms) > 1)
        if self.scene.bar is not None:
            overlay.bar(self.scene.bar, everything)
        for room in rooms:
            probe = self._probe
            if probe is not None and probe.room == (room.left(), room.top()):
                x, y, z = (float(value) for value in probe.place)
                spot = self.project((x, y, z), room)
                if spot is not None:
                    overlay.probe(spot, self._probe_text, room)
        if not self.scene.panels:
            overlay.words(tr("No reflectance shown. Add one, or show one in the legend."), everything)

    def _behind(self, panel: Panel, places: list[tuple[float, float, float]]) -> list[bool]:
        """Which places a solid lobe of the panel hides."""
        result = np.zeros(len(places), bool)
        for layer in panel.layers:
            if layer.style == "solid" and layer.grid is not None and places:
                result |= hidden(layer.surface, layer.grid, self.camera.eye(), places)
        return [bool(value) for value in result]

    def changeEvent(self, event: object) -> None:
        super().changeEvent(event)
        self._frame = None  # its lines have the theme's colour
        self.update()

    def _forget(self) -> None:
        """Everything that was made in a context goes with it."""
        self._painter = None

    def _fail(self, error: Exception) -> None:
        if not isinstance(error, SuiteError):
            log.error("the view in three dimensions", exc_info=error)
        self._failure = tr("The lobes cannot be drawn: {reason}").format(reason=error)
        QTimer.singleShot(0, self, lambda: self.failed.emit(self._failure))


def _projected(matrix: QMatrix4x4, place: tuple[float, float, float], room: QRectF) -> QPointF | None:
    x, y, z = place
    row = matrix.row(3)
    if row.x() * x + row.y() * y + row.z() * z + row.w() <= 1e-4:
        return None
    at = matrix.map(QVector3D(x, y, z))
    return QPointF(
        room.left() + 0.5 * (at.x() + 1.0) * room.width(), room.top() + 0.5 * (1.0 - at.y()) * room.height()
    )
