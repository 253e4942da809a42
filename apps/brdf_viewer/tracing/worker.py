"""``python -m brdf_viewer.tracing.worker FOLDER``: traces what it is asked for on its input, until that is closed.

Requests are lines of JSON, answers too; pictures lie in :mod:`.picture_slots`. Between two passes it looks for a
newer request, so no outdated picture is ever finished. It imports no Qt: it opens no window. When its input
ends, however the window ended, it removes ``FOLDER`` and is gone.

Requests: ``render`` (:mod:`.request`), ``pause``, ``resume`` with the samples to stop at, ``denoise`` on or not,
``taken`` with a slot, ``save`` with a path and a view. Answers: ``moved``, ``opened``, ``picture``, ``failed``, each
with the generation; ``saved`` and ``not_saved`` with the path.
"""

from __future__ import annotations

import json
import logging
import os
import queue
import shutil
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TextIO

from brdf_suite.documents.store import view_from_json
from brdf_suite.errors import SuiteError
from brdf_viewer.tracing.engines import Engines
from brdf_viewer.tracing.job import Job, TracedFrame
from brdf_viewer.tracing.picture_slots import SLOTS, put
from brdf_viewer.tracing.request import TraceRequest

log = logging.getLogger(__name__)

Message = dict[str, Any]
Say = Callable[[Message], None]
NICENESS = 10
"""The window draws with the same processors where no graphics card does: its gestures go first."""


class Inbox:
    """Reads requests on a thread; ``closed`` once the other side has gone."""

    def __init__(self, lines: TextIO) -> None:
        self._lines = lines
        self._waiting: queue.SimpleQueue[Message | None] = queue.SimpleQueue()
        self.closed = False
        threading.Thread(target=self._read, daemon=True).start()

    def take(self, *, wait: bool) -> list[Message]:
        """Return what has come; with ``wait`` at least one message, unless the input has ended."""
        found: list[Message] = []
        while not self.closed:
            try:
                message = self._waiting.get(block=wait and not found)
            except queue.Empty:
                break
            if message is None:
                self.closed = True
            else:
                found.append(message)
        return found

    def _read(self) -> None:
        for line in self._lines:
            self._waiting.put(json.loads(line))
        self._waiting.put(None)


class Worker:
    """Traces the newest request; everything else is dropped."""

    def __init__(self, folder: Path, inbox: Inbox, say: Say, engines: Engines) -> None:
        self._folder, self._free_slots = folder, list(range(SLOTS))
        self._inbox, self._say, self._engines = inbox, say, engines
        self._request: TraceRequest | None = None
        self._job: Job | None = None
        self._frames: Iterator[TracedFrame] | None = None
        self._newest: TracedFrame | None = None
        self._unsent: TracedFrame | None = None
        self._denoised = False
        self._paused = False
        self._samples = 0

    def run(self) -> None:
        while not self._inbox.closed:
            for message in self._inbox.take(wait=not self._has_work):
                self._take(message)
            if not self._inbox.closed and self._has_work:
                self._attempt(self._step)

    @property
    def _has_work(self) -> bool:
        opening = self._request is not None and self._job is None
        return opening or (self._frames is not None and not self._paused)

    def _take(self, message: Message) -> None:
        what = message["do"]
        if what == "render":
            self._request = request = TraceRequest.from_json(message)
            self._job = self._frames = self._newest = self._unsent = None
            self._paused, self._samples, self._denoised = False, request.samples, request.denoised
        elif what == "pause":
            self._paused = True
        elif what == "resume":
            self._paused, self._samples = False, int(message["samples"])
        elif what == "denoise":
            self._denoised = bool(message["on"])
            if self._newest is not None:
                self._attempt(lambda: self._report(self._newest))
        elif what == "taken":
            self._free_slots.append(int(message["slot"]))
            if self._unsent is not None:
                self._attempt(lambda: self._report(self._unsent))
        elif what == "save":
            self._save(Path(message["path"]), message)

    def _step(self) -> None:
        request = self._request
        assert request is not None
        if self._job is None:
            self._job = self._engines.open(request, self._moved)
            title, notices, no_denoiser = self._job.title, list(self._job.notices), self._job.no_denoiser
            self._answer("opened", title=title, notices=notices, no_denoiser=no_denoiser)
            self._frames = self._job.frames()
            return
        assert self._frames is not None
        frame = next(self._frames, None)
        if frame is None:
            self._frames = None
            return
        if self._samples and frame.samples >= self._samples:
            self._paused = True
        self._report(frame)

    def _report(self, frame: TracedFrame | None) -> None:
        self._newest = self._unsent = frame
        if frame is None or self._request is None or self._job is None or not self._free_slots:
            return
        denoised = self._denoised and not self._job.no_denoiser
        slot = self._free_slots[0]
        put(self._folder, slot, self._job.denoise_picture(frame.pixels) if denoised else frame.pixels)
        self._free_slots.pop(0)
        self._unsent = None
        height, width = frame.pixels.shape[:2]
        done = bool((self._samples and frame.samples >= self._samples) or frame.samples == frame.of)
        self._answer(
            "picture",
            slot=slot,
            size=[width, height],
            samples=frame.samples,
            of=self._samples or frame.of,
            noise=frame.noise,
            seconds=frame.seconds,
            done=done,
            denoised=denoised,
        )

    def _moved(self, fraction: float, what: str) -> None:
        self._answer("moved", fraction=fraction, what=what)

    def _answer(self, say: str, /, **facts: object) -> None:
        """Say what became of the present request."""
        generation = -1 if self._request is None else self._request.generation
        self._say({"say": say, "generation": generation, **facts})

    def _save(self, path: Path, message: Message) -> None:
        try:
            if self._job is None:
                raise SuiteError("There is no picture yet")
            self._job.save(path, view_from_json(message["view"]))
        except (SuiteError, MemoryError, OSError) as error:
            self._say({"say": "not_saved", "path": str(path), "text": _words(error)})
        else:
            self._say({"say": "saved", "path": str(path)})

    def _attempt(self, step: Callable[[], None]) -> None:
        """Do a step; a failure is reported and not tried again: the window asks anew where that makes sense."""
        try:
            step()
        except Exception as error:  # whatever went wrong, the user must hear of it
            if not isinstance(error, SuiteError | MemoryError | OSError):
                log.exception("internal error of the tracer")
            self._answer("failed", text=_words(error))
            self._request = self._job = self._frames = self._newest = self._unsent = None


def _words(error: BaseException) -> str:
    if isinstance(error, MemoryError):
        return "There is not enough memory for a picture of this size; make the window smaller."
    if isinstance(error, SuiteError | OSError):
        return str(error)
    return f"Internal error of the renderer: {type(error).__name__}: {error}"


def main(arguments: list[str] | None = None) -> int:
    """Trace until the input ends; return the exit status."""
    folder = Path((arguments or sys.argv[1:])[0])
    # What libraries print must not come between the answers.
    voice = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    if hasattr(os, "nice"):  # not on Windows
        os.nice(NICENESS)
    said = threading.Lock()

    def say(message: Message) -> None:
        with said:
            print(json.dumps(message), file=voice, flush=True)

    try:
        Worker(folder, Inbox(sys.stdin), say, Engines()).run()
    except BrokenPipeError:
        pass  # the window is gone, and nothing listens
    finally:
        shutil.rmtree(folder, ignore_errors=True)  # in the system's temporary folder, which is emptied anyway
    return 0


if __name__ == "__main__":
    sys.exit(main())
