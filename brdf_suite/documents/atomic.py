"""Atomic writing of files.

The content goes to a temporary file in the same folder, is forced to the disk, and takes the old file's place in
one step of the file system. Whatever happens before that step, the old file is as it was.

A writer that is killed leaves its temporary file, hidden and with the ending of the target. The next save of the same
file removes it: a writer that lives holds a lock on its own, which the system frees with the process.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import secrets
import stat
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from glob import escape
from io import BufferedIOBase
from pathlib import Path

from brdf_suite.errors import FileError

if sys.platform != "win32":
    import fcntl

_UNFINISHED = re.compile(r"\..*\.[0-9a-f]{16}(?:\.[^.]*)?", re.DOTALL)
_LONGEST_WRITE_S = 3600.0
"""Where a system has no locks, a temporary file that has not grown for so long belongs to no writer."""


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Yield the path of an empty temporary file that takes the place of ``path`` when the block ends well.

    For libraries that write to a name. The temporary file keeps the ending of ``path``. A symbolic link is
    followed; the mode of an existing file is kept. Where the block, or anything after it, fails, the temporary
    file is removed and the old one stays.

    Raises
    ------
    FileError
        The folder is missing or cannot be written, the target is no plain file, or the disk is full.
    """
    # A link to a file elsewhere must stay a link, so the file that it names is the one replaced.
    target = Path(os.path.realpath(path))
    temporary: Path | None = None
    try:
        mode = _mode_of(target)
        remove_leftovers(target)
        unused = target.parent / f".{target.stem[:80]}.{secrets.token_hex(8)}{target.suffix}"
        # "x" refuses a file that is already there; the user's umask applies as to any new file.
        with unused.open("xb") as held:
            temporary = unused
            _lock(held)
            yield temporary
        with temporary.open("rb+") as file:
            os.fsync(file.fileno())
        if mode is not None:
            temporary.chmod(mode)
        os.replace(temporary, target)  # noqa: PTH105 - tests interpose here as a full disk would
        temporary = None
        sync_folder(target.parent)
    except OSError as error:
        raise FileError(path, f"cannot be written: {error.strerror or error}") from error
    finally:
        if temporary is not None:
            # Where even this fails, the first error is the one to report.
            with contextlib.suppress(OSError):
                temporary.unlink()


def remove_leftovers(target: Path, stem: str | None = None) -> None:
    """Remove the temporary files that killed writers of ``target`` left beside it; those in use stay.

    ``stem`` is a pattern of :mod:`glob` in place of the name without its ending, where that changes with the content.
    """
    stem = escape(target.stem[:80]) if stem is None else stem
    for path in target.parent.glob(f".{stem}.{'[0-9a-f]' * 16}{escape(target.suffix)}"):
        with contextlib.suppress(OSError), path.open("rb+") as file:
            is_left = _lock(file)
            old = time.time() - path.stat().st_mtime > _LONGEST_WRITE_S
            if is_left or old:
                path.unlink()


def is_unfinished(path: Path) -> bool:
    """Return whether a name is that of a temporary file of :func:`replacing`, which is no document.

    >>> is_unfinished(Path(".blue.0123456789abcdef.brdfpaint")), is_unfinished(Path("blue.brdfpaint"))
    (True, False)
    """
    return _UNFINISHED.fullmatch(path.name) is not None


def _lock(file: BufferedIOBase) -> bool:
    """Lock an open file for this process; return whether it is locked now, which needs a system with such locks."""
    if sys.platform == "win32":
        return False
    try:
        fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:  # another holds it, or the file system has no locks
        return False
    return True


def write_atomically(path: str | os.PathLike[str], content: bytes) -> None:
    """Replace the file at ``path`` by ``content``, or raise :class:`FileError` and leave it untouched."""
    with replacing(path) as temporary:
        temporary.write_bytes(content)


def encode(value: Mapping[str, object]) -> bytes:
    """Return a document's JSON object as the bytes of its file; numbers that are not finite are a fault."""
    return (json.dumps(value, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode("utf-8")


def with_lists(pairs: list[tuple[str, object]]) -> dict[str, object]:
    """Return fields with lists for tuples, which JSON does not know: what is saved is compared with what is read."""
    return {name: list(value) if isinstance(value, tuple) else value for name, value in pairs}


def _mode_of(target: Path) -> int | None:
    """Return the mode of the old file, or None where there is none yet."""
    try:
        found = target.stat()
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(found.st_mode):
        raise OSError(0, "it is not a plain file")
    return stat.S_IMODE(found.st_mode)


def sync_folder(folder: Path) -> None:
    """Flush the folder's own entry to disk, where the system supports it."""
    if os.name == "nt":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
