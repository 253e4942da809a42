"""What a reconstruction has done so far, kept on the disk so that it survives being stopped or killed.

One file that only grows, a record for the calibration and one for each position of the turntable. A record is a header
with arrays, as in :mod:`brdf_suite.files.array_file`.

A record is forced to the disk before the next position begins. What a kill leaves half written fails its checksum
and is cut off when the file is taken up again: a record is there whole or not at all. The calibration carries a key,
a hash of the session, the options and the calibration's own photographs, and a position the hash of its photographs;
what does not fit is not taken up.
"""

from __future__ import annotations

import contextlib
import os
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from io import FileIO
from pathlib import Path
from time import perf_counter
from typing import Any

from filelock import FileLock, Timeout

from brdf_suite.arrays import AnyArray
from brdf_suite.documents.atomic import sync_folder
from brdf_suite.errors import FileError
from brdf_suite.files.array_file import Layout, encode_arrays, read_next

CALIBRATION, POSITION = "calibration", "position"
LAYOUT = Layout(b"BRDFWORK", 2, "work file of a reconstruction", ("<i4", "<f4", "<f8"), smallest=0)


@dataclass(frozen=True)
class WorkRecord:
    """What one record holds besides its arrays: ``tag``, plain ``values``, and where it is in the file."""

    tag: str
    values: Mapping[str, Any]
    start: int
    length: int


class WorkFile:
    """An open work file; made by :func:`open_work`. Arrays stay on the disk until they are asked for."""

    def __init__(self, stream: FileIO, path: Path) -> None:
        self._stream = stream
        self.path = path
        self.records: list[WorkRecord] = []
        # The whole records are listed; what follows them is cut off.
        start, end = stream.read(len(LAYOUT.magic)), 0
        if start and not LAYOUT.magic.startswith(start):
            raise FileError(path, "is no work file of a reconstruction and is left as it is", "byte 0")
        size = stream.seek(0, os.SEEK_END)
        with contextlib.suppress(FileError):
            while end < size:
                stream.seek(end)
                header, _ = read_next(LAYOUT, path, stream, size)
                tag, values = header.get("tag"), header.get("values")
                if not isinstance(tag, str) or not isinstance(values, dict):
                    break
                length = stream.tell() - end
                self.records.append(WorkRecord(tag, values, end, length))
                end += length
        stream.truncate(end)

    def arrays(self, record: WorkRecord) -> dict[str, AnyArray]:
        """Return the arrays of a record, by name.

        Raises
        ------
        FileError
            Another process changed the file while it was open.
        """
        try:
            self._stream.seek(record.start)
            return read_next(LAYOUT, self.path, self._stream, record.start + record.length)[1]
        except OSError as error:
            raise FileError(self.path, f"cannot be read: {error.strerror or error}") from error

    def add(self, tag: str, values: Mapping[str, Any], arrays: Mapping[str, AnyArray]) -> None:
        """Append a record and force it to the disk.

        Raises
        ------
        FileError
            The disk is full or refuses; the file then ends where it ended before.
        """
        record = b"".join(encode_arrays(LAYOUT, self.path, {"tag": tag, "values": values}, arrays))
        end = self._stream.seek(0, os.SEEK_END)
        try:
            rest = memoryview(record)
            while rest:
                rest = rest[self._stream.write(rest) :]
            os.fsync(self._stream.fileno())
        except OSError as error:
            # Half a record would be cut off when the file is next opened; here it only takes room.
            with contextlib.suppress(OSError):
                self._stream.truncate(end)
            raise FileError(self.path, f"cannot be written: {error.strerror or error}") from error
        self.records.append(WorkRecord(tag, values, end, len(record)))

    def empty(self) -> None:
        """Forget everything; raises FileError where the disk is full or refuses."""
        try:
            self._stream.seek(0)
            self._stream.truncate(0)
        except OSError as error:
            raise FileError(self.path, f"cannot be written: {error.strerror or error}") from error
        self.records = []


@contextmanager
def open_work(path: Path) -> Iterator[WorkFile]:
    """Open the work file at ``path``, or make it; one program at a time.

    Raises
    ------
    FileError
        The folder cannot be written, the file is of another kind, or another program works with it.
    """
    lock = FileLock(f"{path}.lock", timeout=0)
    try:
        lock.acquire()
    except Timeout as error:
        raise FileError(path, "is in use: another program reconstructs into it") from error
    except OSError as error:
        raise FileError(path, f"cannot be written: {error.strerror or error}") from error
    try:
        # Not "a": what a kill left half written is cut off.
        mode = "r+" if path.exists() else "w+"
        try:
            # Without a buffer: what a full disk refused would be written once more when the file is closed.
            stream = FileIO(path, mode)
            if mode == "w+":
                sync_folder(path.absolute().parent)
        except OSError as error:
            raise FileError(path, f"cannot be opened: {error.strerror or error}") from error
        with stream:
            yield WorkFile(stream, path)
    finally:
        lock.release()
        with contextlib.suppress(OSError):  # gone already, where the system's locks delete their file
            Path(lock.lock_file).unlink()


class StepClock:
    """Seconds by the name of a step; a step within another counts for itself alone."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._lock = threading.Lock()
        self._within = threading.local()

    @contextmanager
    def step(self, name: str) -> Iterator[None]:
        """Count the time of the block."""
        outer: float = getattr(self._within, "seconds", 0.0)
        self._within.seconds = 0.0
        start = perf_counter()
        try:
            yield
        finally:
            whole = perf_counter() - start
            with self._lock:
                self.seconds[name] = self.seconds.get(name, 0.0) + whole - self._within.seconds
            self._within.seconds = outer + whole
