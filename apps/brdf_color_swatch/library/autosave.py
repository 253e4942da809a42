"""The autosave of palettes of any size, encoded by a thread while it takes long."""

from __future__ import annotations

import json
from collections.abc import Callable
from datetime import datetime
from typing import Any

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recovery import Recovered, Recovery
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import encode_palette
from brdf_suite.errors import FileError
from brdf_suite.progress import Progress

_MANY = 300
"""Fewer swatches are written within a frame or two."""


class PaletteRecovery(Recovery[Palette]):
    """As :class:`Recovery`, and what it reads is the same file.

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
    ) -> None:
        super().__init__(store, form, failed, parent)
        self._tasks = tasks
        self._key = f"autosave {id(self)}"
        self._encodes = self._encode_again = False
        store.clean_changed.connect(self._saved)
        self.timer.timeout.disconnect(self.write)
        self.timer.timeout.connect(self.write_in_background)

    def saved(self) -> Recovered[Palette]:
        """Return what the file of the autosave holds."""
        return self._read(self.file)

    def write(self) -> bool:
        """Write the unsaved palette now, and wait for it; see :meth:`Recovery.write`."""
        self._drop()
        return super().write()

    def _drop(self) -> None:
        self._tasks.cancel(self._key)
        self._encodes = self._encode_again = False

    def _saved(self, clean: bool) -> None:
        """What is being encoded is older than what was saved: it shall not be offered instead of it."""
        if clean:
            self._drop()

    def write_in_background(self) -> None:
        """Write the unsaved palette now; a large one is encoded by a thread."""
        self.timer.stop()
        if self._store.is_clean or len(self._store.value) < _MANY:
            self.write()
            return
        if self._encodes:
            self._encode_again = True
            return
        path, stamp = self._store.path, self._store.stamp
        head = {
            "path": None if path is None else str(path),
            "stamp": None if stamp is None else stamp.to_json(),
            "time": datetime.now().isoformat(timespec="microseconds"),
        }
        self._encodes = True
        self._tasks.submit(
            self._key, encode_autosave, (head, self._store.value), self._on_encoded, self._on_encoding_failed
        )

    def _on_encoded(self, content: bytes) -> None:
        self.write_encoded(content)
        self._encode_next()

    def _on_encoding_failed(self, error: Exception) -> None:
        self._failed(error)
        self._encode_next()

    def _encode_next(self) -> None:
        wants, self._encodes, self._encode_again = self._encode_again, False, False
        if wants and not self._closed:
            self.write_in_background()

    def write_encoded(self, content: bytes) -> None:
        """Write what was encoded: here, so that it never comes after the file was removed because all is saved."""
        if self._closed or self._store.is_clean:
            return
        draft = self.file.with_suffix(".tmp")
        try:
            draft.write_bytes(content)
            draft.replace(self.file)
        except OSError as error:
            self._fails = True
            self._failed(FileError(self.file, f"the autosave cannot be written ({error.strerror})"))
            return
        if self._fails:
            self._fails = False
            self.written_again.emit()


def encode_autosave(request: tuple[dict[str, Any], Palette], progress: Progress) -> bytes:
    """Return the autosave's content: entry by entry, so that the window's thread gets its turns in between."""
    head, palette = request
    progress(0.0, "")
    start = json.dumps(head, ensure_ascii=False)
    return start[:-1].encode("utf-8") + b', "document": ' + encode_palette(palette) + b"}"
