"""A view of slice images: the grid, what is under the mouse, and words where there is nothing to draw."""

from __future__ import annotations

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QVBoxLayout, QWidget

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
        self.setObjectName(name)
        self.setMinimumSize(220, 140)
        self.images = ImageGrid()
        self.images.setAccessibleName(title)
        self.setAccessibleName(title)
        self.readout = Readout(self.images)
        self.working = PlainLabel(tr("updating…"), self.images)
        self.working.setObjectName("working")
        self.working.setAutoFillBackground(True)
        self.working.setMargin(2)
        self.working.hide()
        self._late = make_timer(self, self._show_late, _LATE_MS)
        self.empty = PlainLabel(tr("No reflectance shown. Add one."))
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.empty.setWordWrap(True)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(self.empty, 1)
        box.addWidget(self.images, 1)
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
        value = self.grid.pictures[row, column].value
        rows, columns = value.shape
        return float(value[min(int(y * rows), rows - 1), min(int(x * columns), columns - 1)])

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.readout.setPalette(QPalette(self.palette()))

    def _read(self, _row: int, column: int, x: float, y: float) -> None:
        rows = []
        for number, title in enumerate(self.grid.rows):
            at = (number, column)
            if at not in self.grid.pictures:
                continue
            picture = self.grid.pictures[at]
            value = self.value_at(*at, x, y)
            holes = picture.holes
            filled = False
            if holes is not None:
                size_y, size_x = holes.shape
                filled = bool(holes[min(int(y * size_y), size_y - 1), min(int(x * size_x), size_x - 1)])
            rows.append(Row(title, self._colour, "target", value, filled and value == value))
        bar = self.grid.bar
        unit = UNIT if bar is None else bar.title
        self.readout.show_rows(self.head_at(column, x, y), rows, unit, at_right=self._at_left(column, x))

    def _at_left(self, column: int, x: float) -> bool:
        place = self.images.place_of(0, column)
        return place.left() + x * place.width() < self.images.width() / 2.0
