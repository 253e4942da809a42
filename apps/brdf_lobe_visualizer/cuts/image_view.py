"""A view of slice images: the grid, what is under the mouse, and words where there is nothing to draw."""

from __future__ import annotations

from typing import Any

import numpy as np
from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.crosshair import Readout, Row
from brdf_lobe_visualizer.cuts.images import Grid, ImageGrid
from brdf_lobe_visualizer.subjects.subjects import Srgb
from brdf_lobe_visualizer.words import UNIT

_LATE_MS = 200
"""Pictures that are there sooner are not announced."""


class SliceImageView(QWidget):
    """What the unrolled hemisphere and the half-angle slice share; each gives the angles by :meth:`head_at`."""

    def __init__(self, name: str, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        described(self, name=name, spoken=title)
        self.setMinimumSize(220, 140)
        self.images = described(ImageGrid(), spoken=title)
        self.readout = Readout(self.images)
        self.working = described(PlainLabel(tr("updating…"), self.images, margin=2), name="working")
        self.working.setAutoFillBackground(True)
        self.working.hide()
        self._late = make_timer(self, self._show_late, _LATE_MS)
        text = tr("No reflectance shown. Add one.")
        self.empty = PlainLabel(text, wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        fill_column(self, self.empty, self.images, grows=self.images).setStretch(0, 1)
        self.images.hide()
        self.images.hovered.connect(self._read)
        self.images.left.connect(self.readout.hide)
        self._colour: Srgb = (0.5, 0.5, 0.5)

    def set_stale(self, stale: bool) -> None:
        """Set whether newer pictures are being made; shown once it takes longer than a moment."""
        if stale:
            if not self._late.isActive() and not self.working.isVisible():
                self._late.start()
        else:
            self._late.stop()
            self.working.hide()

    def _show_late(self) -> None:
        self.working.adjustSize()
        self.working.move(4, 4)
        self.working.show()
        self.working.raise_()

    def show_grid(self, grid: Grid | None, colour: Srgb = (0.5, 0.5, 0.5)) -> None:
        """Show pictures of a subject with a line of this colour; None: there is none."""
        self._colour = colour
        self.empty.setVisible(grid is None)
        self.images.setVisible(grid is not None)
        self.readout.hide()
        self.images.show_grid(grid or Grid())

    @property
    def grid(self) -> Grid:
        return self.images.grid

    def head_at(self, column: int, x: float, y: float) -> str:
        """Return the angles at shares of width and height of a column's pictures."""
        raise NotImplementedError

    def value_at(self, row: int, column: int, x: float, y: float) -> float:
        """Return the value at a place of a picture; NaN where there is none."""
        return float(_at(self.grid.pictures[row, column].value, x, y))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.readout.setPalette(QPalette(self.palette()))

    def _read(self, _row: int, column: int, x: float, y: float) -> None:
        rows = []
        for number, title in enumerate(self.grid.rows):
            if (number, column) in self.grid.pictures:
                holes = self.grid.pictures[number, column].holes
                value = self.value_at(number, column, x, y)
                filled = holes is not None and bool(_at(holes, x, y)) and value == value
                rows.append(Row(title, self._colour, "target", value, filled))
        bar = self.grid.bar
        place = self.images.place_of(0, column)
        at_left = place.left() + x * place.width() < self.images.width() / 2.0
        unit = UNIT if bar is None else bar.title
        self.readout.show_rows(self.head_at(column, x, y), rows, unit, at_right=at_left)


def _at(values: np.ndarray, x: float, y: float) -> Any:
    """Return what of ``values`` (rows, columns) is at shares of width and height."""
    rows, columns = values.shape
    return values[min(int(y * rows), rows - 1), min(int(x * columns), columns - 1)]
