"""The autosave of palettes of any size, with their history, encoded by a thread while it takes long.

The states of a history share most of their entries: each entry is written once, and a state names its entries by their
places in that list.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recovery import (
    MOST_STATES,
    KeptHistory,
    Recovered,
    Recovery,
    flush_later,
    kept_content,
    remove_autosave,
)
from brdf_qt.program.translation import tr
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_color_swatch.library.history import StepMark, StepMarks
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import (
    entry_from_json,
    entry_to_json,
    palette_from_json,
    palette_to_json,
    without_collection,
)
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.progress import Progress
from brdf_suite.regular_files import exists

_MANY = 300
"""Fewer swatches are written within a frame or two."""
_MOST_PLACES = 1_000_000
"""Entries of all states of a history together: of very large palettes fewer states are kept."""
_Texts = dict[int, tuple[Entry, str]]


@dataclass(frozen=True)
class KeptPalette:
    """The history of a palette, and the mark of each of its steps, which are one fewer than its states."""

    history: KeptHistory[Palette]
    marks: tuple[StepMark, ...]


class PaletteRecovery(Recovery[Palette]):
    """As :class:`Recovery`, and what it reads is the same file; ``marks`` gives the steps of a store's history.

    An encoding that has begun is finished and written, however many edits come meanwhile: the next one begins when it
    is done. So what may be lost is about a second and the time of the encoding, also while edits never cease.
    """

    def __init__(
        self,
        store: DocumentStore[Palette],
        form: DocumentFormat[Palette],
        failed: Callable[[BaseException], None],
        tasks: TaskRunner,
        parent: QObject | None = None,
        *,
        marks: Callable[[DocumentStore[Palette]], StepMarks] = lambda _store: StepMarks((), ()),
    ) -> None:
        super().__init__(store, form, failed, parent, keeps_history=True)
        self._tasks, self._marks = tasks, marks
        self._key = f"autosave {id(self)}"
        self._texts: _Texts = {}
        self._encodes = self._encode_again = False
        self._drafts = 0
        self._draft: Path | None = None
        """What a thread writes now, or has written."""
        store.clean_changed.connect(self._saved)
        self.timer.timeout.disconnect(self.write)
        self.timer.timeout.connect(self.write_in_background)

    def saved(self) -> Recovered[Palette]:
        """Return what the file of the autosave holds."""
        return self._read(self.file)

    def kept(self, file: Path, value: Palette) -> KeptPalette | None:
        """Return the history in an autosave; None where there is none that ends at ``value``: the work counts."""
        try:
            with without_collection():
                found = _kept(kept_content(file)["history"], file)
        except (ValueError, KeyError, TypeError, LookupError, RecursionError, SuiteError):
            return None
        return found if found.history.states[found.history.place][1] == value else None

    def saved_files(self) -> dict[Path, Path]:
        """Return where the histories of saved palettes of ended runs are, by the palette's file; others are removed."""
        found: dict[Path, tuple[str, Path]] = {}
        for file in self.folder.glob("*.history.json"):
            if not self._has_ended(file):
                continue
            try:
                content = kept_content(file)
                path, when = Path(content["path"]), str(content["time"])
            except (FileError, ValueError, KeyError, TypeError, RecursionError):
                remove_autosave(file)
                continue
            older = found.get(path)
            if older is not None:
                remove_autosave(min((when, file), older)[1])
            try:
                is_there = exists(path)
            except FileError:  # it may be there, on a drive that does not answer
                continue
            if is_there:
                found[path] = max((when, file), older or ("", file))
            else:
                remove_autosave(file)
        return {path: file for path, (_, file) in found.items()}

    def write(self) -> bool:
        """Write the unsaved palette now, and wait for it; see :meth:`Recovery.write`."""
        self._drop()
        return super().write()

    def _write(self) -> None:
        self._write_now(self.file)

    @property
    def _keeps_saved(self) -> bool:
        return self._store.path is not None and self._store.stack.count() > 0

    def _write_saved(self) -> None:
        if self._keeps_saved:
            self._write_now(self._saved_file)
        else:
            remove_autosave(self._saved_file)

    def _read_history(self, _content: Any, _value: Palette, _file: Path) -> None:
        """Leave the history where it is until :meth:`kept` is asked for it: that of a large palette takes long."""

    def _write_now(self, file: Path) -> None:
        write_draft((self._request(), self._new_draft()), lambda *_: None).replace(file)
        flush_later(file)

    def _new_draft(self) -> Path:
        # One that was dropped may still be being written.
        self._drafts += 1
        return self.file.with_suffix(f".{self._drafts}.tmp")

    def _drop(self) -> None:
        self._tasks.cancel(self._key)
        if self._draft is not None:
            self._draft.unlink(missing_ok=True)
            self._draft = None
        self._encodes = self._encode_again = False

    def _saved(self, clean: bool) -> None:
        """What is being encoded is older than what was saved: it shall not be offered instead of it."""
        if clean:
            self._drop()

    def _request(self) -> _Request:
        """Return what is to be written: of a saved palette the history alone."""
        store = self._store
        marks, place = self._marks(store), store.stack.index()
        size = max(1, len(store.value) + len(store.value.groups))
        most = max(1, min(MOST_STATES, _MOST_PLACES // size) - 1)
        most_done = min(most, place)
        done = marks.done[-most_done:] if most_done else ()
        undone = marks.undone[: min(most - len(done), store.stack.count() - place)]
        first, last = place - len(done), place + len(undone)
        clean = store.stack.cleanIndex()
        states = store.states()[first : last + 1]
        history = KeptHistory(states, place - first, clean - first if first <= clean <= last else -1)
        value = None if store.is_clean else store.value
        return self.head(), value, KeptPalette(history, (*done, *undone)), self._texts

    def write_in_background(self) -> None:
        """Write the unsaved palette now; a large one is encoded by a thread."""
        self.timer.stop()
        if len(self._store.value) < _MANY or (self._store.is_clean and not self._keeps_saved):
            self.write()
            return
        if self._encodes:
            self._encode_again = True
            return
        self._encodes = True
        request, self._draft = self._request(), self._new_draft()
        self._tasks.submit(
            self._key,
            write_draft,
            (request, self._draft),
            lambda draft: self._on_encoded(draft, saved=request[1] is None),
            self._on_encoding_failed,
        )

    def _on_encoded(self, draft: Path, *, saved: bool) -> None:
        self.take_draft(draft, saved=saved)
        self._draft = None
        self._encode_next()

    def _on_encoding_failed(self, error: Exception) -> None:
        if isinstance(error, OSError):
            self._report_unwritten(error, self.file)
        else:
            self._failed(error)
        self._draft = None
        self._encode_next()

    def _encode_next(self) -> None:
        wants, self._encodes, self._encode_again = self._encode_again, False, False
        if wants and not self._closed:
            self.write_in_background()

    def take_draft(self, draft: Path, *, saved: bool = False) -> None:
        """Make a draft the autosave: here, so that it never comes after the file was removed because all is saved.

        ``saved``: it is the history of a saved palette.
        """
        if self._closed or self._store.is_clean is not saved:
            draft.unlink(missing_ok=True)
            return
        file, other = (self._saved_file, self.file) if saved else (self.file, self._saved_file)
        self._hold_lock()
        try:
            draft.replace(file)
            flush_later(file)
            remove_autosave(other)
        except OSError as error:
            draft.unlink(missing_ok=True)
            self._report_unwritten(error, file)
            return
        if self._fails:
            self._fails = False
            self.written_again.emit()

    def _report_unwritten(self, error: OSError, file: Path) -> None:
        reason = tr("the autosave cannot be written ({reason})").format(reason=error.strerror or error)
        self._fails = True
        self._failed(FileError(file, reason))

    def close(self, *, keep: bool) -> None:
        self._drop()
        super().close(keep=keep)


_Request = tuple[dict[str, Any], Palette | None, KeptPalette, _Texts]


_AT_ONCE = 1000
"""Entries whose texts are handed out together: of a hundred thousand the whole text would be 200 MB."""


def write_draft(request: tuple[_Request, Path], progress: Progress) -> Path:
    """Write an autosave's content to a file beside it, and return its path; none stays where that is cancelled."""
    content, draft = request
    try:
        with draft.open("wb") as file:
            for part in encode_autosave(content, progress):
                file.write(part.encode("utf-8", "backslashreplace"))  # names of files may be no text
        progress(1.0, "")
    except BaseException:
        draft.unlink(missing_ok=True)
        raise
    return draft


def encode_autosave(request: _Request, progress: Progress) -> Iterator[str]:
    """Yield the autosave's content: entry by entry, so that the window's thread gets its turns in between."""
    head, palette, kept, known = request
    progress(0.0, "")
    used: _Texts = {}
    places: dict[int, int] = {}

    def text_of(entry: Entry) -> str:
        found = used.get(id(entry)) or known.get(id(entry))
        if found is None or found[0] is not entry:
            found = (entry, _dumps(entry_to_json(entry)))
        used[id(entry)] = found
        return found[1]

    def list_of(entries: Sequence[Entry]) -> Iterator[str]:
        for start in range(0, len(entries), _AT_ONCE):
            progress(0.5, "")  # here it ends where it is cancelled
            yield (", " if start else "[") + ", ".join(map(text_of, entries[start : start + _AT_ONCE]))
        yield "]" if entries else "[]"

    with without_collection():
        yield _dumps(head)[:-1]
        if palette is not None:
            yield f', "document": {_around(palette)[:-1]}, "entries": '
            yield from list_of(palette.entries)
            yield "}"
        table: list[Entry] = []
        rows = []
        for name, state in kept.history.states:
            for entry in state.entries:
                if id(entry) not in places:
                    places[id(entry)] = len(table)
                    table.append(entry)
            numbers = [places[id(entry)] for entry in state.entries]
            rows.append(f"[{_dumps(name)}, {_around(state)}, {_dumps(_runs(numbers))}]")
        numbers_of = {"place": kept.history.place, "saved": kept.history.saved, "marks": kept.marks}
        yield f', "history": {_dumps(numbers_of)[:-1]}, "entries": '
        yield from list_of(table)
        yield f', "states": [{", ".join(rows)}]}}}}'
    known.clear()
    known.update(used)


def _around(palette: Palette) -> str:
    """Return a palette without its entries as JSON."""
    around = palette_to_json(replace(palette, entries=()))
    del around["entries"]
    return _dumps(around)


def _kept(content: dict[str, Any], file: Path) -> KeptPalette:
    table = [entry_from_json(one, file) for one in content["entries"]]
    states = []
    for name, around, runs in content["states"][:MOST_STATES]:
        palette = palette_from_json({**around, "entries": []}, file)
        entries = tuple(table[number] for start, count in runs for number in range(start, start + count))
        states.append((str(name), replace(palette, entries=entries)))
    place, saved = int(content["place"]), int(content["saved"])
    marks = tuple(StepMark(int(serial), int(stores)) for serial, stores in content["marks"])
    if not 0 <= place < len(states) or not -1 <= saved < len(states) or len(marks) != len(states) - 1:
        raise ValueError("the history does not fit together")
    return KeptPalette(KeptHistory(tuple(states), place, saved), marks)


def _runs(numbers: Sequence[int]) -> list[tuple[int, int]]:
    """Return the start and the length of each run of numbers that follow one another.

    >>> _runs([4, 5, 6, 2, 3, 9])
    [(4, 3), (2, 2), (9, 1)]
    """
    runs: list[tuple[int, int]] = []
    for number in numbers:
        if runs and sum(runs[-1]) == number:
            runs[-1] = (runs[-1][0], runs[-1][1] + 1)
        else:
            runs.append((number, 1))
    return runs


def _dumps(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))
