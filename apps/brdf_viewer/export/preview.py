"""What an export will show, small, before it is begun."""

from __future__ import annotations

from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_suite.arrays import Bytes

ROOM = QSize(320, 200)
_AFTER_MS = 120
_SQUARE = 8


class Preview(QWidget):
    """A place of one size with the picture in the middle. ``wanted()``: it is shown, and what it shows has changed."""

    wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.image = QImage()
        self.setFixedSize(ROOM)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr("Preview"))
        self._later = make_timer(self, self._ask, _AFTER_MS)

    def refresh(self) -> None:
        """Have it drawn anew, once the hand rests."""
        self._later.start()

    def show_image(self, image: QImage) -> None:
        """Show a picture; an empty one leaves the place empty."""
        self.image = image
        self.update()

    def size_of(self, size: tuple[int, int]) -> tuple[int, int]:
        """Return the size in device pixels of a picture of the shape of ``size`` that fits the place."""
        shape = QSize(*size).scaled(ROOM * self.devicePixelRatioF(), Qt.AspectRatioMode.KeepAspectRatio)
        return max(1, shape.width()), max(1, shape.height())

    def _ask(self) -> None:
        if self.isVisible():
            self.wanted.emit()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Base))
        if self.image.isNull():
            return
        shape = self.image.size().scaled(self.size(), Qt.AspectRatioMode.KeepAspectRatio)
        left, top = (self.width() - shape.width()) / 2, (self.height() - shape.height()) / 2
        place = QRectF(left, top, shape.width(), shape.height())
        if self.image.hasAlphaChannel():
            _paint_squares(painter, place)
        painter.drawImage(place, self.image)


def image_of(pixels: Bytes) -> QImage:
    """Return pixels, (h, w, 3) or with coverage (h, w, 4), as an image of its own."""
    height, width, channels = pixels.shape
    form = QImage.Format.Format_RGBA8888 if channels == 4 else QImage.Format.Format_RGB888
    return QImage(pixels.tobytes(), width, height, channels * width, form).copy()


def _paint_squares(painter: QPainter, place: QRectF) -> None:
    """Paint the grey squares that stand for what is seen through."""
    painter.fillRect(place, QColor(150, 150, 150))
    painter.save()
    painter.setClipRect(place)
    for row in range(int(place.height()) // _SQUARE + 1):
        for column in range(row % 2, int(place.width()) // _SQUARE + 1, 2):
            corner = (place.left() + column * _SQUARE, place.top() + row * _SQUARE)
            painter.fillRect(QRectF(*corner, _SQUARE, _SQUARE), QColor(105, 105, 105))
    painter.restore()
