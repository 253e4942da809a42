"""Where windows go on the screen: side by side where it is wide enough, and never one on another."""

from __future__ import annotations

import json
import uuid
from collections.abc import Sequence
from itertools import product

from PySide6.QtCore import QEvent, QLockFile, QObject, QPoint, QRect, QSize
from PySide6.QtWidgets import QWidget

from brdf_qt.program.settings import SHARED, state_folder
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import FileError
from brdf_suite.regular_files import read_bytes

_ENDING = ".window.json"
_REST_MS = 100
"""A window that has not moved for so long is noted."""


def halves(room: QRect, least: QSize) -> tuple[QRect, QRect] | None:
    """Return the left and the right half of a screen; ``None`` where a half is narrower than a window can be."""
    half = room.width() // 2
    if half < least.width():
        return None
    left = QRect(room.topLeft(), QSize(half, room.height()))
    return left, QRect(left.topRight() + QPoint(1, 0), QSize(room.width() - half, room.height()))


def free_place(room: QRect, wanted: QRect, least: QSize, taken: Sequence[QRect]) -> QRect:
    """Return where a window goes: as ``wanted`` where nothing lies there, otherwise where it hides least of the others.

    It is at least ``least`` and at most as large as wanted, and within ``room``; of places that hide as little, the
    largest.
    """
    if not any(wanted.intersects(other) for other in taken):
        return wanted
    spare = [room.right() - other.right() for other in taken] + [
        other.left() - room.left() for other in taken
    ]
    below = [room.bottom() - other.bottom() for other in taken] + [
        other.top() - room.top() for other in taken
    ]
    widths = {min(max(width, least.width()), wanted.width()) for width in (*spare, wanted.width())}
    heights = {min(max(height, least.height()), wanted.height()) for height in (*below, wanted.height())}
    places = []
    for width, height in product(sorted(widths), sorted(heights)):
        for x, y in product(
            (room.left(), room.right() - width + 1), (room.top(), room.bottom() - height + 1)
        ):
            places.append(QRect(x, y, width, height))
    return min(places, key=lambda place: (_hidden(place, taken), -place.width() * place.height()))


def _hidden(place: QRect, taken: Sequence[QRect]) -> int:
    common = [place.intersected(other) for other in taken]
    return sum(one.width() * one.height() for one in common if not one.isEmpty())


class WindowPlaces(QObject):
    """Notes where a window is, and finds where those of the other programs are; one that died has none."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._folder = state_folder("windows", SHARED)
        self._file = self._folder / f"{uuid.uuid4().hex}{_ENDING}"
        self._lock = QLockFile(f"{self._file}.lock")
        self._lock.setStaleLockTime(0)
        self._lock.tryLock(0)
        self._moved = make_timer(self, self._write, _REST_MS)
        window.installEventFilter(self)

    def others(self) -> list[QRect]:
        """Return where the windows of the other programs are, in pixels of the screen."""
        found = []
        for file in self._folder.glob(f"*{_ENDING}"):
            if file == self._file:
                continue
            lock = QLockFile(f"{file}.lock")
            lock.setStaleLockTime(0)
            if lock.tryLock(0):
                file.unlink(missing_ok=True)
                lock.unlock()
                continue
            try:
                found.append(QRect(*json.loads(read_bytes(file))))
            except (FileError, ValueError, TypeError):
                continue  # it is being written, or its program has just ended
        return found

    def step_aside(self) -> None:
        """Move the window, and make it smaller where need be, so that it hides as little as possible of the others."""
        taken = self.others()
        room = self._window.screen().availableGeometry()
        now = self._window.geometry()
        place = free_place(room, now, self._window.minimumSize(), taken)
        if place != now:
            self._window.setGeometry(place)

    def close(self) -> None:
        """Leave no note of a window that is gone."""
        self._window.removeEventFilter(self)
        self._moved.stop()
        self._file.unlink(missing_ok=True)
        self._lock.unlock()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds = QEvent.Type
        if event.type() in (kinds.Show, kinds.Move, kinds.Resize, kinds.WindowStateChange):
            self._moved.start()
        elif event.type() == kinds.Hide:
            self._file.unlink(missing_ok=True)
        return super().eventFilter(watched, event)

    def _write(self) -> None:
        if self._window.isVisible() and not self._window.isMinimized():
            place = self._window.frameGeometry()
            text = json.dumps([place.x(), place.y(), place.width(), place.height()])
            self._file.write_text(text, "utf-8")
