"""L*, C* and h over the aspecular angle, one above the other: points that can be dragged, model and lobes as lines.

pyqtgraph takes a quarter of a second to import, so the plots are built after the window is first painted. They are
drawn a moment after an edit, all of a frame at once: numbers and patches come first.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import fill_column, row_of
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPalette, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_designer.colour.quantities import FIT_WIDTH, MODEL_WIDTH, QUANTITIES, LineKey
from brdf_designer.session.state import Colours, Curves
from brdf_designer.window.caption import Caption

if TYPE_CHECKING:
    from brdf_designer.colour.quantity_plot import QuantityPlot

_FRESH = (mark("L*, C* and h over the aspecular angle"), mark("L*, C*, h over angle"))
_STALE = (
    mark("L*, C* and h: last possible paint"),
    mark("Curves of the last possible paint"),
    mark("Earlier curves"),
)
_PAUSE_MS = 15
_SHOWN_KEY = "designer/plots"
_LEAST_PLOT, _AXIS = 64, 40
"""Pixels of height that a plot needs to be read, and that the axis below the lowest takes."""


class AnglePlot(QWidget):
    """The plots; :meth:`build` makes them, and until then what is shown is kept.

    Signals: ``edited(index, component, value)`` of LCh while a point is moved, between ``drag_started(index,
    component)`` and ``drag_finished()``.
    """

    edited = Signal(int, int, float)
    drag_started = Signal(int, int)
    drag_finished = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumHeight(90)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._box = fill_column(self, spacing=4)
        self.caption = Caption(*map(tr, _FRESH), "")
        self.caption.setToolTip(
            tr("Points are the targets at the measured angles; drag one up or down to change it.")
        )
        self._head = row_of(
            self.caption,
            LineKey(tr("model"), QPalette.ColorRole.PlaceholderText, MODEL_WIDTH),
            LineKey(tr("fitted lobes"), QPalette.ColorRole.WindowText, FIT_WIDTH, Qt.PenStyle.DashLine),
            grows=self.caption,
        )
        # What the user wants to see, first what was asked for last: where there is no room for all, that stays.
        kept = dict.fromkeys(str(settings().value(_SHOWN_KEY, "012")))
        self._wanted = [int(digit) for digit in kept if digit in "012"] or [0, 1, 2]
        self.buttons = [self._button(number) for number in range(len(QUANTITIES))]
        for button in self.buttons:
            self._head.addWidget(button)
        self._box.addLayout(self._head)
        self.plots: list[QuantityPlot] = []
        self._colours: Colours | None = None
        self._curves: Curves | None = None
        self._new_colours = self._new_curves = False
        self._drawing = make_timer(self, self.draw_now, _PAUSE_MS)

    @property
    def is_built(self) -> bool:
        """Whether the plots are there."""
        return bool(self.plots)

    def build(self) -> None:
        """Make the plots and show what was set so far."""
        from brdf_designer.colour.quantity_plot import QuantityPlot

        for quantity in QUANTITIES:
            plot = QuantityPlot(quantity)
            component = quantity.component
            plot.started.connect(lambda index, c=component: self.drag_started.emit(index, c))
            plot.edited.connect(lambda index, value, c=component: self.edited.emit(index, c, value))
            plot.finished.connect(self.drag_finished)
            self._box.addWidget(plot, 1)
            self.plots.append(plot)
        self._show_chosen()

    def show_colours(self, colours: Colours) -> None:
        """Show the readings as points."""
        self._colours, self._new_colours = colours, True
        if self.plots and self.isVisible():
            self._drawing.start()

    def show_curves(self, curves: Curves) -> None:
        """Show model and lobes, fresh."""
        self._curves, self._new_curves = curves, True
        self.caption.set_forms(*map(tr, _FRESH), "")
        if self.plots and self.isVisible():
            self._drawing.start()

    def mark_stale(self) -> None:
        """Say that the lines are of the last paint that could be."""
        self.caption.set_forms(*map(tr, _STALE))

    def draw_now(self) -> None:
        """Draw what was shown last; hidden plots are brought up to date when they are shown."""
        self._drawing.stop()
        for plot in self.plots:
            if plot.isHidden():
                continue
            if self._new_colours and self._colours is not None:
                plot.show_angles(self._colours.angles)
            if self._new_curves and self._curves is not None:
                plot.show_curves(self._curves)
        self._new_colours = self._new_curves = False

    def _button(self, number: int) -> ChoiceButton:
        quantity = QUANTITIES[number]
        button = ChoiceButton(tr(quantity.axis).split(" ", 1)[0])
        button.setChecked(number in self._wanted)
        button.setAccessibleName(tr("Show plot of {name}").format(name=tr(quantity.name)))
        button.setToolTip(tr(quantity.tip))
        button.clicked.connect(lambda: self._toggled(number))
        return button

    def _toggled(self, number: int) -> None:
        shown = self._shown()
        if number not in shown:
            # In a low window it takes the place of the one that was asked for longest ago.
            self._wanted = [number, *(other for other in self._wanted if other != number)]
        elif len(shown) > 1:
            self._wanted.remove(number)
        settings().setValue(_SHOWN_KEY, "".join(map(str, self._wanted)))
        self._show_chosen()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self.plots:
            self._drawing.start()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._shown() != [number for number, plot in enumerate(self.plots) if not plot.isHidden()]:
            self._show_chosen()

    def _shown(self) -> list[int]:
        """The plots that are wanted and have room, in their order; one always."""
        room = self.height() - self._head.sizeHint().height() - _AXIS
        fitting = max(1, room // (_LEAST_PLOT + self._box.spacing()))
        return sorted(self._wanted[:fitting])

    def _show_chosen(self) -> None:
        shown = self._shown()
        for number, button in enumerate(self.buttons):
            button.setChecked(number in shown)
        if not self.plots:
            return
        for number, plot in enumerate(self.plots):
            lowest = number == shown[-1]
            plot.setVisible(number in shown)
            plot.show_axis(lowest)
            # The lowest has the axis below it, which takes about half the room of a plot.
            self._box.setStretch(number + 1, 3 if lowest else 2)
        self._new_colours = self._new_curves = True
        self.draw_now()
