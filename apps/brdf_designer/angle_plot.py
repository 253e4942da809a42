"""L* over the aspecular angle: readings as points that can be dragged, the model and its lobes as lines.

pyqtgraph takes a quarter of a second to import, so the plot is built after the window is first painted.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QVBoxLayout, QWidget

from brdf_designer.caption import Caption
from brdf_designer.desk_state import Colours, Curves
from brdf_designer.line_key import LineKey

if TYPE_CHECKING:
    import pyqtgraph

_HIGHEST = 250.0
_ROOM = 1.12
MODEL_WIDTH, FIT_WIDTH = 4.0, 1.6
_FRESH = ("Lightness over the aspecular angle", "Lightness")
_STALE = ("Lightness: lines of the last paint that can be", "Lightness (earlier)")


class AnglePlot(QWidget):
    """The plot; :meth:`build` makes it, and until then what is shown is kept.

    Signals: ``lightness_edited(index, L*)`` while a point is dragged, between ``drag_started(index)`` and
    ``drag_finished()``.
    """

    lightness_edited = Signal(int, float)
    drag_started = Signal(int)
    drag_finished = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumHeight(90)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._box.setSpacing(4)
        self.caption = Caption(*_FRESH)
        self.caption.setToolTip("Points are readings; drag one up or down to change it.")
        head = QHBoxLayout()
        head.setSpacing(16)
        head.addWidget(self.caption, 1)
        head.addWidget(LineKey("model", QPalette.ColorRole.PlaceholderText, MODEL_WIDTH))
        head.addWidget(
            LineKey("fitted lobes", QPalette.ColorRole.WindowText, FIT_WIDTH, Qt.PenStyle.DashLine)
        )
        self._box.addLayout(head)
        self._plot: pyqtgraph.PlotWidget | None = None
        self._colours: Colours | None = None
        self._curves: Curves | None = None
        self._stale = False
        self._points: list[Any] = []

    @property
    def is_built(self) -> bool:
        """Whether the plot is there."""
        return self._plot is not None

    def build(self) -> None:
        """Make the plot and show what was set so far."""
        import pyqtgraph as pg

        from brdf_designer.plot_items import ReadingPoint, make_plot

        self._point_type = ReadingPoint
        self._plot = make_plot()
        self._model = self._plot.plot()
        self._fitted = self._plot.plot()
        self._unmeasured = pg.LinearRegionItem((0.0, 15.0), movable=False)
        self._unmeasured.setZValue(-10)
        self._plot.addItem(self._unmeasured)
        self._note = pg.TextItem("not measured", anchor=(0.0, 1.0))
        self._plot.addItem(self._note, ignoreBounds=True)
        self._box.addWidget(self._plot, 1)
        self._take_palette()
        if self._colours is not None:
            self.show_colours(self._colours)
        if self._curves is not None:
            self.show_curves(self._curves)
        if self._stale:
            self.mark_stale()

    def show_colours(self, colours: Colours) -> None:
        """Show the readings as points."""
        self._colours = colours
        if self._plot is None:
            return
        if len(self._points) != len(colours.angles):
            for point in self._points:
                self._plot.removeItem(point)
            self._points = [self._new_point() for _ in colours.angles]
        for point, colour in zip(self._points, colours.angles, strict=True):
            point.show_reading(colour.index, colour.aspecular_deg, colour.lab[0], QColor(*colour.rgb))
            point.setToolTip(f"{colour.text}: L* {colour.lab[0]:.1f}")

    def show_curves(self, curves: Curves) -> None:
        """Show model and lobes, fresh."""
        self._curves, self._stale = curves, False
        if self._plot is None:
            return
        self.caption.set_forms(*_FRESH)
        self._model.setData(curves.gamma_deg, curves.model)
        self._fitted.setData(curves.gamma_deg, curves.fitted)
        first, last = curves.measured_deg
        self._unmeasured.setRegion((0.0, first))
        self._unmeasured.setVisible(first > 0.0)
        if not self._dragging():
            # Steps of 10 keep the axes still during most of a drag; what does not change is not drawn anew.
            top = 10.0 * max(1.0, math.ceil(curves.ceiling * _ROOM / 10.0))
            self._plot.setXRange(0.0, last + 4.0, padding=0)
            self._plot.setYRange(0.0, top, padding=0)
            self._note.setPos(0.2, 0.0)

    def mark_stale(self) -> None:
        """Say that the lines are of the last paint that could be."""
        self._stale = True
        self.caption.set_forms(*_STALE)

    def _new_point(self) -> Any:
        assert self._plot is not None
        point = self._point_type(_HIGHEST)
        point.started.connect(self.drag_started)
        point.moved.connect(self.lightness_edited)
        point.finished.connect(self._drag_ended)
        self._plot.addItem(point)
        return point

    def _drag_ended(self) -> None:
        self.drag_finished.emit()
        if self._curves is not None and not self._stale:
            self.show_curves(self._curves)

    def _dragging(self) -> bool:
        return any(point.dragging for point in self._points)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._plot is not None:
            self._take_palette()

    def _take_palette(self) -> None:
        from brdf_designer.plot_items import dress_plot, hatch, line

        assert self._plot is not None
        role = QPalette.ColorRole
        text = self.palette().color(role.WindowText)
        faint = self.palette().color(role.PlaceholderText)
        dress_plot(self._plot, text, self.palette().color(role.Base))
        self._model.setPen(line(faint, MODEL_WIDTH))
        self._fitted.setPen(line(text, FIT_WIDTH, Qt.PenStyle.DashLine))
        self._unmeasured.setBrush(hatch(faint))
        for edge in self._unmeasured.lines:
            edge.setPen(line(QColor(0, 0, 0, 0), 0.0))
        self._note.setColor(text)
