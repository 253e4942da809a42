"""What the plots of lines share: the plot that is made late, words where there is nothing, a note, and the readout."""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType
from typing import Any

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import ElidedLabel, PlainLabel
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QPalette, QPen
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.crosshair import Readout
from brdf_lobe_visualizer.cuts.lines import Line, Lines
from brdf_lobe_visualizer.cuts.pens import grey_pen
from brdf_lobe_visualizer.options import Options
from brdf_suite.inspection.slices.values import SlicePoints


class LinePlot(QWidget):
    """A plot with its note; :meth:`build` makes it, which takes pyqtgraph a quarter of a second the first time.

    A plot of this kind has ``make_items(plot_items)``, ``dress``, ``draw`` and ``read(x, y)``.
    """

    with_axes = False

    def __init__(self, name: str, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        described(self, name=name, spoken=title)
        self.setMinimumSize(220, 140)
        self.lines: Lines | None = None
        """What is drawn."""
        self._theta_deg = 0.0
        self._options = Options()
        self.plot: Any = None
        self._cross: Any = None
        text = tr("No reflectance shown. Add one, or show one in the legend.")
        self.empty = PlainLabel(text, wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        self.note = ElidedLabel()
        self._box = fill_column(self, self.empty, self.note, grows=self.empty, spacing=4)

    def build(self) -> None:
        if self.plot is not None:
            return
        from brdf_lobe_visualizer.cuts import plot_items

        self.plot = described(plot_items.SlicePlot(with_axes=self.with_axes), spoken=self.accessibleName())
        self.make_items(plot_items)
        self._cross.setVisible(False)
        self._cross.setZValue(10)
        self.readout = Readout(self.plot)
        self.plot.moved_over.connect(self.read)
        self.plot.left.connect(self._leave)
        self._box.insertWidget(self._box.indexOf(self.empty), self.plot, 1)
        self.redress()

    def make_items(self, items: ModuleType) -> None:
        """Add what the plot has beside its lines, from the module :mod:`plot_items`."""
        raise NotImplementedError

    def dress(self) -> None:
        raise NotImplementedError

    def draw(self) -> None:
        raise NotImplementedError

    def read(self, x: float, y: float) -> None:
        """Show what is at a place of the plot."""
        raise NotImplementedError

    def redress(self) -> None:
        self.plot.dress()
        self.dress()
        self.readout.setPalette(QPalette(self.palette()))
        self.draw()

    def show_empty(self) -> bool:
        """Show words instead of the plot where there is no line, and return whether that is so."""
        none = self.lines is None or not self.lines.lines
        self.plot.setVisible(not none)
        self.empty.setVisible(none)
        if none:
            self.note.setText("")
        return none

    def sampled_lines(self) -> Iterator[tuple[Line, SlicePoints]]:
        """Yield the lines whose subject has samples near the cut that are drawn, with these samples."""
        for line in () if self.lines is None else self.lines.lines:
            points = self.lines.points.get(line.key) if self.lines is not None else None
            if points is not None and (line.kind == "target" or self._options.shown == "fit"):
                yield line, points

    def pen(self, alpha: float, style: Qt.PenStyle) -> QPen:
        """Return a pen of the theme's text, ``alpha`` of its strength."""
        pen = grey_pen(self.palette(), alpha)
        pen.setStyle(style)
        return pen

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self.plot is not None:
            self.redress()

    def _leave(self) -> None:
        self._cross.setVisible(False)
        self.readout.hide()
