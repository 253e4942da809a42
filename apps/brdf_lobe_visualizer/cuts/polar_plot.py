"""The plane of incidence as a polar plot: normal upwards, light at the left, mirror direction at the right."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.crosshair import rows_at
from brdf_lobe_visualizer.cuts.line_plot import LinePlot
from brdf_lobe_visualizer.cuts.lines import Line, Lines, largest
from brdf_lobe_visualizer.cuts.section import Polar
from brdf_lobe_visualizer.options import Options
from brdf_lobe_visualizer.words import degrees, plain, quantity
from brdf_suite.arrays import Floats
from brdf_suite.inspection.slices.values import LOG_DECADES, Scale, nice_above, radius_of

_SCALES: dict[Scale, str] = {
    "linear": mark("linear radius"),
    "cbrt": mark("cube-root radius"),
    "log": mark("log radius"),
}
_CLEAR_PX = 26.0
_SIDE_PX, _TOP_PX, _FOOT_PX = 44.0, 24.0, 22.0
"""Room for the labels round the half disc."""
_SPREAD = {"linear": 30.0, "cbrt": 300.0}
"""Where the greatest value is so many times the usual one, a line other than logarithmic shows the peak alone."""
_LABELLED_DEG = (-90, -60, -30, 0, 30, 60, 90)


class PolarPlot(LinePlot):
    """The polar plot."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("polar_plot", tr("Polar plot of the plane of incidence"), parent)
        self._phi_deg = 0.0
        self._radius: Polar = "range"
        self._rung: tuple[Scale, float] | None = None
        self.outer = 1.0
        self.scale: Scale = "cbrt"
        self._unit = 100.0

    def make_items(self, items: ModuleType) -> None:
        self.plot.setMouseEnabled(x=False, y=False)
        self._make_text = items.text
        self._rings = items.PolarRings()
        self._light, self._mirror, self._cross = (items.LineItem() for _ in range(3))
        for item in (self._rings, self._light, self._mirror, self._cross):
            self.plot.addItem(item, ignoreBounds=True)
        self._angles = [self._label(f"{abs(angle)}°", _anchor(angle)) for angle in _LABELLED_DEG]
        for angle, item in zip(_LABELLED_DEG, self._angles, strict=True):
            item.setPos(1.02 * np.sin(np.radians(angle)), 1.02 * np.cos(np.radians(angle)))
        self._radii: list[Any] = []
        self._light_name = self._label("", (1.0, 1.0))
        self._mirror_name = self._label("", (0.0, 1.0))
        self.plot.resized.connect(self._resized)
        self._fit_range()

    def show_lines(
        self,
        lines: Lines,
        incidence_deg: tuple[float, float],
        options: Options,
        radius: Polar = "range",
    ) -> None:
        """Draw the lines of a cut of the plane of incidence over θo; the light is at ``incidence_deg``."""
        self.lines, self._options, self._radius = lines, options, radius
        self._theta_deg, self._phi_deg = incidence_deg
        if self.plot is not None:
            self.draw()

    def _label(self, words: str, anchor: tuple[float, float]) -> Any:
        item = self._make_text(words, anchor)
        self.plot.addItem(item, ignoreBounds=True)
        return item

    def _fit_range(self) -> None:
        """Take the half disc as large as the widget lets it be, its middle in the widget's."""
        area: QRect = self.plot.rect()
        wide, high = max(area.width(), 1), max(area.height(), 1)
        unit = self._unit = max(10.0, min((wide - 2.0 * _SIDE_PX) / 2.0, high - _TOP_PX - _FOOT_PX))
        self._rung = None
        middle = 0.5 * (high - unit - _TOP_PX - _FOOT_PX) + _FOOT_PX
        x, y = (-0.5 * wide / unit, 0.5 * wide / unit), (-middle / unit, (high - middle) / unit)
        self.plot.setRange(xRange=x, yRange=y, padding=0.0, disableAutoRange=True)

    def _resized(self) -> None:
        self._fit_range()
        self.draw()

    def draw(self) -> None:
        lines = self.lines
        if self.show_empty() or lines is None:
            return
        scale = self.scale = self._chosen_scale(lines)
        self.outer = nice_above(1.02 * largest(lines.lines))
        self._ring(scale)
        theta = np.radians(lines.cut.angle_deg)
        sine, cosine = np.sin(theta), np.cos(theta)
        drawn = []
        for line in lines.lines:
            radius = radius_of(np.abs(line.value), scale, self.outer)
            if line.filled is not None:
                radius = np.where(line.filled, np.nan, radius)
            drawn.append((line, radius * sine, radius * cosine))
        self.plot.show_lines(drawn)
        self._draw_points(scale)
        self._place(self._light, self._light_name, -self._theta_deg, tr("light"))
        self._place(self._mirror, self._mirror_name, self._theta_deg, tr("mirror"))
        words = [quantity(self._options), tr(_SCALES[scale])]
        if lines.signed:
            words.append(tr("absolute differences"))
        words.append(tr("θi {theta}°").format(theta=f"{self._theta_deg:.1f}"))
        if self._phi_deg:
            words.append(tr("φi {phi}°").format(phi=f"{self._phi_deg:.1f}".replace("-", "−")))
        if any(line.is_front and line.filled is not None and line.filled.any() for line in lines.lines):
            words.append(tr("gaps: not measured"))
        self.note.setText(" · ".join(words))

    def _chosen_scale(self, lines: Lines) -> Scale:
        if self._radius != "range":
            return self._radius
        chosen: Scale = self._options.radius
        return "log" if chosen != "log" and spread_of(lines) > _SPREAD[chosen] else chosen

    def _draw_points(self, scale: Scale) -> None:
        drawn: list[tuple[Line, Floats, Floats]] = []
        for line, points in self.sampled_lines():
            radius, theta = radius_of(points.value, scale, self.outer), np.radians(points.angle_deg)
            drawn.append((line, radius * np.sin(theta), radius * np.cos(theta)))
        self.plot.show_points(drawn)

    def _ring(self, scale: Scale) -> None:
        """Draw the rings and what they stand for, where that is not there yet."""
        if self._rung == (scale, self.outer):
            return
        if self._rung is None or self._rung[0] != scale:
            shares = {
                "linear": (0.25, 0.5, 0.75, 1.0),
                "cbrt": (1.0 / 64.0, 0.125, 0.5, 1.0),
                "log": tuple(10.0 ** -float(k) for k in range(int(LOG_DECADES))),
            }[scale]
            radii = [float(radius_of(np.array(share), scale, 1.0)) for share in shares]
            self._rings.show_rings(radii, self.palette())
            # Not every ring has room for its number.
            named = {"linear": (0.5, 1.0), "cbrt": (1.0 / 64.0, 0.125, 1.0), "log": (1e-4, 1e-2, 1.0)}[scale]
            self._shares = tuple((share, float(radius_of(np.array(share), scale, 1.0))) for share in named)
        while len(self._radii) < len(self._shares):
            self._radii.append(self._label("", (0.5, 0.0)))
            self._radii[-1].setColor(self.palette().color(QPalette.ColorRole.Text))
        for item in self._radii[len(self._shares) :]:
            item.setVisible(False)
        for item, (share, radius) in zip(self._radii, self._shares, strict=False):
            item.setText(plain(share * self.outer))
            item.setPos(radius, 0.0)
        self._clear_radii()
        self._rung = (scale, self.outer)

    def _clear_radii(self) -> None:
        """Hide the numbers that have no room, from the outermost inwards."""
        metrics, free = self.plot.fontMetrics(), 1e9
        for item, (share, radius) in reversed(list(zip(self._radii, self._shares, strict=False))):
            half = 0.5 * metrics.horizontalAdvance(plain(share * self.outer)) + 3.0
            fits = radius * self._unit + half <= free
            item.setVisible(fits)
            if fits:
                free = radius * self._unit - half

    def _place(self, line: Any, name: Any, angle_deg: float, text: str) -> None:
        sine, cosine = np.sin(np.radians(angle_deg)), np.cos(np.radians(angle_deg))
        line.set_data(np.array([0.0, 1.0 * sine]), np.array([0.0, 1.0 * cosine]))
        # Beside a labelled spoke the two texts would lie on each other.
        nearest = min(abs(angle_deg - labelled) for labelled in _LABELLED_DEG)
        clear = bool(np.radians(nearest) * self._unit > _CLEAR_PX)
        name.setVisible(clear)
        if clear:
            name.setText(text)
            name.setPos(1.01 * sine, 1.01 * cosine)

    def read(self, x: float, y: float) -> None:
        if self.lines is None or not self.lines.lines or y < -0.2:
            return
        angle, rows = rows_at(self.lines, float(np.degrees(np.arctan2(x, max(y, 0.0)))))
        turn = np.radians(angle)
        self._cross.set_data(np.array([0.0, np.sin(turn)]), np.array([0.0, np.cos(turn)]))
        self._cross.setVisible(True)
        head = f"{degrees('theta_o', angle)}  {degrees('gamma', self._theta_deg - angle)}"
        self.readout.show_rows(head, rows, quantity(self._options), at_right=x < 0.0)

    def dress(self) -> None:
        text = self.palette().color(QPalette.ColorRole.Text)
        for item in (*self._angles, *self._radii, self._light_name, self._mirror_name):
            item.setColor(text)
        styles = (Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.SolidLine)
        for item, alpha, style in zip(
            (self._light, self._mirror, self._cross), (0.6, 0.5, 0.8), styles, strict=True
        ):
            item.set_pen(self.pen(alpha, style))
        self._rung = None


def spread_of(lines: Lines) -> float:
    """Return how many times the median the greatest value is, of the line where that is most; at least 1."""
    spreads = [1.0]
    for line in lines.lines:
        sizes = np.abs(line.value[np.isfinite(line.value)])
        sizes = sizes[sizes > 0.0]
        if sizes.size:
            # Half of a line's angles lie about the peak: the quarter of the flank stands for what else there is.
            # Partly sorted: a quantile takes ten times as long, and this is asked for at every step of a drag.
            quarter = len(sizes) // 4
            spreads.append(float(sizes.max() / np.partition(sizes, quarter)[quarter]))
    return max(spreads)


def _anchor(angle_deg: float) -> tuple[float, float]:
    """Return which place of a label lies at the rim, so that the label is outside of it.

    Those at the horizon stand on it: below it are the numbers of the rings.
    """
    down = 1.0 if abs(angle_deg) == 90 else 0.5 + 0.5 * float(np.cos(np.radians(angle_deg)))
    return 0.5 - 0.5 * float(np.sin(np.radians(angle_deg))), down
