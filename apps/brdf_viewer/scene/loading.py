"""Environments and surfaces are read on background threads; the picture stays as it was until they are there.

An environment comes in steps: as soon as its broad lobes are there it is handed out as it is then, and sharpens as
its maps are filtered, at most every two seconds.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from time import monotonic

from brdf_qt.work.tasks import TaskRunner, Work
from PySide6.QtCore import QObject, Qt, Signal

from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.statistics import EnvironmentStatistics, environment_statistics
from brdf_suite.pipeline.scene import Partial, PreparedEnvironment, load_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import Progress
from brdf_suite.surface.mesh import Mesh

ENVIRONMENT = "environment"
SURFACE = "surface"
_STATISTICS = "statistics"
_BETWEEN_PARTIAL_S = 2.0
"""Each step that is shown costs a frame: on a software renderer as long as filtering the next map."""


@dataclass(frozen=True)
class EnvironmentRequest:
    """What a worker is to read, and what it calls as soon as there is something to show."""

    key: str
    layout: str
    partial: Partial


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
    counted(key, statistics)
        The figures of an environment that was given to :meth:`count`.
    """

    loaded = Signal(str, str, object)
    partly_loaded = Signal(str, object)
    failed = Signal(str, str, object)
    moved = Signal(str, float, str)
    ended = Signal(str)
    counted = Signal(str, object)
    partly_made = Signal(int, str, object)

    def __init__(self, runner: TaskRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = runner
        self._stopped = False
        self.generation = 0
        self.partly_made.connect(self._on_partial, Qt.ConnectionType.QueuedConnection)

    def load(self, kind: str, key: str, layout: str = "auto", look: SurfaceLook | None = None) -> None:
        """Begin to load ``key``; an older request of the kind is dropped.

        ``layout`` is of an environment's image, ``look`` the shape in which a surface is taken.
        """
        if self._stopped:
            return
        if kind == ENVIRONMENT:
            self.generation += 1
            generation = self.generation

            shown = -math.inf

            def partial(value: PreparedEnvironment) -> None:
                nonlocal shown
                if monotonic() - shown >= _BETWEEN_PARTIAL_S:
                    shown = monotonic()
                    self.partly_made.emit(generation, key, value)  # from the worker's thread to this one

            self._submit(kind, key, prepare_environment, EnvironmentRequest(key, layout, partial))
        else:
            self._submit(kind, key, _surface, (key, look or SurfaceLook()))

    def _submit(self, kind: str, key: str, work: Work, request: object) -> None:
        self.moved.emit(kind, 0.0, "waiting")
        self._runner.submit(
            kind,
            work,
            request,
            done=lambda value: self._done(kind, key, value),
            failed=lambda error: self._failed(kind, key, error),
            progress=lambda fraction, what: self.moved.emit(kind, fraction, what),
        )

    def count(self, key: str, environment: Environment) -> None:
        """Begin to count an environment's figures; those of an older one are dropped."""
        if not self._stopped:
            self._runner.submit(
                _STATISTICS,
                _statistics,
                environment,
                done=lambda value: self.counted.emit(key, value),
                failed=lambda error: self.failed.emit(ENVIRONMENT, key, error),
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

    def _done(self, kind: str, key: str, value: object) -> None:
        self.ended.emit(kind)
        self.loaded.emit(kind, key, value)

    def _failed(self, kind: str, key: str, error: Exception) -> None:
        self.ended.emit(kind)
        self.failed.emit(kind, key, error)


def prepare_environment(request: EnvironmentRequest, progress: Progress) -> PreparedEnvironment:
    """Return an environment with its filtered maps and glint lights, for a worker."""
    prepared = load_environment(request.key, progress, layout=request.layout, partial=request.partial)
    _ = prepared.glint_lights  # found here, so that the first frame does not wait for them
    return prepared


def _statistics(environment: Environment, _progress: Progress) -> EnvironmentStatistics:
    return environment_statistics(environment)


def _surface(request: tuple[str, SurfaceLook], progress: Progress) -> Mesh:
    return load_shaped(*request, progress)
