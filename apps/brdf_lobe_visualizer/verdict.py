"""Whether an error is good, fair or bad, as colour and shape: a disc, a triangle or a square, and a sign in text."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap, QPolygonF

Verdict = Literal["good", "fair", "bad"]
DELTA_E_LIMITS = (1.0, 3.0)
"""ΔE00 up to which an error is good, and up to which it is fair: hardly seen side by side; seen at once."""
RMS_LIMITS = (0.05, 0.20)
"""The same of a relative root mean square, where there is no colour to compare."""
SIGNS: dict[Verdict, str] = {"good": "●", "fair": "▲", "bad": "■"}
_COLOURS: dict[Verdict, str] = {"good": "#3fa34d", "fair": "#d39a00", "bad": "#d1453b"}
_WORDS: dict[Verdict, str] = {
    "good": mark("within tolerance"),
    "fair": mark("visible difference"),
    "bad": mark("out of tolerance"),
}
_ICON_PX = 12


def verdict_of(value: float, limits: tuple[float, float]) -> Verdict:
    """Return the verdict on an error; one that is not known is bad.

    >>> verdict_of(0.4, DELTA_E_LIMITS), verdict_of(22.78, DELTA_E_LIMITS)
    ('good', 'bad')
    """
    if value <= limits[0]:
        return "good"
    return "fair" if value <= limits[1] else "bad"


def words_of(verdict: Verdict) -> str:
    """Return a verdict in words."""
    return tr(_WORDS[verdict])


@lru_cache(16)
def verdict_icon(verdict: Verdict, ratio: float) -> QIcon:
    """Return the sign of a verdict for a screen with so many device pixels to a point."""
    picture = QPixmap(round(_ICON_PX * ratio), round(_ICON_PX * ratio))
    picture.setDevicePixelRatio(ratio)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(_COLOURS[verdict]))
    box = QRectF(1.0, 1.0, _ICON_PX - 2.0, _ICON_PX - 2.0)
    if verdict == "good":
        painter.drawEllipse(box)
    elif verdict == "fair":
        corners = [box.bottomLeft(), QPointF(box.center().x(), box.top()), box.bottomRight()]
        painter.drawPolygon(QPolygonF(corners))
    else:
        painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5))
    painter.end()
    return QIcon(picture)
