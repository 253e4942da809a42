"""The status bar: cells that tell the truth of the moment, each with a name, a value and an explanation."""

from __future__ import annotations

from typing import Literal

from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QLabel, QStatusBar, QWidget

State = Literal["fresh", "stale", "warning"]


class StatusCell(QLabel):
    """One value; stale values are dimmed and bracketed, warnings are bold: never by colour alone."""

    def __init__(self, name: str, tip: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(f"status_{name}")
        self.setAccessibleName(name)
        self.setToolTip(tip)
        self.setMargin(3)
        self._tip = tip
        self.hide()

    def set(self, text: str, tip: str | None = None, state: State = "fresh") -> None:
        """Show ``text``; empty text hides the cell."""
        self.setText(f"({text})" if state == "stale" and text else text)
        self.setToolTip("\n".join(part for part in (tip, self._tip) if part))
        self.setAccessibleDescription(text)
        font = self.font()
        font.setBold(state == "warning")
        self.setFont(font)
        self.setForegroundRole(
            QPalette.ColorRole.PlaceholderText if state == "stale" else QPalette.ColorRole.WindowText
        )
        self.setVisible(bool(text))


class StatusLine(QStatusBar):
    """Permanent cells in the order in which they were asked for."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeGripEnabled(False)
        self._cells: dict[str, StatusCell] = {}

    def cell(self, name: str, tip: str = "", *, right: bool = False) -> StatusCell:
        """Return the cell ``name``; made on first use, at the left or the right end."""
        if name not in self._cells:
            cell = StatusCell(name, tip)
            self._cells[name] = cell
            if right:
                self.addPermanentWidget(cell)
            else:
                self.addWidget(cell)
        return self._cells[name]
