"""A start with the page first: it is on the screen and answers while the program behind it is imported and made."""

from __future__ import annotations

import importlib
import threading
from collections.abc import Callable
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QEventLoop, QObject, Signal
from PySide6.QtWidgets import QApplication

from brdf_qt.program.application import process_age_s
from brdf_qt.program.suite import start_again
from brdf_qt.program.translation import remember, tr
from brdf_qt.start.control import StartControl
from brdf_qt.start.page import StartWindow

T = TypeVar("T")


class Launch(QObject):
    """The page of program ``name``, shown before there is a window; what is chosen there waits for it."""

    _imported = Signal()

    def __init__(self, app: QApplication, name: str) -> None:
        super().__init__(app)
        self._app, self._name = app, name
        self.page = StartWindow(name)
        self.shown_s = 0.0
        """Seconds from the start of the process to the page on the screen."""
        self._waiting: Callable[[], object] | None = None
        self._error: Exception | None = None
        self._quits = self._has_window = False
        self._loop = QEventLoop()
        self.again: Callable[[str], object] = start_again
        """Starts the program of a name once more."""
        page = self.page
        page.painted.connect(lambda: setattr(self, "shown_s", round(process_age_s(), 3)))
        page.paint_chosen.connect(lambda name: self._wait(partial(page.paint_chosen.emit, name)))
        page.file_chosen.connect(lambda path: self._wait(partial(page.file_chosen.emit, path)))
        page.command_chosen.connect(lambda key: self._wait(partial(page.command_chosen.emit, key)))
        page.language_chosen.connect(self._choose_language)

    def load(self, module: str, make: Callable[[], T]) -> T | None:
        """Show the page, import ``module`` on a thread, and return what ``make`` makes; None where the user has quit.

        An error of the import is raised here.
        """
        self._app.setQuitOnLastWindowClosed(False)
        self._app.aboutToQuit.connect(self._quit)
        loop = self._loop
        self.page.painted.connect(loop.quit)
        self.page.show_loading(tr("Loading {program}…").format(program=self._name))
        self.page.show()
        loop.exec()
        self._imported.connect(loop.quit)
        threading.Thread(target=self._import, args=(module,), daemon=True).start()
        loop.exec()
        self._app.aboutToQuit.disconnect(self._quit)
        if self._error is not None:
            raise self._error
        return None if self._quits else make()

    def hand_over(self, start: StartControl) -> None:
        """Give the page to the window that is there now, and have done what was chosen meanwhile."""
        self._app.setQuitOnLastWindowClosed(True)
        self.page.show_loading("")
        start.take(self.page)
        self._has_window = True
        if self._waiting is not None:
            self._waiting()
        elif self.page.isVisible():
            start.lay_over()

    def _import(self, module: str) -> None:
        try:
            importlib.import_module(module)
        except Exception as error:  # noqa: BLE001 - raised again in the main thread
            self._error = error
        self._imported.emit()

    def _wait(self, choice: Callable[[], object]) -> None:
        if not self._has_window:
            self._waiting = choice

    def _choose_language(self, code: str) -> None:
        """End before there is a window, and start again in a language; once there is one, that is its own affair."""
        if not self._has_window:
            remember(code)
            self._quits = True
            self.page.hide()
            self._loop.quit()
            self.again(self._name)

    def _quit(self) -> None:
        self._quits = True
