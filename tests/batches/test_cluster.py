"""Batches on processes: a scheduler and workers as a cluster has them, which are killed on the way."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from time import monotonic, sleep
from typing import ClassVar

import cloudpickle
import pytest

import brdf_suite as bs
from brdf_suite.batches.items import BatchItem, list_paints
from brdf_suite.batches.journal import JOURNAL
from brdf_suite.batches.running import run_batch
from brdf_suite.batches.steps import Outcome, Work
from brdf_suite.batches.workers import local_workers, scheduler_workers
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress

PAINTS = 60
_PATIENCE_S = 300.0
_ENVIRONMENT = os.environ | {"PYTHONSAFEPATH": "1", "OPENBLAS_NUM_THREADS": "1"}


def wait_until(what: object) -> None:
    end = monotonic() + _PATIENCE_S
    while not what():  # type: ignore[operator]
        assert monotonic() < end, "waited in vain"
        sleep(0.05)


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return int(one.getsockname()[1])


class Cluster:
    """A scheduler and workers, each a process of its own."""

    def __init__(self, folder: Path) -> None:
        self.port = free_port()
        self.address = f"tcp://127.0.0.1:{self.port}"
        self._folder = folder
        self.workers: list[subprocess.Popen[bytes]] = []

    def start_scheduler(self) -> None:
        self.scheduler = self._start(
            "scheduler", "--host", "127.0.0.1", "--port", str(self.port), "--no-dashboard"
        )

    def add_worker(self) -> None:
        words = (
            "worker",
            self.address,
            "--nthreads",
            "1",
            "--no-dashboard",
            "--no-nanny",
            "--death-timeout",
            "60",
        )
        self.workers.append(self._start(*words))

    def _start(self, *words: str) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [sys.executable, "-P", "-m", "distributed.cli.dask_" + words[0], *words[1:]],
            cwd=self._folder,
            env=_ENVIRONMENT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def close(self) -> None:
        for one in (*self.workers, self.scheduler):
            one.kill()
            one.wait()


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    made = Cluster(tmp_path)
    made.start_scheduler()
    try:
        for _ in range(2):
            made.add_worker()
        yield made
    finally:
        made.close()


@pytest.fixture
def palette(tmp_path: Path) -> Path:
    paint = bs.load("blue", bs.Paint)
    path = tmp_path / "fleet.brdfpalette"
    bs.save(Palette("fleet", tuple(Entry(paint, str(number)) for number in range(PAINTS))), path)
    return path


def lines_of(folder: Path) -> list[dict[str, object]]:
    path = folder / JOURNAL
    return [json.loads(line) for line in path.read_bytes().splitlines()] if path.exists() else []


def start_batch(palette: Path, out: Path, address: str) -> subprocess.Popen[str]:
    words = (
        "batch",
        "measure",
        str(palette),
        "-o",
        str(out),
        "--scheduler",
        address,
        "--group",
        "1",
        "--json",
    )
    return subprocess.Popen(
        child_command("brdf_suite.cli.main", *words),
        env=_ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_a_batch_survives_the_kill_of_a_worker_and_then_of_the_scheduler(
    cluster: Cluster, palette: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    first = start_batch(palette, out, cluster.address)
    wait_until(lambda: len(lines_of(out)) >= 5)
    cluster.workers[0].send_signal(signal.SIGKILL)
    wait_until(lambda: len(lines_of(out)) >= 15)
    cluster.scheduler.send_signal(signal.SIGKILL)
    _, problem = first.communicate(timeout=_PATIENCE_S)
    assert first.returncode == 1
    assert "goes on where it was" in problem
    assert "Traceback" not in problem
    before = len(lines_of(out))
    assert 15 <= before < PAINTS

    cluster.close()
    cluster.start_scheduler()
    cluster.add_worker()
    second = start_batch(palette, out, cluster.address)
    printed, problem = second.communicate(timeout=_PATIENCE_S)
    assert second.returncode == 0, problem
    answer = json.loads(printed)
    assert (answer["items"], answer["done_before"], answer["done"]) == (PAINTS, before, PAINTS - before)
    keys = [line["key"] for line in lines_of(out)]
    assert len(keys) == len({*keys}) == PAINTS
    assert (out / "results.csv").read_text(encoding="utf-8").count("\n") == PAINTS + 1


def test_a_killed_command_goes_on(cluster: Cluster, palette: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = start_batch(palette, out, cluster.address)
    wait_until(lambda: len(lines_of(out)) >= 5)
    first.kill()
    first.communicate()
    second = start_batch(palette, out, cluster.address)
    printed, problem = second.communicate(timeout=_PATIENCE_S)
    assert second.returncode == 0, problem
    assert json.loads(printed)["done_before"] >= 5
    assert len({line["key"] for line in lines_of(out)}) == PAINTS


def test_a_worker_that_does_not_see_the_folder_says_so(cluster: Cluster, tmp_path: Path) -> None:
    from brdf_suite.batches.steps import Measure
    from brdf_suite.batches.worker import do_items
    from brdf_suite.release import __version__

    with scheduler_workers(cluster.address) as workers:
        asked = workers.executor.submit(do_items, Measure(), "", [], str(tmp_path / "nowhere"), __version__)
        with pytest.raises(SuiteError, match="does not see"):
            asked.result(_PATIENCE_S)
        older = workers.executor.submit(do_items, Measure(), "", [], str(tmp_path), "0.0.1")
        with pytest.raises(SuiteError, match=r"the batch is of 0\.0\.1"):
            older.result(_PATIENCE_S)


def test_a_step_that_a_worker_cannot_begin_ends_the_batch_with_its_reason(
    cluster: Cluster, tmp_path: Path
) -> None:
    @dataclass(frozen=True)
    class NoLight:
        name: ClassVar[str] = "no light"

        def prepare(self, _progress: Progress | None) -> None:
            """There is nothing to prepare."""

        def open(self) -> AbstractContextManager[Work]:
            raise FileError("/home/me/sky.hdr", "there is no such file")

    with pytest.raises(FileError, match=r"/home/me/sky\.hdr: there is no such file"):
        run_batch(
            NoLight(), list_paints(["blue", "red"]), tmp_path, lambda: scheduler_workers(cluster.address)
        )
    assert lines_of(tmp_path) == []


def test_no_scheduler_is_one_line() -> None:
    with (
        pytest.raises(SuiteError, match="No scheduler answers at nonsense"),
        scheduler_workers("nonsense://x"),
    ):
        pass


def test_memory_is_written_with_its_unit() -> None:
    with pytest.raises(SuiteError, match="no amount of memory"), local_workers(1, "much"):
        pass


@dataclass(frozen=True)
class Deadly:
    """One of its items ends the process."""

    name: ClassVar[str] = "deadly"

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    def open(self) -> AbstractContextManager[Work]:
        def work(item: BatchItem, _folder: Path) -> Outcome:
            if item.label == "red":
                os.kill(os.getpid(), signal.SIGKILL)
            return Outcome({"name": item.label})

        return nullcontext(work)


def test_an_item_that_kills_its_worker_is_reported_and_the_rest_done(tmp_path: Path) -> None:
    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    try:
        names = ["blue", "copper", "red", "fine_silver"]
        done = run_batch(Deadly(), list_paints(names), tmp_path, lambda: local_workers(1), group=4)
    finally:
        cloudpickle.unregister_pickle_by_value(sys.modules[__name__])
    ((source, problem),) = done.problems
    assert source == "red"
    assert "the process that worked on it ended" in problem


def test_planted_modules_are_not_imported_by_workers(tmp_path: Path) -> None:
    planted = tmp_path / "distributed.py"
    planted.write_text(f"open({str(tmp_path / 'ran')!r}, 'w').close()", encoding="utf-8")
    words = ("batch", "measure", "blue", "-o", "out", "--workers", "1")
    done = subprocess.run(
        child_command("brdf_suite.cli.main", *words),
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert not (tmp_path / "ran").exists()
    assert (tmp_path / "out" / "results.csv").is_file()
