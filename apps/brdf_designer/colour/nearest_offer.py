"""Where no such paint can be: the nearest one that can, looked for once the edits pause, and one click away."""

from __future__ import annotations

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from brdf_qt.work.fit_error import LARGE_DELTA_E
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.colour.patches import lab_text
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import angle_text, by_angle
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.paint_design.feasible import Feasible, judged, nearest_feasible
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, LobeFit, PaintFitter
from brdf_suite.progress import Progress

KEY = "nearest"
_CLOSING_MS = 10_000
_LARGE_BEYOND = 2.0


def find_nearest(paint: Paint, progress: Progress) -> Feasible | None:
    """Return the nearest paint that can be; on a thread, with a fitter of its own."""
    fitter = PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S)
    try:
        return nearest_feasible(paint, fitter, progress=progress)
    finally:
        fitter.close()


class NearestOffer(Feature, QObject):
    """Says that a target cannot be reached, where, and offers what can; one undo step takes it."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._runner = TaskRunner(self, threads=1)
        self._closed = False
        self.offered: Feasible | None = None
        session.paint_changed.connect(lambda _paint: self._forget())
        session.fit_changed.connect(lambda fit: self._search_later(bool(missed(fit))))
        session.refused.connect(lambda error: self._search_later(isinstance(error, UnreachableError)))
        session.gesture_ended.connect(self._search_later)

    def close(self) -> None:
        """End what runs."""
        self._closed = True
        self._runner.stop(_CLOSING_MS)

    def take(self) -> None:
        """Make the offered paint the document, as one step."""
        found = self.offered
        if found is not None and found.asked == self._session.paint:
            self._session.set_paint(found.paint, tr("Use Closest Paint"))

    def _search_later(self, needed: bool = True) -> None:
        if needed:
            self._session.at_idle(KEY, self._search)

    def _forget(self) -> None:
        self.offered = None
        self._runner.cancel(KEY)
        self._session.dismiss_message(KEY)

    def _search(self) -> None:
        fit = self._session.fit
        can_be = fit is not None and (fit.exact_follows or not missed(fit))
        # What cannot be in the midst of a drag may be at its end.
        if can_be or self._session.in_gesture or self.offered is not None or self._closed:
            return
        self._runner.submit(KEY, find_nearest, self._session.paint, done=self._found, failed=self._failed)

    def _found(self, found: Feasible | None) -> None:
        fit = self._session.fit
        if fit is None:
            what = tr("This paint is impossible.")
        else:
            large = missed(fit)
            names = [angle_text(fit.paint, index) for index in by_angle(fit.paint) if index in large]
            what = tr("No combination of lobes produces the target colour at {angles}.")
            what = what.format(angles=", ".join(names))
        if found is None:
            todo = tr("No possible paint was found close to it. Change a colour or the gloss.")
            self._session.show_message(Message(KEY, what, todo=todo, severity="warning"))
            return
        self.offered = found
        todo = tr("Closest possible paint: {paint}.").format(paint=describe(found))
        actions = ((tr("Use Closest"), self.take),)
        self._session.show_message(Message(KEY, what, todo=todo, actions=actions, severity="warning"))

    def _failed(self, error: Exception) -> None:
        text = tr("The search for the closest possible paint failed: {error}").format(
            error=tr_core(str(error))
        )
        self._session.show_message(Message(KEY, text, severity="warning"))


def missed(fit: LobeFit) -> list[int]:
    """Return the readings whose colour the lobes miss by so much that another paint is worth an offer.

    Lobes are the same on both sides of the mirror direction, and a coat lets a little less out beyond it: what a
    reading there misses by that alone, about 1.2, is shown at its patch and no reason for another paint.
    """
    return [
        index
        for index in judged(fit)
        if fit.readings[index].delta_e_2000
        > (LARGE_DELTA_E if fit.readings[index].aspecular_deg >= 0.0 else _LARGE_BEYOND)
    ]


def describe(found: Feasible) -> str:
    """Return what is another in the offered paint, in words."""
    parts = []
    if found.gloss_changed:
        gloss = found.paint.gloss
        text = tr("gloss {gu:g} GU at 20°").format(gu=gloss.gu_20)
        if gloss.gu_60 is not None:
            text = tr("gloss {gu_20:g} GU at 20° and {gu_60:g} GU at 60°").format(
                gu_20=gloss.gu_20, gu_60=gloss.gu_60
            )
        parts.append(text)
    for index in by_angle(found.paint):
        before, after = found.asked.measurements[index].lab, found.paint.measurements[index].lab
        if before != after:
            parts.append(
                tr("{angle}: {lab} (ΔE00 {error:.1f})").format(
                    angle=angle_text(found.paint, index), lab=lab_text(after), error=found.delta_e[index]
                )
            )
    return "; ".join(parts)
