"""The picture's light while it is edited: drafts follow the hand, the whole of it comes when the hand rests."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Qt, Signal

from brdf_suite.documents.studio import LightDocument
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.pipeline.scene import PreparedEnvironment, prepare_light
from brdf_suite.progress import Progress

REST_MS = 350
_DRAFT, _WHOLE = "draft", "whole"


class LiveLight(QObject):
    """Draws the newest light on threads and filters it for ``basis``.

    An edit does not stop a draft before it has shown something.

    Signals
    -------
    drawn(light, prepared)
        There is something to show of a light; drafts first, and environments of which maps are missing.
    failed(error)
        A light could not be drawn.
    moved(fraction, what), ended()
        Of the whole light, which takes seconds.
    """

    drawn = Signal(object, object)
    failed = Signal(object)
    moved = Signal(float, str)
    ended = Signal()
    _handed_out = Signal(int, object, object)

    def __init__(self, basis: LobeBasis, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._basis = basis
        self._runner = TaskRunner(self)
        self._newest: LightDocument | None = None
        self._drafted: LightDocument | None = None
        self._generation = 0
        self._drafting = False
        self._rest = make_timer(self, partial(self._make, _WHOLE), REST_MS)
        self._handed_out.connect(self._on_handed_out, Qt.ConnectionType.QueuedConnection)

    def show(self, light: LightDocument) -> None:
        """Draw this light; what is in work of an older one is finished only as far as it can be seen soon."""
        self._newest = light
        self._rest.stop()
        self._end_whole()
        if not self._drafting:
            self._make(_DRAFT)

    def stop(self) -> None:
        self._newest = None
        self._drafting = False
        self._generation += 1
        self._rest.stop()
        self._runner.cancel(_DRAFT)
        self._end_whole()

    def close(self) -> None:
        self.stop()
        self._runner.stop()

    def _make(self, key: str) -> None:
        self._drafting, self._drafted = key == _DRAFT, self._newest
        self._generation += 1
        # From the worker's thread to this one.
        hand_out = partial(self._handed_out.emit, self._generation, self._newest)
        self._runner.submit(
            key,
            _prepare,
            (self._newest, hand_out, key == _DRAFT, self._basis),
            done=partial(self._done, key),
            failed=partial(self._failed, key),
            progress=self.moved.emit if key == _WHOLE else None,
        )

    def _on_handed_out(self, generation: int, light: LightDocument, prepared: PreparedEnvironment) -> None:
        if generation != self._generation:
            return
        self.drawn.emit(light, prepared)
        if self._drafting and self._newest is not self._drafted:
            self._make(_DRAFT)  # takes the place of the one that runs

    def _done(self, key: str, prepared: PreparedEnvironment) -> None:
        self.drawn.emit(self._drafted, prepared)
        self._over(key)

    def _failed(self, key: str, error: Exception) -> None:
        self.failed.emit(error)
        self._over(key)

    def _over(self, key: str) -> None:
        if key == _WHOLE:
            self.ended.emit()
            return
        self._drafting = False
        if self._newest is None:
            return
        if self._newest is not self._drafted:
            self._make(_DRAFT)
        else:
            self._rest.start()

    def _end_whole(self) -> None:
        self._runner.cancel(_WHOLE)
        self.ended.emit()


def _prepare(
    request: tuple[LightDocument, Callable[[PreparedEnvironment], None], bool, LobeBasis], progress: Progress
) -> PreparedEnvironment:
    light, hand_out, draft, basis = request
    prepared = prepare_light(light, progress, hand_out, draft=draft, basis=basis)
    if not draft:
        _ = prepared.glint_lights  # found here, so that the first frame does not wait for them
    return prepared
