"""A scheduler and workers as a cluster has them, each a process, and batches on them that are killed on the way."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import monotonic, sleep
from typing import Any

import brdf_suite as bs
from brdf_suite.batches.items import JOURNAL
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.processes import child_command

PATIENCE_S = 300.0
_ENVIRONMENT = os.environ | {"PYTHONSAFEPATH": "1", "OPENBLAS_NUM_THREADS": "1"}


def wait_until(what: Callable[[], bool]) -> None:
    """Wait until something is so; :class:`TimeoutError` after five minutes."""
    end = monotonic() + PATIENCE_S
    while not what():
        if monotonic() > end:
            raise TimeoutError("waited in vain")
        sleep(0.05)


class Cluster:
    """A scheduler and workers, each a process of its own."""

    def __init__(self, folder: Path) -> None:
        with socket.socket() as one:
            one.bind(("127.0.0.1", 0))
            self.port = int(one.getsockname()[1])
        self.address = f"tcp://127.0.0.1:{self.port}"
        self._folder = folder
        self.workers: list[subprocess.Popen[bytes]] = []
        self.start_scheduler()

    def start_scheduler(self) -> None:
        """Start the scheduler, at the same address each time."""
        self.scheduler = self._start(
            "scheduler", "--host", "127.0.0.1", "--port", str(self.port), "--no-dashboard"
        )

    def add_worker(self) -> None:
        """Start one more worker."""
        alone = ("--nthreads", "1", "--no-dashboard", "--no-nanny", "--death-timeout", "60")
        self.workers.append(self._start("worker", self.address, *alone))

    def _start(self, *words: str) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [sys.executable, "-P", "-m", "distributed.cli.dask_" + words[0], *words[1:]],
            cwd=self._folder,
            env=_ENVIRONMENT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def close(self) -> None:
        """Kill all of them."""
        for one in (*self.workers, self.scheduler):
            one.kill()
            one.wait()


@contextmanager
def cluster_of_two(folder: Path) -> Iterator[Cluster]:
    """Start a scheduler and two workers, and kill them at the end."""
    made = Cluster(folder)
    try:
        made.add_worker()
        made.add_worker()
        yield made
    finally:
        made.close()


def make_palette(path: Path, paints: int) -> Path:
    """Write a palette of so many blue paints; return its path."""
    paint = bs.load("blue", bs.Paint)
    bs.save(Palette("fleet", tuple(Entry(paint, str(number)) for number in range(paints))), path)
    return path


def lines_of(folder: Path) -> list[dict[str, Any]]:
    """Return what the journal of a batch has: a line for each finished item."""
    path = folder / JOURNAL
    return [json.loads(line) for line in path.read_bytes().splitlines()] if path.exists() else []


def start_batch(palette: Path, out: Path, address: str) -> subprocess.Popen[str]:
    """Start the command that measures a palette on a cluster, an item at a time."""
    words = ("-o", str(out), "--scheduler", address, "--group", "1", "--json")
    return subprocess.Popen(
        child_command("brdf_suite", "batch", "measure", str(palette), *words),
        env=_ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def kill_worker_and_scheduler(cluster: Cluster, palette: Path, out: Path) -> tuple[int, str]:
    """Kill a worker and then the scheduler of a running batch; return its status and what it said."""
    running = start_batch(palette, out, cluster.address)
    wait_until(lambda: len(lines_of(out)) >= 5)
    cluster.workers[0].send_signal(signal.SIGKILL)
    wait_until(lambda: len(lines_of(out)) >= 15)
    cluster.scheduler.send_signal(signal.SIGKILL)
    _, problem = running.communicate(timeout=PATIENCE_S)
    return running.returncode, problem


def run_again(cluster: Cluster, palette: Path, out: Path) -> dict[str, Any]:
    """Start the scheduler, a worker and the same batch again; return the command's answer."""
    cluster.close()
    cluster.start_scheduler()
    cluster.add_worker()
    return finish(start_batch(palette, out, cluster.address))


def finish(running: subprocess.Popen[str]) -> dict[str, Any]:
    """Wait for a batch; return its answer, or raise :class:`RuntimeError` with what it said."""
    printed, problem = running.communicate(timeout=PATIENCE_S)
    if running.returncode:
        raise RuntimeError(problem)
    answer: dict[str, Any] = json.loads(printed)
    return answer
