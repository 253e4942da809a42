"""Write a file whole or not at all.

The bytes go to a temporary file in the same folder, are forced to the disk, and take the old file's place in
one step of the file system. Whatever happens before that step, the old file is as it was.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import stat
from pathlib import Path

from brdf_suite.errors import FileError


def write_atomically(path: str | os.PathLike[str], content: bytes) -> None:
    """Replace the file at ``path`` by ``content``, or raise :class:`FileError` and leave it untouched.

    A symbolic link is followed; the mode of an existing file is kept.
    """
    # A link to a file elsewhere must stay a link, so the file that it names is the one replaced.
    target = Path(os.path.realpath(path))
    temporary: Path | None = None
    try:
        mode = _mode_of(target)
        unused = target.parent / f".{target.name[:80]}.{secrets.token_hex(8)}.tmp"
        # "x" refuses a file that is already there; the user's umask applies as to any new file.
        with unused.open("xb") as file:
            temporary = unused
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        if mode is not None:
            temporary.chmod(mode)
        os.replace(temporary, target)  # noqa: PTH105 - tests interpose here as a full disk would
        temporary = None
        _sync_folder(target.parent)
    except OSError as error:
        raise FileError(path, f"cannot be written: {error.strerror or error}") from error
    finally:
        if temporary is not None:
            # Where even this fails, the first error is the one to tell.
            with contextlib.suppress(OSError):
                temporary.unlink()


def _mode_of(target: Path) -> int | None:
    """The mode of the old file, or None where there is none yet."""
    try:
        found = target.stat()
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(found.st_mode):
        raise OSError(0, "it is not a plain file")
    return stat.S_IMODE(found.st_mode)


def _sync_folder(folder: Path) -> None:
    """Force the folder's own entry to the disk, where the system knows that."""
    if os.name == "nt":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
