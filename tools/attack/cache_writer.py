"""A program that writes maps into the cache and may be killed at any moment, and how another drives it.

``kill_cache_writers.py`` starts this file as a process and kills it. Free, it writes for ever and says ``start`` and
``end`` of each write. In steps it does nothing unbidden: it makes the entry whose number it is sent, and stands still
until it is signalled to continue before the maps are made (``filtering``) and after each piece that is written
(``piece``).
"""

from __future__ import annotations

import argparse
import os
import queue
import random
import subprocess
import sys
import threading
import time
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np

from brdf_suite.files.cache import disk_cache as cache_folder
from brdf_suite.lighting import lobe_map_cache as cache
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.lighting.lobe_map_cache import MapCache, cache_key

EXPONENTS = (3.0, 40.0)
ENTRIES = 4
KEPT = 3.5  # entries that fit below the limit: room has to be made all the time
PATIENCE_S = 150.0
_PIECE_BYTES = 1 << 20
_STANDS_STILL_S = (
    3600.0  # in steps a writer gives no sign of life for as long as it is not signalled to continue
)

Parts = Iterable[bytes | memoryview]


def environment(index: int) -> Environment:
    """Return one of the environments that are written, tiny and always the same."""
    pixels = np.random.default_rng(index).random((8, 16, 3)).astype(np.float32)
    return Environment(f"environment {index}", pixels)


def maps_of(index: int, size: int) -> LobeMaps:
    """Return maps of ``size`` texels a face side that stand for filtered ones: noise from a fixed seed."""
    rng = np.random.default_rng(1000 + index)
    made = [FaceArray(rng.random((6, size, size, 3)).astype(np.float16), 0.5) for _ in range(4)]
    return LobeMaps(EXPONENTS, (made[0], made[1]), made[2], made[2], made[3])


def limit(size: int) -> int:
    """Return the cache's limit in bytes."""
    return int(KEPT * 4 * 6 * size * size * 3 * 2)


def entry_path(store: MapCache, index: int) -> Path:
    """Return where an entry is kept."""
    return store.path(cache_key(environment(index), EXPONENTS))


def same(one: LobeMaps, other: LobeMaps) -> bool:
    """Whether two sets of maps are equal bit by bit."""
    pairs = zip(
        (one.diffuse, one.through_coat, one.background, *one.lobes),
        (other.diffuse, other.through_coat, other.background, *other.lobes),
        strict=True,
    )
    return one.exponents == other.exponents and all(
        a.scale == b.scale and np.array_equal(a.faces, b.faces) for a, b in pairs
    )


def say(*words: object) -> None:
    """Say something to who started this process."""
    print(*words, flush=True)


def stand_still(*words: object) -> None:
    """Say where this process stands, and wait until it is signalled to continue."""
    say(*words)
    if not sys.stdin.readline():
        sys.exit("The controlling process is gone.")


def pieces(parts: Parts) -> list[bytes | memoryview]:
    """Return the parts of a file, those longer than a MiB cut into pieces of one."""
    return [item[at : at + _PIECE_BYTES] for item in parts for at in range(0, len(item), _PIECE_BYTES)]


def each_announced(parts: Parts) -> Iterator[bytes | memoryview]:
    """Yield the pieces; after each one stand still. What is asked for the next has written the last."""
    every = pieces(parts)
    for index, piece in enumerate(every):
        yield piece
        stand_still("piece", index + 1, len(every))


def write_straight(path: Path, parts: Parts) -> None:
    """Write an entry under its final name at once, as a cache without care would."""
    with path.open("wb") as stream:
        for item in parts:
            stream.write(item)
            os.fsync(stream.fileno())


def report_outcome(store: MapCache, found: LobeMaps, wanted: LobeMaps) -> None:
    """Say what was wrong with the maps and the cache's notices."""
    if not same(found, wanted):
        say("wrong")
    for notice in store.notices:
        say("notice", notice)
    store.notices.clear()


def write_for_ever(folder: Path, size: int, seed: int, careless: bool) -> None:
    """Write entries until killed; say ``start`` and ``end`` of each write on standard output."""
    made = {environment(i).name: maps_of(i, size) for i in range(ENTRIES)}
    real = write_straight if careless else cache_folder.write

    def reported(path: Path, parts: Parts) -> None:
        say("start")
        real(path, parts)
        say("end")

    cache_folder.write = reported
    cache.prefilter = lambda environment, *_: made[environment.name]
    rng = random.Random(seed)
    store = MapCache(folder, limit_bytes=limit(size))
    while True:
        index = rng.randrange(ENTRIES)
        cache_folder.remove(entry_path(store, index))
        wanted = environment(index)
        report_outcome(store, store.get_or_compute(wanted, EXPONENTS), made[wanted.name])


def write_in_steps(folder: Path, size: int, careless: bool) -> None:
    """Make the entries whose numbers come on standard input, one step at a time, until there are no more."""
    made = {environment(i).name: maps_of(i, size) for i in range(ENTRIES)}
    real = write_straight if careless else cache_folder.write
    waiting = False

    def stepped(path: Path, parts: Parts) -> None:
        real(path, each_announced(parts))

    def stand_in(environment: Environment, *_: object) -> LobeMaps:
        stand_still("filtering")
        return made[environment.name]

    def pause(_: float, what: str) -> None:
        nonlocal waiting
        if what.startswith("waiting") and not waiting:
            waiting = True
            say("waiting")

    cache_folder.write = stepped
    cache.prefilter = stand_in
    patience = {"lock_timeout_s": _STANDS_STILL_S, "silence_s": _STANDS_STILL_S}
    store = MapCache(folder, limit_bytes=limit(size), **patience)
    say("idle")
    for line in sys.stdin:
        wanted = environment(int(line))
        waiting = False
        report_outcome(store, store.get_or_compute(wanted, EXPONENTS, pause), made[wanted.name])
        say("idle")


class Writer:
    """A writing process, and what it says."""

    def __init__(self, folder: Path, size: int, *arguments: str) -> None:
        self.heard: queue.SimpleQueue[str] = queue.SimpleQueue()
        self.asides: list[str] = []
        self.process = subprocess.Popen(
            [sys.executable, __file__, str(folder), str(size), *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.heard.put(line.strip())

    def wait_for(self, word: str) -> tuple[float, list[str]]:
        """Return the seconds until ``word`` is said anew, and all that was said before it."""
        said = []
        while not self.heard.empty():
            said.append(self.heard.get_nowait())
        begin = time.monotonic()
        while True:
            line = self.heard.get(timeout=PATIENCE_S)
            if line == word:
                return time.monotonic() - begin, said
            said.append(line)

    def send(self, word: object = "go") -> None:
        """Say what is next to a writer in steps: an entry's number, or to go on."""
        assert self.process.stdin is not None
        self.process.stdin.write(f"{word}\n")
        self.process.stdin.flush()

    def expect(self, *words: str) -> list[str]:
        """Return the first of ``words`` that is said, with what follows it; the rest goes to ``asides``."""
        while True:
            line = self.heard.get(timeout=PATIENCE_S)
            first, *rest = line.split()
            if first in words:
                return [first, *rest]
            self.asides.append(line)

    def kill(self) -> list[str]:
        """Kill it at once and return what it said since it was last heard."""
        self.process.kill()
        self.process.wait()
        self._reader.join()
        assert self.process.stdout is not None
        assert self.process.stdin is not None
        self.process.stdout.close()
        self.process.stdin.close()
        rest = []
        while not self.heard.empty():
            rest.append(self.heard.get())
        return rest


def main() -> None:
    """Be a writer until killed."""
    parser = argparse.ArgumentParser(description="Write maps into a cache until killed.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("size", type=int, help="texels along a face's side")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--careless", action="store_true", help="write under the final name at once")
    parser.add_argument("--stepped", action="store_true", help="stand still between steps")
    options = parser.parse_args()
    if options.stepped:
        write_in_steps(options.folder, options.size, options.careless)
    else:
        write_for_ever(options.folder, options.size, options.seed, options.careless)


if __name__ == "__main__":
    main()
