"""Joins the standard to the paint session: one for each document, judged again at every edit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import decimal, moment, tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from brdf_designer.documents.tabs import OpenDocument
from brdf_designer.from_measurement.section import standard_patterns
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison import records
from brdf_designer.standard_comparison.records import DocumentStandards, Record, Swap, record_from_json
from brdf_designer.standard_comparison.section import StandardSection
from brdf_designer.standard_comparison.settings import ToleranceSettings, load, save
from brdf_designer.standard_comparison.state import say, state_of, verdict_word
from brdf_designer.window.window import DesignerWindow
from brdf_suite.appearance.difference.tolerance import Tolerances
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.paint_design.standard import BatchReport, Standard, judge_batch, paint_like, standard_of
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import paint_names
from brdf_suite.progress import Progress
from brdf_suite.regular_files import is_file

KEY = "standard"
_BATCHES, _KEPT = "standard batches", "standard kept"
_MOST_READ_AHEAD = 20
MOST_BATCHES = 200
_TAB, _SHIPPED = "tab ", "shipped "


class StandardControl(Feature, QObject):
    """The standards of all documents; the one in front is shown, in its section and in the patches."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._kept: dict[int, DocumentStandards] = {}
        self._settings = load()
        self._tasks = TaskRunner(self)
        self._shown = False
        self._angles: list[float] | None = None
        self.section = StandardSection()
        self.host = window.add_section(KEY, tr("Standard"), self.section, tab="compare")
        self._add_commands()
        section = self.section
        section.take_requested.connect(self.take_present)
        for asked in (section.load_requested, window.load_standard.clicked):
            asked.connect(lambda *_: self.ask_standard())
        section.known_list_requested.connect(self._show_known)
        section.known_requested.connect(self.load_known)
        section.swap_requested.connect(self.swap)
        section.remove_requested.connect(self.remove)
        section.chosen.connect(self.choose)
        section.formula_chosen.connect(lambda name: self.judge_by(replace(self._settings, difference=name)))
        section.tolerances.limit_edited.connect(
            lambda *limit: self.judge_by(self._settings.with_limit(*limit))
        )
        section.ellipsoid_chosen.connect(lambda on: self.judge_by(replace(self._settings, ellipsoid=on)))
        section.add_batches_requested.connect(lambda: self._ask(self.add_batches))
        section.clear_batches_requested.connect(lambda: self._set_batches(()))
        section.batches.opened.connect(self._open_batch)
        section.tolerances.refused.connect(
            lambda text: session.show_message(Message(KEY, text, severity="warning"))
        )
        section.batch_section.toggled.connect(lambda _on: self._batches_later())
        self.host.toggled.connect(lambda _on: self.refresh())
        session.paint_changed.connect(self._paint_changed)
        session.document_switched.connect(self._switched)
        session.documents.row_changed.connect(self._batches_later)
        self._known: set[int] = set()
        for document in session.documents.row:
            self._take(document)
        session.documents.opened.connect(self._take)
        self._switched()

    # What the user asks for.

    @property
    def standard(self) -> Standard | None:
        """The standard of the document in front."""
        return self._of_front.standard

    @property
    def tolerances(self) -> Tolerances:
        """The user's formula and tolerances, as the core takes them."""
        return self._settings.tolerances()

    def take_present(self) -> None:
        """Take the paint as it is now as the standard."""
        time = moment(datetime.now())
        self.set_standards([standard_of(self._session.paint, tr("State of {time}").format(time=time))])

    def ask_standard(self) -> None:
        """Ask for a file and load it."""
        focused = self._window.focusWidget()
        self._ask(lambda path: self.load(path, focused))

    def load(self, name_or_path: str | Path, focused: QWidget | None = None) -> None:
        """Load the standards in a file, or a shipped paint, beside the paint.

        ``focused`` had the keyboard when it was asked for: where it has it still, the reading that is farthest from
        the standard gets it.
        """
        path = Path(name_or_path)
        source = str(path.absolute()) if is_file(path) else ""
        focused = focused or self._window.focusWidget()

        def take(found: tuple[Standard, ...]) -> None:
            self.set_standards(found, source=source)
            if focused in (None, self._window.focusWidget()):  # else the user is at something else by now
                self._lead_to_worst()

        self._read(KEY, name_or_path, take)

    def _lead_to_worst(self) -> None:
        """Let the reading be edited at once that is farthest from the standard, where there is a difference."""
        standard = self.standard
        if standard is None:
            return
        rows = self.report(self._session.paint, standard).rows
        judged = ((row.verdict.difference, n) for n, row in enumerate(rows) if row.verdict is not None)
        difference, worst = max(judged, default=(0.0, 0))
        if difference > 0.0:
            self._window.edit_reading(worst)

    def load_known(self, key: str) -> None:
        """Take an open tab's paint as it is now, or a shipped one, by its key in the menu of Load."""
        if key.startswith(_SHIPPED):
            self.load(key.removeprefix(_SHIPPED))
            return
        found = [one for one in self._session.documents.row if f"{_TAB}{one.key}" == key]
        if found:
            self.set_standards([standard_of(found[0].store.value, found[0].title)])

    def _show_known(self) -> None:
        documents = self._session.documents
        tabs = [(f"{_TAB}{one.key}", one.title) for one in documents.row if one is not documents.front]
        shipped = [(f"{_SHIPPED}{name}", title_of(name)) for name in paint_names()]
        self.section.show_known(tabs, shipped)

    def set_standards(self, standards: Sequence[Standard], chosen: int = 0, source: str = "") -> None:
        """Give the document in front these standards to choose from; ``source`` is the file that has them."""
        kept = self._of_front
        kept.standards, kept.chosen, kept.source, kept.awaited = tuple(standards), chosen, source, None
        # What is opened next may not take the place of a tab that has a standard.
        self._session.documents.front.pristine = False
        self._show_choices()
        self.host.set_open(True)
        self.refresh()
        self._note()

    def choose(self, index: int) -> None:
        """Judge against another standard of the same file."""
        self._of_front.chosen = index
        self.refresh()
        self._note()

    def remove(self) -> None:
        """Judge against nothing."""
        self._of_front.standards = ()
        self._of_front.awaited = None
        self.refresh()
        self._note()

    def swap(self) -> None:
        """Edit the standard, and judge it against what was edited; one step, which undo takes back whole."""
        kept, paint = self._of_front, self._session.paint
        standard = kept.standard
        if standard is None:
            return
        try:
            after = paint_like(standard, paint)
        except SuiteError as error:
            self._session.show_message(message_of(error, KEY, todo=tr("The paints were not swapped.")))
            return
        turned = standard_of(paint, tr("Swapped with {name}").format(name=standard.name))
        kept.swaps.append(Swap(paint, standard, after, turned))
        self._turn(turned)
        if after == paint:
            self.refresh()
        self._session.set_paint(after, tr("Swap with Standard"))

    # Showing.

    def refresh(self) -> None:
        """Judge and show; called at every edit, so it does no more than is seen."""
        standard, paint = self.standard, self._session.paint
        for action in (self.swap_action, self.remove_action):
            action.setEnabled(standard is not None)
        if standard is None:
            if self._shown:
                self._window.show_standard(None, {})
                self._shown = False
            self.section.show_state(None)
            return
        report = self.report(paint, standard)
        state = state_of(standard, paint, report)
        labs = {n: row.standard for n, row in enumerate(report.rows) if row.standard is not None}
        self._window.show_standard(state.patches, labs)
        self._shown = True
        if self.host.is_open:
            self.section.show_state(state)
            angles = sorted({m.aspecular_deg for m in paint.measurements})
            if angles != self._angles:
                self._angles = angles
                self.section.show_settings(angles, self._settings)
        self._batches_later()

    def report(self, paint: Paint, standard: Standard) -> BatchReport:
        """Return how a paint does against a standard, by the user's formula and tolerances."""
        return judge_batch(standard, paint, self._settings.tolerances())

    def batches(self) -> list[Paint]:
        """Return what the table judges: every open tab, the one in front first, then what was added."""
        documents = self._session.documents
        others = [one.store.value for one in documents.row if one is not documents.front]
        return [self._session.paint, *others, *self._of_front.batches]

    @property
    def _of_front(self) -> DocumentStandards:
        return self._kept.setdefault(self._session.document_key, DocumentStandards())

    def _switched(self) -> None:
        self._angles = None
        self._show_choices()
        self.refresh()
        self._read_again()

    def _paint_changed(self, paint: Paint) -> None:
        kept = self._of_front
        for swap in kept.swaps:
            # The very objects: what undo and redo put back, and no edit that only looks the same.
            if paint is swap.paint_before and kept.standard is swap.standard_after:
                self._turn(swap.standard_before)
                break
            if paint is swap.paint_after and kept.standard is swap.standard_before:
                self._turn(swap.standard_after)
                break
        self.refresh()

    def _turn(self, standard: Standard) -> None:
        kept = self._of_front
        kept.standards, kept.chosen, kept.source = (standard,), 0, ""
        self._show_choices()
        self._note()

    # From run to run.

    def _record(self, key: int) -> Record | None:
        return self._kept[key].record() if key in self._kept else None

    def _take(self, document: OpenDocument) -> None:
        """Give a document that is opened the standard that it had; its file is read where it comes in front."""
        key = document.key

        def beside() -> object:
            record = self._record(key)
            return None if record is None else record.to_json()

        document.recovery.beside = beside
        if key in self._known:
            # It was closed and reopened, with an autosave that is new.
            document.recovery.note()
            return
        self._known.add(key)
        document.store.path_changed.connect(lambda _path: self._keep(document))
        record = record_from_json(document.beside)
        if record is None and document.beside is None and document.store.path is not None:
            record = records.kept(document.store.path)
        if record is not None:
            awaited = record if record.source else None
            self._kept[key] = DocumentStandards((record.standard,), 0, record.source, awaited)
            document.recovery.note()

    def _keep(self, document: OpenDocument) -> None:
        """Keep the standard of a document: with the file it is in, or with the autosave while it has none."""
        document.recovery.note()
        path = document.store.path
        if path is None:
            return
        try:
            records.keep(path, self._record(document.key))
        except FileError as error:
            reason = f"its standard cannot be kept for the next start ({error.reason})"
            self._session.show_message(message_of(FileError(path, reason), _KEPT))
        else:
            self._session.dismiss_message(_KEPT)

    def _read_again(self) -> None:
        """Read the file of a standard that was kept: what else is in it, and a reflectance that was measured."""
        key, kept = self._session.document_key, self._of_front
        record = kept.awaited
        if record is None:
            return

        def take(found: tuple[Standard, ...]) -> None:
            if kept.awaited is not record:
                return
            kept.awaited = None
            if record.is_of(found):
                kept.standards, kept.chosen = found, record.chosen
            else:
                kept.source = ""
                self._report_kept(tr("{file} has changed.").format(file=record.source))
            if key == self._session.document_key:
                self._show_choices()
                self.refresh()

        def failed(_error: Exception) -> None:
            if kept.awaited is record:
                kept.awaited = None
                self._report_kept(tr("{file} can no longer be read.").format(file=record.source))

        self._tasks.submit(f"{KEY} again", _load, (record.source, self._session.paint), take, failed)

    def _report_kept(self, what: str) -> None:
        todo = tr("The stored standard is used. Load the file again to use its current contents.")
        self._session.show_message(Message(KEY, what, todo=todo))

    def _note(self) -> None:
        self._keep(self._session.documents.front)

    def _show_choices(self) -> None:
        kept = self._of_front
        self.section.show_choices([_title(one) for one in kept.standards], kept.chosen)

    def _show_batches(self) -> None:
        standard = self.standard
        if standard is None or not (self.host.is_open and self.section.batch_section.is_open):
            return
        rows = []
        for paint in self.batches():
            report = self.report(paint, standard)
            word = verdict_word(report.passes)
            cells = (paint.name, _number(report.largest), _number(report.mean), word)
            rows.append((cells, report.passes, report.sentence(say)))
        self.section.batches.show_batches(rows)
        self.section.clear_batches.setEnabled(bool(self._of_front.batches))

    def _batches_later(self) -> None:
        if self.host.is_open and self.section.batch_section.is_open:
            self._session.at_idle(_BATCHES, self._show_batches)

    # Formula and tolerances.

    def judge_by(self, chosen: ToleranceSettings) -> None:
        """Judge by this formula and these tolerances, and keep them for the next run."""
        self._settings = chosen
        save(chosen)
        self._angles = None
        self.refresh()

    # Files.

    def _ask(self, then: Callable[[Path], None]) -> None:
        named = tr("Standards ({patterns})").format(patterns=standard_patterns())
        if (path := self._session.documents.ask(named)) is not None:
            then(path)

    def add_batches(self, path: str | Path) -> None:
        """Judge every paint in a file against the standard too."""
        self._read(_BATCHES, path, self._take_batches)

    def _take_batches(self, found: Sequence[Standard]) -> None:
        kept = self._of_front
        refused: list[str] = []
        paints = []
        for one in found:
            try:
                paints.append(paint_like(one, self._session.paint))
            except SuiteError as error:
                refused.append(str(error))
        if refused:
            what = tr("Some paints cannot be compared: {reasons}").format(reasons=" ".join(refused[:3]))
            self._session.show_message(Message(_BATCHES, what, severity="warning"))
        self.section.batch_section.set_open(True)
        self._set_batches((*kept.batches, *paints)[:MOST_BATCHES])

    def _set_batches(self, batches: tuple[Paint, ...]) -> None:
        self._of_front.batches = batches
        self._show_batches()

    def _open_batch(self, index: int) -> None:
        documents = self._session.documents
        others = [one for one in documents.row if one is not documents.front]
        if 1 <= index <= len(others):
            documents.show(others[index - 1])
        elif index > len(others):
            self._session.open_paint(self._of_front.batches[index - 1 - len(others)], clean=True)

    def _read(self, key: str, name_or_path: str | Path, done: Any) -> None:
        front = self._session.document_key

        def take(found: tuple[Standard, ...]) -> None:
            self._session.dismiss_message(key)
            if front == self._session.document_key:
                done(found)

        self._tasks.submit(
            key,
            _load,
            (str(name_or_path), self._session.paint),
            take,
            lambda error: self._session.show_message(message_of(error, key)),
        )

    def _add_commands(self) -> None:
        add = self._window.add_command
        add("paint", tr("Use This State as &Standard"), "take_standard", self.take_present, "take_standard")
        add("paint", tr("&Load Standard…"), "load_standard", self.ask_standard, "load_standard")
        self.swap_action = add("paint", tr("S&wap with Standard"), None, self.swap, "swap_standard")
        self.remove_action = add("paint", tr("&Remove Standard"), None, self.remove, "remove_standard")


def _load(request: tuple[str, Paint], progress: Progress) -> tuple[Standard, ...]:
    """Read the standards of a file, and what they will be asked for by the judged paint; on a thread."""
    name_or_path, paint = request
    found = load_standards(name_or_path, progress)
    # What has to be measured of it is measured here, and not in the first edit that is judged.
    for standard in found[:_MOST_READ_AHEAD]:
        for reading in paint.measurements:
            standard.lab_at(reading.illumination_deg, reading.aspecular_deg)
    return found


def _title(standard: Standard) -> str:
    return f"{standard.name}  ({tr_core(standard.origin)})" if standard.origin else standard.name


def _number(value: float | None) -> str:
    return "–" if value is None else decimal(f"{value:.2f}")
