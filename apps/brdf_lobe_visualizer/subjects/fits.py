"""Lobes for every subject, fitted off the main thread: a paint within its time limit and then exactly, others once.

The paint that Designer edits is one subject, which changes while it is dragged.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.late_progress import LateProgress
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.exact_fit import ExactFit
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.sources_control import Sources
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import paint_from_json
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter, fit_material
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
        return not self.tasks.busy

    def close(self) -> None:
        """End what is being fitted."""
        self.tasks.stop()

    def set_fitting(self, fitting: FitSettings) -> None:
        """Fit every subject anew, as ``fitting`` says."""
        self._session.fitting = fitting
        for key in self._of:
            self._cancel(key)
        self._of = {}
        self._look()

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
        key, reflectance, fitting = subject.key, subject.reflectance, self._session.fitting
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

        self.tasks.submit(
            key,
            lambda material, progress: fit_material(material, fitting, progress=progress),
            subject.material,
            done,
            failed,
            moved,
        )


KEY = "designer"
"""The key of the subject that is Designer's paint."""
_FOLLOW_MESSAGE = "designer's paint"


class FollowedPaint(Feature, QObject):
    """Shows what Designer publishes, the newest only; fitted on a thread within the time limit, then exactly.

    Signals: ``arrived()`` when a paint of Designer's has been put in the session.
    """

    arrived = Signal()

    def __init__(self, session: LobeSession, window: LobeWindow, sources: Sources, fits: Fits) -> None:
        super().__init__(window)
        self._session, self._window, self._sources, self._fits = session, window, sources, fits
        self._tasks = TaskRunner(self, threads=1)
        self._fitter: PaintFitter | None = None
        self._newest: Paint | None = None
        self._next: Paint | None = None
        self._exact = ExactFit(self)
        self._exact.arrived.connect(self._show)
        self._exact.failed.connect(lambda fit, _error: self._show(fit))
        self._shown = False
        name, tip = (
            mark("&Follow Designer"),
            mark("Show the paint being edited in Designer and follow every change"),
        )
        self.action = window.add_command("reflectance", name, "follow", self._followed, tip=tip, checked=True)
        session.subjects_changed.connect(self._look)

    @property
    def is_idle(self) -> bool:
        return not self._tasks.busy

    def receive(self, topic: str, value: dict[str, Any]) -> None:
        """Take what a program has published; only paints are of interest. ``value`` has passed the link's check."""
        if topic == "paint":
            self._newest = paint_from_json(value, "Designer")
            if self.action.isChecked():
                self._fit(self._newest)

    def close(self) -> None:
        """End what is being fitted, and forget the paints that were received."""
        self._tasks.stop()
        self._exact.forget()
        if self._fitter is not None:
            self._fitter.close()
        self._fitter = self._newest = self._next = None

    def forget_fitter(self) -> None:
        """Fit the next paint as the session says by then; what is in work is dropped."""
        self._tasks.cancel(KEY)
        self._exact.forget()
        if self._fitter is not None:
            self._fitter.close()
        self._fitter = self._next = None

    def _fit(self, paint: Paint) -> None:
        # One that is in work is brought to its end: were each dropped for the next, a drag would show none of them.
        if self._tasks.busy:
            self._next = paint
            return
        if self._fitter is None:
            self._fitter = PaintFitter(self._session.fitting)
        fitter = self._fitter
        self._tasks.submit(KEY, lambda paint, _progress: fitter.fit(paint), paint, self._fresh, self._refused)

    def _fresh(self, fit: LobeFit) -> None:
        self._window.dismiss_message(_FOLLOW_MESSAGE)
        self._exact.watch(fit)
        self._show(fit)
        self._go_on()

    def _go_on(self) -> None:
        paint, self._next = self._next, None
        if paint is not None:
            self._fit(paint)

    def _show(self, fit: LobeFit) -> None:
        if not self.action.isChecked():
            return
        before = self._session.subject(KEY)
        title = tr("Designer: {name}").format(name=fit.name)
        material = replace(fit.material, origin=tr("Designer"))
        shown = PlottedMaterial(KEY, title, material, fit=fit, notes=fit.material.notices)
        colour, dash = self._sources.next_line() if before is None else (before.colour, before.dash)
        self._fits.skip(KEY, shown.reflectance)
        self._session.add(replace(shown, colour=colour, dash=dash))
        if before is None:
            self._session.set_front(KEY)
        self._shown = True
        self.arrived.emit()

    def _refused(self, error: Exception) -> None:
        todo = tr("The previous paint is still shown.")
        self._window.show_message(message_of(error, _FOLLOW_MESSAGE, todo=todo))
        self._go_on()

    def _followed(self, follow: bool) -> None:
        if follow and self._newest is not None:
            self._fit(self._newest)
        elif not follow:
            self._next = None
            self._tasks.cancel(KEY)
            self._exact.forget()

    def _look(self) -> None:
        # Taken out of the legend it is followed no more, or the next edit would bring it back.
        there = self._session.subject(KEY) is not None
        if self._shown and not there:
            self.action.setChecked(False)
        self._shown = there
