"""The library: palettes by their files, read when they are first needed, watched, saved and closed."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from brdf_qt.documents.recovery import Recovered
from brdf_qt.documents.stamp import stamp_of
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of

from brdf_color_swatch.library.base import KEY, LibraryBase
from brdf_color_swatch.library.item import Item
from brdf_color_swatch.library.reading import Read, read_palette_file
from brdf_suite.documents.palette import Palette

_MANY = 1000

__all__ = ["Item", "Library"]


class Library(LibraryBase):
    """What is done with the files of palettes."""

    def load(self, key: str, then: Callable[[], None] | None = None) -> None:
        """Read a palette where it is not read yet, and call ``then`` once it is there."""
        item = self._items[key]
        if item.palette is not None:
            if then is not None:
                then()
            return
        if then is not None:
            item.waiting.append(then)
        if item.state == "reading" or item.path is None:
            return
        item.state, item.problem = "reading", ""
        self.items_changed.emit()
        self.tasks.submit(
            f"read {key}",
            read_palette_file,
            item.path,
            lambda read: self._arrived(key, read),
            lambda error: self._not_read(key, error),
        )

    def cancel_reading(self, key: str) -> None:
        """Leave a palette unread after all."""
        self.tasks.cancel(f"read {key}")
        item = self._items.get(key)
        if item is not None and item.state == "reading":
            item.state = "closed"
            item.waiting.clear()
            self.items_changed.emit()

    def _arrived(self, key: str, read: Read) -> None:
        item = self._items.get(key)
        if item is None or item.palette is not None:
            # What is open may have been changed, or recovered; a file does not take its place unasked.
            return
        path, stamp = (read.path, read.stamp) if read.is_ours else (None, None)
        # What was imported is in its own file still: nothing would be lost with it until it is changed.
        origin = None if read.is_ours else read.path
        self._fill(item, read.palette, path, clean=True, stamp=stamp, rows=read.rows, origin=origin)
        if len(read.palette) >= _MANY:
            # They live long and are in no cycle: a collection that looks through all of them would hold up a scroll.
            gc.freeze()
        self._any_files().remember(read.path)
        self.settled.emit(f"open {key}")
        if read.notices:
            self.message.emit(
                Message(
                    f"open {key}",
                    (
                        tr("“{name}” imported with 1 note.")
                        if len(read.notices) == 1
                        else tr("“{name}” imported with {count} notes.")
                    ).format(name=read.path.name, count=len(read.notices)),
                    todo="\n".join(read.notices[:6]) + ("\n…" if len(read.notices) > 6 else ""),
                )
            )
        self._run_waiting(item)

    def _run_waiting(self, item: Item) -> None:
        """Call those who wait for a palette that is there now."""
        waiting, item.waiting = item.waiting, []
        for then in waiting:
            then()

    def _not_read(self, key: str, error: Exception) -> None:
        item = self._items.get(key)
        if item is None:
            return
        item.state, item.problem = "wrong", str(error)
        item.waiting.clear()
        self.items_changed.emit()
        todo = tr("The palette stays in the library; nothing else has changed.")
        self.message.emit(message_of(error, f"open {key}", todo=todo))

    def ask_open(self, path: Path | None = None) -> str | None:
        """Open ``path``, or ask for a file; return its key. It is read in the background."""
        if path is None:
            from brdf_color_swatch.export.part import open_filters

            recent = self.recent()
            folder = recent[0].parent if recent else Path.home()
            path = self.dialogs.open_path(folder, open_filters())
            if path is None:
                return None
        key = self.add_path(path)
        self.load(key)
        return key

    def recover(self, found: Recovered[Palette]) -> str:
        """Open unsaved work of a run that was ended."""
        item = next((i for i in self.items if found.path is not None and i.path == found.path), None)
        if item is None:
            item = Item(f"p{next(self._numbers)}", found.path, found.value.name)
            self._items[item.key] = item
        if item.palette is None:
            # Its file may be being read for the pane that shows it; the recovered work replaces it.
            self.tasks.cancel(f"read {item.key}")
            self._fill(item, found.value, found.path, clean=False, stamp=found.stamp)
            assert item.palette is not None
            if item.palette.recovery.write():
                item.palette.recovery.drop(found)
            self._run_waiting(item)
        else:
            # It is open, and perhaps changed: the recovered one comes as a step that can be undone.
            self.history.apply(tr("Recover unsaved work"), [(item.palette.store, found.value)])
            item.palette.recovery.drop(found)
        return item.key

    def unsaved_work(self) -> list[Recovered[Palette]]:
        """Return what ended runs left, newest first."""
        return self._finder.found()

    def drop_recovered(self, found: Recovered[Palette]) -> None:
        """Give unsaved work of an earlier run up."""
        self._finder.drop(found)

    def _on_file_changed(self, item: Item) -> None:
        opened = item.palette
        if opened is None or opened.store.path is None:
            return
        now, known = stamp_of(opened.store.path), opened.store.stamp
        if now is not None and (known is None or not known.same_content(now)):
            self.changed_outside.emit(item.key)

    def reread(self, key: str, then: Callable[[Read], None]) -> None:
        """Read the file of an open palette once more, in the background."""
        item = self._items.get(key)
        if item is None or item.palette is None or item.palette.store.path is None:
            # It was closed since it was offered.
            return
        self.tasks.submit(
            f"again {key}",
            read_palette_file,
            item.palette.store.path,
            then,
            lambda error: self.message.emit(
                message_of(error, f"outside {key}", todo=tr("The open palette is unchanged."))
            ),
        )

    def adopt_file(self, key: str, value: Palette, read: Read, name: str) -> None:
        """Take what the file holds now, or what it was merged to, as one step; it is no longer asked about."""
        item = self._items.get(key)
        if item is None or item.palette is None:
            return
        opened = item.palette
        self.history.apply(name, [(opened.store, value)])
        if value == read.palette:
            opened.store.mark_clean(read.path, read.stamp)
        else:
            opened.store.note_stamp(read.stamp)
        opened.base = read.palette
        self.settled.emit(f"outside {key}")
        self.items_changed.emit()

    def save(self, key: str) -> bool:
        """Save a palette, asking for a file where it has none; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save()

    def save_as(self, key: str) -> bool:
        """Ask for a file and save a palette there; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save_as()

    def close(self, key: str) -> bool:
        """Ask about unsaved work, and take a palette out of the library; its file stays. True where it went."""
        item = self._items.get(key)
        if item is None:
            return False
        if item.palette is not None:
            if not item.palette.files.may_discard():
                return False
            item.palette.recovery.close(keep=False)
            item.palette.watch.watch("")
            self.history.forget(item.palette.store)
        for task in ("read", "again", "merge", "columns"):
            self.tasks.cancel(f"{task} {key}")
        del self._items[key]
        for topic in ("open", "outside"):
            # Messages about a closed palette are dismissed.
            self.settled.emit(f"{topic} {key}")
        self.items_changed.emit()
        self.remember()
        return True

    def may_close_all(self) -> bool:
        """Ask about every palette with unsaved work; True where all may go, and their autosaves with them."""
        opened = [item.palette for item in self.items if item.palette is not None]
        if not all(palette.files.may_discard() for palette in opened):
            return False
        for palette in opened:
            palette.recovery.close(keep=False)
        return True

    def keep_unsaved(self) -> None:
        """Write unsaved work for the next start, and end the threads; for a program that has to quit."""
        for item in self.items:
            if item.palette is not None:
                item.palette.recovery.close(keep=True)
        self._finder.close(keep=False)
        self.tasks.stop()

    def restore(self) -> None:
        """Put the files of the last run into the library, unread; those that are gone are left out."""
        found: Any = settings().value(KEY, [])
        names = [found] if isinstance(found, str) else list(found or [])
        self.add_files(Path(name) for name in names)

    def add_files(self, paths: Iterable[Path]) -> list[str]:
        """Put files into the library, unread; return the keys of those that are there."""
        return [self.add_path(path) for path in paths if path.is_file()]
