"""Entries that only save time, kept on disk under the hash of what they were made from.

Whatever happens to the cache (full or read-only disk, a damaged entry, another program at the same work, a kill at any
moment), the caller gets what it asked for; failures are reported.

- An entry is a file of :mod:`brdf_suite.files.array_file`, written under a temporary name, synced and renamed; its
  checksums are compared on reading.
- Programs that need the same entry are serialized by a lock (:mod:`brdf_suite.files.cache.entry_lock`). A damaged
  entry is removed only by who holds it, so that no process removes what another has just rebuilt.
- Each kind of entries has a folder of its own; above the limit, which is one for all kinds, the entries unused for
  longest go. Those of other versions of the program are never read, and go in their turn.

Another program may add or remove any file at any moment, so every step allows for a file that is gone.
"""

from __future__ import annotations

import contextlib
import logging
import os
import re
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from brdf_suite import variables
from brdf_suite.documents.atomic import sync_folder
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.array_file import Layout, read_arrays
from brdf_suite.files.cache.entry_lock import exclusive_entry, shard, try_entry
from brdf_suite.progress import Progress, report

DEFAULT_LIMIT_BYTES = 2 * 1024**3

_ENTRY = re.compile(r"[0-9a-f]{64}\.\w")
_UNFINISHED = ".part"
_FORGOTTEN_SECONDS = 3600.0
_Kept = TypeVar("_Kept")
_log = logging.getLogger(__name__)


def default_root() -> Path:
    """Return the cache's folder: ``$BRDF_SUITE_CACHE``, or the system's place for a user's caches."""
    override = os.environ.get(variables.CACHE)
    if override:
        return Path(override)
    import platformdirs  # 20 ms, which a start with a chosen folder saves

    return Path(platformdirs.user_cache_dir("brdf-suite", appauthor=False))


def default_limit() -> int:
    """Return the size in bytes that the cache may have: ``$BRDF_SUITE_CACHE_MB``, in 10⁶ bytes, or 2 GiB."""
    text = os.environ.get(variables.CACHE_MB, "").strip()
    if not text:
        return DEFAULT_LIMIT_BYTES
    if not text.isdecimal():
        _log.warning(
            "%s is %r, not a whole number of megabytes; 2 GiB is the limit.", variables.CACHE_MB, text
        )
        return DEFAULT_LIMIT_BYTES
    return int(text[:9]) * 1_000_000  # what is longer is beyond every disk


@dataclass(frozen=True)
class CacheEntry:
    """One entry: its file, its size in bytes, and when it was last used, in seconds since 1970.

    ``outdated``: another version of the program wrote it.
    """

    path: Path
    size: int
    last_used: float
    outdated: bool

    @property
    def key(self) -> str:
        """What the entry was made from, as 64 hexadecimal digits."""
        return self.path.name.split(".")[0]


@dataclass(frozen=True)
class CacheCheck:
    """Result of a check of all entries.

    ``sound`` counts entries whose checksum fits; ``damaged`` are names of entries, each with what is wrong, and
    ``removed`` says whether they are gone now. ``outdated`` counts entries of other versions and ``unfinished`` what
    killed programs left; neither is ever read.
    """

    sound: int
    outdated: int
    damaged: tuple[tuple[str, str], ...]
    unfinished: int
    removed: bool

    @property
    def passed(self) -> bool:
        """Whether every entry is sound."""
        return not self.damaged


class DiskCache:
    """The entries of one kind.

    Parameters
    ----------
    folder, what
        The name of the kind's folder, and what messages call its entries.
    layout, ending
        What the entries' files are, and how their names end behind the version.
    root
        The cache's folder; None: :func:`default_root`.
    limit_bytes
        How much is kept of all kinds together; None: :func:`default_limit`; 0 keeps nothing.
    lock_timeout_s, silence_s
        How long another program at the same entry is waited for, and without a sign of life from it.

    Attributes
    ----------
    notices
        What went wrong with the cache so far, as sentences for the user; they are logged too.
    """

    def __init__(
        self,
        folder: str,
        what: str,
        layout: Layout,
        ending: str,
        root: PathLike | None = None,
        *,
        limit_bytes: int | None = None,
        lock_timeout_s: float = 600.0,
        silence_s: float = 60.0,
    ) -> None:
        self.folder = (Path(root) if root is not None else default_root()) / folder
        self.limit_bytes = default_limit() if limit_bytes is None else limit_bytes
        self.lock_timeout_s = lock_timeout_s
        self.silence_s = silence_s
        self.notices: list[str] = []
        self._what = what
        self._layout = layout
        self._ending = f".v{layout.version}{ending}"

    def get_or_make(
        self,
        key: str,
        read: Callable[[Path], _Kept],
        make: Callable[[Progress], _Kept],
        encode: Callable[[_Kept], list[bytes | memoryview]],
        progress: Progress | None,
    ) -> _Kept:
        """Return what ``read`` finds under a key, or what ``make`` makes, which is then kept.

        Only ``make`` and a cancelled ``progress`` raise. ``read`` raises FileError where a file is damaged.
        """
        found = self._load(key, read, damaged_goes=False)
        if found is not None:
            return found
        waiting = exclusive_entry(
            self.folder,
            key,
            timeout_s=self.lock_timeout_s,
            silence_s=self.silence_s,
            progress=progress,
            notice=self._notice,
        )
        with waiting as turn:
            found = self._load(key, read, damaged_goes=True)
            if found is None:
                found = make(turn.watched(progress))
                self._store(key, found, encode, key if turn.locked else None)
        return found

    def packaged(self, path: Path, read: Callable[[Path], _Kept]) -> _Kept | None:
        """Return what comes with the programs at ``path``; None where nothing is there, or what is damaged."""
        try:
            return read(path)
        except FileError as error:
            if not _is_missing(error):
                self._notice(
                    f"The packaged {self._what} are made again: {error} Install brdf-suite again to repair them."
                )
            return None

    def path(self, key: str) -> Path:
        """Return where the entry of a key is kept."""
        return self.folder / f"{key}{self._ending}"

    def entries(self) -> list[CacheEntry]:
        """Return the entries of this kind, the one unused for longest first; none where there is no folder."""
        return _entries([self.folder], self._ending)

    def unfinished(self) -> list[Path]:
        """Return the files that are being written, or that a killed program left."""
        names = _listed(self.folder)
        return [path for path in names if path.name.startswith(".") and path.name.endswith(_UNFINISHED)]

    def clear(self) -> int:
        """Remove all entries and what killed programs left; return how many entries could not be removed."""
        failed = sum(not remove(entry.path) for entry in self.entries())
        self._remove_unfinished()
        return failed

    def verify(self, *, remove_damaged: bool = False, progress: Progress | None = None) -> CacheCheck:
        """Read every entry and compare its checksums; what cannot be read counts as damaged."""
        damaged: list[tuple[str, str]] = []
        sound = outdated = 0
        gone = True
        every = self.entries()
        for index, entry in enumerate(every):
            report(progress, index / len(every), f"checking {index + 1} of {len(every)}")
            if entry.outdated:
                outdated += 1
                continue
            try:
                read_arrays(self._layout, entry.path)
                sound += 1
            except FileError as error:
                if _is_missing(error):  # another program made room
                    continue
                damaged.append((entry.path.name, str(error)))
                if remove_damaged and not remove(entry.path):
                    self._notice(f"{entry.path} cannot be removed.")
                    gone = False
        if remove_damaged:
            self._remove_unfinished()
        report(progress, 1.0, "checked")
        return CacheCheck(sound, outdated, tuple(damaged), len(self.unfinished()), remove_damaged and gone)

    def _load(self, key: str, read: Callable[[Path], _Kept], *, damaged_goes: bool) -> _Kept | None:
        """Return an entry; None where it is not there, or not to be used, which is reported when it is removed."""
        path = self.path(key)
        try:
            found = read(path)
        except FileError as error:
            if damaged_goes and not _is_missing(error):
                self._notice(f"Damaged {self._what} are removed and made again: {error}")
                remove(path)
            return None
        with contextlib.suppress(OSError):  # a read-only cache still serves; only its ages stand still
            os.utime(path)
        return found

    def _store(
        self, key: str, made: _Kept, encode: Callable[[_Kept], list[bytes | memoryview]], held_key: str | None
    ) -> None:
        if held_key is not None:
            self._remove_unfinished(held_key)
        if self.limit_bytes == 0:
            return
        parts = encode(made)
        needed = sum(len(part) for part in parts)
        if not self._make_room(needed):
            self._notice(
                f"The {self._what} are not kept: {needed / 1e6:,.0f} MB do not fit into the cache's "
                f"{self.limit_bytes / 1e6:,.0f} MB; {variables.CACHE_MB} sets another limit."
            )
            return
        try:
            write(self.path(key), parts)
        except OSError as error:
            self._notice(
                f"The {self._what} are not kept: {self.folder} cannot be written ({error.strerror or error}). "
                f"Make room there, or set {variables.CACHE} to another folder."
            )
            return
        self._make_room(0)  # others may have written meanwhile, too

    def _make_room(self, needed: int) -> bool:
        """Remove entries of any kind unused for longest until ``needed`` bytes more fit; say if they do."""
        if needed > self.limit_bytes:
            return False
        kept = _entries([folder for folder in _listed(self.folder.parent) if folder.is_dir()], "")
        excess = sum(entry.size for entry in kept) + needed - self.limit_bytes
        for entry in kept:
            if excess <= 0:
                break
            if remove(entry.path):
                excess -= entry.size
        return excess <= 0

    def _remove_unfinished(self, held_key: str | None = None) -> None:
        """Remove what killed programs left.

        A file belongs to a live program while that holds the entry's lock, unless it has been there for an hour.
        ``held_key`` is an entry whose lock the caller holds itself.
        """
        for path in self.unfinished():
            key = path.name[1:].split("-")[0]
            try:
                old = time.time() - path.stat().st_mtime > _FORGOTTEN_SECONDS
            except OSError:
                continue
            if old or (held_key is not None and shard(key) == shard(held_key)):
                remove(path)
                continue
            with try_entry(self.folder, key) as free:
                if free:
                    remove(path)

    def _notice(self, text: str) -> None:
        self.notices.append(text)
        _log.warning("%s", text)


def write(path: Path, parts: Iterable[bytes | memoryview]) -> None:
    """Write an entry under a temporary name, sync it, and give it its name in one step.

    Raises :class:`OSError`: the disk is full or read-only; nothing is left behind.
    """
    folder, key = path.parent, path.name.split(".")[0]
    folder.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=folder, prefix=f".{key}-", suffix=_UNFINISHED)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as stream:
            for item in parts:
                stream.write(item)
            stream.flush()
            os.fsync(stream.fileno())
        temporary.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            temporary.unlink(missing_ok=True)
        raise
    with contextlib.suppress(OSError):  # without it a crash may lose the entry, no more
        sync_folder(folder)


def remove(path: Path) -> bool:
    """Remove a file; False where that cannot be. One that another program has removed already is removed."""
    try:
        path.unlink(missing_ok=True)
    except OSError:
        return False
    return True


def _entries(folders: Iterable[Path], ending: str) -> list[CacheEntry]:
    """Return what stands in the folders, the one unused for longest first; of another ending is an outdated one."""
    found = []
    for path in (path for folder in folders for path in _listed(folder)):
        if _ENTRY.match(path.name):
            with contextlib.suppress(OSError):
                state = path.stat()
                outdated = not path.name.endswith(ending)
                found.append(CacheEntry(path, state.st_size, state.st_mtime, outdated))
    return sorted(found, key=lambda entry: (entry.last_used, entry.path.name))


def _listed(folder: Path) -> list[Path]:
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _is_missing(error: FileError) -> bool:
    return isinstance(error.__cause__, FileNotFoundError | NotADirectoryError)
