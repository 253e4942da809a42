"""Kill programs in the middle of cache writes and see that what is left is sound.

Two writers put maps into one cache, the same few entries over and over, while entries are removed to make room.
Each is killed (SIGKILL) at a random moment of a write and started again, until ``--kills`` of them hit. After every
kill all entries are checked while the other writer goes on, and at the end by ``brdf-suite cache verify``; then one
more program must find or make every entry, equal to what it should be, and nothing unfinished may be left.

``--stepped`` leaves nothing to luck: the writers stand still after each piece that they have written, and are killed
there. In turn the other one has nothing to do, stands in a write of its own, or waits for the lock of the one killed.

``--careless`` writes under the final name at once, as a cache without care would: then the check must fail.

Run ``python tools/attack/kill_cache_writers.py [--kills 100] [--json]``; status 1 where anything is wrong.
A kill leaves what the system holds in memory: this says nothing about a power cut, for which entries are synced.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from cache_writer import ENTRIES, EXPONENTS, Writer, entry_path, environment, limit, maps_of, same

from brdf_suite import variables
from brdf_suite.errors import SuiteError
from brdf_suite.files.cache import disk_cache as cache_folder
from brdf_suite.files.cache.entry_lock import shard
from brdf_suite.lighting import lobe_map_cache as cache
from brdf_suite.lighting.lobe_map_cache import MapCache

SITUATIONS = ("alone", "beside", "waited for")

Figures = dict[str, object]


def afterwards(folder: Path, size: int) -> Figures:
    """Return what the command says about the cache, and what one more program finds or makes in it."""
    verified = subprocess.run(
        [sys.executable, "-m", "brdf_suite.cli.main", "cache", "verify", "--json"],
        env={**os.environ, variables.CACHE: str(folder)},
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
        "verify_status": verified.returncode,
        "entries_right_afterwards": equal,
        "unfinished_afterwards": len(last.unfinished()),
        "last_notices": last.notices,
    }


def random_kills(folder: Path, kills: int, size: int, careless: bool) -> Figures:
    """Kill writers at random moments until ``kills`` of them hit a write."""
    rng = random.Random(1)
    checker = MapCache(folder)
    fresh = iter(range(10_000))
    way = ["--careless"] if careless else []
    writers = [Writer(folder, size, "--seed", str(next(fresh)), *way) for _ in range(2)]
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
            writers[victim] = Writer(folder, size, "--seed", str(next(fresh)), *way)
    finally:
        for writer in writers:
            writer.kill()
    return {
        "kills_in_a_write": hits,
        "kills_beside_one": misses,
        "damaged_after_kills": damaged,
        "wrong_maps_read": wrong,
        "unfinished_at_most": left_over,
        "longest_wait_s": round(longest_wait, 3),
        "notices": sorted(notices),
    }


class SteppedTrial:
    """Two writers that stand still wherever they can be killed."""

    def __init__(self, folder: Path, size: int, careless: bool) -> None:
        self._rng = random.Random(1)
        self._start = lambda: Writer(folder, size, "--stepped", *(["--careless"] if careless else []))
        self._checker = MapCache(folder)
        self._shards = [shard(entry_path(self._checker, i).name) for i in range(ENTRIES)]
        self._asides: list[str] = []
        self.left_over: list[int] = []
        self.damaged = 0

    def run(self, kills: int) -> Figures:
        """Kill ``kills`` writers in the middle of a write, in every situation in turn."""
        writers = [self._start() for _ in range(2)]
        try:
            for writer in writers:
                writer.expect("idle")
            for number in range(kills):
                victim = number % 2
                self._kill_one(writers[victim], writers[1 - victim], SITUATIONS[number % len(SITUATIONS)])
                writers[victim] = self._start()
                writers[victim].expect("idle")
        finally:
            for writer in writers:
                writer.kill()
        said = [line for writer in writers for line in writer.asides] + self._asides
        return {
            "kills_in_a_write": kills,
            "kills_beside_one": 0,
            "damaged_after_kills": self.damaged,
            "wrong_maps_read": said.count("wrong"),
            "unfinished_at_least": min(self.left_over, default=0),
            "unfinished_at_most": max(self.left_over, default=0),
            "notices": sorted({line.removeprefix("notice ") for line in said if line.startswith("notice")}),
        }

    def _kill_one(self, victim: Writer, other: Writer, situation: str) -> None:
        entry = self._rng.randrange(ENTRIES)
        self._into_a_write(victim, entry)
        if situation == "beside":
            self._into_a_write(other, self._beside(entry))
        elif situation == "waited for":
            other.send(entry)
            other.expect("waiting")
        victim.kill()
        self._asides += victim.asides
        if (
            situation == "waited for"
        ):  # the system has freed the lock: the other has its turn, and stands still
            other.expect("filtering")
        self.left_over.append(len(self._checker.unfinished()))
        self.damaged += len(self._checker.verify().damaged)
        if situation != "alone":
            other.send()
            while other.expect("piece", "idle")[0] == "piece":
                other.send()

    def _into_a_write(self, writer: Writer, entry: int) -> None:
        """Let a writer write some of an entry, and not the last piece of it."""
        cache_folder.remove(entry_path(self._checker, entry))
        writer.send(entry)
        writer.expect("filtering")
        writer.send()
        count = int(writer.expect("piece")[2])
        for _ in range(self._rng.randrange(count - 1)):
            writer.send()
            writer.expect("piece")

    def _beside(self, entry: int) -> int:
        """Return an entry that has another lock."""
        others = [i for i in range(ENTRIES) if self._shards[i] != self._shards[entry]]
        if not others:
            raise SuiteError("All entries of this trial share one lock; give it other environments.")
        return self._rng.choice(others)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the trial."""
    parser = argparse.ArgumentParser(description="Kill programs in the middle of cache writes.")
    parser.add_argument("--kills", type=int, default=100, help="kills that hit a write (default: 100)")
    parser.add_argument(
        "--size", type=int, default=512, help="texels along a face's side (default: 512, 38 MB an entry)"
    )
    parser.add_argument("--stepped", action="store_true", help="kill at known places, not at random moments")
    parser.add_argument(
        "--careless", action="store_true", help="write under the final name: the check must fail"
    )
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory(prefix="brdf-suite-kill-") as name:
        folder = Path(name)
        if options.stepped:
            figures = SteppedTrial(folder, options.size, options.careless).run(options.kills)
        else:
            figures = random_kills(folder, options.kills, options.size, options.careless)
        figures |= afterwards(folder, options.size)
    figures["passed"] = (
        figures["verify_status"] == figures["damaged_after_kills"] == figures["wrong_maps_read"] == 0
        and figures["entries_right_afterwards"] == ENTRIES
        and figures["unfinished_afterwards"] == 0
    )
    if options.json:
        print(json.dumps(figures, indent=2))
    else:
        for key, value in figures.items():
            print(f"{key:>26}: {value}")
    return 0 if figures["passed"] else 1


if __name__ == "__main__":
    sys.exit(main())
