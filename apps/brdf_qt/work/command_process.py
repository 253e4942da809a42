"""Work in child processes: drawing and fitting hold the interpreter, and the window must stay responsive.

The suite's command with ``--follow`` reports its steps as lines of JSON, ``{"fraction": 0.5, "what": "drawing"}``, and
stops, its unfinished files removed, when its input is closed. So it also ends with the program, however that ends.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, BinaryIO

from PySide6.QtCore import QObject, QProcess, Signal

from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress

PATIENCE_MS = 20_000
"""A cancelled command ends at its next step; one that does not by then is ended by force."""
_COMMAND = "brdf_suite"
_CANCELLED = 130
_LONGEST_ERROR = 4000
"""Characters kept of what a process prints to standard error: the last ones are what a crash leaves."""
_LOOK_S = 0.1


class ChildProcess(QObject):
    """A child process that writes lines; a subclass takes them, and an end that it did not ask for."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._rest = b""
        self._errors = ""
        self.has_ended = False
        """Whether the process has ended or failed to start; set it to ignore what still comes."""
        self.process = QProcess(self)
        self.process.readyReadStandardOutput.connect(self._read)
        self.process.readyReadStandardError.connect(self._read_errors)
        self.process.finished.connect(self._finished)
        self.process.errorOccurred.connect(self._not_started)

    @property
    def is_running(self) -> bool:
        return self.process.state() != QProcess.ProcessState.NotRunning

    def launch(self, command: Sequence[str]) -> None:
        """Start the process; what is sent is read as soon as it can be."""
        self.process.start(command[0], list(command[1:]))

    def send(self, message: dict[str, Any]) -> None:
        """Write a line of JSON to the process; nothing where it has ended."""
        if self.is_running:
            self.process.write(json.dumps(message).encode() + b"\n")

    def take_line(self, line: str) -> None:
        """Take a line of standard output."""
        raise NotImplementedError

    def take_end(self, code: int, errors: str, *, crashed: bool) -> None:
        """Take the end of the process, with its exit status (after a crash the signal) and its standard error."""
        raise NotImplementedError

    def take_failed_start(self, reason: str) -> None:
        """Take that the process could not be started."""
        raise NotImplementedError

    def _read(self) -> None:
        *lines, self._rest = (self._rest + self.process.readAllStandardOutput().data()).split(b"\n")
        for line in lines:
            if not self.has_ended:
                self.take_line(line.decode("utf-8", errors="replace"))

    def _read_errors(self) -> None:
        found = bytes(self.process.readAllStandardError().data()).decode("utf-8", errors="replace")
        self._errors = (self._errors + found)[-_LONGEST_ERROR:]

    def _not_started(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart and not self.has_ended:
            self.has_ended = True
            self.take_failed_start(self.process.errorString())

    def _finished(self, code: int, status: QProcess.ExitStatus) -> None:
        self._read()
        self._read_errors()
        if not self.has_ended:
            self.has_ended = True
            self.take_end(code, self._errors.strip(), crashed=status == QProcess.ExitStatus.CrashExit)


class CommandProcess(ChildProcess):
    """One run of the suite's command.

    Signals: ``moved(fraction, what)``; then one of ``done(lines)``, what it printed beside its steps, ``failed(text)``
    and ``cancelled()``.
    """

    moved = Signal(float, str)
    done = Signal(list)
    failed = Signal(str)
    cancelled = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._lines: list[str] = []
        self._is_wanted = True
        self._force = make_timer(self, self.process.kill, PATIENCE_MS)

    def run_command(self, *arguments: str) -> None:
        """Begin ``brdf-suite`` with these arguments; ``--follow`` is added."""
        self.launch(child_command(_COMMAND, *arguments, "--follow"))

    def cancel(self) -> None:
        """Ask it to stop; ``cancelled`` reports when it has."""
        self._is_wanted = False
        self.process.closeWriteChannel()
        self._force.start()

    def stop(self) -> None:
        """Stop it and wait until it has ended: the window closes."""
        if self.is_running:
            self.cancel()
            if not self.process.waitForFinished(PATIENCE_MS):
                self.process.kill()
                self.process.waitForFinished(PATIENCE_MS)

    def clean_up(self, *, forced: bool) -> None:
        """Remove temporary files; after an end by force (``forced``) also what the command left unfinished."""

    def take_line(self, line: str) -> None:
        step = _parse_step(line)
        if step is None:
            self._lines.append(line)
        elif self._is_wanted:
            self.moved.emit(*step)

    def take_failed_start(self, reason: str) -> None:
        self.clean_up(forced=False)
        self.failed.emit(tr("The work could not be started: {reason}.").format(reason=reason))

    def take_end(self, code: int, errors: str, *, crashed: bool) -> None:
        self._force.stop()
        self.clean_up(forced=crashed)
        if not self._is_wanted or code == _CANCELLED:
            self.cancelled.emit()
        elif crashed or (code and (errors or not self._lines)):
            self.failed.emit(_last_error(errors) or tr("The work ended without a message."))
        else:
            self.done.emit(self._lines)  # with 1, too: a sheet that says which paints it lacks


def run_command(arguments: Sequence[str], progress: Progress) -> str:
    """Run ``brdf-suite`` from a thread and return what it printed beside its steps; ``--follow`` is added.

    Raises
    ------
    SuiteError
        The last error that the command printed, or its exit status where it printed nothing.
    Cancelled
        The progress callback asked for it; the command removes its unfinished files.
    """
    with tempfile.TemporaryDirectory(prefix="brdf-command-") as folder:
        output, errors = Path(folder) / "output", Path(folder) / "errors"
        with output.open("wb") as out, errors.open("wb") as err, output.open("rb") as written:
            command = child_command(_COMMAND, *arguments, "--follow")
            process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=out, stderr=err)  # noqa: S603 - a module of ours
            assert process.stdin is not None
            try:
                text = _follow(process, written, progress)
            finally:
                process.stdin.close()
                try:
                    process.wait(PATIENCE_MS / 1000)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
        if process.returncode == _CANCELLED:
            raise Cancelled
        last = _last_error(errors.read_text(encoding="utf-8", errors="replace"))
        if process.returncode and (last or not text):
            raise SuiteError(last or f"the command ended with status {process.returncode}.")
        return text


def _follow(process: subprocess.Popen[bytes], written: BinaryIO, progress: Progress) -> str:
    """Report the steps, the last one again and again so that it can be cancelled; return the other lines."""
    lines: list[str] = []
    rest, step, running = b"", (0.0, ""), True
    while running:
        try:
            process.wait(_LOOK_S)
            running = False
        except subprocess.TimeoutExpired:
            pass
        *found, rest = (rest + written.read()).split(b"\n")
        for line in found:
            text = line.decode("utf-8", errors="replace")
            new = _parse_step(text)
            if new is None:
                lines.append(text)
            else:
                step = new
                progress(*step)
        progress(*step)
    return "\n".join(lines)


def _last_error(errors: str) -> str:
    return next(reversed(errors.strip().splitlines()), "").removeprefix("brdf-suite: ")


def _parse_step(line: str) -> tuple[float, str] | None:
    """Return the fraction and the words of a line that reports a step; None for any other line."""
    if not line.startswith('{"fraction"'):
        return None
    try:
        value = json.loads(line)
        return float(value["fraction"]), str(value["what"])
    except (ValueError, KeyError, TypeError):
        return None
