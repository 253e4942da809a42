"""``brdf-suite basis`` as a process: killed it goes on, interrupted it keeps what it has, refused it says why."""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.cli.tools import basis

ORDER = ("--lobes", "2", "--starts", "2", "--workers", "2")
#: The command, which stops when the first count is kept and its workers are at the second: a signal meets it there.
HELD = """
import sys, time
from brdf_suite.cli.main import main
from brdf_suite.fitting.basis_search import document, search

real_save, real_run, kept = document.save_state, search.Workers.run, 0

def save(state, settings, results):
    global kept
    real_save(state, settings, results)
    kept = len(results)

def run(self, starts, report):
    def held(done):
        report(done)
        if kept == 1:
            print("at the second", flush=True)
            time.sleep(600)
    return real_run(self, starts, held)

document.save_state, search.Workers.run = save, run
sys.exit(main(sys.argv[1:]))
"""


def start(folder: Path, database: Path, *more: str, held: bool = False) -> subprocess.Popen[str]:
    program = ["-c", HELD] if held else ["-m", "brdf_suite"]
    command = [sys.executable, *program, "basis", "--database", str(database), *ORDER, *more]
    return subprocess.Popen(
        command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )


Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(few_paints: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run the command in this process, in a folder: a new one imports for a second, and so do its workers."""

    def run(folder: Path, *more: str) -> tuple[int, str, str]:
        monkeypatch.chdir(folder)
        try:
            status = main(["basis", "--database", str(few_paints), *ORDER, *more])
        except SystemExit as end:  # for wrong arguments
            status = int(str(end.code))
        return status, *capsys.readouterr()

    return run


def kept(folder: Path) -> int:
    state = folder / "basis.json.part"
    return len(json.loads(state.read_text())["results"]) if state.exists() else 0


def members(group: int) -> list[int]:
    """The living processes of a process group."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue  # it ended meanwhile
        if int(fields[2]) == group and fields[0] != "Z":
            found.append(int(entry.name))
    return found


def results(folder: Path) -> list[dict[str, object]]:
    rows: list[dict[str, object]] = json.loads((folder / "basis.json").read_text())["results"]
    for row in rows:
        del row["seconds"]
    return rows


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="the process table is read from /proc")
def test_killed_and_started_again_it_gives_what_it_would_have_given(
    tmp_path: Path, few_paints: Path, run: Run
) -> None:
    undisturbed, killed = tmp_path / "undisturbed", tmp_path / "killed"
    undisturbed.mkdir()
    killed.mkdir()
    status, out, err = run(undisturbed, "--workers", "1")  # the answer is the same whatever their number
    assert status == 0, err
    assert "2 counts" in out
    assert not (undisturbed / "basis.json.part").exists()

    process = start(killed, few_paints, held=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "at the second\n"
    os.kill(process.pid, signal.SIGKILL)
    process.communicate()
    deadline = time.monotonic() + 200.0
    while members(process.pid) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert members(process.pid) == [], "its workers leave with it"
    assert kept(killed) == 1
    assert not (killed / "basis.json").exists()

    status, out, err = run(killed, "--json")
    assert status == 0, err
    answer = json.loads(out)
    assert answer == json.loads((killed / "basis.json").read_text())
    assert answer["provenance"]["command"] == (
        f"brdf-suite basis --lobes 2 --starts 2 --workers 2 --database {few_paints}"
    )
    assert answer["provenance"]["counts_of_an_interrupted_run"] == 1
    assert results(killed) == results(undisturbed)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ((), ""),
        (("--database", "my paints"), " --database 'my paints'"),
        (("-o", "found/basis.json", "--default", "2"), " -o found/basis.json --default 2"),
    ],
)
def test_the_command_that_is_kept_makes_the_answer_again(more: tuple[str, ...], words: str) -> None:
    parser = argparse.ArgumentParser()
    basis.add(parser)
    options = parser.parse_args(more)
    assert basis.command_line(options, 3) == f"brdf-suite basis --lobes 11 --starts 4 --workers 3{words}"


def test_interrupted_it_keeps_what_is_done_and_says_so(tmp_path: Path, few_paints: Path, run: Run) -> None:
    process = start(tmp_path, few_paints, "--lobes", "3", held=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "at the second\n"
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the workers too
    out, err = process.communicate(timeout=280)
    assert process.returncode == 130
    assert out == ""
    assert kept(tmp_path) == 1
    assert "1 of 3 counts are kept in basis.json.part" in err
    assert err.splitlines()[-1] == "brdf-suite: cancelled"
    assert "Traceback" not in err
    # Another order does not go on from it without being asked to.
    status, _out, err = run(tmp_path, "--starts", "3")
    assert status == 1
    assert "other paints or other starts" in err
    assert "--fresh" in err


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (("--lobes", "13"), "'13' is not a whole number from 1 to 12"),
        (("--starts", "1"), "'1' is not a whole number from 2"),
        (("--default", "3"), "--default 3 is more than the 2 lobes"),
        (("--database", "nowhere"), "there is no paint"),
        (("-o", "missing/basis.json"), "missing"),
    ],
)
def test_a_bad_order_is_refused_in_words(tmp_path: Path, run: Run, more: tuple[str, ...], words: str) -> None:
    status, _out, err = run(tmp_path, *more)
    assert status in (1, 2)
    assert words in err
    assert "Traceback" not in err
    assert kept(tmp_path) == 0


def test_a_refused_search_leaves_nothing(run: Run, tmp_path: Path) -> None:
    code, _out, err = run(tmp_path, "--lobes", "12")
    assert (code, list(tmp_path.iterdir())) == (1, []), err
    assert "holds" in err
