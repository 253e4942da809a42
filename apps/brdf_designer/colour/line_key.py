"""Names of the lines of a plot, beside its caption: nothing in the plot is covered."""

from __future__ import annotations

from brdf_qt.fields.labels import PlainLabel
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QHBoxLayout, QWidget

_LENGTH = 32


class LineKey(QWidget):
    """A piece of a line, in a grey of the theme, and its name."""

    def __init__(
        self, name: str, role: QPalette.ColorRole, width: float, style: Qt.PenStyle = Qt.PenStyle.SolidLine
    ) -> None:
        super().__init__()
        self._role, self._width, self._style = role, width, style
        row = QHBoxLayout(self)
        row.setContentsMargins(_LENGTH + 6, 0, 0, 0)
        row.addWidget(PlainLabel(name))

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(QPen(self.palette().color(self._role), self._width, self._style))
        middle = self.height() / 2
        painter.drawLine(QPointF(0, middle), QPointF(_LENGTH, middle))
