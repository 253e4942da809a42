"""Starts designs from measurements: read on a thread, opened in a tab, with a report that stays with it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.documents.tabs import Opener
from brdf_designer.from_measurement.section import ANGLE_SETS, MeasuredSection, start_patterns
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.window.window import DesignerWindow
from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import PAINT_ENDING, load_any_paint
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.paint_design.measured_start import START_SET, MeasuredStart, load_start
from brdf_suite.pipeline.material import file_kind, load_palette_file
from brdf_suite.progress import Progress
from brdf_suite.regular_files import open_regular

if TYPE_CHECKING:
    from brdf_suite.files.exports.format import ImportedPaints

KEY = "measured"
_SET = "measured/angles"
MOST_TABS = 12
"""A file of many paints is a palette: more tabs than these are unusable."""
_HEAD = 1 << 16


@dataclass(frozen=True)
class _Request:
    """What is to be read; ``document`` is the one to read again for, ``None`` for a new one."""

    path: str
    geometry: str
    document: int | None = None


class MeasuredControl(Feature, QObject):
    """Opens what is measured, or a paint that was not designed by angles, as the start of a design."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._tasks = TaskRunner(self, threads=1)
        self._kept: dict[int, tuple[str, MeasuredStart]] = {}
        self.section = MeasuredSection()
        self.host = window.add_section(KEY, tr("Measurement"), self.section, tab="paint")
        self.host.hide()
        self.section.again_requested.connect(self.read_again)
        self.section.standard_requested.connect(self._take_standard)
        self.action = window.add_command(
            "file",
            tr("New from &Measurement…"),
            "new_from_measurement",
            self.ask,
            "new_from_measurement",
            tip=tr(
                "Start a design from the readings of a virtual spectrophotometer on a measured reflectance"
            ),
        )
        session.document_switched.connect(self._show)
        session.documents.find_opener = self.find_opener

    def ask(self) -> None:
        """Ask for something measured, and start a design from it."""
        named = tr("Measured files and paints ({patterns})").format(patterns=start_patterns())
        path = self._session.documents.ask(named)
        if path is None:
            return

        def read(path: Path, progress: Progress) -> Opener:
            progress(0.0, path.name)
            return self.find_opener(path) or partial(self.open, path)

        self._session.documents.reading.begin(path, read, lambda opener: opener(), self._complain)

    def open(self, name_or_path: str | Path) -> None:
        """Read a measured file, or a paint of any kind, and open what was read as a new paint."""
        chosen = settings().value(_SET, START_SET, type=str)
        self._submit(_Request(str(name_or_path), chosen if chosen in dict(ANGLE_SETS) else START_SET))

    def find_opener(self, path: Path) -> Opener | None:
        """Read a file that is no paint designed by its angles; see :attr:`Documents.find_opener`."""
        handed = _handed_over(path)
        if handed is not None:
            return partial(self._open_all, path, handed)
        return partial(self._open_measured, path) if _is_measurement(path) else None

    def _open_measured(self, path: Path) -> None:
        self._session.documents.front.files.remember(path.absolute())
        self.open(path)

    def _open_all(self, path: Path, handed: ImportedPaints) -> None:
        """Open the paints of a hand-over, each in a tab of its own."""
        paints = [paint for paint in handed.paints if isinstance(paint, Paint)]
        for paint in paints[:MOST_TABS]:
            self._session.open_paint(paint)
        self._session.documents.front.files.remember(path.absolute())
        notes = [tr_core(note) for note in handed.notes]
        if len(paints) > MOST_TABS:
            text = tr("{name} contains {count} paints. The first {opened} were opened.")
            notes.insert(0, text.format(name=path.name, count=len(paints), opened=MOST_TABS))
        self._session.dismiss_message("open")
        if notes:
            self._session.show_message(Message("open", " ".join(notes), where=str(path)))

    def read_again(self, geometry: str) -> None:
        """Read the original of the document in front at another set of angles; one step."""
        key = self._session.document_key
        if key in self._kept:
            settings().setValue(_SET, geometry)
            self._submit(_Request(self._kept[key][0], geometry, key))

    def start_of_front(self) -> MeasuredStart | None:
        """Return the report of the document in front; ``None`` where it did not start from a measurement."""
        kept = self._kept.get(self._session.document_key)
        return None if kept is None else kept[1]

    def close(self) -> None:
        """End the thread."""
        self._tasks.stop()

    def _submit(self, request: _Request) -> None:
        progress = self._window.progress

        def moved(fraction: float, what: str) -> None:
            progress.set_job(KEY, fraction, what, lambda: self._tasks.cancel(KEY))

        def done(start: MeasuredStart) -> None:
            progress.end_job(KEY)
            self._opened(request, start)

        def failed(error: Exception) -> None:
            progress.end_job(KEY)
            self._complain(error)

        self._tasks.submit(KEY, _read, request, done, failed, moved)

    def _complain(self, error: Exception) -> None:
        self._session.show_message(message_of(error, "open", todo=tr("The open paints are unchanged.")))

    def _opened(self, request: _Request, start: MeasuredStart) -> None:
        self._session.dismiss_message("open")
        if request.document is None:
            self._session.open_paint(start.paint)
        elif request.document != self._session.document_key:
            return  # its tab is no longer in front; its result is not needed
        else:
            present = self._session.paint
            read = replace(start.paint, name=present.name, flakes=present.flakes, notes=present.notes)
            self._session.set_paint(read, tr("Measure Again"))
        self._kept[self._session.document_key] = (request.path, start)
        self._show()

    def _show(self) -> None:
        start = self.start_of_front()
        self.host.setVisible(start is not None)
        if start is not None:
            self.section.show_start(start)

    def _take_standard(self) -> None:
        standards = self._window.findChild(StandardControl)
        kept = self._kept.get(self._session.document_key)
        if standards is not None and kept is not None:
            standards.load(kept[0])


def _read(request: _Request, progress: Progress) -> MeasuredStart:
    return load_start(request.path, GEOMETRY_SETS[request.geometry], progress)


def _handed_over(path: Path) -> ImportedPaints | None:
    """Read the paints of a file that was handed over (CxF3, CSV, JSON), known by its content; None for any other."""
    if path.suffix.lower() == PAINT_ENDING:
        return None
    from brdf_suite.files.exports import FORMATS
    from brdf_suite.files.exports.format import ImportedPaints

    try:
        with open_regular(path) as stream:
            head = stream.read(_HEAD)
    except FileError:  # opening it as a paint says what is wrong
        return None
    for known in FORMATS:
        if known.sniff is not None and known.read is not None and known.sniff(head):
            return known.read(path)
    try:
        if file_kind(path) != "palette":
            return None
    except FileError:  # opening it as a paint says what is wrong
        return None
    read = load_palette_file(path)
    return ImportedPaints(tuple(to_paint(entry.content) for entry in read.palette), read.notes)


def _is_measurement(path: Path) -> bool:
    """Whether a file is a paint of another kind, or measured; false for all else, which opening reports."""
    try:
        kind = file_kind(path)
        return kind == "measured" or (kind == "paint" and not isinstance(load_any_paint(path), Paint))
    except SuiteError:
        return False
