"""Reads the palettes of the library in the background: when first needed, and again when their file has changed.

A file is read with its rows, and with what the user is to know about it; unsaved work of earlier runs is recovered.
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from brdf_qt.documents.recovery import Recovered
from brdf_qt.documents.stamp import FileStamp, stamp_of
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message

from brdf_color_swatch.export.dialog import open_filters
from brdf_color_swatch.grid.rows import Rows, rows_of
from brdf_color_swatch.library.library import Item, Library
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, load_palette, without_collection
from brdf_suite.errors import DocumentError, FileError
from brdf_suite.progress import Progress

OURS = "brdfpalette"
PROFILE_KEY = "palette/cmyk_profile"
_MANY = 1000


@dataclass(frozen=True, eq=False)
class Read:
    """What a file held. ``is_ours``: it is a ``.brdfpalette``, which holds all that a palette has.

    ``seen`` is how many colours in CMYK have the look that the profile gives.
    """

    path: Path
    palette: Palette
    rows: Rows
    stamp: FileStamp | None
    is_ours: bool
    notices: tuple[str, ...] = ()
    seen: int = 0


def remembered_profile() -> Path | None:
    """Return the ICC profile that was chosen for colours in CMYK, if any."""
    path = str(settings().value(PROFILE_KEY, ""))
    return Path(path) if path else None


def read_palette_file(path: Path, progress: Progress, profile: Path | None = None) -> Read:
    """Read ``path`` of any format; raise :class:`~brdf_suite.errors.FileError` where it cannot be.

    Colours in CMYK of other programs' files are seen through the ICC ``profile``; one that cannot be used is a notice.
    """
    # Before the content: a change in between is then asked about once too often, never lost.
    stamp = stamp_of(path)
    progress(0.0, path.name)
    with without_collection():
        palette, notes, ours = _content(path)
        seen = 0
        if profile is not None and not ours:
            palette, seen, more = foreign_palettes().show_through(palette, profile)
            notes += more
        progress(0.8, path.name)
        rows = rows_of(palette.entries)
        # The window needs them at once, and would work them out on its own thread.
        _ = rows.groups, rows.tag_counts, rows.ids, rows.has_codes, rows.notes, rows.inks, palette.by_id
        if len(palette) >= _MANY:
            # They live long and are in no cycle: a collection that looks through all of them would hold up the window.
            gc.freeze()
    return Read(path.absolute(), palette, rows, stamp, ours, notes, seen)


def foreign_palettes() -> Any:
    """Return the module that reads other programs' files."""
    # With it come the parsers of every format, which a start and our own palettes need not wait for.
    from brdf_color_swatch.library import foreign

    return foreign


def _content(path: Path) -> tuple[Palette, tuple[str, ...], bool]:
    own: DocumentError | None = None
    if path.suffix.lower() == PALETTE_ENDING:
        try:
            return load_palette(path), (), True
        except DocumentError as error:
            # Perhaps another program's file under our ending; otherwise this is the error to report.
            own = error
    try:
        read = foreign_palettes().read_palette(path)
    except FileError:
        if own is not None:
            raise own from None
        raise
    return read.palette, tuple(read.notes), read.format.name == OURS


def _read(request: tuple[Path, Path | None], progress: Progress) -> Read:
    path, profile = request
    return read_palette_file(path, progress, profile)


class PaletteLoader:
    """Loads the files of a library."""

    def __init__(self, library: Library) -> None:
        self._library = library

    def load(self, key: str, then: Callable[[], None] | None = None) -> None:
        """Read a palette where it is not read yet, and call ``then`` once it is there."""
        item = self._library.item(key)
        if item is None:
            return
        if item.palette is not None:
            if then is not None:
                then()
            return
        if then is not None:
            item.waiting.append(then)
        if item.state == "reading" or item.path is None:
            return
        item.state, item.problem = "reading", ""
        self._library.items_changed.emit()
        self._library.tasks.submit(
            f"read {key}",
            _read,
            (item.path, remembered_profile()),
            lambda read: self.accept(key, read),
            lambda error: self._not_read(key, error),
        )

    def cancel_reading(self, key: str) -> None:
        self._library.tasks.cancel(f"read {key}")
        item = self._library.item(key)
        if item is not None and item.state == "reading":
            item.state = "closed"
            item.waiting.clear()
            self._library.items_changed.emit()

    def accept(self, key: str, read: Read) -> None:
        """Give the line of ``key`` what was read; ignored where the line is gone or has a palette already."""
        item = self._library.item(key)
        if item is None or item.palette is not None:
            # What is open may have been changed, or recovered; a file does not take its place unasked.
            return
        path, stamp = (read.path, read.stamp) if read.is_ours else (None, None)
        # What was imported is in its own file still: nothing would be lost with it until it is changed.
        origin = None if read.is_ours else read.path
        self._library.fill(item, read.palette, path, clean=True, stamp=stamp, rows=read.rows, origin=origin)
        self._library.remember_file(read.path)
        self._library.settled.emit(f"open {key}")
        # Ours are saved as they look here; of others it may be the first time that they are seen.
        rough = read.rows.notes if read.rows.inks and not read.is_ours else ()
        notices = tuple(dict.fromkeys((*read.notices, *rough)))
        if notices:
            one, several = tr("“{name}” imported with 1 note."), tr("“{name}” imported with {count} notes.")
            text = one if len(notices) == 1 else several
            text = text.format(name=read.path.name, count=len(notices))
            todo = "\n".join(map(tr_core, notices[:6])) + ("\n…" if len(notices) > 6 else "")
            choose = (tr("Choose CMYK Profile…"), lambda: self._library.profile_requested.emit(key))
            actions = (choose,) if rough or read.seen else ()
            self._library.message.emit(Message(f"open {key}", text, todo=todo, actions=actions))
        self._library.read.emit(key)
        item.run_waiting()

    def _not_read(self, key: str, error: Exception) -> None:
        item = self._library.item(key)
        if item is None:
            return
        item.state, item.problem = "wrong", tr_core(str(error))
        item.waiting.clear()
        self._library.items_changed.emit()
        todo = tr("The palette stays in the library; nothing else has changed.")
        self._library.fails(error, f"open {key}", todo)

    def ask_open(self, path: Path | None = None) -> str | None:
        """Open ``path``, or ask for a file; return its key. It is read in the background."""
        if path is None:
            recent = self._library.recent()
            folder = recent[0].parent if recent else Path.home()
            path = self._library.dialogs.open_path(folder, open_filters())
            if path is None:
                return None
        key = self._library.add_path(path)
        self.load(key)
        return key

    def reread(self, key: str, then: Callable[[Read], None]) -> None:
        """Read the file of an open palette once more, in the background."""
        item = self._library.item(key)
        if item is None or item.palette is None or item.palette.store.path is None:
            # It was closed since it was offered.
            return
        todo = tr("The open palette is unchanged.")
        self._library.tasks.submit(
            f"again {key}",
            read_palette_file,
            item.palette.store.path,
            then,
            lambda error: self._library.fails(error, f"outside {key}", todo),
        )

    def adopt_file(self, key: str, value: Palette, read: Read, name: str) -> None:
        """Take what the file holds now, or what it was merged to, as one step; it is no longer asked about."""
        item = self._library.item(key)
        if item is None or item.palette is None:
            return
        opened = item.palette
        self._library.history.apply(name, [(opened.store, value)])
        if value == read.palette:
            opened.store.mark_clean(read.path, read.stamp)
        else:
            opened.store.stamp = read.stamp  # merged with it, and not saved yet
        opened.base = read.palette
        self._library.settled.emit(f"outside {key}")
        self._library.items_changed.emit()


class UnsavedWork:
    """Recovers the autosaves of ended runs into a library."""

    def __init__(self, library: Library) -> None:
        self._library = library
        # Finds what earlier runs left, and never writes: its document is always clean.
        self._finder = library.recovery_of(library.empty_store())
        self._histories: dict[Path, Path] = {}
        library.read.connect(self._restore_saved)

    def find(self) -> list[Recovered[Palette]]:
        self._histories = self._finder.saved_files()
        for item in self._library.items:
            self._restore_saved(item.key)
        return self._finder.found()

    def _restore_saved(self, key: str) -> None:
        """Give a saved palette its history back, where that ends at what the file holds, and nothing was done yet."""
        item = self._library.item(key)
        if item is None or item.palette is None or item.path is None or item.path not in self._histories:
            return
        file = self._histories.pop(item.path)
        store = item.palette.store
        kept = self._finder.kept(file, store.value)
        if kept is not None and kept.history.place == kept.history.saved and not store.stack.count():
            self._library.restore_history(item, kept, store.path, store.stamp)
        file.unlink(missing_ok=True)

    def recover(self, found: Recovered[Palette]) -> str:
        """Open unsaved work of a run that was ended."""
        item = next((i for i in self._library.items if found.path is not None and i.path == found.path), None)
        if item is None:
            item = self._library.add_item(found.path, found.value.name)
        if item.palette is None:
            # Its file may be being read for the pane that shows it; the recovered work replaces it.
            self._library.tasks.cancel(f"read {item.key}")
            self._library.fill(item, found.value, found.path, clean=False, stamp=found.stamp)
            assert item.palette is not None
            self._restore_unsaved(item, found)
            if item.palette.recovery.write():
                item.palette.recovery.drop(found)
            item.run_waiting()
        else:
            untouched = item.palette.store.is_clean and not item.palette.store.stack.count()
            if not untouched or not self._restore_unsaved(item, found):
                # It is open, and perhaps changed: the recovered one comes as a step that can be undone.
                self._library.history.apply(tr("Recover unsaved work"), [(item.palette.store, found.value)])
            if item.palette.recovery.write():
                item.palette.recovery.drop(found)
        return item.key

    def _restore_unsaved(self, item: Item, found: Recovered[Palette]) -> bool:
        kept = self._finder.kept(found.file, found.value)
        if kept is None or kept.history.place == kept.history.saved:
            return False
        self._library.restore_history(item, kept, found.path, found.stamp)
        return True

    def discard(self, found: Recovered[Palette]) -> None:
        self._finder.drop(found)

    def close(self) -> None:
        self._finder.close(keep=False)
