"""One quantity over the aspecular angle: readings as points that are dragged or moved by keys, two lines.

pyqtgraph is imported with the first plot, after the window is first painted.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pyqtgraph as pg
from brdf_qt.fields.burst import Burst
from brdf_qt.fields.form import fill_column
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QPalette
from PySide6.QtWidgets import QGraphicsItem, QWidget

from brdf_designer.colour.plot_items import ReadingPoint, dress_plot, hatch, line, make_plot
from brdf_designer.colour.quantities import FIT_WIDTH, MODEL_WIDTH, Quantity
from brdf_designer.session.state import AngleColour, Curves
from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.flop.edits import unwrap_hues
from brdf_suite.arrays import Floats

_ROOM, _BELOW = 1.12, 0.1
_LEAST_HUES = 40.0


class QuantityPlot(QWidget):
    """The plot of one quantity.

    Signals: ``edited(index, value)`` while a point is dragged or moved by keys, between ``started(index)`` and
    ``finished()``.
    """

    edited = Signal(int, float)
    started = Signal(int)
    finished = Signal()

    def __init__(self, quantity: Quantity, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._quantity = quantity
        self._angles: tuple[AngleColour, ...] = ()
        self._values: Floats = np.zeros(0)
        self._chosen = 0
        self._curves: Curves | None = None
        self.points: list[Any] = []
        self.plot = make_plot(tr(quantity.axis), turns=quantity.component == 2)
        self._model, self._fitted = self.plot.plot(connect="finite"), self.plot.plot(connect="finite")
        self._unmeasured = pg.LinearRegionItem((0.0, 15.0), movable=False)
        # Hatching it costs 2 ms a frame; as a kept picture it costs nothing.
        self._unmeasured.setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)
        self._unmeasured.setZValue(-10)
        self.plot.addItem(self._unmeasured)
        hue = quantity.component == 2
        self._note = pg.TextItem(tr("A grey has no hue.") if hue else tr("not measured"), anchor=(0.0, 1.0))
        self.plot.addItem(self._note, ignoreBounds=True)
        self._note.setVisible(quantity.component == 0)
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumHeight(56)
        self.setAccessibleName(tr("{name} over the aspecular angle").format(name=tr(quantity.name)))
        self.setToolTip(
            tr(quantity.tip)
            + "\n"
            + tr(
                "Drag a point, or choose one with Left and Right and move it with Up and Down (Shift: fine)."
            )
        )
        fill_column(self, self.plot)
        self._burst = Burst(self)
        self._burst.started.connect(lambda: self.started.emit(self._angles[self._chosen].index))
        self._burst.finished.connect(self.finished)
        self._take_palette()

    def show_axis(self, named: bool) -> None:
        """Name the angle below the plot, or leave that to a plot further down."""
        self.plot.setLabel("bottom", tr("Aspecular angle (degrees)") if named else None)
        self.plot.getAxis("bottom").setStyle(showValues=named)

    def show_angles(self, angles: tuple[AngleColour, ...]) -> None:
        """Show the readings as points; a grey has no hue, and no point in its plot."""
        self._angles = angles
        self._values = self._of([angle.lab for angle in angles])
        self._chosen = min(self._chosen, len(angles) - 1)
        if len(self.points) != len(angles):
            for point in self.points:
                self.plot.removeItem(point)
            self.points = [self._new_point() for _ in angles]
        for point, angle, value in zip(self.points, angles, self._values.tolist(), strict=True):
            known = math.isfinite(value)
            point.setVisible(known)
            if known:
                point.show_reading(angle.index, angle.aspecular_deg, value, QColor(*angle.rgb))
        self._ring()

    def show_curves(self, curves: Curves) -> None:
        """Show model and lobes."""
        self._curves = curves
        lines = [self._of(lab) for lab in (curves.model, curves.fitted)]
        if self._quantity.component == 2:
            lines = [self._turned(curves.gamma_deg, hues) for hues in lines]
        self._model.setData(curves.gamma_deg, lines[0])
        self._fitted.setData(curves.gamma_deg, lines[1])
        first = curves.measured_deg[0]
        self._unmeasured.setRegion((0.0, first))
        self._unmeasured.setVisible(first > 0.0)
        if not self.dragging:
            self._scale(curves, lines)

    @property
    def dragging(self) -> bool:
        """Whether a point is being dragged."""
        return any(point.dragging for point in self.points)

    def _of(self, lab: Any) -> Floats:
        """The quantity of L*a*b* (n, 3); hues run on over 360, NaN for a grey."""
        if self._quantity.component == 2:
            return unwrap_hues(lab)
        lch: Floats = lab_to_lch(lab)[:, self._quantity.component]
        return lch

    def _turned(self, gamma: Floats, hues: Floats) -> Floats:
        """The hues with as many whole turns as bring them to the points."""
        for angle, value in zip(self._angles, self._values.tolist(), strict=True):
            near = int(np.argmin(np.abs(gamma - angle.aspecular_deg)))
            if math.isfinite(value) and math.isfinite(hues[near]):
                return np.asarray(hues + 360.0 * round((value - hues[near]) / 360.0))
        return hues

    def _scale(self, curves: Curves, lines: list[Floats]) -> None:
        nearest = min(0.0, *(angle.aspecular_deg for angle in self._angles))
        self.plot.setXRange(
            nearest - (2.0 if nearest < 0.0 else 0.0), curves.measured_deg[1] + 4.0, padding=0
        )
        measured = curves.gamma_deg >= curves.measured_deg[0]
        seen = np.concatenate((self._values, lines[0][measured]))
        seen = seen[np.isfinite(seen)]
        if self._quantity.component == 2:
            # An empty plot says why it is empty.
            self._note.setVisible(not len(seen))
            low, high = (float(seen.min()), float(seen.max())) if len(seen) else (0.0, 360.0)
            room = max(0.12 * (high - low), 0.5 * (_LEAST_HUES - (high - low)))
            bottom, top = 10.0 * math.floor((low - room) / 10.0), 10.0 * math.ceil((high + room) / 10.0)
        else:
            ceiling = max(
                curves.ceiling if self._quantity.component == 0 else 0.0, float(seen.max(initial=0.0))
            )
            # Steps of 10 keep the axes still during most of a drag; what does not change is not drawn anew.
            top = 10.0 * max(1.0, math.ceil(ceiling * _ROOM / 10.0))
            # A point at 0 is seen, and can be gripped, whole.
            bottom = -_BELOW * top if float(seen.min(initial=top)) < _BELOW * top else 0.0
        self.plot.setYRange(bottom, top, padding=0)
        self._note.setPos(0.2, bottom)

    def _new_point(self) -> Any:
        point = ReadingPoint(self._quantity.lowest, self._quantity.highest)
        point.started.connect(self._grabbed)
        point.moved.connect(self.edited)
        point.finished.connect(self._released)
        self.plot.addItem(point)
        return point

    def _grabbed(self, index: int) -> None:
        self._burst.end()
        self._chosen = next(i for i, angle in enumerate(self._angles) if angle.index == index)
        self.started.emit(index)

    def _released(self) -> None:
        self.finished.emit()
        if self._curves is not None:
            self.show_curves(self._curves)

    # The keyboard.

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose a point by Left and Right, move it by Up and Down."""
        key, fine = event.key(), bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        steps = {
            Qt.Key.Key_Up: 1.0,
            Qt.Key.Key_Down: -1.0,
            Qt.Key.Key_PageUp: 10.0,
            Qt.Key.Key_PageDown: -10.0,
        }
        sides = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
        if not self._angles or (key not in steps and key not in sides):
            super().keyPressEvent(event)
        elif key in sides:
            self._burst.end()
            self._chosen = (self._chosen + sides[Qt.Key(key)]) % len(self._angles)
            self._ring()
        elif math.isfinite(self._values[self._chosen]):
            step = self._quantity.step * (0.2 if fine else 1.0)
            value = float(self._values[self._chosen]) + steps[Qt.Key(key)] * step
            value = min(self._quantity.highest, max(self._quantity.lowest, value))
            self._burst.touch()
            self.edited.emit(self._angles[self._chosen].index, round(value, 2))

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self._ring()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.end()
        super().focusOutEvent(event)
        self._ring()

    def _ring(self) -> None:
        accent = self.palette().color(QPalette.ColorRole.Highlight)
        for number, point in enumerate(self.points):
            point.set_chosen(accent if self.hasFocus() and number == self._chosen else None)
        if self._angles:
            angle, value = self._angles[self._chosen], float(self._values[self._chosen])
            reading = decimal(f"{value % 360.0 if self._quantity.component == 2 else value:.1f}")
            text = f"{angle.text}: {tr(self._quantity.axis)} {reading if math.isfinite(value) else '–'}"
            if text != self.accessibleDescription():
                self.setAccessibleDescription(text)

    # The theme.

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._take_palette()

    def _take_palette(self) -> None:
        role = QPalette.ColorRole
        text = self.palette().color(role.WindowText)
        faint = self.palette().color(role.PlaceholderText)
        dress_plot(self.plot, text, self.palette().color(role.Base))
        self._model.setPen(line(faint, MODEL_WIDTH))
        self._fitted.setPen(line(text, FIT_WIDTH, Qt.PenStyle.DashLine))
        self._unmeasured.setBrush(hatch(faint))
        for edge in self._unmeasured.lines:
            edge.setPen(line(QColor(0, 0, 0, 0), 0.0))
        self._note.setColor(text)
        self._ring()
