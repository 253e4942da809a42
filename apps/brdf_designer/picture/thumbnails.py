"""Small pictures of paints in the window's history and variations; a disc of the readings until a picture is there."""

from __future__ import annotations

from brdf_qt.work.pictures import Pictures
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPixmap, QPixmapCache

from brdf_designer.colour.display import lab_to_codes
from brdf_designer.session.state import by_angle
from brdf_suite.documents.paint import Paint
from brdf_suite.palettes.swatches.look import SwatchLook

SIZE = 128
"""Width and height of a picture in pixels; sharp at 64 points on a screen of double density."""
USUAL_LOOK = SwatchLook(size=SIZE)

_GROUND = QColor(119, 119, 119)


def thumbnail(pictures: Pictures, paint: Paint, look: SwatchLook = USUAL_LOOK) -> QPixmap:
    """Return the picture of a paint where it is drawn, and its placeholder where it is not."""
    found = pictures.picture(paint, look)
    if found is None:
        key, found = pictures.key(paint, look), QPixmap()
        if not QPixmapCache.find(key, found):
            found = placeholder(paint, SIZE)
            QPixmapCache.insert(key, found)
    return found


def placeholder(paint: Paint, size: int) -> QPixmap:
    """Return a disc, lit from the upper left, whose colours are the readings in the order of their angles."""
    order = by_angle(paint)
    codes, _inside = lab_to_codes([paint.measurements[index].lab for index in order])
    picture = QPixmap(size, size)
    picture.fill(_GROUND)
    painter = QPainter(picture)
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
    return picture
