"""A picture that takes the window: zoomed by the wheel, moved by a drag, with marks over it.

F frames it, + and − zoom, the arrow keys move it. ``hovered(x, y)`` gives the pixel under the cursor, in the picture's
own pixels; ``left_picture()`` that there is none.
"""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QResizeEvent,
    QTransform,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_designer.acquire.plots.marks import Mark, draw_legend, draw_mark

_LEAST, _MOST = 0.02, 64.0
_STEP = 1.25
_ROOM = 8.0
_WHEEL = 240.0


class PictureView(QWidget):
    """One picture and its marks; without one, ``empty_text``."""

    hovered = Signal(float, float)
    left_picture = Signal()

    def __init__(self, name: str, empty_text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 120)
        self.setToolTip(tr("Wheel, + and − zoom; middle drag, Shift drag and the arrow keys pan; F frames"))
        self._empty = empty_text
        self.image = QImage()
        """What is shown; null while there is none."""
        self.marks: tuple[Mark, ...] = ()
        self.scale = 1.0
        """Points of the screen for a pixel of the picture."""
        self._centre = QPointF()
        self._framed = True
        self._grip: QPointF | None = None

    def sizeHint(self) -> QSize:
        return QSize(480, 360)

    def show_empty(self, text: str) -> None:
        """Show no picture, and say why."""
        self._empty, self.image, self.marks = text, QImage(), ()
        self.setAccessibleDescription(text)
        self.update()

    def show_image(self, image: QImage) -> None:
        """Show another picture; one of the same size stays where it is on the screen."""
        new_size = image.size() != self.image.size()
        self.image = image
        if new_size:
            self.frame()
        self.update()

    def show_marks(self, marks: Sequence[Mark]) -> None:
        """Draw these over the picture."""
        self.marks = tuple(marks)
        self.setAccessibleDescription("; ".join(mark.name for mark in marks if mark.name))
        self.update()

    # Where it is.

    @property
    def to_screen(self) -> QTransform:
        """From pixels of the picture to points of the widget."""
        middle = QPointF(self.width() / 2.0, self.height() / 2.0)
        found = QTransform.fromTranslate(middle.x(), middle.y())
        found.scale(self.scale, self.scale)
        return found.translate(-self._centre.x(), -self._centre.y())

    def to_picture(self, at: QPointF) -> QPointF:
        """Return the place in the picture under a point of the widget."""
        return self.to_screen.inverted()[0].map(at)

    def frame(self) -> None:
        """Show all of it."""
        self._framed = True
        if self.image.isNull():
            return
        room = QSize(max(1, self.width() - 2 * int(_ROOM)), max(1, self.height() - 2 * int(_ROOM)))
        self.scale = min(room.width() / self.image.width(), room.height() / self.image.height())
        self._centre = QPointF(self.image.width() / 2.0, self.image.height() / 2.0)
        self.update()

    def zoom(self, factor: float, about: QPointF | None = None) -> None:
        """Zoom about a point of the widget, which stays over its pixel."""
        if self.image.isNull():
            return
        about = QPointF(self.rect().center()) if about is None else about
        fixed = self.to_picture(about)
        self._framed = False
        self.scale = min(_MOST, max(_LEAST, self.scale * factor))
        moved = self.to_picture(about)
        self._centre += fixed - moved
        self.update()

    def move_by(self, across: float, down: float) -> None:
        """Move the picture by points of the screen."""
        self._framed = False
        self._centre -= QPointF(across, down) / self.scale
        self.update()

    # Events.

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Base))
        if self.image.isNull():
            painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
            room = self.rect().adjusted(24, 24, -24, -24)
            painter.drawText(room, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, self._empty)
        else:
            to_screen = self.to_screen
            # Small pixels are averaged; large ones are seen as what they are.
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self.scale < 2.0)
            painter.drawImage(
                to_screen.mapRect(QRectF(0.0, 0.0, self.image.width(), self.image.height())), self.image
            )
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for mark in self.marks:
                draw_mark(painter, mark, to_screen)
            self.draw_over(painter)
            draw_legend(painter, list(self.marks), QRectF(self.rect()))
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(self.palette().color(QPalette.ColorRole.Highlight), 2.0))
            painter.drawRect(self.rect().adjusted(1, 1, -1, -1))

    def draw_over(self, painter: QPainter) -> None:
        """Draw what a view of its own has over the marks."""

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._framed:
            self.frame()

    def wheelEvent(self, event: QWheelEvent) -> None:
        self.zoom(2.0 ** (event.angleDelta().y() / _WHEEL), event.position())
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if event.button() == Qt.MouseButton.MiddleButton or (
            event.button() == Qt.MouseButton.LeftButton and shift
        ):
            self._grip = event.position()
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
        else:
            super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._grip is not None:
            step = event.position() - self._grip
            self._grip = event.position()
            self.move_by(step.x(), step.y())
            return
        at = self.to_picture(event.position())
        if not self.image.isNull() and QRectF(self.image.rect()).contains(at):
            self.hovered.emit(at.x(), at.y())
        else:
            self.left_picture.emit()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._grip is not None:
            self._grip = None
            self.unsetCursor()
        else:
            super().mouseReleaseEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.left_picture.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        moves = {
            Qt.Key.Key_Left: (40.0, 0.0),
            Qt.Key.Key_Right: (-40.0, 0.0),
            Qt.Key.Key_Up: (0.0, 40.0),
            Qt.Key.Key_Down: (0.0, -40.0),
        }
        key = Qt.Key(event.key())
        if key in moves:
            self.move_by(*moves[key])
        elif key in (Qt.Key.Key_Plus, Qt.Key.Key_Equal):
            self.zoom(_STEP)
        elif key == Qt.Key.Key_Minus:
            self.zoom(1.0 / _STEP)
        elif key == Qt.Key.Key_F and not event.modifiers():
            self.frame()
        else:
            super().keyPressEvent(event)
