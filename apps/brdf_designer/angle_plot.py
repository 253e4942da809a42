"""L*, C* and h over the aspecular angle, one above the other: points that can be dragged, model and lobes as lines.

pyqtgraph takes a quarter of a second to import, so the plots are built after the window is first painted. They are
drawn a moment after an edit, all of a frame at once: numbers and patches come first.
"""

from __future__ import annotations

from brdf_qt.choice_button import ChoiceButton
from brdf_qt.settings import settings
from brdf_qt.translation import mark, tr
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QVBoxLayout, QWidget

from brdf_designer.caption import Caption
from brdf_designer.desk_state import Colours, Curves
from brdf_designer.line_key import LineKey
from brdf_designer.quantity_plot import FIT_WIDTH, MODEL_WIDTH, QUANTITIES, QuantityPlot

_FRESH = (mark("L*, C* and h over the aspecular angle"), mark("L*, C*, h over the angle"), mark("Curves"))
_STALE = (
    mark("L*, C* and h: lines of the last paint that can be"),
    mark("Lines of the last paint that can be"),
    mark("Earlier lines"),
)
_PAUSE_MS = 15
_SHOWN_KEY = "designer/plots"


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
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._box.setSpacing(4)
        self.caption = Caption(*map(tr, _FRESH))
        self.caption.setToolTip(
            tr("Points are what is asked at the measured angles; drag one up or down to change it.")
        )
        head = QHBoxLayout()
        head.setSpacing(8)
        head.addWidget(self.caption, 1)
        head.addWidget(LineKey(tr("model"), QPalette.ColorRole.PlaceholderText, MODEL_WIDTH))
        head.addWidget(
            LineKey(tr("fitted lobes"), QPalette.ColorRole.WindowText, FIT_WIDTH, Qt.PenStyle.DashLine)
        )
        self.buttons = [self._button(number) for number in range(len(QUANTITIES))]
        for button in self.buttons:
            head.addWidget(button)
        self._box.addLayout(head)
        self.plots: list[QuantityPlot] = []
        self._colours: Colours | None = None
        self._curves: Curves | None = None
        self._new_colours = self._new_curves = False
        self._drawing = QTimer(self)
        self._drawing.setSingleShot(True)
        self._drawing.setInterval(_PAUSE_MS)
        self._drawing.timeout.connect(self.draw_now)

    @property
    def is_built(self) -> bool:
        """Whether the plots are there."""
        return bool(self.plots)

    def build(self) -> None:
        """Make the plots and show what was set so far."""
        for quantity in QUANTITIES:
            plot = QuantityPlot(quantity)
            component = quantity.component
            plot.started.connect(lambda index, c=component: self.drag_started.emit(index, c))
            plot.edited.connect(lambda index, value, c=component: self.edited.emit(index, c, value))
            plot.finished.connect(self.drag_finished)
            self._box.addWidget(plot, 1)
            self.plots.append(plot)
        self._show_chosen()
        self._new_colours = self._new_curves = True
        self.draw_now()

    def show_colours(self, colours: Colours) -> None:
        """Show the readings as points."""
        self._colours, self._new_colours = colours, True
        if self.plots:
            self._drawing.start()

    def show_curves(self, curves: Curves) -> None:
        """Show model and lobes, fresh."""
        self._curves, self._new_curves = curves, True
        self.caption.set_forms(*map(tr, _FRESH))
        if self.plots:
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
        shown = str(settings().value(_SHOWN_KEY, "012"))
        button.setChecked(str(number) in shown)
        button.setAccessibleName(tr("Show the plot of {name}").format(name=tr(quantity.name)))
        button.setToolTip(tr(quantity.tip))
        button.clicked.connect(lambda: self._toggled(number))
        return button

    def _toggled(self, number: int) -> None:
        if not any(button.isChecked() for button in self.buttons):
            self.buttons[number].setChecked(True)
        shown = "".join(str(i) for i, button in enumerate(self.buttons) if button.isChecked())
        settings().setValue(_SHOWN_KEY, shown)
        self._show_chosen()
        self._new_colours = self._new_curves = True
        self.draw_now()

    def _show_chosen(self) -> None:
        shown = [plot for plot, button in zip(self.plots, self.buttons, strict=True) if button.isChecked()]
        for place, plot in enumerate(self.plots, 1):
            lowest = plot is shown[-1]
            plot.setVisible(plot in shown)
            plot.show_axis(lowest)
            # The lowest has the axis below it, which takes about half the room of a plot.
            self._box.setStretch(place, 3 if lowest else 2)
