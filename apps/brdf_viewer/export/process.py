"""An export runs as a process of its own: drawing holds the interpreter, and the window must stay alive.

It is the suite's command; it reports its steps as lines of JSON and stops, its unfinished files removed, when its input
is closed. So it also ends with the Viewer, however that ends.
"""

from __future__ import annotations

import contextlib
import json
import shutil

from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, QProcess, Signal

from brdf_suite.processes import child_command
from brdf_viewer.export.job import ExportJob

PATIENCE_MS = 10_000
"""A cancelled export ends at its next step; one that does not by then is ended by force."""

_CANCELLED = 130


class ExportProcess(QObject):
    """Runs one export.

    Signals: ``moved(fraction, what)``; then one of ``done(notes)``, the lines that it printed, ``failed(text)`` and
    ``cancelled()``.
    """

    moved = Signal(float, str)
    done = Signal(list)
    failed = Signal(str)
    cancelled = Signal()

    def __init__(self, job: ExportJob, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.job = job
        self._message: list[str] = []
        self._rest = b""
        self._is_wanted = True
        self._ended = False
        self.process = QProcess(self)
        self.process.readyReadStandardOutput.connect(self._read)
        self.process.finished.connect(self._finished)
        self.process.errorOccurred.connect(self._not_started)
        self._force = make_timer(self, self.process.kill, PATIENCE_MS)

    def start(self) -> None:
        """Begin."""
        program, *arguments = child_command("brdf_suite.cli.main", *self.job.arguments())
        self.process.start(program, arguments)

    def cancel(self) -> None:
        """Ask it to stop; ``cancelled`` reports when it has."""
        self._is_wanted = False
        self.process.closeWriteChannel()
        self._force.start()

    def stop(self) -> None:
        """Stop it and wait until it has ended: the window closes."""
        if self.process.state() != QProcess.ProcessState.NotRunning:
            self.cancel()
            if not self.process.waitForFinished(PATIENCE_MS):
                self.process.kill()
                self.process.waitForFinished(PATIENCE_MS)

    def _read(self) -> None:
        *lines, self._rest = (self._rest + self.process.readAllStandardOutput().data()).split(b"\n")
        for line in lines:
            text = line.decode("utf-8", errors="replace")
            step = _step(text)
            if step is None:
                self._message.append(text)
            elif self._is_wanted:
                self.moved.emit(*step)

    def _not_started(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._end()
            text = tr("The export could not be started: {reason}.")
            self.failed.emit(text.format(reason=self.process.errorString()))

    def _finished(self, code: int, status: QProcess.ExitStatus) -> None:
        if self._ended:
            return
        self._read()
        words = bytes(self.process.readAllStandardError().data()).decode("utf-8", errors="replace").strip()
        crashed = status == QProcess.ExitStatus.CrashExit
        self._end(forced=crashed)
        if not self._is_wanted or code == _CANCELLED:
            self.cancelled.emit()
        elif crashed or (code and words):
            last = (
                words.splitlines()[-1].removeprefix("brdf-suite: ")
                if words
                else tr("it ended without a message")
            )
            self.failed.emit(last)
        else:
            self.done.emit(list(self._message))  # with 1, too: a sheet that says which paints it lacks

    def _end(self, *, forced: bool = False) -> None:
        self._ended = True
        self._force.stop()
        if forced:
            for path in self.job.leftovers():
                with contextlib.suppress(OSError):  # another process may still hold it
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
        self.job.tidy()


def _step(line: str) -> tuple[float, str] | None:
    """Return the fraction and the words of a line that reports a step; None for any other line."""
    if not line.startswith('{"fraction"'):
        return None
    try:
        value = json.loads(line)
        return float(value["fraction"]), str(value["what"])
    except (ValueError, KeyError, TypeError):
        return None
