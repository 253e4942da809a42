"""Texts of a window: drawn as they are, whatever a name from a file holds, and shortened where there is no room.

Qt draws what looks like HTML as such, in labels and in tips: ``<img src=…>`` in the name of a paint would have a file
read. Labels of the programs are :class:`PlainLabel`, and tips with words from elsewhere go through :func:`plain_tip`.
Both, and with :func:`~brdf_suite.foreign_text.make_visible` all other texts, show characters that are not seen.
"""

from __future__ import annotations

import re
from typing import Any

from PySide6 import QtGui
from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QLabel, QSizePolicy, QWidget

from brdf_qt.fields.marks import SIZE, Mark, draw_mark
from brdf_suite.foreign_text import escape_html, make_visible

_WIDTHS = 16
"""Of so many widths at most a label knows its heights, and of so many texts the widths."""
_SMALL = 0.88
"""The smaller size of type over the usual one."""
_LEAST = 8
"""Characters that an elided label keeps."""
_DIGIT = re.compile(r"\d")


def plain_tip(text: str) -> str:
    """Return what a tool tip has to be set to so that it shows ``text`` as it is.

    >>> plain_tip("Blue, 15°"), plain_tip("<b>Blue</b>")
    ('Blue, 15°', '<p>&lt;b&gt;Blue&lt;/b&gt;</p>')
    """
    text = make_visible(text)
    if not QtGui.Qt.mightBeRichText(text):
        return text
    return f"<p>{escape_html(text).replace(chr(10), '<br>')}</p>"


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

    def setText(self, text: str) -> None:
        super().setText(make_visible(text))

    @property
    def mark(self) -> Mark | None:
        """The mark before the text."""
        return self._mark

    def set_mark(self, what: Mark | None) -> None:
        """Show a mark before the text, None: none. Screen readers say its word."""
        if what is not self._mark:
            self.ensurePolished()  # at its first showing the style would take the room away again
            self._mark = what
            margins = self.contentsMargins()
            margins.setLeft(0 if what is None else SIZE + 4)
            self.setContentsMargins(margins)
            self.setAccessibleDescription("" if what is None else what.word)
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._mark is not None:
            self._paint_mark(QPainter(self))

    def _paint_mark(self, painter: QPainter) -> None:
        if self._mark is not None:
            area = self.contentsRect()
            lines = self.alignment() & Qt.AlignmentFlag.AlignTop or self.wordWrap()
            middle = area.top() + self.fontMetrics().height() / 2 if lines else area.center().y() + 0.5
            draw_mark(painter, self._mark, self.margin(), middle)


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


class DrawnLabel(PlainLabel):
    """One line that it draws itself: a new text asks for a new layout only where the label wants another size for it.

    QLabel asks at every text, and what holds it asks in turn: in a drag the whole window would be laid out anew at
    every step. Screen readers read the text unless it has been given a name of its own.
    """

    _text = ""
    _widths: dict[str, int] | None = None

    def text(self) -> str:
        return self._text

    def setText(self, text: str) -> None:
        text = make_visible(text)
        before = self._text
        if text == before:
            return
        hint = self.sizeHint()
        self._text = text
        if self.accessibleName() in ("", before):
            self.setAccessibleName(text)
        if self.sizeHint() != hint:
            self.updateGeometry()
        self.update()

    @property
    def shown_text(self) -> str:
        """The text as it is drawn."""
        return self._text

    def sizeHint(self) -> QSize:
        self.ensurePolished()
        margins, around = self.contentsMargins(), 2 * self.margin()
        wide = margins.left() + margins.right() + around + self.text_width(self._text)
        return QSize(wide, margins.top() + margins.bottom() + around + self.fontMetrics().height())

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def text_width(self, text: str) -> int:
        """Return the width of a text, pixels. Digits are as wide as each other, and numbers change in every drag."""
        widths = self._widths
        if widths is None or len(widths) > _WIDTHS:
            widths = self._widths = {}
        key = _DIGIT.sub("0", text)
        if key not in widths:
            widths[key] = self.fontMetrics().horizontalAdvance(key)
        return widths[key]

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._widths = None

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        margin = self.margin()
        area = self.contentsRect().adjusted(margin, 0, -margin, 0)
        painter.drawText(area, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, self.shown_text)
        self._paint_mark(painter)


class ElidedLabel(DrawnLabel):
    """Wants the width of its text, and takes less: it ends in an ellipsis, and its tip has the whole."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__("", parent)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self.setText(text)

    def setText(self, text: str) -> None:
        if make_visible(text) != self.text():
            super().setText(text)
            self.setToolTip(plain_tip(text))

    @property
    def shown_text(self) -> str:
        width = self.contentsRect().width() - 2 * self.margin()
        if self.text_width(self.text()) <= width:
            return self.text()
        return self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, width)

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        least = self.fontMetrics().averageCharWidth() * _LEAST + self.contentsMargins().left()
        return QSize(min(hint.width(), least), hint.height())
