"""Exports from the menu to the file: asked for, run beside the Viewer, followed, cancelled."""

from __future__ import annotations

import dataclasses
from pathlib import Path

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lens
from brdf_suite.errors import SuiteError
from brdf_suite.realtime.camera import frame, resolve
from brdf_viewer.commands import NO_TRACED
from brdf_viewer.documents.file_kinds import AskTarget, ask_open, ask_target, file_name, with_ending
from brdf_viewer.export.dialog import ExportDialog
from brdf_viewer.export.job import ExportJob, ExportProcess, ExportSettings
from brdf_viewer.export.preview import image_of
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

KIND = "export"
_MESSAGE_MS = 8000


def ask_source(parent: QWidget) -> str:
    """Ask for a palette, or for a folder by any paint in it; empty where the user gives none."""
    forms = tr("Palettes") + f" (*{PALETTE_ENDING});;" + tr("A paint: all paints of its folder (*.brdfpaint)")
    path = ask_open(parent, tr("Paints of the Sheet"), forms, "palette")
    return path if not path or path.lower().endswith(PALETTE_ENDING) else str(Path(path).parent)


class ExportControl(ViewerFeature):
    """File ▸ Export: the dialog, then one export at a time."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        self.ask: AskTarget = ask_target
        self.process: ExportProcess | None = None
        self._given_up = False
        self.dialog = ExportDialog(lambda: window.picture.device_size, ask_source, window)
        commands = window.commands
        self.dialog.export_requested.connect(self.export)
        self.dialog.cancel_requested.connect(lambda: self._cancelled_by_user(KIND))
        saves = {"screen": commands.save_picture, "traced": commands.save_traced}
        self.dialog.save_requested.connect(lambda kind: saves[kind].trigger())
        self.dialog.preview.wanted.connect(self._preview)
        for signal in (state.view_changed, state.contents_changed, state.traced_changed):
            signal.connect(self.dialog.preview.refresh)
        state.traced_changed.connect(self._offer_traced)
        commands.export_requested.connect(self._open)
        window.export.export.clicked.connect(lambda: self._open(""))
        window.export.copy.clicked.connect(commands.copy.trigger)
        self._offer_traced()
        window.busy_cancelled.connect(self._cancelled_by_user)

    @property
    def running(self) -> bool:
        return self.process is not None

    def _open(self, kind: str) -> None:
        self.dialog.set_lens(self._state.view.lens)
        self.dialog.open_for(kind)

    def _offer_traced(self) -> None:
        self.dialog.offer_traced("" if self._state.traced is not None else tr(NO_TRACED))

    def _preview(self) -> None:
        """Draw what the export will show, in the size of the preview."""
        drawer, dialog, picture = self._window.drawer, self.dialog, self._window.picture
        if drawer is None or not drawer.is_complete:
            return
        if dialog.chosen in ("screen", "traced"):
            dialog.preview.show_image(picture.grab_image())
            return
        view = self._view(dialog.chosen, dialog.lens_chosen)
        size = dialog.preview.size_of(dialog.size_chosen)
        clear = dialog.transparent.isChecked()

        def draw() -> None:
            drawer.scene_renderer.prepare(view)
            dialog.preview.show_image(image_of(drawer.renderer.render_image(view, size, transparent=clear)))

        picture.with_context(draw, redraw=False)

    def export(self, wanted: ExportSettings) -> None:
        """Ask for the file and begin; errors are reported in the window."""
        if self.running:
            return
        fit = self._state.fit
        if fit is None or self._state.surface is None or not self._state.is_complete:
            todo = tr("Wait until paint, surface and environment are loaded, then export.")
            self._refuse(KIND, tr("There is no picture yet."), todo)
            return
        if self._state.edited_light:
            todo = tr("Save it with File ▸ Studio ▸ Save Studio, then export.")
            what = tr("The light has unsaved changes, which an export would not include.")
            self._refuse(KIND, what, todo)
            return
        # As it is when the user asks: the paint may change while the dialog is open.
        view, paint, key = self._view(wanted.kind, wanted.lens), self._state.paint, self._state.paint_key
        stem = Path(wanted.source).stem if wanted.kind == "sheet" else fit.name
        name = file_name(stem, wanted.kind)
        chosen = self.ask(self.dialog, name, wanted.form.title, wanted.form.ending)
        if not chosen:
            return
        if wanted.kind != "sheet" and wanted.lens != self._state.view.lens:
            self._state.change_part("lens", **dataclasses.asdict(wanted.lens))
        path = with_ending(Path(chosen), wanted.form.ending)
        self._window.messages.dismiss(KIND)
        try:
            job = ExportJob(wanted, path, view, paint, key, self._state.fit_words)
        except (SuiteError, OSError) as error:
            self._report(error, KIND)
            return
        self.process = process = ExportProcess(job, self)
        process.moved.connect(lambda fraction, what: self._show(fraction, f"{path.name}: {what}"))
        process.done.connect(lambda notes: self._done(path, notes))
        process.failed.connect(self._failed)
        process.cancelled.connect(lambda: self._end(tr("Export of {file} cancelled").format(file=path.name)))
        self._given_up = False
        self._show(0.0, tr("{file}: starting").format(file=path.name))
        self.dialog.set_busy(True)
        process.start()

    def close(self) -> None:
        if self.process is not None:
            self.process.stop()

    def _view(self, kind: str, lens: Lens) -> View:
        view = self._state.exposed_view
        camera = view.camera
        if kind == "picture":
            camera = resolve(camera, self._state.bounds, self._window.picture.device_size)
        elif kind == "sheet":
            camera = frame(camera)
        return dataclasses.replace(view, camera=camera, lens=view.lens if kind == "sheet" else lens)

    def _show(self, fraction: float, what: str) -> None:
        if self.process is not None and not self._given_up:
            self._window.set_busy(KIND, fraction, what)

    def _cancelled_by_user(self, kind: str) -> None:
        if kind == KIND and self.process is not None:
            self._given_up = True
            self._window.set_idle(KIND)
            self.process.cancel()

    def _done(self, path: Path, notes: list[str]) -> None:
        missed = [note.removeprefix("not drawn: ") for note in notes if note.startswith("not drawn: ")]
        if missed:
            what = tr("{file} was exported without {count} of its paints.")
            what = what.format(file=path.name, count=len(missed))
            message = Message(KIND, what, where="; ".join(map(tr_core, missed[:5])), severity="warning")
            self._window.messages.show_message(message)
        self._end(tr("{name} exported.").format(name=path.name))

    def _failed(self, text: str) -> None:
        self._window.messages.show_message(Message(KIND, text, severity="error"))
        self._end("")

    def _end(self, text: str) -> None:
        if self.process is not None:
            self.process.deleteLater()
            self.process = None
        self._window.set_idle(KIND)
        self.dialog.set_busy(False)
        if text:
            self._window.status.showMessage(text, _MESSAGE_MS)
