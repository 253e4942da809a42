"""One swatch of the grid: its picture or what stands for it, its name, and the marks of its state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from brdf_qt.program.theme import grey
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetrics,
    QGradient,
    QLinearGradient,
    QPainter,
    QPalette,
    QPen,
    QPixmap,
    QPolygon,
    QRadialGradient,
)

from brdf_suite.foreign_text import make_visible

FORMS = ("sphere", "panel", "flop_strip", "chips")
_PAD = 4
_GROUND = grey(50.0)


@dataclass(frozen=True)
class Tile:
    """What a tile shows of a swatch: ``codes`` are sRGB (n, 3) from the face to the flop."""

    name: str
    below: str
    codes: np.ndarray
    angles: tuple[float, ...]
    flat: bool
    picture: QPixmap | None
    spot: bool = False


@dataclass(frozen=True)
class Look:
    """How it is shown now."""

    form: str
    selected: bool = False
    current: bool = False
    focused: bool = False
    hovered: bool = False
    stale: bool = False


class TilePainter:
    """Draws tiles of one size with one font; texts cut to their width are kept."""

    def __init__(self, size: int, font: QFont, palette: QPalette, lines: int = 1) -> None:
        self.size, self.font, self.palette, self.lines = size, font, palette, lines
        self._metrics = QFontMetrics(font)
        self._line = self._metrics.height()
        self._texts: dict[str, str] = {}

    @property
    def tile(self) -> tuple[int, int]:
        return (self.size + 2 * _PAD, self.size + 2 * _PAD + self.lines * self._line + 2)

    def picture_box(self, box: QRect) -> QRect:
        return QRect(box.left() + _PAD, box.top() + _PAD, self.size, self.size)

    def name_box(self, box: QRect) -> QRect:
        return QRect(box.left() + 2, box.top() + 2 * _PAD + self.size - 2, box.width() - 4, self._line + 4)

    def paint(self, painter: QPainter, box: QRect, tile: Tile, look: Look) -> None:
        role = QPalette.ColorRole
        if look.selected:
            painter.fillRect(box, self.palette.color(role.Highlight))
        elif look.hovered:
            painter.fillRect(box, self.palette.color(role.Midlight))
        inside = self.picture_box(box)
        if look.form == "chips":
            self._chips(painter, inside, tile)
        elif tile.picture is not None:
            painter.drawPixmap(inside, tile.picture)
        else:
            self._stand_in(painter, inside, tile, look.form)
        if look.stale and look.form != "chips":
            self._stale(painter, inside)
        if tile.spot:
            self._spot(painter, inside)
        painter.setPen(self.palette.color(role.HighlightedText if look.selected else role.WindowText))
        top = inside.bottom() + 2
        for text in (tile.name, tile.below)[: self.lines]:
            if text:
                line = QRect(box.left() + 2, top, box.width() - 4, self._line)
                painter.drawText(line, Qt.AlignmentFlag.AlignCenter, self._cut(text, line.width()))
            top += self._line
        if look.current and look.focused:
            pen = QPen(self.palette.color(role.Highlight), 2)
            if look.selected:
                pen = QPen(self.palette.color(role.HighlightedText), 1, Qt.PenStyle.DotLine)
            painter.setPen(pen)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(box.adjusted(1, 1, -2, -2))

    def _cut(self, text: str, width: int) -> str:
        cut = self._texts.get(text)
        if cut is None:
            if len(self._texts) > 4000:
                self._texts.clear()
            # A name may have a million characters; what does not fit is not measured.
            cut = self._metrics.elidedText(make_visible(text[:200]), Qt.TextElideMode.ElideRight, width)
            self._texts[text] = cut
        return cut

    def _chips(self, painter: QPainter, box: QRect, tile: Tile) -> None:
        count = len(tile.codes)
        if tile.flat or count == 0:
            colour = tile.codes[count // 2] if count else (119, 119, 119)
            painter.fillRect(box, QColor(*(int(code) for code in colour)))
            return
        for number, code in enumerate(tile.codes):
            left = box.left() + box.width() * number // count
            right = box.left() + box.width() * (number + 1) // count
            chip = QRect(left, box.top(), right - left, box.height())
            painter.fillRect(chip, QColor(*(int(part) for part in code)))
            if chip.width() >= 36:
                dark = 0.2126 * code[0] + 0.7152 * code[1] + 0.0722 * code[2] < 110
                painter.setPen(QColor(230, 230, 230) if dark else QColor(20, 20, 20))
                foot = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignBottom
                painter.drawText(chip.adjusted(0, 0, 0, -2), foot, f"{tile.angles[number]:g}°")

    def _stand_in(self, painter: QPainter, box: QRect, tile: Tile, form: str) -> None:
        """Draw the readings themselves until the picture is there: never mistaken for one, it has no light in it."""
        colours = [QColor(*(int(part) for part in code)) for code in tile.codes] or [_GROUND]
        if form == "flop_strip":
            ramp = QLinearGradient(QPointF(box.topLeft()), QPointF(box.topRight()))
            _spread(ramp, colours, 0.0)
            painter.fillRect(box, ramp)
            return
        painter.fillRect(box, _GROUND)
        if form == "sphere":
            disc = QRectF(box).adjusted(*(0.06 * self.size * way for way in (1, 1, -1, -1)))
            shade = QRadialGradient(disc.center() - QPointF(0.2, 0.25) * self.size, 0.75 * self.size)
            _spread(shade, colours, 0.1)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(shade)
            painter.drawEllipse(disc)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
            return
        ramp = QLinearGradient(QPointF(box.topLeft()), QPointF(box.bottomLeft()))
        _spread(ramp, colours, 0.1)
        edge = round(0.08 * self.size)
        painter.fillRect(box.adjusted(edge, edge, -edge, -edge), ramp)

    def _stale(self, painter: QPainter, box: QRect) -> None:
        """Mark what is still to come: three points in the corner."""
        side = max(2, self.size // 32)
        for number in range(3):
            spot = QRect(box.right() - (3 - number) * (2 * side) - side, box.bottom() - 3 * side, side, side)
            painter.fillRect(spot.adjusted(-1, -1, 1, 1), grey(10.0))
            painter.fillRect(spot, grey(95.0))

    def _spot(self, painter: QPainter, box: QRect) -> None:
        """Mark a spot colour: a light corner at the lower left, as print programs have it."""
        side = max(8, self.size // 7)
        corner = box.bottomLeft()
        triangle = [corner, corner - QPoint(0, side), corner + QPoint(side, 0)]
        painter.setPen(grey(10.0))
        painter.setBrush(grey(98.0))
        painter.drawPolygon(QPolygon(triangle))


def _spread(ramp: QGradient, colours: list[QColor], margin: float) -> None:
    for number, colour in enumerate(colours):
        ramp.setColorAt(margin + (1.0 - 2.0 * margin) * number / max(1, len(colours) - 1), colour)
