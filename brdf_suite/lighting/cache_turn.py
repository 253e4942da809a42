"""Programs that want the same entry of the cache take turns, so that the work is done once.

A lock of the system guards each entry: it is freed when its holder dies, however it dies. A holder that lives
but makes no headway (stopped, or hung) is noticed by its sign of life, a small file that it touches while it
works: after a time without one, the others go on without it. One of 256 lock files serves each entry, so
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
class Turn:
    """One's turn at an entry. ``locked`` is False where no lock could be had and others may work on it too."""

    locked: bool
    alive: Path

    def watched(self, progress: Progress | None) -> Progress:
        """Return ``progress`` that also gives the sign of life for those who wait."""
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
    """Return which of the 256 locks serves an entry."""
    return key[:2]


def lock_path(folder: Path, key: str) -> Path:
    """Return the lock file of an entry."""
    return folder / f".{shard(key)}.lock"


@contextmanager
def take_turn(
    folder: Path, key: str, *, timeout_s: float, silence_s: float, progress: Progress | None, notice: Notice
) -> Iterator[Turn]:
    """Hold the lock of an entry while the body runs; wait for another program that holds it.

    After ``timeout_s`` of waiting, or ``silence_s`` without a sign of life of the holder, or where the folder
    takes no locks, the body runs without one; ``notice`` is called. Both times are in seconds. ``progress`` may
    cancel the waiting.
    """
    from filelock import BaseFileLock, FileLock, Timeout

    alive = folder / f".{shard(key)}.alive"
    lock: BaseFileLock | None = None
    start = heard = time.monotonic()
    sign = _sign(alive)
    while True:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            lock = lock or FileLock(lock_path(folder, key))
            lock.acquire(timeout=POLL_SECONDS)
            break
        except Timeout:
            # What counts is that the sign changes: the clock of a network folder may be another than ours.
            now, latest = time.monotonic(), _sign(alive)
            if latest != sign:
                sign, heard = latest, now
            if now - start > timeout_s or now - heard > silence_s:
                notice(
                    f"Waited {now - start:.0f} s for another program that filters this environment; going on alone."
                )
                lock = None
                break
        except (OSError, NotImplementedError) as error:
            notice(f"The map cache {folder} cannot be locked ({error}).")
            lock = None
            break
        report(progress, 0.0, "waiting for another program that filters this environment")
    try:
        yield Turn(lock is not None, alive)
    finally:
        if lock is not None:
            lock.release()


@contextmanager
def if_free(folder: Path, key: str) -> Iterator[bool]:
    """Hold the lock of an entry if that is possible at once; yields whether it is held."""
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


def _sign(alive: Path) -> int:
    try:
        return alive.stat().st_mtime_ns
    except OSError:
        return 0
