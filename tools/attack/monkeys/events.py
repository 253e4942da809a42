"""Random events for a program that runs: mouse, wheel, keys, menus, drops, clipboard; all drawn from one number.

``python -m tools.attack.monkeys.events PROGRAM SEED EVENTS FOLDER`` is the process that :mod:`tools.attack.monkeys.run`
starts. It runs the program as its command does, and sends an event as soon as the program is at rest after the last
one; some come in bursts. Mouse and keys go through the window, as those of a user do, so that dialogs and popups hold
them back. File dialogs are answered with a file of the folder, or are cancelled.
"""

from __future__ import annotations

import faulthandler
import json
import logging
import os
import random
import resource
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import IO

from brdf_qt.program.program import Program
from PySide6.QtCore import QObject, QPoint, QPointF, Qt, QThread, QTimer
from PySide6.QtGui import (
    QAction,
    QContextMenuEvent,
    QDragEnterEvent,
    QDragLeaveEvent,
    QDragMoveEvent,
    QDropEvent,
    QGuiApplication,
    QInputMethodEvent,
    QWindow,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from shiboken6 import isValid

from brdf_suite.errors import SuiteError
from tools.attack.monkeys.answers import TEXTS, Answers

_MAINS = {
    "designer": ("brdf_designer.command_line", ("--no-start-page", "p.brdfpaint")),
    "viewer": ("brdf_viewer.command_line", ("--no-start-page", "p.brdfpaint")),
    "lobes": ("brdf_lobe_visualizer.command_line", ("--no-start-page", "p.brdfpaint", "blue")),
    "swatch": ("brdf_color_swatch.command_line", ("--no-start-page", "p.brdfpalette")),
}
SILENCE_S = 150.0
"""Of the clock, after which a turn of the event loop that does not end is taken for one without end."""
_MEMORY = 8 << 30
_POLL_MS = 4
_POLLS = 250
"""So often the program is asked whether it is at rest; some work, as a turntable, never ends."""
_DEEPEST = 4
"""Dialogs over each other, before the front one is closed."""
_KEYS = (
    *(Qt.Key(code) for code in range(Qt.Key.Key_0, Qt.Key.Key_9 + 1)),
    *(Qt.Key(code) for code in range(Qt.Key.Key_A, Qt.Key.Key_Z + 1)),
    *(Qt.Key(code) for code in range(Qt.Key.Key_F1, Qt.Key.Key_F12 + 1)),
    *[Qt.Key.Key_Tab, Qt.Key.Key_Return, Qt.Key.Key_Escape] * 3,
    *[Qt.Key.Key_Space, Qt.Key.Key_Delete, Qt.Key.Key_Backspace] * 3,
    *[Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Home, Qt.Key.Key_End] * 3,
    Qt.Key.Key_PageUp, Qt.Key.Key_PageDown, Qt.Key.Key_Plus, Qt.Key.Key_Minus, Qt.Key.Key_Menu, Qt.Key.Key_Comma,
)  # fmt: skip
_MODIFIERS = (
    *[Qt.KeyboardModifier.NoModifier] * 6,
    *[Qt.KeyboardModifier.ControlModifier] * 3,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
    Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier,
)
_MODIFIER_KEYS = {
    Qt.KeyboardModifier.ShiftModifier: Qt.Key.Key_Shift,
    Qt.KeyboardModifier.ControlModifier: Qt.Key.Key_Control,
    Qt.KeyboardModifier.AltModifier: Qt.Key.Key_Alt,
}
_OF_THE_PLATFORM = "This plugin does not support"
"""What Qt's offscreen platform says of itself."""
_BUTTONS = (*[Qt.MouseButton.LeftButton] * 6, Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton)
_COPY = Qt.DropAction.CopyAction
_ACTIONS = Qt.DropAction.CopyAction | Qt.DropAction.MoveAction | Qt.DropAction.LinkAction


class Monkey(QObject):
    """Sends events to a program, and notes what it did and how long each turn of the event loop took.

    A turn is over when this object gets its timer's event: longer ones hold back all that a user does. Processor time
    of the main thread is counted, since another process may hold up both.
    """

    def __init__(self, program: Program, seed: str, events: int, answers: Answers, trace: IO[str]) -> None:
        super().__init__()
        self._program, self._seed, self._events = program, seed, events
        self._rng: random.Random
        self._answers, self._trace = answers, trace
        self._acting = self._polls = 0
        self._pressed = Qt.MouseButton.NoButton
        self._doing = "the start"
        self._began = time.thread_time()
        self._armed = 0.0
        self.done = 0
        self.longest_s = 0.0
        self.slow: dict[str, float] = {}
        self.memory_mb: list[float] = []
        self._kinds: dict[Callable[[], str], int] = {
            self._click: 26, self._drag_mouse: 8, self._wheel: 8, self._key: 22, self._type: 5, self._undo: 6,
            self._command: 10, self._context: 4, self._drop: 6, self._fill_clipboard: 2, self._paste: 3,
            self._close_another: 3, self._resize: 1,
        }  # fmt: skip
        self._later()

    def _later(self) -> None:
        QTimer.singleShot(_POLL_MS, self, self._turn)

    def _turn(self) -> None:
        self._time()
        level = QThread.currentThread().loopLevel()
        if level <= self._acting or not self._is_at_rest():
            self._later()  # the event is still being delivered, or what it led to is under way
            return
        self._polls = 0
        if self.done >= self._events:
            QApplication.exit(0)
            return
        # Before the event: a dialog that it opens runs an event loop of its own, in which the next one comes.
        self._later()
        outer, self._acting = self._acting, level
        try:
            for _ in range(random.Random(f"{self._seed} turn {self.done}").choice((1, 1, 1, 1, 3, 6))):
                self._send()
        finally:
            self._acting = outer

    def _time(self) -> None:
        now = time.thread_time()
        took, self._began = now - self._began, now
        if took > self.longest_s:
            self.longest_s = took
        if took > 1.0:
            self.slow[self._doing] = max(took, self.slow.get(self._doing, 0.0))
        if time.monotonic() - self._armed > 1.0:
            self._armed = time.monotonic()
            faulthandler.dump_traceback_later(SILENCE_S, exit=True)

    def _is_at_rest(self) -> bool:
        self._polls += 1
        return self._polls > _POLLS or (self._polls > 1 and self._program.is_idle)

    def _send(self) -> None:
        # Anew for each: where the machine's load changes what an event meets, the next ones are the same.
        self._rng = random.Random(f"{self._seed} {self.done}")
        self.done += 1  # also where an error ends it
        kind = self._rng.choices(list(self._kinds), list(self._kinds.values()))[0]
        if QThread.currentThread().loopLevel() > _DEEPEST:
            kind = self._close_front
        self._doing = kind.__name__.strip("_")
        self._doing = f"{self._doing} {kind()}"
        if self.done % 50 == 1:
            self.memory_mb.append(_memory_mb())
        print(f"{self.done} {self._doing!a}", file=self._trace, flush=True)

    # Where events go.

    def _front(self) -> list[QWidget]:
        """Return the windows that take events now, always in the same order."""
        for front in (QApplication.activePopupWidget(), QApplication.activeModalWidget()):
            if front is not None:
                return [front]
        found = [one for one in QApplication.topLevelWidgets() if one.isVisible() and one.windowHandle()]
        return sorted(found, key=lambda one: (one is not self._program.window, _name(one), one.windowTitle()))

    def _somewhere(self) -> tuple[QWidget, QWindow, QPoint] | None:
        """Return a widget, its window, and a place of it in the window; None where nothing is there."""
        windows = self._front()
        if not windows:
            return None
        window = windows[0] if self._rng.random() < 0.7 else self._rng.choice(windows)
        handle = window.windowHandle()
        seen = [
            one
            for one in (window, *window.findChildren(QWidget))
            if one.isVisible() and one.window() is window
        ]
        if handle is None or not seen:
            return None
        widget = self._rng.choice(seen)
        wide, high = max(1, widget.width()), max(1, widget.height())
        place = QPoint(self._rng.randrange(wide), self._rng.randrange(high))
        if self._rng.random() < 0.1:
            place = self._rng.choice((QPoint(0, 0), QPoint(wide - 1, high - 1)))
        there = widget.mapTo(window, place)
        return (widget, handle, there) if window.rect().contains(there) else None

    def _focus(self) -> QWindow | None:
        windows = self._front()
        handle = QGuiApplication.focusWindow() or (windows[0].windowHandle() if windows else None)
        return handle if handle is not None and isValid(handle) else None

    # What is sent; each returns what it was, in words.

    def _click(self) -> str:
        found = self._somewhere()
        if found is None:
            return "nowhere"
        widget, handle, place = found
        button, keys = self._rng.choice(_BUTTONS), self._rng.choice(_MODIFIERS)
        name = _name(widget)
        if self._rng.random() < 0.15 and handle.type() != Qt.WindowType.Popup:
            QTest.mouseDClick(handle, button, keys, place)
            return f"twice {name} {button.name}"
        QTest.mousePress(handle, button, keys, place)
        if isValid(handle):  # a popup ends with the press
            QTest.mouseRelease(handle, button, keys, place)
        return f"{name} {button.name}"

    def _drag_mouse(self) -> str:
        """Press, move on, or release: what begins here may end somewhere else."""
        found = self._somewhere()
        if found is None:
            return "nowhere"
        widget, handle, place = found
        name = _name(widget)
        if self._pressed == Qt.MouseButton.NoButton:
            self._pressed = self._rng.choice(_BUTTONS)
            QTest.mousePress(handle, self._pressed, self._rng.choice(_MODIFIERS), place)
            return f"press {name}"
        if self._rng.random() < 0.5:
            QTest.mouseMove(handle, place)
            return f"move {name}"
        button, self._pressed = self._pressed, Qt.MouseButton.NoButton
        QTest.mouseRelease(handle, button, Qt.KeyboardModifier.NoModifier, place)
        return f"release {name}"

    def _wheel(self) -> str:
        found = self._somewhere()
        if found is None:
            return "nowhere"
        widget, handle, place = found
        name = _name(widget)
        turn = QPoint(
            self._rng.choice((0, 0, 0, 120, -120)), self._rng.choice((120, -120, 15, -15, 12000, -12000))
        )
        QTest.wheelEvent(handle, QPointF(place), turn, QPoint(0, 0), self._rng.choice(_MODIFIERS))
        return name

    def _key(self) -> str:
        handle = self._focus()
        key, keys = self._rng.choice(_KEYS), self._rng.choice(_MODIFIERS)
        if handle is None or (key == Qt.Key.Key_Q and keys != Qt.KeyboardModifier.NoModifier):
            return "none"
        _strike(handle, key, keys)
        return f"{key.name} {keys.name}"

    def _type(self) -> str:
        text = self._rng.choice(TEXTS)
        widget = QApplication.focusWidget()
        if widget is None:
            return "nothing"
        name = _name(widget)
        event = QInputMethodEvent()
        event.setCommitString(text)
        QApplication.sendEvent(widget, event)
        if self._rng.random() < 0.5 and (handle := self._focus()) is not None:
            _strike(handle, Qt.Key.Key_Return)
        return f"{text[:20]} {name}"

    def _undo(self) -> str:
        keys = Qt.KeyboardModifier.ControlModifier
        if self._rng.random() < 0.4:
            keys |= Qt.KeyboardModifier.ShiftModifier
        handle = self._focus()
        if handle is not None:
            _strike(handle, Qt.Key.Key_Z, keys)
        return keys.name or ""

    def _command(self) -> str:
        if QApplication.activePopupWidget() is not None or QApplication.activeModalWidget() is not None:
            return self._close_front() if self._rng.random() < 0.3 else self._click()
        entries = [
            (path, action)
            for top in self._program.window.menuBar().actions()
            if isinstance(menu := top.menu(), QMenu)
            for path, action in _below(menu, top.text())
        ]
        path, action = self._rng.choice(entries)
        action.trigger()
        return path

    def _context(self) -> str:
        found = self._somewhere()
        if found is None:
            return "nowhere"
        widget, _, _ = found
        name = _name(widget)
        middle = widget.rect().center()
        reason = QContextMenuEvent.Reason.Mouse
        QApplication.sendEvent(widget, QContextMenuEvent(reason, middle, widget.mapToGlobal(middle)))
        return name

    def _drop(self) -> str:
        found = self._somewhere()
        if found is None or self._pressed != Qt.MouseButton.NoButton:
            return "nowhere"
        widget, _, _ = found
        name = _name(widget)
        what, data = self._answers.carried()
        place = widget.rect().center()
        keys = self._rng.choice(_MODIFIERS)
        left = Qt.MouseButton.LeftButton
        enter = QDragEnterEvent(place, _ACTIONS, data, left, keys)
        QApplication.sendEvent(widget, enter)
        if enter.isAccepted() and isValid(widget):
            move = QDragMoveEvent(place, _ACTIONS, data, left, keys)
            QApplication.sendEvent(widget, move)
            if move.isAccepted() and self._rng.random() < 0.9:
                QApplication.sendEvent(widget, QDropEvent(QPointF(place), _ACTIONS, data, left, keys))
            else:
                QApplication.sendEvent(widget, QDragLeaveEvent())
        return f"{what} {name}"

    def _fill_clipboard(self) -> str:
        what, data = self._answers.carried()
        QGuiApplication.clipboard().setMimeData(data)
        return what

    def _paste(self) -> str:
        handle = self._focus()
        if handle is not None:
            _strike(handle, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
        return "Ctrl+V"

    def _close_another(self) -> str:
        others = [one for one in self._front() if one is not self._program.window]
        if not others:
            return "none"
        other = self._rng.choice(others)
        name = _name(other)
        other.close()
        return name

    def _close_front(self) -> str:
        front = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        if front is None:
            return "none"
        name = _name(front)
        front.close()
        return name

    def _resize(self) -> str:
        wide, high = self._rng.choice(((1, 1), (721, 521), (1280, 800), (2500, 1400), (900, 3000)))
        self._program.window.resize(wide, high)
        return f"{wide}x{high}"


def _name(widget: QWidget) -> str:
    return f"{type(widget).__name__}:{widget.objectName()}"


def _strike(handle: QWindow, key: Qt.Key, keys: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    """Press and release a key; each press may end the window, and the event before it may have done so."""
    for modifier, own in _MODIFIER_KEYS.items():
        if keys & modifier and isValid(handle):
            QTest.keyPress(handle, own)  # QTest itself would go on with a window that is gone
    if isValid(handle):
        QTest.keyPress(handle, key, keys)
    if isValid(handle):
        QTest.keyRelease(handle, key, keys)


def _below(menu: QMenu, path: str) -> Iterator[tuple[str, QAction]]:
    menu.aboutToShow.emit()  # menus of recent files, and the like, are filled then
    for action in menu.actions():
        below = f"{path}/{action.text()}"
        if isinstance(menu_below := action.menu(), QMenu):
            yield from _below(menu_below, below)
        elif action.isEnabled() and not action.isSeparator() and action.objectName() != "action_Quit":
            yield below, action


def _memory_mb() -> float:
    status = Path("/proc/self/statm").read_text(encoding="ascii")
    return int(status.split()[1]) * os.sysconf("SC_PAGE_SIZE") / (1 << 20)


class _Faults(logging.Handler):
    """Collects what is logged of errors that are not the suite's own, and the warnings of Qt."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.messages: Counter[str] = Counter()

    def emit(self, record: logging.LogRecord) -> None:
        """Count a message of Qt, and print an error that no one expected."""
        if record.name == "qt" and _OF_THE_PLATFORM not in record.getMessage():
            self.messages[record.getMessage()[:200]] += 1
        error = record.exc_info[1] if isinstance(record.exc_info, tuple) else None
        if error is not None and not isinstance(error, SuiteError):
            print(
                logging.Formatter().formatException((type(error), error, error.__traceback__)),
                file=sys.stderr,
            )


def main() -> int:
    """Run the program that the command line names under random events."""
    name, seed, events, place = sys.argv[1:]
    faulthandler.enable()
    resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
    folder = Path(place)
    answers = Answers(random.Random(f"{name} {seed}"), folder)
    answers.install()
    faults = _Faults()
    run = QApplication.exec
    found: dict[str, object] = {}

    def run_with_events(*_: object) -> int:
        logging.getLogger().addHandler(faults)
        program = next(
            one for window in QApplication.topLevelWidgets() if (one := window.findChild(Program)) is not None
        )
        monkey = Monkey(program, f"{name} {seed}", int(events), answers, trace)
        status = run()
        found.update(
            events=monkey.done,
            longest_s=monkey.longest_s,
            slow=monkey.slow,
            memory_mb=monkey.memory_mb,
            messages=faults.messages,
        )
        return status

    QApplication.exec = staticmethod(run_with_events)  # type: ignore[method-assign]
    module, arguments = _MAINS[name]
    with (folder / "trace").open("w", encoding="utf-8") as trace:
        status = int(import_module(module).main(list(arguments)))
    faulthandler.cancel_dump_traceback_later()
    (folder / "found.json").write_text(json.dumps(found), encoding="utf-8")
    return status


if __name__ == "__main__":
    sys.exit(main())
