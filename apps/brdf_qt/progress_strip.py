"""A slim strip that shows how far long work is, with a button to cancel it; the old picture stays."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget


class ProgressStrip(QWidget):
    """Hidden until :meth:`begin`; ``cancelled`` is emitted when the user asks to stop."""

    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._text = QLabel()
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setMaximumHeight(12)
        self._cancel = QPushButton("Cancel")
        self._cancel.clicked.connect(self._stop)
        self._slot: Callable[[], None] | None = None
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(8)
        row.addWidget(self._text)
        row.addWidget(self._bar, 1)
        row.addWidget(self._cancel)
        self._paint_grey()
        self.hide()

    def begin(self, text: str, cancel: Callable[[], None] | None = None) -> None:
        """Show the strip at zero; without ``cancel`` there is no button."""
        self._slot = cancel
        self._cancel.setVisible(cancel is not None)
        self.set(0.0, text)
        self.show()

    def set(self, fraction: float, text: str) -> None:
        """Move the bar to ``fraction`` (0…1) and say what is being done."""
        self._bar.setValue(round(1000 * fraction))
        self._text.setText(text)

    def finish(self) -> None:
        """Hide the strip."""
        self._slot = None
        self.hide()

    def changeEvent(self, event: QEvent) -> None:
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._paint_grey()

    def _paint_grey(self) -> None:
        """Fill the bar with grey: the accent is for focus and selection alone."""
        colours = QPalette(self.palette())
        colours.setColor(QPalette.ColorRole.Highlight, colours.color(QPalette.ColorRole.PlaceholderText))
        self._bar.setPalette(colours)

    def _stop(self) -> None:
        slot = self._slot
        self.finish()
        if slot is not None:
            slot()
        self.cancelled.emit()
