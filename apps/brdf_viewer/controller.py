"""Puts state, window, link and background work together: the Viewer without its command line."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path

from brdf_qt.documents.project_files import ProjectFiles
from brdf_qt.documents.projects import is_project
from brdf_qt.link.link import LiveLink
from brdf_qt.program.names import title_of
from brdf_qt.program.program import Program
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.fit_choice import FitCommand
from brdf_qt.window.message_bar import Message
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QGuiApplication

from brdf_suite.documents.store import view_to_json
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.foreign_text import make_visible
from brdf_suite.realtime.gl.context import Context
from brdf_viewer.camera.control import CameraControl
from brdf_viewer.compare.control import KIND, CompareControl
from brdf_viewer.documents.file_kinds import (
    ENDINGS,
    AskFile,
    AskPicture,
    ask_file,
    ask_picture,
    ask_target,
    kind_of,
)
from brdf_viewer.documents.project_part import ViewerProject
from brdf_viewer.documents.recovery import ViewRecovery
from brdf_viewer.documents.remembered import remember
from brdf_viewer.documents.view_files import ViewFiles
from brdf_viewer.export.control import ExportControl
from brdf_viewer.export.picture import PictureExport
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.control import LightingControl
from brdf_viewer.light.lamp_handles import LampControl
from brdf_viewer.light.studio.control import StudioControl
from brdf_viewer.overlay.part_control import PartControl
from brdf_viewer.overlay.part_drops import PartDrops
from brdf_viewer.overlay.readout import FiguresOverlay, FrameMeter, Readout
from brdf_viewer.overlay.seen_parts import SeenParts
from brdf_viewer.paint.control import PaintControl
from brdf_viewer.paint.sparkle_control import SparkleControl
from brdf_viewer.scene.control import SceneControl
from brdf_viewer.scene.drawing import SceneDrawer
from brdf_viewer.scene.standing_question import StandingQuestion
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.surface.control import SurfaceControl
from brdf_viewer.surface.relief_control import IMAGES, ReliefControl
from brdf_viewer.tone.control import ToneControl
from brdf_viewer.tracing.control import TracedControl
from brdf_viewer.window import ViewerWindow

_PUBLISH_MS = 50


_REST_MS = 180
"""After the last step of a movement the picture is drawn whole; longer than between two steps of a hand."""


def _moves(old: View, new: View) -> bool:
    """Whether two views differ as the steps of a movement do."""
    return (old.camera, old.rotation_deg, old.lamps) != (new.camera, new.rotation_deg, new.lamps)


class ViewerController(Program):
    """The running Viewer.

    Parameters
    ----------
    view
        What is shown first.
    paint
        Name or file of the paint that is shown first.
    follow
        Whether it is shown only until Designer has one; otherwise it stays, and Designer is offered.
    ask, ask_picture
        How the user is asked for a file to open, and for one to save the picture to.

    Signals: ``picture_complete()`` once, after the first frame with paint, surface and environment;
    ``picture_finished()`` once, after the first such frame that nothing on its way, as occlusion, will change;
    ``settled()`` each time that a frame's time has been measured and is shown;
    ``failed(kind, text)`` where something could not be loaded.
    """

    picture_complete = Signal()
    picture_finished = Signal()
    settled = Signal()
    failed = Signal(str, str)
    patience_s = math.inf  # a path tracer may be asked for any number of samples
    is_complete_when_started = False
    window: ViewerWindow

    def __init__(
        self,
        view: View,
        paint: str,
        *,
        follow: bool = True,
        ask: AskFile = ask_file,
        ask_picture: AskPicture = ask_picture,
        dialogs: QtDialogs | None = None,
    ) -> None:
        super().__init__(ViewerWindow(self._make_drawer))
        self.state = ViewerState(view, self)
        note = tr("Takes effect in Viewer and Designer at their next start, in Lobe Visualizer at once.")
        self.fit = FitCommand(self.window, note)
        self.state.fitting, self.state.fit_words = self.fit.settings, self.fit.choice.words()
        self.link = LiveLink("viewer", parent=self)
        self._tasks = TaskRunner(self)
        self._ask = ask
        self._complete = self._finished = self._settled = self._started = False
        self._publish = make_timer(self, self._publish_view, _PUBLISH_MS)
        self._at_rest = make_timer(self, self._rest, _REST_MS)
        dialogs = dialogs or QtDialogs(self.window)
        parts = self.state, self.window
        self.camera = CameraControl(*parts)
        self.scene = SceneControl(*parts, self._tasks)
        self.paint = PaintControl(*parts, self.link, paint, follow=follow)
        self.surface = SurfaceControl(*parts, self.scene)
        self.relief = ReliefControl(*parts, ask)
        self.seen = SeenParts(*parts)
        self.parts = PartControl(*parts, self.surface, self.seen)
        self.standing = StandingQuestion(*parts)
        self.drops = PartDrops(*parts, self.seen, self.parts, self.surface, self.paint)
        self._meter = FrameMeter(self.window.status.cell("frame"), self)
        self._meter.shown.connect(self._settle)
        self.tone = ToneControl(*parts)
        self.save = PictureExport(*parts, ask_picture, self.tone.grab_srgb)
        self.export = ExportControl(*parts)
        self.views = ViewFiles(*parts, dialogs)
        self.studio = StudioControl(*parts, self.scene, dialogs)
        self.recovered = ViewRecovery(*parts, self.paint, self.studio, self.views)
        self.lighting = LightingControl(*parts)
        self.lamps = LampControl(*parts, self.seen)
        self.parts.highlight_wanted.connect(self.lamps.handles.put)
        self.sparkle = SparkleControl(*parts)
        self.traced = TracedControl(*parts, self._tasks, ask_target)
        self.compare = CompareControl(*parts, self._tasks, ask)
        self.readout = Readout(*parts)
        self.figures = FiguresOverlay(*parts, self._meter, self.readout)
        part = ViewerProject(*parts, self.paint, self.scene, self.views)
        self.projects = ProjectFiles(self.window, part, dialogs)
        own = self.window.findChildren(ViewerFeature)
        self.features = [*own, self.projects, self.link, self.window.thumbnails]
        self.fit.add_to_menu()
        self._connect()
        self._show_view(None, view)
        self.start()
        self._publish.start()

    @property
    def is_idle(self) -> bool:
        """Whether the picture is loaded, the time of its frame shown, and no trace pending."""
        return self._settled and self._is_loaded and self.traced.is_settled

    @property
    def _is_loaded(self) -> bool:
        """Whether nothing that the picture shows is pending."""
        return super().is_idle and not (self.drawer and self.drawer.awaits_weights)

    @property
    def drawer(self) -> SceneDrawer | None:
        """What draws at present; None while nothing does."""
        return self.window.drawer

    def start(self) -> None:
        """Begin to load, and join the link; a new controller does so by itself, and only the first call acts."""
        if not self._started:
            self._started = True
            super().start()

    def open_file(self, path: str) -> None:
        """Open a file of any kind that the Viewer knows."""
        if is_project(path):
            self.projects.open(Path(path))
            return
        kind = kind_of(path)
        if kind is None:
            known = ", ".join(ending for endings in ENDINGS.values() for ending in endings)
            what = tr("Viewer opens files that end in {endings}.").format(endings=known)
            todo = tr("Drop one of these.")
            message = Message("dropped", what, where=path, todo=todo, severity="error")
            self.window.messages.show_message(message)
        else:
            self._open(kind, path)

    def _open_files(self, paths: list[Path]) -> None:
        for path in paths:
            self.open_file(str(path))

    def _open(self, kind: str, path: str) -> None:
        if kind == "paint":
            self.paint.open(path)
        elif kind == "palette":
            self.paint.open_palette(path)
        elif kind == "view":
            self.views.open(path)
        else:
            self.scene.open(kind, path)

    def _connect(self) -> None:
        window, state = self.window, self.state
        state.view_changed.connect(self._show_view)
        state.contents_changed.connect(window.picture.redraw)
        state.contents_changed.connect(self._show_title)
        self.scene.failed.connect(self.failed)
        window.picture.frame_drawn.connect(self._frame_drawn)
        window.picture.about_to_grab.connect(self._draw_whole)
        window.picture.failed.connect(self._picture_failed)
        window.files_dropped.connect(self._open_files)
        window.closing.connect(self.close)
        self.picture_complete.connect(lambda: self.reached.emit("complete"))
        self.picture_finished.connect(lambda: self.reached.emit("finished"))
        self.failed.connect(self._end_start)
        self.picture_complete.connect(window.thumbnails.begin)
        window.strip.second_taken.connect(lambda key: self.compare.toggle(self.paint.name_of(key)))
        environment, commands = window.environment, window.commands
        for field, signal in (
            ("rotation_deg", environment.rotation.edited),
            ("exposure_ev", environment.exposure.edited),
            ("background", environment.background.picked),
            ("background", commands.background.picked),
            ("background_colour", environment.background_colour.edited),
            ("fresnel", window.fresnel.mode.picked),
            ("look_up", window.fresnel.look_up.picked),
        ):
            signal.connect(lambda value, field=field: state.change_view(**{field: value}))
        for kind in ("environment", "surface", "paint"):
            chooser = getattr(window, kind).chooser
            chooser.browse_requested.connect(lambda kind=kind: self._browse(kind))
        window.strip.palette_requested.connect(lambda: self._browse("palette"))
        commands.open_requested.connect(self._browse)
        commands.recent_requested.connect(self._open)
        commands.copy.triggered.connect(self._copy_picture)
        commands.undo.triggered.connect(self.undo)
        commands.redo.triggered.connect(self._redo)
        state.history.history_changed.connect(self._show_history)

    def _make_drawer(self, context: Context) -> SceneDrawer:
        drawer = SceneDrawer(context, self.state, self.window.surround, self._refused)
        drawer.renderer.screen = self.tone.display
        if self._finished:  # in place of a context that was lost
            QTimer.singleShot(0, self, self._prepare_edits)
        return drawer

    def _refused(self, kind: str, error: SuiteError) -> None:
        """Reported later: the message changes the window, and this comes from within a paint of it."""
        own = {KIND: self.compare.refused, IMAGES: self.relief.refused}
        show = own.get(kind) or partial(self.scene.refused, kind)
        QTimer.singleShot(0, self, lambda: show(error))

    def _rest(self) -> None:
        """Draw whole frames again after a movement."""
        self._at_rest.stop()
        if self.drawer is not None and self.drawer.pace.rest():
            self.window.picture.redraw()

    def _draw_whole(self) -> None:
        self._rest()
        if self.drawer is not None:
            self.drawer.pace.want_whole()

    def _show_view(self, old: View | None, new: View) -> None:
        window, commands = self.window, self.window.commands
        if old is not None and self.drawer is not None and _moves(old, new):
            self.drawer.pace.move()
            self._at_rest.start()
        window.picture.set_view(new)
        window.environment.rotation.set_value(new.rotation_deg)
        window.environment.exposure.set_value(new.exposure_ev)
        window.environment.set_background(new.background, new.background_colour)
        commands.background.show_choice(new.background)
        window.fresnel.mode.show_choice(new.fresnel)
        window.fresnel.look_up.show_choice(new.look_up)
        if not self._publish.isActive():
            self._publish.start()

    def _show_title(self) -> None:
        """Name what is on show, for the task bar and for a screenshot."""
        state = self.state
        names = [] if state.fit is None else [state.fit.name]
        assets = (state.surface, state.environment)
        names += [title_of(asset.key) for asset in assets if asset is not None]
        self.window.setWindowTitle(make_visible(", ".join(names)))

    def _publish_view(self) -> None:
        self.link.publish("view", view_to_json(self.state.view))

    def _frame_drawn(self, milliseconds: float, typical: bool) -> None:
        if not self.state.is_complete:
            return
        if typical:
            self._meter.add(milliseconds)
            if self.drawer is not None:
                self.drawer.pace.end_frame(milliseconds)
        else:
            self.window.picture.redraw()  # the next one is an ordinary frame, whose time can be shown
        if not self._complete and self.drawer is not None and self.drawer.is_complete:
            self._complete = True
            self.picture_complete.emit()
        if self._complete and not self._finished and self._is_loaded:
            self._finished = True
            self.picture_finished.emit()
            QTimer.singleShot(0, self, self._prepare_edits)

    def _prepare_edits(self) -> None:
        if self.drawer is not None:
            self.window.picture.with_context(self.drawer.prepare_edits)

    def _settle(self) -> None:
        """A frame's time is shown: the picture has settled, unless a part of it is still on its way."""
        if self._is_loaded:
            self._settled = True
            self.settled.emit()

    def _end_start(self, kind: str, text: str) -> None:
        if kind == "picture" or not self.state.is_complete:
            self.start_failed.emit(text)

    def _picture_failed(self, text: str) -> None:
        self._meter.clear()
        self.failed.emit("picture", text)

    def _browse(self, kind: str) -> None:
        path = self._ask(self.window, kind)
        if path:
            self._open(kind, path)

    def _copy_picture(self) -> None:
        image = self.tone.grab_srgb()
        if not image.isNull():
            QGuiApplication.clipboard().setImage(image)

    def undo(self) -> None:
        """Stop the turntable and undo the last step of the view."""
        self.camera.turntable.set_running(False)
        self.state.history.undo()

    def _redo(self) -> None:
        self.camera.turntable.set_running(False)
        self.state.history.redo()

    def _show_history(self) -> None:
        history = self.state.history
        self.window.commands.show_history(history.undo_text, history.redo_text)

    def close(self) -> None:
        """Remember the view, leave the link and end what runs; only the first call acts."""
        if self.closed:
            return
        super().close()
        remember(settings(), self.state.view)
        self.window.picture.release()
