"""Curves over an axis, without colour but for the channels': they differ in dash and width too.

pyqtgraph is imported with the first plot, after the window of its page is first shown.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
import pyqtgraph as pg
from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.program.translation import decimal
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QPalette, QPen
from PySide6.QtWidgets import QWidget

from brdf_designer.colour.plot_items import dress_plot, line, make_plot

Kind = Literal["red", "green", "blue", "text", "faint"]
Mark = Literal["line", "points"]
# Red, green and blue that protan, deutan and tritan eyes distinguish, on dark and on light grounds.
_COLOURS = {"red": ("#d9694f", "#b5452c"), "green": ("#8fbf6a", "#4f8a2b"), "blue": ("#6f9ae0", "#2f5fb0")}
_DASHES: dict[str, tuple[float, ...]] = {
    "solid": (),
    "dash": (7.0, 4.0),
    "dot": (1.6, 3.0),
}
_ROOT_TICKS = (0.0, 0.5, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 90.0)
CHANNELS: tuple[tuple[Kind, str], ...] = (("red", "solid"), ("green", "dash"), ("blue", "dot"))
"""The look of the three channels."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A line or points through ``x`` and ``y`` (n,); what is NaN is left out."""

    x: NDArray[np.floating]
    y: NDArray[np.floating]
    name: str = ""
    kind: Kind = "text"
    dash: str = "solid"
    mark: Mark = "line"
    width: float = 1.6


@dataclass(frozen=True)
class Axis:
    """The name of an axis with its unit, whether it is logarithmic, and its range where that is fixed.

    ``root``: as its square root, so that small angles have room; of x alone.
    """

    name: str
    log: bool = False
    reach: tuple[float, float] | None = None
    root: bool = False


class LinesPlot(QWidget):
    """Curves with named axes and a legend."""

    def __init__(self, name: str, x: Axis, y: Axis, *, rising: bool = False) -> None:
        super().__init__()
        self._x, self._y = x, y
        self.curves: tuple[Curve, ...] = ()
        self._marks: tuple[tuple[float, str], ...] = ()
        self._items: list[Any] = []
        logarithmic = tuple(side for side, axis in (("bottom", x), ("left", y)) if axis.log)
        self.plot = make_plot(y.name, decades=logarithmic)
        for side in ("bottom", "left"):
            # A factor of a thousand in the name of an axis is easily read over.
            self.plot.getAxis(side).enableAutoSIPrefix(False)
        self.plot.setLabel("bottom", x.name)
        self.plot.setLogMode(x=x.log, y=y.log)
        if x.root:
            # More of them would lie on each other in a small window.
            self.plot.getAxis("bottom").setTicks(
                [[(math.sqrt(at), decimal(f"{at:g}")) for at in _ROOT_TICKS]]
            )
        self.plot.getAxis("left").setWidth(64)
        self.plot.getPlotItem().vb.setDefaultPadding(0.03)
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        # Curves that rise leave room at the left.
        self._legend = self.plot.addLegend(offset=(8, 8) if rising else (-8, 8))
        self.setAccessibleName(name)
        self.setToolTip(plain_tip(name))
        self.setMinimumSize(160, 120)
        self._empty = PlainLabel()
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setWordWrap(True)
        self._empty.setBackgroundRole(QPalette.ColorRole.Base)
        self._empty.setAutoFillBackground(True)
        self._empty.setMargin(24)
        self._empty.hide()
        fill_column(self, self.plot, self._empty)
        self._take_palette()

    def sizeHint(self) -> QSize:
        return QSize(480, 280)

    def show_empty(self, text: str) -> None:
        """Show no curves, and say why."""
        self.show_curves(())
        self._empty.setText(text)
        self.setAccessibleDescription(text)
        self.plot.hide()
        self._empty.show()

    def show_curves(self, curves: Sequence[Curve], marks: Sequence[tuple[float, str]] = ()) -> None:
        """Draw these curves, and a line down at each of ``marks``, a place on x and its name."""
        self._empty.hide()
        self.plot.show()
        self.curves = tuple(curves)
        self._marks = tuple(marks)
        self._draw()
        self.setAccessibleDescription(", ".join(curve.name for curve in curves if curve.name))

    def _draw(self) -> None:
        for item in self._items:
            self.plot.removeItem(item)
        self._legend.clear()
        self._items = []
        for curve in self.curves:
            y = np.asarray(curve.y, dtype=float)
            x = np.asarray(curve.x, dtype=float)
            if self._y.log:
                y = np.where(y > 0.0, y, np.nan)
            if self._x.log:
                x = np.where(x > 0.0, x, np.nan)
            if self._x.root:
                x = np.sqrt(np.maximum(x, 0.0))
            known = np.isfinite(x) & np.isfinite(y)
            named = {"name": curve.name} if curve.name else {}
            if curve.mark == "points":
                item = self.plot.plot(
                    x[known],
                    y[known],
                    pen=None,
                    symbol="o",
                    symbolSize=4.0 + curve.width,
                    symbolPen=self._pen(curve, 1.2),
                    symbolBrush=QColor(0, 0, 0, 0),
                    **named,
                )
            else:
                # A gap stays a gap.
                item = self.plot.plot(
                    x, np.where(known, y, np.nan), pen=self._pen(curve), connect="finite", **named
                )
            self._items.append(item)
        for place, name in self._marks:
            pen = line(self._colour("faint"), 1.0)
            endless = pg.InfiniteLine(np.log10(place) if self._x.log else place, pen=pen)
            self.plot.addItem(endless, ignoreBounds=True)
            # A line without an end is named in the legend by one that has no points.
            self._items += [endless, self.plot.plot([], [], pen=pen, name=name)]
        self._range()

    def _range(self) -> None:
        for axis, way in ((self._x, "x"), (self._y, "y")):
            if axis.reach is None:
                self.plot.enableAutoRange(axis=way)
            else:
                low, high = (
                    np.log10(axis.reach) if axis.log else np.sqrt(axis.reach) if axis.root else axis.reach
                )
                (self.plot.setXRange if way == "x" else self.plot.setYRange)(low, high, padding=0.0)

    def set_reach(self, x: tuple[float, float] | None = None, y: tuple[float, float] | None = None) -> None:
        """Fix the range of an axis, or let it follow the curves."""
        self._x = replace(self._x, reach=x)
        self._y = replace(self._y, reach=y)
        self._range()

    def _colour(self, kind: Kind) -> QColor:
        role = QPalette.ColorRole
        if kind == "text":
            return self.palette().color(role.Text)
        if kind == "faint":
            return self.palette().color(role.PlaceholderText)
        dark = self.palette().color(role.Base).lightnessF() < 0.5
        return QColor(_COLOURS[kind][0 if dark else 1])

    def _pen(self, curve: Curve, width: float | None = None) -> QPen:
        width = curve.width if width is None else width
        # The width of a cosmetic pen is in pixels of the device.
        pen = line(self._colour(curve.kind), width * self.devicePixelRatioF())
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        dashes = _DASHES[curve.dash]
        if dashes and curve.mark != "points":
            pen.setDashPattern([length / max(width, 1.0) * 1.4 for length in dashes])
        return pen

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "plot"):
            self._take_palette()

    def _take_palette(self) -> None:
        role = QPalette.ColorRole
        dress_plot(self.plot, self.palette().color(role.WindowText), self.palette().color(role.Base))
        self._legend.setLabelTextColor(self.palette().color(role.WindowText))
        if self.curves:
            self._draw()
