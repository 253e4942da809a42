"""Environments and surfaces are read on background threads; the picture stays as it was until they are there.

An environment comes in steps: as soon as its broad lobes are there it is handed out as it is then, and sharpens as
its maps are filtered, at most every two seconds.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from time import monotonic

from PySide6.QtCore import QObject, Qt, Signal

from brdf_qt.work.tasks import TaskRunner
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.statistics import environment_statistics
from brdf_suite.pipeline.scene import Partial, PreparedEnvironment, load_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import Progress
from brdf_suite.surface.mesh import Mesh

ENVIRONMENT = "environment"
SURFACE = "surface"
_STATISTICS = "statistics"
_BETWEEN_PARTIAL_S = 2.0
"""Each step that is shown costs a frame: on a software renderer as long as filtering the next map."""


class SceneLoader(QObject):
    """Loads by packaged name or absolute path; per kind only the newest request counts.

    Signals
    -------
    loaded(kind, key, value)
        A :class:`PreparedEnvironment` or a :class:`Mesh`.
    partly_loaded(key, environment)
        A :class:`PreparedEnvironment` that can be shown, of which sharp maps are missing; the whole one follows.
    failed(kind, key, error)
        It could not be read.
    moved(kind, fraction, what)
        How far it is; the first comes at once with fraction 0.
    ended(kind)
        Loaded, failed or cancelled.
    counted(environment, statistics)
        The figures of an environment that was given to :meth:`count`.
    """

    loaded = Signal(str, str, object)
    partly_loaded = Signal(str, object)
    failed = Signal(str, str, object)
    moved = Signal(str, float, str)
    ended = Signal(str)
    counted = Signal(object, object)
    partly_made = Signal(int, str, object)

    def __init__(self, runner: TaskRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = runner
        self._stopped = False
        self.generation = 0
        self.partly_made.connect(self._on_partial, Qt.ConnectionType.QueuedConnection)

    def load(
        self,
        kind: str,
        key: str,
        layout: str = "auto",
        look: SurfaceLook | None = None,
        basis: LobeBasis | None = None,
    ) -> None:
        """Begin to load ``key``; an older request of the kind is dropped.

        ``layout`` is of an environment's image, ``basis`` what it is filtered for, ``look`` the shape in which a
        surface is taken.
        """
        if self._stopped:
            return
        request: tuple[object, ...] = (key, look or SurfaceLook())
        if kind == ENVIRONMENT:
            self.generation += 1
            request = (key, layout, self._hand_out(self.generation, key), basis)
        self.moved.emit(kind, 0.0, "waiting")
        self._runner.submit(
            kind,
            prepare_environment if kind == ENVIRONMENT else _load_surface,
            request,
            done=lambda value: self._end(kind, partial(self.loaded.emit, kind, key, value)),
            failed=lambda error: self._end(kind, partial(self.failed.emit, kind, key, error)),
            progress=partial(self.moved.emit, kind),
        )

    def _hand_out(self, generation: int, key: str) -> Partial:
        """Return what a worker calls with what there is of an environment; not each time is passed on."""
        shown = -math.inf

        def hand_out(value: PreparedEnvironment) -> None:
            nonlocal shown
            if monotonic() - shown >= _BETWEEN_PARTIAL_S:
                shown = monotonic()
                self.partly_made.emit(generation, key, value)  # from the worker's thread to this one

        return hand_out

    def count(self, key: str, environment: Environment) -> None:
        """Begin to count an environment's figures; those of an older one are dropped."""
        if not self._stopped:
            self._runner.submit(
                _STATISTICS,
                lambda environment, _progress: environment_statistics(environment),
                environment,
                done=partial(self.counted.emit, environment),
                failed=partial(self.failed.emit, ENVIRONMENT, key),
            )

    def cancel(self, kind: str) -> None:
        """Drop the request of the kind, and what it has handed out but is not yet taken."""
        if kind == ENVIRONMENT:
            self.generation += 1
        self._runner.cancel(kind)
        self.ended.emit(kind)

    def stop(self) -> None:
        """End all that runs, and begin no more."""
        self._stopped = True
        self.generation += 1
        self._runner.stop()

    def _on_partial(self, generation: int, key: str, value: PreparedEnvironment) -> None:
        if generation == self.generation:
            self.partly_loaded.emit(key, value)

    def _end(self, kind: str, report: Callable[[], None]) -> None:
        self.ended.emit(kind)
        report()


def prepare_environment(
    request: tuple[str, str, Partial, LobeBasis | None], progress: Progress
) -> PreparedEnvironment:
    """Return an environment with its filtered maps and glint lights, for a worker."""
    key, layout, hand_out, basis = request
    prepared = load_environment(key, progress, layout=layout, basis=basis, partial=hand_out)
    _ = prepared.glint_lights  # found here, so that the first frame does not wait for them
    return prepared


def _load_surface(request: tuple[str, SurfaceLook], progress: Progress) -> Mesh:
    return load_shaped(*request, progress)
