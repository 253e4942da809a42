"""The window that every program of the suite has: menus, messages, inspector, status line, command search.

A program adds its centre widget, its sections and its commands. Nothing here knows a document.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QMimeData, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QAction,
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QPaintEvent,
    QShortcut,
)
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QMainWindow, QMenu, QToolBar, QWidget

from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.application import error_relay
from brdf_qt.program.diagnostics import diagnostics
from brdf_qt.program.icons import icon as icon_of
from brdf_qt.program.settings import settings
from brdf_qt.program.suite import MEMBERS, start_member
from brdf_qt.program.theme import theme_menu
from brdf_qt.program.translation import language_menu, mark, tr
from brdf_qt.start.control import StartControl
from brdf_qt.start.tour import TourStep
from brdf_qt.window.command_palette import CommandPalette
from brdf_qt.window.help_windows import AboutWindow, ShortcutsWindow
from brdf_qt.window.manual import Manual
from brdf_qt.window.message_bar import Message, MessageBar
from brdf_qt.window.placement import halves
from brdf_qt.window.progress_strip import ProgressStrip
from brdf_qt.window.section import Section
from brdf_qt.window.settings_window import SettingsWindow
from brdf_qt.window.shortcuts import give_keys, sequences
from brdf_qt.window.status_line import StatusLine
from brdf_qt.window.tab_panel import Page, Tab, TabPanel
from brdf_suite.foreign_text import make_visible

LAYOUT_VERSION = 1
_SIGNS = {"qt_dockwidget_floatbutton": "arrow-square-out", "qt_dockwidget_closebutton": "x"}


class Panel(QDockWidget):
    """A dock with the icons of the suite: those of the style are one brownish grey in every theme."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(title, parent)
        # The style's come back with every change of what may be done with the panel.
        self.featuresChanged.connect(lambda _features: self._draw_signs())
        self.topLevelChanged.connect(lambda _floats: self._draw_signs())
        self._draw_signs()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.StyleChange, QEvent.Type.PaletteChange):
            self._draw_signs()

    def _draw_signs(self) -> None:
        for button in self.findChildren(QAbstractButton):
            name = _SIGNS.get(button.objectName())
            if name is not None and button.parent() is self:
                button.setIcon(icon_of(name))


class SuiteWindow(QMainWindow):
    """Menus File, Edit, View, Paint, Window, Help; call :meth:`restore_layout` at the end of ``__init__``.

    A feature adds to it with :meth:`add_section`, :meth:`add_dock` and :meth:`add_command`.

    Signals
    -------
    first_painted()
        The window was painted for the first time.
    open_requested(Path | None)
        A file is to be opened, None: the user is to be asked for one.
    files_dropped(list[Path])
        Files were dropped on the window.
    recent_cleared()
        The recent files are to be forgotten.
    close_requested(QCloseEvent)
        The window is about to close; to be ignored where it must stay.
    shipped_requested(str)
        A shipped paint is to be opened, by its name; a program that opens none leaves it to Designer.
    """

    first_painted = Signal()
    open_requested = Signal(object)
    files_dropped = Signal(list)
    recent_cleared = Signal()
    close_requested = Signal(QCloseEvent)
    shipped_requested = Signal(str)
    opens_paints = False
    """Whether ``shipped_requested`` is answered; otherwise Designer is opened with the paint."""
    takes_several_files = True
    """Whether more than one file at a time can be dropped."""

    def __init__(self, name: str, parent: QWidget | None = None, tabs: Sequence[Tab] = ()) -> None:
        super().__init__(parent)
        self.setObjectName(f"{name}Window")
        self.setMinimumSize(720, 520)
        room = self.screen().availableSize()
        self.resize(min(1440, round(0.9 * room.width())), min(900, round(0.9 * room.height())))
        self._program = name
        self._painted = False
        self._put_away: list[QDockWidget] = []
        self._sections: dict[str, Section] = {}
        self.docks: dict[str, QDockWidget] = {}
        self.openers: dict[str, QAction] = {}
        self.settings_window: SettingsWindow | None = None
        self.manual: Manual | None = None
        self.start = StartControl(self, name, self.tour_steps)
        self.start.paint_requested.connect(self._open_paint)
        self.start.file_requested.connect(lambda path: self.files_dropped.emit([path]))
        self.start.command_requested.connect(self._do_or_hand_on)
        self._file_end: QAction | None = None
        self.setAcceptDrops(True)
        titles = (tr("&File"), tr("&Edit"), tr("&View"), tr("&Paint"), tr("&Window"), tr("&Help"))
        menus = [self.menuBar().addMenu(title) for title in titles]
        self.file_menu, self.edit_menu, self.view_menu, self.paint_menu, self.window_menu, self.help_menu = (
            menus
        )
        self.menus = dict(zip(("file", "edit", "view", "paint", "window", "help"), menus, strict=True))
        self.toolbar = QToolBar(tr("Toolbar"), movable=False, iconSize=QSize(18, 18))
        self.toolbar.setObjectName("toolbar")
        self.toolbar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.addToolBar(self.toolbar)
        self.status = StatusLine()
        self.setStatusBar(self.status)
        self.messages = MessageBar()
        self.progress = ProgressStrip()
        self._inside = QWidget()
        self._column = fill_column(self._inside, spacing=0)
        self.setCentralWidget(self._inside)
        self.float_over(self._inside)
        self.panels_menu = QMenu(tr("&Panels"), self)
        self.panel = TabPanel(tabs)
        self.inspector_dock = self.add_panel(mark("Inspector"), self.panel)
        error_relay().reported.connect(self.messages.show_message)
        self._add_common_commands()

    def add_action(
        self,
        menu: QMenu,
        text: str,
        slot: Callable[[], object] | None = None,
        shortcut: str | None = None,
        icon: str | None = None,
        tip: str = "",
    ) -> QAction:
        """Add a command to ``menu``; its object name is ``action_`` and the text without ``&`` and dots.

        ``text`` and ``tip`` are English, marked for translation; ``shortcut`` is a command of
        :data:`~brdf_qt.window.shortcuts.SHORTCUTS`.
        """
        shown = tr(text)
        action = QAction(shown, self)
        action.setObjectName(f"action_{_plain(text)}")
        plain = tr(tip) if tip else _plain(shown)
        if icon:
            action.setIcon(icon_of(icon))
        if shortcut is not None:
            give_keys(action, shortcut)
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(plain_tip(f"{plain} ({keys})" if keys else plain))
        action.setStatusTip("")
        if slot is not None:
            action.triggered.connect(lambda _checked=False: slot())
        menu.addAction(action)
        return action

    def add_panel(
        self, title: str, widget: QWidget, area: Qt.DockWidgetArea = Qt.DockWidgetArea.RightDockWidgetArea
    ) -> QDockWidget:
        """Add a panel that docks, floats, hides and is remembered; listed in View ▸ Panels.

        ``title`` is English, marked for translation.
        """
        dock = Panel(tr(title), self)
        dock.setObjectName(f"panel_{title}")
        dock.setWidget(widget)
        self.addDockWidget(area, dock)
        self.panels_menu.addAction(dock.toggleViewAction())
        return dock

    # What a feature adds.

    @property
    def inspector(self) -> Page:
        """The page of the panel that is in front; the only one of a window without tabs."""
        return self.panel.page

    def add_section(
        self,
        key: str,
        title: str,
        widget: QWidget,
        after: str | None = None,
        *,
        tab: str = "",
        more: bool = False,
        is_open: bool = True,
    ) -> Section:
        """Add a section to the panel: after the one of key ``after``, otherwise at the end.

        ``tab`` is the key of its tab where there are several; with ``more`` it goes into the tab's fold.
        ``is_open`` is how a first start shows it; later starts show it as the user left it.
        """
        section = Section(title, key, is_open=is_open)
        section.add(widget)
        page = self.panel.pages[tab] if tab else self.panel.page
        add = page.add_more if more else page.add_section
        add(section, after=self._sections[after] if after else None)
        self._sections[key] = section
        return section

    def section(self, key: str) -> Section:
        return self._sections[key]

    def show_section(self, key: str) -> None:
        """Show the panel with a section in sight, open."""
        self.inspector_dock.show()
        self.panel.bring_in_sight(self._sections[key])

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

    def add_strip(self, strip: QWidget) -> QDockWidget:
        """Put ``strip`` below the middle, as high as it is and without a title; Tab hides it with the panels."""
        dock = self.add_dock("strip", mark("Paint Strip"), strip, visible=True)
        dock.setFeatures(QDockWidget.DockWidgetFeature.DockWidgetClosable)
        dock.setTitleBarWidget(QWidget())
        self.setCorner(Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea)
        give_keys(dock.toggleViewAction(), "paint_strip")
        return dock

    def add_command(
        self,
        menu: str,
        text: str,
        shortcut: str | None,
        slot: Callable[..., object] | None,
        key: str = "",
        *,
        icon: str | None = None,
        tip: str = "",
        checked: bool | None = None,
    ) -> QAction:
        """Add a command to a menu, one of the keys of ``menus``; Ctrl+K finds it by its text. Quit stays last in File.

        ``text`` and ``tip`` are English, marked for translation; ``shortcut`` is a command of the table of keys, which
        need not be ``key``. ``key`` is its object name after ``action_``, the
        text where none is given. With ``checked`` it can be ticked, and ``slot`` is called with whether it is.
        """
        action = self.add_action(
            self.menus[menu], text, None if checked is not None else slot, shortcut, icon, tip
        )
        if key:
            action.setObjectName(f"action_{key}")
        if checked is not None:
            action.setCheckable(True)
            action.setChecked(checked)
            if slot is not None:
                action.toggled.connect(slot)
        if menu == "file" and self._file_end is not None:
            self.file_menu.removeAction(action)
            self.file_menu.insertAction(self._file_end, action)
        return action

    def command(self, key: str) -> QAction | None:
        """Return the command of that key, None where there is none."""
        return self.findChild(QAction, f"action_{key}")

    def add_recent_menu(self) -> None:
        """Add File ▸ Open Recent at the end of the File menu; :meth:`show_recent` fills it."""
        self.recent_menu = self.file_menu.addMenu(tr("Open &Recent"))
        self.recent_menu.setToolTipsVisible(True)

    def add_tabs_menu(self) -> None:
        """Add View ▸ Panel Tabs, with a command for each tab of the panel."""
        menu = self.view_menu.addMenu(tr("Panel &Tabs"))
        for number, tab in enumerate(self.panel.tabs, 1):
            show = self.add_action(
                menu, tab.title, partial(self.show_tab, tab.key), f"panel_{number}", tab.icon, tab.tip
            )
            show.setObjectName(f"action_tab_{tab.key}")

    def tour_steps(self) -> list[TourStep]:
        """Return what a tour points at; a window without any has no tour."""
        return []

    # What is shown.

    def show_tab(self, key: str) -> None:
        """Bring a tab of the panel to the front, with the keyboard in it."""
        self.inspector_dock.show()
        self.panel.show_page(key)
        self.panel.buttons[key].setFocus(Qt.FocusReason.ShortcutFocusReason)

    def show_recent(self, paths: Sequence[Path]) -> None:
        self.recent_menu.clear()
        for number, path in enumerate(paths, 1):
            action = self.recent_menu.addAction(
                f"&{number % 10} {make_visible(path.name).replace('&', '&&')}"
            )
            action.setToolTip(plain_tip(str(path)))
            action.triggered.connect(lambda _=False, path=path: self.open_requested.emit(path))
        self.recent_menu.addSeparator()
        self.recent_menu.addAction(tr("&Clear"), self.recent_cleared.emit)
        self.recent_menu.setEnabled(bool(paths))

    def show_message(self, message: Message) -> None:
        if message.key == "recovery":
            self.start.hide()  # unsaved work goes first
        self.messages.show_message(message)

    def dismiss_message(self, key: str) -> None:
        self.messages.dismiss(key)

    def set_centre(self, widget: QWidget, *, tab_hides_panels: bool = False) -> None:
        """Let ``widget`` take the middle; with ``tab_hides_panels`` Tab on it toggles the panels."""
        self._column.addWidget(widget, 1)
        if tab_hides_panels:
            shortcut = QShortcut(sequences("panels_of_picture")[0], widget)
            shortcut.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            shortcut.activated.connect(self.toggle_panels)

    def float_over(self, below: QWidget, bar: QWidget | None = None) -> None:
        """Let messages and progress lie over ``below``, a widget in the middle: by default over all of it.

        They leave a ``bar`` along its upper edge in sight.
        """
        for part in (self.messages, self.progress):
            part.float_over(below, self._inside, bar)

    def toggle_panels(self) -> None:
        """Hide every panel, or show again those that were hidden so."""
        shown = [dock for dock in self.findChildren(QDockWidget) if not dock.isHidden()]
        for dock in shown or self._put_away or [self.inspector_dock]:
            dock.setVisible(not shown)
        self._put_away = shown

    def may_close(self) -> bool:
        """Return whether the window may close now; a program answers through ``close_requested``."""
        question = QCloseEvent()
        self.close_requested.emit(question)
        return question.isAccepted()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        count = len(_local_files(event.mimeData()))
        if count == 1 or (count and self.takes_several_files):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        self.files_dropped.emit(_local_files(event.mimeData()))

    def restore_layout(self) -> None:
        """Take up the size, place and panels of the last time."""
        self._default_state = self.saveState(LAYOUT_VERSION)
        self.fit_inspector()
        store = settings()
        geometry, state = store.value("window/geometry"), store.value("window/state")
        if geometry is not None:
            self.restoreGeometry(geometry)
        if state is not None:
            self.restoreState(state, LAYOUT_VERSION)

    def fit_inspector(self) -> None:
        """Give the inspector what its fields want, but not more than a good third of a small window."""
        wanted = min(self.panel.sizeHint().width(), round(0.38 * self.width()))
        self.resizeDocks([self.inspector_dock], [wanted], Qt.Orientation.Horizontal)

    def reset_layout(self) -> None:
        """Put the panels back where a first start has them."""
        self.restoreState(self._default_state, LAYOUT_VERSION)

    def _add_common_commands(self) -> None:
        self.view_menu.addMenu(theme_menu(self.view_menu))
        self.view_menu.addMenu(language_menu(self.view_menu))
        self.view_menu.addMenu(self.panels_menu)
        for role, member in MEMBERS.items():
            if member.name != self._program:
                text = tr("Open {program}").format(program=member.name)
                beside = partial(self.open_beside, role)
                action = self.add_action(self.window_menu, text, beside, f"open_{role}", member.icon)
                action.setObjectName(f"action_open_{role}")
                self.openers[role] = action
        self.window_menu.addSeparator()
        self.add_action(self.view_menu, mark("Show or Hide P&anels"), self.toggle_panels, "panels")
        self.palette_window = palette = CommandPalette(self)
        add, menu = self.add_action, self.help_menu
        add(self.view_menu, mark("Se&ttings…"), self._show_settings, "settings", "gear-six")
        add(menu, mark("&Manual"), self._show_manual, "manual", "book-open").setObjectName("action_manual")
        add(menu, mark("Start &Page"), self.start.show, icon="squares-four").setObjectName(
            "action_start_page"
        )
        add(menu, mark("&Tour"), self.start.start_tour, icon="map-trifold").setObjectName("action_tour")
        add(menu, mark("Find a &Command…"), palette.open, "find_command", "magnifying-glass")
        add(menu, mark("Keyboard &Shortcuts"), lambda: ShortcutsWindow(self).show(), "shortcuts", "keyboard")
        add(menu, mark("Copy &Diagnostics"), self._copy_diagnostics, icon="clipboard-text").setObjectName(
            "action_copy_diagnostics"
        )
        add(menu, mark("&About BRDF Suite"), lambda: AboutWindow(self, self._program).show(), icon="info")
        add(self.window_menu, mark("&Reset Layout"), self.reset_layout, icon="layout")
        add(self.window_menu, mark("Full &Screen"), self._toggle_full_screen, "full_screen", "corners-out")

    def _copy_diagnostics(self) -> None:
        QGuiApplication.clipboard().setText(diagnostics(self._program))
        text = tr("Versions, OpenGL, settings and the log were copied, without names and contents of files.")
        self.show_message(Message("diagnostics", text))

    def add_quit(self) -> None:
        """End the File menu with Quit; call after the program's own File commands."""
        self._file_end = self.file_menu.addSeparator()
        self.add_action(self.file_menu, mark("&Quit"), self.close, "quit", "sign-out")

    def _show_settings(self) -> None:
        if self.settings_window is None:
            self.settings_window = SettingsWindow(self)
        self.settings_window.show_choices()
        self.settings_window.show()
        self.settings_window.raise_()

    def _show_manual(self) -> None:
        if self.manual is None:
            self.manual = Manual(self, self._program.lower().replace(" ", "_"))
        self.manual.show()
        self.manual.raise_()

    def _open_paint(self, name: str) -> None:
        """Open a shipped paint here, or in Designer where this program designs none."""
        if self.opens_paints:
            self.shipped_requested.emit(name)
        else:
            self.open_beside("designer", name)

    def _do_or_hand_on(self, key: str) -> None:
        """Do a command of this window, or of Designer where this one has none of that key."""
        command = self.command(key)
        if command is not None:
            command.trigger()
        else:
            self.open_beside("designer", f"--do={key}")

    def open_beside(self, role: str, *arguments: str) -> None:
        """Open another program of the suite: this window takes the left half of the screen, that one the right.

        ``arguments`` are those of its command line.

        On a screen too narrow for both, this window stays, and the other one keeps out of its way.
        """
        shares = (
            None if self.isFullScreen() else halves(self.screen().availableGeometry(), self.minimumSize())
        )
        beside = None
        if shares is not None:
            self.showNormal()
            frame, inside = self.frameGeometry(), self.geometry()
            ours, beside = (
                share.adjusted(
                    inside.left() - frame.left(),
                    inside.top() - frame.top(),
                    inside.right() - frame.right(),
                    inside.bottom() - frame.bottom(),
                )
                for share in shares
            )
            self.setGeometry(ours)
        if start_member(role, beside, *arguments):
            self.dismiss_message("start")
            return
        member = MEMBERS[role]
        what = tr("{program} could not be started.").format(program=member.name)
        todo = tr("Start it from a terminal: {command}.").format(command=member.command)
        self.show_message(Message("start", what, todo=todo, severity="error"))

    def _toggle_full_screen(self) -> None:
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Let Escape, which nothing else has taken, leave the full screen."""
        if event.key() == Qt.Key.Key_Escape and self.isFullScreen():
            self._toggle_full_screen()
            return
        super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._painted:
            self._painted = True
            QTimer.singleShot(0, self, self.first_painted.emit)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.may_close():
            event.ignore()
            return
        store = settings()
        store.setValue("window/geometry", self.saveGeometry())
        store.setValue("window/state", self.saveState(LAYOUT_VERSION))
        store.sync()
        event.accept()


def _local_files(data: QMimeData) -> list[Path]:
    return [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]


def _plain(text: str) -> str:
    return text.replace("&", "").replace("…", "").strip()
