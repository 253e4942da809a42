"""The window: the view in three dimensions, the legend beside it, plots below, the inspector at the right."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import Shortcut, SuiteWindow
from brdf_qt.window.message_bar import Message
from brdf_qt.window.section import Section
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QDockWidget, QMenu, QSplitter, QVBoxLayout, QWidget

from brdf_lobe_visualizer.plot_row import PlotRow

_VIEW_WIDTH = 400


class LobeWindow(SuiteWindow):
    """The window of Lobe Visualizer; parts add to it by the ``add_`` methods and :meth:`set_centre`.

    Intents: ``open_requested(Path | None)``, a file or that one be asked for; ``dropped(list[Path])``;
    ``recent_cleared``; ``closing``, just before it closes.
    """

    open_requested = Signal(object)
    dropped = Signal(object)
    recent_cleared = Signal()
    closing = Signal()

    def __init__(self) -> None:
        super().__init__("Lobe Visualizer")
        self.setAcceptDrops(True)
        self.paint_menu.setTitle(tr("&Reflectance"))
        self._sections: dict[str, Section] = {}
        self.docks: dict[str, QDockWidget] = {}
        self._menus = {
            "file": self.file_menu,
            "edit": self.edit_menu,
            "view": self.view_menu,
            "reflectance": self.paint_menu,
            "window": self.window_menu,
            "help": self.help_menu,
        }
        self._build_centre()
        self._build_file_menu()

    # What a part adds.

    def set_centre(self, widget: QWidget, *, tab_hides_panels: bool = False) -> None:
        """Put the view in three dimensions into its place; with ``tab_hides_panels`` Tab on it toggles the panels."""
        before = self.top_split.replaceWidget(0, widget)
        if before is not None:
            before.deleteLater()
        self.top_split.setStretchFactor(0, 1)
        widget.show()
        if tab_hides_panels:
            shortcut = QShortcut(QKeySequence(Qt.Key.Key_Tab), widget)
            shortcut.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            shortcut.activated.connect(self.toggle_panels)

    def add_beside(self, widget: QWidget) -> None:
        """Put a widget at the right of the view: the legend."""
        self.top_split.addWidget(widget)
        self.top_split.setStretchFactor(self.top_split.count() - 1, 0)

    def add_plot(self, key: str, title: str, widget: QWidget) -> None:
        """Add a plot below the view, which its button shows or hides; ``title`` is translated already."""
        self.plots.add(key, title, widget)

    def add_section(
        self, key: str, title: str, widget: QWidget, after: str | None = None, *, is_open: bool = True
    ) -> Section:
        """Add a section to the inspector: after the one of key ``after``, otherwise at the end.

        ``is_open`` is how a first start shows it; later starts show it as the user left it.
        """
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
        *,
        visible: bool = False,
    ) -> QDockWidget:
        """Add a panel that docks, floats and hides; listed in View ▸ Panels. ``title``: English, marked."""
        dock = self.add_panel(title, widget, area)
        dock.setObjectName(f"panel_{key}")
        dock.setVisible(visible)
        self.docks[key] = dock
        return dock

    def add_command(
        self,
        menu: str,
        text: str,
        shortcut: Shortcut | None,
        slot: Callable[..., Any] | None,
        *,
        icon: str | None = None,
        tip: str = "",
        checked: bool | None = None,
    ) -> QAction:
        """Add a command to a menu: ``file``, ``edit``, ``view``, ``reflectance``, ``window`` or ``help``.

        ``text`` and ``tip`` are English, marked for translation; Ctrl+K finds the command by its text. With ``checked``
        it can be ticked, and ``slot`` is called with whether it is.
        """
        action = self.add_action(
            self._menus[menu], text, None if checked is not None else slot, shortcut, icon, tip
        )
        if checked is not None:
            action.setCheckable(True)
            action.setChecked(checked)
            if slot is not None:
                action.toggled.connect(slot)
        return action

    # Messages.

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""
        self.messages.show_message(message)

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""
        self.messages.dismiss(key)

    def complete(self) -> None:
        """Settle what depends on every part: size and place of the panels."""
        self._lay_out()
        self.restore_layout()

    def reset_layout(self) -> None:
        """Put panels, plots and their sizes back where a first start has them."""
        super().reset_layout()
        self.plots.reset()
        self._lay_out()

    def _lay_out(self) -> None:
        beside = [self.top_split.widget(place) for place in range(1, self.top_split.count())]
        widths = [widget.sizeHint().width() for widget in beside if widget is not None]
        self.top_split.setSizes([max(self.width() - sum(widths), _VIEW_WIDTH), *widths])
        self.centre_split.setSizes([3 * self.height() // 5, 2 * self.height() // 5])
        self.plots.even()

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

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        self.dropped.emit([Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()])

    def may_close(self) -> bool:
        """See :meth:`SuiteWindow.may_close`: nothing here is unsaved."""
        self.closing.emit()
        return True

    def _build_file_menu(self) -> None:
        keys = QKeySequence.StandardKey
        opened = self.add_action(
            self.file_menu, mark("&Open…"), lambda: self.open_requested.emit(None), keys.Open, "folder-open"
        )
        self.toolbar.addAction(opened)
        self.recent_menu = QMenu(tr("Open &Recent"), self.file_menu)
        self.recent_menu.setToolTipsVisible(True)
        self.file_menu.addMenu(self.recent_menu)

    def _build_centre(self) -> None:
        self.top_split = QSplitter(Qt.Orientation.Horizontal)
        self.top_split.setObjectName("top_split")
        self.top_split.setHandleWidth(8)
        self.top_split.setChildrenCollapsible(False)
        absent = PlainLabel(tr("No 3-D view"))
        absent.setAlignment(Qt.AlignmentFlag.AlignCenter)
        absent.setObjectName("no_view")
        self.top_split.addWidget(absent)
        self.plots = PlotRow()
        self.centre_split = QSplitter(Qt.Orientation.Vertical)
        self.centre_split.setObjectName("centre_split")
        self.centre_split.setHandleWidth(8)
        self.centre_split.setChildrenCollapsible(False)
        self.centre_split.addWidget(self.top_split)
        self.centre_split.addWidget(self.plots)
        self.centre_split.setStretchFactor(0, 3)
        self.centre_split.setStretchFactor(1, 2)
        centre = QWidget()
        box = QVBoxLayout(centre)
        box.setContentsMargins(8, 4, 8, 8)
        box.addWidget(self.centre_split)
        super().set_centre(centre)
