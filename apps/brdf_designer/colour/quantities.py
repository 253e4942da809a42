"""What the plots over the angle show, and the names of their lines; it needs no plotting library."""

from __future__ import annotations

from dataclasses import dataclass

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import mark
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QHBoxLayout, QWidget

MODEL_WIDTH, FIT_WIDTH = 4.0, 1.6
_LENGTH = 32


@dataclass(frozen=True)
class Quantity:
    """What a plot shows: ``component`` of LCh, its axis, the range of a point, and the step of a key."""

    component: int
    name: str
    axis: str
    lowest: float
    highest: float
    step: float
    tip: str


_HUE_TIP = mark("Hue angle hab over the aspecular angle, unwrapped. A grey has no hue and no point.")
QUANTITIES = (
    Quantity(
        0, mark("Lightness"), mark("L*"), 0.0, 250.0, 0.5, mark("Lightness L* over the aspecular angle.")
    ),
    Quantity(1, mark("Chroma"), mark("C*"), 0.0, 250.0, 0.5, mark("Chroma C*ab over the aspecular angle.")),
    Quantity(2, mark("Hue"), mark("h (°)"), -3600.0, 3600.0, 1.0, _HUE_TIP),
)


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
