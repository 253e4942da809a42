"""What stands for a picture until it is drawn: a disc of the paint's own colours, from near the glance to far."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QLinearGradient, QPainter

from brdf_designer.colour.display import lab_to_codes
from brdf_designer.session.state import by_angle
from brdf_suite.documents.paint import Paint

_GROUND = QColor(119, 119, 119)


def placeholder(paint: Paint, size: int) -> QImage:
    """Return a disc, lit from the upper left, whose colours are the readings in the order of their angles."""
    order = by_angle(paint)
    codes, _inside = lab_to_codes([paint.measurements[index].lab for index in order])
    image = QImage(size, size, QImage.Format.Format_RGB32)
    image.fill(_GROUND)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    edge = 0.08 * size
    disc = QRectF(edge, edge, size - 2 * edge, size - 2 * edge)
    ramp = QLinearGradient(disc.topLeft(), disc.bottomRight())
    last = max(1, len(order) - 1)
    for place, code in enumerate(codes.tolist()):
        # The middle of the ramp: at its ends nothing of the disc is left.
        ramp.setColorAt(0.2 + 0.6 * place / last, QColor(*code))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(ramp)
    painter.drawEllipse(disc)
    painter.end()
    return image
