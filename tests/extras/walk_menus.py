"""``walk_menus.py PROGRAM FOLDER ANSWER``: opens a program and does every command of its menus.

Dialogs are closed as soon as they open. Then the parts that need an optional package are used: the Viewer traces and
exports a video, the Designer reads the photographs in FOLDER/session. Writes what was done, and every message that the
windows showed, as JSON to the file ANSWER.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

from brdf_qt.program.application import create_application
from PySide6.QtCore import QObject, QProcess, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from shiboken6 import isValid

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.lighting.procedural import sky, studio
from brdf_suite.pipeline import environments
from brdf_suite.realtime.environment import textures
from brdf_suite.realtime.pictures.renderer import Renderer

Step = Callable[[], bool]
"""A step is over as soon as it returns True."""
_MOST = 1000
_TURN_MS = 4


class Walk(QObject):
    """Goes through the menus of a window, one command in each turn of the event loop."""

    def __init__(
        self, window: QWidget, more: Callable[[], Iterator[Step]], end: Callable[[], object]
    ) -> None:
        super().__init__()
        self._window, self._end = window, end
        self._steps = self._all(more)
        self._wait: Step = lambda: True
        self.done: list[str] = []
        self.messages: set[str] = set()
        self._closer = QTimer(self, interval=_TURN_MS, timeout=self._close_dialogs)
        self._closer.start()
        QTimer.singleShot(0, self._begin)

    def _begin(self) -> None:
        # Nothing is looked at, and a picture of a large window takes most of the time where no GPU draws it.
        self._window.resize(self._window.minimumSizeHint())
        self._go()

    def _go(self) -> None:
        for window in QApplication.topLevelWidgets():
            if isValid(window) and hasattr(window, "messages"):
                for message in window.messages.shown().values():
                    self.messages.add(" | ".join((message.what, message.where, message.todo)))
        if self._wait():
            step = next(self._steps, None)
            if step is None:
                self._closer.stop()
                self._end()
                QApplication.exit(0)
                return
            self._wait = step
        QTimer.singleShot(_TURN_MS, self._go)

    def _all(self, more: Callable[[], Iterator[Step]]) -> Iterator[Step]:
        yield from more()
        while (found := self._next()) is not None and len(self.done) < _MOST:
            key, action = found
            self.done.append(key)
            action.trigger()
            yield lambda: True
            # What goes on, as a turntable does, or fills the screen would be drawn until the end.
            if isValid(action) and action.isCheckable() and action.actionGroup() is None:
                action.trigger()
            if self._window.isFullScreen():
                self._window.showNormal()
            for window in QApplication.topLevelWidgets():
                if window is not self._window and window.isVisible():
                    window.close()

    def _next(self) -> tuple[str, QAction] | None:
        """Return a command that was not done yet, with its key; Quit comes last."""
        left = [(key, action) for key, action in self._entries() if key not in self.done]
        return min(left, key=lambda entry: "Quit" in entry[0], default=None)

    def _entries(self) -> Iterator[tuple[str, QAction]]:
        for action in self._window.menuBar().actions():
            yield from _below(action.menu(), action.text())

    def _close_dialogs(self) -> None:
        for widget in (QApplication.activePopupWidget(), QApplication.activeModalWidget()):
            if widget is not None:
                widget.close()


def _below(menu: QMenu, path: str) -> Iterator[tuple[str, QAction]]:
    menu.aboutToShow.emit()  # menus of recent files, and the like, are filled then
    for action in menu.actions():
        below = f"{path} ▸ {action.text()}"
        if action.menu() is not None:
            yield from _below(action.menu(), below)
        elif action.isEnabled() and not action.isSeparator():
            # The texts of some commands change, as Undo's does; their names do not.
            yield action.objectName() or below, action


def designer(folder: Path) -> Walk:
    """Open the Designer; the assistant opens a folder of photographs."""
    from brdf_designer.acquire.control import AcquireControl
    from brdf_designer.assembly import Designer

    program = Designer()

    def more() -> Iterator[Step]:
        yield lambda: program.is_idle
        control = program.feature(AcquireControl)
        assistant = control.open()
        bench = assistant.bench
        assistant.sessions.open(folder / "session")
        # Its photographs are read by compiled kernels: without numba there is a message and no session.
        yield lambda: bench.is_quiet and (bench.session is not None or bool(bench.window.messages.shown()))

    return Walk(program.window, more, program.close)


def viewer(folder: Path) -> Walk:
    """Open the Viewer; it traces with both renderers, and exports a video."""
    from brdf_viewer.controller import ViewerController
    from brdf_viewer.export.job import FORMATS, ExportSettings

    view = View(environment=str(folder / "light.exr"), surface="sphere", sparkle=Sparkle(mode="off"))
    program = ViewerController(view, "blue")
    program.window.picture.setMaximumSize(120, 90)
    program.export.ask = lambda _parent, name, _title, ending: str(folder / (name + ending))
    messages = program.window.messages

    def more() -> Iterator[Step]:
        yield lambda: program.state.is_complete
        for renderer in ("reference", "raytraced"):
            program.traced.set_renderer(renderer)
            yield lambda: program.traced.renderer == "realtime" and bool(messages.shown())
            for key in list(messages.shown()):
                messages.dismiss(key)
        program.export.export(ExportSettings("turntable", FORMATS["turntable"][0], (16, 16), frames=2))
        yield lambda: not program.export.running

    return Walk(program.window, more, program.window.close)


def lobes(_folder: Path) -> Walk:
    """Open the Lobe Visualizer."""
    from brdf_lobe_visualizer.assembly import LobeVisualizer

    program = LobeVisualizer(asked=["blue"])

    def more() -> Iterator[Step]:
        program.start()
        yield lambda: program.is_idle

    return Walk(program.window, more, program.close)


def swatch(folder: Path) -> Walk:
    """Open Color Swatch."""
    from brdf_color_swatch.assembly import ColorSwatch

    program = ColorSwatch()

    def more() -> Iterator[Step]:
        program.open(str(folder / "list.gpl"))
        yield lambda: len(program.library.items) > 0
        program.window.command("select_all").trigger()

    return Walk(program.window, more, program.close)


def main() -> int:
    """Walk through the program that the command line names."""
    name, folder, answer = sys.argv[1:]
    app = create_application(name.title())
    app.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    started: list[list[str]] = []
    # Nothing is looked at: one sample a pixel is drawn in a quarter of the time, and lights without mip levels sooner.
    Renderer.render.__defaults__ = (0,)
    textures.MIPMAPPED_FROM = 4096
    # Studios and skies of fewer rows: plain numpy filters each new one of them for seconds.
    for draw in (studio, sky):
        draw.__defaults__ = (128, *draw.__defaults__[1:])
    environments.DRAFT_ROWS = 64
    # Another program would stay open; each is walked through on its own.
    QProcess.startDetached = lambda _program, arguments: (started.append(arguments), (True, 0))[1]
    walk = {"designer": designer, "viewer": viewer, "lobes": lobes, "swatch": swatch}[name](Path(folder))
    walk._window.show()
    status = app.exec()
    found = {"done": walk.done, "messages": sorted(walk.messages), "started": started}
    Path(answer).write_text(json.dumps(found, ensure_ascii=False, indent=1), encoding="utf-8")
    return status


if __name__ == "__main__":
    sys.exit(main())
