"""Findings about a folder of photographs: the file, the reason, and the extent of the loss."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from brdf_suite.errors import FileError

Severity = Literal["fatal", "position", "exposure", "warning"]


@dataclass(frozen=True)
class SessionFinding:
    """One finding about the files of a folder.

    Attributes
    ----------
    severity
        ``fatal``: nothing can be made of the folder; ``position``, ``exposure``: this position, or this photograph of
        it, is left out; ``warning``: all is used.
    path
        The file, as it would be opened.
    reason
        What is wrong, starting in lower case, without a full stop.
    place
        The field of ``session.json`` that names the file; empty where there is none.
    position, exposure
        Their indices, where the finding is about one.
    """

    severity: Severity
    path: str
    reason: str
    place: str = ""
    position: int | None = None
    exposure: int | None = None

    def error(self) -> FileError:
        """Return the error for this finding."""
        return FileError(self.path, self.reason, self.place or None)

    def to_json(self) -> dict[str, object]:
        """Return the fields that are there."""
        return {name: value for name, value in vars(self).items() if value not in (None, "")}
