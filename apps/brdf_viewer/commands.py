"""The Viewer's commands: menus, toolbar and keys, found by Ctrl+K like all commands of the suite."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial

from brdf_qt.choosing.sources import Source
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.shortcuts import give_keys
from brdf_qt.window.view_titles import BACKGROUND_TITLES, PRESETS, TONE_TITLES
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu

from brdf_suite.foreign_text import make_visible
from brdf_viewer.compare.section import MODE_TITLES
from brdf_viewer.tracing.section import QUALITY_TITLES, RENDERER_TIPS, RENDERER_TITLES

_OPENED = (
    ("paint", mark("&Open Paint…"), "open"),
    ("environment", mark("Open &Environment…"), "open_environment"),
    ("surface", mark("Open &Surface…"), "open_surface"),
    ("palette", mark("Open Pa&lette…"), "open_palette"),
    ("view", mark("Open &View…"), "open_view"),
)
_TURN = mark("One turn of the object, as a video or a folder of pictures")
_EXPORTS = {
    "picture": (mark("Export &Picture…"), mark("A picture of any size, as PNG or EXR")),
    "turntable": (mark("Export &Turntable…"), _TURN),
    "sheet": (mark("Export &Contact Sheet…"), mark("All paints of a palette or a folder in this light")),
}
_TRACED = mark("Save the traced picture as EXR with the variance of each pixel")
NO_TRACED = mark("There is no traced picture yet: choose Ray-traced or Path-traced in the tab Export")
_RENDERERS = ("real_time", "ray_traced", "path_traced")
_RECENT = {
    "paint": mark("Recent &Paints"),
    "palette": mark("Recent Pale&ttes"),
    "view": mark("Recent Vie&ws"),
    "environment": mark("Recent E&nvironments"),
    "surface": mark("Recent S&urfaces"),
}


class ChoiceGroup(QActionGroup):
    """Choices of a menu; ``picked(key)`` when the user takes one, as of a :class:`ChoiceBox`."""

    picked = Signal(str)

    def __init__(self, window: SuiteWindow, menu: QMenu, titles: Mapping[str, str] | None = None) -> None:
        super().__init__(menu)
        self._window, self._menu = window, menu
        self.add(titles or {})

    def add(self, titles: Mapping[str, str]) -> None:
        """Add choices by their keys."""
        for key, title in titles.items():
            action = self._window.add_action(self._menu, title, partial(self.picked.emit, key))
            action.setCheckable(True)
            action.setData(key)
            self.addAction(action)

    def show_choice(self, key: str) -> None:
        """Tick the present choice; none where the key is of no choice."""
        for action in self.actions():
            action.setChecked(action.data() == key)


class ViewerCommands(QObject):
    """Makes the actions in the window's menus; features connect them.

    Signals
    -------
    open_requested(kind), recent_requested(kind, path)
        Of a ``paint``, ``palette``, ``view``, ``environment`` or ``surface``.
    export_requested(kind)
        ``picture``, ``turntable``, ``sheet``; empty: as last time.
    paint_requested(name), preset_requested(key)
        A shipped paint; a side to look from.
    step_requested(step)
        1 for the next paint, -1 for the one before.
    """

    open_requested = Signal(str)
    recent_requested = Signal(str, str)
    export_requested = Signal(str)
    paint_requested = Signal(str)
    preset_requested = Signal(str)
    step_requested = Signal(int)

    def __init__(self, window: SuiteWindow) -> None:
        super().__init__(window)
        self._window, self._add = window, window.add_action
        self._add_file()
        self._add_view()
        self._add_paint()
        self.undo = self._add(window.edit_menu, mark("&Undo"), None, "undo", "arrow-counter-clockwise")
        self.redo = self._add(window.edit_menu, mark("&Redo"), None, "redo", "arrow-clockwise")
        self.show_history("", "")
        window.edit_menu.addSeparator()
        tip = mark("Copy the picture to the clipboard at full resolution")
        self.copy = self._add(window.edit_menu, mark("&Copy Picture"), None, "copy", "copy", tip)
        window.toolbar.addActions([self.open_paint, self.follow])
        window.toolbar.addSeparator()
        window.toolbar.addActions([self.undo, self.redo])
        # Their texts name the step; in the toolbar, that would move what is beside them.
        self.undo.setIconText(tr("Undo"))
        self.redo.setIconText(tr("Redo"))
        window.toolbar.addSeparator()
        window.toolbar.addActions([self.frame, self.turntable])
        self.frame.setIconText(tr("Frame"))
        window.toolbar.addSeparator()
        window.toolbar.addAction(self.export)

    def set_recent(self, kind: str, paths: Iterable[str]) -> None:
        """List the recent files of a kind in the File menu."""
        menu = self.recent_menus[kind]
        menu.clear()
        for path in paths:
            action = menu.addAction(make_visible(path).replace("&", "&&"))
            action.setToolTip(plain_tip(path))
            action.triggered.connect(lambda _=False, path=path: self.recent_requested.emit(kind, path))
        menu.setEnabled(not menu.isEmpty())

    def set_paints(self, paints: Iterable[Source]) -> None:
        for source in paints:
            self._add(self._paints, source.title, partial(self.paint_requested.emit, source.key))

    def show_history(self, undo: str, redo: str) -> None:
        """Say what Undo and Redo would do; empty where there is nothing to be done."""
        for action, word, step in ((self.undo, mark("&Undo"), undo), (self.redo, mark("&Redo"), redo)):
            action.setText(f"{tr(word)} {make_visible(step)}".strip())
            action.setEnabled(bool(step))

    def _add_file(self) -> None:
        menu, add = self._window.file_menu, self._add
        opened = [
            add(menu, text, partial(self.open_requested.emit, kind), keys, "folder-open")
            for kind, text, keys in _OPENED
        ]
        self.open_paint = opened[0]
        menu.addSeparator()
        tip = mark("Camera, light and all settings")
        self.save_view = add(menu, mark("&Save View"), None, "save", "floppy-disk", tip)
        self.save_view_as = add(menu, mark("Save View &As…"), None, "save_as")
        menu.addSeparator()
        tip = mark("A picture, a turntable or a contact sheet, with a preview")
        self.export = add(
            menu, mark("E&xport…"), partial(self.export_requested.emit, ""), "export", "export", tip
        )
        kinds = menu.addMenu(tr("Export &As"))
        kinds.setToolTipsVisible(True)
        for kind, (text, tip) in _EXPORTS.items():
            add(kinds, text, partial(self.export_requested.emit, kind), tip=tip)
        kinds.addSeparator()
        tip = mark("Save the picture as PNG at full resolution, with paint and settings as metadata")
        self.save_picture = add(kinds, mark("&Save Picture…"), None, "save_picture", "floppy-disk", tip)
        self.save_traced = add(
            kinds, mark("Save T&raced Picture…"), None, "save_traced", "floppy-disk", _TRACED
        )
        menu.addSeparator()
        self.studio = menu.addMenu(tr("S&tudio"))
        menu.addSeparator()
        self.recent_menus = {kind: menu.addMenu(tr(title)) for kind, title in _RECENT.items()}
        self._window.add_quit()

    def _add_view(self) -> None:
        window, menu, add = self._window, self._window.view_menu, self._add
        menu.addSeparator()
        self.presets: list[QAction] = []
        for number, (key, (title, _, _)) in enumerate(PRESETS.items(), 1):
            tip = tr("View: {view}, framing the surface").format(view=tr(title))
            look = partial(self.preset_requested.emit, key)
            action = add(menu, f"View: {title}", look, f"preset_{number}", tip=tip)
            action.setText(tr("View: {view}").format(view=tr(title)))
            action.setIconText(tr(title))
            self.presets.append(action)
        tip = mark("Fill the picture with the surface")
        self.frame = add(menu, mark("&Frame Surface"), None, "frame", "frame-corners", tip)
        tip = mark("Rotate the surface in front of camera and light")
        self.turntable = add(menu, mark("&Turntable"), None, "play", "arrows-clockwise", tip)
        self.turntable.setCheckable(True)
        # Space presses a button that has the focus; it is the turntable's on the picture only.
        self.turntable.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        self.on_picture = [self.turntable]
        menu.addSeparator()
        self.sources = {
            "environment": ChoiceGroup(window, menu.addMenu(tr("&Environment"))),
            "surface": ChoiceGroup(window, menu.addMenu(tr("S&urface"))),
        }
        for group in self.sources.values():
            # A file of the user's is none of them, and a choice that fails goes back.
            group.setExclusionPolicy(QActionGroup.ExclusionPolicy.ExclusiveOptional)
        self._add_renderers(menu.addMenu(tr("&Renderer")))
        self.tone = ChoiceGroup(window, menu.addMenu(tr("T&one Curve")), TONE_TITLES)
        self.background = ChoiceGroup(window, menu.addMenu(tr("&Background")), BACKGROUND_TITLES)
        self._add_compare(menu.addMenu(tr("&Compare")))
        tip = mark("Frame time, lobes, tone curve and readout")
        self.figures = add(menu, mark("Figures over the &Picture"), None, "figures", tip=tip)
        self.figures.setCheckable(True)
        window.add_tabs_menu()

    def offer_traced(self, there: bool) -> None:
        """Offer to save the traced picture where there is one; the tip says why not."""
        self.save_traced.setEnabled(there)
        self.save_traced.setToolTip(plain_tip(tr(_TRACED if there else NO_TRACED)))

    def _add_renderers(self, menu: QMenu) -> None:
        self.renderer = ChoiceGroup(self._window, menu, RENDERER_TITLES)
        for name, action in zip(_RENDERERS, self.renderer.actions(), strict=True):
            give_keys(action, name)
            action.setToolTip(
                plain_tip(f"{tr(RENDERER_TIPS[action.data()])} ({action.shortcut().toString()})")
            )
        menu.addSeparator()
        text = tr("Ray-traced: {quality}")
        titles = {key: text.format(quality=tr(title)) for key, title in QUALITY_TITLES.items()}
        self.quality = ChoiceGroup(self._window, menu, titles)
        menu.addSeparator()
        tip = mark("Keep the picture as it is")
        self.stop_refining = self._add(menu, mark("&Stop Refining"), None, "stop_refining", tip=tip)
        self.resume_refining = self._add(menu, mark("&Resume Refining"), None, "resume_refining")

    def _add_compare(self, menu: QMenu) -> None:
        self.compare = ChoiceGroup(self._window, menu, MODE_TITLES)
        menu.addSeparator()
        tip = mark("Alternate between A and B; again to return to the previous mode")
        self.blink = self._add(menu, mark("Start or Stop &Blinking"), None, "blink", tip=tip)
        tip = mark("Switch between A and B manually")
        self.flip = self._add(menu, mark("&Switch and Stay"), None, "flip", tip=tip)
        tip = mark("Keep the current paint as B")
        self.freeze = self._add(menu, mark("&Freeze A as B"), None, "freeze", tip=tip)

    def _add_paint(self) -> None:
        menu, add = self._window.paint_menu, self._add
        tip = mark("Show the paint that is being edited in Designer")
        self.follow = add(menu, mark("&Follow Designer"), None, "follow", "link", tip)
        self.follow.setCheckable(True)
        menu.addSeparator()
        tip = mark("In the open palette or the shipped paints")
        for text, step, key in (
            (mark("&Next Paint"), 1, "next_paint"),
            (mark("&Previous Paint"), -1, "previous_paint"),
        ):
            action = add(menu, text, partial(self.step_requested.emit, step), key, tip=tip)
            # Arrows move in lists and numbers; they are the paints' on the picture only.
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            self.on_picture.append(action)
        self.palette_close = add(menu, mark("&Close Palette"))
        menu.addSeparator()
        self._paints = menu.addMenu(tr("Open &Shipped Paint"))
