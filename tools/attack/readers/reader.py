"""A reader of files as the harness calls it, and the files that it is given damaged."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.errors import FileError, SuiteError

MEGABYTE = 1 << 20
REFUSALS: tuple[type[Exception], ...] = (SuiteError,)
LONGEST_MESSAGE = 2300
"""Characters; what cannot be seen in a message is shown by the windows and the command."""


class WrongValueError(Exception):
    """A reader returned what it promises not to return; the text says what."""


@dataclass(frozen=True)
class Reader:
    """A reader.

    Parameters
    ----------
    name
        ``group:kind``, as the table and ``--only`` have it.
    read
        Reads one file and raises :class:`WrongValueError` where the value is not as promised.
    make
        Writes undamaged files into an empty folder and returns them; companions (textures, buffers) may lie beside.
    has_place
        Every refusal names a place in the file.
    memory
        Bytes that one reading may take; beside them three times the file.
    refusals
        The exceptions by which it refuses.
    outside
        A library of others, which dies with its own process: its death is counted and is no crash.
    """

    name: str
    read: Callable[[Path], object]
    make: Callable[[Path], list[Path]]
    has_place: bool = False
    memory: int = 256 * MEGABYTE
    refusals: tuple[type[Exception], ...] = REFUSALS
    outside: bool = False


def outcome(reader: Reader, path: Path) -> str:
    """Read a file; return ``read`` or ``refused``, or what went wrong, in words."""
    try:
        reader.read(path)
    except reader.refusals as error:
        text = str(error)
        if "not enough memory" in text:
            return "over the memory bound, refused"
        # That a file is too large is said of the whole of it.
        placed = getattr(error, "place", None) or "that this format can need" in text
        if reader.has_place and isinstance(error, SuiteError) and not placed:
            return f"no place in the message {text!r}"[:300]
        # The file's own name may be as long as a system allows.
        own = error.path if isinstance(error, FileError) else ""
        good = len(text) - len(own) < LONGEST_MESSAGE
        return "refused" if good else f"message {text!r}"[:300]
    except MemoryError:
        return "MemoryError"
    except Exception as error:  # noqa: BLE001 - finding these is what this program is for
        return f"{type(error).__name__}: {error}"[:300]
    return "read"


def text_files(**files: str | bytes) -> Callable[[Path], list[Path]]:
    """Return what writes files: ``name__ending`` stands for ``name.ending``."""

    def make(folder: Path) -> list[Path]:
        paths = []
        for name, content in files.items():
            paths.append(folder / name.replace("__", "."))
            paths[-1].write_bytes(content.encode() if isinstance(content, str) else content)
        return paths

    return make
