"""The frame time in the status bar: the median of the last frames, renewed a few times a second."""

from __future__ import annotations

from collections import deque
from statistics import median

from brdf_qt.program.translation import tr
from brdf_qt.window.status_line import StatusCell
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Signal

_FRAMES = 15
_SHOW_EVERY_MS = 250


class FrameMeter(QObject):
    """Takes the milliseconds of each frame; a number that changes sixty times a second could not be read.

    ``shown()`` is emitted each time that the status bar was renewed.
    """

    shown = Signal()

    def __init__(self, cell: StatusCell, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._cell = cell
        self._frames: deque[float] = deque(maxlen=_FRAMES)
        self._timer = make_timer(self, self._show, _SHOW_EVERY_MS)

    def add(self, milliseconds: float) -> None:
        """Count one frame."""
        self._frames.append(milliseconds)
        if not self._timer.isActive():
            self._timer.start()

    def clear(self) -> None:
        """There is no picture: show no time."""
        self._frames.clear()
        self._timer.stop()
        self._cell.set("")

    @property
    def words(self) -> str:
        """The frame time as it is shown; empty while there is none."""
        return self._cell.text()

    def _show(self) -> None:
        typical, slowest = median(self._frames), max(self._frames)
        tip = tr("Frame time: median of the last {count}; slowest {slowest:.1f} ms")
        self._cell.set(f"{typical:.1f} ms", tip.format(count=len(self._frames), slowest=slowest))
        self.shown.emit()
