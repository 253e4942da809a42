"""Reads the palettes of the library in the background: when first needed, and again when their file has changed."""

from __future__ import annotations

import gc
from collections.abc import Callable
from pathlib import Path

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of

from brdf_color_swatch.export.dialog import open_filters
from brdf_color_swatch.library.library import Library
from brdf_color_swatch.library.reading import Read, read_palette_file
from brdf_suite.documents.palette import Palette

_MANY = 1000


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
            read_palette_file,
            item.path,
            lambda read: self.accept(key, read),
            lambda error: self._not_read(key, error),
        )

    def cancel_reading(self, key: str) -> None:
        """Leave a palette unread after all."""
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
        if len(read.palette) >= _MANY:
            # They live long and are in no cycle: a collection that looks through all of them would hold up a scroll.
            gc.freeze()
        self._library.remember_file(read.path)
        self._library.settled.emit(f"open {key}")
        if read.notices:
            self._library.message.emit(
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
        item.run_waiting()

    def _not_read(self, key: str, error: Exception) -> None:
        item = self._library.item(key)
        if item is None:
            return
        item.state, item.problem = "wrong", str(error)
        item.waiting.clear()
        self._library.items_changed.emit()
        todo = tr("The palette stays in the library; nothing else has changed.")
        self._library.message.emit(message_of(error, f"open {key}", todo=todo))

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
        self._library.tasks.submit(
            f"again {key}",
            read_palette_file,
            item.palette.store.path,
            then,
            lambda error: self._library.message.emit(
                message_of(error, f"outside {key}", todo=tr("The open palette is unchanged."))
            ),
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
            opened.store.note_stamp(read.stamp)
        opened.base = read.palette
        self._library.settled.emit(f"outside {key}")
        self._library.items_changed.emit()
