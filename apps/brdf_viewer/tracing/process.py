"""The process that traces, seen from the window: lines of JSON to it and from it, and its end, however it comes."""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_qt.work.command_process import ChildProcess
from PySide6.QtCore import QObject, Signal

from brdf_suite.arrays import Singles
from brdf_suite.processes import child_command
from brdf_viewer.tracing.picture_slots import take

WORKER = "brdf_viewer.tracing.worker"
_END_MS = 5000
_FACTS = ("samples", "of", "noise", "seconds", "done", "denoised")


@dataclass(frozen=True, eq=False)
class TracedPicture:
    """A picture of one generation.

    ``pixels`` (h, w, 4): radiance of the working space, weighted by the object's coverage, and that coverage;
    (h, w, 7): with the darkness of the ground after them.
    ``samples`` a pixel, of ``of`` (0: without end); ``noise`` is a share of the luminance, None where unknown;
    ``seconds`` were spent on it. ``done``: it is as good as it was asked to become. ``denoised``: a denoiser has
    guessed what the noise hides.
    """

    generation: int
    pixels: Singles
    samples: int
    of: int
    noise: float | None
    seconds: float
    done: bool
    denoised: bool = False

    @property
    def size(self) -> tuple[int, int]:
        return (self.pixels.shape[1], self.pixels.shape[0])


class TraceProcess(ChildProcess):
    """Runs one worker; a new object for a new one.

    Signals
    -------
    opened(generation, notices, no_denoiser), moved(generation, fraction, what), pictured(TracedPicture)
        What becomes of a request.
    failed(generation, text)
        It cannot be traced; the process goes on.
    saved(path), not_saved(path, text)
        What became of a picture that was to be saved.
    crashed(text)
        The process has ended without a request.
    """

    opened = Signal(int, list, str)
    moved = Signal(int, float, str)
    pictured = Signal(object)
    failed = Signal(int, str)
    saved = Signal(str)
    not_saved = Signal(str, str)
    crashed = Signal(str)

    def __init__(self, parent: QObject | None = None, *, program: Sequence[str] | None = None) -> None:
        super().__init__(parent)
        self.folder = Path(tempfile.mkdtemp(prefix="brdf-traced-"))
        self._program = [*(program or child_command(WORKER))]

    def start(self) -> None:
        """Begin; what is sent is read as soon as it can be."""
        self.launch([*self._program, str(self.folder)])

    def end(self) -> None:
        """End it, in the middle of whatever it does: it holds nothing that is not asked for again."""
        self.has_ended = True
        if self.is_running:
            self.process.kill()
            self.process.waitForFinished(_END_MS)
        shutil.rmtree(self.folder, ignore_errors=True)  # in the temporary folder, which is emptied anyway

    def take_line(self, line: str) -> None:
        if not line:
            return
        answer = json.loads(line)
        what, generation = answer["say"], int(answer.get("generation", 0))
        if what == "picture":
            self._take_picture(answer, generation)
        elif what == "opened":
            notices = [tr_core(text) for text in answer["notices"]]
            self.opened.emit(generation, notices, tr_core(str(answer["no_denoiser"])))
        elif what == "moved":
            self.moved.emit(generation, float(answer["fraction"]), tr_core(str(answer["what"])))
        elif what == "failed":
            self.failed.emit(generation, tr_core(str(answer["text"])))
        elif what == "saved":
            self.saved.emit(str(answer["path"]))
        elif what == "not_saved":
            self.not_saved.emit(str(answer["path"]), tr_core(str(answer["text"])))

    def _take_picture(self, answer: dict[str, Any], generation: int) -> None:
        width, height = answer["size"]
        try:
            pixels = take(self.folder, int(answer["slot"]), (int(width), int(height)))
        except (OSError, ValueError, MemoryError) as error:
            self.failed.emit(generation, tr("The picture could not be read: {reason}").format(reason=error))
            return
        self.send({"do": "taken", "slot": answer["slot"]})
        self.pictured.emit(TracedPicture(generation, pixels, *(answer[fact] for fact in _FACTS)))

    def take_failed_start(self, reason: str) -> None:
        self.crashed.emit(tr("The renderer could not be started: {reason}.").format(reason=reason))

    def take_end(self, code: int, errors: str, *, crashed: bool) -> None:
        # Where Python reports the places of a crash, what was said of its cause stands before them.
        words = errors.partition("Fatal Python error:")[0] or errors
        lines = [line for line in words.splitlines() if line.strip()]
        last = lines[-1].strip() if lines else tr("no message; the computer may be out of memory")
        text = tr("The renderer ended (status {code}): {words}.")
        if crashed:
            text = tr("The renderer crashed (signal {code}): {words}.")
        self.crashed.emit(text.format(code=code, words=last.rstrip(".")))
