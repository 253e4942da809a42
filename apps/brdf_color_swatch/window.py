"""The window of Color Swatch: library at the left, swatches in one or two panes, inspector at the right.

Intents out, setters in; what a part of the program adds comes through ``add_section``, ``add_command``, ``add_dock``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import Shortcut, SuiteWindow
from brdf_qt.window.message_bar import Message
from brdf_qt.window.section import Section
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QCloseEvent, QDragEnterEvent, QDropEvent, QKeySequence
from PySide6.QtWidgets import QDockWidget, QHBoxLayout, QMenu, QSplitter, QToolButton, QVBoxLayout, QWidget

from brdf_color_swatch.grid.pane import Pane
from brdf_color_swatch.library.tree import LibraryTree
from brdf_color_swatch.panels.filters import FiltersPanel
from brdf_color_swatch.panels.palette import PalettePanel
from brdf_color_swatch.panels.swatch import SwatchPanel
from brdf_color_swatch.panels.top_bar import TopBar


class SwatchWindow(SuiteWindow):
    """Signals: ``open_requested(Path | None)``, ``recent_cleared()``, ``close_requested(QCloseEvent)``."""

    open_requested = Signal(object)
    recent_cleared = Signal()
    close_requested = Signal(QCloseEvent)

    def __init__(self, lights: list[str]) -> None:
        super().__init__("Color Swatch")
        self.setAcceptDrops(True)
        self.tree = LibraryTree()
        self.bar = TopBar(lights)
        self.picture_of: Callable[[int, int], object] = lambda _pane, _row: None
        """Set by what draws pictures: a QPixmap or None for a row of a pane."""
        self.panes = tuple(Pane(number, self._picture) for number in (0, 1))
        self.swatch, self.palette_panel, self.filters = SwatchPanel(), PalettePanel(), FiltersPanel()
        self._sections: dict[str, Section] = {}
        self._build_centre()
        self._build_library()
        self.add_section("swatch", tr("Swatch"), self.swatch)
        self.add_section("filters", tr("Filters"), self.filters, is_open=False)
        self.add_section("palette", tr("Palette or Group"), self.palette_panel, is_open=False)
        self._menus = {
            "file": self.file_menu,
            "edit": self.edit_menu,
            "view": self.view_menu,
            "paint": self.paint_menu,
            "window": self.window_menu,
            "help": self.help_menu,
        }
        self.recent_menu = QMenu(tr("Open &Recent"), self)
        self.recent_menu.setToolTipsVisible(True)
        cells = self.status
        self.count_cell = cells.cell(mark("Swatches"), tr("Swatches shown and selected"))
        self.picture_cell = cells.cell(mark("Pictures"), tr("Visible pictures still pending"))
        self.note_cell = cells.cell(mark("Note"), tr("Notes on the colours shown"), elastic=True)
        self.link_cell = cells.cell(mark("Link"), tr("Connected programs of the suite"), right=True)

    def _picture(self, pane: int, row: int) -> object:
        return self.picture_of(pane, row)

    # What a part of the program adds.

    def add_section(
        self, key: str, title: str, widget: QWidget, after: str | None = None, *, is_open: bool = True
    ) -> Section:
        """Add a section to the inspector: after the one of key ``after``, otherwise at the end."""
        section = Section(title, key, is_open=is_open)
        section.add(widget)
        self.inspector.add_section(section, after=self._sections[after] if after else None)
        self._sections[key] = section
        return section

    def section(self, key: str) -> Section:
        """Return the section of that key."""
        return self._sections[key]

    def add_dock(
        self,
        key: str,
        title: str,
        widget: QWidget,
        area: Qt.DockWidgetArea = Qt.DockWidgetArea.BottomDockWidgetArea,
    ) -> QDockWidget:
        """Add a hidden panel that docks and floats; listed in View ▸ Panels."""
        dock = self.add_panel(title, widget, area)
        dock.setObjectName(f"panel_{key}")
        dock.hide()
        return dock

    def add_command(
        self,
        menu: str,
        text: str,
        shortcut: Shortcut | None,
        slot: Callable[[], object],
        key: str,
        *,
        icon: str | None = None,
        tip: str = "",
    ) -> QAction:
        """Add a command to a menu by its name; its object name is ``action_`` and ``key``. Ctrl+K finds it."""
        action = self.add_action(self._menus[menu], text, slot, shortcut, icon, tip)
        action.setObjectName(f"action_{key}")
        return action

    def command(self, key: str) -> QAction | None:
        """Return the command of that key; ``None`` where no part has added it."""
        return self.findChild(QAction, f"action_{key}")

    def menu(self, key: str) -> QMenu:
        """Return a menu of the menu bar by its name."""
        return self._menus[key]

    def complete(self) -> None:
        """End the File menu, and take up size and panels of the last time; after all parts are there."""
        self.add_quit()
        self.restore_layout()

    # What is shown.

    def show_title(self, title: str, path: Path | None, *, clean: bool) -> None:
        """Show which palette the pane in front has, and whether it is saved."""
        self.setWindowTitle(f"{title}[*]" if title else "[*]")
        self.setWindowFilePath(str(path) if path is not None else "")
        self.setWindowModified(not clean)

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""
        self.messages.show_message(message)

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""
        self.messages.dismiss(key)

    def show_recent(self, paths: Sequence[Path]) -> None:
        """Fill File ▸ Open Recent."""
        self.recent_menu.clear()
        for number, path in enumerate(paths, 1):
            action = self.recent_menu.addAction(f"&{number % 10} {path.name}")
            action.setToolTip(plain_tip(str(path)))
            action.triggered.connect(lambda _=False, path=path: self.open_requested.emit(path))
        self.recent_menu.addSeparator()
        self.recent_menu.addAction(tr("&Clear"), self.recent_cleared.emit)
        self.recent_menu.setEnabled(bool(paths))

    @property
    def has_two_panes(self) -> bool:
        """Whether the second pane is shown."""
        return not self.panes[1].isHidden()

    def show_second(self, shown: bool) -> None:
        """Show the second pane, or one alone."""
        self.panes[1].setVisible(shown)
        if shown:
            half = max(1, self.pane_split.width() // 2)
            self.pane_split.setSizes([half, half])

    # How it is built.

    def _build_centre(self) -> None:
        self.pane_split = QSplitter(Qt.Orientation.Horizontal)
        self.pane_split.setObjectName("pane_split")
        self.pane_split.setHandleWidth(8)
        self.pane_split.setChildrenCollapsible(False)
        for pane in self.panes:
            self.pane_split.addWidget(pane)
        self.panes[1].hide()
        centre = QWidget()
        box = QVBoxLayout(centre)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(self.bar)
        box.addWidget(self.pane_split, 1)
        self.set_centre(centre)

    def _build_library(self) -> None:
        inside = QWidget()
        box = QVBoxLayout(inside)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        self.library_buttons = QHBoxLayout()
        self.library_buttons.setContentsMargins(8, 4, 8, 4)
        box.addLayout(self.library_buttons)
        box.addWidget(self.tree, 1)
        self.library_dock = self.add_panel(mark("Library"), inside, Qt.DockWidgetArea.LeftDockWidgetArea)
        self.tree.setMinimumWidth(168)

    def add_library_button(self, action: QAction) -> None:
        """Put a command over the library as a button."""
        button = QToolButton()
        button.setDefaultAction(action)
        button.setAutoRaise(True)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        button.setAccessibleName(action.text().replace("&", ""))
        self.library_buttons.addWidget(button)

    def fit_inspector(self) -> None:
        """Give the inspector what it wants, and the library a sixth of the window at most a fourth."""
        super().fit_inspector()
        wanted = max(160, min(240, round(0.18 * self.width())))
        self.resizeDocks([self.library_dock], [wanted], Qt.Orientation.Horizontal)

    # Drops on the window and its end.

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        for url in event.mimeData().urls():
            if url.isLocalFile():
                self.open_requested.emit(Path(url.toLocalFile()))

    def may_close(self) -> bool:
        """See :meth:`SuiteWindow.may_close`: the program answers through ``close_requested``."""
        question = QCloseEvent()
        self.close_requested.emit(question)
        return question.isAccepted()


def standard(key: QKeySequence.StandardKey) -> QKeySequence:
    """Return the platform's shortcut of a kind."""
    return QKeySequence(key)
