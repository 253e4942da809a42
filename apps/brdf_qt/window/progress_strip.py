"""A slim strip that shows how far long work is, a line for each, with buttons to cancel; the old picture stays."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QFrame, QProgressBar, QPushButton, QWidget

from brdf_qt.fields.form import fill_column, fill_row
from brdf_qt.fields.labels import ElidedLabel
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_qt.window.floating import Floating

_LEAST_BAR = 64


class _Line(QFrame):
    """One job: what is done, how far it is, and a button where it can be cancelled."""

    def __init__(self, cancel: Callable[[], None] | None) -> None:
        super().__init__()
        self._text = ElidedLabel()
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setMaximumHeight(12)
        self._bar.setMinimumWidth(_LEAST_BAR)
        row = fill_row(self)
        row.setContentsMargins(8, 4, 8, 4)
        row.addWidget(self._text)
        row.addWidget(self._bar, 1)
        if cancel is not None:
            button = QPushButton(tr("Cancel"))
            button.clicked.connect(lambda: cancel())
            row.addWidget(button)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.AlternateBase)
        self._paint_grey()

    def set(self, fraction: float, text: str) -> None:
        self._bar.setValue(round(1000 * fraction))
        if text != self._text.text():
            self._bar.setAccessibleName(text)
            self._text.setText(text)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._paint_grey()

    def _paint_grey(self) -> None:
        """Fill the bar with grey: the accent is for focus and selection alone."""
        colours = QPalette(self.palette())
        colours.setColor(QPalette.ColorRole.Highlight, colours.color(QPalette.ColorRole.PlaceholderText))
        self._bar.setPalette(colours)


class ProgressStrip(Floating):
    """Over the picture, at its lower edge; hidden while there is no work. Work has a key.

    ``cancelled`` is emitted when the user asks to stop some.
    """

    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Edge.BottomEdge, parent)
        self._lines: dict[str, _Line] = {}
        self._box = fill_column(self, spacing=0)
        self.hide()

    @property
    def jobs(self) -> tuple[str, ...]:
        """The keys of what is shown, from the top."""
        return tuple(self._lines)

    def set_job(self, key: str, fraction: float, text: str, cancel: Callable[[], None] | None = None) -> None:
        """Show a job of this key at ``fraction`` (0…1), below those that are shown; ``cancel`` is of its first time."""
        if key not in self._lines:
            stop = None if cancel is None else partial(self._stop, key, cancel)
            self._lines[key] = line = _Line(stop)
            line.setObjectName(f"job_{key}")
            self._box.addWidget(line)
        self._lines[key].set(fraction, tr_core(text))
        self.show()

    def end_job(self, key: str) -> None:
        """The job has ended; nothing where there is none."""
        line = self._lines.pop(key, None)
        if line is not None:
            self._box.removeWidget(line)
            line.hide()
            line.deleteLater()
        self.setVisible(bool(self._lines))

    def _stop(self, key: str, cancel: Callable[[], None]) -> None:
        self.end_job(key)
        cancel()
        self.cancelled.emit()
