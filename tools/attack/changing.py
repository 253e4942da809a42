"""Files that change while they are read: cut off, made longer, written over, replaced by another, or removed.

In two ways. Within the reading process the change comes at one of the calls that the reading makes, mostly one that
opens or reads a file: each is hit, whatever else the machine does. And another process changes the files all the time,
which also reaches what a library does within one call. A file that is mapped into memory and cut off ends its reader.
"""

from __future__ import annotations

import contextlib
import os
import random
import signal
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import FrameType
from typing import Any

from tools.attack.mutation import mutate
from tools.attack.readers.reader import Reader, outcome
from tools.attack.seeds import Seed

_CALLS_ON_FILES = frozenset(
    ("open", "stat", "lstat", "fstat", "read", "readinto", "readline", "seek", "close", "scandir")
)
_PAUSE_S = 0.002
"""The longest between two changes by another process."""


def _cut(path: Path, content: bytes, rng: random.Random) -> None:
    os.truncate(path, rng.choice((0, rng.randrange(len(content) + 1))))


def _lengthen(path: Path, content: bytes, _rng: random.Random) -> None:
    with path.open("ab") as file:
        file.write(content)


def _write_over(path: Path, content: bytes, rng: random.Random) -> None:
    path.write_bytes(mutate(content, rng))


def _replace(path: Path, content: bytes, rng: random.Random) -> None:
    other = path.with_name("other")
    other.write_bytes(mutate(content, rng))
    other.replace(path)


def _remove(path: Path, _content: bytes, _rng: random.Random) -> None:
    path.unlink()


_CHANGES: tuple[Callable[[Path, bytes, random.Random], None], ...] = (
    _cut,
    _cut,
    _lengthen,
    _write_over,
    _replace,
    _remove,
)


class _ChangingSeed(Seed):
    """A seed whose files change while they are read; what is missing or another need not have a place."""

    def __init__(self, reader: Reader, path: Path, label: str) -> None:
        super().__init__(replace(reader, has_place=False), path, f"{label} {path.parent.name}/{path.name}")

    @property
    def size(self) -> int:
        """Bytes of the file at its longest."""
        return 4 * len(self.content)

    def damaged(self, _run: int, _number: int) -> dict[str, bytes]:
        """Return nothing: a reading begins with the undamaged files."""
        return {}

    def change(self, folder: Path, rng: random.Random) -> None:
        """Change one of the files; a reader may have removed it itself."""
        name = rng.choice((self.name, self.name, *self.companions))
        content = self.companions.get(name, self.content)
        with contextlib.suppress(FileNotFoundError):
            rng.choice(_CHANGES)(folder / name, content, rng)


class SeedChangedAtCall(_ChangingSeed):
    """A seed that changes at one call of its reading."""

    def __init__(self, reader: Reader, path: Path) -> None:
        super().__init__(reader, path, "at a call")
        self._calls = 0
        self._on_files: list[int] = []
        self._rng = random.Random()

    def write(self, folder: Path, run: int, number: int) -> Path:
        """Write the files, and draw at which call they change."""
        self._rng = self.generator(run, number)
        return super().write(folder, run, number)

    def outcome(self, path: Path) -> str:
        """Read the file while it changes."""
        if not self._calls:
            self._count_calls(path)
            self.restore(path.parent)
        at = self._rng.randrange(self._calls)
        if self._on_files and self._rng.random() < 0.9:
            # Before the call, or as it returns.
            at = self._rng.choice(self._on_files) + self._rng.randrange(2)
        count = 0

        def hook(_frame: FrameType, _event: str, _argument: Any) -> None:
            nonlocal count
            if count == at:
                sys.setprofile(None)
                self.change(path.parent, self._rng)
            count += 1

        sys.setprofile(hook)
        try:
            return outcome(self.reader, path)
        finally:
            sys.setprofile(None)

    def _count_calls(self, path: Path) -> None:
        """Count the calls and returns of an undisturbed reading, and which of them are on files."""
        on_files = self._on_files

        def hook(_frame: FrameType, event: str, argument: Any) -> None:
            if event == "c_call" and argument.__name__ in _CALLS_ON_FILES:
                on_files.append(self._calls)
            self._calls += 1

        sys.setprofile(hook)
        try:
            outcome(self.reader, path)
        finally:
            sys.setprofile(None)


class SeedChangedBeside(_ChangingSeed):
    """A seed that another process changes all the time."""

    def __init__(self, reader: Reader, path: Path) -> None:
        super().__init__(reader, path, "by another process")

    def write(self, folder: Path, _run: int, _number: int) -> Path:
        """Return the file, which is the other process's to write."""
        return folder / self.name

    @contextlib.contextmanager
    def beside(self, folder: Path) -> Iterator[None]:
        """Let a process change and restore the files until the block ends, or this process does."""
        reading = os.getpid()
        pid = os.fork()
        if pid == 0:
            try:
                os.closerange(3, 256)  # of the pipe to the parent of both, which waits for its end
                rng = random.Random(self.key)
                while os.getppid() == reading:
                    self.change(folder, rng)
                    time.sleep(_PAUSE_S * rng.random())
                    if rng.random() < 0.5:
                        self._replace_all(folder)
                    else:
                        self.restore(folder)
                    time.sleep(_PAUSE_S * rng.random())
            finally:
                os._exit(0)
        try:
            yield
        finally:
            ended, _ = os.waitpid(pid, os.WNOHANG)
            if ended:
                raise RuntimeError("the process that changes the files ended")
            os.kill(pid, signal.SIGKILL)
            os.waitpid(pid, 0)

    def _replace_all(self, folder: Path) -> None:
        for name, content in ({self.name: self.content} | self.companions).items():
            (folder / "other").write_bytes(content)
            (folder / "other").replace(folder / name)
