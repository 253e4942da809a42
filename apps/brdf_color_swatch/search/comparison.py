"""Two selected paints side by side: their colours touching at each angle, and what they differ by."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.rows import ANGLES_DEG, codes_of
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.palette import Entry
from brdf_suite.palettes.columns import Columns

_HEADS = (mark("Angle"), mark("ΔE00"), mark("ΔL*"), mark("Δa*"), mark("Δb*"), mark("ΔC*"), mark("Δh"))
_TIPS = (
    mark("Aspecular angle"),
    mark("Colour difference CIEDE2000"),
    mark("Lightness difference, second minus first"),
    mark("Red–green difference, second minus first"),
    mark("Yellow–blue difference, second minus first"),
    mark("Chroma difference, second minus first"),
    mark("Hue angle difference in degrees, second minus first"),
)


class _Pair(QWidget):
    """The first colour over the second at each angle, edge to edge: so is a difference seen best."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._codes = np.zeros((2, 0, 3), np.uint8)
        self.setMinimumHeight(96)

    def show_codes(self, codes: np.ndarray, description: str) -> None:
        self._codes = codes
        described(self, spoken=tr("Both paints at each angle"), tip=description)
        self.setAccessibleDescription(description)
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(240, 112)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        count = self._codes.shape[1]
        for line in range(2 if count else 0):
            for number in range(count):
                left, right = self.width() * number // count, self.width() * (number + 1) // count
                top = self.height() * line // 2
                colour = QColor(*(int(part) for part in self._codes[line, number]))
                painter.fillRect(
                    QRect(left, top, right - left, self.height() * (line + 1) // 2 - top), colour
                )


class ComparePanel(QWidget):
    """Shows two entries; the first one is the standard."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.names, self.figures = PlainLabel(wordWrap=True), PlainLabel(wordWrap=True)
        self.pair = _Pair()
        self.table = QTableWidget(0, len(_HEADS))
        for column, (title, tip) in enumerate(zip(_HEADS, _TIPS, strict=True)):
            head = QTableWidgetItem(tr(title))
            head.setToolTip(tr(tip))
            self.table.setHorizontalHeaderItem(column, head)
        self.table.verticalHeader().hide()
        self.table.setShowGrid(False)
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.setSelectionMode(QTableWidget.SelectionMode.NoSelection)
        self.table.setAccessibleName(tr("Differences at each angle"))
        self.table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.table.horizontalHeader().setMinimumSectionSize(28)
        fill_column(self, self.names, self.pair, self.table, self.figures)
        self.show_entries([])

    def show_entries(self, entries: Sequence[Entry]) -> None:
        """Show two entries; with any other number, what to do."""
        two = len(entries) == 2
        for widget in (self.pair, self.table, self.figures):
            widget.setVisible(two)
        if not two:
            self.names.setText(tr("Select two swatches to compare, or one in each of two panes."))
            return
        columns = Columns.of(entries)
        lab = columns.main
        first, second = (entry.name or entry.code or tr("(no name)") for entry in entries)
        self.names.setText(tr("Above: {first}\nBelow: {second}").format(first=first[:80], second=second[:80]))
        differences = delta_e_2000(lab[0], lab[1])
        lch = lab_to_lch(lab)
        self.table.setRowCount(len(ANGLES_DEG))
        lines = []
        for row, angle in enumerate(ANGLES_DEG):
            turn = (lch[1, row, 2] - lch[0, row, 2] + 180.0) % 360.0 - 180.0
            values = [
                f"{angle:g}°",
                decimal(f"{differences[row]:.2f}"),
                *(decimal(f"{value:+.1f}") for value in lab[1, row] - lab[0, row]),
                decimal(f"{lch[1, row, 1] - lch[0, row, 1]:+.1f}"),
                f"{turn:+.0f}°" if min(lch[:, row, 1]) >= 1.0 else "–",
            ]
            lines.append(f"{values[0]} ΔE00 {values[1]}")
            for column, value in enumerate(values):
                item = QTableWidgetItem(value.replace("-", "−").replace("nan", "–").replace("+–", "–"))
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.table.setItem(row, column, item)
        self.pair.show_codes(codes_of(lab), "; ".join(lines))
        height = self.table.horizontalHeader().sizeHint().height() + 2
        self.table.setFixedHeight(height + sum(self.table.rowHeight(row) for row in range(len(ANGLES_DEG))))
        figures = []
        if np.isfinite(differences).any():
            mean, worst = decimal(f"{np.nanmean(differences):.2f}"), decimal(f"{np.nanmax(differences):.2f}")
            figures.append(tr("Mean ΔE00 {mean}, worst {worst}").format(mean=mean, worst=worst))
        flops = [_format_figure(flop) for flop in columns.flop]
        figures.append(tr("Flop {first} and {second}").format(first=flops[0], second=flops[1]))
        if np.isfinite(columns.gloss).any():
            first, second = (_format_figure(gloss) for gloss in columns.gloss)
            figures.append(tr("Gloss 20°: {first} and {second} GU").format(first=first, second=second))
        self.figures.setText("\n".join(figures))


class PaintComparison(SwatchFeature):
    """Keeps the panel in step with what is selected: two in one pane, or one in each."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self.panel = ComparePanel()
        self.section = window.add_section("compare", tr("Compare"), self.panel, after="swatch", is_open=False)
        self._command = window.add_command(
            "paint", mark("&Compare the Two Selected"), "compare", self.compare, "compare", icon="scales"
        )
        session.selection_changed.connect(lambda _pane: self._show())
        session.shown_changed.connect(lambda _pane: self._show())
        session.front_changed.connect(self._show)
        self.section.toggled.connect(lambda _open: self._show())
        self._show()

    def pair(self) -> tuple[Entry, ...]:
        """Return the two entries that are compared; fewer where there are not two."""
        chosen = self._session.selected_entries
        if len(chosen) == 2 or not self._window.has_two_panes:
            return chosen if len(chosen) == 2 else ()
        left, right = self._session.selected_in(0), self._session.selected_in(1)
        if len(left) == len(right) == 1:
            return (left[0], right[0])
        other = (right, left)[self._session.front]
        return other if len(other) == 2 and not chosen else ()

    def compare(self) -> None:
        self._window.inspector_dock.show()
        self.section.set_open(True)
        self._show()
        self._window.inspector.ensureWidgetVisible(self.section)

    def _show(self) -> None:
        pair = self.pair()
        self._command.setEnabled(len(pair) == 2)
        if self.section.is_open:
            self.panel.show_entries(pair)


def _format_figure(value: float) -> str:
    return decimal(f"{value:.1f}") if np.isfinite(value) else "–"
