"""Locks of the cache, one per entry, so that several programs compute an entry only once.

An operating-system lock guards each entry: it is released when its holder dies for any reason. A holder that
is stopped or hangs is detected by its heartbeat, a small file that it touches while it works: after a time
without one, the other programs proceed without it. One of 256 lock files serves each entry, so
their number stays bounded without ever deleting one, which could split its holders.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.progress import Progress, report

POLL_SECONDS = 0.2
_TOUCH_SECONDS = 1.0

Notice = Callable[[str], None]


@dataclass(frozen=True)
class EntryLock:
    """Exclusive access to an entry. ``locked`` is False where no lock was available and others may work on it too."""

    locked: bool
    alive: Path

    def watched(self, progress: Progress | None) -> Progress:
        """Return ``progress`` that also touches the heartbeat file for waiting programs."""
        last = -_TOUCH_SECONDS

        def touch(fraction: float, what: str) -> None:
            nonlocal last
            now = time.monotonic()
            if self.locked and now - last >= _TOUCH_SECONDS:
                last = now
                with contextlib.suppress(
                    OSError
                ):  # a full disk: the others wait as long as they would anyway
                    self.alive.touch()
            report(progress, fraction, what)

        return touch


def shard(key: str) -> str:
    """Return the name of the lock, one of 256, that serves an entry."""
    return key[:2]


def lock_path(folder: Path, key: str) -> Path:
    """Return the lock file of an entry."""
    return folder / f".{shard(key)}.lock"


@contextmanager
def exclusive_entry(
    folder: Path, key: str, *, timeout_s: float, silence_s: float, progress: Progress | None, notice: Notice
) -> Iterator[EntryLock]:
    """Hold the lock of an entry while the body runs; wait for another program that holds it.

    After ``timeout_s`` of waiting, or ``silence_s`` without a heartbeat of the holder, or where the folder
    supports no locks, the body runs without one; ``notice`` is called. Both times are in seconds. ``progress`` may
    cancel the waiting.
    """
    from filelock import BaseFileLock, FileLock, Timeout  # 35 ms, which a cache that has the entry saves

    alive = folder / f".{shard(key)}.alive"
    lock: BaseFileLock | None = None
    start = heard = time.monotonic()
    beat = _heartbeat(alive)
    while True:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            lock = lock or FileLock(lock_path(folder, key))
            lock.acquire(timeout=POLL_SECONDS)
            break
        except Timeout:
            # Only changes of the heartbeat count: the clock of a network folder may differ from ours.
            now, latest = time.monotonic(), _heartbeat(alive)
            if latest != beat:
                beat, heard = latest, now
            if now - start > timeout_s or now - heard > silence_s:
                notice(
                    f"Waited {now - start:.0f} s for another program at the same work; continuing without it."
                )
                lock = None
                break
        except (OSError, NotImplementedError) as error:
            notice(f"The cache {folder} cannot be locked ({error}).")
            lock = None
            break
        report(progress, 0.0, "waiting for another program at the same work")
    try:
        yield EntryLock(lock is not None, alive)
    finally:
        if lock is not None:
            lock.release()


@contextmanager
def try_entry(folder: Path, key: str) -> Iterator[bool]:
    """Hold the lock of an entry if it is free; yields whether it is held."""
    from filelock import FileLock, Timeout

    lock = FileLock(lock_path(folder, key))
    try:
        lock.acquire(blocking=False)
    except (Timeout, OSError, NotImplementedError):
        yield False
        return
    try:
        yield True
    finally:
        lock.release()


def _heartbeat(alive: Path) -> int:
    try:
        return alive.stat().st_mtime_ns
    except OSError:
        return 0
