"""Limit on the size of data decoded from a file, checked beforehand: a small file can declare any number of values."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

from brdf_suite.errors import FileError, PathLike

_Others = ParamSpec("_Others")
_Result = TypeVar("_Result")

MOST_MADE_BYTES = 1 << 30
"""Largest array of pixels or mesh data, in bytes, that is made of one file."""


def check_made(path: PathLike, size: int, what: str, place: str | None = None) -> None:
    """Raise :class:`FileError` where ``what``, to be made of the file ``path``, takes more than the limit.

    ``size`` is in bytes; ``place`` says where in the file it is announced.
    """
    if size > MOST_MADE_BYTES:
        taken = f"{size / 2**30:,.1f} GiB" if size < 1 << 60 else "more memory than there is"
        raise FileError(path, f"{what} would take {taken}; {MOST_MADE_BYTES >> 30} GiB is allowed", place)


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
