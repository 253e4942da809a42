"""The swatches that a pane shows, as a table: a row each, the columns of the list. Grid and list share it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import Any

from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import (
    QAbstractTableModel,
    QMimeData,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)

from brdf_color_swatch.grid.layout import Part
from brdf_color_swatch.grid.rows import ANGLES_DEG, Rows
from brdf_suite.documents.palette import Entry
from brdf_suite.foreign_text import make_visible

ID_ROLE = Qt.ItemDataRole.UserRole + 1
_READINGS = tuple(f"{axis}_{angle:g}" for angle in ANGLES_DEG for axis in ("L", "a", "b"))
SORT_KEYS: tuple[str, ...] = ("name", "code", *_READINGS, "gloss", "flop", "tags", "date")
_TITLES = {
    "name": mark("Name"),
    "code": mark("Code"),
    "gloss": mark("Gloss 20° (GU)"),
    "flop": mark("Flop"),
    "tags": mark("Tags"),
    "date": mark("Date"),
}
_TIPS = {
    "name": mark("Name of the paint (rename: F2)"),
    "code": mark("Manufacturer's code or your own"),
    "gloss": mark("Gloss at 20° in gloss units (GU), coat and base together"),
    "flop": mark("Flop index 2.69 (L*15 − L*110)^1.11 / L*45^0.86; 0 for a solid colour"),
    "tags": mark("Search terms"),
    "date": mark("Date of the last change (year-month-day)"),
}
NAME, CODE = 0, 1
TAGS, DATE = SORT_KEYS.index("tags"), SORT_KEYS.index("date")
FLAGS = (
    Qt.ItemFlag.ItemIsSelectable
    | Qt.ItemFlag.ItemIsEnabled
    | Qt.ItemFlag.ItemIsDragEnabled
    | Qt.ItemFlag.ItemIsDropEnabled
)


@dataclass(frozen=True)
class VisibleRows:
    """What a pane shows: places in ``rows`` in their order, and the headings over them."""

    rows: Rows
    places: tuple[int, ...] = ()
    parts: tuple[Part, ...] = ()
    figure: dict[int, float] = field(default_factory=dict)
    """ΔE00 to what was asked for, by place in ``rows``; empty where nothing was."""


class SwatchModel(QAbstractTableModel):
    """Rows of :class:`VisibleRows`.

    Signals: ``renamed(id, column, text)`` when the user has edited a name or a code;
    ``sort_requested(key, descending)`` when a column header was clicked.
    """

    renamed = Signal(str, str, str)
    sort_requested = Signal(str, bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.shown = VisibleRows(Rows.empty())
        self._by_id: dict[str, int] | None = None
        self.mime_types: tuple[str, ...] = ()
        self.mime_of: Callable[[list[str]], QMimeData | None] | None = None
        self.read_only = False
        """Whether names and codes cannot be edited here."""

    def show(self, shown: VisibleRows) -> bool:
        """Show these rows; return whether each has the id that it had before."""
        self.beginResetModel()
        before, self.shown = self.shown, shown
        same = shown.rows.ids is before.rows.ids and shown.places == before.places
        if not same:
            self._by_id = None
        self.endResetModel()
        return same

    def id_at(self, row: int) -> str:
        return self.shown.rows.ids[self.shown.places[row]]

    def ids_at(self, rows: Sequence[int]) -> tuple[str, ...]:
        """Return the ids of rows, in their order."""
        ids, places = self.shown.rows.ids, self.shown.places
        return tuple(map(ids.__getitem__, map(places.__getitem__, rows)))

    def row_of(self, key: str) -> int | None:
        if self._by_id is None:
            ids = self.shown.rows.ids
            self._by_id = dict(zip(map(ids.__getitem__, self.shown.places), count(), strict=False))
        return self._by_id.get(key)

    def entry_at(self, row: int) -> Entry:
        return self.shown.rows.entries[self.shown.places[row]]

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008 - the signature is Qt's
        return 0 if parent.isValid() else len(self.shown.places)

    def columnCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008 - the signature is Qt's
        return 0 if parent.isValid() else len(SORT_KEYS)

    def flags(self, index: QModelIndex | QPersistentModelIndex) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.ItemIsDropEnabled
        editable = index.column() in (NAME, CODE) and not self.read_only
        return FLAGS | Qt.ItemFlag.ItemIsEditable if editable else FLAGS

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        if orientation is not Qt.Orientation.Horizontal:
            return section + 1 if role == Qt.ItemDataRole.DisplayRole else None
        key = SORT_KEYS[section]
        axis, _, angle = key.partition("_")
        if role == Qt.ItemDataRole.DisplayRole:
            return tr(_TITLES[key]) if key in _TITLES else f"{axis}* {angle}°"
        if role == Qt.ItemDataRole.ToolTipRole:
            tip = tr("CIE {axis}* (D65, 10°) at the aspecular angle {angle}°").format(axis=axis, angle=angle)
            return plain_tip(tr(_TIPS[key]) if key in _TIPS else tip)
        return None

    def data(self, index: QModelIndex | QPersistentModelIndex, role: int = 0) -> Any:
        if not index.isValid() or index.row() >= len(self.shown.places):
            return None
        place = self.shown.places[index.row()]
        rows, key = self.shown.rows, SORT_KEYS[index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return make_visible(rows.text(place, key))
        if role == Qt.ItemDataRole.EditRole:
            return rows.text(place, key)
        if role == Qt.ItemDataRole.TextAlignmentRole and key not in ("name", "code", "tags", "date"):
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.ToolTipRole:
            return plain_tip(rows.describe(place, self.shown.figure.get(place)))
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return rows.describe_aloud(place)
        if role == ID_ROLE:
            return rows.ids[place]
        return None

    def setData(
        self, index: QModelIndex | QPersistentModelIndex, value: Any, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        key = SORT_KEYS[index.column()]
        text = str(value).strip()
        if role != Qt.ItemDataRole.EditRole or text == self.data(index, role):
            return False
        self.renamed.emit(self.id_at(index.row()), key, text)
        return True

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        if column >= 0:
            self.sort_requested.emit(SORT_KEYS[column], order is Qt.SortOrder.DescendingOrder)

    def supportedDragActions(self) -> Qt.DropAction:
        return Qt.DropAction.MoveAction | Qt.DropAction.CopyAction

    def supportedDropActions(self) -> Qt.DropAction:
        return Qt.DropAction.MoveAction | Qt.DropAction.CopyAction

    def mimeTypes(self) -> list[str]:
        return list(self.mime_types)

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData | None:  # type: ignore[override]  # Qt takes None for no data
        rows = sorted({index.row() for index in indexes})
        return self.mime_of([self.id_at(row) for row in rows]) if self.mime_of is not None else None
