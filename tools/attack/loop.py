"""The loop of all readers: forked workers with limits read damaged files, and one process counts what comes out.

A worker reads many inputs of one seed file, since a fork takes as long as a hundred of them. It is ended after a slice
of time, and replaced where it dies, hangs or grows. Limits are set by the kernel, so that they hold within libraries:
an alarm of processor time that kills, and a bound of the address space. (A Python handler of an alarm waits for a C
call to return; a bound of memory that OpenBLAS runs into makes it end the process with a line on standard error, which
earlier loops sent nowhere: they ended without a word.) Each input is reported before the next begins, and standard
error goes to a file that is quoted where a worker dies.
"""

from __future__ import annotations

import faulthandler
import json
import os
import re
import resource
import selectors
import signal
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

from brdf_suite.documents.atomic import encode, write_atomically
from tools.attack.bounds import HANG_S, OUTSIDE_HANG_S
from tools.attack.readers.reader import MEGABYTE, outcome
from tools.attack.seeds import Seed

SILENCE_S = 90.0
"""Of the clock: what waits for something that never comes takes no processor time."""
SLICE_S = 10.0
INPUTS_PER_WORKER = 2000
GROWTH = 512 * MEGABYTE
"""Of a worker over its life: libraries leak a strip for each damaged file."""
_SLACK = 512 * MEGABYTE
_KEPT_PER_FAULT = 3
_SAVE_S = 15.0


@dataclass
class Tally:
    """What came out of the inputs of one reader."""

    inputs: int = 0
    read: int = 0
    refused: int = 0
    died: int = 0
    faults: dict[str, int] = field(default_factory=dict)
    longest_s: float = 0.0
    largest_mb: float = 0.0
    cpu_s: float = 0.0
    done: dict[str, int] = field(default_factory=dict)

    def add_fault(self, text: str) -> int:
        """Count a fault; return how often it was met."""
        self.faults[text] = self.faults.get(text, 0) + 1
        return self.faults[text]


@dataclass
class _Worker:
    """A forked worker and what was heard of it."""

    pid: int
    pipe: int
    seed: Seed
    first: int
    folder: tempfile.TemporaryDirectory[str]
    heard: int = 0
    rest: bytes = b""
    when: float = field(default_factory=time.monotonic)


class Loop:
    """Damages the seeds of readers in turn, until each reader has its inputs or the time is over.

    Parameters
    ----------
    seeds, run
        What is damaged, and the number that all damage is drawn from.
    inputs
        Of each reader, divided among its seeds; a seed with a number of its own has all of those.
    results
        A file that is written every 15 s and from which another call goes on; None: nowhere.
    keep
        A folder for inputs that made a fault; None: nowhere.
    """

    def __init__(
        self,
        seeds: Sequence[Seed],
        run: int,
        inputs: int,
        *,
        results: Path | None = None,
        keep: Path | None = None,
        hang_s: float = HANG_S,
        report: Callable[[str], None] = lambda _text: None,
    ) -> None:
        self._seeds, self._run, self._results, self._keep = seeds, run, results, keep
        self._hang_s, self._report = hang_s, report
        self.tallies: dict[str, Tally] = {}
        if results is not None and results.exists():
            kept = json.loads(results.read_text())
            if kept["run"] != run:
                raise ValueError(f"{results} is of run {kept['run']}, not {run}")
            self.tallies = {name: Tally(**value) for name, value in kept["readers"].items()}
        count: dict[str, int] = {}
        for seed in seeds:
            self.tallies.setdefault(seed.reader.name, Tally()).done.setdefault(seed.key, 0)
            count[seed.reader.name] = count.get(seed.reader.name, 0) + 1
        self._wanted = {
            id(seed): -(-inputs // count[seed.reader.name]) if seed.inputs is None else seed.inputs
            for seed in seeds
        }
        self._selector = selectors.DefaultSelector()
        self._slice_s = SLICE_S
        self._saved = self._reported = time.monotonic()

    def run(self, jobs: int = 1, seconds: float = float("inf")) -> None:
        """Read until all inputs are read or the time is over; ``jobs`` workers at once."""
        until = time.monotonic() + seconds
        # Where the time is short, every seed comes at least once.
        self._slice_s = min(SLICE_S, 0.7 * jobs * seconds / len(self._seeds))
        waiting = list(self._seeds)
        try:
            while True:
                while waiting and len(self._selector.get_map()) < jobs and time.monotonic() < until:
                    # In turn: each reader comes before any comes twice.
                    waiting.sort(key=lambda seed: self._share(seed))
                    if self._share(waiting[0]) >= 1.0:
                        waiting.clear()
                    else:
                        self._start(waiting.pop(0), until)
                if not self._selector.get_map():
                    break
                for key, _ in self._selector.select(1.0):
                    seed = self._hear(key.data)
                    if seed is not None:
                        waiting.append(seed)
                for worker in [key.data for key in self._selector.get_map().values()]:
                    if time.monotonic() - worker.when > max(SILENCE_S, 4.0 * self._hang_s):
                        os.kill(worker.pid, signal.SIGKILL)
                self._tell_and_save()
        finally:
            for worker in [key.data for key in self._selector.get_map().values()]:
                os.kill(worker.pid, signal.SIGKILL)
                os.waitpid(worker.pid, 0)
                worker.folder.cleanup()
            self._save()

    def _share(self, seed: Seed) -> float:
        return self.tallies[seed.reader.name].done[seed.key] / self._wanted[id(seed)]

    def _start(self, seed: Seed, until: float) -> None:
        first = self.tallies[seed.reader.name].done[seed.key]
        last = min(self._wanted[id(seed)], first + INPUTS_PER_WORKER)
        shared = "/dev/shm" if Path("/dev/shm").is_dir() else None
        folder = tempfile.TemporaryDirectory(prefix="attack-", dir=shared, ignore_cleanup_errors=True)
        receive, send = os.pipe()
        ends = min(until, time.monotonic() + self._slice_s)
        pid = os.fork()
        if pid == 0:
            status = 70
            try:
                os.close(receive)
                _work(
                    seed,
                    self._run,
                    range(first, last),
                    Path(folder.name),
                    send,
                    ends,
                    self._hang_s,
                )
                status = 0
            except BaseException as error:  # noqa: BLE001 - the other side is the parent's
                os.write(2, f"{type(error).__name__}: {error}\n".encode())
            finally:
                os._exit(status)
        os.close(send)
        worker = _Worker(pid, receive, seed, first, folder)
        self._selector.register(receive, selectors.EVENT_READ, worker)

    def _hear(self, worker: _Worker) -> Seed | None:
        """Take up what a worker reports; return its seed where it has ended."""
        content = os.read(worker.pipe, 1 << 16)
        tally = self.tallies[worker.seed.reader.name]
        if content:
            worker.when = time.monotonic()
            *lines, worker.rest = (worker.rest + content).split(b"\n")
            for line in lines:
                self._count(worker, tally, line.decode())
            return None
        self._selector.unregister(worker.pipe)
        os.close(worker.pipe)
        _, status = os.waitpid(worker.pid, 0)
        if status != 0:
            self._ended(worker, tally, status)
        worker.folder.cleanup()
        return worker.seed

    def _count(self, worker: _Worker, tally: Tally, line: str) -> None:
        seconds, growth, result = line.split(" ", 2)
        tally.inputs += 1
        tally.cpu_s = round(tally.cpu_s + float(seconds), 4)
        tally.longest_s = max(tally.longest_s, float(seconds))
        tally.largest_mb = max(tally.largest_mb, float(growth))
        if result == "read":
            tally.read += 1
        elif result == "refused":
            tally.refused += 1
        else:
            self._fault(worker, tally, result)
        self._advance(worker, tally)

    def _ended(self, worker: _Worker, tally: Tally, status: int) -> None:
        """Count the input during which a worker died."""
        log = Path(worker.folder.name, "log")
        said = log.read_bytes()[-300:].decode("utf-8", "replace").strip() if log.exists() else ""
        if os.WIFSIGNALED(status):
            number = os.WTERMSIG(status)
            how = f"died ({signal.Signals(number).name})"
            if number in (signal.SIGPROF, signal.SIGKILL):
                how = (
                    f"over {self._hang_s:g} s of processor time"
                    if number == signal.SIGPROF
                    else "no sign of life"
                )
        else:
            how = f"ended with status {os.waitstatus_to_exitcode(status)}"
        tally.inputs += 1
        if worker.seed.reader.outside:
            tally.died += 1
        else:
            self._fault(worker, tally, f"{how}; {said}" if said else how)
        self._advance(worker, tally)

    def _advance(self, worker: _Worker, tally: Tally) -> None:
        """Count one more input of a worker as read, so that no other run reads it again."""
        worker.heard += 1
        tally.done[worker.seed.key] = worker.first + worker.heard

    def _fault(self, worker: _Worker, tally: Tally, text: str) -> None:
        general = re.sub(r"(?:/[\w.-]+)+/", "", re.sub(r"0x[0-9a-f]+|\d+", "#", text))
        number = worker.first + worker.heard
        times = tally.add_fault(general)
        if times == 1:
            self._report(f"{worker.seed.reader.name} {worker.seed.key} {number}: {text}")
        if self._keep is not None and times <= _KEPT_PER_FAULT:
            folder = self._keep / worker.seed.reader.name.replace(":", "-") / f"{worker.seed.name}-{number}"
            folder.mkdir(parents=True, exist_ok=True)
            worker.seed.write(folder, self._run, number)

    def _tell_and_save(self) -> None:
        now = time.monotonic()
        if now - self._saved > _SAVE_S:
            self._saved = now
            self._save()
        if now - self._reported > 60.0:
            self._reported = now
            least = min(self._share(seed) for seed in self._seeds)
            total = sum(tally.inputs for tally in self.tallies.values())
            self._report(f"{total:,} inputs; the reader that is furthest behind has {100.0 * least:.1f} %")

    def _save(self) -> None:
        if self._results is not None:
            readers = {name: asdict(tally) for name, tally in sorted(self.tallies.items())}
            write_atomically(self._results, encode({"run": self._run, "readers": readers}))


def _work(
    seed: Seed,
    run: int,
    numbers: range,
    folder: Path,
    pipe: int,
    until: float,
    hang_s: float,
) -> None:
    """Read damaged versions of a seed and report each: seconds, megabytes, and what came out."""
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    log = os.open(folder / "log", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    os.dup2(log, 1)
    os.dup2(log, 2)
    faulthandler.disable()  # of the parent, whose own standard error it holds
    scratch = folder / "files"
    scratch.mkdir()
    os.chdir(scratch)
    tempfile.tempdir = str(folder)  # what a killed library leaves goes with it
    sys.setrecursionlimit(1000)
    seed.restore(scratch)
    found = outcome(seed.reader, scratch / seed.name)  # imports and caches are not what is limited
    if found != "read" and seed.is_whole:
        raise RuntimeError(f"the undamaged {seed.name} is not read: {found}")
    warnings.simplefilter("error")
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    bound = seed.reader.memory + 3 * seed.size
    wide = 4 if seed.reader.outside else 1
    resource.setrlimit(
        resource.RLIMIT_AS, (_status("VmSize") + wide * bound + _SLACK, resource.RLIM_INFINITY)
    )
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    begin = _status("VmRSS")
    limit_s = min(hang_s, OUTSIDE_HANG_S) if seed.reader.outside else hang_s
    with seed.beside(scratch):
        for number in numbers:
            path = seed.write(scratch, run, number)
            _forget_peak()
            before = _status("VmRSS")
            signal.setitimer(signal.ITIMER_PROF, limit_s)
            start = time.process_time()
            result = seed.outcome(path)
            seconds = time.process_time() - start
            signal.setitimer(signal.ITIMER_PROF, 0.0)
            growth = _status("VmHWM") - before
            if growth > bound and result in ("read", "refused") and not seed.reader.outside:
                result = "over the memory bound"
            line = " ".join(f"{seconds:.4f} {growth / MEGABYTE:.1f} {result}".splitlines())
            os.write(pipe, line.encode("utf-8", "backslashreplace") + b"\n")
            if time.monotonic() > until or _status("VmRSS") - begin > GROWTH:
                break
            if os.fstat(log).st_size > MEGABYTE:
                os.truncate(log, 0)


def _status(name: str) -> int:
    """Return a figure of this process's memory in bytes."""
    with Path("/proc/self/status").open("rb") as file:
        for line in file:
            if line.startswith(name.encode()):
                return int(line.split()[1]) << 10
    raise RuntimeError(f"the system does not report {name}")


def _forget_peak() -> None:
    """Let the kernel begin a new largest resident size."""
    Path("/proc/self/clear_refs").write_text("5")
