"""Kill programs in the middle of cache writes and see that what is left is sound.

Two writers put maps into one cache, the same few entries over and over, while entries are removed to make room.
Each is killed (SIGKILL) at a random moment of a write and started again, until ``--kills`` of them hit. After every
kill all entries are checked while the other writer goes on, and at the end by ``brdf-suite cache verify``; then one
more program must find or make every entry, equal to what it should be, and nothing unfinished may be left.

``--careless`` writes under the final name at once, as a cache without care would: then the check must fail.

Run ``python tests/benchmarks/kill_cache_writers.py [--kills 100] [--json]``; status 1 where anything is wrong.
A kill leaves what the system holds in memory: this says nothing about a power cut, for which entries are synced.
"""

from __future__ import annotations

import argparse
import json
import os
import queue
import random
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from brdf_suite.lighting import cache, cache_folder
from brdf_suite.lighting.cache import MapCache, cache_key
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.face_array import FaceArray
from brdf_suite.lighting.prefilter import LobeMaps

EXPONENTS = (3.0, 40.0)
ENTRIES = 4
KEPT = 3.5  # entries that fit below the limit: room has to be made all the time
PATIENCE_S = 60.0


def environment(index: int) -> Environment:
    """Return one of the environments that are written, tiny and always the same."""
    pixels = np.random.default_rng(index).random((8, 16, 3)).astype(np.float32)
    return Environment(f"environment {index}", pixels)


def maps_of(index: int, size: int) -> LobeMaps:
    """Return maps of ``size`` texels a face side that stand for filtered ones: noise from a fixed seed."""
    rng = np.random.default_rng(1000 + index)
    made = [FaceArray(rng.random((6, size, size, 3)).astype(np.float16), 0.5) for _ in range(4)]
    return LobeMaps(EXPONENTS, (made[0], made[1]), made[2], made[3])


def limit(size: int) -> int:
    """Return the cache's limit in bytes."""
    return int(KEPT * 4 * 6 * size * size * 3 * 2)


def same(one: LobeMaps, other: LobeMaps) -> bool:
    """Whether two sets of maps are equal bit by bit."""
    pairs = zip(
        (one.diffuse, one.background, *one.lobes),
        (other.diffuse, other.background, *other.lobes),
        strict=True,
    )
    return one.exponents == other.exponents and all(
        a.scale == b.scale and np.array_equal(a.faces, b.faces) for a, b in pairs
    )


def write_for_ever(folder: Path, size: int, seed: int, careless: bool) -> None:
    """Write entries until killed; say ``start`` and ``end`` of each write on standard output."""
    made = {environment(i).name: maps_of(i, size) for i in range(ENTRIES)}
    real = cache_folder.write

    def careful(folder: Path, key: str, parts: Iterable[bytes | memoryview]) -> None:
        print("start", flush=True)
        real(folder, key, parts)
        print("end", flush=True)

    def straight(folder: Path, key: str, parts: Iterable[bytes | memoryview]) -> None:
        print("start", flush=True)
        with (folder / f"{key}{cache_folder.ENDING}").open("wb") as stream:
            for item in parts:
                stream.write(item)
                os.fsync(stream.fileno())
        print("end", flush=True)

    cache_folder.write = straight if careless else careful
    cache.prefilter = lambda environment, *_: made[environment.name]
    rng = random.Random(seed)
    store = MapCache(folder, limit_bytes=limit(size))
    while True:
        wanted = environment(rng.randrange(ENTRIES))
        cache_folder.remove(store.folder / f"{cache_key(wanted, EXPONENTS)}{cache_folder.ENDING}")
        if not same(store.get_or_compute(wanted, EXPONENTS), made[wanted.name]):
            print("wrong", flush=True)
        for notice in store.notices:
            print("notice", notice, flush=True)
        store.notices.clear()


class Writer:
    """A writing process, and what it says with the time at which it was heard."""

    def __init__(self, folder: Path, size: int, seed: int, careless: bool) -> None:
        self.heard: queue.SimpleQueue[str] = queue.SimpleQueue()
        arguments = ["--writer", str(folder), "--size", str(size), "--seed", str(seed)]
        self.process = subprocess.Popen(
            [sys.executable, __file__, *arguments, *(["--careless"] if careless else [])],
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

    def kill(self) -> list[str]:
        """Kill it at once and return what it said since the last wait."""
        self.process.kill()
        self.process.wait()
        self._reader.join()
        assert self.process.stdout is not None
        self.process.stdout.close()
        rest = []
        while not self.heard.empty():
            rest.append(self.heard.get())
        return rest


def trial(folder: Path, kills: int, size: int, careless: bool, seed: int = 1) -> dict[str, object]:
    """Kill writers until ``kills`` of them hit a write, and return the figures."""
    rng = random.Random(seed)
    checker = MapCache(folder)
    fresh = iter(range(10_000))
    writers = [Writer(folder, size, next(fresh), careless) for _ in range(2)]
    hits = misses = damaged = wrong = 0
    left_over = 0
    longest_wait = 0.0
    notices: set[str] = set()
    try:
        writers[0].wait_for("start")
        typical = writers[0].wait_for("end")[0]
        while hits < kills:
            victim = rng.randrange(2)
            waited, said = writers[victim].wait_for("start")
            if "end" in said:  # not its first write: what it waited for is a turn, not its own start-up
                longest_wait = max(longest_wait, waited)
            time.sleep(rng.uniform(0.0, 1.3 * typical))
            rest = writers[victim].kill()
            # What it had written down as ended while we slept is in ``rest``: then the last write decides.
            ends = [word for word in rest if word in ("start", "end")]
            in_write = not ends or ends[-1] == "start"
            hits, misses = hits + in_write, misses + (not in_write)
            typical *= 1.1 if in_write else 0.9
            wrong += (said + rest).count("wrong")
            notices |= {line.removeprefix("notice ") for line in said + rest if line.startswith("notice")}
            left_over = max(left_over, len(checker.unfinished()))
            damaged += len(checker.verify().damaged)
            writers[victim] = Writer(folder, size, next(fresh), careless)
    finally:
        for writer in writers:
            writer.kill()
    verified = subprocess.run(
        [sys.executable, "-m", "brdf_suite.cli.main", "cache", "verify", "--json"],
        env={**os.environ, cache.ENVIRONMENT_VARIABLE: str(folder)},
        capture_output=True,
        text=True,
        check=False,
    )
    made = {environment(i).name: maps_of(i, size) for i in range(ENTRIES)}
    cache.prefilter = lambda environment, *_: made[environment.name]
    last = MapCache(folder, limit_bytes=limit(size))
    equal = sum(
        same(last.get_or_compute(environment(i), EXPONENTS), made[environment(i).name])
        for i in range(ENTRIES)
    )
    return {
        "kills_in_a_write": hits,
        "kills_beside_one": misses,
        "verify_status": verified.returncode,
        "damaged_after_kills": damaged,
        "wrong_maps_read": wrong,
        "entries_right_afterwards": equal,
        "unfinished_at_most": left_over,
        "unfinished_afterwards": len(last.unfinished()),
        "longest_wait_s": round(longest_wait, 3),
        "notices": sorted(notices | set(last.notices)),
        "passed": verified.returncode == 0
        and damaged == wrong == 0
        and equal == ENTRIES
        and not last.unfinished(),
    }


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the trial, or be one of its writers."""
    parser = argparse.ArgumentParser(description="Kill programs in the middle of cache writes.")
    parser.add_argument("--kills", type=int, default=100, help="kills that hit a write (default: 100)")
    parser.add_argument(
        "--size", type=int, default=512, help="texels along a face's side (default: 512, 38 MB an entry)"
    )
    parser.add_argument(
        "--careless", action="store_true", help="write under the final name: the check must fail"
    )
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--writer", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=int, default=0, help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if options.writer is not None:
        write_for_ever(options.writer, options.size, options.seed, options.careless)
    with tempfile.TemporaryDirectory(prefix="brdf-suite-kill-") as folder:
        figures = trial(Path(folder), options.kills, options.size, options.careless)
    if options.json:
        print(json.dumps(figures, indent=2))
    else:
        for key, value in figures.items():
            print(f"{key:>26}: {value}")
    return 0 if figures["passed"] else 1


if __name__ == "__main__":
    sys.exit(main())
