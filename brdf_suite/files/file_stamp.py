"""What tells a file from what it was before, so that what was read of it may be kept."""

from __future__ import annotations

from pathlib import Path


def file_stamp(asked: object) -> tuple[int, int] | None:
    """Return time of change (ns) and size (bytes) of the file that a text names; None for what names no file."""
    if not isinstance(asked, str):
        return None
    try:
        status = Path(asked).stat()
    except (OSError, ValueError):  # a shipped name, or a file that whoever reads it will miss
        return None
    return status.st_mtime_ns, status.st_size
