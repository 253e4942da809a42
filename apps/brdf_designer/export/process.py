"""An export in a process of its own, from a thread of the window: drawing and fitting hold the interpreter.

It is the suite's command; it reports its steps as lines of JSON and stops when its input is closed, so it also
ends with Designer, however that ends. An unfinished file is removed by the process that writes it.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.appearance.difference.tolerance import Limits, Tolerances
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress

_CANCELLED = 130
_PATIENCE_S = 20.0
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
        What the command said, or that it ended without a word.
    Cancelled
        The progress callback asked for it; an old file stays.
    """
    with tempfile.TemporaryDirectory(prefix="brdf-handover-") as folder:
        paint = Path(folder) / "paint.brdfpaint"
        save_paint(request.paint, paint)
        words = child_command("brdf_suite.cli.main", "export", str(paint))
        words += ["--format", request.format, "-o", str(request.path), "--json", "--follow"]
        if not request.pictures:
            words.append("--no-pictures")
        if request.standard is not None:
            standard = Path(folder) / "standard.brdfpaint"
            save_paint(request.standard, standard)
            words += ["--standard", str(standard), *tolerance_words(request.tolerances, request.paint)]
        with (Path(folder) / "said").open("w+b") as said:
            return _run(words, said.fileno(), Path(folder) / "said", progress)


def _run(words: list[str], said: int, heard: Path, progress: Progress) -> tuple[str, ...]:
    process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=said)
    assert process.stdin is not None
    assert process.stdout is not None
    lines: list[str] = []
    try:
        for line in process.stdout:
            text = line.decode("utf-8", errors="replace")
            step = _step(text)
            if step is None:
                lines.append(text)
            else:
                progress(*step)
        status = process.wait()
    finally:
        # Where the window has asked to stop: its input ends, and it takes its unfinished file along.
        process.stdin.close()
        if process.poll() is None:
            try:
                process.wait(_PATIENCE_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        process.stdout.close()
    if status == _CANCELLED:
        raise Cancelled
    if status != 0:
        last = heard.read_text(encoding="utf-8", errors="replace").strip().splitlines()[-1:]
        why = last[0].removeprefix("brdf-suite: ") if last else f"it ended with status {status}."
        raise SuiteError(f"The paint could not be exported: {why}")
    done = json.loads("".join(lines))
    return tuple(str(note) for note in done["notes"])


def _step(line: str) -> tuple[float, str] | None:
    """The fraction and what is being done, where a line reports a step."""
    try:
        value = json.loads(line)
        return float(value["fraction"]), str(value["what"])
    except (ValueError, KeyError, TypeError):
        return None


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
