"""Pictures of paints: from memory, from the disk, or drawn in a process of its own; only those that are requested.

A view requests the pictures that it shows, under a name of its own. Missing ones are looked up on the disk by a thread;
those not stored there are rendered by :mod:`brdf_suite.palettes.swatches.process`, the newest view's first. The window
never waits for them.

A paint over which that process dies is found by asking for one at a time, and is refused alone. That nothing can be
drawn is a verdict on a form in a light, and another form or light is tried anew.
"""

from __future__ import annotations

import base64
import json
import logging
from collections import OrderedDict
from collections.abc import Iterable, Sequence
from itertools import islice
from typing import Any, NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QProcess, QProcessEnvironment, Qt, Signal
from PySide6.QtGui import QImage, QPixmap

from brdf_qt.program.translation import tr
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.palette_store import entry_to_json
from brdf_suite.palettes.swatches.look import Content, SwatchLook, swatch_key
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress

log = logging.getLogger(__name__)

MOST_BYTES = 64 << 20
"""Of pictures in memory; those unused for longest go first."""
IDLE_MS = 120_000
"""A process that has had nothing to draw for so long is ended: it holds some 250 MB."""

_MODULE = "brdf_suite.palettes.swatches.process"
_BATCH = 16
_LOOKED_UP = 64
_LINES_A_TURN = 6
_PATIENCE_MS = 3_000
_MOST_DEATHS = 4
"""In a row, the last ones over single paints and no picture between: then it is not the paints."""
_MOST_KEYS = 50_000
_MOST_LATEST = 600


class _Wish(NamedTuple):
    content: Content
    look: SwatchLook
    size: int
    """Width and height on the screen, device pixels."""
    ratio: float


class Pictures(QObject):
    """The pictures of a window, and the process that draws them; it is started by the first that must be drawn.

    Signals
    -------
    arrived(keys)
        Pictures with these keys, a set, are there now or refused.
    unavailable(look, text)
        Nothing can be drawn of the form of a look in its light, and why.
    waiting_changed(count)
        How many of the requested are still to come.
    """

    arrived = Signal(object)
    unavailable = Signal(object, str)
    waiting_changed = Signal(int)

    def __init__(self, parent: QObject | None = None, program: Sequence[str] | None = None) -> None:
        super().__init__(parent)
        self.program = [*(program or child_command(_MODULE))]
        """The command that draws; while it is empty, nothing is drawn."""
        self._tasks = TaskRunner(self, threads=1)
        self._process = QProcess(self)
        self._process.setStandardErrorFile(QProcess.nullDevice())
        # OpenBLAS's second thread would wait in a loop, on the processor that the window needs.
        environment = QProcessEnvironment.systemEnvironment()
        environment.insert("OPENBLAS_NUM_THREADS", "1")
        self._process.setProcessEnvironment(environment)
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._ended)
        self._process.errorOccurred.connect(self._not_started)
        self._store: Any = None
        self._keys: dict[tuple[int, int], tuple[Content, SwatchLook, str]] = {}
        self._kept: OrderedDict[str, QPixmap] = OrderedDict()
        self._bytes = 0
        self._latest: OrderedDict[int, tuple[Content, QPixmap]] = OrderedDict()
        self._refused: dict[str, str] = {}
        self._problems: dict[tuple[str, str], str] = {}
        self._wishes: dict[str, dict[str, _Wish]] = {}
        self._requested_places: dict[str, tuple[str, str]] = {}
        self._not_stored: set[str] = set()
        self._suspects: set[str] = set()
        self._in_process: dict[str, _Wish] = {}
        self._look_in_process = SwatchLook()
        self._reading_store = self._ending = self._closed = False
        self._deaths = self.request_number = self._waiting = 0
        self._fresh: set[str] = set()
        self._pump_timer = make_timer(self, self._pump)
        self._arrival_timer = make_timer(self, self._emit_arrived, 16)
        self._lines_timer = make_timer(self, self._read)
        self._idle_timer = make_timer(self, self._end_process, IDLE_MS)

    def request(
        self,
        owner: str,
        contents: Iterable[Content],
        look: SwatchLook,
        size: float | None = None,
        ratio: float = 1.0,
    ) -> None:
        """Request pictures, the first ones first; the earlier request of the same ``owner`` is dropped.

        They are scaled to ``size`` points of a screen with ``ratio`` device pixels to a point; None: as drawn.
        """
        place = _place(look)
        if self._requested_places.get(owner) != place:
            self._requested_places[owner] = place
            self._problems.pop(place, None)
            self._deaths = 0
        self._wishes.pop(owner, None)
        wishes = self._wishes[owner] = {}
        pixels = look.size if size is None else round(size * ratio)
        for content in contents:
            key = self.key(content, look)
            if key not in self._kept and key not in self._refused:
                wishes.setdefault(key, _Wish(content, look, pixels, ratio))
        self._note_waiting()
        self._pump_timer.start()

    def key(self, content: Content, look: SwatchLook) -> str:
        """Return what :attr:`arrived` reports for the picture of a paint: one for all paints that look the same."""
        found = self._keys.get((id(content), id(look)))
        if found is None or found[0] is not content or found[1] is not look:
            if len(self._keys) > _MOST_KEYS:
                self._keys.clear()
            found = self._keys[id(content), id(look)] = (content, look, swatch_key(content, look))
        return found[2]

    def picture(self, content: Content, look: SwatchLook) -> QPixmap | None:
        """Return the picture of a paint; None while it is not there."""
        key = self.key(content, look)
        if key in self._kept:
            self._kept.move_to_end(key)
        return self._kept.get(key)

    def latest(self, content: Content) -> QPixmap | None:
        """Return the picture of a paint, in any look, that arrived last."""
        found = self._latest.get(id(content))
        return found[1] if found is not None and found[0] is content else None

    def is_settled(self, content: Content, look: SwatchLook) -> bool:
        """Whether the picture is there, or never will be."""
        key = self.key(content, look)
        return key in self._kept or key in self._refused or bool(self.problem(look))

    def refusal(self, content: Content, look: SwatchLook) -> str:
        """Return why there is no picture of a paint; empty where there is or may be one."""
        return self._refused.get(self.key(content, look), "")

    def problem(self, look: SwatchLook) -> str:
        """Return the text of :attr:`unavailable` for the form and light of a look; empty while it can be drawn."""
        return self._problems.get(_place(look), "")

    @property
    def waiting(self) -> int:
        """How many of the requested pictures are still to come."""
        return 0 if self._closed else len(self._open_wishes())

    def close(self) -> None:
        """End process and thread; nothing is drawn any more."""
        self._closed = True
        for timer in (self._pump_timer, self._arrival_timer, self._lines_timer, self._idle_timer):
            timer.stop()
        self._tasks.stop()
        if self._store is not None:
            self._store.close()
        if self._process.state() != QProcess.ProcessState.NotRunning:
            # What it has drawn is kept already, and it may be in the middle of a picture.
            self._process.kill()
            self._process.waitForFinished(_PATIENCE_MS)

    # From disk, or drawn.

    def _open_wishes(self) -> dict[str, _Wish]:
        """What can still come, the newest owner's first."""
        return {
            key: wish
            for wishes in reversed(self._wishes.values())
            for key, wish in wishes.items()
            if not self.problem(wish.look)
        }

    def _pump(self) -> None:
        if self._closed:
            return
        wishes = self._open_wishes()
        if not self._reading_store:
            unknown = [(key, wish) for key, wish in wishes.items() if key not in self._not_stored]
            if unknown:
                self._reading_store = True
                asked = dict(unknown[:_LOOKED_UP])
                self._tasks.submit("store", self._look_up, asked, self._found, self._not_found)
        if not self.program or self._in_process or self._ending:
            return
        ready = {key: wish for key, wish in wishes.items() if key in self._not_stored}
        if ready:
            # Over one of these the process has died: alone it is known which.
            alone = [key for key in ready if key in self._suspects][:1]
            look = next(iter(ready.values())).look
            batch = alone or list(islice((key for key, wish in ready.items() if wish.look == look), _BATCH))
            self._idle_timer.stop()
            self._send_request({key: ready[key] for key in batch})
        elif not wishes:
            self._idle_timer.start()

    def _look_up(
        self, wishes: dict[str, _Wish], _progress: Progress
    ) -> tuple[dict[str, _Wish], dict[str, np.ndarray]]:
        if self._store is None:
            from brdf_suite.palettes.swatches.store import SwatchStore

            self._store = SwatchStore()
        return wishes, self._store.get(wishes)

    def _found(self, answer: tuple[dict[str, _Wish], dict[str, np.ndarray]]) -> None:
        self._reading_store = False
        wishes, pictures = answer
        self._not_stored.update(wishes.keys() - pictures.keys())
        for key, pixels in pictures.items():
            self._keep(key, wishes[key], np.ascontiguousarray(pixels).tobytes())
        self._pump()

    def _not_found(self, error: Exception) -> None:
        # The store reports no error that matters; whatever this is, the pictures are rendered instead.
        log.error("The pictures on the disk cannot be looked through.", exc_info=error)
        self._reading_store = False
        self._not_stored.update(self._open_wishes())
        self._pump()

    def _send_request(self, batch: dict[str, _Wish]) -> None:
        self._in_process = batch
        self.request_number += 1
        look = self._look_in_process = next(iter(batch.values())).look
        items = [{**entry_to_json(Entry(wish.content)), "key": key} for key, wish in batch.items()]
        request = {"id": self.request_number, "look": look.to_json(), "items": items}
        if self._process.state() == QProcess.ProcessState.NotRunning:
            self._process.start(self.program[0], self.program[1:])
        if self._in_process:  # starting may have failed at once because there is no such program
            self._process.write(json.dumps(request).encode("utf-8") + b"\n")

    def _read(self) -> None:
        for _ in range(_LINES_A_TURN):
            if self._closed or not self._process.canReadLine():
                return
            self.receive(json.loads(bytes(self._process.readLine().data())))
        # The rest in a later turn, so that a scroll step comes between.
        self._lines_timer.start()

    def receive(self, answer: dict[str, Any]) -> None:
        """Take an answer of the rendering process; what it says of an earlier request is ignored."""
        if answer.get("id") != self.request_number:
            return
        key = str(answer.get("key", ""))
        wish = self._in_process.pop(key, None)
        if wish is not None:
            self._deaths = 0
            self._suspects.discard(key)
            if "picture" in answer:
                self._keep(key, wish, base64.b64decode(answer["picture"]))
                return
            if "fault" in answer:
                log.error("A picture could not be drawn.\n%s", answer["fault"])
            self._refuse(key, str(answer["refused"]))
        elif "failed" in answer or "unavailable" in answer:
            self.give_up(self._look_in_process, str(answer.get("failed") or answer.get("unavailable")))
        if "done" in answer or "failed" in answer:
            self._in_process = {}
            self._pump()

    def _refuse(self, key: str, why: str) -> None:
        self._refused[key] = why
        self._settle(key)

    def _keep(self, key: str, wish: _Wish, data: bytes) -> None:
        size = round((len(data) / 3) ** 0.5)
        image = QImage(data, size, size, 3 * size, QImage.Format.Format_RGB888)
        if wish.size != size:
            image = image.scaled(
                wish.size,
                wish.size,
                Qt.AspectRatioMode.IgnoreAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
        pixmap = QPixmap.fromImage(image.convertToFormat(QImage.Format.Format_RGB32))
        pixmap.setDevicePixelRatio(wish.ratio)
        before = self._kept.pop(key, None)
        if before is not None:
            self._bytes -= _bytes(before)
        self._kept[key] = pixmap
        self._bytes += _bytes(pixmap)
        while self._bytes > MOST_BYTES and len(self._kept) > 1:
            self._bytes -= _bytes(self._kept.popitem(last=False)[1])
        self._latest[id(wish.content)] = (wish.content, pixmap)
        while len(self._latest) > _MOST_LATEST:
            self._latest.popitem(last=False)
        self._settle(key)

    def _settle(self, key: str) -> None:
        for wishes in self._wishes.values():
            wishes.pop(key, None)
        self._not_stored.discard(key)
        self._fresh.add(key)
        if not self._arrival_timer.isActive():
            self._arrival_timer.start()

    def _emit_arrived(self) -> None:
        fresh, self._fresh = self._fresh, set()
        self._note_waiting()
        self.arrived.emit(fresh)

    def _note_waiting(self) -> None:
        waiting = self.waiting
        if waiting != self._waiting:
            self._waiting = waiting
            self.waiting_changed.emit(waiting)

    # The process.

    def _ended(self, *_: object) -> None:
        while not self._closed and self._process.canReadLine():
            self.receive(json.loads(bytes(self._process.readLine().data())))
        if self._closed:
            return
        self._ending = False
        if self._in_process and not self.problem(self._look_in_process):
            self._deaths += 1
            if self._deaths >= _MOST_DEATHS:
                why = tr("The rendering process ended repeatedly. Choose another form or light.")
                self.give_up(self._look_in_process, why)
            elif self._in_process.keys() <= self._suspects:
                for key in self._in_process:
                    self._refuse(key, tr("The rendering process ended while rendering this paint."))
            self._suspects.update(self._in_process)
        self._in_process = {}
        self._pump_timer.start()

    def _not_started(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            why = self._process.errorString()
            self._in_process = {}
            self.give_up(
                self._look_in_process, tr("The pictures cannot be rendered: {reason}.").format(reason=why)
            )
            self._pump_timer.start()

    def give_up(self, look: SwatchLook, why: str) -> None:
        """Stop rendering the form of a look in its light, and report the reason."""
        self._problems[_place(look)] = why
        self._deaths = 0
        self._note_waiting()
        self.unavailable.emit(look, why)

    def _end_process(self) -> None:
        """End a process that has had nothing to do for a while; it ends when its input does."""
        if self._process.state() != QProcess.ProcessState.NotRunning:
            self._ending = True
            self._process.closeWriteChannel()


def _place(look: SwatchLook) -> tuple[str, str]:
    return look.form, look.environment


def _bytes(pixmap: QPixmap) -> int:
    return 4 * pixmap.width() * pixmap.height()
