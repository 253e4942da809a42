"""A list of thumbnails with their names, as a grid or in one row; only those in sight are made."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QPersistentModelIndex, QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import (
    QHelpEvent,
    QHideEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QPixmap,
    QResizeEvent,
    QShowEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QToolTip,
    QWidget,
)

from brdf_qt.choosing.sources import KEY_ROLE, FilteredSources
from brdf_qt.fields.labels import plain_tip, set_small
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer

PICTURE = 64
"""Width and height of a picture, points."""
_PAD = 4
_MARK = 20
"""Width and height of the mark at a tile's upper right, points."""
_SOON_MS = 30
"""After the last step of a scroll; what only flies by is not drawn."""
_TAKE_KEYS = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class _Tile(QStyledItemDelegate):
    """Draws a picture and under it the name, shortened; the present one is filled with the accent."""

    def __init__(self, view: ThumbnailView) -> None:
        super().__init__(view)
        self._view = view

    def sizeHint(self, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex) -> QSize:
        return self._view.tile

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        box: QRect = option.rect
        state: QStyle.StateFlag = option.state
        palette, role = self._view.palette(), QPalette.ColorRole
        present = index.data(KEY_ROLE) == self._view.sources.model.present
        if present:
            painter.fillRect(box, palette.color(role.Highlight))
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(box, palette.color(role.Midlight))
        place = QRect(box.left() + (box.width() - PICTURE) // 2, box.top() + _PAD, PICTURE, PICTURE)
        picture = index.data(Qt.ItemDataRole.DecorationRole)
        if isinstance(picture, QPixmap):
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawPixmap(place, picture)
        painter.setFont(self._view.font())
        painter.setPen(palette.color(role.HighlightedText if present else role.Text))
        line = QRect(box.left() + 2, place.bottom() + 2, box.width() - 4, self._view.fontMetrics().height())
        metrics = self._view.fontMetrics()
        name = metrics.elidedText(str(index.data())[:200], Qt.TextElideMode.ElideRight, line.width())
        painter.drawText(line, Qt.AlignmentFlag.AlignCenter, name)
        hovered = bool(state & QStyle.StateFlag.State_MouseOver)
        self._paint_mark(painter, box, index, wanted=hovered, present=present)
        if self._view.hasFocus() and index == self._view.currentIndex():
            painter.setPen(QPen(palette.color(role.HighlightedText if present else role.Highlight), 2))
            painter.drawRect(box.adjusted(1, 1, -1, -1))

    def _paint_mark(
        self,
        painter: QPainter,
        box: QRect,
        index: QModelIndex | QPersistentModelIndex,
        *,
        wanted: bool,
        present: bool,
    ) -> None:
        """Draw the mark of comparing: under the pointer, and where that is done already."""
        view = self._view
        is_second = bool(view.second) and index.data(KEY_ROLE) == view.second
        focused = view.hasFocus() and index == view.currentIndex()
        if not view.mark_tip or not (is_second or ((wanted or focused) and not present)):
            return
        palette, role, place = view.palette(), QPalette.ColorRole, view.mark_box(box)
        painter.fillRect(place, palette.color(role.Highlight if is_second else role.Button))
        painter.setPen(palette.color(role.Mid))
        painter.drawRect(place.adjusted(0, 0, -1, -1))
        icon("scales").paint(painter, place.adjusted(2, 2, -2, -2))


class ThumbnailView(QListView):
    """Shows ``sources``, in one row or, with ``wraps``, as a grid; a click or Enter takes one.

    Signals: ``taken(key, shifted)``, with whether Shift was held, or the mark of the tile was met.
    """

    taken = Signal(str, bool)

    def __init__(
        self, sources: FilteredSources, owner: str, *, wraps: bool, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.sources, self._owner, self._wraps = sources, owner, wraps
        set_small(self)
        self.tile = QSize(PICTURE + 6 * _PAD, PICTURE + 2 * _PAD + self.fontMetrics().height() + 2)
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setFlow(QListView.Flow.LeftToRight)
        self.setWrapping(wraps)
        self.setMovement(QListView.Movement.Static)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setUniformItemSizes(True)
        self.setGridSize(self.tile)
        self.setItemDelegate(_Tile(self))
        self.mark_tip = ""
        """What the mark at a tile's upper right does, "{name}" in it; without it the tiles have none."""
        self.second = ""
        """The key of the entry that the present one is compared with; its mark stays."""
        self._pressed_at = QPoint()
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setDragDropMode(QAbstractItemView.DragDropMode.DragOnly)
        self.setDragEnabled(True)
        self.setMouseTracking(True)
        policy = Qt.ScrollBarPolicy
        if not wraps:
            self.setVerticalScrollBarPolicy(policy.ScrollBarAlwaysOff)
            self.setHorizontalScrollBarPolicy(policy.ScrollBarAlwaysOn)  # its room is kept: nothing jumps
            bar = self.horizontalScrollBar()
            bar.setSingleStep(self.tile.width())
            self.setFixedHeight(self.tile.height() + bar.sizeHint().height() + 2 * self.frameWidth())
        else:
            self.setHorizontalScrollBarPolicy(policy.ScrollBarAlwaysOff)
            self.verticalScrollBar().setSingleStep(self.tile.height() // 2)
        self.setModel(sources)
        self._soon = make_timer(self, self._request, _SOON_MS)
        for bar in (self.horizontalScrollBar(), self.verticalScrollBar()):
            bar.valueChanged.connect(lambda _value: self._later())
        for changed in (sources.modelReset, sources.layoutChanged, sources.rowsInserted, sources.rowsRemoved):
            changed.connect(self._later)
        sources.model.present_changed.connect(self.show_present)
        self.clicked.connect(
            lambda index: self._take(
                index, shifted=_shift_held() or self._meets_mark(index, self._pressed_at)
            )
        )

    def show_present(self, key: str) -> None:
        """Bring the present entry in sight."""
        row = self.sources.row_of(key)
        if row >= 0:
            self.setCurrentIndex(self.sources.index(row, 0))
            self.scrollTo(self.currentIndex())
        self.viewport().update()

    def show_second(self, key: str) -> None:
        """Mark the entry that the present one is compared with; an empty key marks none."""
        if key != self.second:
            self.second = key
            self.viewport().update()

    @staticmethod
    def mark_box(tile: QRect) -> QRect:
        """Return where the mark of a tile is."""
        return QRect(tile.right() - _MARK - 1, tile.top() + 2, _MARK, _MARK)

    def _meets_mark(self, index: QModelIndex, place: QPoint) -> bool:
        if not self.mark_tip or not index.isValid() or index.data(KEY_ROLE) == self.sources.model.present:
            return False
        return self.mark_box(self.visualRect(index)).contains(place)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._pressed_at = event.position().toPoint()
        super().mousePressEvent(event)

    def viewportEvent(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent):
            index = self.indexAt(event.pos())
            if self._meets_mark(index, event.pos()):
                said = self.mark_tip.format(name=index.data())
                box = self.mark_box(self.visualRect(index))
                QToolTip.showText(event.globalPos(), plain_tip(said), self, box)
                return True
        return super().viewportEvent(event)

    def go_in(self) -> None:
        """Take the keyboard, on an entry."""
        if not self.currentIndex().isValid() and self.sources.rowCount():
            self.setCurrentIndex(self.sources.index(0, 0))
        self.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def in_sight(self) -> range:
        """Return the rows that are seen, and one more tile at each side."""
        wide, high = max(1, self.tile.width()), max(1, self.tile.height())
        if not self._wraps:
            first = self.horizontalOffset() // wide - 1
            return range(max(0, first), first + self.viewport().width() // wide + 3)
        columns = max(1, self.viewport().width() // wide)
        first = self.verticalOffset() // high - 1
        return range(max(0, first * columns), (first + self.viewport().height() // high + 4) * columns)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.sources.rowCount():
            painter = QPainter(self.viewport())
            painter.setPen(self.palette().color(QPalette.ColorRole.PlaceholderText))
            area = self.viewport().rect().adjusted(8, 8, -8, -8)
            painter.drawText(
                area, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, tr("Nothing matches.")
            )

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _TAKE_KEYS and self.currentIndex().isValid():
            shifted = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self._take(self.currentIndex(), shifted=shifted)
            return
        if not self._wraps and event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            step = 1 if event.key() == Qt.Key.Key_Right else -1
            row = min(max(self.currentIndex().row() + step, 0), self.sources.rowCount() - 1)
            self.setCurrentIndex(self.sources.index(row, 0))
            return
        super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll a row sideways by the usual wheel too."""
        turned = event.angleDelta()
        if self._wraps or turned.x():
            super().wheelEvent(event)
            return
        bar = self.horizontalScrollBar()
        bar.setValue(bar.value() - round(turned.y() / 120 * 2 * self.tile.width()))
        event.accept()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._later()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._later()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._later()

    def _later(self, *_: object) -> None:
        self._soon.start()

    def _request(self) -> None:
        thumbnails = self.sources.model.thumbnails
        if thumbnails is not None:
            shown = self.sources.sources(self.in_sight()) if self.isVisible() else []
            thumbnails.request(self._owner, [(source.key, source.content) for source in shown])

    def _take(self, index: QModelIndex, *, shifted: bool) -> None:
        key = str(index.data(KEY_ROLE))
        self.sources.model.note_taken(key)
        self.taken.emit(key, shifted)


def _shift_held() -> bool:
    return bool(QApplication.keyboardModifiers() & Qt.KeyboardModifier.ShiftModifier)
