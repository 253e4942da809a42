"""The stamp of a file, time of change and size: while it is the same, what was read may be kept."""

from __future__ import annotations

from pathlib import Path


def file_stamp(asked: object) -> tuple[int, int] | None:
    """Return time of change (ns) and size (bytes) of the file that a text names; None for what names no file."""
    if not isinstance(asked, str):
        return None
    try:
        status = Path(asked).stat()
    except (OSError, ValueError):  # a shipped name, or a file whose reader will report that it is missing
        return None
    return status.st_mtime_ns, status.st_size
