"""Figures of the visible subjects: worked out one after another on a thread, kept while nothing of them changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from brdf_qt.program.translation import tr
from brdf_qt.window.late_progress import LateProgress
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Signal

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS, GeometrySet
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.progress import Progress
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.inspection.figures.figures import ReflectanceFigures

_PAUSE_MS = 200
"""A drag changes a paint sixty times a second; its figures follow once it rests."""


@dataclass(frozen=True, eq=False)
class _Inputs:
    """What figures depend on, by the names of ``FiguresRequest``; compared by identity where it is large."""

    reflectance: Reflectance
    fit: LobeWeights | None
    reference: Reflectance | None
    azimuth_deg: float
    isotropic: bool
    geometry_set: GeometrySet

    def is_same(self, other: _Inputs | None) -> bool:
        return (
            other is not None
            and self.reflectance is other.reflectance
            and self.fit is other.fit
            and self.reference is other.reference
            and (self.azimuth_deg, self.geometry_set) == (other.azimuth_deg, other.geometry_set)
        )


class FiguresWork(QObject):
    """Keeps figures in step with the session while they are needed (:meth:`set_needed`).

    Signals: ``changed()`` when figures are there, have gone, or are stale.
    """

    changed = Signal()

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._tasks = TaskRunner(self, threads=1)
        self._progress = LateProgress(window.progress, self)
        self.angles = GEOMETRY_SETS[DEFAULT_SET]
        self._needed = False
        self._of: dict[str, _Inputs] = {}
        self._found: dict[str, tuple[_Inputs, ReflectanceFigures]] = {}
        self._pause = make_timer(self, self._look, _PAUSE_MS)
        for signal in (session.subjects_changed, session.visibility_changed, session.options_changed):
            signal.connect(self._touch)
        session.incidence_changed.connect(lambda _theta, _phi: self._touch())

    @property
    def is_idle(self) -> bool:
        return not self._needed or not (self._pause.isActive() or self._tasks.busy)

    def set_needed(self, needed: bool) -> None:
        """Set whether the figures are visible; only then are any computed."""
        if needed != self._needed:
            self._needed = needed
            if needed:
                self._look()
            else:
                self._pause.stop()
                for key in [key for key in self._of if not self._is_fresh(key)]:
                    self._cancel(key)

    def set_angles(self, name: str) -> None:
        """Read the colours at the geometries of a set of :data:`GEOMETRY_SETS`."""
        self.angles = GEOMETRY_SETS[name]
        self._touch()

    def figures(self, key: str) -> ReflectanceFigures | None:
        """Return the newest figures of a subject, maybe of what it was before; None where there are none."""
        found = self._found.get(key)
        return None if found is None or found[1].geometry_set is not self.angles else found[1]

    def is_stale(self, key: str) -> bool:
        """Whether the subject is another since its figures were worked out."""
        return not self._is_fresh(key) or self._pause.isActive()

    def close(self) -> None:
        self._needed = False
        self._pause.stop()
        self._tasks.stop()

    def _is_fresh(self, key: str) -> bool:
        found = self._found.get(key)
        return found is not None and found[0].is_same(self._of.get(key))

    def _touch(self) -> None:
        if self._needed:
            self._pause.start()

    def _look(self) -> None:
        visible = self._session.visible
        for key in set(self._of) - {s.key for s in visible}:
            self._cancel(key)
        for key in set(self._found) - {s.key for s in self._session.subjects}:
            del self._found[key]
        for subject in visible:
            wanted = self.inputs_of(subject)
            if not wanted.is_same(self._of.get(subject.key)):
                self._of[subject.key] = wanted
                if not self._is_fresh(subject.key):
                    self._submit(subject, wanted)
        self.changed.emit()

    def inputs_of(self, subject: PlottedMaterial) -> _Inputs:
        reference = self._session.reference
        other = None if reference is None or reference.key == subject.key else reference
        # Switching a lobe makes new weights; those of a whole fit are always the same object.
        weights = self._session.weights_of(subject)
        turned = not subject.isotropic or (other is not None and not other.isotropic)
        azimuth = self._session.incidence[1] if turned else 0.0
        against = None if other is None else self._session.target_of(other)
        return _Inputs(
            self._session.target_of(subject), weights, against, azimuth, subject.isotropic, self.angles
        )

    def _submit(self, subject: PlottedMaterial, wanted: _Inputs) -> None:
        key, job = subject.key, f"figures {subject.key}"
        text = tr("Computing statistics for {name}").format(name=subject.title)
        moved = self._progress.begin(job, text, lambda: self._cancel(key))

        def done(found: ReflectanceFigures) -> None:
            self._progress.end(job)
            self._window.dismiss_message(job)
            self._found[key] = (wanted, found)
            self.changed.emit()

        def failed(error: Exception) -> None:
            self._progress.end(job)
            self._window.show_message(message_of(error, job, todo=tr("Its figures are not shown.")))
            self.changed.emit()

        self._tasks.submit(key, _figures, wanted, done, failed, moved)

    def _cancel(self, key: str) -> None:
        self._tasks.cancel(key)
        self._progress.end(f"figures {key}")
        self._of.pop(key, None)


def _figures(wanted: _Inputs, progress: Progress) -> ReflectanceFigures:
    # Deferred: what measures brings the fits of undivided data, and the panel is not there at a first start.
    from brdf_suite.inspection.figures.figures import FiguresRequest, reflectance_figures

    return reflectance_figures(FiguresRequest(**vars(wanted)), progress)
