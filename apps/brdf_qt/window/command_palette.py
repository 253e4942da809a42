"""Ctrl+K: find any command of the window by its name, and run it with Enter."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent, QPalette
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLineEdit, QListWidget, QListWidgetItem, QMainWindow, QMenu

from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import tr
from brdf_qt.window.command_search import search
from brdf_suite.foreign_text import make_visible

_ACTION = Qt.ItemDataRole.UserRole
_MOST_ROWS = 12


def commands(window: QMainWindow, *, also_disabled: bool = False) -> Iterator[tuple[str, QAction]]:
    """Yield (path, action) for every entry of the menus that can be chosen now, as in ``("File ▸ Open…", action)``."""
    for top in window.menuBar().actions():
        menu = top.menu()
        if isinstance(menu, QMenu):
            yield from _inside(menu, _plain(top.text()), also_disabled)


def _inside(menu: QMenu, path: str, also_disabled: bool) -> Iterator[tuple[str, QAction]]:
    menu.aboutToShow.emit()
    for action in menu.actions():
        text = f"{path} ▸ {_plain(action.text())}"
        below = action.menu()
        if isinstance(below, QMenu):
            yield from _inside(below, text, also_disabled)
        elif not action.isSeparator() and action.text() and (also_disabled or action.isEnabled()):
            yield text, action


def _plain(text: str) -> str:
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&")


class CommandPalette(QFrame):
    """A small list over the window; Escape or a click elsewhere closes it."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window, Qt.WindowType.Popup)
        self._window = window
        self.setObjectName("command_palette")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.query = QLineEdit()
        self.query.setPlaceholderText(tr("Find a command by name"))
        self.query.setAccessibleName(tr("Find a command by name"))
        self.query.setClearButtonEnabled(True)
        self.found = QListWidget()
        self.found.setAccessibleName(tr("Matching commands"))
        self.found.setToolTip(tr("Enter or a click runs the command; the arrow keys choose another"))
        self.found.setUniformItemSizes(True)
        self.found.setSpacing(3)
        self.found.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._empty = PlainLabel(tr("No matching command."))
        self._empty.setMargin(8)
        box = fill_column(self, self.query, self.found, self._empty, spacing=6)
        box.setContentsMargins(8, 8, 8, 8)
        self._all: list[tuple[str, QAction]] = []
        self.query.textChanged.connect(self._filter)
        self.query.installEventFilter(self)
        self.found.currentItemChanged.connect(self._mark_current)
        self.found.itemActivated.connect(self._run)
        self.found.itemClicked.connect(self._run)

    def open(self) -> None:
        """Show the palette at the top of the window with every command of now."""
        self._all = list(commands(self._window))
        self.query.clear()
        self._filter("")
        width = min(560, self._window.width() - 48)
        row = self.found.sizeHintForRow(0) if self.found.count() else 20
        self.resize(width, 64 + (row + 6) * _MOST_ROWS)
        corner = self._window.mapToGlobal(self._window.rect().topLeft())
        self.move(corner.x() + (self._window.width() - width) // 2, corner.y() + 56)
        self.show()
        self.query.setFocus()

    def _filter(self, query: str) -> None:
        kept = [self._all[index] for index in search(query, [text for text, _ in self._all])]
        self.found.clear()
        for text, action in kept:
            keys = action.shortcut().toString(action.shortcut().SequenceFormat.NativeText)
            item = QListWidgetItem(make_visible(text))
            item.setData(_ACTION, action)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{text} {keys}")
            self.found.addItem(item)
            if keys:
                self.found.setItemWidget(item, _KeyLabel(keys))
        self.found.setCurrentRow(0)
        self.found.setVisible(bool(kept))
        self._empty.setVisible(not kept)

    def _mark_current(self, current: QListWidgetItem | None, previous: QListWidgetItem | None) -> None:
        """Write the keys of the row that is chosen in the colour of text on the accent."""
        for item in (previous, current):
            label = None if item is None else self.found.itemWidget(item)
            if isinstance(label, _KeyLabel):
                label.set_current(item is current)

    def _run(self, item: QListWidgetItem) -> None:
        if not self.isVisible():  # One click may be reported twice, as a click and as an activation.
            return
        self.close()
        action: QAction = item.data(_ACTION)
        action.trigger()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.query and isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1}.get(Qt.Key(event.key()))
            if step is not None:
                row = self.found.currentRow() + step
                self.found.setCurrentRow(max(0, min(self.found.count() - 1, row)))
                return True
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                if item := self.found.currentItem():
                    self._run(item)
                return True
        return super().eventFilter(watched, event)


class _KeyLabel(QFrame):
    """The shortcut of a command at the right end of its row; lets clicks through to the list."""

    def __init__(self, keys: str) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 6, 0)
        row.addStretch(1)
        self.keys = PlainLabel(keys)
        row.addWidget(self.keys)
        self.set_current(False)

    def set_current(self, is_current: bool) -> None:
        """Take the colour of text in a chosen row, or of a remark."""
        roles = QPalette.ColorRole
        self.keys.setForegroundRole(roles.HighlightedText if is_current else roles.PlaceholderText)
