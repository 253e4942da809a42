"""``-`` in place of a file: standard input for what is read, standard output for what ``-o`` writes."""

from __future__ import annotations

import argparse
import errno
import io
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TextIO

from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError
from brdf_suite.foreign_text import make_visible
from brdf_suite.regular_files import exists

_READ = ("PAINT", "PALETTE", "FILE")
"""An argument is read from a file, but for ``-o``, where one of these is in the word that stands for it."""


@contextmanager
def streams(options: argparse.Namespace) -> Iterator[None]:
    """Give the options files in place of ``-`` in the body; what it wrote goes to standard output behind it.

    Standard input is kept in a file, since readers look at the content first, and is called "standard input" in all
    that is printed. Beside a file on standard output all else goes to standard error.
    """
    parser: CommandParser = options.parser
    _take_last(options)
    reading = [dest for dest in _inputs(parser) if "-" in _words(getattr(options, dest))]
    output = getattr(options, "output", None)
    writing = output is not None and str(output) == "-"
    if not reading and not writing:
        yield
        return
    out = sys.stdout
    with ExitStack() as stack:
        folder = Path(stack.enter_context(TemporaryDirectory(prefix="brdf-suite-")))
        if reading:
            file = folder / "standard input"
            _keep_input(options, reading, file)
            stack.enter_context(redirect_stdout(_Renaming(sys.stdout, str(file), file.name)))
            stack.enter_context(redirect_stderr(_Renaming(sys.stderr, str(file), file.name)))
        if not writing:
            yield
            return
        options.output = folder / f"standard output{_ending(options)}"
        renamed = _Renaming(sys.stderr, str(options.output), "standard output")
        with redirect_stdout(renamed), redirect_stderr(renamed):
            yield
        if exists(options.output):
            out.flush()
            out.buffer.write(options.output.read_bytes())
            out.flush()


def _inputs(parser: CommandParser) -> list[str]:
    return [
        action.dest
        for action in parser._actions
        if action.dest != "output" and any(word in str(action.metavar) for word in _READ)
    ]


def _words(value: object) -> list[str]:
    return [str(one) for one in value] if isinstance(value, list) else [str(value)]


def _take_last(options: argparse.Namespace) -> None:
    """Take the last of several sources for the output where a command has it so and no ``-o`` is given."""
    if getattr(options, "or_last", False) and options.output is None:
        if len(options.sources) > 1:
            options.output = Path(options.sources.pop())
        elif not getattr(options, "list_losses", False):
            options.parser.error("the following arguments are required: -o/--output")


def _keep_input(options: argparse.Namespace, reading: list[str], file: Path) -> None:
    if getattr(options, "follow", False):
        options.parser.error("--follow reads standard input itself; name a file in place of -")
    if sum(_words(getattr(options, dest)).count("-") for dest in reading) > 1:
        options.parser.error("standard input (-) can be read once")
    if sys.stdin is None:
        raise SuiteError("standard input: is closed.")
    file.write_bytes(sys.stdin.buffer.read())
    for dest in reading:
        value = getattr(options, dest)
        kept = type(value)(file) if not isinstance(value, list) else None
        setattr(options, dest, kept or [type(one)(file) if str(one) == "-" else one for one in value])


def _ending(options: argparse.Namespace) -> str:
    stream = getattr(options, "stream", None)
    if stream is None:
        options.parser.error("-o - is not supported here; name a file")
    if getattr(options, "json", False) or getattr(options, "follow", False):
        options.parser.error("with -o - standard output is the file; leave --json and --follow out")
    return str(stream(options)) if callable(stream) else str(stream)


@contextmanager
def visible_streams() -> Iterator[None]:
    """Show characters that are not seen in all that the body prints for people: on terminals, and on standard error.

    Names in files could otherwise steer the terminal. What standard output gives to a file or to another program is
    left as it is: it is data.
    """
    with ExitStack() as stack:
        if sys.stdout.isatty():
            stack.enter_context(redirect_stdout(_Visible(sys.stdout)))
        if sys.stderr is not None:
            stack.enter_context(redirect_stderr(_Visible(sys.stderr)))
        yield


@contextmanager
def closed_output() -> Iterator[None]:
    """Raise :class:`OSError` after the body if it wrote to standard output, and the caller had closed that."""
    if sys.stdout is not None:
        yield
        return
    out = _Closed()
    with redirect_stdout(out):
        try:
            yield
        except SystemExit as end:  # of --help
            if end.code or not out.is_needed:
                raise
    if out.is_needed:
        raise OSError(errno.EBADF, "standard output is closed")


class _Closed(io.TextIOBase):
    """In place of a standard output that the caller closed."""

    encoding = "utf-8"
    is_needed = False

    @property
    def buffer(self) -> Any:
        """The stream itself, for files on standard output."""
        return self

    def write(self, content: str | bytes) -> int:
        """Discard a text or bytes, and store that there were some."""
        self.is_needed = True
        return len(content)


class _Visible(io.TextIOBase):
    """A stream for people: of control characters only tab, line feed and a carriage return at the start pass."""

    encoding = "utf-8"

    def __init__(self, stream: TextIO) -> None:
        self.stream, self.encoding = stream, stream.encoding

    @property
    def buffer(self) -> Any:
        """The stream of bytes below, for files on standard output."""
        return self.stream.buffer

    def write(self, text: str) -> int:
        """Write the text as it is to be seen; progress bars return to the start of their line before they write."""
        start = "\r" if text.startswith("\r") else ""
        self.stream.write(start + make_visible(text[len(start) :]))
        return len(text)

    def flush(self) -> None:
        """Write what is buffered."""
        self.stream.flush()

    def fileno(self) -> int:
        """Return the number of the file below."""
        return self.stream.fileno()

    def isatty(self) -> bool:
        """Return whether the stream is a terminal."""
        return self.stream.isatty()


class _Renaming(io.TextIOBase):
    """A stream with another name for a file in all that is written to it."""

    def __init__(self, stream: TextIO, path: str, name: str) -> None:
        self.stream, self._path, self._name = stream, path, name

    def write(self, text: str) -> int:
        """Write with the name replaced."""
        return self.stream.write(text.replace(self._path, self._name))

    def flush(self) -> None:
        """Write what is buffered."""
        self.stream.flush()

    def isatty(self) -> bool:
        """Return whether the stream is a terminal."""
        return self.stream.isatty()
