"""A slice of the standing attack with fixed seeds: damaged files of every reader, kills of every writer, wrong lines.

``python tools/attack/run.py`` goes on with other seeds; docs/development/reliability.md has the figures of a long run.
"""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("resource", reason="memory limits are set through the Unix module resource")
if not Path("/proc/self/clear_refs").exists():
    pytest.skip("memory in use is read from /proc", allow_module_level=True)

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError
from tools.attack import kills, loop, report
from tools.attack.command_lines import signals, wrong
from tools.attack.loop import Loop, Seed, seeds_of
from tools.attack.readers import READERS, chosen, coverage
from tools.attack.readers.reader import Reader, WrongValueError, text_files
from tools.attack.replay import replay
from tools.attack.writers import WRITERS, Writer

INPUTS = 40
"""Of each reader; a limit of time would depend on what else the machine does."""
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


@pytest.mark.parametrize("writer", WRITERS, ids=lambda writer: writer.name)
def test_a_writer_that_is_killed_damages_and_leaves_nothing(writer: Writer, tmp_path: Path) -> None:
    found = kills.Trial(writer, tmp_path, 1).run(10)
    assert (found.damaged, found.lost, found.leftovers, found.full_disk_faults) == (0, 0, 0, 0), (
        found.examples
    )
    assert found.kills >= 10
    assert found.in_a_write > 3


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
