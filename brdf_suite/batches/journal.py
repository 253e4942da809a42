"""The journal of a batch: one line of JSON for each finished item, appended as it ends.

Only the process that runs the batch writes it. A line that a kill or a full disk cut off is left out when the journal
is opened again, and its item is done again; files of items have the same names in every run and are replaced whole.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from filelock import FileLock, Timeout

from brdf_suite.batches.items import JOURNAL, BatchItem
from brdf_suite.batches.steps import Value
from brdf_suite.documents.atomic import make_folder, sync_folder
from brdf_suite.errors import FileError
from brdf_suite.regular_files import exists, is_file

_LOCK = ".lock"


@dataclass(frozen=True)
class Finished:
    """An item that is done: what came of it, or the problem that there was."""

    key: str
    label: str
    source: str
    row: Mapping[str, Value]
    files: tuple[str, ...] = ()
    notices: tuple[str, ...] = ()
    problem: str = ""

    @classmethod
    def failed(cls, item: BatchItem, problem: str) -> Finished:
        """Return an item of which nothing came."""
        return cls(item.key, item.label, item.source, {}, notices=item.notices, problem=problem)


class Journal:
    """The finished items of a folder, by their keys; ``append`` adds some, on the disk when it returns."""

    def __init__(self, folder: Path, step: str) -> None:
        self.path = folder / JOURNAL
        self._step = step
        self.finished: dict[str, Finished] = {}
        self.others: set[str] = set()
        """Keys of items that another step, or one with other options, has done in this folder."""
        self._read()

    def append(self, done: Iterable[Finished]) -> None:
        """Add finished items; raise :class:`FileError` where the disk refuses."""
        lines = []
        for one in done:
            self.finished[one.key] = one
            lines.append(json.dumps({"step": self._step, **vars(one)}))
        try:
            is_new = not exists(self.path)
            with self.path.open("a", encoding="utf-8") as file:
                file.write("".join(line + "\n" for line in lines))
                file.flush()
                os.fsync(file.fileno())
            if is_new:
                sync_folder(self.path.parent)
        except OSError as error:
            raise FileError(self.path, f"cannot be written: {error.strerror or error}") from error

    def _read(self) -> None:
        """Take the finished items of this step; cut off what the last writer left unfinished."""
        if not exists(self.path):
            return
        try:
            with self.path.open("rb+") as file:
                whole = 0
                for line in file:
                    if not line.endswith(b"\n"):
                        break
                    whole += len(line)
                    self._take(line)
                file.truncate(whole)
        except OSError as error:
            raise FileError(self.path, f"cannot be read: {error.strerror or error}") from error

    def _take(self, line: bytes) -> None:
        try:
            value = json.loads(line)
            if value.pop("step") != self._step:
                self.others.add(str(value["key"]))
                return
            value["files"], value["notices"] = tuple(value["files"]), tuple(value["notices"])
            one = Finished(**value)
        except (ValueError, KeyError, TypeError, AttributeError):  # damaged: the item is done again
            return
        # A problem may have been the machine's; such items are tried again.
        if not one.problem and all(is_file(self.path.parent / file) for file in one.files):
            self.finished[one.key] = one


@contextmanager
def journal_of(folder: Path, step: str) -> Iterator[Journal]:
    """Open the journal of a folder for one process.

    Raises
    ------
    FileError
        The folder cannot be made, or another batch is running in it.
    """
    lock = FileLock(folder / _LOCK)
    try:
        make_folder(folder)
        lock.acquire(blocking=False)
    except Timeout as error:
        raise FileError(folder, "another batch is running in this folder") from error
    except OSError as error:
        raise FileError(folder, f"cannot be written: {error.strerror or error}") from error
    try:
        yield Journal(folder, step)
    finally:
        lock.release()
