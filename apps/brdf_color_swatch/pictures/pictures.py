"""Pictures of swatches: from memory, from the disk, or drawn in a process of its own; only those that are seen.

A view requests the pictures that it paints. Missing ones are looked up on the disk by a thread; those not stored there
are rendered by :mod:`brdf_suite.palettes.swatches.process`, newest requests first. The window never waits for them.

A paint over which that process dies is found by asking for one at a time, and is refused alone. That nothing can be
drawn is a verdict on a form in a light, and another form or light is tried anew.
"""

from __future__ import annotations

import base64
import json
import logging
from collections import OrderedDict
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from brdf_qt.program.translation import tr
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, QProcess, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QPixmap

from brdf_suite.documents.palette import Entry
from brdf_suite.documents.palette_store import entry_to_json
from brdf_suite.palettes.swatches.look import SwatchLook, swatch_key
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress

log = logging.getLogger(__name__)

MOST_BYTES = 64 << 20
"""Of pictures in memory; those unused for longest go first."""
LADDER = (32, 48, 64, 96, 128, 192, 256, 320, 384, 512)
"""Sizes that are drawn: a drag of the size slider scales what is there, and draws at few of its steps."""

_MODULE = "brdf_suite.palettes.swatches.process"
_BATCH = 16
_LOOKED_UP = 64
_LINES_A_TURN = 6
_PATIENCE_MS = 3_000
_MOST_DEATHS = 4
"""In a row, the last ones over single paints and no picture between: then it is not the paints."""
_MOST_KEYS = 50_000


class Pictures(QObject):
    """The pictures of one look.

    Signals
    -------
    arrived(entry ids)
        Pictures of these are there now; a set of ids.
    unavailable(text)
        Nothing can be drawn of this form in this light, and why. The readings stand for the pictures.
    waiting_changed(count)
        How many of the requested are still to come.
    """

    arrived = Signal(object)
    unavailable = Signal(str)
    waiting_changed = Signal(int)

    def __init__(self, parent: QObject | None = None, program: Sequence[str] | None = None) -> None:
        super().__init__(parent)
        self._program = [*(program or child_command(_MODULE))]
        self._tasks = TaskRunner(self, threads=1)
        self._process = QProcess(self)
        self._process.setStandardErrorFile(QProcess.nullDevice())
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._ended)
        self._process.errorOccurred.connect(self._not_started)
        self._store: Any = None
        self._look: Any = None
        self._shown_size = 0
        self._ratio = 1.0
        self._keys: dict[int, tuple[object, str]] = {}
        self._kept: OrderedDict[str, QPixmap] = OrderedDict()
        self._bytes = 0
        self._last: OrderedDict[int, tuple[object, QPixmap]] = OrderedDict()
        self._refused: dict[str, str] = {}
        self._not_stored: set[str] = set()
        self._suspects: set[str] = set()
        self._pending: dict[str, Entry] = {}
        self._ids: dict[str, list[str]] = {}
        self._in_process: set[str] = set()
        self._reading_store = self._closed = False
        self._deaths = self.request_number = 0
        self._problem = ""
        self._waiting = 0
        self._fresh: set[str] = set()
        self._pump_timer = self._timer(0, self._pump)
        self._arrival_timer = self._timer(16, self._emit_arrived)
        self._lines_timer = self._timer(0, self._read)

    def _timer(self, interval_ms: int, act: Callable[[], None]) -> QTimer:
        timer = QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(interval_ms)
        timer.timeout.connect(act)
        return timer

    # What is asked.

    def set_look(self, form: str, light: str, size: int, ratio: float) -> None:
        """Say how pictures are to look; ``size`` in pixels of the window, ``ratio`` device pixels to one of them."""
        # With it comes what knows environments: not before the first paint.
        wanted = round(size * ratio)
        drawn = next((step for step in LADDER if step >= wanted), LADDER[-1])
        look = SwatchLook(form=form, environment=light, size=drawn)  # type: ignore[arg-type]  # it checks it
        self._ratio = ratio
        if look == self._look and size == self._shown_size:
            return
        if self._look is None or (look.form, look.environment) != (self._look.form, self._look.environment):
            self._problem, self._deaths = "", 0
        if look != self._look:
            self._keys.clear()
            self._not_stored.clear()
            self._suspects.clear()
            self._pending.clear()
            self._look = look
            self._in_process.clear()
            self.request_number += 1
        self._shown_size = size
        self._pump_timer.start()

    def picture(self, entry: Entry) -> QPixmap | None:
        """Return the picture of an entry; the one of the look before while the new one is not there; or none."""
        if self._look is None:
            return None
        found = self._kept.get(self._key(entry))
        if found is not None:
            self._kept.move_to_end(self._key(entry))
            return found
        before = self._last.get(id(entry.content))
        return before[1] if before is not None and before[0] is entry.content else None

    def is_stale(self, entry: Entry) -> bool:
        """Whether the picture is still to come."""
        if self._look is None:
            return not self._problem
        key = self._key(entry)
        return key not in self._kept and key not in self._refused and not self._problem

    def refusal(self, entry: Entry) -> str:
        """Return why there is no picture of an entry; empty where there is or may be one."""
        return "" if self._look is None else self._refused.get(self._key(entry), "")

    def request(self, entries: Iterable[Entry]) -> None:
        """Request pictures of these entries, the first ones first; earlier requests are dropped."""
        if self._look is None or self._closed or self._problem:
            return
        self._pending = {}
        self._ids = {}
        for entry in entries:
            key = self._key(entry)
            self._ids.setdefault(key, []).append(entry.id)
            if key not in self._kept and key not in self._refused:
                self._pending.setdefault(key, entry)
        self._note_waiting()
        self._pump_timer.start()

    @property
    def waiting(self) -> int:
        """How many of the requested pictures are still to come."""
        return 0 if self._problem or self._closed else len(self._pending)

    @property
    def problem(self) -> str:
        """The text of :attr:`unavailable`; empty while pictures can be drawn."""
        return self._problem

    def close(self) -> None:
        """End process and thread; nothing is drawn any more."""
        self._closed = True
        for timer in (self._pump_timer, self._arrival_timer, self._lines_timer):
            timer.stop()
        self._tasks.stop()
        if self._store is not None:
            self._store.close()
        if self._process.state() != QProcess.ProcessState.NotRunning:
            # What it has drawn is kept already, and it may be in the middle of a picture.
            self._process.kill()
            self._process.waitForFinished(_PATIENCE_MS)

    # From disk, or drawn.

    def _key(self, entry: Entry) -> str:
        content = entry.content
        found = self._keys.get(id(content))
        if found is not None and found[0] is content:
            return found[1]
        if len(self._keys) > _MOST_KEYS:
            self._keys.clear()
        key = swatch_key(content, self._look)
        self._keys[id(content)] = (content, key)
        return key

    def _pump(self) -> None:
        if self._closed or self._problem or self._look is None:
            return
        if not self._reading_store:
            keys = [key for key in self._pending if key not in self._not_stored][:_LOOKED_UP]
            if keys:
                self._reading_store = True
                self._tasks.submit("store", self._look_up, tuple(keys), self._found, self._not_found)
        if not self._in_process:
            ready = [(key, one) for key, one in self._pending.items() if key in self._not_stored]
            # Over one of these the process has died: alone it is known which.
            alone = [pair for pair in ready if pair[0] in self._suspects][:1]
            batch = alone or ready[:_BATCH]
            if batch:
                self._send_request(batch)

    def _look_up(
        self, keys: tuple[str, ...], _progress: Progress
    ) -> tuple[tuple[str, ...], dict[str, np.ndarray]]:
        if self._store is None:
            from brdf_suite.palettes.swatches.store import SwatchStore

            self._store = SwatchStore()
        return keys, self._store.get(keys)

    def _found(self, answer: tuple[tuple[str, ...], dict[str, np.ndarray]]) -> None:
        self._reading_store = False
        keys, pictures = answer
        for key in keys:
            if key in pictures:
                pixels = np.ascontiguousarray(pictures[key])
                self._keep(key, pixels.tobytes(), pixels.shape[0])
            else:
                self._not_stored.add(key)
        self._pump()

    def _not_found(self, error: Exception) -> None:
        # The store reports no error that matters; whatever this is, the pictures are rendered instead.
        log.error("The pictures on the disk cannot be looked through.", exc_info=error)
        self._reading_store = False
        self._not_stored.update(self._pending)
        self._pump()

    def _send_request(self, batch: list[tuple[str, Entry]]) -> None:
        items: list[dict[str, Any]] = []
        for key, entry in batch:
            content = entry_to_json(entry)
            item: dict[str, Any] = {name: content[name] for name in ("paint", "flat") if name in content}
            items.append({"key": key} | item)
        self._in_process = {key for key, _ in batch}
        request = {"id": self.request_number, "look": self._look.to_json(), "items": items}
        if self._process.state() == QProcess.ProcessState.NotRunning:
            self._process.start(self._program[0], self._program[1:])
        self._process.write(json.dumps(request).encode("utf-8") + b"\n")

    def _read(self) -> None:
        for _ in range(_LINES_A_TURN):
            if self._closed or not self._process.canReadLine():
                return
            self.receive(json.loads(bytes(self._process.readLine().data())))
        # The rest in a later turn, so that a scroll step comes between.
        self._lines_timer.start()

    def receive(self, answer: dict[str, Any]) -> None:
        """Take an answer of the rendering process; late ones of a former look are ignored."""
        key = str(answer.get("key", ""))
        if "picture" in answer:
            self._mark_alive(key)
            data = base64.b64decode(answer["picture"])
            self._keep(key, data, round((len(data) / 3) ** 0.5))
        elif "refused" in answer:
            self._mark_alive(key)
            if "fault" in answer:
                log.error("A picture could not be drawn.\n%s", answer["fault"])
            self._refuse(key, str(answer["refused"]))
        elif answer.get("id") != self.request_number:
            # The end of what was asked for a look that is shown no more; it says nothing of this one.
            self._pump()
        elif "failed" in answer or "unavailable" in answer:
            self.give_up(str(answer.get("failed") or answer.get("unavailable")))
        elif "done" in answer:
            self._in_process.clear()
            self._pump()

    def _mark_alive(self, key: str) -> None:
        self._deaths = 0
        self._suspects.discard(key)

    def _refuse(self, key: str, why: str) -> None:
        self._refused[key] = why
        self._pending.pop(key, None)
        self._fresh.update(self._ids.get(key, ()))
        self._arrival_timer.start()

    def _keep(self, key: str, data: bytes, size: int) -> None:
        image = QImage(data, size, size, 3 * size, QImage.Format.Format_RGB888)
        target = round(self._shown_size * self._ratio)
        if target != size:
            image = image.scaled(
                target,
                target,
                Qt.AspectRatioMode.IgnoreAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
        pixmap = QPixmap.fromImage(image.convertToFormat(QImage.Format.Format_RGB32))
        pixmap.setDevicePixelRatio(self._ratio)
        before = self._kept.pop(key, None)
        if before is not None:
            self._bytes -= _bytes(before)
        self._kept[key] = pixmap
        self._bytes += _bytes(pixmap)
        while self._bytes > MOST_BYTES and len(self._kept) > 1:
            self._bytes -= _bytes(self._kept.popitem(last=False)[1])
        entry = self._pending.pop(key, None)
        if entry is not None:
            self._last[id(entry.content)] = (entry.content, pixmap)
            while len(self._last) > 600:
                self._last.popitem(last=False)
        self._fresh.update(self._ids.get(key, ()))
        if not self._arrival_timer.isActive():
            self._arrival_timer.start()

    def _emit_arrived(self) -> None:
        fresh, self._fresh = self._fresh, set()
        self._note_waiting()
        if fresh:
            self.arrived.emit(fresh)

    def _note_waiting(self) -> None:
        if self.waiting != self._waiting:
            self._waiting = self.waiting
            self.waiting_changed.emit(self._waiting)

    # The process.

    def _ended(self, *_: object) -> None:
        if self._closed or self._problem:
            return
        while self._process.canReadLine():
            self.receive(json.loads(bytes(self._process.readLine().data())))
        if self._problem:
            return
        unanswered = {key for key in self._in_process if key not in self._kept and key not in self._refused}
        self._in_process.clear()
        if unanswered:
            self._deaths += 1
            if self._deaths >= _MOST_DEATHS:
                self.give_up(tr("The rendering process ended repeatedly. Choose another form or light."))
                return
            if unanswered <= self._suspects:
                for key in unanswered:
                    self._refuse(key, tr("The rendering process ended while rendering this paint."))
            self._suspects.update(unanswered)
        self._pump_timer.start()

    def _not_started(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self.give_up(
                tr("The swatches cannot be rendered: {reason}.").format(reason=self._process.errorString())
            )

    def give_up(self, why: str) -> None:
        """Stop rendering this form in this light, and report the reason."""
        self._problem = why
        self._pending.clear()
        self._in_process.clear()
        self._note_waiting()
        self.unavailable.emit(why)


def _bytes(pixmap: QPixmap) -> int:
    return 4 * pixmap.width() * pixmap.height()
