"""The figures as a table for the eye: a row per figure, a column per reflectance with its line in the header."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import tr
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QGuiApplication, QIcon, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

if TYPE_CHECKING:
    # What measures is much to import, and the panel is not seen at a first start.
    from brdf_suite.inspection.figures.text import FigureRow

_NOTHING = 1e-9
_Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True, eq=False)
class Column:
    """A reflectance: its title, its line, and whether its figures are of what it was before."""

    title: str
    line: QIcon
    stale: bool


class FiguresModel(QAbstractTableModel):
    """Rows and columns as they were given last."""

    def __init__(self) -> None:
        super().__init__()
        self._rows: Sequence[FigureRow] = ()
        self._columns: Sequence[Column] = ()

    def show(self, columns: Sequence[Column], rows: Sequence[FigureRow]) -> None:
        """Show these figures."""
        same = len(rows) == len(self._rows) and len(columns) == len(self._columns)
        if same:
            # The place that is scrolled to and the selection stay while a paint is dragged.
            self._rows, self._columns = rows, columns
            if not rows:
                return
            self.dataChanged.emit(self.index(0, 0), self.index(self.rowCount() - 1, self.columnCount() - 1))
            self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, self.columnCount() - 1)
        else:
            self.beginResetModel()
            self._rows, self._columns = rows, columns
            self.endResetModel()

    def rowCount(self, _parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's own signature
        return len(self._rows)

    def columnCount(self, _parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's own signature
        return 1 + len(self._columns)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row = self._rows[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return self.text(index.row(), index.column())
        if role == Qt.ItemDataRole.TextAlignmentRole and index.column() > 0:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.AccessibleTextRole and index.column() > 0:
            title = self._columns[index.column() - 1].title
            return f"{title}, {_named(row)}: {self.text(index.row(), index.column())}"
        return None

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if section == 0:
            return tr("Figure") if role == Qt.ItemDataRole.DisplayRole else None
        column = self._columns[section - 1]
        if role == Qt.ItemDataRole.DisplayRole:
            return f"({column.title})" if column.stale else column.title
        if role == Qt.ItemDataRole.DecorationRole:
            return column.line
        if role == Qt.ItemDataRole.ToolTipRole:
            stale = tr("{title}: outdated, being recomputed").format(title=column.title)
            return plain_tip(stale if column.stale else column.title)
        return None

    def text(self, row: int, column: int) -> str:
        """Return what a cell shows."""
        shown = self._rows[row]
        if column == 0:
            return _named(shown)
        value = shown.values[column - 1]
        if value is None:
            return "–"
        # What rounding leaves of a difference of equals is none.
        return "0" if abs(value) < _NOTHING else f"{value:.4g}".replace("-", "−")


class FiguresTable(QTableView):
    """The table; Ctrl+C copies the selected cells, with tabs between them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.figures = FiguresModel()
        self.setModel(self.figures)
        self.setAccessibleName(tr("Figures of the reflectances"))
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 6)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy_selected()
        else:
            super().keyPressEvent(event)

    def copy_selected(self) -> None:
        """Copy the selected cells; nothing where none is."""
        chosen = sorted({(index.row(), index.column()) for index in self.selectedIndexes()})
        if not chosen:
            return
        lines: dict[int, list[str]] = {}
        for row, column in chosen:
            lines.setdefault(row, []).append(self.figures.text(row, column))
        QGuiApplication.clipboard().setText("\n".join("\t".join(line) for line in lines.values()))


def _named(row: FigureRow) -> str:
    return f"{row.name}, {row.unit}" if row.unit else row.name
