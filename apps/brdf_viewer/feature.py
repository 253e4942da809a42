"""What every feature of the Viewer has: its state and its window."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from brdf_qt.program.feature import Feature
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner, Work
from PySide6.QtCore import QObject

from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class ViewerFeature(Feature, QObject):
    """One feature of the Viewer, which connects its part of the window with the viewer state when it is made."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(window)
        self._state, self._window = state, window

    def _report(self, error: BaseException, key: str, todo: str = "") -> None:
        """Show an error in the window, under ``key``, with what can be done."""
        self._window.messages.show_message(message_of(error, key, todo=todo))

    def _refuse(self, key: str, what: str, todo: str, where: str = "") -> None:
        """Say in the window, under ``key``, why a command does nothing, and what can be done."""
        self._window.messages.show_message(Message(key, what, where=where, todo=todo, severity="error"))

    def _run(
        self,
        runner: TaskRunner,
        key: str,
        work: Work,
        request: object,
        done: Callable[[Any], None],
        failed: Callable[[Exception], None],
        title: str = "",
    ) -> None:
        """Do work on a thread; the window shows under ``key`` how far it is, after ``title``, until it has ended."""
        window = self._window
        window.messages.dismiss(key)

        def end(take: Callable[[Any], None], result: object) -> None:
            window.set_idle(key)
            take(result)

        runner.submit(
            key,
            work,
            request,
            done=lambda answer: end(done, answer),
            failed=lambda error: end(failed, error),
            progress=lambda fraction, what: window.set_busy(key, fraction, title + what),
        )
