"""The plots below the view: buttons choose which are shown, side by side."""

from __future__ import annotations

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QScrollArea, QSplitter, QWidget

_SHOWN_KEY = "lobes/plots"
_FIRST = 3
"""So many of the plots are shown at a first start."""
_UNBOUND = 16_777_215
"""The height that Qt takes for no limit (QWIDGETSIZE_MAX)."""


class PlotRow(QWidget):
    """Plots side by side, each with a button that shows or hides it; which are shown is remembered.

    Signals: ``shown_changed(key, shown)``.
    """

    shown_changed = Signal(str, bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plots")
        self.plots: dict[str, QWidget] = {}
        """The plots by key, in order."""
        self.buttons: dict[str, ChoiceButton] = {}
        remembered = settings().value(_SHOWN_KEY)
        self._chosen = None if remembered is None else str(remembered).split()
        self._head = row_of(None)
        self._split = QSplitter(Qt.Orientation.Horizontal)
        self._split.setHandleWidth(8)
        self._split.setChildrenCollapsible(False)
        # Where there is no room for the least that all of them need, they are scrolled and do not lie over one another.
        self._scroll = scroll = QScrollArea()
        scroll.setObjectName("plots_scroll")
        scroll.setFrameShape(QScrollArea.Shape.NoFrame)
        scroll.setWidgetResizable(True)
        scroll.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setWidget(self._split)
        fill_column(self, self._head, scroll, grows=scroll, spacing=4)
        self.hide()

    def add(self, key: str, title: str, plot: QWidget) -> None:
        first = len(self.plots) < _FIRST if self._chosen is None else key in self._chosen
        spoken = tr("Show plot {name}").format(name=title)
        button = described(ChoiceButton(title), name=f"plot_button_{key}", spoken=spoken)
        button.setChecked(first)
        button.clicked.connect(lambda: self.set_shown(key, button.isChecked()))
        self._head.insertWidget(self._head.count() - 1, button)
        self._split.addWidget(plot)
        self._split.setStretchFactor(self._split.count() - 1, 1)
        plot.setVisible(first)
        self.plots[key], self.buttons[key] = plot, button
        self._show_any()
        self.show()

    def shown(self) -> tuple[str, ...]:
        return tuple(key for key, button in self.buttons.items() if button.isChecked())

    def even(self) -> None:
        """Give all plots the same width: one that has just come would otherwise have what its least is."""
        self._split.setSizes([10_000] * self._split.count())

    def reset(self) -> None:
        for place, key in enumerate(self.plots):
            self.set_shown(key, place < _FIRST)

    def _show_any(self) -> None:
        # Where no plot is chosen, the room is left to the view above.
        some = bool(self.shown())
        self._scroll.setVisible(some)
        self.setMaximumHeight(_UNBOUND if some else self._head.sizeHint().height())

    def set_shown(self, key: str, shown: bool, *, remember: bool = True) -> None:
        """Show or hide a plot, and remember it, unless it is for this run alone."""
        self.buttons[key].setChecked(shown)
        self.plots[key].setVisible(shown)
        self._show_any()
        self.even()
        if remember:
            settings().setValue(_SHOWN_KEY, " ".join(self.shown()))
        self.shown_changed.emit(key, shown)
