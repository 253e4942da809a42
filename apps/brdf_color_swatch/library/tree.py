"""The library at the left: palettes, their groups within groups, and their tags. Swatches can be dropped on each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from brdf_qt.fields.form import described
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from PySide6.QtCore import QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QIcon,
    QMouseEvent,
    QPainter,
    QPalette,
    QPixmap,
)
from PySide6.QtWidgets import QAbstractItemView, QTreeWidget, QTreeWidgetItem, QWidget

from brdf_color_swatch.editing.transfer import can_take
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.library import Item
from brdf_suite.foreign_text import make_visible

_SCOPE = Qt.ItemDataRole.UserRole
_TAGS = Scope("", (), "\0tags")


@dataclass(frozen=True)
class _Line:
    """What a line of the tree shows: compared with what it showed before, so that little is made anew."""

    scope: Scope
    text: str
    tip: str
    colour: str
    sign: str
    read_only: bool = False
    children: tuple[_Line, ...] = ()


class LibraryTree(QTreeWidget):
    """Signals: ``scope_chosen(scope)``, ``renamed(scope, name)``, ``dropped(event, scope)``,
    ``group_dropped(group, scope, moves)``, ``menu_requested(scope, point)``.
    """

    scope_chosen = Signal(object)
    renamed = Signal(object, str)
    dropped = Signal(object, object)
    group_dropped = Signal(object, object, bool)
    menu_requested = Signal(object, QPoint)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        described(self, name="library", spoken=tr("Library: palettes, groups and tags"))
        self.setHeaderHidden(True)
        self.setFrameShape(QTreeWidget.Shape.NoFrame)
        self.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)
        self.setUniformRowHeights(True)
        self.setIconSize(QSize(16, 16))
        self.setAcceptDrops(True)
        self.setDragEnabled(True)
        self.setDropIndicatorShown(True)
        self.setDragDropMode(QAbstractItemView.DragDropMode.DragDrop)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.customContextMenuRequested.connect(self._ask_menu)
        self._lines: tuple[_Line, ...] = ()
        self._quiet = False
        self._chosen = Scope()
        self._drop_item: QTreeWidgetItem | None = None
        self.drop_action: Callable[[QDropEvent, Scope], Qt.DropAction] = lambda event, _scope: (
            event.proposedAction()
        )
        """What a drop of swatches on a palette, a group or a tag would do; set by what takes drops."""
        self.currentItemChanged.connect(lambda now, _before: self._choose(now))
        self.itemChanged.connect(self._edited)

    def show_items(self, items: tuple[Item, ...]) -> None:
        """Show the library; what was open in the tree stays so."""
        lines = tuple(_line_of(item) for item in items)
        if lines == self._lines:
            return
        opened = {self._scope(item) for item in self._all() if item.isExpanded()}
        known = {line.scope for line in self._lines}
        self._lines = lines
        self._quiet = True
        top = self.verticalScrollBar().value()
        self.clear()
        for line in lines:
            made = self._build_item(line)
            self.addTopLevelItem(made)
            if line.scope not in known or line.scope in opened:
                made.setExpanded(True)
        for item in self._all():
            inner_group = item.parent() is not None and self._scope(item).group
            if self._scope(item) in opened or (inner_group and not known):
                item.setExpanded(True)
        self._mark_chosen()
        self.verticalScrollBar().setValue(top)
        self._quiet = False

    def show_scope(self, scope: Scope) -> None:
        self._chosen = scope
        self._quiet = True
        self._mark_chosen()
        self._quiet = False

    def rename(self, scope: Scope) -> None:
        item = self.item_of(scope)
        if item is not None:
            self.setCurrentItem(item)
            self.editItem(item)

    def _build_item(self, line: _Line) -> QTreeWidgetItem:
        item = QTreeWidgetItem([make_visible(line.text)])
        item.setData(0, _SCOPE, line.scope)
        item.setToolTip(0, plain_tip(line.tip))
        item.setIcon(0, _dot(line.colour) if line.colour else icon(line.sign))
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsDropEnabled
        if line.scope.tag != _TAGS.tag and not line.read_only:
            flags |= Qt.ItemFlag.ItemIsEditable
        if line.scope.group:
            flags |= Qt.ItemFlag.ItemIsDragEnabled
        item.setFlags(flags)
        for child in line.children:
            item.addChild(self._build_item(child))
        return item

    def _all(self) -> list[QTreeWidgetItem]:
        found: list[QTreeWidgetItem] = []
        waiting = [self.topLevelItem(place) for place in range(self.topLevelItemCount())]
        while waiting:
            item = waiting.pop(0)
            if item is not None:
                found.append(item)
                waiting = [item.child(place) for place in range(item.childCount())] + waiting
        return found

    def _scope(self, item: QTreeWidgetItem) -> Scope:
        scope = item.data(0, _SCOPE)
        return scope if isinstance(scope, Scope) else Scope()

    def item_of(self, scope: Scope) -> QTreeWidgetItem | None:
        return next((item for item in self._all() if self._scope(item) == scope), None)

    def _mark_chosen(self) -> None:
        item = self.item_of(self._chosen) or self.item_of(Scope(self._chosen.palette))
        self.setCurrentItem(item)  # type: ignore[arg-type]  # Qt takes a null pointer for none

    def _choose(self, item: QTreeWidgetItem | None) -> None:
        if item is None or self._quiet:
            return
        scope = self._scope(item)
        if scope.tag != _TAGS.tag:
            self._chosen = scope
            self.scope_chosen.emit(scope)

    def _edited(self, item: QTreeWidgetItem, _column: int) -> None:
        if self._quiet:
            return
        scope, text = self._scope(item), item.text(0).strip()
        before = next((line.text for line in _flat(self._lines) if line.scope == scope), "")
        name = _name_of(scope, before)
        self._quiet = True
        item.setText(0, make_visible(before))
        self._quiet = False
        if text and text not in (before, name, make_visible(before), make_visible(name)):
            self.renamed.emit(scope, text)

    def _ask_menu(self, point: QPoint) -> None:
        item = self.itemAt(point)
        scope = self._scope(item) if item is not None else Scope()
        self.menu_requested.emit(scope, self.viewport().mapToGlobal(point))

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if event.source() is self or can_take(event.mimeData()):
            event.acceptProposedAction()

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        item = self.itemAt(event.position().toPoint())
        if item is not self._drop_item:
            self._drop_item = item
            self.viewport().update()
        if event.source() is self:
            event.acceptProposedAction()
        elif can_take(event.mimeData()):
            action = self.drop_action(event, self._scope(item) if item is not None else Scope())
            event.setDropAction(action)
            event.setAccepted(action is not Qt.DropAction.IgnoreAction)

    def dragLeaveEvent(self, _event: object) -> None:
        self._drop_item = None
        self.viewport().update()

    def dropEvent(self, event: QDropEvent) -> None:
        item = self.itemAt(event.position().toPoint())
        self._drop_item = None
        self.viewport().update()
        scope = self._scope(item) if item is not None else Scope()
        if event.source() is self:
            current = self.currentItem()
            moved = self._scope(current) if current is not None else Scope()
            # The tree itself moves nothing: the palette is changed, and then the tree shows it.
            event.setDropAction(Qt.DropAction.IgnoreAction)
            event.accept()
            if moved.group and scope.palette and not scope.tag:
                shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
                self.group_dropped.emit(moved, scope, shift)
            return
        self.dropped.emit(event, scope)

    def drawRow(self, painter: QPainter, options: object, index: object) -> None:
        super().drawRow(painter, options, index)  # type: ignore[arg-type]  # as Qt gives them
        if self._drop_item is not None and self.itemFromIndex(index) is self._drop_item:  # type: ignore[arg-type]
            box: QRect = options.rect  # type: ignore[attr-defined]  # a QStyleOptionViewItem
            painter.setPen(self.palette().color(QPalette.ColorRole.Highlight))
            painter.drawRect(box.adjusted(0, 0, -1, -1))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        item = self.itemAt(event.position().toPoint())
        # A click on the current scope shows all of it again, also after a search in another scope.
        if item is not None and event.button() is Qt.MouseButton.LeftButton:
            self._choose(item)


def _line_of(item: Item) -> _Line:
    scope = Scope(item.key)
    signs = {"closed": "file", "reading": "hourglass", "open": "palette", "wrong": "warning-octagon"}
    tip = str(item.path) if item.path is not None else tr("Not saved to a file")
    if item.read_only:
        tip = tr(
            "Comes with the suite: read-only. Save As or drag swatches to another palette to change them."
        )
    if item.state == "wrong":
        tip = item.problem
    elif item.state == "closed":
        tip = tr("{file}\nNot loaded; select it to load it.").format(file=tip)
    title = item.title[:200]
    if item.palette is None:
        return _Line(scope, title, tip, "", signs[item.state])
    palette = item.palette.store.value
    rows = item.palette.rows
    counts: Counter[tuple[str, ...]] = Counter()
    of, paths = rows.groups
    for path, number in zip(paths, np.bincount(of, minlength=len(paths)).tolist(), strict=True):
        for depth in range(1, len(path) + 1):
            counts[path[:depth]] += number
    # Each group under the group around it, in one pass over all of them.
    inside: dict[tuple[str, ...], list[tuple[str, ...]]] = {}
    known = {group.path: group for group in palette.groups}
    for path in known:
        inside.setdefault(path[:-1], []).append(path)

    def groups(around: tuple[str, ...]) -> tuple[_Line, ...]:
        return tuple(
            _Line(
                Scope(item.key, path),
                _with_count(path[-1] or tr("(no name)"), counts[path]),
                known[path].notes[:300],
                known[path].colour,
                "folder",
                item.read_only,
                groups(path),
            )
            for path in inside.get(around, ())
        )

    tags = rows.tag_counts
    children = groups(())
    if tags:
        names = [(tag, _with_count(tag, tags[tag])) for tag in sorted(tags, key=str.casefold)]
        locked = item.read_only
        under = tuple(_Line(Scope(item.key, (), tag), text, "", "", "tag", locked) for tag, text in names)
        scope_of_tags = Scope(item.key, (), _TAGS.tag)
        children = (*children, _Line(scope_of_tags, tr("Tags"), "", "", "tag", locked, under))
    mark = "" if item.is_clean else " •"
    tip = tip if item.is_clean else tr("{file}\nUnsaved changes.").format(file=tip)
    sign = "lock-simple" if item.read_only else "palette"
    colour = "" if item.read_only else palette.colour
    text = _with_count(title, len(palette)) + mark
    return _Line(scope, text, tip, colour, sign, item.read_only, children)


def _with_count(name: str, count: int) -> str:
    return f"{name}  {count}"


def _name_of(scope: Scope, text: str) -> str:
    if scope.tag:
        return scope.tag
    return scope.group[-1] if scope.group else text


def _flat(lines: tuple[_Line, ...]) -> list[_Line]:
    return [one for line in lines for one in (line, *_flat(line.children))]


def _dot(colour: str) -> QIcon:
    picture = QPixmap(16, 16)
    picture.fill(QColor(0, 0, 0, 0))
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setBrush(QColor(colour))
    painter.setPen(QColor(128, 128, 128))
    painter.drawEllipse(2, 2, 11, 11)
    painter.end()
    return QIcon(picture)
