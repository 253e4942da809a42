"""An export in a process of its own, from a thread of the window; an unfinished file is removed by that process."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from brdf_qt.work.command_process import run_command

from brdf_suite.appearance.difference.tolerance import Limits, Tolerances
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.progress import Progress, subrange

_LETTERS = {"difference": "E", "lightness": "L", "chroma": "C", "hue": "H"}


@dataclass(frozen=True)
class Request:
    """What is exported, and where to; ``standard`` and ``tolerances`` go into reports."""

    paint: Paint
    format: str
    path: Path
    pictures: bool = True
    standard: Paint | None = None
    tolerances: Tolerances | None = None


def run_export(request: Request, progress: Progress) -> tuple[str, ...]:
    """Write the file and return notes about it.

    Raises
    ------
    SuiteError
        What the command printed, or its exit status.
    Cancelled
        The progress callback asked for it; an old file stays.
    """
    with tempfile.TemporaryDirectory(prefix="brdf-handover-") as folder:
        paint = Path(folder) / "paint.brdfpaint"
        save_paint(request.paint, paint)
        words = ["export", str(paint), "--format", request.format, "-o", str(request.path), "--json"]
        if not request.pictures:
            words.append("--no-pictures")
        if request.standard is not None:
            standard = Path(folder) / "standard.brdfpaint"
            save_paint(request.standard, standard)
            words += ["--standard", str(standard), *tolerance_words(request.tolerances, request.paint)]
        try:
            done = json.loads(run_command(words, progress))
        except Cancelled:
            raise
        except SuiteError as error:
            raise SuiteError(f"The paint could not be exported: {error}") from error
        return tuple(str(note) for note in done["notes"])


@dataclass(frozen=True)
class Written:
    """What became of a file: the notes about it, or the error because of which it was not written."""

    path: Path
    notes: tuple[str, ...] = ()
    error: Exception | None = None


def run_exports(requests: Sequence[Request], progress: Progress) -> tuple[Written, ...]:
    """Write one file after the other; one that cannot be written does not hold up the others.

    Raises
    ------
    Cancelled
        The progress callback asked for it; files that are whole already stay.
    """
    done: list[Written] = []
    for request in requests:
        part = subrange(progress, len(done) / len(requests), (len(done) + 1) / len(requests))
        assert part is not None
        try:
            done.append(Written(request.path, run_export(request, part)))
        except Cancelled:
            raise
        except SuiteError as error:
            done.append(Written(request.path, error=error))
    return tuple(done)


def tolerance_words(tolerances: Tolerances | None, paint: Paint) -> list[str]:
    """Return the options of the command that ask for these tolerances, at the angles that the paint is read at."""
    if tolerances is None:
        return []
    words = ["--difference", tolerances.difference]
    read = {m.aspecular_deg for m in paint.measurements}
    limits: list[tuple[str, float | Limits | None]] = [
        (f"{angle:g}=", found) for angle, found in tolerances.by_angle.items() if angle in read
    ]
    limits.append(("", tolerances.otherwise))
    ellipsoid = False
    for at, found in limits:
        if found is None:
            continue
        parts = found if isinstance(found, Limits) else Limits(difference=found)
        named = [(letter, getattr(parts, name)) for name, letter in _LETTERS.items()]
        text = ",".join(f"{letter}{value!r}" for letter, value in named if value is not None)
        if text:
            words += ["--tolerance", at + text]
        ellipsoid = ellipsoid or parts.ellipsoid
    return [*words, "--ellipsoid"] if ellipsoid else words
