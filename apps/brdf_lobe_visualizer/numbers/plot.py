"""The albedo over the incidence, a line per visible reflectance; pyqtgraph is imported when the plot is first seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QHideEvent, QPalette, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from brdf_lobe_visualizer.cuts.pens import colour_of, dashed_pen, grey_pen
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_suite.arrays import Floats


@dataclass(frozen=True, eq=False)
class AlbedoLine:
    """A subject's line: ``albedo`` (k,) at ``incidence_deg`` (k,); pale where it is of what it was before."""

    subject: PlottedMaterial
    incidence_deg: Floats
    albedo: Floats
    stale: bool
    front: bool


class AlbedoPlot(QWidget):
    """Signals: ``seen(bool)`` when it comes into view or goes."""

    seen = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("albedo_plot")
        self.setMinimumSize(220, 140)
        self.setAccessibleName(tr("Albedo over the incidence"))
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self.empty = PlainLabel(tr("No albedo yet."))
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._box.addWidget(self.empty, 1)
        self.plot: Any = None
        self.curves: list[Any] = []
        self._lines: Sequence[AlbedoLine] = ()

    @property
    def lines(self) -> Sequence[AlbedoLine]:
        """What is drawn."""
        return self._lines

    def show_lines(self, lines: Sequence[AlbedoLine]) -> None:
        """Draw these lines in the place of those before."""
        self._lines = tuple(lines)
        if self.isVisible():
            self._draw()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.seen.emit(True)
        self._draw()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.seen.emit(False)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self.plot is not None:
            self._dress()
            self._draw()

    def _build(self) -> None:
        import pyqtgraph as pg

        self.plot = pg.PlotWidget()
        self.plot.setAntialiasing(True)
        self.plot.setMenuEnabled(False)
        self.plot.hideButtons()
        self.plot.setFrameShape(self.plot.Shape.NoFrame)
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.plot.showGrid(x=True, y=True, alpha=0.15)
        self.plot.setLabel("bottom", tr("Incidence θi (°)"))
        self.plot.setLabel("left", tr("Luminous albedo"))
        self.plot.getAxis("bottom").enableAutoSIPrefix(False)
        self.plot.getAxis("left").enableAutoSIPrefix(False)
        self.plot.setMouseEnabled(x=False, y=False)
        self._whole = pg.InfiniteLine(pos=1.0, angle=0, movable=False)
        self._whole.setToolTip(tr("Total reflection"))
        self.plot.addItem(self._whole, ignoreBounds=True)
        self._box.insertWidget(0, self.plot, 1)
        self._dress()

    def _dress(self) -> None:
        palette = self.palette()
        self.plot.setBackground(palette.color(QPalette.ColorRole.Base))
        for side in ("bottom", "left"):
            self.plot.getAxis(side).setPen(grey_pen(palette, 1.0))
            self.plot.getAxis(side).setTextPen(grey_pen(palette, 1.0))
        self._whole.setPen(grey_pen(palette, 0.6))

    def _draw(self) -> None:
        self.empty.setVisible(not self._lines)
        if self.plot is None:
            if not self._lines:
                return
            self._build()
        self.plot.setVisible(bool(self._lines))
        base = self.palette().color(QPalette.ColorRole.Base)
        while len(self.curves) < len(self._lines):
            self.curves.append(self.plot.plot(antialias=True))
        for curve, line in zip(self.curves, self._lines, strict=False):
            colour = colour_of(line.subject.colour, base)
            colour.setAlphaF(0.5 if line.stale else 1.0)
            curve.setPen(dashed_pen(colour, 2.4 if line.front else 1.6, line.subject.dash))
            curve.setData(line.incidence_deg, line.albedo)
            curve.setVisible(True)
        for curve in self.curves[len(self._lines) :]:
            curve.setVisible(False)
        top = max((float(line.albedo.max()) for line in self._lines), default=1.0)
        self.plot.setXRange(0.0, 90.0, padding=0.0)
        self.plot.setYRange(0.0, max(1.05, 1.05 * top), padding=0.0)
