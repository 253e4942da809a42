"""What can be chosen, as a model that lists, grids and strips share: shipped things, files, entries of a palette."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Literal

from PySide6.QtCore import (
    QAbstractListModel,
    QMimeData,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
    Signal,
)

from brdf_qt.choosing.drag import MIME, carry_paint
from brdf_qt.choosing.thumbnails import Thumbnails
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.settings import settings
from brdf_suite.foreign_text import make_visible
from brdf_suite.palettes.swatches.look import Content

Index = QModelIndex | QPersistentModelIndex
Group = Literal["shipped", "recent", "palette"]
KEY_ROLE = Qt.ItemDataRole.UserRole
MOST_TAKEN = 20
"""So many keys of what was taken last are remembered."""


@dataclass(frozen=True)
class Source:
    """One entry: ``key`` is what is loaded (a shipped name or a path), ``title`` what is shown.

    ``content`` is the paint itself where it is in memory already; otherwise its picture is made from ``key``.
    """

    key: str
    title: str
    group: Group = "shipped"
    content: Content | None = None


class SourceModel(QAbstractListModel):
    """The entries in their order. Without ``thumbnails`` they have no pictures.

    Signals: ``present_changed(key)``, another entry is the one in use.
    """

    present_changed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._sources: list[Source] = []
        self._taken: list[str] = []
        self._kind = ""
        self.thumbnails: Thumbnails | None = None
        self.present = ""
        """The key of the entry that the program uses now."""

    def set_thumbnails(self, thumbnails: Thumbnails) -> None:
        """Show pictures from here, and remember what is taken under their kind."""
        self.thumbnails, self._kind = thumbnails, thumbnails.kind
        stored = settings().value(f"recent/taken_{self._kind}", [])
        # One that is alone comes back as itself.
        self._taken = [str(key) for key in (stored if isinstance(stored, list) else [stored])]
        thumbnails.arrived.connect(self._redraw)
        self._redraw()

    def set_sources(self, sources: Iterable[Source]) -> None:
        """List these, and no others."""
        self.beginResetModel()
        self._sources = list(sources)
        self.endResetModel()

    def add(self, source: Source) -> int:
        """Put an entry last, and return its row."""
        row = len(self._sources)
        self.beginInsertRows(QModelIndex(), row, row)
        self._sources.append(source)
        self.endInsertRows()
        return row

    def rename(self, key: str, title: str) -> None:
        """Give an entry another title; nothing where there is none."""
        row = self.row_of(key)
        if row >= 0 and self._sources[row].title != title:
            self._sources[row] = replace(self._sources[row], title=title)
            self.dataChanged.emit(self.index(row), self.index(row))

    def set_present(self, key: str) -> None:
        """Mark the entry that is in use."""
        if key != self.present:
            self.present = key
            self._redraw()
            self.present_changed.emit(key)

    def note_taken(self, key: str) -> None:
        """Remember that the user took an entry; those of a palette are known for as long as it is open only."""
        row = self.row_of(key)
        if self._kind and row >= 0 and self._sources[row].group != "palette":
            self._taken = [key, *(one for one in self._taken if one != key)][:MOST_TAKEN]
            settings().setValue(f"recent/taken_{self._kind}", self._taken)
            self._redraw()

    def rank(self, row: int) -> int:
        """Return how long ago an entry was taken, 0 for the last; larger than any for one that never was."""
        key = self._sources[row].key
        return self._taken.index(key) if key in self._taken else MOST_TAKEN

    def source_at(self, row: int) -> Source:
        return self._sources[row]

    def row_of(self, key: str) -> int:
        """Return the row of a key; -1 where there is none."""
        return next((row for row, source in enumerate(self._sources) if source.key == key), -1)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - the signature is Qt's
        return 0 if parent.isValid() else len(self._sources)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid() or index.row() >= len(self._sources):
            return None
        source = self._sources[index.row()]
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return make_visible(source.title)
        if role == KEY_ROLE:
            return source.key
        if role == Qt.ItemDataRole.ToolTipRole:
            is_file = source.group != "shipped" and source.content is None
            return plain_tip(f"{source.title}\n{source.key}" if is_file else source.title)
        if role == Qt.ItemDataRole.DecorationRole and self.thumbnails is not None:
            return self.thumbnails.picture(source.key, source.content)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        return flags | Qt.ItemFlag.ItemIsDragEnabled if index.isValid() else flags

    def mimeTypes(self) -> list[str]:
        return [MIME]

    def mimeData(self, indexes: Iterable[QModelIndex]) -> QMimeData | None:  # type: ignore[override]  # Qt takes None for no data
        for index in indexes:
            source = self._sources[index.row()]
            content = None if self.thumbnails is None else self.thumbnails.content(source.key, source.content)
            if content is not None:
                return carry_paint(content, source.key)
        return None

    def supportedDragActions(self) -> Qt.DropAction:
        return Qt.DropAction.CopyAction

    def _redraw(self) -> None:
        if self._sources:
            self.dataChanged.emit(self.index(0), self.index(len(self._sources) - 1))


class FilteredSources(QSortFilterProxyModel):
    """The entries of a model whose titles hold every word of a text, of one group or of all."""

    def __init__(self, model: SourceModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.model = model
        self._words: list[str] = []
        self._group = ""
        self.setSourceModel(model)

    def set_text(self, text: str) -> None:
        self._words = text.casefold().split()
        self.invalidate()

    def set_group(self, group: str) -> None:
        """Keep one group; an empty one keeps all. Of ``recent`` is also what was taken lately, the last first."""
        self._group = group
        self.sort(0 if group == "recent" else -1)
        self.invalidate()

    def key_at(self, row: int) -> str:
        return str(self.index(row, 0).data(KEY_ROLE))

    def row_of(self, key: str) -> int:
        """Return the row of a key; -1 where it is not among those that are kept."""
        row = self.model.row_of(key)
        return self.mapFromSource(self.model.index(row)).row() if row >= 0 else -1

    def sources(self, rows: Iterable[int]) -> list[Source]:
        """Return the entries of ``rows``, those that there are."""
        kept = (row for row in rows if 0 <= row < self.rowCount())
        return [self.model.source_at(self.mapToSource(self.index(row, 0)).row()) for row in kept]

    def filterAcceptsRow(self, row: int, _parent: Index, /) -> bool:
        source = self.model.source_at(row)
        taken = self._group == "recent" and self.model.rank(row) < MOST_TAKEN
        title = source.title.casefold()
        return (not self._group or source.group == self._group or taken) and all(
            word in title for word in self._words
        )

    def lessThan(self, left: Index, right: Index) -> bool:
        ranks = self.model.rank(left.row()), self.model.rank(right.row())
        return ranks < ranks[::-1] if ranks[0] != ranks[1] else left.row() < right.row()
