"""The strip of states: a small picture and the step that led to each, the present one selected."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from brdf_qt.fields.form import described
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import tr
from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QPersistentModelIndex,
    QPoint,
    QRect,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QFontMetrics, QPainter, QPalette, QPen, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from brdf_suite.documents.paint import Paint
from brdf_suite.foreign_text import make_visible

PICTURE, SMALL_PICTURE = 48, 32
_WIDTH, _PAD, _NAME_LINES, _BEHIND_OPACITY = 92, 4, 2, 0.45
Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True)
class HistoryState:
    """A state: the step that led to it, and the paint."""

    step: str
    paint: Paint


class HistoryModel(QAbstractListModel):
    """The states as rows; what stays from one history to the next is not drawn anew.

    ``picture`` gives the small picture of a paint, at once.
    """

    def __init__(self, picture: Callable[[Paint], QPixmap], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.picture = picture
        self.states: tuple[HistoryState, ...] = ()
        self.present = 0

    def show(self, states: Sequence[HistoryState], present: int) -> None:
        """Show ``states``, of which ``present`` is the paint as it is now."""
        new, old = tuple(states), self.states
        same = next(
            (i for i, (a, b) in enumerate(zip(old, new, strict=False)) if a != b), min(len(old), len(new))
        )
        here = QModelIndex()
        if len(new) < len(old):
            self.beginRemoveRows(here, len(new), len(old) - 1)
            self.states = old[: len(new)]
            self.endRemoveRows()
        elif len(new) > len(old):
            self.beginInsertRows(here, len(old), len(new) - 1)
            self.states = (*old, *new[len(old) :])
            self.endInsertRows()
        self.states, self.present = new, present
        if new:
            # Where the present one moved, what lies behind it is dimmed and the rest is not.
            first = 0 if same == len(new) else min(same, present)
            self.dataChanged.emit(self.index(first), self.index(len(new) - 1))

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self.states)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        state = self.states[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return make_visible(state.step or tr("Opened"))
        if role == Qt.ItemDataRole.ToolTipRole:
            return plain_tip(self._description(index.row(), state))
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return self._description(index.row(), state)
        if role == Qt.ItemDataRole.DecorationRole:
            return self.picture(state.paint)
        return None

    def _description(self, row: int, state: HistoryState) -> str:
        text = tr("State {number}: {step}").format(number=row, step=state.step or tr("Opened"))
        if row == self.present:
            return tr("{state}, current").format(state=text)
        if row > self.present:
            return tr("{state}, undone").format(state=text)
        return text


def name_lines(name: str, metrics: QFontMetrics, width: int) -> list[str]:
    """Return a step's name in as many lines as there is room for; omissions are marked by an ellipsis."""
    lines: list[str] = []
    for word in make_visible(name).split():
        longer = f"{lines[-1]} {word}" if lines else word
        # The last line takes all that is left, and is cut.
        if lines and (len(lines) == _NAME_LINES or metrics.horizontalAdvance(longer) <= width):
            lines[-1] = longer
        else:
            lines.append(word)
    return [metrics.elidedText(line, Qt.TextElideMode.ElideRight, width) for line in lines]


class _Painter(QStyledItemDelegate):
    """Draws a state: picture over its step's name; undone ones are faint, the present one has the accent's frame.

    ``compact``: smaller pictures, and the names in the tips alone.
    """

    compact = False

    @property
    def size(self) -> int:
        """Width and height of a picture."""
        return SMALL_PICTURE if self.compact else PICTURE

    def height(self, option: QStyleOptionViewItem) -> int:
        """Return the height of a state."""
        name = 2 if self.compact else _NAME_LINES * option.fontMetrics.height() + 6
        return self.size + 2 * _PAD + name

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        model = index.model()
        assert isinstance(model, HistoryModel)
        painter.save()
        rect = option.rect.adjusted(1, 1, -1, -1)
        # While there is nothing to scroll, the room of the scroll bar is the item's too.
        rect.setHeight(min(rect.height(), self.height(option) - 2))
        if index.row() > model.present:
            painter.setOpacity(_BEHIND_OPACITY)
        box = QRect(0, 0, self.size, self.size)
        box.moveCenter(QPoint(rect.center().x(), rect.top() + _PAD + self.size // 2))
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawPixmap(box, index.data(Qt.ItemDataRole.DecorationRole))
        painter.setPen(option.palette.color(QPalette.ColorRole.WindowText))
        if not self.compact:
            below = rect.adjusted(3, self.size + 2 * _PAD, -3, -1)
            flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop
            name = "\n".join(name_lines(str(index.data()), option.fontMetrics, below.width()))
            painter.drawText(below, flags, name)
        role = QPalette.ColorRole
        painter.setOpacity(1.0)
        if index.row() == model.present:
            painter.setPen(QPen(option.palette.color(role.Highlight), 2.0))
            painter.drawRect(rect.adjusted(1, 1, -1, -1))
        elif option.state & (QStyle.StateFlag.State_HasFocus | QStyle.StateFlag.State_MouseOver):
            painter.setPen(QPen(option.palette.color(role.Mid), 1.0))
            painter.drawRect(rect.adjusted(0, 0, -1, -1))
        painter.restore()

    def sizeHint(self, option: QStyleOptionViewItem, _index: Index) -> QSize:
        # So wide that the longest of the common names has two lines.
        wide = max(_WIDTH, option.fontMetrics.horizontalAdvance("Change Lightness") + 16)
        return QSize(self.size + 2 * _PAD + 2 if self.compact else wide, self.height(option))


class HistoryStrip(QListView):
    """The states side by side, the newest at the right.

    Signals: ``chosen(place)`` on a click or Enter, ``menu_requested(place, QPoint)`` with where, on the screen.
    """

    chosen = Signal(int)
    menu_requested = Signal(int, QPoint)

    def __init__(self, picture: Callable[[Paint], QPixmap], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        tip = tr("States of this paint, oldest at the left; click one to restore it.")
        described(self, name="history_strip", spoken=tr("History of this paint"), tip=tip)
        self.states = HistoryModel(picture, self)
        self.setModel(self.states)
        self._painter = _Painter(self)
        self.setItemDelegate(self._painter)
        self.setFlow(QListView.Flow.LeftToRight)
        self.setWrapping(False)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        # Its place is kept: the pictures shall not move when they become too many.
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.viewport().setBackgroundRole(QPalette.ColorRole.Window)
        self.clicked.connect(lambda index: self.chosen.emit(index.row()))
        self.activated.connect(lambda index: self.chosen.emit(index.row()))
        self.customContextMenuRequested.connect(self._ask_menu)
        self._fit_height()

    def show_states(self, states: Sequence[HistoryState], present: int) -> None:
        """Show ``states``, and bring the present one into sight."""
        moved = present != self.states.present or len(states) != len(self.states.states)
        self.states.show(states, present)
        if moved:
            index = self.states.index(present)
            self.setCurrentIndex(index)
            self.scrollTo(index)

    @property
    def is_compact(self) -> bool:
        """Whether it is shown at its lowest."""
        return self._painter.compact

    def set_compact(self, on: bool) -> None:
        """Take less room: in a low window the colours come first."""
        if on != self._painter.compact:
            self._painter.compact = on
            self._fit_height()
            self.doItemsLayout()

    def _fit_height(self) -> None:
        option = QStyleOptionViewItem()
        self.initViewItemOption(option)
        self.setFixedHeight(self._painter.height(option) + self.horizontalScrollBar().sizeHint().height())

    def redraw(self) -> None:
        """Draw again: a picture has come."""
        self.viewport().update()

    def _ask_menu(self, place: QPoint) -> None:
        index = self.indexAt(place)
        if index.isValid():
            self.menu_requested.emit(index.row(), self.viewport().mapToGlobal(place))
