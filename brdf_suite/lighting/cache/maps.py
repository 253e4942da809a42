"""Disk cache of prefiltered maps, keyed by the content they were made from.

The cache only ever saves time. Whatever happens to it (full or read-only disk, a damaged entry, another
program at the same work, a kill at any moment), the caller gets the maps; failures are reported.

- The key is a hash of the environment's pixels, the exponents, the versions of algorithm and file, and the
  largest face size.
- An entry is written under a temporary name, synced and renamed, and carries a checksum that is checked on
  reading (:mod:`brdf_suite.lighting.cache.maps.map_file`, :mod:`brdf_suite.lighting.cache.maps.folder`).
- Programs that need the same entry are serialized by a lock (:mod:`brdf_suite.lighting.cache.maps.lock`). A damaged
entry is removed
  only by who holds it, so that no process removes what another has just rebuilt.
- The maps of the default light come with the programs (``packaging/generators/resources.py lobe_maps`` writes them):
  they are looked for first, under the same key, and are never copied into the user's folder.
- Above the size limit the entries unused for longest are removed.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import logging
import os
from collections.abc import Sequence
from pathlib import Path

from brdf_suite.lighting.cache import folder as cache_folder
from brdf_suite.lighting.cache.folder import ENDING, CacheCheck, CacheEntry
from brdf_suite.lighting.cache.lock import exclusive_entry
from brdf_suite.lighting.cache.map_file import FORMAT_VERSION, DamagedMapFileError, encode_maps, read_map_file
from brdf_suite.lighting.cache.packed_maps import read_packed_maps
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.prefilter import (
    ALGORITHM_VERSION,
    LobeMaps,
    Ready,
    background_size,
    prefilter,
)
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource_root

ENVIRONMENT_VARIABLE = "BRDF_SUITE_CACHE"
LIMIT_VARIABLE = "BRDF_SUITE_CACHE_MB"
DEFAULT_LIMIT_BYTES = 2 * 1024**3
PACKAGED = "lobe_maps"
"""The folder, among the resources, of the maps that come with the programs."""
PACKAGED_ENDING = ".packedmaps"

_log = logging.getLogger(__name__)


def default_root() -> Path:
    """Return the cache's folder: ``$BRDF_SUITE_CACHE``, or the system's place for a user's caches."""
    override = os.environ.get(ENVIRONMENT_VARIABLE)
    if override:
        return Path(override)
    import platformdirs

    return Path(platformdirs.user_cache_dir("brdf-suite", appauthor=False))


def default_limit() -> int:
    """Return the size in bytes that the cache may have: ``$BRDF_SUITE_CACHE_MB``, in 10⁶ bytes, or 2 GiB."""
    text = os.environ.get(LIMIT_VARIABLE, "").strip()
    if not text:
        return DEFAULT_LIMIT_BYTES
    if not text.isdecimal():
        _log.warning("%s is %r, not a whole number of megabytes; 2 GiB is the limit.", LIMIT_VARIABLE, text)
        return DEFAULT_LIMIT_BYTES
    return int(text) * 1_000_000


class MapCache:
    """Cache of lobe maps, keyed by content.

    Parameters
    ----------
    root
        The cache's folder; None: see :func:`default_root`.
    limit_bytes
        The size kept on disk; None: see :func:`default_limit`. 0 keeps nothing.
    lock_timeout_s, silence_s
        How long to wait for another program that makes the same maps, in all and without a sign of life.

    Attributes
    ----------
    notices
        What went wrong with the cache so far, as sentences for the user; they are logged too.

    >>> MapCache().get_or_compute(environment, [20.0, 500.0])  # doctest: +SKIP
    """

    def __init__(
        self,
        root: str | os.PathLike[str] | None = None,
        *,
        limit_bytes: int | None = None,
        lock_timeout_s: float = 600.0,
        silence_s: float = 60.0,
    ) -> None:
        self.folder = (Path(root) if root is not None else default_root()) / "lobe_maps"
        self.limit_bytes = default_limit() if limit_bytes is None else limit_bytes
        self.lock_timeout_s = lock_timeout_s
        self.silence_s = silence_s
        self.notices: list[str] = []

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
        found = self._load_packaged(key)
        if found is None:
            found = self._load(key, damaged_goes=False)
        if found is None:
            waiting = exclusive_entry(
                self.folder,
                key,
                timeout_s=self.lock_timeout_s,
                silence_s=self.silence_s,
                progress=progress,
                notice=self._notice,
            )
            with waiting as turn:
                found = self._load(key, damaged_goes=True)
                if found is None:
                    found = prefilter(environment, exponents, turn.watched(progress), ready)
                    self._store(key, found, environment.name, key if turn.locked else None)
        report(progress, 1.0, "the environment is filtered")
        return found

    def entries(self) -> list[CacheEntry]:
        """Return the entries, the one unused for longest first."""
        return cache_folder.entries(self.folder)

    def unfinished(self) -> list[Path]:
        """Return the files that are being written, or that a killed program left."""
        return cache_folder.find_unfinished(self.folder)

    def clear(self) -> int:
        """Remove all entries and what killed programs left; return how many entries could not be removed."""
        failed = sum(not cache_folder.remove(entry.path) for entry in self.entries())
        cache_folder.remove_unfinished(self.folder)
        return failed

    def verify(self, *, remove: bool = False, progress: Progress | None = None) -> CacheCheck:
        """Read every entry and compare its checksum; ``remove`` the damaged ones and what was left unfinished."""
        return cache_folder.check(self.folder, remove_damaged=remove, progress=progress, notice=self._notice)

    def _load_packaged(self, key: str) -> LobeMaps | None:
        """Return maps that come with the programs; None where these are not among them, or are damaged."""
        path = resource_root() / PACKAGED / f"{key}{PACKAGED_ENDING}"
        try:
            return read_packed_maps(path, key)
        except FileNotFoundError:
            return None
        except (DamagedMapFileError, OSError) as error:
            self._notice(
                f"The packaged maps {path} cannot be used ({error}); they are made again. Install brdf-suite again."
            )
            return None

    def _load(self, key: str, *, damaged_goes: bool) -> LobeMaps | None:
        """Return an entry; None where it is not there, or not to be used, which is reported when it is removed."""
        path = self.folder / f"{key}{ENDING}"
        try:
            maps = read_map_file(path, key)
        except (FileNotFoundError, NotADirectoryError):
            return None
        except DamagedMapFileError as error:
            if damaged_goes:
                self._notice(
                    f"The cached maps {path} are damaged ({error}); they are removed and made again."
                )
                cache_folder.remove(path)
            return None
        except OSError as error:
            if damaged_goes:
                self._notice(
                    f"The cached maps {path} cannot be read ({error.strerror or error}); they are made again."
                )
            return None
        with contextlib.suppress(OSError):  # a read-only cache still serves; only its ages stand still
            os.utime(path)
        return maps

    def _store(self, key: str, maps: LobeMaps, environment: str, held_key: str | None) -> None:
        parts = encode_maps(maps, key, environment)
        needed = sum(len(item) for item in parts)
        if held_key is not None:
            cache_folder.remove_unfinished(self.folder, held_key)
        if self.limit_bytes == 0:
            return
        if not cache_folder.make_room(self.folder, needed, self.limit_bytes):
            self._notice(
                f"The filtered maps are not kept: {needed / 1e6:,.0f} MB do not fit into the cache's "
                f"{self.limit_bytes / 1e6:,.0f} MB; {LIMIT_VARIABLE} sets another limit."
            )
            return
        try:
            cache_folder.write(self.folder, key, parts)
        except OSError as error:
            self._notice(
                f"The filtered maps are not kept: {self.folder} cannot be written ({error.strerror or error}). "
                f"Make room there, or set {ENVIRONMENT_VARIABLE} to another folder."
            )
            return
        cache_folder.make_room(self.folder, 0, self.limit_bytes)  # others may have written meanwhile, too

    def _notice(self, text: str) -> None:
        self.notices.append(text)
        _log.warning("%s", text)


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
