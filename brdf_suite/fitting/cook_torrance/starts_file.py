"""The ends of a fit's starts in a file, so that a fit that was broken off goes on where it was."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path

from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.errors import FileError

FORMAT = "brdf-suite starts of a lobe fit"
VERSION = 1
_LARGEST = 1 << 20


class StartsFile:
    """Keeps starts in ``path``; the file is made with the first start and may be deleted at any time."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def load(self, key: str) -> Mapping[int, list[float]]:
        """Return the ends that the file keeps for this key; none where there is no file, or it is another fit's.

        Raises
        ------
        FileError
            A file of this name holds something other than starts; it is left unchanged.
        """
        try:
            if self._path.stat().st_size > _LARGEST:
                raise FileError(self._path, "is no file of kept starts; name another one")
            text = self._path.read_text("utf-8")
        except FileNotFoundError:
            return {}
        except UnicodeDecodeError as error:
            raise FileError(self._path, "is no file of kept starts; name another one") from error
        except OSError as error:
            raise FileError(self._path, f"cannot be read: {error.strerror or error}") from error
        try:
            value = json.loads(text)
        except ValueError as error:
            raise FileError(self._path, "is no file of kept starts; name another one") from error
        if not isinstance(value, dict) or value.get("format") != FORMAT:
            raise FileError(self._path, "is no file of kept starts; name another one", "format")
        if value.get("version") != VERSION or value.get("key") != key:
            return {}
        return _ends(value.get("ends"))

    def save(self, key: str, ends: Mapping[int, list[float]]) -> None:
        """Write the ends of the fit of this key; raise :class:`FileError` where that fails."""
        value = {
            "format": FORMAT,
            "version": VERSION,
            "key": key,
            "ends": {str(number): list(x) for number, x in ends.items()},
        }
        write_atomically(self._path, encode(value))

    def remove(self) -> None:
        """Delete the file, which is of no use once the fit is done."""
        try:
            self._path.unlink(missing_ok=True)
        except OSError as error:
            raise FileError(self._path, f"cannot be removed: {error.strerror or error}") from error


def _ends(value: object) -> dict[int, list[float]]:
    """Those of the entries that are what was written; a start that is not is searched again."""
    found: dict[int, list[float]] = {}
    if not isinstance(value, dict):
        return found
    for name, numbers in value.items():
        if not (str(name).isdecimal() and isinstance(numbers, list)):
            continue
        if all(isinstance(x, (int, float)) and not isinstance(x, bool) and math.isfinite(x) for x in numbers):
            found[int(name)] = [float(x) for x in numbers]
    return found
