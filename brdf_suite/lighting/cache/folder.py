"""Files of the map cache: listing, eviction and verification.

Nothing here fails for the sake of the cache. Another program may add or remove any file at any moment, so
every step allows for a file that has gone.
"""

from __future__ import annotations

import contextlib
import os
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.lighting.cache.lock import shard, try_entry
from brdf_suite.lighting.cache.map_file import FORMAT_VERSION, DamagedMapFileError, read_map_file
from brdf_suite.progress import Progress, report

_EVERY_ENDING = ".lobemaps"
ENDING = f".v{FORMAT_VERSION}{_EVERY_ENDING}"
"""How the entries of this version end; those of others are never read, and go when space is short."""
_UNFINISHED = ".part"
_FORGOTTEN_SECONDS = 3600.0


@dataclass(frozen=True)
class CacheEntry:
    """One entry: its file, its size in bytes, and when it was last used, in seconds since 1970."""

    path: Path
    size: int
    last_used: float

    @property
    def key(self) -> str:
        """What the entry was made from, as 64 hexadecimal digits."""
        return self.path.name.split(".")[0]

    @property
    def outdated(self) -> bool:
        """Whether another version of the program wrote it."""
        return not self.path.name.endswith(ENDING)


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


def entries(folder: Path) -> list[CacheEntry]:
    """Return the entries in ``folder``, the one unused for longest first; none where there is no folder."""
    found = []
    for path in _listed(folder):
        if path.name.endswith(_EVERY_ENDING) and not path.name.startswith("."):
            with contextlib.suppress(OSError):
                state = path.stat()
                found.append(CacheEntry(path, state.st_size, state.st_mtime))
    return sorted(found, key=lambda entry: (entry.last_used, entry.path.name))


def find_unfinished(folder: Path) -> list[Path]:
    """Return the files that are being written, or that a killed program left."""
    return [path for path in _listed(folder) if path.name.startswith(".") and path.name.endswith(_UNFINISHED)]


def write(folder: Path, key: str, parts: Iterable[bytes | memoryview]) -> None:
    """Write an entry under a temporary name, sync it, and give it its name in one step.

    Raises
    ------
    OSError
        The disk is full or read-only; nothing is left behind.
    """
    folder.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=folder, prefix=f".{key}-", suffix=_UNFINISHED)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as stream:
            for item in parts:
                stream.write(item)
            stream.flush()
            os.fsync(stream.fileno())
        temporary.replace(folder / f"{key}{ENDING}")
    except BaseException:
        with contextlib.suppress(OSError):
            temporary.unlink(missing_ok=True)
        raise
    _sync_names(folder)


def make_room(folder: Path, needed: int, limit: int) -> bool:
    """Remove entries unused for longest until ``needed`` bytes more stay below ``limit``; say if they do."""
    if needed > limit:
        return False
    kept = entries(folder)
    excess = sum(entry.size for entry in kept) + needed - limit
    for entry in kept:
        if excess <= 0:
            break
        if remove(entry.path):
            excess -= entry.size
    return excess <= 0


def remove_unfinished(folder: Path, held_key: str | None = None) -> int:
    """Remove what killed programs left; return how many files.

    A file belongs to a live program while that holds the entry's lock, unless it has been there for an hour.
    ``held_key`` is an entry whose lock the caller holds itself.
    """
    count = 0
    for path in find_unfinished(folder):
        key = path.name[1:].split("-")[0]
        try:
            old = time.time() - path.stat().st_mtime > _FORGOTTEN_SECONDS
        except OSError:
            continue
        if old or (held_key is not None and shard(key) == shard(held_key)):
            count += remove(path)
        else:
            with try_entry(folder, key) as free:
                count += free and remove(path)
    return count


def check(
    folder: Path, *, remove_damaged: bool, progress: Progress | None, notice: Callable[[str], None]
) -> CacheCheck:
    """Read every entry and compare its checksum; what cannot be read counts as damaged."""
    damaged: list[tuple[str, str]] = []
    sound = outdated = 0
    gone = True
    every = entries(folder)
    for index, entry in enumerate(every):
        report(progress, index / len(every), f"checking {index + 1} of {len(every)}")
        if entry.outdated:
            outdated += 1
            continue
        try:
            read_map_file(entry.path, entry.key)
            sound += 1
            continue
        except FileNotFoundError:  # another program made room
            continue
        except DamagedMapFileError as error:
            damaged.append((entry.path.name, str(error)))
        except OSError as error:
            damaged.append((entry.path.name, f"cannot be read ({error.strerror or error})"))
        if remove_damaged and not remove(entry.path):
            notice(f"{entry.path} cannot be removed.")
            gone = False
    if remove_damaged:
        remove_unfinished(folder)
    report(progress, 1.0, "checked")
    return CacheCheck(sound, outdated, tuple(damaged), len(find_unfinished(folder)), remove_damaged and gone)


def remove(path: Path) -> bool:
    """Remove a file; False where that cannot be. One that another program has removed already is removed."""
    try:
        path.unlink(missing_ok=True)
    except OSError:
        return False
    return True


def _listed(folder: Path) -> list[Path]:
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _sync_names(folder: Path) -> None:
    """Bring the folder's new name to the disk, where the system can; without it a crash may lose the entry."""
    if os.name != "posix":
        return
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
