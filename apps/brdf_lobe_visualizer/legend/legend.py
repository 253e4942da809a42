"""The legend: a row per subject, with what can be done to it by mouse and by key. Rows in, edits to the session."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from brdf_qt.fields.form import described, fill_column, icon_button, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip, set_bold
from brdf_qt.fields.marks import Mark
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QPoint, QSize, Qt, Signal
from PySide6.QtGui import QDropEvent, QIcon, QKeyEvent, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QHBoxLayout,
    QHeaderView,
    QPushButton,
    QStackedWidget,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from brdf_lobe_visualizer.cuts.pens import LINE_SIZE, line_icon
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import Dash, Srgb
from brdf_lobe_visualizer.verdict import words_of
from brdf_suite.foreign_text import make_visible

TITLE, SOLO, REFERENCE, ERROR = range(4)
_KEY = Qt.ItemDataRole.UserRole
_FLAGS = (
    Qt.ItemFlag.ItemIsEnabled
    | Qt.ItemFlag.ItemIsSelectable
    | Qt.ItemFlag.ItemIsUserCheckable
    | Qt.ItemFlag.ItemIsEditable
    | Qt.ItemFlag.ItemIsDragEnabled
)


@dataclass(frozen=True)
class LegendRow:
    """What a row shows.

    ``error`` is a short text and ``verdict`` what it is worth; ``tip`` lists all that is known of the subject.
    """

    key: str
    title: str
    colour: Srgb
    dash: Dash
    shown: bool
    solo: bool
    reference: bool
    error: str
    tip: str
    verdict: Mark | None = None

    @property
    def spoken(self) -> str:
        """What a screen reader says of it."""
        words = [self.title, tr("shown") if self.shown else tr("hidden")]
        words += [tr("solo")] * self.solo + [tr("reference")] * self.reference
        words += [tr("error {error}").format(error=self.error)] * bool(self.error)
        words += [words_of(self.verdict)] if self.verdict is not None and self.error else []
        return ", ".join(words)


_KEYS = {
    Qt.Key.Key_Space: "shown",
    Qt.Key.Key_S: "solo",
    Qt.Key.Key_R: "reference",
    Qt.Key.Key_C: "colour",
    Qt.Key.Key_D: "dash",
    Qt.Key.Key_F2: "rename",
    Qt.Key.Key_Delete: "remove",
    Qt.Key.Key_Backspace: "remove",
}


class _Rows(QTreeWidget):
    """The rows; keys and drags that a tree does not know."""

    key_pressed = Signal(str)
    dropped = Signal(str, int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._dress()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.ApplicationPaletteChange:
            self._dress()

    def _dress(self) -> None:
        # Fusion frames the boxes of rows with a darker shade of the window, which is not seen on a dark one.
        shown = QApplication.palette()
        palette = QPalette()
        palette.setColor(QPalette.ColorRole.Window, shown.color(QPalette.ColorRole.PlaceholderText))
        self.setPalette(palette)
        self.header().setPalette(shown)

    def event(self, event: QEvent) -> bool:
        """Keep the legend's keys from commands of the window that have the same one, as Space has."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            plain = event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)
            if plain and Qt.Key(event.key()) in _KEYS:
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        modifiers = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        key = Qt.Key(event.key())
        if modifiers == Qt.KeyboardModifier.NoModifier and key in _KEYS:
            self.key_pressed.emit(_KEYS[key])
        elif modifiers == Qt.KeyboardModifier.AltModifier and key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self.key_pressed.emit("up" if key == Qt.Key.Key_Up else "down")
        else:
            super().keyPressEvent(event)

    def dropEvent(self, event: QDropEvent) -> None:
        """Emit which row was dropped where; the rows themselves follow the session."""
        row = self.currentItem()
        under = self.itemAt(event.position().toPoint())
        place = self.topLevelItemCount() if under is None else self.indexOfTopLevelItem(under)
        if under is not None and self.dropIndicatorPosition() == self.DropIndicatorPosition.BelowItem:
            place += 1
        event.setDropAction(Qt.DropAction.IgnoreAction)
        event.accept()
        if row is not None:
            before = self.indexOfTopLevelItem(row)
            self.dropped.emit(row.data(0, _KEY), place - 1 if before < place else place)


class Legend(QWidget):
    """All subjects, edited in the session. Signals with a key: ``renamed(key, title)``, ``dash_requested(key)``,
    ``colour_requested(key)``; without one ``menu_requested(QPoint)``, ``open_requested``, ``list_requested``.
    """

    renamed = Signal(str, str)
    colour_requested = Signal(str)
    dash_requested = Signal(str)
    menu_requested = Signal(QPoint)
    open_requested = Signal()
    list_requested = Signal()

    def __init__(self, session: LobeSession, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.setObjectName("legend")
        self._keys: list[str] = []
        self._shown: tuple[LegendRow, ...] = ()
        self._filling = False
        self.rows = _Rows()
        self._build_rows()
        self.pages = QStackedWidget()
        self.pages.addWidget(self.rows)
        self.pages.addWidget(self._empty())
        self.pages.setCurrentIndex(1)
        fill_column(self, self._head(), self.pages, grows=self.pages, spacing=4)
        self.setMinimumWidth(170)

    def show_rows(self, rows: Sequence[LegendRow], front: str) -> None:
        """Show these rows, of which that of key ``front`` is selected."""
        self._filling = True
        try:
            if [row.key for row in rows] != self._keys:
                self._keys = [row.key for row in rows]
                self.rows.clear()
                for _row in rows:
                    self.rows.addTopLevelItem(QTreeWidgetItem())
                self._shown = ()
            old = self._shown if len(self._shown) == len(rows) else (None,) * len(rows)
            for place, (row, before) in enumerate(zip(rows, old, strict=True)):
                item = self.rows.topLevelItem(place)
                if item is None:
                    continue
                if row != before:
                    _fill(item, row, before, self.devicePixelRatioF())
                if row.key == front and self.rows.currentItem() is not item:
                    self.rows.setCurrentItem(item)
            self._shown = tuple(rows)
        finally:
            self._filling = False
        self.pages.setCurrentIndex(0 if rows else 1)
        self.rows.setColumnHidden(ERROR, not any(row.error for row in rows))

    def edit_title(self, key: str) -> None:
        item = self.rows.topLevelItem(self._keys.index(key)) if key in self._keys else None
        if item is not None:
            self.rows.setFocus()
            self.rows.editItem(item, TITLE)

    def sizeHint(self) -> QSize:
        return QSize(252, 240)

    def _build_rows(self) -> None:
        rows = self.rows
        tip = tr(
            "Space: show or hide. S: solo. R: set as reference. C: colour. D: dash. "
            "F2: rename. Delete: remove. Alt+Up, Alt+Down: move."
        )
        described(rows, spoken=tr("Legend of reflectances"), tip=tip)
        rows.setHeaderLabels([tr("Reflectance"), tr("Solo"), tr("Ref."), tr("Error")])
        tips = (
            tr("Visibility, and line style in the plots"),
            tr("Solo: show only the reflectances ticked here"),
            tr("Reference for differences and errors"),
            tr("RMS difference relative to the reference, away from the mirror direction"),
        )
        for column, tip in enumerate(tips):
            rows.headerItem().setToolTip(column, plain_tip(tip))
        header = rows.header()
        header.setStretchLastSection(False)
        header.setMinimumSectionSize(24)
        header.setSectionResizeMode(TITLE, QHeaderView.ResizeMode.Stretch)
        for column in (SOLO, REFERENCE, ERROR):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        rows.setRootIsDecorated(False)
        rows.setUniformRowHeights(True)
        rows.setIconSize(LINE_SIZE)
        rows.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        rows.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        rows.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        rows.customContextMenuRequested.connect(
            lambda at: self.menu_requested.emit(rows.viewport().mapToGlobal(at))
        )
        rows.currentItemChanged.connect(self._selected)
        rows.itemChanged.connect(self._changed)
        rows.itemDoubleClicked.connect(
            lambda item, column: rows.editItem(item, TITLE) if column == TITLE else None
        )
        rows.key_pressed.connect(self._key)
        rows.dropped.connect(self._session.move)

    def _head(self) -> QHBoxLayout:
        title = PlainLabel(tr("Legend"))
        set_bold(title, True)
        return row_of(
            title,
            None,
            icon_button("folder-open", tr("Open a file"), self.open_requested.emit, flat=True),
            icon_button(
                "list-plus", tr("Add from the library of reflectances"), self.list_requested.emit, flat=True
            ),
            icon_button("eye", tr("Show all"), self._session.show_all, flat=True),
            spacing=4,
        )

    def _empty(self) -> QWidget:
        page = QWidget()
        text = PlainLabel(
            tr("No reflectances. Drop files here, or"), wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter
        )
        buttons = [QPushButton(tr("Open a File…")), QPushButton(tr("Add from Library…"))]
        for button, signal in zip(buttons, (self.open_requested, self.list_requested), strict=True):
            button.clicked.connect(signal)
        fill_column(page, None, text, *buttons, None)
        return page

    def _selected(self, item: QTreeWidgetItem | None) -> None:
        if item is not None and not self._filling:
            self._session.set_front(item.data(0, _KEY))

    def _changed(self, item: QTreeWidgetItem, column: int) -> None:
        key = item.data(0, _KEY)
        row = self._row(key)
        if self._filling or row is None:
            return
        checked = item.checkState(column) == Qt.CheckState.Checked
        if column == SOLO:
            self._session.set_solo(key, checked)
        elif column == REFERENCE:
            self._session.set_reference(key if checked else None)
        elif checked != row.shown:
            self._session.set_hidden(key, not checked)
        elif item.text(TITLE) != row.title:
            self._shown = ()  # the row shows what was typed, also where it is refused
            self.renamed.emit(key, item.text(TITLE))

    def _key(self, what: str) -> None:
        item = self.rows.currentItem()
        row = None if item is None else self._row(item.data(0, _KEY))
        if item is None or row is None:
            return
        place = self.rows.indexOfTopLevelItem(item)
        session = self._session
        acts: dict[str, Callable[[], object]] = {
            "shown": lambda: session.set_hidden(row.key, row.shown),
            "solo": lambda: session.set_solo(row.key, not row.solo),
            "reference": lambda: session.set_reference(None if row.reference else row.key),
            "colour": lambda: self.colour_requested.emit(row.key),
            "dash": lambda: self.dash_requested.emit(row.key),
            "rename": lambda: self.rows.editItem(item, TITLE),
            "remove": lambda: session.remove(row.key),
            "up": lambda: session.move(row.key, place - 1),
            "down": lambda: session.move(row.key, place + 1),
        }
        acts[what]()

    def _row(self, key: str) -> LegendRow | None:
        return next((row for row in self._shown if row.key == key), None)


def _fill(item: QTreeWidgetItem, row: LegendRow, before: LegendRow | None, ratio: float) -> None:
    item.setFlags(_FLAGS)
    item.setData(0, _KEY, row.key)
    item.setText(TITLE, make_visible(row.title))
    item.setToolTip(TITLE, plain_tip(row.tip))
    for column, on in ((TITLE, row.shown), (SOLO, row.solo), (REFERENCE, row.reference)):
        item.setCheckState(column, Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
    item.setText(ERROR, row.error)
    item.setIcon(ERROR, QIcon() if row.verdict is None else row.verdict.icon)
    item.setToolTip(ERROR, plain_tip(row.tip))
    item.setTextAlignment(ERROR, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    item.setData(TITLE, Qt.ItemDataRole.AccessibleTextRole, row.spoken)
    if before is None or (row.colour, row.dash) != (before.colour, before.dash):
        item.setIcon(TITLE, line_icon(row.colour, row.dash, ratio))
