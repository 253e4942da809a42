"""Power loss: what a write that was reported as done has forced to the disk, and what there is in the middle of one.

A child writes while a :class:`Disk` notes each file's content and each folder's names when :func:`os.fsync` forces them
to the disk. What was not forced may be lost in any part, so the worst is taken: content and names are as they were
last forced. After the report that must be the version that was reported. In the middle of the next write each renaming,
linking and removal may have come to the disk before anything that was not forced: then the old or the new version must
be there. A file that is renamed before its content is forced, or a folder that is not forced at all, fails one of both.
"""

from __future__ import annotations

import copy
import json
import os
import stat
import sys
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tools.attack.children import be_quiet, in_child, wait_for_threads
from tools.attack.writing import chosen
from tools.attack.writing.writer import Writer

Names = dict[str, tuple[int, bool]]
"""Of a folder: the number of the file or folder behind each name, and whether it is a folder."""


@dataclass
class Losses:
    """Simulated power losses while one writer writes."""

    losses: int = 0
    faults: list[str] = field(default_factory=list)


class Disk:
    """What a power loss leaves of a folder at the worst, and the moments of a write at which one is simulated."""

    def __init__(self, folder: Path) -> None:
        self._root = folder.stat().st_ino
        self._contents: dict[int, bytes] = {}
        self._names: dict[int, Names] = {}
        self._held: list[int] = []
        """Open descriptors: no other file can get the number of one that was noted."""
        self.moments: list[tuple[str, Disk]] = []

    def watch(self) -> None:
        """Note from now on what this process forces to the disk, and the steps that change names."""
        force = os.fsync

        def fsync(descriptor: Any) -> None:
            force(descriptor)
            self._note(descriptor if isinstance(descriptor, int) else descriptor.fileno())

        for name in ("fsync", "fdatasync"):
            setattr(os, name, fsync)
        sys.addaudithook(self._step)

    def _note(self, descriptor: int) -> None:
        found = os.fstat(descriptor)
        self._held.append(os.dup(descriptor))
        if stat.S_ISDIR(found.st_mode):
            with os.scandir(descriptor) as entries:
                self._names[found.st_ino] = {
                    one.name: (one.inode(), one.is_dir(follow_symlinks=False)) for one in entries
                }
        elif stat.S_ISREG(found.st_mode):
            self._contents[found.st_ino] = Path(f"/proc/self/fd/{descriptor}").read_bytes()

    def _step(self, event: str, arguments: tuple[Any, ...]) -> None:
        """Add the moment at which a step that has not been made yet is on the disk, before all that was not forced."""
        if event not in ("os.rename", "os.link", "os.remove"):
            return
        path = Path(os.fsdecode(arguments[0]))
        try:
            found = path.lstat()
            home = path.parent.stat().st_ino
        except OSError:
            return
        after = Disk.__new__(Disk)
        after._root, after._contents = self._root, dict(self._contents)
        after._names = copy.deepcopy(self._names)
        if event != "os.link":
            after._names.get(home, {}).pop(path.name, None)
        said = f"{event} of {path.name}"
        if event != "os.remove":
            target = Path(os.fsdecode(arguments[1]))
            names = after._names.get(target.parent.stat().st_ino)
            if names is not None:
                names[target.name] = (found.st_ino, stat.S_ISDIR(found.st_mode))
            said = f"{said} to {target.name}"
        self.moments.append((said, after))

    def leave(self, folder: Path) -> None:
        """Write what is left into an empty folder."""
        self._leave(self._root, folder)

    def _leave(self, number: int, folder: Path) -> None:
        for name, (inner, is_folder) in self._names.get(number, {}).items():
            if is_folder:
                (folder / name).mkdir()
                self._leave(inner, folder / name)
            else:
                (folder / name).write_bytes(self._contents.get(inner, b""))


def lose_power(writer: Writer, folder: Path) -> Losses:
    """Write two versions into an empty folder, with a power loss after each and at each step of the second."""

    def work() -> str:
        be_quiet()
        disk, found = Disk(folder), Losses()
        disk.watch()
        for number in (1, 2):
            disk.moments = []
            writer.write(folder, number)
            wait_for_threads()
            moments, disk.moments = disk.moments, []  # reading has steps of its own
            _judge(writer, disk, (number,), f"after version {number} was reported", found)
        for said, after in moments:
            _judge(writer, after, (1, 2), f"at {said}", found)
        return json.dumps([found.losses, found.faults])

    return Losses(*json.loads(in_child(work)))


def _judge(writer: Writer, disk: Disk, allowed: tuple[int, ...], when: str, found: Losses) -> None:
    found.losses += 1
    with tempfile.TemporaryDirectory(prefix="attack-") as left:
        disk.leave(Path(left))
        try:
            version = writer.read(Path(left))
        except Exception as error:  # noqa: BLE001 - whatever a reader says of a document that a power loss damaged
            found.faults.append(f"{when}: {type(error).__name__}: {error}"[:300])
            return
    if version not in allowed:
        found.faults.append(f"{when}: version {version} is left")


def lose_power_in_writers(
    words: Iterable[str] = (), report: Callable[[str], None] = print, *, in_slices: bool = False
) -> dict[str, Losses]:
    """Return the figures of the writers of documents (:func:`tools.attack.writing.chosen`); caches may lose all."""
    found: dict[str, Losses] = {}
    for writer in chosen(words, in_slices=in_slices):
        if writer.optional or not writer.is_forced:
            continue
        with tempfile.TemporaryDirectory(prefix="attack-") as folder:
            found[writer.name] = lose_power(writer, Path(folder))
        for text in found[writer.name].faults:
            report(f"{writer.name}: {text}")
    return found
