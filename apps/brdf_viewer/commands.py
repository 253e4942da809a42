"""The Viewer's commands: menus, toolbar and keys, found by Ctrl+K like all commands of the suite."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import SuiteWindow
from PySide6.QtCore import QObject, Qt, Signal, SignalInstance
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu

from brdf_viewer.camera.presets import PRESETS
from brdf_viewer.compare.section import MODE_TITLES
from brdf_viewer.fields.source_chooser import Source
from brdf_viewer.light.environment_section import BACKGROUND_TITLES
from brdf_viewer.paint.fresnel_section import FRESNEL_TITLES, LOOK_UP_TITLES
from brdf_viewer.paint.sparkle_section import SPARKLE_TITLES
from brdf_viewer.tone.section import TONE_TITLES
from brdf_viewer.traced.words import QUALITY_TITLES, RENDERER_TIPS, RENDERER_TITLES


class ViewerCommands(QObject):
    """Makes the actions in the window's menus; each ``*_requested`` signal is a command of the user.

    A kind is ``paint``, ``palette``, ``view``, ``environment`` or ``surface`` in ``open_requested`` and
    ``recent_requested``, and ``picture``, ``turntable`` or ``sheet`` in ``export_requested``. ``step_requested(step)``
    is 1 for the next paint, -1 for the one before. ``blink_requested`` starts or stops blinking, ``flip_requested``
    switches to the other paint by hand, ``freeze_requested`` keeps the current paint as the second one.
    """

    open_requested = Signal(str)
    recent_requested = Signal(str, str)
    paint_requested = Signal(str)
    designer_requested = Signal()
    preset_requested = Signal(str)
    frame_requested = Signal()
    tone_curve_requested = Signal(str)
    background_requested = Signal(str)
    fresnel_requested = Signal(str)
    look_up_requested = Signal(str)
    sparkle_requested = Signal(str)
    copy_requested = Signal()
    picture_requested = Signal()
    export_requested = Signal(str)
    source_requested = Signal(str, str)
    compare_requested = Signal(str)
    blink_requested = Signal()
    flip_requested = Signal()
    freeze_requested = Signal()
    step_requested = Signal(int)
    palette_close_requested = Signal()
    view_save_requested = Signal()
    view_save_as_requested = Signal()
    renderer_requested = Signal(str)
    quality_requested = Signal(str)
    trace_stop_requested = Signal()
    trace_resume_requested = Signal()
    trace_save_requested = Signal()
    undo_requested = Signal()
    redo_requested = Signal()

    def __init__(self, window: SuiteWindow) -> None:
        super().__init__(window)
        self._window = window
        self._add_file()
        self._add_view()
        self._add_paint()
        self.undo = window.add_action(
            window.edit_menu, mark("&Undo"), self.undo_requested.emit, QKeySequence.StandardKey.Undo
        )
        self.redo = window.add_action(
            window.edit_menu, mark("&Redo"), self.redo_requested.emit, QKeySequence.StandardKey.Redo
        )
        self.show_history("", "")
        window.edit_menu.addSeparator()
        window.add_action(
            window.edit_menu,
            mark("&Copy Picture"),
            self.copy_requested.emit,
            QKeySequence.StandardKey.Copy,
            "copy",
            mark("Copy the picture to the clipboard at full resolution"),
        )
        designer = window.add_action(
            window.window_menu, mark("Open &Designer"), self.designer_requested.emit, "Ctrl+D", "palette"
        )
        window.window_menu.insertAction(window.window_menu.actions()[0], designer)
        self._add_toolbar()

    def set_recent(self, kind: str, paths: Iterable[str]) -> None:
        """List the recent files of a kind in the File menu."""
        menu = self.recent_menus[kind]
        menu.clear()
        for path in paths:
            action = menu.addAction(path)
            action.setToolTip(plain_tip(path))
            action.triggered.connect(lambda _=False, path=path: self.recent_requested.emit(kind, path))
        menu.setEnabled(not menu.isEmpty())

    def set_paints(self, paints: Iterable[Source]) -> None:
        """List the shipped paints in the Paint menu."""
        for source in paints:
            self._window.add_action(
                self._paints, source.title, partial(self.paint_requested.emit, source.key)
            )

    def set_sources(self, kind: str, sources: Iterable[Source]) -> None:
        """List the shipped environments or surfaces in the View menu."""
        for source in sources:
            action = self._window.add_action(
                self._sources[kind],
                source.title,
                partial(self.source_requested.emit, kind, source.key),
            )
            action.setCheckable(True)
            action.setData(source.key)
            self._source_groups[kind].addAction(action)

    def show_history(self, undo: str, redo: str) -> None:
        """Say what Undo and Redo would do; empty where there is nothing to be done."""
        for action, word, step in ((self.undo, mark("&Undo"), undo), (self.redo, mark("&Redo"), redo)):
            action.setText(f"{tr(word)} {step}".strip())
            action.setEnabled(bool(step))

    def show_source(self, kind: str, key: str) -> None:
        """Tick the shipped environment or surface that is chosen; none where it is a file."""
        for action in self._source_groups[kind].actions():
            action.setChecked(action.data() == key)

    def show_state(self, *, tone_curve: str, background: str, fresnel: str, look_up: str) -> None:
        """Tick what the view has."""
        shown = (
            (self._tone, tone_curve),
            (self._background, background),
            (self._fresnel, fresnel),
            (self._look_up, look_up),
        )
        for group, key in shown:
            for action in group.actions():
                action.setChecked(action.data() == key)

    def _add_file(self) -> None:
        menu = self._window.file_menu
        self.open_paint = self._open(menu, mark("&Open Paint…"), "paint", QKeySequence.StandardKey.Open)
        self._open(menu, mark("Open &Environment…"), "environment", "Ctrl+Shift+E")
        self._open(menu, mark("Open &Surface…"), "surface", "Ctrl+M")
        self._open(menu, mark("Open Pa&lette…"), "palette", "Ctrl+Shift+L")
        self._open(menu, mark("Open &View…"), "view", "Ctrl+Shift+O")
        menu.addSeparator()
        add = self._window.add_action
        save = QKeySequence.StandardKey.Save
        add(
            menu,
            mark("&Save View"),
            self.view_save_requested.emit,
            save,
            "floppy-disk",
            mark("Camera, light and all settings"),
        )
        add(menu, mark("Save View &As…"), self.view_save_as_requested.emit, "Ctrl+Shift+S")
        menu.addSeparator()
        self._window.add_action(
            menu,
            mark("Save &Picture…"),
            self.picture_requested.emit,
            "Ctrl+E",
            "floppy-disk",
            mark("Save the picture as PNG at full resolution, with paint and settings as metadata"),
        )
        self._window.add_action(
            menu,
            mark("Save T&raced Picture…"),
            self.trace_save_requested.emit,
            "Ctrl+Shift+R",
            "floppy-disk",
            mark("Save the traced picture as EXR with the variance of each pixel"),
        )
        for text, kind, keys, tip in (
            (
                mark("E&xport Picture…"),
                "picture",
                "Ctrl+Shift+X",
                mark("A picture of any size, as PNG or EXR"),
            ),
            (
                mark("Export &Turntable…"),
                "turntable",
                None,
                mark("One turn of the object, as a video or a folder of pictures"),
            ),
            (
                mark("Export &Contact Sheet…"),
                "sheet",
                None,
                mark("All paints of a palette or a folder in this light"),
            ),
        ):
            self._window.add_action(
                menu, text, partial(self.export_requested.emit, kind), keys, "export", tip
            )
        menu.addSeparator()
        self.studio = menu.addMenu(tr("S&tudio"))
        menu.addSeparator()
        self.recent_menus = {
            kind: menu.addMenu(tr(title))
            for kind, title in (
                ("paint", mark("Recent &Paints")),
                ("palette", mark("Recent Pale&ttes")),
                ("view", mark("Recent Vie&ws")),
                ("environment", mark("Recent E&nvironments")),
                ("surface", mark("Recent S&urfaces")),
            )
        }
        self._window.add_quit()

    def _open(self, menu: QMenu, text: str, kind: str, keys: str | QKeySequence.StandardKey) -> QAction:
        return self._window.add_action(
            menu, text, lambda: self.open_requested.emit(kind), keys, "folder-open"
        )

    def _add_view(self) -> None:
        menu = self._window.view_menu
        menu.addSeparator()
        self.presets = [
            self._window.add_action(
                menu,
                f"View: {title}",
                partial(self.preset_requested.emit, key),
                str(index + 1),
                tip=tr("View: {view}, framing the surface").format(view=tr(title)),
            )
            for index, (key, (title, _, _)) in enumerate(PRESETS.items())
        ]
        for action, (title, _, _) in zip(self.presets, PRESETS.values(), strict=True):
            action.setText(tr("View: {view}").format(view=tr(title)))
        self.frame = self._window.add_action(
            menu,
            mark("&Frame Surface"),
            self.frame_requested.emit,
            "F",
            "frame-corners",
            mark("Fill the picture with the surface"),
        )
        self.turntable = self._window.add_action(
            menu,
            mark("&Turntable"),
            None,
            "Space",
            "arrows-clockwise",
            mark("Rotate the surface in front of camera and light"),
        )
        self.turntable.setCheckable(True)
        # Space presses a button that has the focus; it is the turntable's on the picture only.
        self.turntable.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        self.on_picture = [self.turntable]
        menu.addSeparator()
        self._sources = {
            "environment": menu.addMenu(tr("&Environment")),
            "surface": menu.addMenu(tr("S&urface")),
        }
        self._source_groups = {kind: QActionGroup(submenu) for kind, submenu in self._sources.items()}
        for group in self._source_groups.values():
            # A file of the user's is none of them, and a choice that fails goes back.
            group.setExclusionPolicy(QActionGroup.ExclusionPolicy.ExclusiveOptional)
        self._add_renderers()
        self._tone = self._choices(menu.addMenu(tr("T&one Curve")), TONE_TITLES, self.tone_curve_requested)
        self._background = self._choices(
            menu.addMenu(tr("&Background")), BACKGROUND_TITLES, self.background_requested
        )
        self._add_compare()
        self.figures = self._window.add_action(
            menu,
            mark("Figures over the &Picture"),
            None,
            "H",
            tip=mark("Frame time, lobes, tone curve and readout"),
        )
        self.figures.setCheckable(True)
        self._fresnel = self._choices(menu.addMenu(tr("Fres&nel")), FRESNEL_TITLES, self.fresnel_requested)
        self._look_up = self._choices(menu.addMenu(tr("&Look-up")), LOOK_UP_TITLES, self.look_up_requested)
        self._sparkle = self._choices(menu.addMenu(tr("Spar&kle")), SPARKLE_TITLES, self.sparkle_requested)

    def _add_renderers(self) -> None:
        menu = self._window.view_menu.addMenu(tr("&Renderer"))
        titles = {key: tr(title) for key, title in RENDERER_TITLES.items()}
        self._renderers = self._choices(menu, titles, self.renderer_requested)
        for number, action in enumerate(self._renderers.actions(), 1):
            action.setShortcut(QKeySequence(f"Ctrl+{number}"))
            action.setToolTip(plain_tip(tr(RENDERER_TIPS[action.data()]) + f" (Ctrl+{number})"))
        menu.addSeparator()
        qualities = {
            key: tr("Ray-traced: {quality}").format(quality=tr(QUALITY_TITLES[key])) for key in QUALITY_TITLES
        }
        self._qualities = self._choices(menu, qualities, self.quality_requested)
        menu.addSeparator()
        add = self._window.add_action
        add(
            menu,
            mark("&Stop Refining"),
            self.trace_stop_requested.emit,
            "Ctrl+.",
            tip=mark("Keep the picture as it is"),
        )
        add(menu, mark("&Resume Refining"), self.trace_resume_requested.emit, "Ctrl+Shift+.")

    def show_renderer(self, renderer: str, quality: str) -> None:
        """Tick which renderer makes the picture, and the ray tracer's quality where it is that."""
        for action in self._renderers.actions():
            action.setChecked(action.data() == renderer)
        for action in self._qualities.actions():
            action.setChecked(action.data() == quality and renderer == "raytraced")

    def _add_compare(self) -> None:
        menu = self._window.view_menu.addMenu(tr("&Compare"))
        self._compare = self._choices(menu, MODE_TITLES, self.compare_requested)
        menu.addSeparator()
        self._window.add_action(
            menu,
            mark("Start or Stop &Blinking"),
            self.blink_requested.emit,
            "B",
            tip=mark("Alternate between A and B; again to return to the previous mode"),
        )
        self._window.add_action(
            menu,
            mark("&Switch and Stay"),
            self.flip_requested.emit,
            "Shift+B",
            tip=mark("Switch between A and B manually"),
        )
        self._window.add_action(
            menu,
            mark("&Freeze A as B"),
            self.freeze_requested.emit,
            "Ctrl+B",
            tip=mark("Keep the current paint as B"),
        )

    def show_sparkle(self, mode: str) -> None:
        """Tick how flakes are drawn."""
        for action in self._sparkle.actions():
            action.setChecked(action.data() == mode)

    def show_compare(self, mode: str) -> None:
        """Tick how two paints are compared."""
        for action in self._compare.actions():
            action.setChecked(action.data() == mode)

    def _choices(self, menu: QMenu, titles: dict[str, str], signal: SignalInstance) -> QActionGroup:
        group = QActionGroup(menu)
        for key, title in titles.items():
            action = self._window.add_action(menu, title, partial(signal.emit, key))
            action.setCheckable(True)
            action.setData(key)
            group.addAction(action)
        return group

    def _add_paint(self) -> None:
        menu = self._window.paint_menu
        self.follow = self._window.add_action(
            menu,
            mark("&Follow Designer"),
            None,
            "Ctrl+L",
            "link",
            mark("Show the paint that is being edited in Designer"),
        )
        self.follow.setCheckable(True)
        menu.addSeparator()
        for text, step, key in ((mark("&Next Paint"), 1, "Right"), (mark("&Previous Paint"), -1, "Left")):
            action = self._window.add_action(
                menu,
                text,
                partial(self.step_requested.emit, step),
                key,
                tip=mark("In the open palette or the shipped paints"),
            )
            # Arrows move in lists and numbers; they are the paints' on the picture only.
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            self.on_picture.append(action)
        self.palette_close = self._window.add_action(
            menu, mark("&Close Palette"), self.palette_close_requested.emit
        )
        menu.addSeparator()
        self._paints = menu.addMenu(tr("Open &Shipped Paint"))

    def _add_toolbar(self) -> None:
        bar = self._window.toolbar
        bar.addAction(self.open_paint)
        bar.addAction(self.follow)
        bar.addSeparator()
        for action, (title, _, _) in zip(self.presets, PRESETS.values(), strict=True):
            action.setIconText(tr(title))
            bar.addAction(action)
        bar.addAction(self.frame)
        self.frame.setIconText(tr("Frame"))
        bar.addSeparator()
        bar.addAction(self.turntable)
