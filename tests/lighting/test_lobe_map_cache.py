"""The cache saves time and never fails: damage, locks, full and read-only disks, two programs at once."""

import logging
import os
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from filelock import FileLock

from brdf_suite.errors import Cancelled
from brdf_suite.files.cache import entry_lock as cache_lock
from brdf_suite.files.cache.disk_cache import default_root
from brdf_suite.files.cache.entry_lock import exclusive_entry, lock_path
from brdf_suite.lighting import lobe_map_cache as cache_module
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.lighting.lobe_map_cache import PLAIN, MapCache, cache_key


@pytest.fixture
def environment() -> Environment:
    pixels = np.random.default_rng(2).random((32, 64, 3)).astype(np.float32)
    return Environment("noise", pixels)


@pytest.fixture
def count_work(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Count how often maps are really made."""
    made: list[str] = []
    real = cache_module.prefilter

    def counted(environment: Environment, *rest: object) -> LobeMaps:
        made.append(environment.name)
        return real(environment, *rest)

    monkeypatch.setattr(cache_module, "prefilter", counted)
    return made


def same(one: LobeMaps, other: LobeMaps) -> bool:
    pairs = zip(
        (one.diffuse, one.through_coat, one.background, *one.lobes),
        (other.diffuse, other.through_coat, other.background, *other.lobes),
        strict=True,
    )
    return one.exponents == other.exponents and all(
        a.scale == b.scale and np.array_equal(a.faces, b.faces) for a, b in pairs
    )


def test_second_time_comes_from_disk_and_is_the_same(environment: Environment, count_work: list[str]) -> None:
    first = MapCache().get_or_compute(environment, [3.0, 9e9])
    again = MapCache().get_or_compute(Environment("other name", environment.radiance), [3.0, 9e9])
    assert count_work == ["noise"]
    assert same(first, again)
    assert again.lobes[1] is again.background


def test_another_lobe_set_or_another_pixel_is_another_entry(
    environment: Environment, count_work: list[str]
) -> None:
    cache = MapCache()
    cache.get_or_compute(environment, [3.0])
    cache.get_or_compute(environment, [4.0])
    pixels = environment.radiance.copy()
    pixels[0, 0, 0] += np.float32(0.5)
    cache.get_or_compute(Environment("changed", pixels), [3.0])
    assert count_work == ["noise", "noise", "changed"]
    assert len(cache.entries()) == 3


@pytest.mark.parametrize("damage", ["truncate", "header", "payload", "empty", "text"])
def test_a_damaged_entry_is_noticed_and_rebuilt(
    environment: Environment, count_work: list[str], damage: str, caplog: pytest.LogCaptureFixture
) -> None:
    cache = MapCache()
    good = cache.get_or_compute(environment, [3.0])
    entry = cache.entries()[0].path
    data = bytearray(entry.read_bytes())
    if damage == "truncate":
        data = data[:-7]
    elif damage == "header":
        data[20] ^= 0xFF
    elif damage == "payload":
        data[-1000] ^= 0x01
    else:
        data = bytearray(b"" if damage == "empty" else b"not maps at all, but long enough to look")
    entry.write_bytes(bytes(data))
    with caplog.at_level(logging.WARNING):
        assert same(cache.get_or_compute(environment, [3.0]), good)
    assert "Damaged maps are removed and made again" in caplog.text
    assert len(count_work) == 2
    cache.get_or_compute(environment, [3.0])
    assert len(count_work) == 2


def test_a_place_that_cannot_be_written_costs_only_time(
    environment: Environment, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("a file where the folder should be")
    with caplog.at_level(logging.WARNING):
        maps = MapCache(blocked).get_or_compute(environment, [3.0])
    assert maps.lobes[0].faces.max() > 0
    assert "not kept" in caplog.text


def test_a_full_disk_costs_only_time_and_leaves_nothing(
    environment: Environment, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    cache = MapCache()
    with caplog.at_level(logging.WARNING):
        cache.get_or_compute(environment, [3.0])
    assert "No space left" in caplog.text
    assert cache.entries() == []
    assert not list(cache.folder.glob(".*.part"))


def test_the_entry_unused_for_longest_goes_first(environment: Environment) -> None:
    cache = MapCache()
    for index, exponent in enumerate((3.0, 4.0, 5.0)):
        cache.get_or_compute(environment, [exponent])
        entry = cache.folder / f"{cache_key(environment, [exponent])}.v{PLAIN.version}.lobemaps"
        os.utime(entry, (1000.0 + index, 1000.0 + index))
    size = cache.entries()[0].size
    cache.get_or_compute(environment, [3.0])  # used: now the youngest
    small = MapCache(limit_bytes=3 * size + size // 2)
    small.get_or_compute(environment, [6.0])
    left = {entry.key for entry in small.entries()}
    assert left == {cache_key(environment, [e]) for e in (3.0, 5.0, 6.0)}
    small.clear()
    assert small.entries() == []


PROGRAM = """
import sys, time, numpy as np
from pathlib import Path
from brdf_suite.lighting import lobe_map_cache as cache
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
folder, name = Path(sys.argv[1]), sys.argv[2]
real = cache.prefilter
def counted(*rest):
    (folder / f"made-{name}").touch()
    while len(list(folder.glob("asks-*"))) < 2:  # the other asks while this one is at work
        time.sleep(0.01)
    time.sleep(0.1)
    return real(*rest)
cache.prefilter = counted
pixels = np.random.default_rng(7).random((32, 64, 3)).astype(np.float32)
(folder / f"asks-{name}").touch()
maps = cache.MapCache().get_or_compute(Environment("shared", pixels), [15.0, 30.0])
print(int(maps.lobes[0].faces.astype(np.float64).sum()))
"""


def test_two_programs_do_the_work_once(tmp_path: Path) -> None:
    programs = [
        subprocess.Popen(
            [sys.executable, "-c", PROGRAM, str(tmp_path), name], stdout=subprocess.PIPE, text=True
        )
        for name in "ab"
    ]
    answers = [program.communicate(timeout=280)[0] for program in programs]
    assert [program.returncode for program in programs] == [0, 0]
    assert answers[0] == answers[1] != ""
    assert len(list(tmp_path.glob("made-*"))) == 1


HOLDER = """
import sys, time
from filelock import FileLock
lock = FileLock(sys.argv[1]); lock.acquire(); print("held", flush=True); time.sleep(600)
"""


def test_waiting_can_be_cancelled_and_a_killed_holder_frees_the_lock(environment: Environment) -> None:
    cache = MapCache()
    cache.folder.mkdir(parents=True)
    lock = cache.folder / f".{cache_key(environment, [3.0])[:2]}.lock"
    with subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(lock)], stdout=subprocess.PIPE, text=True
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "held\n"
        waits: list[str] = []

        def cancel(fraction: float, what: str) -> None:
            waits.append(what)
            raise Cancelled

        with pytest.raises(Cancelled):
            cache.get_or_compute(environment, [3.0], cancel)
        assert "waiting" in waits[0]
        holder.kill()
    assert cache.get_or_compute(environment, [3.0]).exponents == (3.0,)
    assert cache.notices == []  # it did not wait until it gave up


def test_the_folder_can_be_chosen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path / "here"))
    assert MapCache().folder == tmp_path / "here" / "lobe_maps"
    monkeypatch.delenv("BRDF_SUITE_CACHE")
    assert default_root().name == "brdf-suite"


def test_two_at_once_find_a_damaged_entry_and_rebuild_it_once(
    environment: Environment, count_work: list[str]
) -> None:
    """A waiting process must take what the other rebuilt, not remove it."""
    good = MapCache().get_or_compute(environment, [3.0])
    entry = MapCache().entries()[0].path
    entry.write_bytes(entry.read_bytes()[:-5])
    with ThreadPoolExecutor(4) as pool:
        answers = list(pool.map(lambda _: MapCache().get_or_compute(environment, [3.0]), range(4)))
    assert all(same(answer, good) for answer in answers)
    assert len(count_work) == 2


def test_a_holder_without_a_sign_of_life_is_not_waited_for(
    environment: Environment, caplog: pytest.LogCaptureFixture
) -> None:
    cache = MapCache(silence_s=0.5)
    cache.folder.mkdir(parents=True)
    lock = lock_path(cache.folder, cache_key(environment, [3.0]))
    with FileLock(lock), caplog.at_level(logging.WARNING):
        assert cache.get_or_compute(environment, [3.0]).exponents == (3.0,)
    assert "continuing without it" in cache.notices[0]
    assert len(cache.entries()) == 1


def test_a_holder_that_gives_signs_of_life_is_waited_for(
    environment: Environment, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The work of the first takes longer than the second's patience with silence, on a clock of the test's own."""
    now = [100.0]
    monkeypatch.setattr(cache_lock, "time", SimpleNamespace(monotonic=lambda: now[0]))
    monkeypatch.setattr(cache_lock, "POLL_SECONDS", 0.01)
    looked = threading.Semaphore(0)  # one for each time that the second looks and goes on waiting
    key = cache_key(environment, [3.0])
    folder = MapCache().folder
    steps = 0

    def slow() -> None:
        nonlocal steps
        with exclusive_entry(
            folder, key, timeout_s=600.0, silence_s=600.0, progress=None, notice=pytest.fail
        ) as turn:
            watched = turn.watched(None)
            for _ in range(8):
                now[0] += 2.0
                watched(0.1, "slow")
                started.set()
                for _ in range(2):  # the first look may have been on its way before the sign
                    assert looked.acquire(timeout=120.0)
                steps += 1

    started = threading.Event()
    with ThreadPoolExecutor(1) as pool:
        first = pool.submit(slow)
        assert started.wait(120.0)
        second = MapCache(silence_s=3.0)
        second.get_or_compute(environment, [3.0], lambda _fraction, _what: looked.release())
        assert steps == 8, "it did not wait"
        assert second.notices == []
        first.result()


def test_what_killed_programs_left_goes_with_the_next_entry(environment: Environment) -> None:
    cache = MapCache()
    cache.folder.mkdir(parents=True)
    mine, other, held = (
        cache.folder / f".{key}-x.part" for key in (cache_key(environment, [3.0]), "0" * 64, "1" * 64)
    )
    for left in (mine, other, held):
        left.write_bytes(b"half an entry")
    with FileLock(lock_path(cache.folder, "1" * 64)):
        cache.get_or_compute(environment, [3.0])
        assert cache.unfinished() == [held]  # its writer may be alive
    cache.get_or_compute(environment, [4.0])
    assert cache.unfinished() == []


def test_an_entry_larger_than_the_limit_is_not_kept_and_pushes_nothing_out(environment: Environment) -> None:
    MapCache().get_or_compute(environment, [3.0])
    before = MapCache().entries()
    cache = MapCache(limit_bytes=1000)
    cache.get_or_compute(environment, [4.0])
    assert "do not fit" in cache.notices[0]
    assert MapCache().entries() == before
    nothing = MapCache(limit_bytes=0)
    nothing.get_or_compute(environment, [5.0])
    assert nothing.notices == []
    assert MapCache().entries() == before


def test_the_limit_can_be_set_and_nonsense_is_reported(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setenv("BRDF_SUITE_CACHE_MB", "300")
    assert MapCache().limit_bytes == 300_000_000
    monkeypatch.setenv("BRDF_SUITE_CACHE_MB", "9" * 5000)
    assert MapCache().limit_bytes > 10**14
    monkeypatch.setenv("BRDF_SUITE_CACHE_MB", "-1 GB")
    with caplog.at_level(logging.WARNING):
        assert MapCache().limit_bytes == 2 * 1024**3
    assert "-1 GB" in caplog.text


def test_cancelled_work_leaves_nothing_and_frees_the_lock(environment: Environment) -> None:
    def cancel(fraction: float, what: str) -> None:
        if fraction > 0.0:
            raise Cancelled

    cache = MapCache()
    with pytest.raises(Cancelled):
        cache.get_or_compute(environment, [3.0], cancel)
    assert cache.entries() == []
    assert cache.unfinished() == []
    with FileLock(lock_path(cache.folder, cache_key(environment, [3.0])), timeout=0.0):
        pass


def test_many_at_once_in_a_cache_too_small_for_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """Entries come and go under everybody's hands: each still gets its own maps."""

    def made(environment: Environment, exponents: list[float], *_: object) -> LobeMaps:
        rng = np.random.default_rng(int(environment.name))
        faces = [FaceArray(rng.random((6, 32, 32, 3)).astype(np.float16), 1.0) for _ in range(4)]
        return LobeMaps((3.0,), (faces[0],), *faces[1:])

    monkeypatch.setattr(cache_module, "prefilter", made)
    environments = [Environment(str(i), np.full((4, 8, 3), i, np.float32)) for i in range(6)]
    size = 4 * 6 * 32 * 32 * 3 * 2
    caches = [MapCache(limit_bytes=int(2.5 * size)) for _ in range(120)]

    def ask(index: int) -> bool:
        wanted = environments[index * 7 % 6]
        if index % 10 == 0:
            caches[index].clear()
        if index % 10 == 5:
            assert caches[index].verify().passed
        return same(caches[index].get_or_compute(wanted, [3.0]), made(wanted, [3.0]))

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(ask, range(120)))
    assert [notice for cache in caches for notice in cache.notices] == []
    assert MapCache().verify().passed
    assert sum(entry.size for entry in MapCache().entries()) <= 2.5 * size + 4096
    assert MapCache().unfinished() == []
