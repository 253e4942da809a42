"""Joins the page of the fit to the table, and the fitted lobes to Designer."""

from __future__ import annotations

from typing import Any

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import QObject

from brdf_designer.acquire.fit.page import FitPage
from brdf_designer.acquire.reconstruction.session import ReconstructionSession
from brdf_designer.session.paint_session import PaintSession
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.store import PAINT_ENDING, save_paint
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit, fit_cook_torrance
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.paint_design.measured_start import MeasuredStart, measured_start
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress
from brdf_suite.reflectance.designed.build import build_reflectance


class FitControl(QObject):
    """Fits, shows, opens and saves."""

    def __init__(
        self, bench: ReconstructionSession, page: FitPage, paint_session: PaintSession, dialogs: QtDialogs
    ) -> None:
        super().__init__(bench)
        self._bench, self._page, self._paint_session, self._dialogs = bench, page, paint_session, dialogs
        page.fit_requested.connect(self.find)
        page.choice_edited.connect(lambda: bench.invalidate("fit"))
        page.open_requested.connect(self.open)
        page.save_requested.connect(self.save)
        bench.found.connect(self._show)
        bench.busy_changed.connect(self._busy)

    def find(self) -> None:
        """Fit the lobes to the table."""
        table, session = self._bench.results.get("table"), self._bench.session
        if table is None or session is None:
            return
        request = (session.name, table.acquired.table, *self._page.chosen)
        self._bench.run("fit", _find_fit, request, lambda found: self._bench.keep("fit", found))

    def open(self) -> None:
        """Start a design from the fitted lobes, in a tab of Designer."""
        fit: FileFit | None = self._bench.results.get("fit")
        if fit is not None and fit.paint is not None:
            self._bench.run("start", _find_start, (fit.paint, str(self._bench.folder)), self._opened)

    def save(self) -> None:
        """Ask where the lobes are to be, and write them as a paint."""
        fit: FileFit | None = self._bench.results.get("fit")
        if fit is None or fit.paint is None or self._bench.folder is None:
            return
        named = fit.paint.name.replace("/", "_") + PAINT_ENDING
        path = self._dialogs.save_path(self._bench.folder.parent / named, tr("Paint (*.brdfpaint)"))
        if path is None:
            return
        paint, saved = fit.paint, tr("Saved as {file}.").format(file=path)
        self._bench.run(
            "save_paint",
            lambda target, _progress: save_paint(paint, target),
            path,
            lambda _: self._page.kept.setText(saved),
        )

    def _opened(self, start: MeasuredStart) -> None:
        self._paint_session.open_paint(start.paint)
        text = tr("“{name}” is open in a new tab in Designer. It is not saved yet.").format(
            name=start.paint.name
        )
        self._page.kept.setText(text)
        notes = " ".join(map(tr_core, start.notices))
        if start.mean_delta_e is not None:
            mean = tr("Mean ΔE00 to the fitted lobes at angles that were not used: {mean:.1f}.")
            notes = f"{mean.format(mean=start.mean_delta_e)} {notes}".rstrip()
        self._paint_session.show_message(Message("acquired", text, where=notes))

    def _show(self, key: str) -> None:
        if key not in ("fit", "table"):
            return
        fit: FileFit | None = self._bench.results.get("fit")
        self._page.show_fit(fit, has_table="table" in self._bench.results)
        if fit is None:
            self._bench.window.show_step("fit", "todo", "")
        else:
            words = tr("RMS ln {error:.3f}").format(error=fit.errors.log_rms)
            self._bench.window.show_step("fit", "done", words)

    def _busy(self, key: str, busy: bool) -> None:
        if key == "fit":
            if busy:
                self._bench.window.show_step("fit", "running", "")
                self._page.start.setEnabled(False)
            else:
                self._show("fit")
        elif key == "start":
            fit = self._bench.results.get("fit")
            self._page.open.setEnabled(not busy and fit is not None and fit.paint is not None)


def _find_fit(request: tuple[str, Any, str, int], progress: Progress) -> FileFit:
    """Fit lobes: ``request`` has the name of a table, the table, the model and the number of lobes."""
    name, table, model, lobes = request
    settings = Settings(lobes=lobes, model=model)  # type: ignore[arg-type] # one of the page's
    found = fit_cook_torrance(name, table, settings, progress=progress)
    _ = found.plot  # worked out here, and not when it is shown
    return found


def _find_start(request: tuple[CookTorrancePaint, str], progress: Progress) -> MeasuredStart:
    """Read the lobes of a paint by the virtual spectrophotometer, and start a design from them; with their source."""
    paint, source = request
    return measured_start(Material(paint.name, build_reflectance(paint), origin=source), progress=progress)
