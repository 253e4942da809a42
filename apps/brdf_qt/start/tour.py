"""The tour: a few callouts that point at parts of the window, one at a time. Nothing waits for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPainterPath, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QMainWindow, QPushButton, QWidget

from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel, set_bold
from brdf_qt.program.translation import tr

_WIDTH = 330
_ARROW = 14
_ROUND = 8.0
_GAP = 4


@dataclass(frozen=True)
class TourStep:
    """A part of the window, what is said of it, and what brings it in sight."""

    target: QWidget
    title: str
    text: str
    reveal: Callable[[], object] = lambda: None


class Tour(QObject):
    """Shows one callout after the other in ``window``; it ends with the last, or when the user leaves it."""

    def __init__(self, window: QMainWindow, steps: Sequence[TourStep]) -> None:
        super().__init__(window)
        self._window, self._steps = window, list(steps)
        self.callout: Callout | None = None

    @property
    def is_running(self) -> bool:
        """Whether a callout is shown."""
        return self.callout is not None

    def show_step(self, number: int) -> None:
        """Show the callout of a step; past the last one the tour is over."""
        self.leave()
        if not 0 <= number < len(self._steps):
            return
        step = self._steps[number]
        step.reveal()
        callout = self.callout = Callout(self._window, step, number + 1, len(self._steps))
        callout.next.clicked.connect(lambda: self.show_step(number + 1))
        callout.back.clicked.connect(lambda: self.show_step(number - 1))
        callout.end.clicked.connect(self.leave)
        callout.show()
        callout.next.setFocus()

    def leave(self) -> None:
        """End the tour where it is."""
        if self.callout is not None:
            self.callout.hide()
            self.callout.deleteLater()
            self.callout = None


class Callout(QWidget):
    """A box with an arrow to a part of the window; the part can be used meanwhile."""

    def __init__(self, window: QMainWindow, step: TourStep, number: int, count: int) -> None:
        super().__init__(window)
        self.setObjectName("tour_callout")
        self._target = step.target
        self._tip = QPoint()
        title = PlainLabel(step.title)
        set_bold(title, True)
        text = PlainLabel(step.text, wordWrap=True)
        place = PlainLabel(tr("{number} of {count}").format(number=number, count=count))
        self.end = described(QPushButton(tr("Leave the Tour")), name="tour_leave")
        self.back = described(QPushButton(tr("Back")), name="tour_back")
        self.back.setVisible(number > 1)
        self.next = described(QPushButton(tr("Next") if number < count else tr("Finish")), name="tour_next")
        self.end.setVisible(number < count)
        for button in (self.end, self.back, self.next):
            button.setAutoDefault(True)
        row = row_of(place, None, self.end, self.back, self.next, spacing=6)
        margin = _ARROW + 12
        self._column = fill_column(
            self, title, text, row, spacing=8, margins=(margin, margin, margin, margin)
        )
        for widget in (window, self._target):
            widget.installEventFilter(self)
        self.setAccessibleName(f"{step.title}. {step.text}")
        self._settle()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.LayoutRequest):
            self._settle()
        return super().eventFilter(watched, event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.end.click()
            return
        super().keyPressEvent(event)

    def _settle(self) -> None:
        """Stand beside the target where there is room, at least within the window, and point at it."""
        window = self.window()
        corner = self._target.mapTo(window, QPoint(0, 0))
        target = QRect(corner, self._target.size())
        width = min(_WIDTH + 2 * _ARROW, window.width())
        size = QRect(0, 0, width, self._column.heightForWidth(width))
        room = window.rect()
        size.moveCenter(target.center())
        if target.width() > size.width() and target.height() > size.height():
            size.moveBottom(target.center().y())
            tip = target.center() + QPoint(0, _ARROW)
        elif target.bottom() + size.height() <= room.bottom():
            size.moveTop(target.bottom() + _GAP)
            tip = QPoint(target.center().x(), target.bottom() + _GAP)
        else:
            size.moveBottom(target.top() - _GAP)
            tip = QPoint(target.center().x(), target.top() - _GAP)
        size.moveLeft(max(room.left(), min(size.left(), room.right() - size.width())))
        size.moveTop(max(room.top(), min(size.top(), room.bottom() - size.height())))
        self.setGeometry(size)
        self._tip = tip - size.topLeft()
        self.raise_()
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        box = QRectF(self.rect()).adjusted(_ARROW, _ARROW, -_ARROW, -_ARROW)
        shape = QPainterPath()
        shape.addRoundedRect(box, _ROUND, _ROUND)
        x = min(max(float(self._tip.x()), box.left() + 24.0), box.right() - 24.0)
        above = self._tip.y() <= self.height() // 2
        edge, end = (box.top() + 1.0, 1.0) if above else (box.bottom() - 1.0, self.height() - 1.0)
        arrow = QPainterPath(QPointF(x - _ARROW, edge))
        arrow.lineTo(QPointF(x, end))
        arrow.lineTo(QPointF(x + _ARROW, edge))
        arrow.closeSubpath()
        colours = self.palette()
        painter.setBrush(colours.color(QPalette.ColorRole.Base))
        painter.setPen(QPen(colours.color(QPalette.ColorRole.Accent), 1.5))
        painter.drawPath(shape.united(arrow))
