"""Joins the pages of response, geometry, reconstruction and coverage to the road."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.message_bar import Message, message_of
from PySide6.QtCore import QObject, Signal

from brdf_designer.acquire.camera_response.work import find_response
from brdf_designer.acquire.geometry.work import find_geometry
from brdf_designer.acquire.reconstruction.session import WORK_FILE, ReconstructionSession, no_session
from brdf_designer.acquire.reconstruction.work import (
    KeptWork,
    TableFound,
    TableRequest,
    find_kept,
    find_table,
    save_table,
)
from brdf_designer.acquire.states import CoverageState, Found, Problem
from brdf_suite.errors import FileError


class ReconstructionController(QObject):
    """Starts the steps, shows what they found, and keeps it."""

    _partial = Signal(int, int, object)

    def __init__(self, bench: ReconstructionSession, dialogs: QtDialogs) -> None:
        super().__init__(bench)
        self._bench, self._dialogs = bench, dialogs
        self._done = self._total = 0
        self._saved = ""
        window = bench.window
        window.response.recover_requested.connect(self.find_response)
        window.response.kind_chosen.connect(lambda kind: self._choose("response", response=kind))
        window.geometry_page.find_requested.connect(self.find_geometry)
        window.geometry_page.refine_chosen.connect(lambda on: self._choose("geometry", refine=on))
        window.reconstruction.start_requested.connect(self.find_table)
        window.reconstruction.again_requested.connect(lambda: self.find_table(restart=True))
        window.reconstruction.grazing_edited.connect(lambda angle: self._choose("table", grazing_deg=angle))
        window.coverage.save_requested.connect(self.save)
        self._partial.connect(self._show_partial)
        bench.opened.connect(self._opened)
        bench.found.connect(self._show)
        bench.busy_changed.connect(self._busy)

    # The steps.

    def find_response(self) -> None:
        """Find the response of the camera."""
        if self._ready():
            todo, take = tr("The other steps are unchanged."), partial(self._bench.keep, "response")
            self._bench.run("response", find_response, self._bench.request(), take, todo=todo)

    def find_geometry(self) -> None:
        """Find sphere and lamp."""
        if self._ready():
            self._bench.run("geometry", find_geometry, self._bench.request(), self._keep)

    def find_table(self, *, restart: bool = False) -> None:
        """Make the table, or go on with it."""
        if not self._ready() or self._bench.is_busy("table"):
            return
        request = TableRequest(self._bench.request(), restart, self._partial.emit)
        self._bench.window.reconstruction.show_partial(None)
        self._bench.run(
            "table", find_table, request, self._take_table, moved=self._moved, failed=self._failed
        )

    def _failed(self, error: Exception) -> None:
        message = message_of(
            error, "table", todo=tr("Finished positions are kept. Click Resume to continue.")
        )
        folder = self._bench.folder
        if isinstance(error, FileError) and folder is not None and error.path == str(folder / WORK_FILE):
            message = replace(
                message,
                todo=tr(
                    "The mask, the rig or an option has changed since. Starting over discards the "
                    "earlier results."
                ),
                actions=((tr("Start Over"), lambda: self.find_table(restart=True)),),
            )
        self._bench.say(message)

    def save(self) -> None:
        """Ask where the table is to be, and write it."""
        bench = self._bench
        table = bench.results.get("table")
        if table is None or bench.folder is None or bench.session is None:
            return
        named = f"{bench.session.name.replace('/', '_')}.brdftable"
        filters = ";;".join((tr("Table with coverage (*.brdftable)"), tr("MERL layout (*.binary)")))
        path = self._dialogs.save_path(bench.folder.parent / named, filters)
        if path is None:
            return

        def done(notes: tuple[str, ...]) -> None:
            self._saved = tr("Saved as {file}.").format(file=path)
            self._bench.window.coverage.kept.setText(" ".join((self._saved, *notes)))

        self._bench.run("save", save_table, (table.acquired, path), done)

    # Choices.

    def _choose(self, step: str, **option: Any) -> None:
        """Take another option of the road, and forget what a step found by the old one."""
        self._bench.options = replace(self._bench.options, **option)
        self._bench.invalidate(step)

    def _ready(self) -> bool:
        if self._bench.session is None:
            self._bench.say(no_session())
            return False
        return True

    # What was found.

    def _opened(self) -> None:
        session = self._bench.session
        self._done, self._total = 0, 0 if session is None else len(session.positions)
        self._bench.window.reconstruction.show_partial(None)
        self._show_done(())
        if session is not None:
            self._bench.run("kept", find_kept, self._bench.request(), self._take_kept, shown=False)

    def _take_kept(self, kept: KeptWork) -> None:
        if kept.reason:
            self._bench.say(
                Message(
                    "kept",
                    tr("The earlier reconstruction in this folder cannot be resumed."),
                    where=tr_core(kept.reason),
                    todo=tr("Click Start Over on the page Reconstruction."),
                    severity="warning",
                )
            )
        if kept.done:
            self._keep(kept.calibrated)
            self._done = kept.done
            self._show_done(())
            self._bench.window.reconstruction.show_progress(
                tr("{done} positions were finished in an earlier run.").format(done=kept.done),
                running=False,
            )
            words = tr("{done} of {total} done").format(done=kept.done, total=self._total)
            self._bench.window.show_step("reconstruction", "todo", words)

    def _keep(self, found: dict[str, Found]) -> None:
        for key, value in found.items():
            self._bench.keep(key, value)

    def _take_table(self, found: TableFound) -> None:
        bench = self._bench
        # What was calibrated on the way is kept without forgetting the table that came of it.
        self._keep(found.calibrated)
        self._done = len(found.acquired.positions_done)
        self._saved = ""
        bench.keep("table", found)

    def _show(self, key: str) -> None:
        window, value = self._bench.window, self._bench.results.get(key)
        if key == "response":
            window.response.show_response(None if value is None else value.state)
            if value is not None and value.state is None:
                window.response.note.setText(
                    tr("The photographs are linear files. No response curve is needed.")
                )
            words = "" if value is None else _response_words(value)
            window.show_step("response", "todo" if value is None else "done", words)
        elif key == "geometry":
            window.geometry_page.show_geometry(None if value is None else value.state)
            if value is not None and value.state is None:
                text = tr("Result of an earlier run. Run this step again to display it.")
                window.geometry_page.note.setText(text)
                window.geometry_page.picture.show_empty(text)
            self._report_geometry(value)
        elif key == "table":
            self._show_table(value)

    def _report_geometry(self, value: Any) -> None:
        if value is None:
            self._bench.window.show_step("geometry", "todo", "")
            return
        rms = value.found.figures.get("highlight_rms_px", value.found.figures.get("outline_rms_px"))
        words = "" if rms is None else tr("{rms:.3f} px RMS").format(rms=rms)
        moved = value.state is not None and bool(value.state.problems)
        self._bench.window.show_step("geometry", "warning" if moved else "done", words)

    def _show_table(self, value: TableFound | None) -> None:
        window = self._bench.window
        window.coverage.show_coverage(None if value is None else value.state)
        if value is None:
            window.show_step("reconstruction", "todo", "")
            window.show_step("coverage", "todo", "")
            return
        failed = tuple(
            Problem("error", self._name(one.position), one.reason) for one in value.acquired.positions_failed
        )
        window.reconstruction.show_partial(value.state)
        window.reconstruction.show_progress(tr("Done."), running=False)
        self._show_done(failed)
        words = tr("{done} of {total} positions").format(done=self._done, total=self._total)
        window.show_step("reconstruction", "warning" if failed else "done", words)
        measured = next((text for name, text, _ in value.state.facts if name == tr("Measured")), "")
        window.show_step("coverage", "done", tr("{share} measured").format(share=measured))
        window.coverage.kept.setText(
            self._saved
            or tr("Not saved yet. The intermediate results are kept in {file}.").format(file=WORK_FILE)
        )

    def _name(self, position: int) -> str:
        session = self._bench.session
        if session is None:
            return ""
        return tr("{angle:g}°").format(angle=session.positions[position].angle_deg)

    # While it runs.

    def _moved(self, _fraction: float, what: str) -> None:
        self._bench.window.reconstruction.show_progress(what, running=True)

    def _show_partial(self, done: int, total: int, state: CoverageState | None) -> None:
        if not self._bench.is_busy("table"):
            return
        self._done, self._total = done, total
        self._show_done(())
        if state is not None:
            self._bench.window.reconstruction.show_partial(state)

    def _show_done(self, failed: tuple[Problem, ...]) -> None:
        self._bench.window.reconstruction.show_done(self._done, self._total, failed)

    def _busy(self, key: str, busy: bool) -> None:
        window, step = self._bench.window, {"table": "reconstruction"}.get(key, key)
        if key not in ("response", "geometry", "table"):
            return
        if busy:
            window.show_step(step, "running", "")
        elif key not in self._bench.results:
            window.show_step(step, "todo", "")
        else:
            self._show(key)
        if key == "response":
            window.response.start.setEnabled(not busy)
        elif key == "geometry":
            window.geometry_page.start.setEnabled(not busy)
        elif busy:
            window.reconstruction.show_progress(tr("Waiting…"), running=True)
        elif key not in self._bench.results:
            stopped = tr("Stopped. Finished positions are kept.") if self._done else ""
            window.reconstruction.show_progress(stopped, running=False)
            self._show_done(())


def _response_words(value: Found) -> str:
    if value.state is None or value.state.linear:
        return tr("linear")
    if value.kept:
        return tr("from the earlier run")
    return tr("recovered") if value.state.times else tr("as stated")
