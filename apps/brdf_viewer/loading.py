"""Environments and surfaces are read on background threads; the picture stays as it was until they are there."""

from __future__ import annotations

from brdf_qt.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.statistics import EnvironmentStatistics, environment_statistics
from brdf_suite.pipeline.scene import PreparedEnvironment, load_environment, load_surface
from brdf_suite.progress import Progress
from brdf_suite.surface.mesh import Mesh

ENVIRONMENT = "environment"
SURFACE = "surface"
_STATISTICS = "statistics"


class SceneLoader(QObject):
    """Loads by packaged name or absolute path; per kind only the newest request counts.

    Signals
    -------
    loaded(kind, key, value)
        A :class:`PreparedEnvironment` or a :class:`Mesh`.
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
    failed = Signal(str, str, object)
    moved = Signal(str, float, str)
    ended = Signal(str)
    counted = Signal(str, object)

    def __init__(self, runner: TaskRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = runner
        self._stopped = False

    def load(self, kind: str, key: str, layout: str = "auto") -> None:
        """Begin to load ``key``; an older request of the kind is dropped. ``layout`` is of an environment's image."""
        if self._stopped:
            return
        self.moved.emit(kind, 0.0, "waiting")
        self._runner.submit(
            kind,
            _environment if kind == ENVIRONMENT else _surface,
            (key, layout) if kind == ENVIRONMENT else key,
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
        """Drop the request of the kind."""
        self._runner.cancel(kind)
        self.ended.emit(kind)

    def stop(self) -> None:
        """End all that runs, and begin no more."""
        self._stopped = True
        self._runner.stop()

    def _done(self, kind: str, key: str, value: object) -> None:
        self.ended.emit(kind)
        self.loaded.emit(kind, key, value)

    def _failed(self, kind: str, key: str, error: Exception) -> None:
        self.ended.emit(kind)
        self.failed.emit(kind, key, error)


def _environment(request: tuple[str, str], progress: Progress) -> PreparedEnvironment:
    key, layout = request
    return load_environment(key, progress, layout=layout)


def _statistics(environment: Environment, _progress: Progress) -> EnvironmentStatistics:
    return environment_statistics(environment)


def _surface(key: str, progress: Progress) -> Mesh:
    progress(0.0, "reading the surface")
    mesh = load_surface(key)
    progress(1.0, "reading the surface")
    return mesh
