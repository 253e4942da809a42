"""The status bar: the subject in front, its fit and whether time limited it, the reading of its error, the link."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.suite import connected_words
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.status_line import StatusLine
from brdf_qt.work.fit_error import fit_mark
from PySide6.QtCore import QObject

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.verdict import DELTA_E_LIMITS, verdict_of, words_of
from brdf_lobe_visualizer.window import LobeWindow


class Status(QObject):
    """Keeps the cells in step with the session; parts may add cells of their own to ``window.status``."""

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session = session
        line: StatusLine = window.status
        self._subject = line.cell(mark("subject"), tr("Selected reflectance"), elastic=True)
        self._fit = line.cell(mark("fit"), tr("Fitted lobes and fitting time"))
        self._notes = line.cell(mark("notes"), tr("Notes on the reflectance"), elastic=True)
        self._light = line.cell(mark("incidence"), tr("Direction of the light"), right=True)
        self._link = line.cell(mark("link"), tr("Connected programs of the suite"), right=True)
        session.subjects_changed.connect(self._show_front)
        session.front_changed.connect(self._show_front)
        session.incidence_changed.connect(lambda _theta, _phi: self._show_light())
        self._show_front()
        self._show_light()

    def show_peers(self, roles: Sequence[str]) -> None:
        self._link.set(connected_words(roles))

    def _show_front(self) -> None:
        front = self._session.front
        if front is None:
            for cell in (self._subject, self._fit, self._notes):
                cell.set("")
            return
        self._subject.set(front.title, tr_core(front.material.origin))
        front_notes = [tr_core(note) for note in front.notes]
        self._notes.set("" if not front_notes else front_notes[-1], "\n".join(front_notes))
        fit = front.fit
        if fit is None:
            self._fit.set(tr("no fit yet"), state="stale")
            return
        notes = [tr_core(notice) for notice in fit.notices]
        milliseconds = 1e3 * fit.fit_seconds
        shown = f"{milliseconds:.0f}" if milliseconds >= 100.0 else f"{milliseconds:.3g}"
        parts = [tr("fit {ms} ms").format(ms=shown)]
        if fit.worst_delta_e is not None:
            text = tr("worst ΔE00 {value}").format(value=decimal(f"{fit.worst_delta_e:.2f}"))
            parts.append(text)
            notes = [f"{text}: {words_of(verdict_of(fit.worst_delta_e, DELTA_E_LIMITS))}", *notes]
        if fit.time_limited:
            follows = tr("exact fit follows") if fit.exact_follows else tr("best result so far")
            parts.append(tr("time limit: {what}").format(what=follows))
        sign = fit_mark(fit.worst_delta_e, fit.time_limited and not fit.exact_follows)
        self._fit.set(" · ".join(parts), "\n".join(notes), "warning" if sign else "fresh", sign)

    def _show_light(self) -> None:
        theta, phi = self._session.incidence
        self._light.set(tr("light {theta}°, {phi}°").format(theta=f"{theta:.1f}", phi=f"{phi:.0f}"))
