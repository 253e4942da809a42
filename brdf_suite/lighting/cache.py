"""Prefiltered maps kept on disk, named by what they were made from.

The cache only ever saves time. Whatever happens to it (full or read-only disk, a damaged entry, another
program at the same work, a kill at any moment), the caller gets the maps; what went wrong is logged.

- The key is a hash of the environment's pixels, the exponents, the algorithm's version and the largest face
size. - An entry is written under a temporary name, synced and renamed, and carries a checksum that is checked
on reading. - Programs that want the same entry take turns through a file lock, which the system frees when
its holder dies. - Above the size limit the entries unused for longest are removed.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import logging
import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.map_file import FORMAT_VERSION, DamagedMapFileError, decode_maps, encode_maps
from brdf_suite.lighting.prefilter import (
    ALGORITHM_VERSION,
    LobeMaps,
    Ready,
    background_size,
    prefilter,
)
from brdf_suite.progress import Progress, report

ENVIRONMENT_VARIABLE = "BRDF_SUITE_CACHE"
DEFAULT_LIMIT_BYTES = 2 * 1024**3
_ENDING = ".lobemaps"
_STALE_SECONDS = 3600.0
_POLL_SECONDS = 0.2

_log = logging.getLogger(__name__)


def default_root() -> Path:
    """Return the cache's folder: ``$BRDF_SUITE_CACHE``, or the system's place for a user's caches."""
    override = os.environ.get(ENVIRONMENT_VARIABLE)
    if override:
        return Path(override)
    import platformdirs

    return Path(platformdirs.user_cache_dir("brdf-suite", appauthor=False))


class MapCache:
    """Lobe maps by content. ``root`` None: see :func:`default_root`; ``limit_bytes``: size kept on disk.

    >>> MapCache().get_or_compute(environment, [20.0, 500.0])  # doctest: +SKIP
    """

    def __init__(
        self,
        root: str | os.PathLike[str] | None = None,
        *,
        limit_bytes: int = DEFAULT_LIMIT_BYTES,
        lock_timeout_s: float = 600.0,
    ) -> None:
        self.folder = (Path(root) if root is not None else default_root()) / "lobe_maps"
        self.limit_bytes = limit_bytes
        self.lock_timeout_s = lock_timeout_s

    def get_or_compute(
        self,
        environment: Environment,
        exponents: Sequence[float],
        progress: Progress | None = None,
        ready: Ready | None = None,
    ) -> LobeMaps:
        """Return the maps of :func:`prefilter`, from disk where they are there; ``ready`` as there.

        Only an unsound request or a cancelled ``progress`` raises.
        """
        key = cache_key(environment, exponents)
        found = self._load(key)
        if found is None:
            with self._turn(key, progress):
                found = self._load(key)
                if found is None:
                    found = prefilter(environment, exponents, progress, ready)
                    self._store(key, found)
        report(progress, 1.0, "the environment is filtered")
        return found

    def entries(self) -> list[Path]:
        """Return the entries' files, the one unused for longest first."""
        try:
            aged = [(path.stat().st_mtime_ns, path) for path in self.folder.glob(f"*{_ENDING}")]
        except OSError:
            return []  # another program removed one meanwhile; the next call sees what is left
        return [path for _, path in sorted(aged)]

    def clear(self) -> None:
        """Remove all entries."""
        for path in self.entries():
            _remove(path)

    def _path(self, key: str) -> Path:
        return self.folder / f"{key}{_ENDING}"

    def _load(self, key: str) -> LobeMaps | None:
        path = self._path(key)
        try:
            data = path.read_bytes()
        except FileNotFoundError:
            return None
        except OSError as error:
            _log.warning("The map cache %s cannot be read (%s); the maps are made anew.", path, error)
            return None
        try:
            maps = decode_maps(data, key)
        except DamagedMapFileError as error:
            _log.warning("The cached maps %s are damaged (%s); they are removed and made anew.", path, error)
            _remove(path)
            return None
        with contextlib.suppress(OSError):  # a read-only cache still serves; only its ages stand still
            os.utime(path)
        return maps

    def _store(self, key: str, maps: LobeMaps) -> None:
        parts = encode_maps(maps, key)
        temporary: Path | None = None
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self._make_room(sum(len(item) for item in parts))
            handle, name = tempfile.mkstemp(dir=self.folder, prefix=".", suffix=".part")
            temporary = Path(name)
            with os.fdopen(handle, "wb") as stream:
                for item in parts:
                    stream.write(item)
                stream.flush()
                os.fsync(stream.fileno())
            temporary.replace(self._path(key))
        except OSError as error:
            _log.warning("The filtered maps are not kept: %s cannot be written (%s).", self.folder, error)
            if temporary is not None:
                _remove(temporary)

    def _make_room(self, needed: int) -> None:
        """Remove what was unused for longest until ``needed`` bytes fit, and what killed writers left."""
        for path in self.folder.glob(".*.part"):
            with contextlib.suppress(FileNotFoundError):
                if time.time() - path.stat().st_mtime > _STALE_SECONDS:
                    path.unlink()
        sizes = []
        for path in self.entries():
            with contextlib.suppress(FileNotFoundError):
                sizes.append((path, path.stat().st_size))
        excess = sum(size for _, size in sizes) + needed - self.limit_bytes
        for path, size in sizes:
            if excess <= 0:
                break
            _remove(path)
            excess -= size

    @contextmanager
    def _turn(self, key: str, progress: Progress | None) -> Iterator[None]:
        """Hold the lock of an entry, waiting for another program that makes it; without a lock where none
        works.

        One of 256 lock files serves each entry: their number stays bounded without ever deleting one, which
        could split its holders.
        """
        from filelock import FileLock, Timeout

        lock = None
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            lock = FileLock(self.folder / f".{key[:2]}.lock")
            start = time.monotonic()
            while not lock.is_locked:
                try:
                    lock.acquire(timeout=_POLL_SECONDS)
                except Timeout:
                    report(progress, 0.0, "waiting for another program that filters this environment")
                    if time.monotonic() - start > self.lock_timeout_s:
                        _log.warning("Gave up waiting for another program that filters the environment.")
                        lock = None
                        break
        except (OSError, NotImplementedError) as error:
            _log.warning("The map cache %s cannot be locked (%s).", self.folder, error)
            lock = None
        try:
            yield
        finally:
            if lock is not None:
                lock.release()


def cache_key(environment: Environment, exponents: Sequence[float]) -> str:
    """Return the name of the maps of an environment and exponents: 64 hexadecimal digits."""
    parts = [
        environment.content_hash,
        [float(exponent) for exponent in exponents],
        ALGORITHM_VERSION,
        FORMAT_VERSION,
        background_size(environment),
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()


def _remove(path: Path) -> None:
    """Remove a file where that is possible; another program may have done so already."""
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        _log.warning("%s cannot be removed (%s).", path, error)
