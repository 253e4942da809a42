"""A slice of the standing attack with fixed seeds: damaged, changing and crossed files of every reader, kills and power
losses of every writer, wrong lines.

``python tools/attack/run.py`` goes on with other seeds; docs/development/reliability.md has the figures of a long run.
"""

from __future__ import annotations

import hashlib
import json
import mmap
import os
import signal
import time
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("resource", reason="memory limits are set through the Unix module resource")
if not Path("/proc/self/clear_refs").exists():
    pytest.skip("memory in use is read from /proc", allow_module_level=True)

from brdf_suite.documents.atomic import sync_folder, write_atomically
from brdf_suite.errors import FileError
from brdf_suite.regular_files import read_bytes
from tools.attack import kills, loop, report
from tools.attack.changing import SeedChangedAtCall, SeedChangedBeside
from tools.attack.command_lines import signals, wrong
from tools.attack.loop import Loop
from tools.attack.power import lose_power
from tools.attack.readers import READERS, chosen, coverage
from tools.attack.readers.reader import Reader, WrongValueError, text_files
from tools.attack.replay import replay
from tools.attack.seeds import CrossedSeed, Seed, SplicedSeed, contents_of, crossing_seeds, seeds_of
from tools.attack.writing import WRITERS
from tools.attack.writing import coverage as writing_coverage
from tools.attack.writing.writer import Writer

INPUTS = 40
"""Of each reader; a limit of time would depend on what else the machine does."""
CHANGES = 6
"""Of each reader."""
ONE_IN = 19
"""Files of other readers that are given to each."""
GROUPS = sorted({reader.name.partition(":")[0] for reader in READERS})
FOUND = Path(__file__).with_name("found")


def faults_of(run: Loop) -> list[str]:
    return [f"{name}: {fault}" for name, tally in run.tallies.items() for fault in tally.faults]


@pytest.mark.parametrize("group", GROUPS)
def test_damaged_files_are_read_or_refused(group: str, tmp_path: Path) -> None:
    seeds = list(seeds_of(chosen([f"{group}:"]), tmp_path))
    run = Loop(seeds, 7, INPUTS, keep=tmp_path / "kept")
    run.run()
    assert not faults_of(run)
    tallies = run.tallies.values()
    assert min(tally.inputs for tally in tallies) >= INPUTS
    assert any(tally.read for tally in tallies)  # some damage does no harm, so the readers were reached
    assert any(tally.refused for tally in tallies) or group in ("settings", "text")


@pytest.mark.parametrize("group", GROUPS)
def test_files_that_change_while_they_are_read_are_read_or_refused(group: str, tmp_path: Path) -> None:
    seeds = list(seeds_of(chosen([f"{group}:"]), tmp_path, SeedChangedAtCall))
    run = Loop(seeds, 7, CHANGES)
    run.run()
    assert not faults_of(run)
    tallies = run.tallies.values()
    assert min(tally.inputs for tally in tallies) >= CHANGES
    assert any(tally.refused for tally in tallies) or group in ("settings", "text")


@pytest.fixture(scope="module")
def contents(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[bytes]]:
    return contents_of(list(READERS), tmp_path_factory.mktemp("others"))


@pytest.mark.parametrize("group", GROUPS)
def test_files_of_other_formats_and_spliced_ones_are_read_or_refused(
    group: str, contents: dict[str, list[bytes]], tmp_path: Path
) -> None:
    seeds = list(crossing_seeds(chosen([f"{group}:"]), tmp_path, contents, ONE_IN))
    run = Loop(seeds, 7, CHANGES, keep=tmp_path / "kept")
    run.run()
    assert not faults_of(run)
    assert any(tally.refused for tally in run.tallies.values()) or group in ("settings", "text")


def test_every_reader_has_a_seed_that_reaches_it() -> None:
    assert coverage.missing() == []


def test_a_reader_without_a_seed_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    new = Reader("palette:new", lambda _path: None, lambda _folder: [])
    broken = Reader("palette:broken", Path.rmdir, text_files(a__txt="x"))
    monkeypatch.setattr(coverage, "READERS", (new, broken))
    monkeypatch.setattr(coverage, "_PLACES", ("brdf_suite/files/meshes",))
    found = coverage.missing()
    assert "palette:new has no seed; add one in tools/attack/readers." in found
    assert any(text.startswith("palette:broken: the undamaged a.txt is not read") for text in found)
    assert (
        "read_mesh in brdf_suite/files/meshes/reading.py is reached by no seed of tools/attack/readers."
        in found
    )


def test_every_function_that_writes_is_reached_by_a_writer() -> None:
    assert writing_coverage.missing() == []


def test_a_function_that_no_writer_reaches_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writing_coverage, "_PLACES", ("brdf_suite/files/meshes",))
    monkeypatch.setattr(writing_coverage, "WRITERS", ())
    monkeypatch.setattr(writing_coverage, "NOT_WRITERS", {"apps": "nothing"})
    found = writing_coverage.missing()
    assert found[0] == "apps of NOT_WRITERS names no function that writes."
    assert (
        "write_obj in brdf_suite/files/meshes/writing.py is reached by no writer of tools/attack/writing."
        in found
    )


REAL = {
    "measured:bird": "brdf/bird_example.json",
    "measured:cornell": "brdf/krylon_blue.brdf",
    "measured:alta": "brdf/retro-gray-tape.dat",
    "measured:rgl": "brdf/paper_white_rgb.bsdf",
    "environment:exr": "environments/warehouse.exr",
    "environment:hdr": "environments/kiara_1_dawn_1k.hdr",
    "mesh:glb": "meshes/CesiumMilkTruck.glb",
}


@pytest.mark.parametrize("name", REAL)
def test_damaged_files_of_others(name: str, shared_data: Path, tmp_path: Path) -> None:
    source = shared_data / REAL[name]
    content = source.read_bytes()
    if source.suffix in (".brdf", ".dat"):  # thousands of lines that are read one like the other
        content = b"".join(content.splitlines(keepends=True)[:400])
    (tmp_path / source.name).write_bytes(content)
    run = Loop([Seed(chosen([name])[0], tmp_path / source.name)], 7, 25)
    run.run()
    assert not faults_of(run)
    assert run.tallies[name].refused > 0


def crash(_path: Path) -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


def hang(_path: Path) -> None:
    while True:
        pass


def wait(_path: Path) -> None:
    time.sleep(3600.0)


def greedy(_path: Path) -> int:
    return len(b"x" * (64 << 20))


def flood(_path: Path) -> int:
    try:
        return len(bytearray(8 << 30))
    except MemoryError as error:
        raise FileError(_path, "there is not enough memory for what it holds") from error


def raises(_path: Path) -> None:
    raise KeyError("x")


def lies(_path: Path) -> None:
    raise WrongValueError("not finite")


def leaves(_path: Path) -> None:
    os.write(2, b"a library gives up")
    os._exit(3)


def damaged_only(read: Callable[[Path], object]) -> Callable[[Path], object]:
    return lambda path: None if path.read_bytes() == b"whole" else read(path)


@pytest.mark.parametrize(
    ("read", "words"),
    [
        (crash, "died (SIGSEGV)"),
        (hang, "of processor time"),
        (wait, "no sign of life"),
        (greedy, "over the memory bound"),
        (flood, "over the memory bound, refused"),
        (raises, "KeyError"),
        (lies, "not finite"),
        (leaves, "ended with status #; a library gives up"),
    ],
)
def test_what_goes_wrong_in_a_reader_is_seen(
    read: Callable[[Path], object], words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if read is wait:
        monkeypatch.setattr(loop, "SILENCE_S", 3.0)
    (tmp_path / "a.txt").write_bytes(b"whole")
    reader = Reader("x:y", damaged_only(read), lambda _folder: [], memory=16 << 20)
    run = Loop([Seed(reader, tmp_path / "a.txt")], 1, 2, hang_s=0.5, keep=tmp_path / "kept")
    run.run()
    tally = run.tallies["x:y"]
    assert tally.inputs == 2
    assert sum(tally.faults.values()) == 2
    assert all(words in fault for fault in tally.faults), tally.faults
    assert len(list((tmp_path / "kept" / "x-y").iterdir())) == 2
    assert not report.passed({"readers": {"x:y": vars(tally)}})


def mapped(path: Path) -> int:
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
        file.read(1)
        return sum(content[:])


def trusts_its_size(path: Path) -> None:
    size = path.stat().st_size
    with path.open("rb") as file:
        if len(file.read(size)) != size:
            raise IndexError("cut off")


def is_there(path: Path) -> int:
    if not path.exists():
        raise FileError(path, "is missing")
    return len(path.read_bytes())


@pytest.mark.parametrize(
    ("read", "words"),
    [(mapped, "died (SIGBUS)"), (trusts_its_size, "cut off"), (is_there, "FileNotFoundError")],
)
def test_careless_readers_of_changing_files_are_seen(
    read: Callable[[Path], object], words: str, tmp_path: Path
) -> None:
    (tmp_path / "a.txt").write_bytes(b"whole" * 1000)
    seed = SeedChangedAtCall(Reader("x:y", read, lambda _folder: []), tmp_path / "a.txt")
    run = Loop([seed], 1, 60)
    run.run()
    assert any(words in fault for fault in run.tallies["x:y"].faults), run.tallies
    assert not report.passed({"changing": {"x:y": vars(run.tallies["x:y"])}})


def test_another_process_changes_what_is_read(tmp_path: Path) -> None:
    def read(path: Path) -> None:
        begun = path.with_name("begun")
        if not begun.exists():  # the first reading of a worker is undisturbed
            begun.touch()
            return
        begin = time.monotonic()
        while len(read_bytes(path)) == 5000:
            if time.monotonic() - begin > 60.0:
                return
        raise KeyError("changed")

    (tmp_path / "a.txt").write_bytes(b"whole" * 1000)
    run = Loop([SeedChangedBeside(Reader("x:y", read, lambda _folder: []), tmp_path / "a.txt")], 1, 5)
    run.run()
    tally = run.tallies["x:y"]
    assert (tally.inputs, tally.read) == (5, 0)
    assert set(tally.faults) <= {"KeyError: 'changed'"}


def test_careless_readers_of_crossed_files_are_seen(tmp_path: Path) -> None:
    def read(path: Path) -> None:
        content = path.read_bytes()
        if content not in (b"a" * 40, b"b" * 40):
            raise KeyError("foreign" if content == b"foreign" else "spliced")

    (tmp_path / "a.txt").write_bytes(b"a" * 40)
    reader = Reader("x:y", read, lambda _folder: [])
    crossed = CrossedSeed(reader, tmp_path / "a.txt", [b"foreign"])
    spliced = SplicedSeed(reader, tmp_path / "a.txt", [b"b" * 40])
    run = Loop([crossed, spliced], 1, 40)
    run.run()
    tally = run.tallies["x:y"]
    assert tally.done == {crossed.key: 1, spliced.key: 20}
    assert tally.faults["KeyError: 'foreign'"] == 1
    assert tally.faults["KeyError: 'spliced'"] > 5


def test_both_of_two_files_that_refer_to_each_other_are_damaged(tmp_path: Path) -> None:
    digest = hashlib.sha256(b"0 1 2 3").hexdigest()
    (tmp_path / "a.txt").write_text(f"uses b.txt {digest}")
    (tmp_path / "b.txt").write_bytes(b"0 1 2 3")
    seed = Seed(Reader("x:y", Path.read_bytes, lambda _folder: []), tmp_path / "a.txt")
    damaged = [seed.damaged(1, number) for number in range(200)]
    assert {tuple(sorted(files)) for files in damaged} == {("a.txt",), ("b.txt",), ("a.txt", "b.txt")}
    sums = [
        (files["a.txt"], hashlib.sha256(files["b.txt"]).hexdigest()) for files in damaged if len(files) == 2
    ]
    assert any(main == f"uses b.txt {made}".encode() for main, made in sums)
    assert any(files["b.txt"] == seed.content for files in damaged if "b.txt" in files)
    assert damaged[7] == seed.damaged(1, 7)


def test_a_run_goes_on_where_it_was_stopped(tmp_path: Path) -> None:
    seeds = list(seeds_of(chosen(["palette:gpl"]), tmp_path / "seeds"))
    results = tmp_path / "results.json"
    Loop(seeds, 1, 30, results=results).run()
    half = json.loads(results.read_text())["readers"]["palette:gpl"]
    Loop(seeds, 1, 60, results=results).run()
    whole = json.loads(results.read_text())["readers"]["palette:gpl"]
    assert (half["inputs"], whole["inputs"]) == (30, 60)
    once = Loop(seeds, 1, 60)
    once.run()
    assert (once.tallies["palette:gpl"].read, once.tallies["palette:gpl"].refused) == (
        whole["read"],
        whole["refused"],
    )
    with pytest.raises(ValueError, match="is of run 1, not 2"):
        Loop(seeds, 2, 60, results=results)


def test_what_was_found_stays_mended() -> None:
    assert len(list(FOUND.rglob("*.*"))) > 5
    assert replay(FOUND) == []


@pytest.mark.parametrize("writer", [one for one in WRITERS if one.in_slices], ids=lambda writer: writer.name)
def test_a_writer_that_is_killed_damages_and_leaves_nothing(writer: Writer, tmp_path: Path) -> None:
    found = kills.Trial(writer, tmp_path, 1).run(10)
    assert (found.damaged, found.lost, found.leftovers, found.full_disk_faults) == (0, 0, 0, 0), (
        found.examples
    )
    assert found.kills >= 10
    assert found.in_a_write > 3


DOCUMENTS = [one for one in WRITERS if one.in_slices and one.is_forced and not one.optional]


@pytest.mark.parametrize("writer", DOCUMENTS, ids=lambda writer: writer.name)
def test_a_document_that_was_saved_survives_a_power_loss(writer: Writer, tmp_path: Path) -> None:
    found = lose_power(writer, tmp_path)
    assert found.faults == []
    assert found.losses >= 2


def forced(path: Path, content: bytes) -> None:
    with path.open("wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("", ""),
        ("content", "at os.rename of draft to a"),
        ("early", "after version 1 was reported"),
        ("folder", "after version 1 was reported"),
        ("inner", "after version 1 was reported"),
        ("removed", "at os.remove of a"),
    ],
)
def test_writers_that_a_power_loss_damages_are_seen(fault: str, words: str, tmp_path: Path) -> None:
    def write(folder: Path, number: int) -> None:
        home, content = folder / "inner", f"{number} ".encode() * 2
        home.mkdir(exist_ok=True)
        draft = home / "draft"
        if fault == "content":
            draft.write_bytes(content)
        else:
            forced(draft, content)
        if fault == "early":
            draft.write_bytes(content + content)
        if fault == "removed":
            (home / "a").unlink(missing_ok=True)
            sync_folder(home)
        draft.replace(home / "a")
        for synced, name in ((home, "folder"), (folder, "inner")):
            if fault != name:
                sync_folder(synced)
        if fault == "content":
            with (home / "a").open("rb+") as file:
                os.fsync(file.fileno())

    def read(folder: Path) -> int:
        words = (folder / "inner" / "a").read_text().split()
        if fault == "early" and len(words) != 4:
            raise ValueError("cut off")
        (version,) = set(words)
        return int(version)

    found = lose_power(Writer("x", write, read), tmp_path)
    assert found.losses >= 3
    assert [text for text in found.faults if text.startswith(words)] == found.faults[:1]
    assert bool(found.faults) is bool(fault)
    assert report.passed({"power": {"x": vars(found)}}) is not bool(fault)


@pytest.mark.parametrize("fault", ["damaged", "lost", "leftovers", "full_disk_faults"])
def test_careless_writers_are_seen(fault: str, tmp_path: Path) -> None:
    def write(folder: Path, number: int) -> None:
        content = f"{number} ".encode() * 20_000
        if fault == "damaged":
            (folder / "a").write_bytes(content)
        elif fault == "lost":
            write_atomically(folder / "a", f"{number - number % 5} ".encode() * 2)
        elif fault == "leftovers":
            draft = folder / f"draft {time.time_ns():016x}"
            draft.write_bytes(content)
            draft.replace(folder / "a")
        else:
            try:
                write_atomically(folder / "a", content)
            except FileError as error:
                raise KeyError("a") from error

    def read(folder: Path) -> int:
        (version,) = set((folder / "a").read_text().split())
        return int(version)

    found = kills.Trial(Writer("x", write, read), tmp_path, 1).run(12)
    assert getattr(found, fault) > 0
    assert not report.passed({"kills": {"x": vars(found)}})


def test_wrong_command_lines_give_no_traceback() -> None:
    said: list[str] = []
    found = wrong(24, 11, said.append)
    assert (found.lines, found.faults) == (24, {}), said


def test_signals_and_closed_pipes_during_the_start_give_no_traceback() -> None:
    said: list[str] = []
    found = signals(4, 5, said.append)
    assert (found.lines, found.faults) == (4, {}), said


READER = {"inputs": 19_999, "faults": {}, "longest_s": 0.0, "died": 0}
KILLED = {"kills": 999, "in_a_write": 9, "damaged": 0, "lost": 0, "leftovers": 0, "full_disks": 6}


@pytest.mark.parametrize(
    ("part", "short", "enough"),
    [
        (
            "readers",
            {str(n): READER for n in range(60)},
            {str(n): {**READER, "inputs": 20_000} for n in range(60)},
        ),
        ("readers", {"a": {**READER, "inputs": 999_999}}, {"a": {**READER, "inputs": 1_000_000}}),
        (
            "kills",
            {"a": {**KILLED, "full_disk_faults": 0}},
            {"a": {**KILLED, "full_disk_faults": 0, "kills": 1000}},
        ),
        ("lines", {"lines": 239, "faults": {}}, {"lines": 240, "faults": {}}),
    ],
)
def test_too_few_pass_in_a_slice_and_not_in_the_long_run(
    part: str, short: dict[str, object], enough: dict[str, object]
) -> None:
    signals = {"signals": {"lines": 60, "faults": {}}} if part == "lines" else {}
    assert report.passed({part: short, **signals})
    assert not report.passed({part: short, **signals, "whole": True})
    assert report.passed({part: enough, **signals, "whole": True})


def test_the_table_is_written_between_the_markers(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("before\n<!-- attack: begin -->\nold\n<!-- attack: end -->\nafter\n")
    lines = {"lines": 3, "faults": {"x": "y"}}
    report.write(page, {"lines": lines})
    text = page.read_text()
    assert "| wrong command lines: tracebacks | 1 | 0 |" in text
    assert "old" not in text
    assert text.startswith("before\n")
    assert text.endswith("after\n")
    page.write_text("no markers")
    with pytest.raises(ValueError, match="has no markers"):
        report.write(page, {"lines": lines})
