"""A search of the basis as a process of its own: the suite's command, which keeps what it finds in ``FILE.part``.

It reports its steps as lines of JSON and stops when its input is closed, so it ends with the program, however that
ends; the same search resumes from what is kept.
"""

from __future__ import annotations

import json
from pathlib import Path

from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, QProcess, Signal

from brdf_suite.processes import child_command

PATIENCE_MS = 10_000
"""A cancelled search ends within an evaluation; one that does not by then is ended by force."""
MOST_LOBES = 11
_CANCELLED = 130


class BasisRun(QObject):
    """One search. Signals: ``moved(fraction, what)``; then one of ``done()``, ``failed(text)`` and ``cancelled()``."""

    moved = Signal(float, str)
    done = Signal()
    failed = Signal(str)
    cancelled = Signal()

    def __init__(self, folder: Path, output: Path, lobes: int, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.folder, self.output, self.lobes = folder, output, lobes
        self._rest = b""
        self._wanted, self._ended = True, False
        self._process = QProcess(self)
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._finished)
        self._process.errorOccurred.connect(self._not_started)
        self._force = make_timer(self, self._process.kill, PATIENCE_MS)

    @property
    def state(self) -> Path:
        """The file that holds what is found so far."""
        return self.output.with_name(self.output.name + ".part")

    def start(self) -> None:
        """Begin, or resume from what is kept."""
        from brdf_suite.fitting.basis_search.workers import usable_cores  # much to import for a start

        # A core is left to the windows.
        workers = max(1, usable_cores() - 1)
        words = ["basis", "--follow", "--database", str(self.folder), "-o", str(self.output)]
        words += ["--lobes", str(self.lobes), "--workers", str(workers)]
        program, *arguments = child_command("brdf_suite.cli.main", *words)
        self._process.start(program, arguments)

    def cancel(self) -> None:
        """Ask it to stop; ``cancelled`` is emitted once it has."""
        self._wanted = False
        self._process.closeWriteChannel()
        self._force.start()

    def stop(self) -> None:
        """Stop it and wait until it has ended: the window closes."""
        if self._process.state() != QProcess.ProcessState.NotRunning:
            self.cancel()
            if not self._process.waitForFinished(PATIENCE_MS):
                self._process.kill()
                self._process.waitForFinished(PATIENCE_MS)

    def _read(self) -> None:
        *lines, self._rest = (self._rest + bytes(self._process.readAllStandardOutput().data())).split(b"\n")
        for line in lines:
            step = _step(line.decode("utf-8", errors="replace"))
            if step is not None and self._wanted:
                self.moved.emit(*step)

    def _not_started(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart and not self._ended:
            self._ended = True
            self.failed.emit(f"The search could not be started: {self._process.errorString()}.")

    def _finished(self, code: int, status: QProcess.ExitStatus) -> None:
        if self._ended:
            return
        self._ended = True
        self._force.stop()
        self._read()
        words = bytes(self._process.readAllStandardError().data()).decode("utf-8", errors="replace").strip()
        if not self._wanted or code == _CANCELLED:
            self.cancelled.emit()
        elif code or status == QProcess.ExitStatus.CrashExit:
            last = (
                words.splitlines()[-1].removeprefix("brdf-suite: ")
                if words
                else "the search ended without an error message"
            )
            self.failed.emit(last)
        else:
            self.done.emit()


def _step(line: str) -> tuple[float, str] | None:
    """Return the fraction and the words of a line that reports a step; None for any other line."""
    if not line.startswith('{"fraction"'):
        return None
    try:
        value = json.loads(line)
        return float(value["fraction"]), str(value["what"])
    except (ValueError, KeyError, TypeError):
        return None
