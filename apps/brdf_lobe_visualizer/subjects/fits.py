"""Lobes for every subject, fitted off the main thread: a paint within its time limit and then exactly, others once."""

from __future__ import annotations

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_lobe_visualizer.late_progress import LateProgress
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress
from brdf_suite.reflectance.protocol import Reflectance


class Fits(Feature, QObject):
    """Gives each subject its fit as soon as there is one; a subject whose reflectance changes is fitted anew.

    The fit of before stays until the new one is there: a picture that is late by a frame is better than one that
    flickers.
    """

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        # One thread: HiGHS takes a core, and a fit of samples takes a second or two.
        self.tasks = TaskRunner(self, threads=1)
        self._progress = LateProgress(window.progress, self)
        self._of: dict[str, Reflectance] = {}
        session.subjects_changed.connect(self._look)
        self._look()

    @property
    def is_idle(self) -> bool:
        """Whether every subject has its fit, or is known to have none."""
        return not self.tasks.busy

    def close(self) -> None:
        """End what is being fitted."""
        self.tasks.stop()

    def skip(self, key: str, reflectance: Reflectance) -> None:
        """Fit nothing for this reflectance of a subject: the caller supplies the fit, as for a followed paint."""
        self._of[key] = reflectance

    def _look(self) -> None:
        subjects = self._session.subjects
        for key in set(self._of) - {s.key for s in subjects}:
            del self._of[key]
            self._cancel(key)
            self._window.dismiss_message(f"fit {key}")
        for subject in subjects:
            if self._of.get(subject.key) is not subject.reflectance:
                self._of[subject.key] = subject.reflectance
                self._fit(subject)

    def _cancel(self, key: str) -> None:
        self.tasks.cancel(key)
        self._progress.end(f"fit {key}")

    def _fit(self, subject: PlottedMaterial) -> None:
        key, reflectance = subject.key, subject.reflectance
        job = f"fit {key}"
        text = tr("Fitting lobes to {name}").format(name=subject.title)
        moved = self._progress.begin(job, text, lambda: self._cancel(key))

        def done(fit: LobeFit) -> None:
            self._progress.end(job)
            self._window.dismiss_message(job)
            now = self._session.subject(key)
            if now is not None and now.reflectance is reflectance:
                self._session.change(key, fit=fit)

        def failed(error: Exception) -> None:
            self._progress.end(job)
            todo = tr("The reflectance is shown without a fit.")
            self._window.show_message(message_of(error, job, todo=todo))

        self.tasks.submit(key, _fitted, subject.material, done, failed, moved)


def _fitted(material: Material, progress: Progress) -> LobeFit:
    return fit_material(material, progress=progress)
