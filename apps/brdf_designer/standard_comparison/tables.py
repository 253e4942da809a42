"""The tables of the Standard section: as high as their rows, never scrolled inside the inspector."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.marks import Mark, verdict_mark
from brdf_qt.fields.number import parse_number
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from brdf_designer.standard_comparison.settings import PARTS, ToleranceSettings
from brdf_designer.standard_comparison.state import LIMIT_NAMES, ResultRow
from brdf_suite.foreign_text import make_visible

_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_MARK = Qt.ItemDataRole.UserRole
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class WholeTable(QTableWidget):
    """A table that shows all of its rows; texts are set without making an item anew."""

    def __init__(self, name: str, headings: Sequence[str], parent: QWidget | None = None) -> None:
        super().__init__(0, len(headings), parent)
        self.setAccessibleName(name)
        self.setHorizontalHeaderLabels(list(headings))
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 8)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setMinimumSectionSize(24)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setHighlightSections(False)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setTabKeyNavigation(False)
        self.setWordWrap(False)

    def set_row_count(self, count: int) -> None:
        """Have ``count`` rows, all with items, and the height for them."""
        if count == self.rowCount():
            return
        old = self.rowCount()
        self.setRowCount(count)
        for row in range(old, count):
            for column in range(self.columnCount()):
                item = QTableWidgetItem()
                item.setTextAlignment(_LEFT if column == 0 else _RIGHT)
                self.setItem(row, column, item)
        self.setFixedHeight(self.sizeHint().height())

    def set_text(
        self,
        row: int,
        column: int,
        text: str,
        *,
        bold: bool = False,
        tip: str = "",
        mark: Mark | None = None,
    ) -> None:
        """Show a text, with a mark before it where one is given; nothing where it is shown already."""
        item = self.item(row, column)
        if item is None:
            return
        text = make_visible(text)
        if item.text() != text:
            item.setText(text)
        if item.data(_MARK) != (mark and mark.name):
            item.setData(_MARK, mark and mark.name)
            item.setIcon(QIcon() if mark is None else mark.icon)
        if item.font().bold() != bold:
            font = item.font()
            font.setBold(bold)
            item.setFont(font)
        if item.toolTip() != tip:
            item.setToolTip(plain_tip(tip))

    def sizeHint(self) -> QSize:
        rows = sum(self.rowHeight(row) for row in range(self.rowCount()))
        frame = 2 * self.frameWidth()
        return QSize(240, self.horizontalHeader().sizeHint().height() + rows + frame)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, self.sizeHint().height())


class ResultTable(WholeTable):
    """Per angle the difference, its parts, and the verdict."""

    def __init__(self) -> None:
        headings = (tr("Angle"), "ΔE", "ΔL*", "ΔC*", "ΔH*", tr("Verdict"))
        super().__init__(tr("Differences from the standard per angle"), headings)
        header = self.horizontalHeader()
        header.setSectionResizeMode(5, QHeaderView.ResizeMode.ResizeToContents)

    def show_rows(self, title: str, rows: Sequence[ResultRow]) -> None:
        """Show the rows; ``title`` is the formula's."""
        heading = self.horizontalHeaderItem(1)
        if heading is not None:
            heading.setToolTip(plain_tip(title))
        self.set_row_count(len(rows))
        for number, row in enumerate(rows):
            sign = verdict_mark(row.passes)
            for column, text in enumerate(row.cells):
                self.set_text(
                    number,
                    column,
                    text,
                    bold=column in row.bold,
                    tip=row.tip,
                    mark=sign if column == 5 else None,
                )


class ToleranceTable(WholeTable):
    """Limits per angle, typed into the cells; an empty one does not judge.

    ``limit_edited(angle, part, value)``: angle in degrees or ``None`` for all, value ``None`` where it was cleared.
    ``refused(text)``: what was typed is no number.
    """

    limit_edited = Signal(object, str, object)
    refused = Signal(str)

    def __init__(self) -> None:
        super().__init__(tr("Tolerances per angle"), (tr("Angle"), *(LIMIT_NAMES[part] for part in PARTS)))
        triggers = QAbstractItemView.EditTrigger
        self.setEditTriggers(triggers.DoubleClicked | triggers.AnyKeyPressed | triggers.SelectedClicked)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self._angles: list[float | None] = []
        self._shown: ToleranceSettings | None = None
        self.itemChanged.connect(self._on_changed)

    def show_settings(self, angles: Sequence[float], chosen: ToleranceSettings) -> None:
        """Show the limits everywhere and at ``angles``."""
        self._angles, self._shown = [None, *angles], chosen
        tip = tr("Largest {part} that passes; empty: not evaluated")
        with QSignalBlocker(self):
            self.set_row_count(len(self._angles))
            for row, angle in enumerate(self._angles):
                self.set_text(row, 0, tr("all angles") if angle is None else f"{angle:g}°")
                heading = self.item(row, 0)
                if heading is not None:
                    heading.setFlags(Qt.ItemFlag.ItemIsEnabled)
                limits = chosen.limits(angle)
                for column, part in enumerate(PARTS, 1):
                    value = getattr(limits, part)
                    text = "" if value is None else decimal(f"{value:g}")
                    self.set_text(row, column, text, tip=tip.format(part=LIMIT_NAMES[part]))

    def _on_changed(self, item: QTableWidgetItem) -> None:
        if item.column() == 0 or self._shown is None:
            return
        angle, part, text = self._angles[item.row()], PARTS[item.column() - 1], item.text().strip()
        value = parse_number(text) if text else None
        if text and (value is None or value < 0.0):
            self.refused.emit(
                tr("“{text}” is not a tolerance. Enter a number of 0 or more, or leave it empty.").format(
                    text=text[:40]
                )
            )
            self.show_settings([one for one in self._angles if one is not None], self._shown)
            return
        self.limit_edited.emit(angle, part, value)


class BatchTable(WholeTable):
    """Several batches against the one standard; ``opened(index)`` for a double click or Return."""

    opened = Signal(int)

    def __init__(self) -> None:
        super().__init__(
            tr("Batches compared with the standard"), (tr("Batch"), tr("ΔE max"), tr("mean"), tr("Verdict"))
        )
        header = self.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column in (1, 2, 3):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        self.itemActivated.connect(lambda item: self.opened.emit(item.row()))

    def show_batches(self, rows: Sequence[tuple[tuple[str, str, str, str], bool | None, str]]) -> None:
        """Show (texts, whether it passes, the difference in words) of each batch."""
        self.set_row_count(len(rows))
        for number, (cells, passes, tip) in enumerate(rows):
            for column, text in enumerate(cells):
                last = column == 3
                sign = verdict_mark(passes) if last else None
                self.set_text(number, column, text, bold=last and passes is False, tip=tip, mark=sign)
