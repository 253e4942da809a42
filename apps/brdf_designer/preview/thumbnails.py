"""Small pictures of paints by the real renderer, drawn in a process of their own and kept.

A client requests pictures under a name of its own (``owner``); a newer list takes the place of what of the
older one is not drawn yet, so nothing is drawn that is no longer requested. Until a picture is there, a disc of the
paint's readings stands in for it.
"""

from __future__ import annotations

import base64
import json
from collections import OrderedDict
from collections.abc import Sequence
from typing import Any

from brdf_qt.program.translation import tr
from PySide6.QtCore import QCoreApplication, QObject, QProcess, QTimer, Signal
from PySide6.QtGui import QImage

from brdf_designer.preview.thumbnail_placeholder import placeholder
from brdf_designer.preview.thumbnail_scene import SIZE, USUAL_SCENE, ThumbnailScene, paint_key
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.processes import child_command

__all__ = ["SIZE", "ThumbnailScene", "Thumbnails", "paint_key", "thumbnails_of"]

MOST_KEPT = 600
"""Pictures are 64 kB each."""
IDLE_MS = 120_000
"""A process that has had nothing to draw for so long is ended: it holds some 250 MB."""

_PATIENCE_MS = 3_000
_MOST_DEATHS = 2
_MODULE = "brdf_designer.preview.thumbnails_process"

_Wish = tuple[str, Paint, ThumbnailScene]


class Thumbnails(QObject):
    """The pictures, and the process that draws them; it is started by the first request.

    Signals
    -------
    ready(str, QImage)
        The picture of a key is drawn.
    failed(str, str)
        There is no such paint: its key, and why.
    unavailable(str)
        Nothing can be drawn on this machine; with the message for the user. Placeholders stay.
    busy_changed(bool)
        Whether pictures are still to come.
    """

    ready = Signal(str, QImage)
    failed = Signal(str, str)
    unavailable = Signal(str)
    busy_changed = Signal(bool)

    def __init__(self, parent: QObject | None = None, program: Sequence[str] | None = None) -> None:
        super().__init__(parent)
        self.program = [*(program or child_command(_MODULE))]
        """What draws the pictures; while it is empty, placeholders stand for them."""
        self._process = QProcess(self)
        self._process.setStandardErrorFile(QProcess.nullDevice())
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._ended)
        self._process.errorOccurred.connect(self._not_started)
        self._ending = False
        self._wishes: dict[str, list[_Wish]] = {}
        self._drawn: OrderedDict[str, QImage] = OrderedDict()
        self._stand_ins: OrderedDict[str, QImage] = OrderedDict()
        self._refused: dict[str, str] = {}
        self._asked: str | None = None
        self._deaths = 0
        self._reason = ""
        self._busy = False
        self._closed = False
        self._idle = QTimer(self, singleShot=True, interval=IDLE_MS)
        self._idle.timeout.connect(self._rest)
        self._pump = QTimer(self, singleShot=True, interval=0)
        self._pump.timeout.connect(self._ask_next)
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.close)

    def request(self, owner: str, paints: Sequence[Paint], scene: ThumbnailScene = USUAL_SCENE) -> None:
        """Have pictures drawn, the first one first; ``owner``'s older list is forgotten."""
        self._wishes[owner] = [(paint_key(paint, scene), paint, scene) for paint in paints]
        self._note_busy()
        self._pump.start()

    def picture(self, paint: Paint, scene: ThumbnailScene = USUAL_SCENE) -> QImage:
        """Return the picture of a paint where it is drawn, and its placeholder where it is not."""
        key = paint_key(paint, scene)
        if key in self._drawn:
            self._drawn.move_to_end(key)
            return self._drawn[key]
        if key not in self._stand_ins:
            self._stand_ins[key] = placeholder(paint, SIZE)
            _trim(self._stand_ins)
        return self._stand_ins[key]

    def is_drawn(self, paint: Paint, scene: ThumbnailScene = USUAL_SCENE) -> bool:
        """Return whether the picture is ready."""
        return paint_key(paint, scene) in self._drawn

    def refusal(self, paint: Paint, scene: ThumbnailScene = USUAL_SCENE) -> str:
        """Return why there is no picture of a paint; empty where there is one, or none was asked for yet."""
        return self._refused.get(paint_key(paint, scene), "")

    @property
    def problem(self) -> str:
        """The reason of :attr:`unavailable`; empty while pictures can be drawn."""
        return self._reason

    def close(self) -> None:
        """End the process; nothing is drawn any more."""
        self._closed = True
        self._wishes.clear()
        self._pump.stop()
        self._idle.stop()
        if self._process.state() != QProcess.ProcessState.NotRunning:
            # It keeps nothing that would be lost, and may be in the middle of a picture.
            self._process.kill()
            self._process.waitForFinished(_PATIENCE_MS)
        self._note_busy()

    # The process.

    def _next(self) -> _Wish | None:
        """The newest owner's first picture that is not there."""
        for owner in reversed(list(self._wishes)):
            for wish in self._wishes[owner]:
                if wish[0] not in self._drawn and wish[0] not in self._refused:
                    return wish
        return None

    def _note_busy(self) -> None:
        busy = not self._closed and not self._reason and (self._asked is not None or self._next() is not None)
        if busy != self._busy:
            self._busy = busy
            self.busy_changed.emit(busy)

    def _ask_next(self) -> None:
        if not self.program or self._closed or self._reason or self._ending or self._asked is not None:
            return
        wish = self._next()
        if wish is None:
            self._note_busy()
            self._idle.start()
            return
        self._idle.stop()
        key, paint, scene = wish
        self._asked = key
        request = {
            "key": key,
            "paint": paint_to_json(paint),
            "environment": scene.environment,
            "surface": scene.surface,
        }
        if self._process.state() == QProcess.ProcessState.NotRunning:
            self._process.start(self.program[0], self.program[1:])
        if self._asked is not None:  # starting may have failed at once because there is no such program
            # Kept for it also while it is still starting.
            self._process.write(json.dumps(request).encode("utf-8") + b"\n")

    def _read(self) -> None:
        while self._process.canReadLine():
            self._take(json.loads(bytes(self._process.readLine().data())))

    def _take(self, answer: dict[str, Any]) -> None:
        if "unavailable" in answer:
            self._give_up(str(answer["unavailable"]))
            return
        key = str(answer["key"])
        self._asked = None
        self._deaths = 0
        if "picture" in answer:
            pixels = base64.b64decode(answer["picture"])
            image = QImage(pixels, SIZE, SIZE, 3 * SIZE, QImage.Format.Format_RGB888)
            self._drawn[key] = image.convertToFormat(QImage.Format.Format_RGB32)
            self._stand_ins.pop(key, None)
            _trim(self._drawn)
            self.ready.emit(key, self._drawn[key])
        else:
            self._refused[key] = str(answer["refused"])
            self.failed.emit(key, self._refused[key])
        self._note_busy()
        self._ask_next()

    def _ended(self, *_: object) -> None:
        self._read()
        meant, self._ending = self._ending, False
        if self._closed or self._reason:
            return
        if not meant and self._asked is not None:
            self._asked = None
            self._deaths += 1
            if self._deaths >= _MOST_DEATHS:
                self._give_up(tr("The thumbnail process ended twice."))
                return
        self._pump.start()

    def _not_started(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            why = self._process.errorString()
            self._give_up(tr("The thumbnails cannot be drawn: {reason}.").format(reason=why))

    def _give_up(self, why: str) -> None:
        self._asked = None
        self._reason = why
        self._note_busy()
        self.unavailable.emit(why)

    def _rest(self) -> None:
        """End a process that has had nothing to do for a while; it ends when its input does."""
        if self._process.state() != QProcess.ProcessState.NotRunning:
            self._ending = True
            self._process.closeWriteChannel()


def _trim(kept: OrderedDict[str, QImage]) -> None:
    while len(kept) > MOST_KEPT:
        kept.popitem(last=False)


def thumbnails_of(window: QObject) -> Thumbnails:
    """Return the one of a window; it is made at the first call and goes with the window."""
    found = window.findChild(Thumbnails)
    return Thumbnails(window) if found is None else found
