"""The plane of incidence as a polar plot: the model and the fitted lobes, the light from the left."""

from __future__ import annotations

import math
from dataclasses import dataclass

from brdf_qt.fields.form import described
from brdf_qt.program.translation import tr
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_designer.colour.quantities import FIT_WIDTH, MODEL_WIDTH
from brdf_suite.arrays import Floats

_RINGS_DEG = (-60, -30, 0, 30, 60)
_SIDE, _TOP, _FOOT = 30.0, 22.0, 8.0


@dataclass(frozen=True, eq=False)
class LobeLines:
    """Distances (n,) from the middle, 0 to 1, of model and lobes over the polar angle (n,) of the view, degrees."""

    light_deg: float
    view_deg: Floats
    model: Floats
    fitted: Floats


class LobesPlot(QWidget):
    """Draws :class:`LobeLines`; a word stands in their place while there are none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        tip = tr(
            "Reflectance in the plane of the light, as seen from each side; the radius is its cube root. "
            "Solid: the model; dashed: the fitted lobes."
        )
        described(self, name="lobes_plot", spoken=tr("Lobes in the plane of the light"), tip=tip)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(180, 100)
        self.lines: LobeLines | None = None

    def show_lines(self, lines: LobeLines) -> None:
        """Draw these."""
        self.lines = lines
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(380, 220)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(self.rect())
        if self.lines is None:
            painter.drawText(area, Qt.AlignmentFlag.AlignCenter, tr("No lobes yet"))
            return
        radius = max(20.0, min(0.5 * area.width() - _SIDE, area.height() - _TOP - _FOOT))
        foot = QPointF(area.center().x(), 0.5 * (area.height() + radius + _TOP - _FOOT))
        self._paint_rings(painter, foot, radius)
        lines, role = self.lines, QPalette.ColorRole
        turn = math.radians(lines.light_deg)
        painter.setPen(QPen(self.palette().color(role.PlaceholderText), 1.5, Qt.PenStyle.DotLine))
        painter.drawLine(QLineF(foot, foot + QPointF(-math.sin(turn), -math.cos(turn)) * radius))
        for share, which, width, style in (
            (lines.model, role.PlaceholderText, MODEL_WIDTH, Qt.PenStyle.SolidLine),
            (lines.fitted, role.WindowText, FIT_WIDTH, Qt.PenStyle.DashLine),
        ):
            painter.setPen(QPen(self.palette().color(which), width, style))
            painter.drawPolyline(_outline(lines.view_deg, share, foot, radius))

    def _paint_rings(self, painter: QPainter, foot: QPointF, radius: float) -> None:
        painter.setPen(QPen(self.palette().color(QPalette.ColorRole.Light), 1.0))
        painter.drawLine(QLineF(foot - QPointF(radius, 0.0), foot + QPointF(radius, 0.0)))
        for share in (0.5, 1.0):
            reach = share * radius
            ring = QRectF(foot.x() - reach, foot.y() - reach, 2.0 * reach, 2.0 * reach)
            painter.drawArc(ring, 0, 180 * 16)
        metrics = painter.fontMetrics()
        for angle in _RINGS_DEG:
            way = QPointF(math.sin(math.radians(angle)), -math.cos(math.radians(angle)))
            painter.setPen(QPen(self.palette().color(QPalette.ColorRole.Light), 1.0))
            painter.drawLine(QLineF(foot, foot + way * radius))
            painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
            text = f"{abs(angle)}°"
            place = foot + way * (radius + 12.0)
            wide = metrics.horizontalAdvance(text)
            painter.drawText(place - QPointF(0.5 * wide, -0.35 * metrics.ascent()), text)


def _outline(view_deg: Floats, share: Floats, foot: QPointF, radius: float) -> QPolygonF:
    points = [
        foot + QPointF(math.sin(math.radians(angle)), -math.cos(math.radians(angle))) * (radius * far)
        for angle, far in zip(view_deg.tolist(), share.tolist(), strict=True)
        if math.isfinite(far)
    ]
    return QPolygonF(points)
