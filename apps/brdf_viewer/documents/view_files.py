"""Views as files: opened as a step that can be undone, saved with everything that the Viewer sets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from brdf_qt.documents.recent_files import RecentFiles, folder_beside
from brdf_qt.documents.stamp import FileStamp, is_changed, stamp_of
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import Overwrite, QtDialogs
from brdf_qt.window.message_bar import Message
from brdf_qt.work.tasks import TaskRunner

from brdf_suite.documents.store import VIEW_ENDING, load_view, save_view
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress
from brdf_suite.realtime.camera import resolve
from brdf_viewer.documents.file_kinds import with_ending
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

KIND = "view"
_READERS = 4
_MESSAGE_MS = 6000


class ViewFiles(ViewerFeature):
    """File ▸ Open View, Save View, Save View As; what is open is never asked about: Undo brings it back."""

    def __init__(self, state: ViewerState, window: ViewerWindow, dialogs: QtDialogs) -> None:
        super().__init__(state, window)
        self._dialogs = dialogs
        # Its own: a disk that hangs keeps no light waiting, and a view that was given up none after it.
        self._runner = TaskRunner(self, threads=_READERS)
        self._is_reading = False
        window.busy_cancelled.connect(self._cancel)
        self._recent = RecentFiles(f"recent/{KIND}")
        window.commands.save_view.triggered.connect(self.save)
        window.commands.save_view_as.triggered.connect(self.save_as)
        self._list()

    @property
    def path(self) -> Path | None:
        """The file that Save writes to; None before the first one."""
        return self._state.history.path

    @property
    def is_idle(self) -> bool:
        return not self._is_reading

    def open(self, path: str, adapt: Callable[[View], View] | None = None) -> None:
        """Read the view in a file on a thread, and show it; Save then writes to that file.

        With ``adapt`` what that makes of the view is shown, which has no file.
        """
        file = Path(path).absolute()

        def done(found: tuple[View, FileStamp | None]) -> None:
            self._is_reading = False
            if adapt is None:
                self.show(found[0])
                self._take(file, found[1])
            else:
                self.show(adapt(found[0]))

        def failed(error: Exception) -> None:
            self._is_reading = False
            self._report(error, KIND, tr("The picture is unchanged. Choose another view."))

        self._is_reading = True
        self._window.set_busy(KIND, 0.0, file.name)
        self._run(self._runner, KIND, _read, file, done, failed)

    def close(self) -> None:
        self._runner.stop()

    def _cancel(self, kind: str) -> None:
        if kind == KIND and self._is_reading:
            self._is_reading = False
            self._runner.cancel(KIND)
            self._window.set_idle(KIND)

    def show(self, view: View) -> None:
        """Show a view, one step of the history; the file that Save writes to stays."""
        history = self._state.history
        history.end()
        history.set(view)
        history.end()
        self._window.keep_opened()

    def save(self) -> bool:
        """Write the view to its file, or ask for one; True where it was written."""
        if self.path is None:
            return self.save_as()
        if is_changed(self.path, self._state.history.stamp):
            answer = self._dialogs.changed_file(self.path)
            if answer is not Overwrite.OVERWRITE:
                return answer is Overwrite.SAVE_AS and self.save_as()
        return self._write(self.path)

    def save_as(self) -> bool:
        """Ask for a file and write the view to it; True where it was written."""
        suggested = self.path or folder_beside(None, self._recent.paths()) / f"view{VIEW_ENDING}"
        filters = tr("View") + f" (*{VIEW_ENDING});;" + tr("All files (*)")
        path = self._dialogs.save_path(suggested, filters)
        return path is not None and self._write(with_ending(path, VIEW_ENDING).absolute())

    def _write(self, path: Path) -> bool:
        try:
            save_view(self.seen(), path)
        except SuiteError as error:
            self._report(error, KIND, tr("Choose another name or folder."))
            return False
        self._take(path, stamp_of(path))
        self._window.status.showMessage(tr("Saved: {path}").format(path=path.name), _MESSAGE_MS)
        if self._state.edited_light:
            what = tr("{file} refers to the light without its unsaved edits.").format(file=path.name)
            todo = tr("Save the studio, then the view again.")
            self._window.messages.show_message(Message(KIND, what, todo=todo, severity="warning"))
        return True

    def seen(self) -> View:
        """Return the view with its camera where it stands: a picture of it elsewhere is framed as it is here."""
        state, view = self._state, self._state.view
        if state.surface is None:
            return view
        return replace(view, camera=resolve(view.camera, state.bounds, self._window.picture.device_size))

    def _take(self, path: Path, stamp: FileStamp | None) -> None:
        self._state.history.mark_clean(path, stamp)
        self._window.messages.dismiss(KIND)
        self._recent.add(str(path))
        self._list()

    def _list(self) -> None:
        self._window.commands.set_recent(KIND, self._recent.paths())


def _read(file: Path, progress: Progress) -> tuple[View, FileStamp | None]:
    progress(0.0, file.name)
    stamp = stamp_of(file)
    return load_view(file), stamp
