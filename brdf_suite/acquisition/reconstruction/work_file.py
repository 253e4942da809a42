"""What a reconstruction has done so far, kept on the disk so that it survives being stopped or killed.

One file that only grows, a record for the calibration and one for each position of the turntable::

    8   BRDFWORK, then for each record:
    4   CALI or POSN
    8   u64, length of the payload
    32  SHA-256 of tag, length and payload
    …   payload: u32 length of a JSON object, the object, and the arrays that it lists, C order

A record is forced to the disk before the next position begins. What a kill leaves half written fails its checksum
and is cut off when the file is taken up again: a record is there whole or not at all. The calibration carries a key,
a hash of the session, the options and the calibration's own photographs, and a position the hash of its photographs;
what does not fit is not taken up. Nothing in the file is ever executed or unpickled.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
import struct
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import IO, Any

import numpy as np
from filelock import FileLock, Timeout

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import FileError

MAGIC = b"BRDFWORK"
CALIBRATION, POSITION = b"CALI", b"POSN"

_HEAD = struct.Struct("<4sQ")
_DIGEST = 32
_LENGTH = struct.Struct("<I")
_DTYPES = ("<i4", "<f4", "<f8")
_LARGEST = 1 << 30


@dataclass(frozen=True)
class WorkRecord:
    """What one record holds besides its arrays: ``tag``, plain ``values``, and where its payload is in the file."""

    tag: bytes
    values: Mapping[str, Any]
    start: int
    length: int


class WorkFile:
    """An open work file; made by :func:`open_work`. Arrays stay on the disk until they are asked for."""

    def __init__(self, stream: IO[bytes], path: Path) -> None:
        self._stream = stream
        self.path = path
        self.records: list[WorkRecord] = []
        self._read()

    def arrays(self, record: WorkRecord) -> dict[str, AnyArray]:
        """Return the arrays of a record, by name.

        Raises
        ------
        FileError
            Another process changed the file while it was open.
        """
        try:
            self._stream.seek(record.start)
            found = _unpacked(self._stream.read(record.length))
        except OSError as error:
            raise FileError(self.path, f"cannot be read: {error.strerror or error}") from error
        if found is None:
            raise FileError(self.path, "was changed by another program", f"byte {record.start}")
        return found[1]

    def add(self, tag: bytes, values: Mapping[str, Any], arrays: Mapping[str, AnyArray]) -> None:
        """Append a record and force it to the disk.

        Raises
        ------
        FileError
            The disk is full or refuses; the file then ends where it ended before.
        """
        payload = _packed(values, arrays)
        head = _HEAD.pack(tag, len(payload))
        end = self._stream.seek(0, os.SEEK_END)
        try:
            self._write(head + hashlib.sha256(head + payload).digest())
            self._write(payload)
            os.fsync(self._stream.fileno())
        except OSError as error:
            # Half a record would be cut off when the file is next opened; here it only takes room.
            with contextlib.suppress(OSError):
                self._stream.truncate(end)
            raise FileError(self.path, f"cannot be written: {error.strerror or error}") from error
        self.records.append(WorkRecord(tag, values, end + _HEAD.size + _DIGEST, len(payload)))

    def empty(self) -> None:
        """Forget everything; raises FileError where the disk is full or refuses."""
        try:
            self._stream.seek(0)
            self._stream.truncate(0)
            self._write(MAGIC)
        except OSError as error:
            raise FileError(self.path, f"cannot be written: {error.strerror or error}") from error
        self.records = []

    def _write(self, content: bytes) -> None:
        rest = memoryview(content)
        while rest:
            rest = rest[self._stream.write(rest) :]

    def _read(self) -> None:
        """List the whole records and cut off what follows them."""
        start = self._stream.read(len(MAGIC))
        if start != MAGIC:
            if start and not MAGIC.startswith(start):
                raise FileError(
                    self.path, "is no work file of a reconstruction and is left as it is", "byte 0"
                )
            self.empty()
            return
        end = self._stream.tell()
        while (record := self._next()) is not None:
            self.records.append(record)
            end = record.start + record.length
        self._stream.truncate(end)

    def _next(self) -> WorkRecord | None:
        head = self._stream.read(_HEAD.size + _DIGEST)
        if len(head) < _HEAD.size + _DIGEST:
            return None
        tag, length = _HEAD.unpack_from(head)
        if tag not in (CALIBRATION, POSITION) or length > _LARGEST:
            return None
        start = self._stream.tell()
        payload = self._stream.read(length)
        if (
            len(payload) != length
            or hashlib.sha256(head[: _HEAD.size] + payload).digest() != head[_HEAD.size :]
        ):
            return None
        found = _unpacked(payload)
        return None if found is None else WorkRecord(tag, found[0], start, length)


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
        mode = "r+b" if path.exists() else "w+b"
        try:
            # Without a buffer: what a full disk refused would be written once more when the file is closed.
            stream = path.open(mode, buffering=0)
        except OSError as error:
            raise FileError(path, f"cannot be opened: {error.strerror or error}") from error
        with stream:
            yield WorkFile(stream, path)
    finally:
        lock.release()
        with contextlib.suppress(OSError):  # gone already, where the system's locks delete their file
            Path(lock.lock_file).unlink()


def _packed(values: Mapping[str, Any], arrays: Mapping[str, AnyArray]) -> bytes:
    held = {name: np.ascontiguousarray(array) for name, array in arrays.items()}
    listed = [[name, array.dtype.str, list(array.shape)] for name, array in held.items()]
    text = json.dumps({"values": values, "arrays": listed}, allow_nan=False).encode()
    return b"".join((_LENGTH.pack(len(text)), text, *(array.tobytes() for array in held.values())))


def _unpacked(payload: bytes) -> tuple[dict[str, Any], dict[str, AnyArray]] | None:
    """Return values and arrays of a payload whose checksum fits; None where another version wrote it."""
    try:
        (length,) = _LENGTH.unpack_from(payload)
        at = _LENGTH.size + length
        described = json.loads(payload[_LENGTH.size : at])
        arrays: dict[str, AnyArray] = {}
        for name, dtype, shape in described["arrays"]:
            if dtype not in _DTYPES:
                return None
            arrays[name] = np.frombuffer(payload, dtype, math.prod(shape), at).reshape(shape)
            at += arrays[name].nbytes
        return dict(described["values"]), arrays
    except (ValueError, KeyError, TypeError, struct.error):
        return None


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
