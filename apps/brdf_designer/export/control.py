"""Exports the current paint: losses are listed while the section is open, the file written in the background."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.export.process import Request, run_export
from brdf_designer.export.section import REPORTS, HandoverSection
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.paint_design.standard import paint_like
from brdf_suite.progress import Progress

KEY = "handover"
_LOSSES = "handover-losses"
_FORMAT = "handover/format"
_FOLDER = "handover/folder"
_NOT_IN_NAMES = re.compile(r'[\x00-\x1f<>:"/\\|?*]+')
# As the core has them; it is imported when the section is opened, not at the start of the program.
NAMES = (
    ("cxf", ".cxf"), ("csv", ".csv"), ("json", ".json"), ("luxcore", ".scn"), ("openpbr", ".mtlx"),
    ("gltf", ".gltf"), ("usd", ".usda"), ("rgl", ".bsdf"), ("html", ".html"), ("pdf", ".pdf"),
)  # fmt: skip


class HandoverControl(Feature, QObject):
    """Joins the section to the paint session."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._tasks = TaskRunner(self, threads=2)
        self.section = HandoverSection(NAMES)
        self.host = window.add_section(KEY, tr("Export"), self.section, tab="export")
        self.action = window.add_command(
            "file",
            tr("&Export…"),
            "export",
            self.open,
            KEY,
            tip=tr("Export the paint for other programs, or as a report"),
        )
        self.section.choose(str(settings().value(_FORMAT, NAMES[0][0], type=str)))
        self.section.format_chosen.connect(self._chosen)
        self.section.export_requested.connect(self.ask)
        self.host.seen.connect(self._later)
        session.paint_changed.connect(lambda _paint: self._later())

    def open(self) -> None:
        """Open the section with the keyboard in its list: what is lost is read before anything is written."""
        self._window.show_section(KEY)
        self.section.formats.setFocus()
        self._later()

    def ask(self) -> None:
        """Ask for a file and write it."""
        name = self.section.chosen
        ending = dict(NAMES)[name]
        kept = Path(str(settings().value(_FOLDER, "", type=str)) or Path.home())
        folder = kept if kept.is_dir() else Path.home()
        suggested = folder / (file_name(self._session.paint.name) + ending)
        filters = f"{self.section.formats.currentText()} (*{ending})"
        path = self._session.documents.dialogs.save_path(suggested, filters)
        if path is not None:
            settings().setValue(_FOLDER, str(path.absolute().parent))
            self.export(path)

    def export(self, path: Path) -> None:
        """Write the paint as it is now in the chosen format, in the background."""
        try:
            request = self._request(path)
        except SuiteError as error:
            self._session.show_message(message_of(error, KEY, todo=tr("No file was written.")))
            return
        progress = self._window.progress
        text = tr("Exporting {name}").format(name=path.name)

        def moved(fraction: float, _what: str) -> None:
            progress.set_job(KEY, fraction, text, lambda: self._tasks.cancel(KEY))

        moved(0.0, "")
        self._session.dismiss_message(KEY)
        self._tasks.submit(
            KEY, run_export, request, lambda notes: self._written(path, notes), self._failed, moved
        )

    def close(self) -> None:
        """End what is still written; an old file stays."""
        self._tasks.stop(30_000)

    def _request(self, path: Path) -> Request:
        paint, name = self._session.paint, self.section.chosen
        standards = self._window.findChild(StandardControl)
        request = Request(paint, name, path, self.section.pictures.isChecked())
        if standards is None or name not in REPORTS or not self.section.compared.isChecked():
            return request
        if standards.standard is None:
            return request
        like = paint_like(standards.standard, paint)
        return replace(request, standard=like, tolerances=standards.tolerances)

    def _written(self, path: Path, notes: tuple[str, ...]) -> None:
        self._window.progress.end_job(KEY)
        self._session.show_message(
            Message(KEY, tr("{name} exported.").format(name=path.name), where=str(path), todo=" ".join(notes))
        )

    def _failed(self, error: Exception) -> None:
        self._window.progress.end_job(KEY)
        self._session.show_message(
            message_of(error, KEY, todo=tr("An existing file with this name is unchanged."))
        )

    # What is lost.

    def _chosen(self, name: str) -> None:
        settings().setValue(_FORMAT, name)
        self._later()

    def _later(self) -> None:
        """Update once the edits pause, and only what is visible."""
        if self.host.is_seen:
            self._session.at_idle(_LOSSES, self._report)

    def _report(self) -> None:
        name = self.section.chosen
        standards = self._window.findChild(StandardControl)
        has_standard = standards is not None and standards.standard is not None
        self.section.show_options(name, has_standard=has_standard)
        self.section.show_format(self.section.holds.text(), None)
        self._tasks.submit(
            _LOSSES,
            _find_out,
            (self._session.paint, name),
            lambda found: self.section.show_format(*found),
            lambda error: self._session.show_message(message_of(error, KEY)),
        )


def _find_out(request: tuple[Paint, str], _progress: Progress) -> tuple[str, tuple[str, ...], str]:
    from brdf_suite.reports.handover import format_named, item_of_paint

    paint, name = request
    known = format_named(name)
    try:
        return known.holds, known.losses(item_of_paint(paint)), ""
    except UnreachableError as error:
        return known.holds, (), str(error)


def file_name(name: str) -> str:
    """Return a paint's name as that of a file on every system, without ending."""
    return _NOT_IN_NAMES.sub("_", name).strip(" .")[:100] or "paint"
