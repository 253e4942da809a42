"""Errors of every subject against the reference, computed on a thread."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Signal

from brdf_lobe_visualizer.session import LobeSession
from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.progress import Progress
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.inspection.figures.figures import Errors

_PAUSE_MS = 60
"""A drag changes a paint sixty times a second; its error follows a few times."""


@dataclass(frozen=True)
class ShownError:
    """An error beside a subject: root mean square of the differences over that of the reference, and mean ΔE00.

    ``delta_e`` is over the angles of ASTM E2194 that both have; None where there is none.
    """

    errors: Errors
    delta_e: float | None


class LegendErrors(QObject):
    """Signals: ``changed()`` when an error is there, or none any more."""

    changed = Signal()

    def __init__(self, session: LobeSession, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._tasks = TaskRunner(self, threads=1)
        self._found: dict[str, ShownError] = {}
        self._working: set[str] = set()
        self._of: dict[str, tuple[Reflectance, Reflectance]] = {}
        self._pause = make_timer(self, self._look, _PAUSE_MS)
        session.subjects_changed.connect(self._touch)
        session.visibility_changed.connect(self._touch)

    @property
    def is_idle(self) -> bool:
        return not self._tasks.busy and not self._pause.isActive()

    def error(self, key: str) -> ShownError | None:
        """Return the error of a subject against the reference; None where none was chosen, or it is not there yet."""
        return self._found.get(key)

    def is_stale(self, key: str) -> bool:
        """Whether the error is of the subject or the reference as they were before."""
        subject, reference = self._session.subject(key), self._session.reference
        if subject is None or reference is None or key not in self._found:
            return False
        return self._pause.isActive() or self._tasks.busy

    def close(self) -> None:
        self._pause.stop()
        self._tasks.stop()

    def _touch(self) -> None:
        # Not begun anew: a drag would put it off until its end.
        if not self._pause.isActive():
            self._pause.start()

    def _look(self) -> None:
        reference = self._session.reference
        wanted = {
            s.key: (reference.reflectance, s.reflectance)
            for s in self._session.subjects
            if reference is not None and s.key != reference.key
        }
        for key in set(self._of) - set(wanted):
            self._tasks.cancel(key)
            self._working.discard(key)
            del self._of[key]
            self._found.pop(key, None)
        for key, pair in wanted.items():
            before = self._of.get(key)
            same = before is not None and all(a is b for a, b in zip(before, pair, strict=True))
            # One that is in work is brought to its end, or a drag would show none.
            if not same and key not in self._working:
                self._of[key] = pair
                self._submit(key, pair)
        self.changed.emit()

    def _submit(self, key: str, pair: tuple[Reflectance, Reflectance]) -> None:
        self._working.add(key)

        def done(found: ShownError) -> None:
            self._working.discard(key)
            self._found[key] = found
            self._touch()
            self.changed.emit()

        def failed(_error: Exception) -> None:
            # The subject's own message reports the error already.
            self._working.discard(key)
            self._found.pop(key, None)
            self.changed.emit()

        self._tasks.submit(key, _error_of, pair, done, failed)


def _error_of(pair: tuple[Reflectance, Reflectance], _progress: Progress) -> ShownError:
    # Deferred: it brings the fits of undivided data, and nothing of it is needed before a reference is chosen.
    from brdf_suite.inspection.figures.figures import angle_readings, errors_between

    reference, other = pair
    errors = errors_between(reference, other)
    readings = angle_readings(other, None, reference, GEOMETRY_SETS["e2194"])
    differences = [r.delta_e_reference for r in readings if r.delta_e_reference is not None]
    return ShownError(errors, sum(differences) / len(differences) if differences else None)
