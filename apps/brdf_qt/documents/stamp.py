"""What a file held when it was read or written last, to notice that another program has changed it since."""

from __future__ import annotations

import hashlib
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from brdf_suite.errors import FileError
from brdf_suite.regular_files import open_regular

_LARGEST_READ = 64 << 20
"""Bytes of content that are read for a stamp: it is taken on the thread of the window."""


@dataclass(frozen=True)
class FileStamp:
    """Size in bytes, time of the last change in ns, and SHA-256 of the content.

    ``digest`` is empty where the content was not readable. Of a file over 64 MiB it is made of size, time and number of
    the file (inode), and none of the content.
    """

    size: int
    mtime_ns: int
    digest: str

    def same_content(self, other: FileStamp) -> bool:
        """Whether both files hold the same; by time and size alone where a content could not be read.

        A file that was copied or touched has another time, and yet nothing in it would be lost.
        """
        if self.digest and other.digest:
            return self.digest == other.digest
        return (self.size, self.mtime_ns) == (other.size, other.mtime_ns)

    def to_json(self) -> dict[str, Any]:
        """Return the stamp as a JSON object; :meth:`from_json` is the inverse."""
        return asdict(self)

    @classmethod
    def from_json(cls, value: dict[str, Any]) -> FileStamp:
        """Return the stamp of a JSON object; raise ValueError, KeyError or TypeError where it is none."""
        return cls(int(value["size"]), int(value["mtime_ns"]), str(value["digest"]))


def stamp_of(path: Path) -> FileStamp | None:
    """Return the stamp of a file as it is now; ``None`` where there is nothing at ``path``."""
    try:
        found = path.stat()
    except OSError:  # Not there, or not to be looked at: writing will report what is wrong with it.
        return None
    if found.st_size > _LARGEST_READ:
        return FileStamp(
            found.st_size, found.st_mtime_ns, f"{found.st_size} {found.st_mtime_ns} {found.st_ino}"
        )
    try:
        with open_regular(path, _LARGEST_READ) as stream:
            digest = hashlib.file_digest(stream, "sha256").hexdigest()
    except FileError:  # It may still be replaced as a whole; size and time then have to do.
        digest = ""
    return FileStamp(found.st_size, found.st_mtime_ns, digest)


def is_changed(path: Path, known: FileStamp | None) -> bool:
    """Whether a file holds something else than is known of it, so that writing it would lose that; also where nothing
    is known of it.
    """
    present = stamp_of(path)
    return present is not None and (known is None or not known.same_content(present))
