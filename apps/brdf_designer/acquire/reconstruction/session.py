"""The session that is open and what was found of it, for every part of the assistant; and its work on threads.

What hangs on something that has changed is forgotten: another number of the rig takes the geometry and the table
with it, another mask the table. A frozen request goes to a thread and an answer comes back.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.window.progress_strip import ProgressStrip
from brdf_qt.work.tasks import TaskRunner, Work
from PySide6.QtCore import QObject, Signal

from brdf_designer.acquire.window import AcquireWindow
from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.session.session import Session

WORK_FILE = "reconstruction.work"
"""What is done of a reconstruction is kept under this name in the session's folder."""
ORDER = ("response", "geometry", "mask", "table", "fit")
_AFTER = {
    "response": ("geometry", "table", "fit"),
    "geometry": ("table", "fit"),
    "mask": ("table", "fit"),
    "table": ("fit",),
    "fit": (),
}


@dataclass(frozen=True)
class StepRequest:
    """What a thread needs to take the road up: the folder, the choices, and what was found before.

    ``response`` is a :class:`brdf_designer.acquire.states.Found`, ``geometry`` a calibration with its
    geometry; None where a step was not taken.
    """

    folder: Path
    options: AcquireOptions
    response: Any = None
    geometry: Any = None


class ReconstructionSession(QObject):
    """The state of the assistant.

    Signals
    -------
    opened()
        Another session is open, or none.
    edited()
        The open session has other values.
    found(str)
        Something of :data:`ORDER` was found, or is forgotten: :attr:`results` says which.
    busy_changed(str, bool)
        Work of that key has begun, or ended.
    ended(str, bool)
        Work of that key has ended; whether it has done what it was asked for.
    """

    opened = Signal()
    edited = Signal()
    found = Signal(str)
    busy_changed = Signal(str, bool)
    ended = Signal(str, bool)

    def __init__(
        self, window: AcquireWindow, elsewhere: ProgressStrip, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.window, self._elsewhere = window, elsewhere
        self.folder: Path | None = None
        self.session: Session | None = None
        self.options = AcquireOptions()
        self.results: dict[str, Any] = {}
        # The road is long and takes all cores: one at a time. Pictures come beside it.
        self._road, self._beside = TaskRunner(self, threads=1), TaskRunner(self, threads=1)
        self._running: dict[str, tuple[TaskRunner, float, str]] = {}
        window.hidden.connect(self._move_progress)
        window.brought.connect(self._move_progress)

    # What is open.

    def open(self, folder: Path | None, session: Session | None) -> None:
        """Make this the session."""
        self.stop_all()
        self.folder, self.session = folder, session
        self.results.clear()
        self.opened.emit()
        for key in ORDER:
            self.found.emit(key)

    def edit(self, session: Session, *, forget: str | None) -> None:
        """Take other values of the session; ``forget`` names what no longer holds, with all after it."""
        self.session = session
        if forget is not None:
            self.invalidate(forget)
        self.edited.emit()

    def keep(self, key: str, value: Any) -> None:
        """Keep what was found; what hangs on it is forgotten."""
        for later in _AFTER[key]:
            self._drop(later)
        self.results[key] = value
        self.found.emit(key)

    def invalidate(self, key: str) -> None:
        """Forget what was found, and what hangs on it."""
        for later in (key, *_AFTER[key]):
            self._drop(later)

    def _drop(self, key: str) -> None:
        self.cancel(key)
        if self.results.pop(key, None) is not None:
            self.found.emit(key)

    def request(self) -> StepRequest:
        """Return what the road starts from."""
        assert self.folder is not None
        geometry = self.results.get("geometry")
        return StepRequest(
            self.folder,
            self.options,
            self.results.get("response"),
            None if geometry is None else geometry.found,
        )

    # Work.

    def is_busy(self, key: str) -> bool:
        """Whether work of that key runs or waits."""
        return key in self._running

    @property
    def is_quiet(self) -> bool:
        """Whether nothing runs."""
        return not self._running

    def run(
        self,
        key: str,
        work: Work,
        request: Any,
        done: Callable[[Any], None],
        *,
        beside: bool = False,
        todo: str = "",
        moved: Callable[[float, str], None] | None = None,
        shown: bool = True,
        failed: Callable[[Exception], None] | None = None,
    ) -> None:
        """Run work on a thread; ``beside`` the road, and ``shown`` as progress with a button to cancel.

        An error becomes a message with ``todo``, or is handed to ``failed``.
        """
        runner = self._beside if beside else self._road
        self._running[key] = (runner, 0.0, "") if shown else (runner, -1.0, "")
        self.window.messages.dismiss(key)

        def report(fraction: float, what: str) -> None:
            if shown:
                self._running[key] = (runner, fraction, what)
                self._strip.set_job(key, fraction, what, lambda: self.cancel(key))
            if moved is not None:
                moved(fraction, what)

        def answered(answer: Any) -> None:
            self._end(key)
            done(answer)
            self.ended.emit(key, True)

        def refused(error: Exception) -> None:
            self._end(key)
            if failed is not None:
                failed(error)
            else:
                self.say(message_of(error, key, todo=todo))
            self.ended.emit(key, False)

        self.busy_changed.emit(key, True)
        runner.submit(key, work, request, answered, refused, report)

    def cancel(self, key: str) -> None:
        """Stop work of that key; nothing where none runs."""
        if key in self._running:
            self._running[key][0].cancel(key)
            self._end(key)
            self.ended.emit(key, False)

    def stop_all(self) -> None:
        """Stop everything."""
        for key in tuple(self._running):
            self.cancel(key)

    def close(self) -> None:
        """Stop everything, and wait for the threads."""
        self.stop_all()
        for runner in (self._road, self._beside):
            runner.stop()

    def say(self, message: Message) -> None:
        """Show a message in the window of the assistant."""
        self.window.messages.show_message(message)

    def _end(self, key: str) -> None:
        self._running.pop(key, None)
        for strip in (self.window.progress, self._elsewhere):
            strip.end_job(key)
        self.busy_changed.emit(key, False)

    @property
    def _strip(self) -> ProgressStrip:
        """Where progress is shown: in the assistant, or in Designer while that is closed."""
        return self.window.progress if self.window.isVisible() else self._elsewhere

    def _move_progress(self) -> None:
        """Show what runs in the window that is there."""
        here = self._strip
        for strip in (self.window.progress, self._elsewhere):
            if strip is not here:
                for key in self._running:
                    strip.end_job(key)
        for key, (_, fraction, what) in self._running.items():
            if fraction >= 0.0 and what and key not in here.jobs:
                here.set_job(key, fraction, what, partial(self.cancel, key))


def no_session() -> Message:
    """Return what is said where something needs a session and none is open."""
    return Message("session", tr("No session is open."), todo=tr("Open a folder of photographs first."))
