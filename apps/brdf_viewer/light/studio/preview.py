"""The studio as a panorama: what the middle of the scene sees all around, with its lamps to click and to drag."""

from __future__ import annotations

import numpy as np
from brdf_qt.program.translation import tr
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QPolygonF,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, srgb_encode
from brdf_suite.documents.studio import LightDocument, Sky, Studio
from brdf_suite.geometry.polar import point_at, polar
from brdf_viewer.light.studio.places import (
    covers,
    outline,
    panorama_direction,
    panorama_place,
)

_COLUMNS = 512
_REACH_PX = 10.0
_STEPS_DEG = {
    Qt.Key.Key_Left: (1.0, 0.0),
    Qt.Key.Key_Right: (-1.0, 0.0),
    Qt.Key.Key_Up: (0.0, 1.0),
    Qt.Key.Key_Down: (0.0, -1.0),
}
_NOTCH = 120.0


class StudioPreview(QWidget):
    """Twice as wide as high; in front (+z) is the middle.

    Signals
    -------
    picked(index)
        A lamp was clicked; -1 for none. A sky's sun is 0.
    dragged(index, azimuth_deg, elevation_deg)
        It is pulled, or moved by the arrow keys.
    scaled(index, factor)
        The wheel was turned over it.
    gesture_started(), gesture_finished()
        Around a drag.
    """

    picked = Signal(int)
    dragged = Signal(int, float, float)
    scaled = Signal(int, float)
    gesture_started = Signal()
    gesture_finished = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._light: LightDocument | None = None
        self.panorama = QImage()
        self._outlines: list[NDArray[np.float64]] = []
        self._middles: list[NDArray[np.float64]] = []
        self._chosen = -1
        self._held = -1
        self._offset = QPointF()
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(tr("Panorama of the studio"))
        self.setToolTip(
            tr(
                "Full panorama, front at the centre. Click a lamp to select it, drag it to move it, turn the wheel "
                "over it to resize it, arrow keys move it by 1°"
            )
        )

    def set_light(self, light: LightDocument) -> None:
        """Show where the lamps are; the picture behind them follows when it is drawn."""
        if isinstance(self._light, Studio) != isinstance(light, Studio):
            self.panorama = QImage()
        self._light = light
        lamps = light.lamps if isinstance(light, Studio) else ()
        self._outlines = [panorama_place(outline(lamp)) for lamp in lamps]
        self._middles = [panorama_place(np.array(lamp.position_m)) for lamp in lamps]
        if isinstance(light, Sky) and light.model != "overcast":
            sun = point_at(light.sun_azimuth_deg, light.sun_elevation_deg, 1.0)
            self._middles = [panorama_place(np.array(sun))]
        self.update()

    def set_radiance(self, radiance: NDArray[np.float32]) -> None:
        """Show the light itself, (h, w, 3) of the working space."""
        step = max(1, radiance.shape[1] // _COLUMNS)
        rho = radiance[::step, ::step].astype(np.float64)
        bright = rho.max(axis=-1, keepdims=True)
        rho = rho / (1.0 + np.maximum(bright - 0.6, 0.0))  # bright lamps keep their colour
        codes = np.round(255.0 * srgb_encode(np.clip(rho @ WORKING_TO_SRGB.T, 0.0, 1.0))).astype(np.uint8)
        height, width = codes.shape[:2]
        # A copy, because the image does not keep the array alive.
        self.panorama = QImage(codes.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888).copy()
        self.update()

    def set_chosen(self, index: int) -> None:
        """Mark a lamp; -1 marks none."""
        if index != self._chosen:
            self._chosen = index
            self.update()

    def sizeHint(self) -> QSize:
        return QSize(320, 160)

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        return width // 2

    def place_of(self, index: int) -> QPointF:
        """Return where the middle of a lamp, or the sun, is in the widget."""
        return self._point(self._middles[index])

    def lamp_at(self, position: QPointF) -> int:
        """Return the lamp under a place of the widget, the nearest in front of others; -1 where there is none."""
        toward = self._toward(position)
        lamps = self._light.lamps if isinstance(self._light, Studio) else ()
        hit = [index for index, lamp in enumerate(lamps) if covers(lamp, toward)]
        if hit:
            return min(hit, key=lambda index: polar(lamps[index].position_m)[2])
        near = [
            (float(np.hypot(point.x() - position.x(), point.y() - position.y())), index)
            for index, point in enumerate(map(self._point, self._middles))
        ]
        distance, index = min(near, default=(np.inf, -1))
        return index if distance <= _REACH_PX else -1

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        index = self.lamp_at(event.position())
        self.picked.emit(index)
        if index < 0:
            return
        self._held = index
        self._offset = self.place_of(index) - event.position()
        self.gesture_started.emit()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held < 0:
            over = self.lamp_at(event.position()) >= 0
            self.setCursor(Qt.CursorShape.OpenHandCursor if over else Qt.CursorShape.ArrowCursor)
            return
        self.setCursor(Qt.CursorShape.ClosedHandCursor)
        self._drag(self._held, self._toward(event.position() + self._offset))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self._held >= 0:
            self._held = -1
            self.unsetCursor()
            self.gesture_finished.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        index = self.lamp_at(event.position())
        if index < 0 or not isinstance(self._light, Studio) or not self.hasFocus():
            event.ignore()  # the panel scrolls
            return
        self.scaled.emit(index, 1.05 ** (event.angleDelta().y() / _NOTCH))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = _STEPS_DEG.get(Qt.Key(event.key()))
        if step is None or not 0 <= self._chosen < len(self._middles):
            super().keyPressEvent(event)
            return
        toward = panorama_direction(*(float(value) for value in self._middles[self._chosen]))
        self._drag(self._chosen, toward, *step)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        area, palette = QRectF(self.rect()), self.palette()
        if self.panorama.isNull():
            painter.fillRect(area, palette.color(QPalette.ColorRole.Base))
        else:
            painter.drawImage(area, self.panorama)
        for index, middle in enumerate(self._middles):
            chosen = index == self._chosen
            line = palette.color(QPalette.ColorRole.Highlight) if chosen else QColor(255, 255, 255)
            # Dark under light: seen on a lamp as on a wall.
            for width, colour in (
                (3.5 if chosen else 2.5, QColor(0, 0, 0, 160)),
                (2.0 if chosen else 1.0, line),
            ):
                painter.setPen(QPen(colour, width))
                if index < len(self._outlines):
                    self._draw_outline(painter, self._outlines[index])
                else:
                    painter.drawEllipse(self._point(middle), 7.0, 7.0)
        if self.hasFocus():
            painter.setPen(QPen(palette.color(QPalette.ColorRole.Highlight), 1.0))
            painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5))

    def _draw_outline(self, painter: QPainter, places: NDArray[np.float64]) -> None:
        """Draw a lamp's edge; what crosses the picture's sides, behind the scene, is left open there."""
        piece = QPolygonF()
        closed = np.concatenate([places, places[:1]])
        for place, jump in zip(
            closed, np.abs(np.diff(closed[:, 0], prepend=closed[0, 0])) > 0.5, strict=True
        ):
            if jump:
                painter.drawPolyline(piece)
                piece = QPolygonF()
            piece.append(self._point(place))
        painter.drawPolyline(piece)

    def _drag(self, index: int, toward: NDArray[np.float64], around: float = 0.0, up: float = 0.0) -> None:
        azimuth, elevation, _ = polar((float(toward[0]), float(toward[1]), float(toward[2])))
        self.dragged.emit(index, azimuth + around, min(89.0, max(-89.0, elevation + up)))

    def _point(self, place: NDArray[np.float64]) -> QPointF:
        return QPointF(float(place[0]) * self.width(), float(place[1]) * self.height())

    def _toward(self, position: QPointF) -> NDArray[np.float64]:
        across = position.x() / max(1, self.width())
        down = min(1.0, max(0.0, position.y() / max(1, self.height())))
        return panorama_direction(across, down)
