"""Pictures of paints kept on disk by their keys: what was drawn once is there at once the next time.

One SQLite file in the suite's cache folder, so that a thousand small pictures cost one open file and no names. It
only ever saves time: many programs read and write it at once, one that is killed in the middle leaves it as it was
before, and a file that is damaged, full or read-only is reported and not used. Each picture carries a checksum; one
that does not fit is as good as none. Above the limit the pictures unused for longest go.
"""

from __future__ import annotations

import contextlib
import logging
import os
import sqlite3
import threading
import time
import zlib
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TypeVar

import numpy as np

from brdf_suite import variables
from brdf_suite.arrays import Bytes
from brdf_suite.files.cache.disk_cache import default_limit, default_root

_VERSION = 2
_PATIENCE_S = 5.0
_PAUSE_S = 0.01
_AGES_S = 3600.0
"""How old a note of use may be before it is written anew: reading is then mostly reading alone."""
_MOST_ASKED = 500
_TRIM_TO = 0.9
_T = TypeVar("_T")
_log = logging.getLogger(__name__)


_TABLE = """
CREATE TABLE IF NOT EXISTS pictures (
    key TEXT PRIMARY KEY, height INTEGER NOT NULL, width INTEGER NOT NULL, checksum INTEGER NOT NULL,
    used REAL NOT NULL, bytes INTEGER NOT NULL, pixels BLOB NOT NULL
)
"""
# Sums and ages are read from the index alone: the pictures themselves are hundreds of megabytes.
_INDEX = "CREATE INDEX IF NOT EXISTS by_use ON pictures (used, bytes, key)"

_COLUMNS = ["key", "height", "width", "checksum", "used", "bytes", "pixels"]

_BUSY = ("SQLITE_BUSY", "SQLITE_LOCKED", "SQLITE_PROTOCOL")
_DAMAGED = ("SQLITE_CORRUPT", "SQLITE_NOTADB")
"""Of these alone another file helps; any other error may be of the moment, and others may have the file open."""


class _OtherTableError(Exception):
    """The file holds another table than this program makes."""


class SwatchStore:
    """The pictures on disk; any thread may call, one at a time.

    Parameters
    ----------
    root
        The cache's folder; None: ``$BRDF_SUITE_CACHE`` or the system's place for a user's caches.
    limit_bytes
        How much is kept; 0 keeps nothing; None: a quarter of the cache's limit, some 25,000 pictures of 96 by 96.

    Attributes
    ----------
    notices
        What went wrong with it so far, as sentences for the user; they are logged too.
    """

    def __init__(self, root: str | os.PathLike[str] | None = None, *, limit_bytes: int | None = None) -> None:
        self.folder = (Path(root) if root is not None else default_root()) / "swatches"
        self.path = self.folder / f"pictures.v{_VERSION}.sqlite"
        self.limit_bytes = default_limit() // 4 if limit_bytes is None else limit_bytes
        self.notices: list[str] = []
        self._lock = threading.Lock()
        self._connection: sqlite3.Connection | None = None
        self._given_up = False

    def get(self, keys: Iterable[str]) -> dict[str, Bytes]:
        """Return the pictures (h, w, 3) that are kept, by key; one that is damaged is left out and goes."""
        wanted = list(dict.fromkeys(keys))
        with self._lock:
            return self._try(lambda connection: self._read(connection, wanted), {})

    def put(self, pictures: Mapping[str, Bytes]) -> None:
        """Keep pictures (h, w, 3); what is there under a key already is replaced."""
        if self.limit_bytes == 0 or not pictures:
            return
        rows = [_row(key, pixels) for key, pixels in pictures.items()]
        with self._lock:
            self._try(lambda connection: self._write(connection, rows), None)

    def size(self) -> tuple[int, int]:
        """Return how many pictures are kept, and their bytes."""
        with self._lock:
            return self._look(_counted, (0, 0))

    def clear(self) -> int:
        """Remove all pictures; return how many there were."""
        with self._lock:
            return self._look(_cleared, 0)

    def verify(self, *, remove: bool = False) -> tuple[int, int]:
        """Read every picture; return how many are sound and how many damaged, and ``remove`` those."""
        with self._lock:
            return self._look(lambda connection: _verified(connection, remove), (0, 0))

    def close(self) -> None:
        """Close the file; it is opened again when it is next needed."""
        with self._lock:
            self._shut()

    def __del__(self) -> None:
        self._shut()

    # Below here the lock is held.

    def _shut(self) -> None:
        if self._connection is not None:
            with contextlib.suppress(sqlite3.Error):
                self._connection.close()
        self._connection = None

    def _look(self, work: Callable[[sqlite3.Connection], _T], nothing: _T) -> _T:
        """Do some work on the file if it is there; none is made."""
        try:
            there = self.path.is_file()
        except OSError:  # no file system takes the name
            there = False
        return self._try(work, nothing) if there else nothing

    def _try(self, work: Callable[[sqlite3.Connection], _T], nothing: _T) -> _T:
        """Do some work on the file; where it is damaged make it anew, and where that fails do without."""
        if self._given_up:
            return nothing
        until = time.monotonic() + _PATIENCE_S
        renewed = False
        while True:
            try:
                return work(self._open())
            except (
                sqlite3.Error,
                UnicodeDecodeError,
                _OtherTableError,
            ) as error:  # a damaged text is no UTF-8
                self._shut()
                name = str(getattr(error, "sqlite_errorname", ""))
                if name.startswith(_BUSY):
                    # SQLite does not wait where several programs make the file or set its journal at once.
                    if time.monotonic() < until:
                        time.sleep(_PAUSE_S)
                        continue
                    self._notice(f"The pictures in {self.path} are in use by another program; doing without.")
                    return nothing
                spoilt = isinstance(error, UnicodeDecodeError | _OtherTableError) or name.startswith(_DAMAGED)
                if renewed or not spoilt:
                    return self._give_up(str(error), nothing)
                renewed = True
                self._notice(f"The kept pictures {self.path} are damaged ({error}); they are made anew.")
                for ending in ("", "-wal", "-shm"):
                    with contextlib.suppress(OSError):
                        self.path.with_name(self.path.name + ending).unlink(missing_ok=True)
            except OSError as error:
                self._shut()
                return self._give_up(error.strerror or str(error), nothing)

    def _give_up(self, why: str, nothing: _T) -> _T:
        self._given_up = True
        self._notice(
            f"Pictures of paints are not kept: {self.path} cannot be used ({why}). Make room there, or set "
            f"{variables.CACHE} to another folder."
        )
        return nothing

    def _open(self) -> sqlite3.Connection:
        if self._connection is None:
            self.folder.mkdir(parents=True, exist_ok=True)
            for ending in ("", "-wal", "-shm"):  # of the version before, whose checksums left the key out
                with contextlib.suppress(OSError):
                    (self.folder / f"pictures.v1.sqlite{ending}").unlink(missing_ok=True)
            connection = sqlite3.connect(
                self.path, timeout=_PATIENCE_S, isolation_level=None, check_same_thread=False
            )
            self._connection = connection
            # Written beside and moved over later: readers never wait, and a crash leaves the older state.
            connection.execute("PRAGMA journal_mode = WAL")
            connection.execute("PRAGMA synchronous = NORMAL")
            connection.execute(_TABLE)
            columns = [
                name for (name,) in connection.execute("SELECT name FROM pragma_table_info('pictures')")
            ]
            if columns != _COLUMNS:
                raise _OtherTableError("it holds another table")
            connection.execute(_INDEX)
        return self._connection

    def _read(self, connection: sqlite3.Connection, keys: list[str]) -> dict[str, Bytes]:
        found: dict[str, Bytes] = {}
        damaged: list[str] = []
        aged: list[str] = []
        now = time.time()
        for start in range(0, len(keys), _MOST_ASKED):
            asked = keys[start : start + _MOST_ASKED]
            marks = ",".join("?" * len(asked))
            rows = connection.execute(
                f"SELECT key, height, width, checksum, used, pixels FROM pictures WHERE key IN ({marks})",  # noqa: S608 - the marks are "?,?"
                asked,
            )
            for key, height, width, checksum, used, blob in rows:
                pixels = _pixels(key, height, width, checksum, blob)
                if pixels is None:
                    damaged.append(key)
                    continue
                found[key] = pixels
                if not 0.0 <= now - used < _AGES_S:
                    aged.append(key)
        # A read-only folder serves too; only its ages stand still.
        with contextlib.suppress(sqlite3.OperationalError):
            for key in damaged:
                connection.execute("DELETE FROM pictures WHERE key = ?", (key,))
            if aged:
                connection.executemany(
                    "UPDATE pictures SET used = ? WHERE key = ?", [(now, key) for key in aged]
                )
        return found

    def _write(self, connection: sqlite3.Connection, rows: list[tuple[object, ...]]) -> None:
        connection.execute("BEGIN IMMEDIATE")
        try:
            connection.executemany("INSERT OR REPLACE INTO pictures VALUES (?, ?, ?, ?, ?, ?, ?)", rows)
            self._trim(connection)
            connection.execute("COMMIT")
        except BaseException:
            with contextlib.suppress(sqlite3.Error):
                connection.execute("ROLLBACK")
            raise

    def _trim(self, connection: sqlite3.Connection) -> None:
        (total,) = connection.execute("SELECT COALESCE(SUM(bytes), 0) FROM pictures").fetchone()
        if total <= self.limit_bytes:
            return
        excess = total - int(_TRIM_TO * self.limit_bytes)
        gone = []
        for key, size in connection.execute("SELECT key, bytes FROM pictures ORDER BY used, key"):
            if excess <= 0:
                break
            gone.append((key,))
            excess -= size
        connection.executemany("DELETE FROM pictures WHERE key = ?", gone)

    def _notice(self, text: str) -> None:
        if text not in self.notices:
            self.notices.append(text)
            _log.warning("%s", text)


def _row(key: str, pixels: Bytes) -> tuple[object, ...]:
    height, width = pixels.shape[:2]
    # What a pixel adds to the one above it: a smooth flank is then mostly small numbers.
    rows = np.ascontiguousarray(pixels).reshape(height, -1)
    steps = rows.copy()
    steps[1:] -= rows[:-1]
    blob = zlib.compress(steps.tobytes(), 1)
    return key, height, width, _checksum(key, height, width, blob), time.time(), len(blob), blob


def _checksum(key: object, height: object, width: object, blob: bytes) -> int:
    """The checksum of a row; the key is in it, so that no picture is taken for another paint's."""
    return zlib.crc32(blob, zlib.crc32(f"{key}\0{height}\0{width}\0".encode("utf-8", "replace")))


def _pixels(key: object, height: object, width: object, checksum: object, blob: object) -> Bytes | None:
    """The picture of a row, None where it is damaged."""
    if not isinstance(blob, bytes) or _checksum(key, height, width, blob) != checksum:
        return None
    if not isinstance(height, int) or not isinstance(width, int) or not 0 < height * width <= 1 << 20:
        return None
    wanted = height * width * 3
    unpacker = zlib.decompressobj()
    try:
        data = unpacker.decompress(blob, wanted + 1)
    except zlib.error:
        return None
    if len(data) != wanted:
        return None
    steps = np.frombuffer(data, np.uint8).reshape(height, width * 3)
    return np.add.accumulate(steps, axis=0, dtype=np.uint8).reshape(height, width, 3)


def _counted(connection: sqlite3.Connection) -> tuple[int, int]:
    count, total = connection.execute("SELECT COUNT(*), COALESCE(SUM(bytes), 0) FROM pictures").fetchone()
    return int(count), int(total)


def _cleared(connection: sqlite3.Connection) -> int:
    count, _ = _counted(connection)
    connection.execute("DELETE FROM pictures")
    connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    connection.execute("VACUUM")
    return count


def _verified(connection: sqlite3.Connection, remove: bool) -> tuple[int, int]:
    damaged = [
        (key,)
        for key, height, width, checksum, blob in connection.execute(
            "SELECT key, height, width, checksum, pixels FROM pictures"
        )
        if _pixels(key, height, width, checksum, blob) is None
    ]
    count, _ = _counted(connection)
    if remove:
        connection.executemany("DELETE FROM pictures WHERE key = ?", damaged)
    return count - len(damaged), len(damaged)
