"""The grid of swatches: only what is seen is painted, whatever the palette's size.

A view of Qt's own kind, so that selection, keys, editing in place, drag and drop and screen readers are those of every
list; only where a swatch lies and how it looks is said here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from PySide6.QtCore import (
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QItemSelectionRange,
    QModelIndex,
    QPersistentModelIndex,
    QPoint,
    QRect,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QDrag,
    QDragLeaveEvent,
    QDragMoveEvent,
    QDropEvent,
    QFont,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QRegion,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractItemDelegate, QAbstractItemView, QWidget

from brdf_color_swatch.grid.layout import GAP, GridLayout
from brdf_color_swatch.grid.model import SwatchModel
from brdf_color_swatch.grid.tile import Look, Tile, TilePainter
from brdf_color_swatch.grid.view_state import SIZES
from brdf_suite.foreign_text import make_visible

DEFAULT_SIZE = 96


class SwatchGrid(QAbstractItemView):
    """Swatches as tiles under headings, which can be selected, opened, dragged and dropped.

    A click selects, Ctrl more, Shift as they follow; a drag over the empty room draws a band.
    ``tile_of(row)`` returns the content of a tile; it is called for visible tiles only. Signals:
    ``size_requested(size)`` on Ctrl+wheel; ``seen_changed()`` when other swatches become visible;
    ``dropped(event, row)`` with the row before which the drop fell.
    """

    size_requested = Signal(int)
    seen_changed = Signal()
    dropped = Signal(object, int)

    def __init__(
        self, model: SwatchModel, tile_of: Callable[[int], Tile], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._swatches, self._tile_of = model, tile_of
        self.form = "sphere"
        self._hovered = -1
        self._drop_row = -1
        self._range_start = -1
        self._ranging = False
        self._anchor: QPoint | None = None
        self._band: QRect | None = None
        self._band_base = QItemSelection()
        self.lines = 1
        """Lines of text under a picture: the name, and where something has one a code or a figure."""
        self.tiles = TilePainter(DEFAULT_SIZE, self.font(), self.palette())
        self.layout_ = GridLayout((), self.tiles.tile, 400)
        self.drop_action: Callable[[QDropEvent], Qt.DropAction] = lambda event: event.proposedAction()
        """What a drop would do; set by what takes drops."""
        self.stale: Callable[[int], bool] = lambda _row: False
        self.setObjectName("grid")
        self.setFrameShape(QAbstractItemView.Shape.NoFrame)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)
        self.setDragDropMode(QAbstractItemView.DragDropMode.DragDrop)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setAutoScroll(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        # Always there: a bar that comes and goes would move every tile.
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self.setMouseTracking(True)
        # The surround itself, and not the lighter ground of lists: in the booth theme it is the grey to judge by.
        self.viewport().setBackgroundRole(QPalette.ColorRole.Window)
        self.setModel(model)
        self.verticalScrollBar().valueChanged.connect(lambda _value: self.seen_changed.emit())

    def set_size(self, size: int) -> None:
        """Show pictures of ``size`` pixels; what was at the top stays there."""
        size = min(SIZES[1], max(SIZES[0], size))
        if size != self.tiles.size:
            top = self.layout_.near(GAP + 1, self.verticalScrollBar().value())
            self._renew(size)
            if top is not None:
                self.verticalScrollBar().setValue(self.layout_.box(min(top, self.layout_.count - 1))[1] - GAP)

    def _renew(self, size: int) -> None:
        self.tiles = TilePainter(size, self.font(), self.palette(), self.lines)
        self._lay_out()

    def _lay_out(self) -> None:
        self.layout_ = GridLayout(self._swatches.shown.parts, self.tiles.tile, self.viewport().width())
        self.updateGeometries()
        self.viewport().update()
        self.seen_changed.emit()

    def updateGeometries(self) -> None:
        super().updateGeometries()
        bar = self.verticalScrollBar()
        height = self.viewport().height()
        bar.setRange(0, max(0, self.layout_.height - height))
        bar.setPageStep(max(1, height - self.tiles.tile[1] // 2))
        bar.setSingleStep(max(16, (self.tiles.tile[1] + GAP) // 3))

    def seen(self, margin: int = 0) -> list[int]:
        """Return the rows that are seen now, and those within ``margin`` pixels of it."""
        top = self.verticalScrollBar().value()
        found: list[int] = []
        for _part, places in self.layout_.between(top - margin, top + self.viewport().height() + margin):
            found.extend(places)
        return found

    def refresh_rows(self, rows: list[int]) -> None:
        """Paint some rows anew, where they are seen: a picture has come."""
        top, height = self.verticalScrollBar().value(), self.viewport().height()
        for row in rows:
            if row < self.layout_.count:
                left, y, w, h = self.layout_.box(row)
                if y + h > top and y < top + height:
                    self.viewport().update(left, y - top, w, h)

    def reset(self) -> None:
        super().reset()
        self._hovered = self._drop_row = self._range_start = -1
        self._band = None
        shown = self._swatches.shown
        self.lines = 2 if shown.figure or shown.rows.has_codes else 1
        if self.lines != self.tiles.lines:
            self._renew(self.tiles.size)
        else:
            self._lay_out()

    def visualRect(self, index: QModelIndex | QPersistentModelIndex) -> QRect:
        if not index.isValid() or index.column() != 0 or index.row() >= self.layout_.count:
            return QRect()
        left, top, width, height = self.layout_.box(index.row())
        return QRect(left, top - self.verticalOffset(), width, height)

    def indexAt(self, point: QPoint) -> QModelIndex:
        row = self.layout_.at(point.x(), point.y() + self.verticalOffset())
        return QModelIndex() if row is None else self.model().index(row, 0)

    def scrollTo(
        self,
        index: QModelIndex | QPersistentModelIndex,
        hint: QAbstractItemView.ScrollHint = QAbstractItemView.ScrollHint.EnsureVisible,
    ) -> None:
        if not index.isValid() or index.row() >= self.layout_.count:
            return
        _left, top, _width, height = self.layout_.box(index.row())
        bar, room = self.verticalScrollBar(), self.viewport().height()
        if hint is QAbstractItemView.ScrollHint.PositionAtCenter:
            bar.setValue(top + height // 2 - room // 2)
        elif top < bar.value():
            bar.setValue(top - GAP)
        elif top + height > bar.value() + room:
            bar.setValue(top + height + GAP - room)

    def moveCursor(self, action: QAbstractItemView.CursorAction, _keys: Qt.KeyboardModifier) -> QModelIndex:
        count = self.layout_.count
        if not count:
            return QModelIndex()
        current, act = self.currentIndex(), QAbstractItemView.CursorAction
        if not current.isValid():
            return self.model().index(0, 0)
        row = current.row()
        lines = max(1, self.viewport().height() // (self.tiles.tile[1] + GAP))
        sideways = {act.MoveLeft: -1, act.MovePrevious: -1, act.MoveRight: 1, act.MoveNext: 1}
        steps = {act.MoveUp: -1, act.MoveDown: 1, act.MovePageUp: -lines, act.MovePageDown: lines}
        if action in (act.MoveHome, act.MoveEnd):
            row = 0 if action is act.MoveHome else count - 1
        elif action in sideways:
            row += sideways[action]
        else:
            row = self.layout_.step(row, steps.get(action, 0))
        return self.model().index(min(count - 1, max(0, row)), 0)

    def horizontalOffset(self) -> int:
        return 0

    def verticalOffset(self) -> int:
        return self.verticalScrollBar().value()

    def scrollContentsBy(self, dx: int, dy: int) -> None:
        # What is seen already is moved; only what comes into view is painted.
        self.viewport().scroll(dx, dy)

    def isIndexHidden(self, index: QModelIndex | QPersistentModelIndex) -> bool:
        return index.column() != 0

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self.viewport())
        # Pictures that have come are painted where they lie, and not all that lies between them.
        clip, region = event.rect(), event.region()
        several = region.rectCount() > 1
        offset = self.verticalOffset()
        painter.translate(0, -offset)
        painter.setFont(self.tiles.font)
        current = self.currentIndex().row() if self.currentIndex().isValid() else -1
        focused = self.hasFocus()
        selection = self.selectionModel()
        top, bottom = clip.top() + offset, clip.bottom() + offset
        root = QModelIndex()
        for part, places in self.layout_.between(top, bottom):
            self._heading(painter, part, top, bottom)
            for row in places:
                left, y, width, height = self.layout_.box(row)
                if y > bottom or y + height < top or left > clip.right() or left + width < clip.left():
                    continue
                if several and not region.intersects(QRect(left, y - offset, width, height)):
                    continue
                look = Look(
                    self.form,
                    selected=selection.isRowSelected(row, root),
                    current=row == current,
                    focused=focused,
                    hovered=row == self._hovered,
                    stale=self.stale(row),
                )
                self.tiles.paint(painter, QRect(left, y, width, height), self._tile_of(row), look)
        self._marks(painter)
        painter.end()

    def _heading(self, painter: QPainter, part: int, top: int, bottom: int) -> None:
        left, y, width, height = self.layout_.heading(part)
        if not height or y > bottom or y + height < top:
            return
        shown = self.layout_.parts[part]
        font = QFont(self.tiles.font)
        font.setBold(True)
        painter.setFont(font)
        painter.setPen(self.palette().color(self.palette().ColorRole.WindowText))
        text = painter.fontMetrics().elidedText(
            make_visible(shown.title[:300]), Qt.TextElideMode.ElideMiddle, max(40, width - 80)
        )
        box = QRect(left, y, width, height)
        painter.drawText(box, Qt.AlignmentFlag.AlignVCenter, text)
        along = painter.fontMetrics().horizontalAdvance(text)
        painter.setFont(self.tiles.font)
        painter.setPen(self.palette().color(self.palette().ColorRole.PlaceholderText))
        count = str(shown.count)
        painter.drawText(box.adjusted(along + 8, 0, 0, 0), Qt.AlignmentFlag.AlignVCenter, count)
        start = left + along + 16 + painter.fontMetrics().horizontalAdvance(count)
        painter.setPen(self.palette().color(self.palette().ColorRole.Mid))
        painter.drawLine(start, y + height // 2, left + width, y + height // 2)

    def _marks(self, painter: QPainter) -> None:
        accent = self.palette().color(self.palette().ColorRole.Highlight)
        if self._drop_row >= 0 and self.layout_.count:
            row = min(self._drop_row, self.layout_.count - 1)
            left, y, width, height = self.layout_.box(row)
            at = left - GAP // 2 if self._drop_row <= row else left + width + GAP // 2
            painter.fillRect(at - 1, y, 3, height, accent)
        if self._band is not None:
            painter.setPen(accent)
            painter.drawRect(self._band.adjusted(0, 0, -1, -1))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self.viewport().width() != self.layout_.width:
            self._lay_out()
        else:
            self.updateGeometries()
            self.seen_changed.emit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange, QEvent.Type.StyleChange):
            self._renew(self.tiles.size)

    def sizeHint(self) -> QSize:
        return QSize(720, 520)

    def setSelection(self, rect: QRect, flags: QItemSelectionModel.SelectionFlag) -> None:
        box = rect.normalized().translated(0, self.verticalOffset())
        if self._ranging and self.currentIndex().isValid():
            # Shift selects from one to the other as they follow, and not a rectangle between them.
            ends = sorted((max(0, self._range_start), self.currentIndex().row()))
            rows = list(range(ends[0], ends[1] + 1))
        elif box.width() <= 1 and box.height() <= 1:
            row = self.layout_.at(box.left(), box.top())
            rows = [] if row is None else [row]
        else:
            rows = self.layout_.inside((box.left(), box.top(), box.width(), box.height()))
        self.selectionModel().select(self._selection(rows), flags)

    def _selection(self, rows: list[int]) -> QItemSelection:
        """Return runs of rows as ranges: ten thousand single ones would take a second."""
        selection, model, last = QItemSelection(), self.model(), self.model().columnCount() - 1
        if rows and rows[-1] - rows[0] == len(rows) - 1:  # they rise
            selection.select(model.index(rows[0], 0), model.index(rows[-1], last))
            return selection
        start = 0
        for place in range(1, len(rows) + 1):
            if place == len(rows) or rows[place] != rows[place - 1] + 1:
                selection.select(model.index(rows[start], 0), model.index(rows[place - 1], last))
                start = place
        return selection

    def select_rows(self, rows: list[int]) -> None:
        """Select these rows and no others; the first becomes the current one."""
        rows = sorted(rows)
        flag = QItemSelectionModel.SelectionFlag
        if rows:
            self.selectionModel().setCurrentIndex(self.model().index(rows[0], 0), flag.NoUpdate)
            self._range_start = rows[0]
        self.selectionModel().select(self._selection(rows), flag.ClearAndSelect)

    def selected_rows(self) -> list[int]:
        """Return the rows that are selected, in their order; from ranges, as an index for each of many takes long."""
        ranges = _ranges(self.selectionModel().selection())
        if len(ranges) == 1:
            return list(range(ranges[0].top(), ranges[0].bottom() + 1))
        return sorted({row for one in ranges for row in range(one.top(), one.bottom() + 1)})

    def visualRegionForSelection(self, selection: QItemSelection) -> QRegion:
        region, seen = QRegion(), set(self.seen())
        if selection.count() > 50:
            return QRegion(self.viewport().rect())
        for one in _ranges(selection):
            for row in seen.intersection(range(one.top(), one.bottom() + 1)):
                region += self.visualRect(self.model().index(row, 0))
        return region

    def mousePressEvent(self, event: QMouseEvent) -> None:
        index = self.indexAt(event.position().toPoint())
        if not index.isValid() and event.button() is Qt.MouseButton.LeftButton:
            # A band over the empty room; the press itself clears, unless Ctrl or Shift keeps what is selected.
            keys = Qt.KeyboardModifier
            keeps = event.modifiers() & (keys.ControlModifier | keys.ShiftModifier)
            if not keeps:
                self.clearSelection()
            self._anchor = event.position().toPoint() + QPoint(0, self.verticalOffset())
            self._band_base = self.selectionModel().selection() if keeps else QItemSelection()
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            return
        with self._range(event.modifiers()):
            super().mousePressEvent(event)

    @contextmanager
    def _range(self, modifiers: Qt.KeyboardModifier) -> Iterator[None]:
        """With Shift a range goes on from where it began; without, it begins at what becomes the current one."""
        self._ranging = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        if self._ranging and self._range_start < 0:
            self._range_start = self.currentIndex().row()
        try:
            yield
        finally:
            if not self._ranging:
                self._range_start = self.currentIndex().row()
            self._ranging = False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        point = event.position().toPoint()
        if self._anchor is not None:
            here = point + QPoint(0, self.verticalOffset())
            self._band = QRect(self._anchor, here).normalized()
            box = self._band
            rows = self.layout_.inside((box.left(), box.top(), max(1, box.width()), max(1, box.height())))
            flag = QItemSelectionModel.SelectionFlag
            selection = QItemSelection(self._band_base)
            selection.merge(self._selection(rows), flag.Select)
            self.selectionModel().select(selection, flag.ClearAndSelect)
            bar = self.verticalScrollBar()
            away = (point.y() > self.viewport().height()) - (point.y() < 0)
            bar.setValue(bar.value() + away * bar.singleStep())
            self.viewport().update()
            return
        row = self.layout_.at(point.x(), point.y() + self.verticalOffset())
        hovered = -1 if row is None else row
        if hovered != self._hovered:
            before, self._hovered = self._hovered, hovered
            self.refresh_rows([place for place in (before, hovered) if place >= 0])
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._anchor is not None:
            self._anchor = self._band = None
            self.viewport().update()
            return
        super().mouseReleaseEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        if self._hovered >= 0:
            row, self._hovered = self._hovered, -1
            self.refresh_rows([row])
        super().leaveEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.size_requested.emit(round(self.tiles.size * 1.15 ** (event.angleDelta().y() / 120.0)))
            event.accept()
            return
        super().wheelEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        # A Return that ends the writing of a name comes by here too, while the name is still the old one.
        writing = self.state() == QAbstractItemView.State.EditingState
        opens = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentIndex().isValid()
        if opens and not writing:
            self.activated.emit(self.currentIndex())
            return
        with self._range(event.modifiers()):
            super().keyPressEvent(event)

    def selectAll(self) -> None:
        count = self.layout_.count
        if count:
            flag = QItemSelectionModel.SelectionFlag
            self.selectionModel().select(self._selection(list(range(count))), flag.ClearAndSelect)

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        super().dragMoveEvent(event)
        if any(event.mimeData().hasFormat(kind) for kind in self._swatches.mime_types):
            action = self.drop_action(event)
            taken = action is not Qt.DropAction.IgnoreAction
            row = self.drop_row(event.position().toPoint()) if taken else -1
            if row != self._drop_row:
                self._drop_row = row
                self.viewport().update()
            event.setDropAction(action)
            event.setAccepted(taken)

    def dragLeaveEvent(self, event: QDragLeaveEvent) -> None:
        self._drop_row = -1
        self.viewport().update()
        super().dragLeaveEvent(event)

    def dropEvent(self, event: QDropEvent) -> None:
        row, self._drop_row = self.drop_row(event.position().toPoint()), -1
        self.viewport().update()
        self.setState(QAbstractItemView.State.NoState)
        self.dropped.emit(event, row)

    def startDrag(self, actions: Qt.DropAction) -> None:
        """Drag what is selected; what is moved is taken out by the edit itself, and not by the view."""
        model = self._swatches
        data = model.mime_of and model.mime_of([model.id_at(row) for row in self.selected_rows()])
        if data is None:
            return
        drag = QDrag(self)
        drag.setMimeData(data)
        here = self.visualRect(self.currentIndex())
        if here.isValid():
            drag.setPixmap(self.viewport().grab(self.tiles.picture_box(here)))
            drag.setHotSpot(QPoint(self.tiles.size // 2, self.tiles.size // 2))
        drag.exec(actions, Qt.DropAction.CopyAction)

    def drop_row(self, point: QPoint) -> int:
        """Return before which row a drop at a point falls; the number of rows where it falls behind the last."""
        y = point.y() + self.verticalOffset()
        found = self.layout_.near(point.x(), y)
        if found is None:
            return 0
        if y >= self.layout_.height:
            return self.layout_.count
        left, _top, width, _height = self.layout_.box(found)
        return found + 1 if point.x() > left + width // 2 else found

    def closeEditor(self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint) -> None:
        # Tab goes on to the next name, as in every list; Return stays.
        super().closeEditor(editor, hint)
        self.setFocus(Qt.FocusReason.OtherFocusReason)


def _ranges(selection: QItemSelection) -> list[QItemSelectionRange]:
    return [selection.at(number) for number in range(selection.count())]
