"""What the start page asks for, done in the window that it belongs to; and the tour after the first use of it."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QRect, Signal
from PySide6.QtWidgets import QMainWindow

from brdf_qt.program.settings import settings
from brdf_qt.program.suite import start_again
from brdf_qt.program.translation import chosen, remember
from brdf_qt.start.page import StartWindow
from brdf_qt.start.tour import Tour, TourStep

_SEEN = "tour/seen"


class StartControl(QObject):
    """Shows the start page over a window, and hands on what is chosen there; the page may come before the window.

    Signals
    -------
    paint_requested(name), file_requested(Path), command_requested(key)
        As :class:`StartWindow` has them, once the window is there. The page is gone then.
    """

    paint_requested = Signal(str)
    file_requested = Signal(Path)
    command_requested = Signal(str)

    def __init__(self, window: QMainWindow, program: str, tour: Callable[[], list[TourStep]]) -> None:
        super().__init__(window)
        self._window, self._program, self._steps = window, program, tour
        self.page: StartWindow | None = None
        self.tour: Tour | None = None
        self.again: Callable[[str], object] = start_again
        """Starts the program of a name once more, after this one has closed."""

    def take(self, page: StartWindow) -> None:
        """Take a page that was shown before the window; what was chosen there meanwhile is done by its owner."""
        self.page = page
        page.paint_chosen.connect(self._open_paint)
        page.language_chosen.connect(self.choose_language)
        page.file_chosen.connect(lambda path: self._leave(partial(self.file_requested.emit, path)))
        page.command_chosen.connect(self._command)

    def show(self) -> None:
        """Show the page over the window."""
        if self.page is None:
            self.take(StartWindow(self._program))
        self.lay_over()

    def lay_over(self) -> None:
        """Keep the page over its window, in the middle of it as far as the screen has room; nothing is blocked."""
        page = self.page
        if page is None:
            return
        room = self._window.screen().availableGeometry()
        place = QRect(page.rect())
        place.moveCenter(self._window.frameGeometry().center())
        place.moveLeft(max(room.left(), min(place.left(), room.right() - place.width())))
        place.moveTop(max(room.top(), min(place.top(), room.bottom() - place.height())))
        page.move(place.topLeft())
        page.show()
        above, below = page.windowHandle(), self._window.windowHandle()
        if above is not None and below is not None:
            above.setTransientParent(below)
        page.raise_()
        page.activateWindow()

    def hide(self) -> None:
        """Put the page away: work has begun elsewhere."""
        if self.page is not None:
            self.page.hide()

    def start_tour(self) -> None:
        """Lead through the window, from the first step; another tour that runs is left."""
        if self.tour is not None:
            self.tour.leave()
        settings().setValue(_SEEN, True)
        self.tour = Tour(self._window, self._steps())
        self.tour.show_step(0)

    def _command(self, key: str) -> None:
        if key == "manual":  # is read beside the page
            self.command_requested.emit(key)
        elif key == "tour":
            self.hide()
            self.command_requested.emit(key)
        else:
            self._leave(partial(self.command_requested.emit, key))

    def choose_language(self, code: str) -> None:
        """Close the window, which asks about unsaved work, and start again in a language; else all stays as it is."""
        before = chosen()
        remember(code)
        self.hide()  # the window is the last one then, and the program ends with it
        if self._window.close():
            self.again(self._program)
            return
        remember(before)
        self.lay_over()

    def _leave(self, act: Callable[[], object]) -> None:
        """Put the page away, and act in the window, which has the keyboard then."""
        self.hide()
        self._window.activateWindow()
        act()

    def _open_paint(self, name: str) -> None:
        """Open a paint; who does so for the first time is led through the window. Other beginnings have a task."""
        self._leave(partial(self.paint_requested.emit, name))
        if self._steps() and not settings().value(_SEEN, False, type=bool):
            self.start_tour()
