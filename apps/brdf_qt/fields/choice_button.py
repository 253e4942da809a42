"""A button that stays down, and shows it in every theme: filled with the colour of selection while it is checked."""

from __future__ import annotations

from PySide6.QtCore import QEvent
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication, QToolButton, QWidget


class ChoiceButton(QToolButton):
    """A checkable button of one choice."""

    def __init__(self, text: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText(text)
        self.setCheckable(True)
        self.toggled.connect(lambda _on: self._dress())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.ApplicationPaletteChange:
            self._dress()

    def _dress(self) -> None:
        # What this palette does not set follows the theme.
        palette = QPalette()
        if self.isChecked():
            shown, role = QApplication.palette(), QPalette.ColorRole
            palette.setColor(role.Button, shown.color(role.Highlight))
            palette.setColor(role.ButtonText, shown.color(role.HighlightedText))
        self.setPalette(palette)
