"""The one way in which the suite opens files to read them: only regular files, of a bounded size.

A pipe or a device in the place of a file would be waited for without end, and a folder or a dangling link has nothing
to read. Libraries that take a name instead of an open file get it after :func:`check_regular`.
"""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from io import BufferedReader
from pathlib import Path, PureWindowsPath
from typing import Concatenate, ParamSpec, TypeVar

from brdf_suite.errors import FileError, PathLike

# A pipe that takes the file's place between the two looks is not waited for; Windows has no such flag, nor such pipes.
_FLAGS = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0) | getattr(os, "O_BINARY", 0)

_Others = ParamSpec("_Others")
_Result = TypeVar("_Result")


@contextmanager
def open_regular(path: PathLike, largest: int | None = None) -> Iterator[BufferedReader]:
    """Yield the open file at ``path``.

    Raises
    ------
    FileError
        It is missing, not readable, also within the block, not a regular file, or over ``largest`` bytes.
    """
    try:
        # Looked at before it is opened: opening a device can do something, as rewind a tape.
        _check(path, Path(path).stat(), largest)
        with open(os.open(path, _FLAGS), "rb") as stream:  # noqa: PTH123 - pathlib takes no flags
            _check(path, os.fstat(stream.fileno()), largest)
            yield stream
    except OSError as error:
        raise FileError(path, f"cannot be read ({_reason(path, error)})") from error
    except ValueError as error:
        if "\0" not in os.fspath(path):
            raise
        raise FileError(path, "cannot be read (its name holds a NUL character)") from error


def check_regular(path: PathLike, largest: int | None = None) -> None:
    """Raise :class:`FileError` as :func:`open_regular` would: for files that a library opens by their name."""
    with open_regular(path, largest):
        pass


_NOT_THERE = {errno.ENOENT, errno.ENOTDIR, errno.EBADF, errno.ELOOP}


def exists(path: PathLike) -> bool:
    """Return whether there is such a file or folder; :class:`FileError` where the file system refuses to look."""
    try:
        Path(path).stat()
    except ValueError:  # NUL in the name
        return False
    except OSError as error:
        if error.errno in _NOT_THERE:
            return False
        # A name that the file system does not take, a folder that may not be entered.
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    return True


def is_file(path: PathLike) -> bool:
    """Return whether there is such a file; False also where the file system refuses to look."""
    try:
        return Path(path).is_file()
    except (OSError, ValueError):
        return False


def is_folder(path: PathLike) -> bool:
    """Return whether there is such a folder; False also where the file system refuses to look."""
    try:
        return Path(path).is_dir()
    except (OSError, ValueError):
        return False


def read_bytes(path: PathLike, largest: int | None = None) -> bytes:
    """Return the content of a regular file of at most ``largest`` bytes, or raise :class:`FileError`."""
    with open_regular(path, largest) as stream:
        # As many as it has now: asking for the largest would reserve that much.
        return stream.read(os.fstat(stream.fileno()).st_size)


def read_text(path: PathLike, largest: int | None = None) -> str:
    """Return the content of a regular file in UTF-8, or raise :class:`FileError`."""
    try:
        return read_bytes(path, largest).decode("utf-8")
    except UnicodeDecodeError as error:
        raise FileError(path, "is not text in UTF-8", f"byte {error.start}") from error


def find_inside(folder: Path, name: str, start: Path | None = None) -> Path | None:
    """Return the file that another one names, ``name`` being relative to ``start``, by default ``folder``.

    ``folder`` has no links. None where the file does not lie in it or below, also by links. The name is looked at as
    text first: on Windows even the question whether a file of a share exists reaches its server.
    """
    if PureWindowsPath(name).anchor:  # also Windows' own way of naming other places, on any system
        return None
    place = Path(os.path.normpath((start or folder) / name))
    if not place.is_relative_to(folder):
        return None
    file = place.resolve()
    return file if file.is_relative_to(folder) else None


def within_memory(
    read: Callable[Concatenate[PathLike, _Others], _Result],
) -> Callable[Concatenate[PathLike, _Others], _Result]:
    """Return the reader ``read``, which takes a path first, with FileError in place of MemoryError."""

    @wraps(read)
    def reader(path: PathLike, /, *args: _Others.args, **kwargs: _Others.kwargs) -> _Result:
        try:
            return read(path, *args, **kwargs)
        except MemoryError as error:
            raise FileError(path, "there is not enough memory for what it holds") from error

    return reader


def _check(path: PathLike, found: os.stat_result, largest: int | None) -> None:
    if not stat.S_ISREG(found.st_mode):
        folder = " (it is a folder)" if stat.S_ISDIR(found.st_mode) else ""
        raise FileError(path, f"is not a plain file{folder}")
    if largest is not None and found.st_size > largest:
        raise FileError(
            path, f"has {found.st_size:,} bytes, more than the {largest:,} that this format can need"
        )


def _reason(path: PathLike, error: OSError) -> str:
    if isinstance(error, FileNotFoundError) and os.path.islink(path):  # noqa: PTH114 - as open_regular, any path
        return "it is a link to a file that is not there"
    return error.strerror or str(error)
