"""Writers killed at any moment: no document damaged or lost, and nothing left over after the next start.

Each writer writes one version after another to the same place, in a forked child that is killed in three ways: at a
random moment (SIGKILL by the clock), at each step that opens, renames or removes a file (:func:`sys.addaudithook`), and
within a file, after so many bytes (the kernel's limit of a file's size, whose signal kills). The last two leave nothing
to luck. After each kill what is there must be a whole version, not older than the last that was reported as written.
Then the program starts again: it writes once more, and no file may be there that was not there before. Caches, which
several programs use at once, have another writer beside the one that is killed.

The same limit of a file's size, with its signal ignored, stands for a full disk: the writer must report a
:class:`SuiteError`, and the old version must still be there.
"""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import random
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from brdf_suite.errors import SuiteError
from tools.attack.children import be_quiet, in_child, wait_for_threads
from tools.attack.writing import chosen
from tools.attack.writing.writer import VERSIONS, Writer

_STEPS = frozenset(
    (
        "open",
        "os.rename",
        "os.remove",
        "os.chmod",
        "os.mkdir",
        "os.rmdir",
        "os.link",
        "os.truncate",
        "sqlite3.connect",
    )
)
_MOST_STEPS = 60
_BYTES = (0, 1, 100, 4096, 20_000, 100_000)


@dataclass
class Figures:
    """Kills of one writer, or of all."""

    kills: int = 0
    in_a_write: int = 0
    damaged: int = 0
    lost: int = 0
    leftovers: int = 0
    full_disks: int = 0
    full_disk_faults: int = 0
    examples: list[str] = field(default_factory=list)

    def add(self, other: Figures) -> None:
        """Add the figures of another writer."""
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)

    def note(self, text: str) -> None:
        """Keep a few of the faults in words."""
        if len(self.examples) < 4:
            self.examples.append(text[:300])


class Trial:
    """Kills of one writer in a folder of its own."""

    def __init__(self, writer: Writer, folder: Path, seed: int) -> None:
        self._writer, self._folder = writer, folder
        self._rng = random.Random(f"{seed} {writer.name}")
        self._usual: Counter[str] = Counter()
        self._version = 0
        self._beside = False
        self.figures = Figures()

    def run(self, kills: int) -> Figures:
        """Kill at every step and after some bytes, then at random moments until there are ``kills``."""
        seconds = self._undisturbed()
        for step in range(1, _MOST_STEPS):
            if not self._one(lambda step=step: _kill_at_step(step)):  # type: ignore[misc]  # bound early
                break
            if self.figures.kills >= kills // 2:
                break
        for size in _BYTES:
            self._one(lambda size=size: _kill_at_size(size))  # type: ignore[misc]  # bound early
        with self._companion():
            while self.figures.kills < kills:
                self._one(None, self._rng.uniform(0.0, 3.0 * seconds))
        for size in _BYTES:
            self._full_disk(size)
        return self.figures

    @contextlib.contextmanager
    def _companion(self) -> Iterator[None]:
        """Let another process write beside the one that is killed, where several may; it must live to the end."""
        if not self._writer.optional:
            yield
            return
        pid = os.fork()
        if pid == 0:
            try:
                be_quiet()
                for number in itertools.count(VERSIONS // 2):
                    self._writer.write(self._folder, number % VERSIONS)
            finally:
                os._exit(1)
        self._beside = True
        try:
            yield
        finally:
            self._beside = False
            ended, _ = os.waitpid(pid, os.WNOHANG)
            if ended:
                self.figures.damaged += 1
                self.figures.note(f"{self._writer.name}: the program beside it ended")
            else:
                os.kill(pid, signal.SIGKILL)
                os.waitpid(pid, 0)
                self.figures.kills += 1
                self._judge(self._version, "killed beside the other")

    def _undisturbed(self) -> float:
        """Write some versions without a kill; return the seconds that one takes."""

        def work() -> str:
            begin = time.monotonic()
            for number in range(1, 10):
                self._writer.write(self._folder, number)
                usual = self._listed()
                for name, count in usual.items():
                    self._usual[name] = max(self._usual[name], count)
            return json.dumps([(time.monotonic() - begin) / 9.0, self._usual])

        seconds, usual = json.loads(in_child(work))
        self._usual = Counter(usual)
        self._version = 9
        return float(seconds)

    def _one(self, prepare: Callable[[], object] | None, after_s: float = 0.0) -> bool:
        """Kill one child, and see what it left; False where it lived on by itself."""
        receive, send = os.pipe()
        base = self._version
        pid = os.fork()
        if pid == 0:
            try:
                os.close(receive)
                be_quiet()
                if prepare is not None:
                    prepare()
                for number in itertools.count(base + 1):
                    os.write(send, b"<")
                    self._writer.write(self._folder, number % VERSIONS)
                    os.write(send, b">")
                    if prepare is not None:
                        break
            finally:
                os._exit(0)
        os.close(send)
        said = os.read(receive, 1)  # it has begun
        if prepare is None:
            time.sleep(after_s)
            os.kill(pid, signal.SIGKILL)
        _, status = os.waitpid(pid, 0)
        while more := os.read(receive, 1 << 16):
            said += more
        os.close(receive)
        if not os.WIFSIGNALED(status):
            self._version = base + said.count(b">")
            return False
        self.figures.kills += 1
        self.figures.in_a_write += said.endswith(b"<")
        self._judge(
            base + said.count(b">"), f"{'killed' if prepare is None else 'cut off'} after {said!r}"[:80]
        )
        return True

    def _judge(self, reported: int, how: str) -> None:
        """Count what a kill damaged, lost and left over; ``reported`` is the last version that was written."""

        def work() -> str:
            try:
                found = self._writer.read(self._folder)
            except Exception as error:  # noqa: BLE001 - whatever a reader says of a document that a kill damaged
                return json.dumps(["damaged", f"{type(error).__name__}: {error}", []])
            again = reported + 2
            self._writer.write(self._folder, again % VERSIONS)
            # What the program beside it is writing just now is no leftover.
            more = [
                name
                for name, count in self._listed().items()
                if count > self._usual[name] and not self._beside
            ]
            return json.dumps(["read", found, more])

        word, found, more = json.loads(in_child(work))
        allowed = (-1,) if self._writer.optional else (reported % VERSIONS, (reported + 1) % VERSIONS)
        if word == "damaged":
            self.figures.damaged += 1
            self.figures.note(f"{self._writer.name}: {how}: {found}")
        elif found not in allowed:
            self.figures.lost += 1
            self.figures.note(f"{self._writer.name}: {how}: version {found}, not {allowed}")
        if more:
            self.figures.leftovers += 1
            self.figures.note(f"{self._writer.name}: {how}: left over {more}")
        if word == "damaged" or more:
            shutil.rmtree(self._folder)
            self._folder.mkdir()
            self._undisturbed()
        else:
            self._version = reported + 2

    def _full_disk(self, size: int) -> None:
        """Write to a disk that takes no more than ``size`` bytes of a file."""
        base = self._version

        def work() -> str:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
            said, written = "", False
            try:
                self._writer.write(self._folder, (base + 1) % VERSIONS)
                written = True
            except SuiteError:
                pass
            except Exception as error:  # noqa: BLE001 - finding these is what this program is for
                if not (self._writer.optional and isinstance(error, ValueError)):
                    said = f"{type(error).__name__}: {error}"
            resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            try:
                found = self._writer.read(self._folder)
            except Exception as error:  # noqa: BLE001 - as above
                return json.dumps([f"{said} then {type(error).__name__}: {error}", written])
            if not self._writer.optional and found != (base + written) % VERSIONS:
                said = f"{said} version {found} instead of {base + written}"
            more = [name for name, count in self._listed().items() if count > self._usual[name]]
            return json.dumps([f"{said} left over {more}" if more else said, written])

        said, written = json.loads(in_child(work))
        self._version = base + written
        self.figures.full_disks += 1
        if said:
            self.figures.full_disk_faults += 1
            self.figures.note(f"{self._writer.name}: full disk at {size} bytes: {said}")
            shutil.rmtree(self._folder)
            self._folder.mkdir()
            self._undisturbed()

    def _listed(self) -> Counter[str]:
        """Return the files that there are once the threads are done, hashes and numbers made alike."""
        wait_for_threads()
        files = (str(path.relative_to(self._folder)) for path in self._folder.rglob("*") if path.is_file())
        return Counter(re.sub(r"[0-9a-f]{8,}|-\w{8}(?=\.)", "#", name) for name in files)


def _kill_at_step(step: int) -> None:
    """Die at the ``step``-th operation on a file's name."""
    count = 0

    def hook(event: str, _arguments: object) -> None:
        nonlocal count
        if event in _STEPS:
            count += 1
            if count == step:
                os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(hook)


def _kill_at_size(size: int) -> None:
    """Die when a file grows over ``size`` bytes."""
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def kill_writers(
    kills: int,
    seed: int,
    words: Iterable[str] = (),
    report: Callable[[str], None] = print,
    *,
    in_slices: bool = False,
) -> dict[str, Figures]:
    """Return the figures of the writers (:func:`tools.attack.writing.chosen`), with ``kills`` in all."""
    writers = chosen(words, in_slices=in_slices)
    found: dict[str, Figures] = {}
    for writer in writers:
        with tempfile.TemporaryDirectory(prefix="attack-") as folder:
            found[writer.name] = Trial(writer, Path(folder), seed).run(-(-kills // len(writers)))
        for text in found[writer.name].examples:
            report(text)
    return found
