"""The status bar: cells with the current state, each with a name, a value and an explanation."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QSize
from PySide6.QtGui import QFont, QFontMetrics, QPalette
from PySide6.QtWidgets import QStatusBar, QWidget

from brdf_qt.fields.labels import DrawnLabel, ElidedLabel, plain_tip, set_bold
from brdf_qt.fields.marks import SIZE, Mark
from brdf_qt.program.translation import tr

State = Literal["fresh", "stale", "warning"]
_MOST_CHARACTERS, _FEWEST_CHARACTERS = 48, 8


class StatusCell(ElidedLabel):
    """One value; stale values are dimmed and bracketed, warnings are bold and have a mark: never by colour alone.

    It keeps the width of the longest text that it has had, so that the others stay where they are. An ``elastic``
    one gives way where the line is too short for all: it ends in an ellipsis, and its tip has the whole.
    """

    def __init__(self, name: str, tip: str = "", *, elastic: bool = False) -> None:
        super().__init__()
        self._elastic = elastic
        self.setObjectName(f"status_{name}")
        self.setAccessibleName(tr(name))
        self.setToolTip(plain_tip(tip))
        self.setMargin(3)
        # Filled, a cell is drawn without the window behind it, a hundred times a second in a drag.
        self.setAutoFillBackground(True)
        self._tip = self._said = tip
        self._shown: tuple[str, str | None, State, Mark | None] | None = None
        self._widest = 0
        self._character = self.fontMetrics().averageCharWidth()  # in bold type it would be another
        policy = self.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.setSizePolicy(policy)
        self.hide()

    def set(
        self, text: str, tip: str | None = None, state: State = "fresh", mark: Mark | None = None
    ) -> None:
        """Show ``text``; empty text hides the cell. A warning has the mark of one where ``mark`` is none."""
        if (text, tip, state, mark) == self._shown:
            return
        self._shown = (text, tip, state, mark)
        self.set_mark(Mark.WARNING if mark is None and state == "warning" and text else mark)
        self.setText(f"({text})" if state == "stale" and text else text)
        whole = text if self._elastic else ""
        said = "\n".join(part for part in (whole, tip, self._tip) if part)
        if said != self._said:
            self._said = said
            self.setToolTip(plain_tip(said))
        self.setAccessibleDescription(text)
        # What is as it was is not drawn anew: a drag sets these a hundred times a second.
        if self.font().bold() != (state == "warning"):
            set_bold(self, state == "warning")
        role = QPalette.ColorRole.PlaceholderText if state == "stale" else QPalette.ColorRole.WindowText
        if self.foregroundRole() != role:
            self.setForegroundRole(role)
        self.setVisible(bool(text))

    def setText(self, text: str) -> None:
        DrawnLabel.setText(self, text)  # its tip says more than the text

    def reserve(self, text: str) -> None:
        """Keep room for a text of this length with a mark, from the start."""
        font = QFont(self.font())
        font.setBold(True)
        wide = QFontMetrics(font).horizontalAdvance(text) + SIZE + 4 + 2 * self.margin()
        self._widest = max(self._widest, wide)
        self.updateGeometry()

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        longest = self._character * _MOST_CHARACTERS if self._elastic else hint.width()
        self._widest = max(self._widest, min(hint.width(), longest))
        return QSize(self._widest, hint.height())

    def minimumSizeHint(self) -> QSize:
        hint = self.sizeHint()
        least = self._character * _FEWEST_CHARACTERS + SIZE
        return QSize(min(hint.width(), least), hint.height()) if self._elastic else hint

    @property
    def shown_text(self) -> str:
        return super().shown_text if self._elastic else self.text()


class StatusLine(QStatusBar):
    """Permanent cells in the order in which they were asked for."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeGripEnabled(False)
        self._cells: dict[str, StatusCell] = {}

    def cell(self, name: str, tip: str = "", *, right: bool = False, elastic: bool = False) -> StatusCell:
        """Return the cell ``name``; made on first use, at the left or the right end, elastic or not."""
        if name not in self._cells:
            self._cells[name] = cell = StatusCell(name, tip, elastic=elastic)
            (self.addPermanentWidget if right else self.addWidget)(cell)
        return self._cells[name]
