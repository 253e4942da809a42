"""The grid of swatches: what the mouse, the keys and drags do in it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QEvent, QItemSelection, QItemSelectionModel, QItemSelectionRange, QPoint, QRect, Qt
from PySide6.QtGui import (
    QDrag,
    QDragLeaveEvent,
    QDragMoveEvent,
    QDropEvent,
    QKeyEvent,
    QMouseEvent,
    QRegion,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractItemDelegate, QAbstractItemView, QWidget

from brdf_color_swatch.grid.model import SwatchModel
from brdf_color_swatch.grid.view import GridView


class SwatchGrid(GridView):
    """Swatches that can be selected, opened, dragged and dropped.

    A click selects, Ctrl more, Shift as they follow; a drag over the empty room draws a band.
    """

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
        model, data = self.model(), event.mimeData()
        if isinstance(model, SwatchModel) and any(data.hasFormat(kind) for kind in model.mime_types):
            row = self.drop_row(event.position().toPoint())
            if row != self._drop_row:
                self._drop_row = row
                self.viewport().update()
            event.acceptProposedAction()

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
        model = self.model()
        data = None
        if isinstance(model, SwatchModel) and model.mime_of is not None:
            data = model.mime_of([model.id_at(row) for row in self.selected_rows()])
        if data is None:
            return
        drag = QDrag(self)
        drag.setMimeData(data)
        here = self.visualRect(self.currentIndex())
        if here.isValid():
            drag.setPixmap(self.viewport().grab(self.tiles.picture_box(here)))
            drag.setHotSpot(QPoint(self.tiles.size // 2, self.tiles.size // 2))
        drag.exec(actions, Qt.DropAction.MoveAction)

    def drop_row(self, point: QPoint) -> int:
        """Return before which row a drop at a point falls; the number of rows where it falls behind the last."""
        found = self.layout_.near(point.x(), point.y() + self.verticalOffset())
        if found is None:
            return 0
        left, _top, width, _height = self.layout_.box(found)
        return found + 1 if point.x() > left + width // 2 else found

    def closeEditor(self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint) -> None:
        # Tab goes on to the next name, as in every list; Return stays.
        super().closeEditor(editor, hint)
        self.setFocus(Qt.FocusReason.OtherFocusReason)


def _ranges(selection: QItemSelection) -> list[QItemSelectionRange]:
    return [selection.at(number) for number in range(selection.count())]
