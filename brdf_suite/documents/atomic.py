"""Atomic writing of files.

The content goes to a temporary file in the same folder, is forced to the disk, and takes the old file's place in
one step of the file system. Whatever happens before that step, the old file is as it was.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import re
import secrets
import stat
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from glob import escape
from pathlib import Path
from typing import IO

from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import exists

try:
    import fcntl
except ImportError:  # Windows
    _LOCKS = False
else:
    _LOCKS = True

_NOT_FLUSHED = (errno.EINVAL, errno.EBADF, errno.ENOTSUP, errno.EOPNOTSUPP, errno.ENOSYS)
"""What file systems that flush no folders answer."""
_UNFINISHED = re.compile(r"\..*\.[0-9a-f]{16}(?:\.[^.]*)?")
_FORGOTTEN_S = 3600.0
"""Age from which a temporary file is taken for forgotten where there are no locks."""


def check_target(path: PathLike, *, overwrite: bool = True) -> None:
    """Refuse a name under which no file can be, before any work is done for it; a symbolic link is followed.

    Whether the disk has room is found only when the file is written.

    Raises
    ------
    FileError
        There is such a file and it may not be replaced, what is there is no plain file, its folder does not exist or
        may not be written, or the file system takes no such name.
    """
    _existing_folder_of(path)
    try:
        mode = _mode_of(Path(path))
    except (OSError, ValueError) as error:  # ValueError: NUL in the name
        raise FileError(path, f"cannot be written: {getattr(error, 'strerror', None) or error}") from error
    if mode is not None and not overwrite:
        raise FileError(path, "exists already; choose another name, or --overwrite")
    check_folder_of(path)


def check_folder_of(path: PathLike) -> None:
    """Raise :class:`FileError` where the folder that is to hold ``path`` does not exist or may not be written.

    Windows says of every folder that it may be.
    """
    if not os.access(_existing_folder_of(path), os.W_OK):
        raise FileError(path, "its folder cannot be written")


def _existing_folder_of(path: PathLike) -> Path:
    """Return the folder in which ``path`` is written, of a link that of its file; FileError where it does not exist."""
    given = Path(path).absolute()
    folders = [given.parent]
    with contextlib.suppress(OSError, ValueError):
        if given.is_symlink():
            folders.append(Path(os.path.realpath(given)).parent)
    try:
        exist = all(folder.is_dir() for folder in folders)
    except OSError as error:  # a name that the file system does not take, a folder that may not be entered
        raise FileError(path, f"its folder cannot be used: {error.strerror or error}") from error
    if not exist:
        raise FileError(path, "its folder does not exist")
    return folders[-1]


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
        remove_unfinished(target)
        temporary, file = _unused(target)
        with file:
            if not _LOCKS:
                file.close()  # Windows renames no open file
            yield temporary
            with temporary.open("rb+") as written:
                if mode is not None:
                    temporary.chmod(mode)
                os.fsync(written.fileno())
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


def is_unfinished(path: Path) -> bool:
    """Return whether a name is that of a temporary file of :func:`replacing`: such a file is no document.

    >>> is_unfinished(Path(".blue.0123456789abcdef.brdfpaint")), is_unfinished(Path("blue.brdfpaint"))
    (True, False)
    """
    return _UNFINISHED.fullmatch(path.name) is not None


def documents_in(folder: Path, ending: str, *, within: bool = False) -> Iterator[Path]:
    """Yield the files of a folder, with ``within`` also of those in it, whose names have this ending.

    Raises :class:`FileError`: the file system refuses to look.
    """
    if not exists(folder):
        return iter(())
    found = folder.rglob(f"*{ending}") if within else folder.glob(f"*{ending}")
    return (path for path in found if not is_unfinished(path))


def remove_unfinished(target: Path, stem: str | None = None) -> None:
    """Remove what writers of the file ``target`` left that were ended by force; what one is writing now stays.

    A writer holds a lock on its temporary file, which the system frees with the process. ``stem`` is a pattern of
    :mod:`glob` in place of the target's name without its ending, where that changes with the content.
    """
    stem = escape(_short(target.stem)) if stem is None else stem
    try:
        beside = [
            path for path in target.parent.glob(f".{stem}.*{escape(target.suffix)}") if is_unfinished(path)
        ]
        for path in beside:
            if not stat.S_ISREG(path.lstat().st_mode):
                continue  # a pipe would be waited for without end
            with path.open("rb") as file:
                try:
                    forgotten = _lock(file) or time.time() - os.fstat(file.fileno()).st_mtime > _FORGOTTEN_S
                except BlockingIOError:
                    continue
                if forgotten and _LOCKS:
                    path.unlink(missing_ok=True)  # while it is locked: no writer can take it for its own
            if forgotten and not _LOCKS:
                path.unlink(missing_ok=True)
    except OSError:
        pass  # nothing that the task needs: the next writer tries again


def _unused(target: Path) -> tuple[Path, IO[bytes]]:
    """Make an empty temporary file beside ``target``, locked where there are locks; return its path and it, open."""
    while True:
        path = target.parent / f".{_short(target.stem)}.{secrets.token_hex(8)}{target.suffix}"
        # "x" refuses a file that is already there; the user's umask applies as to any new file.
        file = path.open("xb")
        try:
            if not _lock(file) or os.fstat(file.fileno()).st_nlink:
                return path, file
        except BlockingIOError:
            pass  # another writer takes it for a forgotten one, and removes it
        file.close()


def _short(stem: str) -> str:
    """Return as much of a name as leaves room for what is added: names have at most 255 bytes."""
    return os.fsencode(stem)[:80].decode("utf-8", "ignore")


def _lock(file: IO[bytes]) -> bool:
    """Lock an open file for this process, without waiting; False where there are no locks.

    Raises :class:`BlockingIOError`: another process has it.
    """
    if not _LOCKS:
        return False
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise
    except OSError:  # the file system knows no locks
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


def make_folder(folder: Path) -> None:
    """Make a folder, and those that it lies in, where there are none, and force their names to the disk.

    A file in a folder is lost with the name of the folder. Raises :class:`FileError`: it cannot be made.
    """
    try:
        missing = [one for one in (folder, *folder.parents) if not one.exists()]
        folder.mkdir(parents=True, exist_ok=True)
        for one in missing:
            sync_folder(one.parent)
    except (OSError, ValueError) as error:  # ValueError: NUL in the name
        raise FileError(folder, f"cannot be made: {getattr(error, 'strerror', None) or error}") from error


def sync_folder(folder: Path) -> None:
    """Flush the folder's own entry to disk, where the system supports it.

    It is passed over in a folder that may be written and not read, and on file systems that flush no folders: there
    the system alone decides when the name of a file reaches the disk. Raises :class:`OSError` on all other faults.
    """
    if os.name == "nt":
        return
    try:
        descriptor = os.open(folder, os.O_RDONLY)
    except PermissionError:
        return
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in _NOT_FLUSHED:
            raise
    finally:
        os.close(descriptor)
