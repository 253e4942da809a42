"""What is shown while no session is open: a sketch of the rig from above, what to photograph, and how to begin."""

from __future__ import annotations

import math

from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import tr
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette, QPen, QPolygonF
from PySide6.QtWidgets import QPushButton, QWidget

_LAMP_DEG = 55.0
_LAMPS_DEG = tuple(range(0, 181, 20))
_SPHERE = 0.26
"""Radius of the sphere over that of the lamp's way."""
_MARGIN_PX = 44


class RigSketch(QWidget):
    """The rig from above: sphere, camera, and the lamp on its way from the camera round to the far side."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        words = tr(
            "Sketch of the rig from above: a painted sphere in the middle, a fixed camera, and a lamp that "
            "moves around the sphere from 0° at the camera to 180°"
        )
        described(self, name="rig_sketch", spoken=words)
        self.setMinimumSize(280, 220)

    def sizeHint(self) -> QSize:
        return QSize(560, 360)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        colours = self.palette()
        ink = colours.color(QPalette.ColorRole.WindowText)
        soft = colours.color(QPalette.ColorRole.PlaceholderText)
        room = QRectF(self.rect()).adjusted(_MARGIN_PX, _MARGIN_PX, -_MARGIN_PX, -_MARGIN_PX)
        # A half circle above, its diameter from the camera at the left to the far side at the right.
        reach = max(40.0, min(0.5 * room.width(), room.height() / (1.0 + _SPHERE)))
        middle = QPointF(room.center().x(), room.top() + reach)

        def at(degrees: float, share: float) -> QPointF:
            turn = math.radians(degrees)
            return middle + QPointF(-math.cos(turn), -math.sin(turn)) * (share * reach)

        painter.setPen(QPen(soft, 1.2, Qt.PenStyle.DashLine))
        box = QRectF(middle.x() - reach, middle.y() - reach, 2.0 * reach, 2.0 * reach)
        painter.drawArc(box, 0, 180 * 16)
        painter.setBrush(soft)
        painter.setPen(Qt.PenStyle.NoPen)
        for degrees in _LAMPS_DEG:
            painter.drawEllipse(at(degrees, 1.0), 2.5, 2.5)
        self._sphere(painter, middle, reach, at(_LAMP_DEG, 1.0), ink)
        # The axis of the camera, and the ray of the lamp; between them the angle that session.json states.
        painter.setPen(QPen(soft, 1.2))
        painter.drawLine(at(0.0, 0.95), at(0.0, _SPHERE))
        lit = QColor("#e0b030")
        painter.setPen(QPen(lit, 1.8))
        painter.drawLine(at(_LAMP_DEG, 0.94), at(_LAMP_DEG, _SPHERE + 0.02))
        painter.setPen(QPen(ink, 1.4))
        small = QRectF(box)
        small.setSize(box.size() * 0.52)
        small.moveCenter(middle)
        painter.drawArc(small, 180 * 16, -round(_LAMP_DEG * 16))
        self._text(painter, at(0.5 * _LAMP_DEG, 0.62), "θ", ink)
        self._camera(painter, at(0.0, 1.0), ink)
        painter.setPen(QPen(ink, 1.4))
        painter.setBrush(lit)
        painter.drawEllipse(at(_LAMP_DEG, 1.0), 8.0, 8.0)
        line = painter.fontMetrics().height()
        words = tr("Lamp, moved in steps")
        beside = QPointF(0.5 * painter.fontMetrics().horizontalAdvance(words) + 14.0, 10.0)
        self._text(painter, at(_LAMP_DEG, 1.0) - beside, words, ink)
        self._text(painter, at(0.0, 1.0) + QPointF(0.0, 26.0), tr("Camera, fixed"), ink)
        self._text(painter, middle + QPointF(0.0, _SPHERE * reach + line), tr("Painted sphere"), ink)
        self._text(painter, at(180.0, 1.0) + QPointF(0.0, 20.0), "180°", soft)
        self._text(painter, at(0.0, 1.0) - QPointF(32.0, 0.0), "0°", soft)

    def _sphere(self, painter: QPainter, middle: QPointF, reach: float, lamp: QPointF, ink: QColor) -> None:
        """Draw the sphere, light where the lamp shines."""
        radius = _SPHERE * reach
        painter.setPen(QPen(ink, 1.4))
        painter.setBrush(QColor(120, 124, 130))
        painter.drawEllipse(middle, radius, radius)
        way = lamp - middle
        length = math.hypot(way.x(), way.y())
        spot = middle + way * (0.55 * radius / length)
        painter.setPen(Qt.PenStyle.NoPen)
        for share, grey in ((0.42, 160), (0.26, 200), (0.12, 245)):
            painter.setBrush(QColor(grey, grey, grey))
            painter.drawEllipse(spot, share * radius, share * radius)

    def _camera(self, painter: QPainter, at: QPointF, ink: QColor) -> None:
        painter.setPen(QPen(ink, 1.4))
        painter.setBrush(self.palette().color(QPalette.ColorRole.Button))
        painter.drawRoundedRect(QRectF(at.x() - 18.0, at.y() - 10.0, 24.0, 20.0), 3.0, 3.0)
        nose = [QPointF(6.0, -5.0), QPointF(15.0, -8.0), QPointF(15.0, 8.0), QPointF(6.0, 5.0)]
        painter.drawPolygon(QPolygonF([at + point for point in nose]))

    def _text(self, painter: QPainter, at: QPointF, text: str, colour: QColor) -> None:
        """Write a text around a point, moved so that all of it is seen."""
        metrics = painter.fontMetrics()
        box = QRectF(0.0, 0.0, metrics.horizontalAdvance(text) + 2.0, metrics.height())
        box.moveCenter(at)
        box.moveLeft(min(max(0.0, box.left()), self.width() - box.width()))
        painter.setPen(colour)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


class StartPage(QWidget):
    """Signals: ``open_requested()``, ``template_requested()``, ``sample_requested()``."""

    open_requested = Signal()
    template_requested = Signal()
    sample_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.sketch = RigSketch()
        centred = Qt.AlignmentFlag.AlignCenter
        text = PlainLabel(
            tr(
                "Photograph a painted sphere under a lamp that moves around it, several exposures at each "
                "position. Open the folder of the photographs, or try the steps with simulated ones."
            ),
            wordWrap=True,
            alignment=centred,
        )
        tip = tr("Open a folder with a session.json")
        self.open = described(QPushButton(tr("Open Folder…")), name="start_open", tip=tip)
        tip = tr("Create a folder with a session.json template for new photographs")
        self.new = described(QPushButton(tr("New Folder…")), name="start_new", tip=tip)
        tip = tr(
            "Simulate photographs of a blue metallic sphere and take all steps with them; about half a minute"
        )
        self.sample = described(QPushButton(tr("Try a Simulated Session")), name="start_sample", tip=tip)
        self.open.setDefault(True)
        self.open.clicked.connect(self.open_requested)
        self.new.clicked.connect(self.template_requested)
        self.sample.clicked.connect(self.sample_requested)
        buttons = row_of(None, self.open, self.new, self.sample, None, spacing=8)
        fill_column(self, self.sketch, text, buttons, grows=self.sketch, spacing=12, margins=(24, 16, 24, 24))
