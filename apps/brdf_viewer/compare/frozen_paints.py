"""Paints that were frozen to be compared with: kept as files beside the settings, so that a view can name them."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
from collections.abc import Collection
from pathlib import Path

from brdf_qt.program.settings import state_folder
from brdf_qt.program.translation import tr

from brdf_suite.documents.store import PAINT_ENDING, AnyPaint, paint_to_json, save_paint

_FOLDER = "frozen"
_HASH = 8
MOST_KEPT = 32


def freeze(paint: AnyPaint | None, key: str, used: Collection[str | None] = ()) -> str:
    """Return what a view calls this paint: a file of its own; ``key`` for a measured file, which is never edited.

    Of the files that are kept the one that was looked at longest ago goes first, but none of ``used``.

    Raises :class:`FileError` where the file cannot be written.
    """
    if paint is None:
        return key
    folder = state_folder(_FOLDER)
    text = json.dumps(paint_to_json(paint), sort_keys=True)
    stem = re.sub(r"[^\w\- ]+", "_", paint.name).strip(" _")[:60] or "paint"
    path = folder / f"{stem}-{hashlib.sha256(text.encode()).hexdigest()[:_HASH]}{PAINT_ENDING}"
    if not path.exists():
        save_paint(paint, path)
        _forget_oldest(folder, {*used, str(path.absolute())})
    touch(str(path.absolute()))
    return str(path.absolute())


def touch(key: str) -> None:
    """A paint is on show: where it is a frozen one it is young again."""
    if frozen_title(key) is not None:
        with contextlib.suppress(OSError):  # a file that is gone or read-only is reported elsewhere
            os.utime(key)


def frozen_title(key: str) -> str | None:
    """Return what a frozen paint is called in a list; None for any other key.

    >>> frozen_title("blue") is None
    True
    """
    path = Path(key)
    if path.parent.name != _FOLDER or path.parent != state_folder(_FOLDER).absolute():
        return None
    return tr("{name} (frozen)").format(name=path.stem[: -_HASH - 1])


def _forget_oldest(folder: Path, used: Collection[str | None]) -> None:
    files = sorted(folder.glob(f"*{PAINT_ENDING}"), key=lambda file: file.stat().st_mtime, reverse=True)
    for file in files[MOST_KEPT:]:
        if str(file.absolute()) not in used:
            file.unlink(missing_ok=True)
            # A factored paint has its textures beside it, named after it.
            for textures in folder.glob(f"{file.stem}-*.exr"):
                textures.unlink(missing_ok=True)
