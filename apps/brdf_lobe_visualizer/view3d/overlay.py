"""The words over the picture: angles, arrows' names, titles, notes and the scale bar; painted sharp at any size."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPainterPath, QPen

from brdf_lobe_visualizer.view3d.frame import Bar, Label, Panel
from brdf_suite.foreign_text import make_visible

Project = Callable[[tuple[float, float, float]], QPointF | None]
_HALO = 3.0
_BAR_WIDTH = 14.0
_SWATCH = 10.0


@dataclass(frozen=True)
class Words:
    """A line of text and its place, logical pixels; ``ground``: on a ground of its own."""

    box: QRectF
    text: str
    font: QFont
    ground: bool = False


class Overlay:
    """Paints in logical pixels; ``ink`` and ``paper`` are the theme's text and ground."""

    def __init__(self, painter: QPainter, font: QFont, ink: QColor, paper: QColor) -> None:
        self._painter, self._ink, self._paper = painter, ink, paper
        self._font = QFont(font)
        # Digits of one width, so that a turning number does not tremble.
        self._font.setFeature(QFont.Tag("tnum"), 1)
        self._small = QFont(self._font)
        self._small.setPointSizeF(max(7.0, 0.9 * self._font.pointSizeF()))
        self._bold = QFont(self._font)
        self._bold.setBold(True)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)

    def labels(
        self,
        labels: Sequence[Label],
        project: Project,
        room: QRectF,
        hidden: Sequence[bool],
        taken: Sequence[QRectF] = (),
    ) -> None:
        """Paint labels that lie within ``room``; arrows' first, none over another, none that a lobe hides."""
        taken = list(taken)
        seen = [label for label, behind in zip(labels, hidden, strict=True) if label.strong or not behind]
        for label in sorted(seen, key=lambda row: not row.strong):
            at = project(label.place)
            if at is None or not room.contains(at):
                continue
            font = self._bold if label.strong else self._small
            size = QFontMetricsF(font).boundingRect(label.text).size()
            box = QRectF(0.0, 0.0, size.width() + 2.0, size.height())
            box.moveCenter(at)
            if not room.contains(box) or any(box.intersects(other) for other in taken):
                continue
            taken.append(box)
            colour = self._ink if label.colour is None else QColor.fromRgbF(*label.colour)
            if label.strong and self._paper.lightnessF() > 0.45:
                colour = colour.darker(190)  # on light ground, so that it stands out as on dark
            self._halo(box, label.text, font, colour)

    def words_of(self, panel: Panel, room: QRectF, taken: Sequence[QRectF] = ()) -> list[Words]:
        """Return title, caption and note of a panel and where they stand: none over another or over ``taken``.

        In a small panel lines of the caption give way to the note, which must be known, and the note's last line is
        shortened.
        """
        inner = room.adjusted(12.0, 8.0, -12.0, -8.0)
        found: list[Words] = []
        y = inner.top()

        def put(text: str, font: QFont, left: float, top: float) -> bool:
            metrics = QFontMetricsF(font)
            line = QRectF(left, top, inner.right() - left, metrics.height())
            beside = [box.left() - 6.0 for box in taken if box.intersects(line)]
            line.setRight(min([line.right(), *beside]))
            if line.width() < 24.0 or line.bottom() > inner.bottom():
                return False
            shown = metrics.elidedText(make_visible(text), Qt.TextElideMode.ElideRight, line.width())
            line.setWidth(min(line.width(), metrics.horizontalAdvance(shown) + 2.0))
            found.append(Words(line, shown, font))
            return True

        if panel.title:
            indent = _SWATCH + 6.0 if panel.colour is not None else 0.0
            if put(panel.title, self._bold, inner.left() + indent, y):
                y = found[-1].box.bottom() + 2.0
        notes = self._broken(panel.note, inner, y, taken)
        floor = notes[0].box.top() if notes else inner.bottom()
        for text in panel.caption.splitlines():
            if y + QFontMetricsF(self._small).height() > floor or not put(text, self._small, inner.left(), y):
                break
            y = found[-1].box.bottom()
        return [*found, *notes]

    def _broken(self, text: str, inner: QRectF, top: float, taken: Sequence[QRectF]) -> list[Words]:
        """Return a note as lines from the lower edge upwards, but not above ``top``."""
        if not text:
            return []
        metrics = QFontMetricsF(self._small)
        below = [box for box in taken if box.intersects(inner)]
        right = min([inner.right(), *(box.left() - 14.0 for box in below)])
        wide = right - inner.left()
        room = int((inner.bottom() - top) // metrics.height())
        if wide < 48.0 or room < 1:
            return []
        lines: list[str] = []
        for paragraph in make_visible(text).splitlines():
            lines.append("")
            for word in paragraph.split():
                longer = f"{lines[-1]} {word}".strip()
                if lines[-1] and metrics.horizontalAdvance(longer) > wide:
                    lines.append(word)
                else:
                    lines[-1] = longer
        if len(lines) > room:
            lines = [*lines[: room - 1], " ".join(lines[room - 1 :])]
        shown = [metrics.elidedText(line, Qt.TextElideMode.ElideRight, wide) for line in lines]
        y = inner.bottom() - len(shown) * metrics.height()
        found = []
        for number, line in enumerate(shown):
            long = metrics.horizontalAdvance(line) + 2.0
            box = QRectF(
                inner.left() + 0.5 * (wide - long), y + number * metrics.height(), long, metrics.height()
            )
            found.append(Words(box, line, self._small, ground=True))
        return found

    def panel(self, panel: Panel, room: QRectF, words: Sequence[Words], *, bordered: bool) -> None:
        """Paint the edge of a panel, its mark in the legend's colour, and its words."""
        p = self._painter
        if bordered:
            p.setPen(QPen(_faded(self._ink, 50), 1.0))
            p.drawRect(room.adjusted(0.5, 0.5, -0.5, -0.5))
        if panel.title and panel.colour is not None and words:
            middle = words[0].box.center().y()
            p.setPen(Qt.PenStyle.NoPen)
            p.setBrush(QColor.fromRgbF(*panel.colour))
            p.drawRoundedRect(QRectF(room.left() + 12.0, middle - 0.5 * _SWATCH, _SWATCH, _SWATCH), 2.0, 2.0)
            p.setBrush(Qt.BrushStyle.NoBrush)
        for word in words:
            if word.ground:
                p.fillRect(word.box.adjusted(-6.0, 0.0, 6.0, 0.0), _faded(self._paper, 215))
            self._halo(word.box, word.text, word.font, self._ink)

    def bar_room(self, bar: Bar, room: QRectF) -> QRectF:
        """Return what a scale bar with its words takes of ``room``, right and below; empty where there is no room."""
        high = min(240.0, 0.42 * room.height())
        if high < 60.0:
            return QRectF()
        metrics = QFontMetricsF(self._small)
        wide = max(metrics.horizontalAdvance(text) for _, text in bar.ticks) + _BAR_WIDTH + 14.0
        wide = max(wide, metrics.horizontalAdvance(bar.title) + 8.0)
        above = metrics.height() + 12.0
        return QRectF(
            room.right() - wide - 10.0, room.bottom() - high - above - 14.0, wide, high + above + 8.0
        )

    def bar(self, bar: Bar, room: QRectF) -> None:
        """Paint a scale bar into its part of ``room``, its words to its left."""
        p = self._painter
        space = self.bar_room(bar, room)
        if space.isEmpty():
            return
        p.fillRect(space, _faded(self._paper, 190))
        metrics = QFontMetricsF(self._small)
        top = space.top() + metrics.height() + 12.0
        box = QRectF(space.right() - _BAR_WIDTH - 4.0, top, _BAR_WIDTH, space.bottom() - 8.0 - top)
        colours = np.ascontiguousarray(bar.codes[::-1])
        image = QImage(colours.tobytes(), 1, len(colours), 3, QImage.Format.Format_RGB888)
        p.drawImage(box, image)
        p.setPen(QPen(_faded(self._ink, 140), 1.0))
        p.drawRect(box)
        last = np.inf
        for share, text in sorted(bar.ticks, reverse=True):
            y = box.bottom() - share * box.height()
            p.setPen(QPen(_faded(self._ink, 200), 1.0))
            p.drawLine(QPointF(box.left() - 4.0, y), QPointF(box.left(), y))
            if abs(last - y) < metrics.height():
                continue
            last = y
            wide = metrics.horizontalAdvance(text) + 2.0
            room = QRectF(box.left() - 7.0 - wide, y - 0.5 * metrics.height(), wide, metrics.height())
            self._halo(room, text, self._small, self._ink)
        wide = metrics.horizontalAdvance(bar.title) + 2.0
        room = QRectF(box.right() - wide, box.top() - metrics.height() - 8.0, wide, metrics.height())
        self._halo(room, bar.title, self._small, self._ink)

    def probe(self, at: QPointF, text: str, room: QRectF) -> None:
        """Mark a point and write what it is beside it."""
        p = self._painter
        p.setPen(QPen(_faded(self._paper, 220), 3.0))
        p.drawEllipse(at, 4.0, 4.0)
        p.setPen(QPen(self._ink, 1.4))
        p.drawEllipse(at, 4.0, 4.0)
        metrics = QFontMetricsF(self._small)
        wide, high = metrics.horizontalAdvance(text) + 4.0, metrics.height()
        box = QRectF(at.x() + 10.0, at.y() - high - 6.0, wide, high)
        box.moveLeft(min(box.left(), room.right() - wide - 4.0))
        box.moveTop(max(box.top(), room.top() + 4.0))
        p.fillRect(box.adjusted(-4.0, -1.0, 4.0, 1.0), _faded(self._paper, 190))
        self._halo(box, text, self._small, self._ink)

    def words(self, text: str, room: QRectF) -> None:
        self._painter.setFont(self._font)
        self._painter.setPen(self._ink)
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        self._painter.drawText(room.adjusted(24, 24, -24, -24), int(flags), text)

    def _halo(self, box: QRectF, text: str, font: QFont, colour: QColor) -> None:
        """Text with a rim of the ground's colour: read before lines and lobes alike."""
        metrics = QFontMetricsF(font)
        path = QPainterPath()
        base = QPointF(box.left() + 1.0, box.center().y() + 0.5 * (metrics.ascent() - metrics.descent()))
        path.addText(base, font, text)
        rim = QPen(_faded(self._paper, 200), _HALO)
        rim.setCapStyle(Qt.PenCapStyle.RoundCap)
        rim.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        self._painter.strokePath(path, rim)
        self._painter.fillPath(path, colour)


def _faded(colour: QColor, alpha: int) -> QColor:
    faded = QColor(colour)
    faded.setAlpha(alpha)
    return faded
