"""Where the programs of one user on one machine meet, and which of them is the relay.

The meeting place is a socket in a folder that only this user can enter. Beside it lies a lock file: the program that
holds the lock is the relay, and alone may remove a stale socket and listen. The operating system frees the
lock when its holder ends, however it ends, so there is never a second relay and never a lock to clean up.
"""

from __future__ import annotations

import getpass
import hashlib
import os
import stat
import tempfile
from pathlib import Path

from filelock import FileLock, Timeout

from brdf_suite import variables
from brdf_suite.errors import SuiteError

VERSION = 2
"""Of the link: what its messages are. Programs of different versions have different meeting places.

Version 1 (suite 0.1.0) numbers messages by the time of day, version 2 by the time since the machine was started.
"""
_LONGEST_SOCKET_PATH = 100


class LinkAddressError(SuiteError):
    """There is no folder for the socket that is safe from other users; programs then run unlinked."""


def link_name() -> str:
    """Return the name of the link: of this user, or what ``BRDF_SUITE_LINK`` says (for separate sessions)."""
    own = f"brdf-suite-{_user()}"
    wanted = os.environ.get(variables.LINK, "")
    if not wanted:
        return own
    safe = "".join(c if c.isascii() and (c.isalnum() or c in "-_.") else "_" for c in wanted)
    if safe != wanted or len(safe) > 40:
        safe = f"{safe[:20]}-{hashlib.sha256(wanted.encode()).hexdigest()[:12]}"
    return f"{own}-{safe}"


class LinkAddress:
    """Socket name and relay lock of one link, in this :data:`VERSION` of it.

    Parameters
    ----------
    name
        As from :func:`link_name`.

    Raises
    ------
    LinkAddressError
        No private folder could be made.
    """

    def __init__(self, name: str) -> None:
        folder = private_folder()
        name = f"{name}-v{VERSION}"
        path = folder / f"{name}.socket"
        if len(os.fsencode(path)) > _LONGEST_SOCKET_PATH:
            path = folder / f"{hashlib.sha256(name.encode()).hexdigest()[:16]}.socket"
        self.socket_name = str(path) if os.name == "posix" else name
        self._lock = FileLock(str(path.with_suffix(".lock")))

    def claim(self) -> bool:
        """Try to become the relay, without waiting; true where this program now is."""
        try:
            self._lock.acquire(blocking=False)
        except (Timeout, OSError):
            return False
        return True

    def give_up(self) -> None:
        """Stop being the relay."""
        self._lock.release()


def private_folder() -> Path:
    """Return a folder of this user alone, made where it is missing."""
    runtime = os.environ.get("XDG_RUNTIME_DIR", "")
    base = Path(runtime) if runtime and Path(runtime).is_dir() else Path(tempfile.gettempdir())
    folder = base / f"brdf-suite-{_user()}"
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        found = folder.lstat()
    except OSError as error:
        raise LinkAddressError(f"{folder}: the folder of the live link cannot be made ({error}).") from error
    if os.name == "posix" and (
        not stat.S_ISDIR(found.st_mode) or found.st_uid != os.getuid() or stat.S_IMODE(found.st_mode) & 0o077
    ):
        raise LinkAddressError(
            f"{folder}: other users can enter this folder, so the live link stays off; remove the folder."
        )
    return folder


def _user() -> str:
    return str(os.getuid()) if os.name == "posix" else getpass.getuser()
