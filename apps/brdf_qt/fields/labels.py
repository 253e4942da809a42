"""Texts of a window: drawn as they are, whatever a name from a file holds, and shortened where there is no room.

Qt draws what looks like HTML as such, in labels and in tips: ``<img src=…>`` in the name of a paint would have a file
read. Labels of the programs are :class:`PlainLabel`, and tips with words from elsewhere go through :func:`plain_tip`.
"""

from __future__ import annotations

from html import escape
from typing import Any

from PySide6 import QtGui
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QLabel, QSizePolicy, QWidget

from brdf_qt.fields.marks import SIZE, Mark, draw_mark

_WIDTHS = 16
"""Of so many widths at most a label knows its heights."""
_SMALL = 0.88
"""The smaller size of type over the usual one."""
_LEAST = 8
"""Characters that an elided label keeps."""


def plain_tip(text: str) -> str:
    """Return what a tool tip has to be set to so that it shows ``text`` as it is.

    >>> plain_tip("Blue, 15°"), plain_tip("<b>Blue</b>")
    ('Blue, 15°', '<p>&lt;b&gt;Blue&lt;/b&gt;</p>')
    """
    if not QtGui.Qt.mightBeRichText(text):
        return text
    return f"<p>{escape(text).replace(chr(10), '<br>')}</p>"


def set_bold(widget: QWidget, bold: bool) -> None:
    """Write the text of a widget in bold type, or as usual."""
    font = widget.font()
    font.setBold(bold)
    widget.setFont(font)


def set_small(widget: QWidget) -> None:
    """Write the text of a widget in the smaller of the two sizes: remarks, and numbers that repeat others."""
    font = widget.font()
    font.setPointSizeF(_SMALL * QApplication.font().pointSizeF())
    widget.setFont(font)


class PlainLabel(QLabel):
    """A label that draws its text as it is, whatever tags it holds; a state may be marked before it."""

    _mark: Mark | None = None

    def __init__(self, text: str = "", parent: QWidget | None = None, **options: Any) -> None:
        super().__init__(parent, **options)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setText(text)

    @property
    def mark(self) -> Mark | None:
        """The mark before the text."""
        return self._mark

    def set_mark(self, what: Mark | None) -> None:
        """Show a mark before the text, None: none. Screen readers say its word."""
        if what is not self._mark:
            self._mark = what
            margins = self.contentsMargins()
            margins.setLeft(0 if what is None else SIZE + 4)
            self.setContentsMargins(margins)
            self.setAccessibleDescription("" if what is None else what.word)
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        self._paint_mark()

    def _paint_mark(self) -> None:
        if self._mark is not None:
            area = self.contentsRect()
            lines = self.alignment() & Qt.AlignmentFlag.AlignTop or self.wordWrap()
            middle = area.top() + self.fontMetrics().height() / 2 if lines else area.center().y() + 0.5
            draw_mark(QPainter(self), self._mark, self.margin(), middle)


class RoomyLabel(PlainLabel):
    """Text that comes and goes in a place of its own: it breaks its lines, and what lies below stays where it is.

    Its place is as high as ``lines`` from the start, as the longest text so far of this width, and also kept while it
    is hidden.
    """

    def __init__(self, text: str = "", lines: int = 0) -> None:
        super().__init__(text, wordWrap=True)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._lines = lines
        self._tallest: dict[int, int] = {}
        policy = self.sizePolicy()
        policy.setRetainSizeWhenHidden(lines > 0)
        self.setSizePolicy(policy)

    def heightForWidth(self, width: int) -> int:
        known = self._tallest.get(width, self._lines * self.fontMetrics().lineSpacing())
        if len(self._tallest) > _WIDTHS:
            self._tallest.clear()
        self._tallest[width] = max(known, super().heightForWidth(width))
        return self._tallest[width]

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        return QSize(hint.width(), max(hint.height(), self._lines * self.fontMetrics().lineSpacing()))


class ElidedLabel(PlainLabel):
    """Wants the width of its text, and takes less: it ends in an ellipsis, and its tip has the whole."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__("", parent)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self.setText(text)

    def setText(self, text: str) -> None:
        if text != self.text():
            super().setText(text)
            self.setToolTip(plain_tip(text))

    @property
    def shown_text(self) -> str:
        """The text as it is drawn."""
        width = self.contentsRect().width() - 2 * self.margin()
        return self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, width)

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        least = self.fontMetrics().averageCharWidth() * _LEAST + self.contentsMargins().left()
        return QSize(min(hint.width(), least), hint.height())

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.shown_text == self.text():
            super().paintEvent(event)
            return
        flags = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        area = self.contentsRect().adjusted(self.margin(), 0, -self.margin(), 0)
        palette, role = self.palette(), self.foregroundRole()
        painter = QPainter(self)
        self.style().drawItemText(painter, area, flags, palette, self.isEnabled(), self.shown_text, role)
        painter.end()
        self._paint_mark()
