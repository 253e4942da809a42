"""The albedo over the incidence, a line per visible reflectance; pyqtgraph is imported when the plot is first seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QHideEvent, QPalette, QShowEvent
from PySide6.QtWidgets import QWidget

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
        described(self, name="albedo_plot", spoken=tr("Albedo over the incidence"))
        self.setMinimumSize(220, 140)
        self.empty = PlainLabel(tr("No albedo yet."), alignment=Qt.AlignmentFlag.AlignCenter)
        self._box = fill_column(self, self.empty, grows=self.empty)
        self.plot: Any = None
        self.curves: list[Any] = []
        self.lines: Sequence[AlbedoLine] = ()
        """What is drawn."""

    def show_lines(self, lines: Sequence[AlbedoLine]) -> None:
        self.lines = tuple(lines)
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
        from brdf_lobe_visualizer.cuts.plot_items import SlicePlot, level

        self.plot = SlicePlot(with_axes=True)
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.plot.showGrid(x=True, y=True, alpha=0.15)
        self.plot.setLabel("bottom", tr("Incidence θi (°)"))
        self.plot.setLabel("left", tr("Luminous albedo"))
        self.plot.setMouseEnabled(x=False, y=False)
        self._whole = level(1.0)
        self._whole.setToolTip(tr("Total reflection"))
        self.plot.addItem(self._whole, ignoreBounds=True)
        self._box.insertWidget(0, self.plot, 1)
        self._dress()

    def _dress(self) -> None:
        self.plot.dress()
        self._whole.setPen(grey_pen(self.palette(), 0.6))

    def _draw(self) -> None:
        self.empty.setVisible(not self.lines)
        if self.plot is None:
            if not self.lines:
                return
            self._build()
        self.plot.setVisible(bool(self.lines))
        base = self.palette().color(QPalette.ColorRole.Base)
        while len(self.curves) < len(self.lines):
            self.curves.append(self.plot.plot(antialias=True))
        for curve, line in zip(self.curves, self.lines, strict=False):
            colour = colour_of(line.subject.colour, base)
            colour.setAlphaF(0.5 if line.stale else 1.0)
            curve.setPen(dashed_pen(colour, 2.4 if line.front else 1.6, line.subject.dash))
            curve.setData(line.incidence_deg, line.albedo)
            curve.setVisible(True)
        for curve in self.curves[len(self.lines) :]:
            curve.setVisible(False)
        top = max((float(line.albedo.max()) for line in self.lines), default=1.0)
        self.plot.setXRange(0.0, 90.0, padding=0.0)
        self.plot.setYRange(0.0, max(1.05, 1.05 * top), padding=0.0)
