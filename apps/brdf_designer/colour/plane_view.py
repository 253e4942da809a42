"""The plane of a* and b* as a disc: a handle for one reading, marks for the others, and a ring for all hues."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from brdf_qt.fields.burst import Burst
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QConicalGradient,
    QFocusEvent,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_suite.arrays import Bytes, Floats
from brdf_suite.paint_design.colour_plane import ColourPlane

SIDE = 204
"""Width and height, pixels."""
_RING, _GAP = 13.0, 5.0
_HANDLE, _MARK, _NEAR = 7.0, 4.0, 9.0
_FINE = 0.1
_STEP, _TURN_STEP = 0.5, 1.0
_DARK, _LIGHT = QColor(0, 0, 0, 220), QColor(255, 255, 255, 235)
_BRIGHT = 62.0
"""L* of a plane on which lines are dark."""
_TIP = mark(
    "a* to the right, b* up, at the L* of the reading. Drag the handle, or move it with the arrow keys (Shift: fine); "
    "a click on a mark goes to that angle, as Page Up and Page Down do. The ring turns the hue of all angles, as "
    "Ctrl+Left and Ctrl+Right do."
)


@dataclass(frozen=True)
class PlaneMark:
    """A reading in the plane: its index in the document, its angle in words, a*, b*, sRGB code."""

    index: int
    text: str
    a: float
    b: float
    rgb: tuple[int, int, int]


class PlaneView(QWidget):
    """Draws and is dragged; it knows no paint.

    Signals: ``moved(index, a, b)`` and ``turned(degrees)`` since the gesture began, between ``gesture_started`` and
    ``gesture_finished``; ``chosen(index)`` of a mark that is to be the handle.
    """

    moved = Signal(int, float, float)
    turned = Signal(float)
    chosen = Signal(int)
    gesture_started = Signal()
    gesture_finished = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("colour_plane")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setToolTip(plain_tip(tr(_TIP)))
        self.setMouseTracking(True)
        # Filled, it is drawn without all that lies behind it.
        self.setAutoFillBackground(True)
        self._marks: tuple[PlaneMark, ...] = ()
        self._index = 0
        self._most = 100.0
        self._image = QImage()
        self._gamut: list[QLineF] = []
        self._reachable: list[QLineF] = []
        self._hues: list[QColor] = []
        self._ink = _LIGHT
        self._ring: QPixmap | None = None
        self._ground: QPixmap | None = None
        self._held: QPointF | None = None
        self._grip = QPointF()
        self._turning: float | None = None
        self._turn = 0.0
        self._burst = Burst(self)
        self._burst.started.connect(self._begin_keys)
        self._burst.finished.connect(self.gesture_finished)

    # What is shown.

    @property
    def is_held(self) -> bool:
        """Whether a gesture of the mouse or the keys goes on."""
        return self._held is not None or self._turning is not None or self._burst.is_running

    def show_plane(self, plane: ColourPlane, lightness: float, most_chroma: float) -> None:
        """Show the colours of an L* out to a chroma, and the lines in them."""
        self._ink = _DARK if lightness > _BRIGHT else _LIGHT
        codes = plane.codes
        tall, wide = codes.shape[:2]
        self._image = QImage(codes.tobytes(), wide, tall, 3 * wide, QImage.Format.Format_RGB888).copy()
        self._most = most_chroma
        self._gamut = _lines(plane.gamut)
        self._reachable = [] if plane.reachable is None else _lines(plane.reachable)
        self._ground = None
        self.update()

    def show_hues(self, codes: Bytes) -> None:
        """Colour the ring: codes (n, 3) from 0° in equal steps."""
        self._hues = [QColor(*code) for code in codes.tolist()]
        self._ring = self._ground = None
        self.update()

    def show_marks(self, marks: tuple[PlaneMark, ...], index: int) -> None:
        """Show the readings in the order of their angles; ``index`` is the one with the handle."""
        if (marks, index) == (self._marks, self._index):
            return
        self._marks, self._index = marks, index
        now = self._handle()
        if now is not None:
            name = tr("Chroma and hue at {angle}").format(angle=now.text)
            if name != self.accessibleName():
                self.setAccessibleName(name)
        self.update()

    # Where things are.

    def point_of(self, a: float, b: float) -> QPointF:
        """Return where a colour of the plane lies."""
        middle, scale = QRectF(self.rect()).center(), self._radius() / self._most
        return QPointF(middle.x() + scale * a, middle.y() - scale * b)

    def ring_point(self, degrees: float) -> QPointF:
        """Return where a hue lies on the ring."""
        middle, radius = QRectF(self.rect()).center(), self._radius() + _GAP + 0.5 * _RING
        angle = math.radians(degrees)
        return QPointF(middle.x() + radius * math.cos(angle), middle.y() - radius * math.sin(angle))

    def _radius(self) -> float:
        return 0.5 * min(self.width(), self.height()) - _RING - _GAP - 1.0

    def _handle(self) -> PlaneMark | None:
        return next((one for one in self._marks if one.index == self._index), None)

    def _colour_at(self, point: QPointF) -> tuple[float, float]:
        """a* and b* of a point, those beyond the disc moved to its edge."""
        middle, scale = QRectF(self.rect()).center(), self._most / self._radius()
        a, b = scale * (point.x() - middle.x()), scale * (middle.y() - point.y())
        chroma = math.hypot(a, b)
        shrink = min(1.0, self._most / chroma) if chroma > 0.0 else 1.0
        return round(shrink * a, 2), round(shrink * b, 2)

    def _hue_at(self, point: QPointF) -> float:
        middle = QRectF(self.rect()).center()
        return math.degrees(math.atan2(middle.y() - point.y(), point.x() - middle.x()))

    def _on_ring(self, point: QPointF) -> bool:
        middle = QRectF(self.rect()).center()
        return math.hypot(point.x() - middle.x(), point.y() - middle.y()) > self._radius() + 0.5 * _GAP

    # The mouse.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton or not self._marks:
            event.ignore()
            return
        self._burst.end()
        point = event.position()
        if self._on_ring(point):
            self._turning, self._turn = self._hue_at(point), 0.0
            self.gesture_started.emit()
            return
        near = [
            (QLineF(self.point_of(one.a, one.b), point).length(), one.index != self._index, one)
            for one in self._marks
        ]
        away, _, nearest = min(near, key=lambda one: one[:2])
        if away <= _NEAR and nearest.index != self._index:
            self.chosen.emit(nearest.index)
        self.gesture_started.emit()
        handle = self._handle()
        assert handle is not None
        if away <= _NEAR:
            self._held = self.point_of(handle.a, handle.b) - point
        else:
            self._held = QPointF(0.0, 0.0)
            self.moved.emit(self._index, *self._colour_at(point))
        self._grip = point

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        point = event.position()
        fine = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if self._turning is not None:
            now = self._hue_at(point)
            step = (now - self._turning + 180.0) % 360.0 - 180.0
            self._turning = now
            self._turn += _FINE * step if fine else step
            self.turned.emit(round(self._turn, 2))
        elif self._held is not None:
            if fine:
                # The rest of the way is taken back from what is held.
                self._held -= (point - self._grip) * (1.0 - _FINE)
            self._grip = point
            self.moved.emit(self._index, *self._colour_at(point + self._held))
        else:
            on_ring = self._on_ring(point)
            self.setCursor(Qt.CursorShape.OpenHandCursor if on_ring else Qt.CursorShape.CrossCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        if self._held is not None or self._turning is not None:
            self._held = self._turning = None
            self.gesture_finished.emit()

    # The keyboard.

    def keyPressEvent(self, event: QKeyEvent) -> None:
        keys = Qt.Key
        ways = {keys.Key_Left: (-1, 0), keys.Key_Right: (1, 0), keys.Key_Up: (0, 1), keys.Key_Down: (0, -1)}
        way, key = ways.get(Qt.Key(event.key())), Qt.Key(event.key())
        fine = _FINE if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        handle = self._handle()
        if handle is None or (way is None and key not in (keys.Key_PageUp, keys.Key_PageDown)):
            super().keyPressEvent(event)
        elif way is None:
            self._burst.end()
            place = self._marks.index(handle) + (1 if key == keys.Key_PageDown else -1)
            self.chosen.emit(self._marks[place % len(self._marks)].index)
        elif event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            if way[0]:
                self._burst.touch()
                # Counter-clockwise as on the disc: Left turns towards greater hues.
                self._turn -= way[0] * fine * _TURN_STEP
                self.turned.emit(round(self._turn, 2))
        else:
            self._burst.touch()
            a, b = handle.a + way[0] * fine * _STEP, handle.b + way[1] * fine * _STEP
            self.moved.emit(self._index, round(a, 2), round(b, 2))

    def _begin_keys(self) -> None:
        self._turn = 0.0
        self.gesture_started.emit()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.end()
        super().focusOutEvent(event)
        self.update()

    # Drawing.

    def sizeHint(self) -> QSize:
        return QSize(SIDE, SIDE)

    def minimumSizeHint(self) -> QSize:
        return QSize(SIDE, SIDE)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._ring = self._ground = None

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        # The disc and its lines stay while the handle moves, the ring while the disc is of another L*.
        ratio = self.devicePixelRatioF()
        if self._ring is None or self._ring.devicePixelRatioF() != ratio:
            self._ring, self._ground = self._draw(ratio, self._paint_ring), None
        if self._ground is None:
            self._ground = self._draw(ratio, self._paint_disc)
        painter.drawPixmap(0, 0, self._ring)
        painter.drawPixmap(0, 0, self._ground)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_marks(painter)

    def _draw(self, ratio: float, paint: Callable[[QPainter], None]) -> QPixmap:
        picture = QPixmap(self.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(Qt.GlobalColor.transparent)
        painter = QPainter(picture)
        hints = QPainter.RenderHint
        painter.setRenderHints(hints.Antialiasing | hints.SmoothPixmapTransform)
        paint(painter)
        painter.end()
        return picture

    def _paint_disc(self, painter: QPainter) -> None:
        middle, radius = QRectF(self.rect()).center(), self._radius()
        disc = QRectF(middle.x() - radius, middle.y() - radius, 2.0 * radius, 2.0 * radius)
        edge = QPainterPath()
        edge.addEllipse(disc)
        painter.setClipPath(edge)
        if self._image.isNull():
            painter.fillRect(disc, self.palette().base())
        else:
            # The outermost points of the lattice lie on the edge.
            inner = QRectF(0.5, 0.5, self._image.width() - 1.0, self._image.height() - 1.0)
            painter.drawImage(disc, self._image, inner)
        painter.save()
        painter.translate(middle)
        scale = radius / self._most
        painter.scale(scale, -scale)
        faint = QColor(self._ink)
        faint.setAlpha(50)
        painter.setPen(_pen(faint, 1.0))
        painter.drawLines(
            [QLineF(-self._most, 0.0, self._most, 0.0), QLineF(0.0, -self._most, 0.0, self._most)]
        )
        for lines, width in ((self._gamut, 1.0), (self._reachable, 2.4)):
            painter.setPen(_pen(self._ink, width))
            painter.drawLines(lines)
        painter.restore()
        painter.setClipping(False)
        painter.setPen(QPen(self.palette().dark().color(), 1.0))
        painter.drawEllipse(disc)

    def _paint_ring(self, painter: QPainter) -> None:
        middle, inner = QRectF(self.rect()).center(), self._radius() + _GAP
        ring = QPainterPath()
        for radius in (inner, inner + _RING):
            ring.addEllipse(middle, radius, radius)
        gradient = QConicalGradient(middle, 0.0)
        for place, colour in enumerate((*self._hues, *self._hues[:1])):
            gradient.setColorAt(place / len(self._hues), colour)
        painter.fillPath(ring, gradient if self._hues else self.palette().base())

    def _paint_marks(self, painter: QPainter) -> None:
        points = [self.point_of(one.a, one.b) for one in self._marks]
        painter.setPen(QPen(self._ink, 1.2))
        painter.drawPolyline(points)
        font = self.font()
        font.setPixelSize(10)
        painter.setFont(font)
        for one, point in zip(self._marks, points, strict=True):
            if math.hypot(one.a, one.b) > 0.5:
                place = self.ring_point(math.degrees(math.atan2(one.b, one.a)))
                _paint_dot(painter, place, _HANDLE - 1.0 if one.index == self._index else 2.5, one.rgb, _DARK)
            if one.index != self._index:
                _paint_dot(painter, point, _MARK, one.rgb, self._ink)
        self._paint_names(painter, points)
        handle = self._handle()
        if handle is not None:
            point = self.point_of(handle.a, handle.b)
            if self.hasFocus():
                painter.setPen(QPen(self.palette().highlight().color(), 3.0))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawEllipse(point, _HANDLE + 3.5, _HANDLE + 3.5)
            _paint_dot(painter, point, _HANDLE, handle.rgb, self._ink)

    def _paint_names(self, painter: QPainter, points: list[QPointF]) -> None:
        """Write the angle beside each mark but the handle, on the first side where nothing else lies."""
        metrics = painter.fontMetrics()
        taken = [_square(point, _HANDLE + 1.0) for point in points]
        painter.setPen(self._ink)
        for own, (one, point) in enumerate(zip(self._marks, points, strict=True)):
            if one.index == self._index:
                continue
            size = QSizeF(metrics.horizontalAdvance(one.text), metrics.ascent())
            places = [QRectF(point + corner, size) for corner in _corners(size)]
            others = [rect for number, rect in enumerate(taken) if number != own]
            free = [place for place in places if not any(place.intersects(other) for other in others)]
            if free:
                taken.append(free[0])
                painter.drawText(free[0].bottomLeft(), one.text)


def _square(middle: QPointF, half: float) -> QRectF:
    return QRectF(middle.x() - half, middle.y() - half, 2.0 * half, 2.0 * half)


def _corners(size: QSizeF) -> list[QPointF]:
    """Return where a text may begin beside a mark at the origin: right above and below, left above and below."""
    right, left = _MARK + 2.0, -_MARK - 2.0 - size.width()
    above, below = -_MARK - size.height(), _MARK
    return [QPointF(x, y) for x in (right, left) for y in (above, below)]


def _paint_dot(
    painter: QPainter, place: QPointF, radius: float, rgb: tuple[int, int, int], edge: QColor
) -> None:
    painter.setBrush(QColor(*rgb))
    painter.setPen(QPen(edge, 1.8))
    painter.drawEllipse(place, radius, radius)


def _pen(colour: QColor, width: float) -> QPen:
    pen = QPen(colour, width)
    pen.setCosmetic(True)
    pen.setCapStyle(Qt.PenCapStyle.SquareCap)  # a third of the time of round ones
    return pen


def _lines(segments: Floats) -> list[QLineF]:
    return [QLineF(*line) for line in segments.reshape(-1, 4).tolist()]
