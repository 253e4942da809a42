"""The status bar: cells with the current state, each with a name, a value and an explanation."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QStatusBar, QWidget

from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.program.translation import tr

State = Literal["fresh", "stale", "warning"]
_LEAST = 8
"""Characters that an elastic cell keeps."""


class StatusCell(PlainLabel):
    """One value; stale values are dimmed and bracketed, warnings are bold: never by colour alone.

    An ``elastic`` one gives way where the line is too short for all: it ends in an ellipsis, and its tip has the whole.
    """

    def __init__(
        self, name: str, tip: str = "", parent: QWidget | None = None, *, elastic: bool = False
    ) -> None:
        super().__init__("", parent)
        self._elastic = elastic
        self.setObjectName(f"status_{name}")
        self.setAccessibleName(tr(name))
        self.setToolTip(plain_tip(tip))
        self.setMargin(3)
        # Filled, a cell is drawn without the window behind it, a hundred times a second in a drag.
        self.setAutoFillBackground(True)
        self._tip = tip
        self._shown: tuple[str, str | None, State] | None = None
        self.hide()

    def set(self, text: str, tip: str | None = None, state: State = "fresh") -> None:
        """Show ``text``; empty text hides the cell."""
        if (text, tip, state) == self._shown:
            return
        self._shown = (text, tip, state)
        self.setText(f"({text})" if state == "stale" and text else text)
        whole = text if self._elastic else ""
        self.setToolTip(plain_tip("\n".join(part for part in (whole, tip, self._tip) if part)))
        self.setAccessibleDescription(text)
        # What is as it was is not drawn anew: a drag sets these a hundred times a second.
        font = self.font()
        if font.bold() != (state == "warning"):
            font.setBold(state == "warning")
            self.setFont(font)
        role = QPalette.ColorRole.PlaceholderText if state == "stale" else QPalette.ColorRole.WindowText
        if self.foregroundRole() != role:
            self.setForegroundRole(role)
        self.setVisible(bool(text))

    @property
    def shown_text(self) -> str:
        """The text as it is drawn: shortened where there is no room for all of it."""
        return self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, self._room())

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        if not self._elastic:
            return hint
        return QSize(min(hint.width(), self.fontMetrics().averageCharWidth() * _LEAST), hint.height())

    def paintEvent(self, event: QPaintEvent) -> None:
        if not self._elastic or self.shown_text == self.text():
            super().paintEvent(event)
            return
        painter = QPainter(self)
        area = self.contentsRect().adjusted(self.margin(), 0, -self.margin(), 0)
        flags = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        self.style().drawItemText(
            painter, area, flags, self.palette(), True, self.shown_text, self.foregroundRole()
        )

    def _room(self) -> int:
        return self.contentsRect().width() - 2 * self.margin()


class StatusLine(QStatusBar):
    """Permanent cells in the order in which they were asked for."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeGripEnabled(False)
        self._cells: dict[str, StatusCell] = {}

    def cell(self, name: str, tip: str = "", *, right: bool = False, elastic: bool = False) -> StatusCell:
        """Return the cell ``name``; made on first use, at the left or the right end, elastic or not."""
        if name not in self._cells:
            cell = StatusCell(name, tip, elastic=elastic)
            self._cells[name] = cell
            if right:
                self.addPermanentWidget(cell)
            else:
                self.addWidget(cell)
        return self._cells[name]
