"""Exports the current paint: losses are listed while the section is open, the file written in the background."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.export.process import Request, Written, run_exports
from brdf_designer.export.section import REPORTS, TITLES, FormatState, HandoverSection
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.paint_design.standard import paint_like
from brdf_suite.progress import Progress
from brdf_suite.regular_files import exists, is_folder

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
        kept = settings().value(_FORMAT, NAMES[0][0])
        self.section.choose(*(kept if isinstance(kept, list) else [str(kept)]))
        if not self.section.chosen:
            self.section.choose(NAMES[0][0])
        self.section.formats_chosen.connect(self._chosen)
        self.section.export_requested.connect(self.ask)
        self.host.seen.connect(self._later)
        session.paint_changed.connect(lambda _paint: self._later())

    def open(self) -> None:
        """Open the section with the keyboard in its list: what is lost is read before anything is written."""
        self._window.show_section(KEY)
        section = self.section
        section.formats[next(iter(section.chosen), NAMES[0][0])].setFocus()
        self._later()

    def ask(self) -> None:
        """Ask for a file, or where several formats are ticked for a folder, and write."""
        names, endings = self.section.chosen, dict(NAMES)
        kept = Path(str(settings().value(_FOLDER, "", type=str)) or Path.home())
        folder = kept if is_folder(kept) else Path.home()
        stem, dialogs = file_name(self._session.paint.name), self._session.documents.dialogs
        if len(names) == 1:
            ending = endings[names[0]]
            filters = f"{tr(TITLES[names[0]])} (*{ending})"
            path = dialogs.save_path(folder / (stem + ending), filters)
            paths = [] if path is None else [path]
        else:
            chosen = dialogs.folder_path(
                tr("Export {count} Files to a Folder").format(count=len(names)), folder
            )
            paths = [] if chosen is None else free_paths(chosen, stem, [endings[name] for name in names])
        if paths:
            settings().setValue(_FOLDER, str(paths[0].absolute().parent))
            self.export(*paths)

    def export(self, *paths: Path) -> None:
        """Write the paint as it is now to a file for each of the ticked formats, in the background."""
        try:
            requests = [
                self._request(name, path) for name, path in zip(self.section.chosen, paths, strict=True)
            ]
        except SuiteError as error:
            self._session.show_message(message_of(error, KEY, todo=tr("No file was written.")))
            return
        progress = self._window.progress
        text = tr("Exporting {name}").format(name=", ".join(path.name for path in paths))

        def moved(fraction: float, _what: str) -> None:
            progress.set_job(KEY, fraction, text, lambda: self._tasks.cancel(KEY))

        moved(0.0, "")
        self._session.dismiss_message(KEY)
        self._tasks.submit(KEY, run_exports, requests, self._written, self._failed, moved)

    @property
    def is_idle(self) -> bool:
        """Whether nothing is written, and the losses that are on show are those of the paint."""
        return not self._tasks.busy

    def close(self) -> None:
        """End what is still written; an old file stays."""
        self._tasks.stop(30_000)

    def _request(self, name: str, path: Path) -> Request:
        paint = self._session.paint
        standards = self._window.findChild(StandardControl)
        request = Request(paint, name, path, self.section.pictures.isChecked())
        if standards is None or name not in REPORTS or not self.section.compared.isChecked():
            return request
        if standards.standard is None:
            return request
        like = paint_like(standards.standard, paint)
        return replace(request, standard=like, tolerances=standards.tolerances)

    def _written(self, files: tuple[Written, ...]) -> None:
        self._window.progress.end_job(KEY)
        good = [one for one in files if one.error is None]
        for one in files:
            if one.error is not None:
                todo = tr("An existing file with this name is unchanged.")
                if good:
                    todo += " " + tr("Exported: {names}.").format(names=", ".join(g.path.name for g in good))
                self._session.show_message(message_of(one.error, KEY, todo=todo))
                return
        names, where = ", ".join(one.path.name for one in good), good[0].path
        self._session.show_message(
            Message(
                KEY,
                tr("{name} exported.").format(name=names),
                where=str(where if len(good) == 1 else where.parent),
                todo=" ".join(note for one in good for note in one.notes),
            )
        )

    def _failed(self, error: Exception) -> None:
        self._window.progress.end_job(KEY)
        self._session.show_message(
            message_of(error, KEY, todo=tr("An existing file with this name is unchanged."))
        )

    # What is lost.

    def _chosen(self) -> None:
        settings().setValue(_FORMAT, list(self.section.chosen))
        self.section.show_formats(None)
        self._later()

    def _later(self) -> None:
        """Update once the edits pause, and only what is visible; losses of what was before no longer count."""
        self._tasks.cancel(_LOSSES)
        if self.host.is_seen:
            self._session.at_idle(_LOSSES, self._report)

    def _report(self) -> None:
        standards = self._window.findChild(StandardControl)
        self.section.show_options(has_standard=standards is not None and standards.standard is not None)
        self.section.show_formats(None)
        self._tasks.submit(
            _LOSSES,
            _find_out,
            (self._session.paint, self.section.chosen),
            self.section.show_formats,
            lambda error: self._session.show_message(message_of(error, KEY)),
        )


def _find_out(request: tuple[Paint, tuple[str, ...]], _progress: Progress) -> tuple[FormatState, ...]:
    from brdf_suite.reports.handover import format_named, item_of_paint

    paint, names = request
    found = []
    for name in names:
        known = format_named(name)
        try:
            found.append(FormatState(name, known.holds, known.losses(item_of_paint(paint))))
        except UnreachableError as error:
            found.append(FormatState(name, known.holds, (), str(error)))
    return tuple(found)


def free_paths(folder: Path, stem: str, endings: Sequence[str]) -> list[Path]:
    """Return files of one name in a folder, none of which is there yet: the name itself, or with a number."""
    for number in itertools.count(1):
        name = stem if number == 1 else f"{stem} {number}"
        paths = [folder / f"{name}{ending}" for ending in endings]
        if not any(exists(path) for path in paths):
            return paths
    raise AssertionError


def file_name(name: str) -> str:
    """Return a paint's name as that of a file on every system, without ending."""
    return _NOT_IN_NAMES.sub("_", name).strip(" .")[:100] or "paint"
