"""Collector shared by palette readers: entries and groups in order, checked and repaired with notices."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

from brdf_suite.documents.flat_colour import LONGEST_NAME, FlatColour, Model
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import (
    DEEPEST_GROUP,
    MOST_ENTRIES,
    MOST_GROUPS,
    Entry,
    Foreign,
    Group,
    GroupPath,
    Palette,
)
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.tables.grid import decode

_Fields = ParamSpec("_Fields")
_Made = TypeVar("_Made")

_CHOICE = re.compile(r"\[([^\[\]|]*)\|([^\[\]|]*)\]")
_CONTROL = re.compile("[\x00-\x1f\x7f-\x9f\ud800-\udfff]")
_CONTROL_IN_LINES = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff]")
_LONGEST_NOTES = 100_000
MOST_COLOURS = 30_000
"""Of a foreign file: ten times the largest colour atlas, and as many as are read in two seconds."""
_written_here: ContextVar[bool] = ContextVar("written_here", default=False)


@contextmanager
def allow_palette_size() -> Iterator[None]:
    """Raise the colour limit to that of a palette while reading files written by this program."""
    token = _written_here.set(True)
    try:
        yield
    finally:
        _written_here.reset(token)


class Collector:
    """Collector of entries and groups in file order; errors name the file and the place.

    Names that are too long are cut, control characters become spaces, and a group of a name that was there already
    gets a number: all of this is counted, and reported by :meth:`finish`.
    """

    def __init__(self, path: PathLike) -> None:
        self.path = path
        self.entries: list[Entry] = []
        self.notes: dict[str, int] = {}
        self._groups: dict[GroupPath, Group] = {}

    def fail(self, reason: str, place: str) -> FileError:
        """Return the error of this file, to be raised."""
        return FileError(self.path, reason, place)

    def note(self, sentence: str) -> None:
        """Record a notice for the user.

        ``{n}`` in it becomes how often it was said, and ``[one|many]`` the word that fits that number.
        """
        self.notes[sentence] = self.notes.get(sentence, 0) + 1

    def check_count(self, count: int, place: str) -> None:
        """Refuse a file of more colours than are allowed in it, before any of them is made."""
        most = MOST_ENTRIES if _written_here.get() else MOST_COLOURS
        if count > most:
            reason = f"{count:,} colours are more than the {most:,} that a file of this kind may have"
            raise self.fail(reason, place)

    def name(self, text: str, longest: int = LONGEST_NAME) -> str:
        """Return a name as it can be kept."""
        if len(text) > longest:
            self.note(f"{{n}} name[|s] [was|were] cut: there were more than {longest:,} characters.")
            text = text[:longest]
        if text.isprintable():
            return text
        cleaned = _CONTROL.sub(" ", text)
        if cleaned != text:
            self.note("Control characters in {n} name[|s] became spaces.")
        return cleaned

    def lines(self, text: str) -> str:
        """Return a text of several lines as it can be kept."""
        cleaned = _CONTROL_IN_LINES.sub(" ", text.replace("\r\n", "\n").replace("\r", "\n"))
        if len(cleaned) > _LONGEST_NOTES:
            self.note(f"{{n}} text[|s] [was|were] cut: there were more than {_LONGEST_NOTES:,} characters.")
        return cleaned[:_LONGEST_NOTES]

    def _make(
        self, place: str, kind: Callable[_Fields, _Made], *values: _Fields.args, **fields: _Fields.kwargs
    ) -> _Made:
        try:
            return kind(*values, **fields)
        except ValueRangeError as error:
            raise self.fail(f"{error.place}: {error.reason}", place) from error

    def colour(
        self, place: str, name: str, model: Model, values: Sequence[float], **fields: Any
    ) -> FlatColour:
        """Return a :class:`FlatColour` with further ``fields``; :class:`FileError` where one is out of range."""
        return self._make(place, FlatColour, name, model, tuple(values), **fields)

    def add(self, place: str, content: FlatColour | Paint, **fields: Any) -> None:
        """Add an :class:`Entry` with further ``fields``; errors as :meth:`colour`."""
        self.check_count(len(self.entries) + 1, place)
        # Its number is the id that it would get anyway.
        self.entries.append(self._make(place, Entry, content, str(len(self.entries) + 1), **fields))

    def declare(self, place: str, names: Sequence[str]) -> GroupPath:
        """Begin the group of a path, and those around it, where they have not begun; return the path."""
        path = tuple(self.name(name) for name in names)
        for depth in range(len(path)):
            if path[: depth + 1] not in self._groups:
                self.group(place, path[:depth], path[depth])
        return path

    def group(
        self,
        place: str,
        around: GroupPath,
        name: str,
        notes: str = "",
        colour: str = "",
        foreign: Foreign = (),
    ) -> GroupPath:
        """Begin a group within another, and return its path; one of a name that was there gets a number."""
        if len(around) >= DEEPEST_GROUP:
            raise self.fail(f"groups are nested deeper than {DEEPEST_GROUP}", place)
        if len(self._groups) >= MOST_GROUPS:
            raise self.fail(f"has more than {MOST_GROUPS:,} groups", place)
        clean = self.name(name)
        path = (*around, clean)
        number = 1
        while path in self._groups:
            number += 1
            if number > 1000:
                raise self.fail("more than a thousand groups have the same name", place)
            path = (*around, f"{clean[: LONGEST_NAME - 8]} ({number})")
        if number > 1:
            self.note("{n} group[|s] of a name that was there already [has|have] a number now.")
        self._groups[path] = self._make(place, Group, path, notes, colour, foreign)
        return path

    def finish(
        self, name: str = "", *, notes: str = "", columns: int = 0, colour: str = "", foreign: Foreign = ()
    ) -> tuple[Palette, tuple[str, ...]]:
        """Return the palette and the notes; without a name it has that of the file."""
        # A palette whose file says no name is called as the file is.
        stem = _CONTROL.sub(" ", Path(self.path).stem)[:200].strip() or "Palette"
        clean = self.name(name).strip() or stem
        groups = tuple(self._groups.values())
        try:
            palette = Palette(clean, tuple(self.entries), groups, notes, colour, columns, foreign)
        except ValueRangeError as error:
            raise self.fail(error.reason, error.place) from error
        return palette, tuple(_counted(sentence, count) for sentence, count in self.notes.items())


def _counted(sentence: str, count: int) -> str:
    if "{n}" not in sentence:
        return sentence
    fitting = _CHOICE.sub(lambda found: found[1] if count == 1 else found[2], sentence)
    return fitting.replace("{n}", f"{count:,}")


def decode_text(content: bytes, path: PathLike, collector: Collector | None = None) -> str:
    """Return a text file's text: UTF-8 or UTF-16, with or without a mark, else Latin-1, which is reported.

    Raises :class:`FileError`: it is no text: it holds a NUL byte, or half a letter of UTF-16.
    """
    found = decode(content)
    if found is None:
        if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
            raise FileError(path, "is not text in UTF-16", "byte 0")
        raise FileError(path, "holds a NUL byte, so it is not text", f"byte {content.index(0)}")
    text, assumed = found
    if assumed and collector is not None:
        collector.note(
            "The file is not in UTF-8; its letters are taken for those of Latin-1 as Windows has it (1252)."
        )
    return text


def decode_lines(content: bytes, path: PathLike, collector: Collector) -> list[str]:
    """Return the lines of a text file, however they end; as :func:`decode_text`."""
    return decode_text(content, path, collector).replace("\r\n", "\n").replace("\r", "\n").split("\n")
