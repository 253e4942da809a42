"""Kept pictures: whatever happens to the file, a program gets the right picture or none."""

from __future__ import annotations

import contextlib
import os
import signal
import sqlite3
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.palettes.swatches.store import SwatchStore

RNG = np.random.default_rng(5)
PICTURES = {f"{index:064d}": RNG.integers(0, 256, (12, 10, 3)).astype(np.uint8) for index in range(8)}
KEYS = list(PICTURES)


def same(found: dict[str, np.ndarray], keys: list[str] = KEYS) -> bool:
    return set(found) == set(keys) and all((found[key] == PICTURES[key]).all() for key in keys)


@pytest.fixture
def store(tmp_path: Path) -> SwatchStore:
    store = SwatchStore(tmp_path)
    store.put(PICTURES)
    return store


def test_pictures_come_back_and_stay(store: SwatchStore, tmp_path: Path) -> None:
    assert same(store.get([*KEYS, "0" * 63 + "x"]))
    store.close()
    assert same(store.get(KEYS))
    other = SwatchStore(tmp_path)
    assert same(other.get(KEYS))
    assert other.size()[0] == len(KEYS)
    assert other.clear() == len(KEYS)
    assert store.get(KEYS) == {}
    assert store.notices == []


def test_pictures_take_a_quarter_of_the_limit_of_the_cache(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert SwatchStore(tmp_path).limit_bytes == 512 * 1024**2
    monkeypatch.setenv("BRDF_SUITE_CACHE_MB", "400")
    assert SwatchStore(tmp_path).limit_bytes == 100_000_000


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="open files are read from /proc")
def test_the_file_is_closed_with_its_store(tmp_path: Path) -> None:
    store = SwatchStore(tmp_path)
    store.put(PICTURES)
    path = store.path
    assert path in open_files()
    del store
    assert path not in open_files()


def open_files() -> list[Path]:
    """Return what this process has open."""
    found = []
    for entry in Path("/proc/self/fd").iterdir():
        with contextlib.suppress(OSError):  # the listing's own
            found.append(entry.readlink())
    return found


def test_the_default_place_is_the_suites_cache(own_cache: None) -> None:
    store = SwatchStore()
    store.put({KEYS[0]: PICTURES[KEYS[0]]})
    assert store.path.parent == Path(os.environ["BRDF_SUITE_CACHE"]) / "swatches"
    assert store.path.is_file()


def test_a_damaged_picture_is_as_good_as_none(store: SwatchStore) -> None:
    store.close()
    with sqlite3.connect(store.path) as file:
        (blob,) = file.execute("SELECT pixels FROM pictures WHERE key = ?", (KEYS[2],)).fetchone()
        spoilt = bytearray(blob)
        spoilt[len(spoilt) // 2] ^= 1
        file.execute("UPDATE pictures SET pixels = ? WHERE key = ?", (bytes(spoilt), KEYS[2]))
        file.execute("UPDATE pictures SET height = 70000 WHERE key = ?", (KEYS[3],))
    file.close()
    assert store.verify() == (len(KEYS) - 2, 2)
    rest = [key for key in KEYS if key not in KEYS[2:4]]
    assert same(store.get(KEYS), rest)
    assert store.verify() == (len(rest), 0)
    store.put(PICTURES)
    assert same(store.get(KEYS))


@pytest.mark.parametrize("damage", ["garbage", "truncated", "other table", "empty"])
def test_a_damaged_file_is_made_anew_and_reported(store: SwatchStore, damage: str) -> None:
    store.close()
    if damage == "garbage":
        store.path.write_bytes(b"not a database at all" * 500)
    elif damage == "truncated":
        data = store.path.read_bytes()
        store.path.write_bytes(data[: len(data) // 2 + 7])
    elif damage == "empty":
        store.path.write_bytes(b"")
    else:
        with sqlite3.connect(store.path) as file:
            file.execute("DROP TABLE pictures")
            file.execute("CREATE TABLE pictures (used, bytes, key)")
        file.close()
    found = store.get(KEYS)
    # Nothing wrong is ever given.
    assert all((found[key] == PICTURES[key]).all() for key in found)
    store.put(PICTURES)
    assert same(store.get(KEYS))
    assert (damage == "empty") == (store.notices == [])


def test_a_picture_that_was_moved_to_another_key_is_not_given(store: SwatchStore) -> None:
    with sqlite3.connect(store.path) as file:
        file.execute("DELETE FROM pictures WHERE key = ?", (KEYS[1],))
        file.execute("UPDATE pictures SET key = ? WHERE key = ?", (KEYS[1], KEYS[0]))
        file.execute(
            "UPDATE pictures SET height = width, width = height, bytes = 1 WHERE key = ?", (KEYS[2],)
        )
    file.close()
    assert set(store.get(KEYS)) == set(KEYS[3:])
    assert store.verify() == (len(KEYS) - 3, 0), "what is damaged goes when it is read"


def test_the_pictures_unused_for_longest_go(tmp_path: Path) -> None:
    one = {KEYS[0]: PICTURES[KEYS[0]]}
    store = SwatchStore(tmp_path)
    store.put(one)
    size = store.size()[1]
    store = SwatchStore(tmp_path, limit_bytes=int(4.5 * size))
    store.put({key: PICTURES[key] for key in KEYS[1:4]})
    with sqlite3.connect(store.path) as file:
        for age, key in enumerate(KEYS[:4]):
            file.execute("UPDATE pictures SET used = used - ? WHERE key = ?", (4000.0 + age, key))
    file.close()
    assert same(store.get([KEYS[3]]), [KEYS[3]])
    store.put({KEYS[4]: PICTURES[KEYS[4]]})
    kept = store.get(KEYS)
    assert store.size()[1] <= 4.5 * size
    assert {KEYS[3], KEYS[4]} <= set(kept)
    assert KEYS[2] not in kept
    nothing = SwatchStore(tmp_path / "none", limit_bytes=0)
    nothing.put(PICTURES)
    assert nothing.get(KEYS) == {}


def test_a_folder_that_cannot_be_used_is_reported_once(tmp_path: Path) -> None:
    (tmp_path / "swatches").write_text("a file stands in the way")
    store = SwatchStore(tmp_path)
    store.put(PICTURES)
    assert store.get(KEYS) == {}
    assert store.size() == (0, 0)
    assert len(store.notices) == 1
    assert "BRDF_SUITE_CACHE" in store.notices[0]


def test_a_full_disk_costs_the_pictures_and_no_more(store: SwatchStore) -> None:
    store.close()
    store._open().execute("PRAGMA max_page_count = 1")
    big = RNG.integers(0, 256, (200, 200, 3)).astype(np.uint8)
    store.put({"f" * 64: big})
    assert len(store.notices) == 1
    assert same(SwatchStore(store.folder.parent).get(KEYS))


def test_an_error_that_is_no_damage_leaves_the_file_to_the_others(store: SwatchStore) -> None:
    other = SwatchStore(store.folder.parent)
    assert same(other.get(KEYS))
    # SQLite stops the work as it would for an error of the disk.
    store._open().set_progress_handler(lambda: 1, 1)
    assert store.get(KEYS) == {}
    (notice,) = store.notices
    assert "interrupted" in notice
    assert "damaged" not in notice
    extra = {"e" * 64: PICTURES[KEYS[0]]}
    other.put(extra)
    assert same(SwatchStore(store.folder.parent).get([*KEYS]))
    assert set(SwatchStore(store.folder.parent).get(extra)) == set(extra)


_WRITER = """
import sys
import numpy as np
from brdf_suite.palettes.swatches.store import SwatchStore
store = SwatchStore(sys.argv[1])
print("ready", flush=True)
sys.stdin.readline()
for index in range(int(sys.argv[2]), int(sys.argv[2]) + 40):
    store.put({f"{index:064d}": np.full((9, 9, 3), index % 256, np.uint8)})
print("done", flush=True)
sys.stdin.readline()
"""


_MAKER = """
import sys
import numpy as np
from brdf_suite.palettes.swatches.store import SwatchStore
key = f"{int(sys.argv[1]):064d}"
for line in sys.stdin:
    store = SwatchStore(line.strip())
    store.put({key: np.zeros((9, 9, 3), np.uint8)})
    print(store.notices, flush=True)
"""


def test_programs_that_make_the_file_at_once_wait_for_each_other(tmp_path: Path) -> None:
    makers = [
        subprocess.Popen(
            [sys.executable, "-c", _MAKER, str(index)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for index in range(4)
    ]
    folders = [tmp_path / f"cache {index}" for index in range(30)]
    for folder in folders:
        for maker in makers:
            assert maker.stdin is not None
            maker.stdin.write(f"{folder}\n")
            maker.stdin.flush()
        assert [maker.stdout and maker.stdout.readline() for maker in makers] == ["[]\n"] * len(makers)
        assert len(SwatchStore(folder).get(f"{index:064d}" for index in range(len(makers)))) == len(makers)
    for maker in makers:
        maker.communicate()


def test_programs_and_threads_write_at_once(tmp_path: Path) -> None:
    writers = [
        subprocess.Popen(
            [sys.executable, "-c", _WRITER, str(tmp_path), str(start)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for start in (100, 200)
    ]
    store = SwatchStore(tmp_path)
    for writer in writers:
        assert writer.stdout is not None
        assert writer.stdin is not None
        assert writer.stdout.readline() == "ready\n"
        writer.stdin.write("\n")
        writer.stdin.flush()
    with ThreadPoolExecutor(2) as threads:
        list(threads.map(lambda key: store.put({key: PICTURES[key]}), KEYS))
    for writer in writers:
        writer.communicate("\n")
        assert writer.returncode == 0
    wanted = [f"{index:064d}" for start in (100, 200) for index in range(start, start + 40)]
    found = store.get([*wanted, *KEYS])
    assert len(found) == len(wanted) + len(KEYS)
    assert all((found[key] == int(key) % 256).all() for key in wanted)


_KILLED = """
import sys
import numpy as np
from brdf_suite.palettes.swatches import store as swatch_store
store = swatch_store.SwatchStore(sys.argv[1])
class Stop(swatch_store.SwatchStore):
    def _trim(self, connection):
        # In the middle of a transaction: rows are written, and nothing is agreed yet.
        print("writing", flush=True)
        sys.stdin.readline()
Stop(sys.argv[1]).put({"e" * 64: np.zeros((300, 300, 3), np.uint8)})
"""


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="another system kills otherwise")
def test_a_writer_that_is_killed_leaves_what_was_there(store: SwatchStore, tmp_path: Path) -> None:
    store.close()
    writer = subprocess.Popen(
        [sys.executable, "-c", _KILLED, str(tmp_path)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert writer.stdout is not None
    assert writer.stdout.readline() == "writing\n"
    writer.kill()
    writer.communicate()
    assert same(store.get([*KEYS, "e" * 64]))
    store.put(PICTURES)
    assert store.notices == []


def test_texts_of_the_file_that_are_no_text_are_damage(store: SwatchStore) -> None:
    store.close()
    for name in ("", "-wal"):
        path = store.path.with_name(store.path.name + name)
        if path.exists():
            path.write_bytes(path.read_bytes().replace(b"by_use ON pictures", b"by_use ON p\xffctures"))
    assert store.get(KEYS) == {}
    assert any("are damaged" in text for text in store.notices)
    store.put(PICTURES)
    assert same(store.get(KEYS))
