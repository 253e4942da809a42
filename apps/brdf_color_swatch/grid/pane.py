"""One pane: the swatches of a palette, group or tag, as a grid or a list, with a word where there are none."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.fields.form import described, fill_column, icon_button, row_of
from brdf_qt.fields.labels import ElidedLabel, PlainLabel, set_bold
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from PySide6.QtCore import (
    QEvent,
    QItemSelectionModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QPoint,
    QRect,
    QSignalBlocker,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QAccessible,
    QAccessibleAnnouncementEvent,
    QColor,
    QDropEvent,
    QPainter,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QStackedWidget,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QToolButton,
    QWidget,
)

from brdf_color_swatch.editing.transfer import TAKEN
from brdf_color_swatch.grid.grid import SwatchGrid
from brdf_color_swatch.grid.model import SORT_KEYS, SwatchModel, VisibleRows
from brdf_color_swatch.grid.tile import Tile

_CHIP = 18
_WITH_TEXT_PX = 420
"""In a narrower pane the button for what is selected is its icon alone."""


class _NameDelegate(QStyledItemDelegate):
    """Puts the editor of a name where the name is written."""

    def __init__(self, grid: SwatchGrid) -> None:
        super().__init__(grid)
        self._grid = grid

    def createEditor(
        self, parent: QWidget, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex
    ) -> QWidget:
        editor = QLineEdit(parent)
        editor.setAlignment(Qt.AlignmentFlag.AlignCenter)
        editor.setMaxLength(200)
        return editor

    def updateEditorGeometry(
        self, editor: QWidget, _option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        editor.setGeometry(self._grid.tiles.name_box(self._grid.visualRect(index)))


class ChipDelegate(QStyledItemDelegate):
    """Draws three chips, or one for a flat colour, and then the text."""

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        model = index.model()
        assert isinstance(model, SwatchModel)
        inside = QStyleOptionViewItem(option)
        inside.rect = option.rect.adjusted(3 * _CHIP + 8, 0, 0, 0)
        super().paint(painter, inside, index)
        place = model.shown.places[index.row()]
        top, height = option.rect.top() + 3, option.rect.height() - 6
        for number, code in enumerate(model.shown.rows.codes[place]):
            chip = QRect(option.rect.left() + 4 + number * _CHIP, top, _CHIP, height)
            painter.fillRect(chip, QColor(*(int(part) for part in code)))

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex
    ) -> None:
        editor.setGeometry(option.rect.adjusted(3 * _CHIP + 8, 0, 0, 0))


_WIDTHS = {"name": 200, "code": 96, "tags": 140, "date": 90, "gloss": 96, "flop": 56}


class Pane(QFrame):
    """Grid and list over one model and one selection.

    Signals: ``activated()``, ``selected(ids)``, ``opened(id)`` for Return or a double click,
    ``dropped(event, row)``,
    ``menu_requested(point)`` in screen coordinates,
    ``close_requested()``, ``action_requested(key)`` for a button of the empty page, ``seen_changed()``. What the user
    edits, sorts or scales is emitted by :attr:`model` and :attr:`grid`.
    """

    activated = Signal()
    selected = Signal(object)
    opened = Signal(str)
    dropped = Signal(object, int)
    menu_requested = Signal(QPoint)
    close_requested = Signal()
    action_requested = Signal(str)
    seen_changed = Signal()

    def __init__(
        self, number: int, picture_of: Callable[[int, int], object], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.number = number
        self._picture_of = picture_of
        self._quiet = False
        self._note = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter, minimumWidth=120)
        self._bar, self._buttons = QProgressBar(), row_of(spacing=6)
        self.setObjectName(f"pane_{number}")
        self.setAccessibleName(tr("Swatches") if number == 0 else tr("Swatches, second pane"))
        self.model = SwatchModel(self)
        self.model.mime_types = TAKEN
        self.grid = described(SwatchGrid(self.model, self.tile_of), spoken=tr("Grid of swatches"))
        self.grid.setItemDelegate(_NameDelegate(self.grid))
        self.list = _list(self.model)
        self.list.setSelectionModel(self.grid.selectionModel())
        self._head()
        self.stack = QStackedWidget()
        for page in (self.grid, self.list, self._note_page()):
            self.stack.addWidget(page)
        fill_column(self, self.head, self.stack, grows=self.stack, spacing=0)
        self._as_list = False
        self.title = ""
        """What is shown, in words."""
        self._join()

    def tile_of(self, row: int) -> Tile:
        shown = self.model.shown
        place = shown.places[row]
        return shown.rows.tile(place, self._picture_of(self.number, row), shown.figure.get(place))

    def show_rows(self, shown: VisibleRows) -> None:
        """Show these swatches; what was selected stays so where it is still there, and so does the place."""
        current = self.grid.currentIndex()
        row: int | None = current.row() if current.isValid() else None
        key = "" if row is None else self.model.id_at(row)
        rows = self.grid.selected_rows()
        kept = self.model.ids_at(rows)
        top = self.grid.verticalScrollBar().value()
        top_list = self.list.verticalScrollBar().value()
        self._quiet = True
        if not self.model.show(shown):
            rows = [found for one in kept if (found := self.model.row_of(one)) is not None]
            row = self.model.row_of(key) if key else None
        self.grid.select_rows(rows)
        if row is not None:
            flag = QItemSelectionModel.SelectionFlag.NoUpdate
            self.grid.selectionModel().setCurrentIndex(self.model.index(row, 0), flag)
        self.grid.verticalScrollBar().setValue(top)
        self.list.verticalScrollBar().setValue(top_list)
        self._quiet = False
        self._report_selected()

    def show_note(self, text: str, actions: tuple[tuple[str, str], ...] = (), *, busy: bool = False) -> None:
        """Show a word instead of swatches, with buttons (text, key); empty text shows the swatches."""
        if text:
            self._note.setText(text)
            self._bar.setVisible(busy)
            while self._buttons.count():
                taken = self._buttons.takeAt(0)
                widget = taken.widget() if taken is not None else None
                if widget is not None:
                    widget.hide()  # at once: it is taken away later
                    widget.deleteLater()
            for label, key in actions:
                button = described(QPushButton(label), name=f"note_{key}")
                button.clicked.connect(lambda _=False, key=key: self.action_requested.emit(key))
                self._buttons.addWidget(button)
        self._noted = bool(text)
        self._turn()

    def show_as_list(self, as_list: bool) -> None:
        self._as_list = as_list
        self._turn()

    def _turn(self) -> None:
        page = 2 if self._noted else 1 if self._as_list else 0
        if self.stack.currentIndex() != page:
            had_focus = self.isAncestorOf(self.focusWidget()) if self.focusWidget() else False
            self.stack.setCurrentIndex(page)
            if had_focus:
                self.view.setFocus(Qt.FocusReason.OtherFocusReason)

    @property
    def note(self) -> str:
        """What is written instead of swatches; empty where they are shown."""
        return self._note.text() if self._noted else ""

    @property
    def view(self) -> QAbstractItemView:
        return self.list if self._as_list else self.grid

    def show_title(self, title: str, count: str, *, front: bool, two: bool) -> None:
        """Show what the pane is of; ``front``: it is the one that is worked in, of ``two`` where there are two."""
        self.title = title
        self._title.setText(title)
        set_bold(self._title, front)
        self._count.setText(count)
        # The first pane stays.
        self._close.setVisible(two and self.number > 0)
        self._mark.setVisible(front and two)

    def reveal(self, ids: tuple[str, ...]) -> None:
        rows = [row for one in ids if (row := self.model.row_of(one)) is not None]
        if not rows:
            return
        self.grid.select_rows(rows)
        index = self.model.index(min(rows), 0)
        for view in (self.grid, self.list):
            view.scrollTo(index, QAbstractItemView.ScrollHint.EnsureVisible)
        self.view.setFocus(Qt.FocusReason.OtherFocusReason)

    def rename_current(self) -> None:
        index = self.grid.currentIndex()
        if index.isValid():
            index = self.model.index(index.row(), 0)
            self.view.scrollTo(index)
            self.view.setCurrentIndex(index)
            self.view.edit(index)

    def show_sort(self, key: str, *, descending: bool) -> None:
        """Show in the list's head what it is ordered by."""
        header = self.list.horizontalHeader()
        descends = key in SORT_KEYS and descending
        with QSignalBlocker(header):
            header.setSortIndicator(
                SORT_KEYS.index(key) if key in SORT_KEYS else -1,
                Qt.SortOrder.DescendingOrder if descends else Qt.SortOrder.AscendingOrder,
            )

    def _head(self) -> None:
        self.head = QWidget()
        self.head.setMinimumHeight(30)
        self._mark = described(PlainLabel("▸"), name="front_mark", tip=tr("Active pane"))
        self._title = ElidedLabel()
        self._count = PlainLabel()
        self._count.setForegroundRole(self._count.foregroundRole().PlaceholderText)
        self._close = icon_button("x", tr("Close pane"), self.close_requested.emit, flat=True)
        tip = tr("Copy the selected swatches to a new palette, in a file of its own")
        self.new_palette = described(
            QToolButton(), name="new_from_selection", spoken=tr("New Palette from Selection…"), tip=tip
        )
        self.new_palette.setText(tr("New Palette from Selection…"))
        self.new_palette.setIcon(icon("file-plus"))
        self.new_palette.setAutoRaise(True)
        self.new_palette.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.new_palette.clicked.connect(lambda: self.action_requested.emit("new_from_selection"))
        self.new_palette.hide()
        parts = (self._mark, self._title, self.new_palette, self._count, self._close)
        self.head.setLayout(row_of(*parts, grows=self._title, margins=(8, 2, 8, 2)))
        for widget in (self.head, self._mark, self._title, self._count):
            widget.installEventFilter(self)

    def _note_page(self) -> QWidget:
        page = QWidget()
        page.setAcceptDrops(True)
        page.installEventFilter(self)
        self._noted = False
        self._bar.setRange(0, 0)
        self._bar.setTextVisible(False)
        self._bar.setMaximumWidth(240)
        policy = self._bar.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self._bar.setSizePolicy(policy)
        bar, buttons = row_of(None, self._bar, None), row_of(None, self._buttons, None)
        margins = (24, 24, 24, 24)
        box = fill_column(page, None, self._note, bar, buttons, None, spacing=6, margins=margins)
        # A little above the middle.
        box.setStretch(0, 2)
        box.setStretch(4, 3)
        return page

    def _join(self) -> None:
        self.grid.dropped.connect(self.dropped)
        self.grid.seen_changed.connect(self.seen_changed)
        self.grid.selectionModel().selectionChanged.connect(lambda *_: self._report_selected())
        self.grid.selectionModel().currentChanged.connect(lambda now, _before: self._speak(now))
        for view in (self.grid, self.list):
            view.activated.connect(self._open)
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
            view.customContextMenuRequested.connect(
                lambda point, view=view: self.menu_requested.emit(view.viewport().mapToGlobal(point))
            )
            view.installEventFilter(self)
            view.viewport().installEventFilter(self)
        self.list.verticalScrollBar().valueChanged.connect(lambda _value: self.seen_changed.emit())
        self.list.horizontalHeader().sortIndicatorChanged.connect(
            lambda section, order: self.model.sort(section, order)
        )

    def _open(self, index: QModelIndex) -> None:
        if index.isValid():
            self.opened.emit(self.model.id_at(index.row()))

    def _speak(self, index: QModelIndex) -> None:
        """Describe the current swatch to a screen reader: its name and its colour."""
        if not index.isValid():
            return
        shown = self.model.shown
        text = shown.rows.describe_aloud(shown.places[index.row()])
        self.grid.setAccessibleDescription(text)
        if self.grid.hasFocus() and QAccessible.isActive():
            QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self.grid, text))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        styles = Qt.ToolButtonStyle
        narrow = self.width() < _WITH_TEXT_PX
        self.new_palette.setToolButtonStyle(
            styles.ToolButtonIconOnly if narrow else styles.ToolButtonTextBesideIcon
        )

    def _report_selected(self) -> None:
        self.new_palette.setVisible(self.grid.selectionModel().hasSelection())
        if not self._quiet:
            self.selected.emit(self.model.ids_at(self.grid.selected_rows()))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.FocusIn, QEvent.Type.MouseButtonPress):
            self.activated.emit()
        heads = (self.head, self._mark, self._title, self._count)
        if event.type() == QEvent.Type.MouseButtonPress and watched in heads:
            # The keys go where the click has gone.
            self.view.setFocus(Qt.FocusReason.MouseFocusReason)
        if (
            watched is self.list.viewport()
            and isinstance(event, QDropEvent)
            and event.type() == QEvent.Type.Drop
        ):
            index = self.list.indexAt(event.position().toPoint())
            self.dropped.emit(event, index.row() if index.isValid() else self.model.rowCount())
            return True
        if watched is self.stack.widget(2) and isinstance(event, QDropEvent):
            # Enter and move events are drop events too.
            event.acceptProposedAction()
            if event.type() == QEvent.Type.Drop:
                self.dropped.emit(event, 0)
            return True
        return super().eventFilter(watched, event)

    def sizeHint(self) -> QSize:
        return QSize(480, 480)


def _list(model: SwatchModel) -> QTableView:
    view = described(QTableView(), name="list", spoken=tr("List of swatches"))
    view.setModel(model)
    view.setItemDelegateForColumn(0, ChipDelegate(view))
    view.setFrameShape(QFrame.Shape.NoFrame)
    view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
    view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    view.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)
    view.setDragDropMode(QAbstractItemView.DragDropMode.DragDrop)
    view.setDefaultDropAction(Qt.DropAction.MoveAction)
    view.setDragDropOverwriteMode(False)
    view.setAlternatingRowColors(True)
    view.setShowGrid(False)
    view.setWordWrap(False)
    view.setTabKeyNavigation(False)
    view.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
    vertical = view.verticalHeader()
    vertical.hide()
    vertical.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    vertical.setDefaultSectionSize(26)
    header = view.horizontalHeader()
    header.setSectionsClickable(True)
    header.setSortIndicatorShown(True)
    header.setSortIndicatorClearable(True)
    header.setHighlightSections(False)
    for column, key in enumerate(SORT_KEYS):
        view.setColumnWidth(column, _WIDTHS.get(key, 62))
    return view
