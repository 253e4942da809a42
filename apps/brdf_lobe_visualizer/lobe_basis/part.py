"""The part of the window that shows the lobes' basis: which exponents for how many lobes, and what they are worth.

It shows a search: that of the shipped paints, of a folder of the user's, or one in a file, also while it runs; a search
of a folder can be started here, in a process of its own. Beside the search's errors stands that of the selected
reflectance, live.
"""

from __future__ import annotations

import hashlib
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.documents.watch import FileWatch
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import ElidedLabel
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings, state_folder
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.window.progress_strip import ProgressStrip
from brdf_qt.work.command_process import CommandProcess
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog, QMenu, QPushButton, QToolButton, QWidget

from brdf_lobe_visualizer.lobe_basis.paints import FolderPaints, PaintsIn
from brdf_lobe_visualizer.lobe_basis.plots import MOST_LOBES, BasisPlots
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.fitting.lobes.basis import STORED_NAME
from brdf_suite.progress import Progress
from brdf_suite.regular_files import is_file, is_folder
from brdf_suite.resources import resource, resource_root

if TYPE_CHECKING:
    from brdf_suite.fitting.basis_search.document import StoredSearch
    from brdf_suite.inspection.basis_of_paint import ErrorsOverCount


class BasisRun(CommandProcess):
    """One search over the paints of ``folder``, written to ``output``."""

    def __init__(self, folder: Path, output: Path, lobes: int, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.folder, self.output, self.lobes = folder, output, lobes

    @property
    def state(self) -> Path:
        """The file that holds what is found so far."""
        return self.output.with_name(self.output.name + ".part")

    def start(self) -> None:
        """Begin, or resume from what is kept."""
        from brdf_suite.fitting.basis_search.search import usable_cores  # much to import for a start

        # A core is left to the windows.
        workers = max(1, usable_cores() - 1)
        words = ["basis", "--database", str(self.folder), "-o", str(self.output)]
        self.run_command(*words, "--lobes", str(self.lobes), "--workers", str(workers))


BASIS = "basis"
_FOLDER_KEY = "lobes/basis_folder"
_TASK = "basis/own"


class BasisView(QWidget):
    """The plots with their buttons, a note, and the progress of a search."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("basis_view")
        self.setMinimumSize(260, 140)
        self.plots = BasisPlots()
        self.note = ElidedLabel()
        self.progress = ProgressStrip()
        tip = tr("Search for the exponents that best fit these paints. Takes minutes.")
        self.search = described(QPushButton(tr("Search")), name="basis_search", tip=tip)
        tip = tr("Paints that the search optimises the lobes for")
        self.database = described(QToolButton(), name="basis_database", tip=tip)
        self.database.setText(tr("Database"))
        self.database.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.database)
        menu.setToolTipsVisible(True)
        self.choose = menu.addAction(tr("Folder of Paints…"))
        self.choose.setToolTip(tr("Use another folder of paints as the database"))
        self.open = menu.addAction(tr("Open a Search…"))
        self.open.setToolTip(tr("Show a finished or running search from a file"))
        menu.addSeparator()
        self.reset = menu.addAction(tr("Sample Paints"))
        self.reset.setToolTip(tr("Return to the sample paints and their search"))
        self.database.setMenu(menu)
        head = row_of(self.note, self.search, self.database, grows=self.note, spacing=4)
        fill_column(self, head, self.plots, self.progress, grows=self.plots, spacing=4)


class Basis(Feature, QObject):
    """Shows a search and the selected reflectance's errors; starts searches."""

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session, self.window = session, window
        self.view = BasisView()
        kept = str(settings().value(_FOLDER_KEY, "") or "")
        self.folder = Path(kept) if kept and is_folder(kept) else _shipped()
        self.search: StoredSearch | None = None
        self.run: BasisRun | None = None
        self._source: Path | None = None
        self._shown_source: Path | None = None
        self._own_of: tuple[Any, Any] | None = None
        self._working = self._built = self._follows_run = self._wants_search = False
        self._reading = FileReading(window.progress, self)
        self._watch = FileWatch(self)
        self._watch.changed.connect(lambda _path: self._read())
        self.paints = FolderPaints(session, self)
        self.paints.changed.connect(self._paints_seen)
        self._output_of: tuple[Path, Path] | None = None
        window.plots.add(BASIS, tr("Basis"), self.view)
        self.view.search.clicked.connect(self.start_search)
        self.view.choose.triggered.connect(self._choose_folder)
        self.view.open.triggered.connect(self._choose_file)
        self.view.reset.triggered.connect(self.show_shipped)
        window.add_command("view", mark("Show the Basis"), None, lambda: window.plots.set_shown(BASIS, True))
        self._timer = make_timer(self, self._refresh)
        for signal in (session.subjects_changed, session.front_changed):
            signal.connect(self._timer.start)
        window.plots.shown_changed.connect(lambda _key, _shown: self._timer.start())
        window.first_painted.connect(self._timer.start)

    @property
    def is_idle(self) -> bool:
        """Whether all that is shown is there; a search that the user has started is not waited for."""
        waits = self._working or self.paints.busy or not self._reading.is_idle or self._timer.isActive()
        return not self._is_shown() or (self._built and not waits)

    def close(self) -> None:
        """End a search that runs; what it found is kept."""
        self._reading.close()
        if self.run is not None:
            self.run.stop()

    def show_shipped(self) -> None:
        self.show_folder(_shipped())

    def show_folder(self, folder: Path) -> None:
        """Take a folder of paints as the database; its search is shown where there is one."""
        if self.run is not None:
            self.run.cancel()
        elif not self.view.search.isEnabled():
            self._drop_search()
        self._follows_run = False
        self.folder = folder
        settings().setValue(_FOLDER_KEY, "" if folder == _shipped() else str(folder))
        self._follow_folder()

    def show_file(self, path: Path) -> None:
        """Show the search in a file, and what becomes of it while it runs."""
        self._source = path
        self._watch.watch(str(path))
        self._read()

    def start_search(self) -> None:
        """Search the exponents for the present folder, in a process of its own."""
        if self.run is not None or not self.view.search.isEnabled():
            return
        self.view.search.setEnabled(False)
        self.view.progress.set_job(BASIS, 0.0, tr("Scanning the folder for paints"), self._drop_search)
        self._wants_search = True
        self.paints.look()

    def _drop_search(self) -> None:
        self._wants_search = False
        self.view.progress.end_job(BASIS)
        self.view.search.setEnabled(True)

    def _paints_seen(self) -> None:
        self.show_note()
        if self._wants_search and self.paints.known is not None:
            self._wants_search = False
            self._begin_search(self.paints.known)

    def _begin_search(self, paints: PaintsIn) -> None:
        if not paints.count:
            self._drop_search()
            text = tr("there is no paint ({ending})").format(ending=PAINT_ENDING)
            self._session.messages.show_message(message_of(FileError(self.folder, text), BASIS))
            return
        run = BasisRun(self.folder, self._output(), max(1, min(MOST_LOBES, paints.count)), self)
        self.run = run
        self._follows_run = True
        words = tr("Searching a basis for {count} paints").format(count=paints.count)
        run.moved.connect(lambda fraction, what: self._moved(fraction, f"{words}: {what}"))
        run.done.connect(self._done)
        run.failed.connect(self._failed)
        run.cancelled.connect(self._ended)
        self.view.progress.set_job(BASIS, 0.0, words, run.cancel)
        run.start()

    def _is_shown(self) -> bool:
        return BASIS in self.window.plots.shown()

    def _refresh(self) -> None:
        if not self._is_shown():
            return
        if not self._built:
            self._built = True
            self.view.plots.build()
            self._follow_folder()
        self._ask_own()

    def _follow_folder(self) -> None:
        self.paints.follow(self.folder)
        if self.folder == _shipped():
            self.show_file(Path(str(resource("basis", STORED_NAME))))
            return
        output = self._output()
        state = output.with_name(output.name + ".part")
        self._source = output if is_file(output) else state if is_file(state) else None
        self._watch.watch("" if self._source is None else str(self._source))
        self._read()

    def _read(self) -> None:
        """Read the search that is shown, on a thread; on an error a message is shown and the old one stays."""
        source = self._source
        if source is None:
            self._take(None, None)
            return

        def done(search: StoredSearch) -> None:
            if source == self._source:
                self._session.messages.dismiss_message(BASIS)
                self._take(search, source)

        def failed(error: Exception) -> None:
            if source == self._source:
                self._session.messages.show_message(message_of(error, BASIS))
                self._take(self.search, self._shown_source)

        self._reading.begin(source, _load, done, failed)

    def _take(self, search: StoredSearch | None, source: Path | None) -> None:
        self.search, self._shown_source = search, source
        if self._built:
            self.view.plots.show_search(search)
            self.show_note()
            self._ask_own()

    def show_note(self) -> None:
        search, words = self.search, [self._name()]
        if search is None or not search.results:
            words.append(tr("no search yet: choose Search"))
        else:
            words.append(tr("{count} targets").format(count=len(search.paints)))
            partial, whole = tr("{count} lobe counts so far"), tr("default: {count} lobes")
            text = partial if search.default_count is None else whole
            words.append(text.format(count=search.default_count or len(search.results)))
            if search.date:
                words.append(search.date)
            if self._is_stale(search):
                words.append(tr("paints changed since the search: search again"))
        own = self.view.plots.own
        if own is not None and not own[1].whole:
            words.append(tr("{name}: colour error only, no separate coat").format(name=own[0].title))
        self.view.note.setText(" · ".join(words))

    def _name(self) -> str:
        if self._is_other():
            assert self._shown_source is not None
            return self._shown_source.name
        return tr("Sample paints") if self.folder == _shipped() else self.folder.name

    def _is_other(self) -> bool:
        """Whether a search is shown that is neither the folder's nor the shipped one."""
        return self._shown_source is not None and self._shown_source.parent not in (
            self._output().parent,
            Path(str(resource("basis", STORED_NAME))).parent,
        )

    def _is_stale(self, search: StoredSearch) -> bool:
        if self._is_other():
            return False  # a file of its own: its paints are unknown
        paints = self.paints.known
        # Until the folder has been looked at nothing is said; without a sum the paints have gone.
        return paints is not None and paints.sha256 != search.sha256

    def _output(self) -> Path:
        """Return where a search of the present folder is kept: by the folder's place."""
        if self._output_of is None or self._output_of[0] != self.folder:
            place = hashlib.sha256(os.fsencode(self.folder.resolve())).hexdigest()[:16]
            self._output_of = self.folder, state_folder("basis") / f"{place}.json"
        return self._output_of[1]

    def _ask_own(self) -> None:
        """Ask a thread for the errors of the front subject; one at a time, the newest next."""
        front, search = self._session.front, self.search
        if not self._built or not self._is_shown():
            return
        if front is None or search is None or not search.results:
            self._own_of = None
            self.view.plots.show_own(None, None)
            return
        wanted = (front.reflectance, search.results)
        if self._working or (
            self._own_of is not None and self._own_of[0] is wanted[0] and self._own_of[1] == wanted[1]
        ):
            return
        self._working = True
        bases = {result.count: result.exponents for result in search.results}
        self._session.tasks.submit(
            _TASK,
            _errors,
            (front.reflectance, bases),
            lambda errors: self._own_ended(front.key, wanted, errors),
            lambda error: self._own_ended(front.key, wanted, None, error),
        )

    def _own_ended(
        self,
        key: str,
        wanted: tuple[Any, Any],
        errors: ErrorsOverCount | None,
        error: Exception | None = None,
    ) -> None:
        self._working = False
        self._own_of = wanted
        front = self._session.front
        if error is not None:
            self.view.plots.show_own(None, None)
            self._session.messages.show_message(message_of(error, _TASK))
        elif front is not None and front.key == key:
            self.view.plots.show_own(front, errors)
            self._session.messages.dismiss_message(_TASK)
        self.show_note()
        self._ask_own()

    def _moved(self, fraction: float, words: str) -> None:
        run = self.run
        if run is not None:
            self.view.progress.set_job(BASIS, fraction, words, run.cancel)
            if self._follows_run and self._source != run.state and is_file(run.state):
                self.show_file(run.state)

    def _done(self) -> None:
        run = self.run
        self._ended()
        if run is not None and self._follows_run:
            self.show_file(run.output)

    def _failed(self, words: str) -> None:
        self._ended()
        self._session.messages.show_message(message_of(SuiteError(words), BASIS))

    def _ended(self) -> None:
        self.view.progress.end_job(BASIS)
        self.view.search.setEnabled(True)
        if self.run is not None:
            self.run.deleteLater()
            self.run = None
        self.show_note()
        self.paints.look()  # changes in subfolders are not reported

    def _choose_folder(self) -> None:
        name = QFileDialog.getExistingDirectory(self.window, tr("Folder of Paints"), str(self.folder))
        if name:
            self.show_folder(Path(name))

    def _choose_file(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self.window, tr("Open a Search"), "", tr("Searches (*.json *.part);;All files (*)")
        )
        if name:
            self._follows_run = False
            self.show_file(Path(name))


def _errors(request: tuple[Any, dict[int, tuple[float, ...]]], progress: Any) -> ErrorsOverCount:
    from brdf_suite.inspection.basis_of_paint import errors_over_count

    return errors_over_count(*request, progress)


def _load(source: Path, _progress: Progress) -> StoredSearch:
    from brdf_suite.fitting.basis_search.document import load_search

    return load_search(source)


def _shipped() -> Path:
    return Path(str(resource_root() / "paints"))
