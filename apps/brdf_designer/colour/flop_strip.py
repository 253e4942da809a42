"""The flop as one continuous strip, with grips that move it: L*, C* and h at either end, the flop index at the face."""

from __future__ import annotations

import math

from brdf_qt.fields.burst import Burst
from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import plain_tip, set_small
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QHelpEvent,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QWheelEvent,
)
from PySide6.QtWidgets import QToolTip, QWidget

from brdf_designer.colour.flop_grips import GRIPS, RADIUS, FlopOfPaint, centres, flop_of, paint_grip
from brdf_designer.colour.patches import GIVEN_SHARE, OUTSIDE_TIP, paint_corner
from brdf_designer.session.edits import SetFlop
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import Curves
from brdf_designer.window.caption import Caption
from brdf_suite.arrays import Bytes
from brdf_suite.documents.paint import Paint

_FRESH = (
    mark("Flop (target above, fit below)"),
    mark("Flop (target above, fit below)"),
    mark("Flop over the aspecular angle"),
    mark("Flop"),
)
_GRIPS_TIP = mark(
    "The grips change the flop about the face: L, C and h at either end the travel "
    "of lightness, chroma and hue, F the flop index. Drag one up or down, or "
    "choose one with Left and Right and move it with Up and Down (Shift: fine)."
)
_FINE = 0.1


class FlopStrip(QWidget):
    """The model's colour from the nearest to the farthest reading, marked where something was measured."""

    def __init__(self, session: PaintSession) -> None:
        super().__init__()
        self.caption = Caption(*map(tr, _FRESH))
        set_small(self.caption)
        self.band = Band(session)
        self._head: tuple[str, ...] = tuple(map(tr, _FRESH))
        # The active grip, or the strip.
        self.band.described.connect(lambda forms: self.caption.set_forms(*(forms or self._head)))
        fill_column(self, self.band, self.caption, None, spacing=4)

    def show_curves(self, curves: Curves) -> None:
        """Show the strip, fresh."""
        self._head = tuple(map(tr, _FRESH))
        self.band.show_curves(curves)
        self.band.describe()

    def mark_stale(self) -> None:
        """Say that the strip is of the last paint that could be."""
        self._head = (tr("Flop: last possible paint"),)
        self.band.describe()


class Band(QWidget):
    """The strip itself, with grips that edit the flop.

    ``described(forms)``: what a grip under the mouse, or of the keys, stands at; () for none.
    """

    described = Signal(tuple)

    def __init__(self, session: PaintSession) -> None:
        super().__init__()
        self._session = session
        self._image, self._given = QImage(), QImage()
        self._range = (15.0, 110.0)
        self._marks: tuple[float, ...] = ()
        self._outside = False
        self._paint: Paint | None = None
        self._opened: Paint | None = None
        self._known: tuple[Paint, FlopOfPaint | None] | None = None
        self._chosen = 0
        self._under: int | None = None
        self._grabbed: tuple[int, float, float] | None = None
        self.setFixedHeight(64)
        # Filled edge to edge, it is drawn without all that lies behind it.
        self.setAutoFillBackground(True)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setObjectName("flop_strip")
        self.setAccessibleName(tr("Flop strip"))
        self.setToolTip(tr(_GRIPS_TIP))
        self._burst = Burst(self)
        self._burst.started.connect(session.begin_gesture)
        self._burst.finished.connect(session.end_gesture)

    def show_paint(self, paint: Paint) -> None:
        """Let the grips move this paint."""
        self._paint = paint
        if self._under is not None or self.hasFocus():
            self.describe()

    def keep_opened(self) -> None:
        """Take the paint that is shown for what a double click goes back to."""
        self._opened = self._paint

    def show_curves(self, curves: Curves) -> None:
        """Show the colours."""
        self._image, self._given = _row(curves.strip_rgb), _row(curves.strip_given_rgb)
        self._range, self._marks = curves.measured_deg, curves.marks_deg
        outside = not bool(curves.strip_in_gamut.all())
        if outside != self._outside:
            self._outside = outside
            parts = (tr(OUTSIDE_TIP), tr(_GRIPS_TIP)) if outside else (tr(_GRIPS_TIP),)
            self.setToolTip(plain_tip("\n".join(parts)))
        self.update()

    def describe(self) -> None:
        """Draw the grips, and say what the active one, under the mouse or of the keys, stands at."""
        self.update()
        place = self._chosen if self.hasFocus() else None
        if self._grabbed is not None:
            place = self._grabbed[0]
        elif self._under is not None:
            place = self._under
        flop = self._flop()
        if place is None or flop is None:
            self.described.emit(())
            return
        forms = flop.describe(GRIPS[place])
        if self.accessibleDescription() != forms[0]:
            self.setAccessibleDescription(forms[0])
        self.described.emit(forms)

    def grip_at(self, point: QPointF) -> int | None:
        """Return the place in :data:`GRIPS` of the grip at a point of the strip."""
        if self._flop() is None:
            return None
        away = [math.dist((centre.x(), centre.y()), (point.x(), point.y())) for centre in self.grip_centres()]
        nearest = min(range(len(away)), key=away.__getitem__)  # in a narrow strip grips lie over each other
        return nearest if away[nearest] <= RADIUS + 1.5 else None

    def grip_centres(self) -> list[QPointF]:
        """Return where the grips stand, in the order of :data:`GRIPS`."""
        flop = self._flop()
        first, last = self._range
        face = 0.0 if flop is None else (flop.face_deg - first) / max(1e-9, last - first)
        band = self._band()
        return centres(band.adjusted(0, 0, 0, -GIVEN_SHARE * band.height()), face)

    def amount(self, place: int) -> float:
        """Return what a grip stands at; NaN where the paint has none of it."""
        flop = self._flop()
        return math.nan if flop is None else flop.amount(GRIPS[place])

    def _flop(self) -> FlopOfPaint | None:
        """The flop of the paint that is shown; worked out when it is asked for, and not in every edit."""
        if self._paint is None:
            return None
        if self._known is None or self._known[0] is not self._paint:
            self._known = (self._paint, flop_of(self._paint))
        return self._known[1]

    # The mouse.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        place = self.grip_at(event.position())
        if event.button() != Qt.MouseButton.LeftButton or place is None:
            event.ignore()
            return
        self._burst.end()
        self._choose(place)
        amount = self.amount(place)
        if math.isfinite(amount):
            self._grabbed = (place, event.globalPosition().y(), amount)
            self._session.begin_gesture()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._grabbed is None:
            self._hover(self.grip_at(event.position()))
            return
        place, start, amount = self._grabbed
        scale = _FINE if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        up = (start - event.globalPosition().y()) * scale
        self._session.edit(SetFlop(GRIPS[place].key, GRIPS[place].dragged(amount, up)))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self._grabbed is not None:
            self._grabbed = None
            self._session.end_gesture()
            self._hover(self.grip_at(event.position()))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        place = self.grip_at(event.position())
        if place is None or event.button() != Qt.MouseButton.LeftButton or self._opened is None:
            return
        opened = flop_of(self._opened)
        if opened is not None and math.isfinite(amount := opened.amount(GRIPS[place])):
            self._session.edit(SetFlop(GRIPS[place].key, amount))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Turn the chosen grip only with the focus, as every number does."""
        if self.hasFocus() and event.angleDelta().y():
            self._step(1.0 if event.angleDelta().y() > 0 else -1.0)
            event.accept()
        else:
            event.ignore()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._hover(None)

    def _hover(self, place: int | None) -> None:
        if place == self._under:
            return
        self._under = place
        if place is None:
            self.unsetCursor()
        else:
            self.setCursor(Qt.CursorShape.SizeVerCursor)
        self.describe()

    # The keyboard.

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose a grip by Left and Right, move it by Up and Down."""
        fine = _FINE if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        steps = {
            Qt.Key.Key_Up: fine,
            Qt.Key.Key_Down: -fine,
            Qt.Key.Key_PageUp: 10.0,
            Qt.Key.Key_PageDown: -10.0,
        }.get(Qt.Key(event.key()))
        side = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()))
        if steps is not None:
            self._step(steps)
        elif side is not None:
            self._burst.end()
            self._choose((self._chosen + side) % len(GRIPS))
        else:
            super().keyPressEvent(event)

    def _step(self, steps: float) -> None:
        grip, amount = GRIPS[self._chosen], self.amount(self._chosen)
        if math.isfinite(amount):
            self._burst.touch()
            self._session.edit(SetFlop(grip.key, grip.stepped(amount, steps)))

    def _choose(self, place: int) -> None:
        self._chosen = place
        self.describe()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.describe()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.end()
        super().focusOutEvent(event)
        self.describe()

    # Drawing.

    def event(self, event: QEvent) -> bool:
        """Show a tip for the grip under the mouse."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            place = self.grip_at(QPointF(event.pos()))
            if place is not None:
                QToolTip.showText(event.globalPos(), plain_tip(GRIPS[place].tip()), self)
                return True
        return super().event(event)

    def _band(self) -> QRectF:
        return QRectF(0, 0, self.width(), self.height() - self.fontMetrics().height() - 6)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        band = self._band()
        if self._image.isNull():
            painter.fillRect(band, self.palette().base())
            return
        row = QRectF(0.5, 0, self._image.width() - 1.0, 1)
        painter.drawImage(band, self._image, row)
        given = band.adjusted(0, round((1.0 - GIVEN_SHARE) * band.height()), 0, 0)
        painter.drawImage(given, self._given, row)
        if self._outside:
            paint_corner(painter, band)
        painter.setPen(self.palette().dark().color())
        painter.drawRect(band.adjusted(0, 0, -1, -1))
        self._paint_scale(painter, band)
        if self._flop() is not None:
            self._paint_grips(painter)

    def _paint_scale(self, painter: QPainter, band: QRectF) -> None:
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        first, last = self._range
        for angle in self._marks:
            part = (angle - first) / max(1e-9, last - first)
            x = part * (band.width() - 1)
            painter.drawLine(QPointF(x, band.bottom()), QPointF(x, band.bottom() + 4))
            label = f"{angle:g}°"
            width = self.fontMetrics().horizontalAdvance(label)
            left = min(max(0.0, x - width / 2), band.width() - width)
            painter.drawText(QPointF(left, self.height() - self.fontMetrics().descent() - 1.0), label)

    def _paint_grips(self, painter: QPainter) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        font = self.font()
        font.setPixelSize(11)
        font.setBold(True)
        painter.setFont(font)
        held = None if self._grabbed is None else self._grabbed[0]
        for place, centre in enumerate(self.grip_centres()):
            paint_grip(
                painter,
                centre,
                GRIPS[place],
                self.palette(),
                known=math.isfinite(self.amount(place)),
                near=place in (self._under, held),
                chosen=self.hasFocus() and place == self._chosen,
            )


def _row(codes: Bytes) -> QImage:
    count = len(codes)
    return QImage(codes.tobytes(), count, 1, 3 * count, QImage.Format.Format_RGB888).copy()
