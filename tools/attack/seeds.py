"""Seeds: undamaged files of a reader, and what each input makes of them."""

from __future__ import annotations

import contextlib
import hashlib
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from tools.attack.mutation import mutate, splice
from tools.attack.readers.reader import Reader, outcome

_LARGEST_FOREIGN = 1 << 20
"""Bytes of another reader's file that are given to a reader: what a file is, is seen from its beginning."""


class Seed:
    """An undamaged file with its companions, and its damaged versions by number."""

    inputs: int | None = None
    """All the versions that there are; None: any number."""
    is_whole = True
    """Its reader reads it as it is."""

    def __init__(self, reader: Reader, path: Path, label: str = "") -> None:
        self.reader, self.name = reader, path.name
        self.key = label or f"{path.parent.name}/{path.name}"
        self.content = path.read_bytes()
        beside = [one for one in path.parent.iterdir() if one.is_file() and one.name != path.name]
        self.companions = {one.name: one.read_bytes() for one in beside if one.name.encode() in self.content}

    @property
    def size(self) -> int:
        """Bytes of the largest file that damage starts from."""
        return len(self.content)

    def damaged(self, run: int, number: int) -> dict[str, bytes]:
        """Return the files that are damaged by their names, mostly one; the same each time."""
        rng = self.generator(run, number)
        if not self.companions or rng.random() < 0.6:
            return {self.name: mutate(self.content, rng)}
        name = rng.choice(sorted(self.companions))
        old = self.companions[name]
        # One in ten refers to what is the file that refers to it.
        new = self.content if rng.random() < 0.1 else mutate(old, rng)
        if rng.random() < 0.5:
            return {name: new}
        main = self.content
        if rng.random() < 0.5:  # a checksum that the main file has of its companion is made right
            main = main.replace(_sha256(old), _sha256(new))
        return {self.name: mutate(main, rng) if rng.random() < 0.7 else main, name: new}

    def generator(self, run: int, number: int) -> random.Random:
        """Return what all chance of an input is drawn from."""
        return random.Random(f"{run} {self.reader.name} {self.key} {number}")

    def write(self, folder: Path, run: int, number: int) -> Path:
        """Write the files, some of them damaged; return the main one."""
        return self._write(folder, self.damaged(run, number))

    def restore(self, folder: Path) -> Path:
        """Write the undamaged files; return the main one."""
        return self._write(folder, {})

    def _write(self, folder: Path, damaged: Mapping[str, bytes]) -> Path:
        for name, content in ({self.name: self.content} | self.companions | dict(damaged)).items():
            (folder / name).write_bytes(content)
        return folder / self.name

    def outcome(self, path: Path) -> str:
        """Read what was written; return what came out as :func:`tools.attack.readers.reader.outcome`."""
        return outcome(self.reader, path)

    @contextlib.contextmanager
    def beside(self, _folder: Path) -> Iterator[None]:
        """Do what goes on beside all readings of a worker; here nothing."""
        yield


class StoredSeed(Seed):
    """A file that was damaged before, and is read once as it is."""

    inputs = 1
    is_whole = False

    def damaged(self, _run: int, _number: int) -> dict[str, bytes]:
        """Return nothing: the files are as they were stored."""
        return {}


class _MixedSeed(Seed):
    """What is made of this file and the files of others.

    What is wrong with it need not have a place. The libraries of all meshes may get it, and die in their own process.
    """

    def __init__(self, reader: Reader, path: Path, others: Sequence[bytes], label: str) -> None:
        outside = reader.outside or reader.name.startswith("mesh:")
        mixed = replace(reader, has_place=False, outside=outside)
        super().__init__(mixed, path, f"{label} {path.parent.name}/{path.name}")
        self._others = others


class SplicedSeed(_MixedSeed):
    """A file made of two: of this one and another of the same reader, or of its group where it has no other."""

    def __init__(self, reader: Reader, path: Path, others: Sequence[bytes]) -> None:
        super().__init__(reader, path, others, "spliced")

    @property
    def size(self) -> int:
        """Bytes of both."""
        return len(self.content) + max(len(other) for other in self._others)

    def damaged(self, run: int, number: int) -> dict[str, bytes]:
        """Return the file, spliced with one of the others."""
        rng = self.generator(run, number)
        first, second = self.content, rng.choice(self._others)
        return {self.name: splice(first, second, rng) if rng.random() < 0.5 else splice(second, first, rng)}


class CrossedSeed(_MixedSeed):
    """The files of all other readers, each once, under the name of this one."""

    def __init__(self, reader: Reader, path: Path, others: Sequence[bytes]) -> None:
        super().__init__(reader, path, others, "crossed")
        self.inputs = len(others)

    @property
    def size(self) -> int:
        """Bytes of the largest."""
        return max(len(other) for other in self._others)

    def damaged(self, _run: int, number: int) -> dict[str, bytes]:
        """Return the content of another file."""
        return {self.name: self._others[number]}


Make = Callable[[Reader, Path], Seed]


def seeds_of(readers: Sequence[Reader], folder: Path, make: Make = Seed) -> Iterator[Seed]:
    """Write the undamaged files of readers below ``folder`` and yield them; a reader without one is left out."""
    for reader, paths in _made(readers, folder):
        for path in paths:
            yield make(reader, path)


def contents_of(readers: Sequence[Reader], folder: Path) -> dict[str, list[bytes]]:
    """Return the beginnings of the undamaged files of each reader by its name."""
    return {
        reader.name: [path.read_bytes()[:_LARGEST_FOREIGN] for path in paths]
        for reader, paths in _made(readers, folder)
    }


def crossing_seeds(
    readers: Sequence[Reader], folder: Path, contents: Mapping[str, Sequence[bytes]], step: int = 1
) -> Iterator[Seed]:
    """Yield each seed spliced, and for each ending of a reader one in ``step`` of the ``contents`` of others."""
    for reader, paths in _made(readers, folder):
        group = reader.name.partition(":")[0]
        foreign = [one for name, all_of in contents.items() if name != reader.name for one in all_of]
        related = [
            one for name, all_of in contents.items() if name.partition(":")[0] == group for one in all_of
        ]
        for path in paths:
            own = [other.read_bytes() for other in paths if other != path and other.suffix == path.suffix]
            yield SplicedSeed(reader, path, own or related)
        for path in {path.suffix: path for path in paths}.values():
            yield CrossedSeed(reader, path, foreign[::step])


def _made(readers: Sequence[Reader], folder: Path) -> list[tuple[Reader, list[Path]]]:
    found = []
    for reader in readers:
        own = folder / reader.name.replace(":", "_")
        own.mkdir(parents=True, exist_ok=True)
        found.append((reader, reader.make(own)))
    return found


def _sha256(content: bytes) -> bytes:
    return hashlib.sha256(content).hexdigest().encode()
