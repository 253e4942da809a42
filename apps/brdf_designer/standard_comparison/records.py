"""The standards of a document; the one that it was last judged by is kept beside the settings for each file.

A record has the chosen standard itself (its paint, or its readings), so that it is there at once and also where the
file it came from has gone; and that file, from which the others of it and a measured reflectance are read again.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from brdf_qt.program.settings import state_folder

from brdf_suite.documents.atomic import documents_in, write_atomically
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.documents.store import paint_from_json, paint_to_json
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.paint_design.standard import Standard
from brdf_suite.regular_files import read_bytes

MOST_RECORDS = 500
_FOLDER = "standards"


@dataclass(frozen=True)
class Record:
    """A standard, the file or name that it was loaded from ("" where from none), and its place in it."""

    standard: Standard
    source: str = ""
    chosen: int = 0

    def is_of(self, found: Sequence[Standard]) -> bool:
        """Return whether it is still what stands at its place among the standards that were found in its file."""
        if not 0 <= self.chosen < len(found):
            return False
        one = found[self.chosen]
        if one.reflectance is not None:
            # Of a measured one only the name can be compared without measuring it again.
            return one.name == self.standard.name and self.standard.paint is None
        same = self.standard
        return (one.name, one.paint, one.readings) == (same.name, same.paint, same.readings)

    def to_json(self) -> dict[str, Any]:
        """Return it as plain values; what was read of a measured reflectance is stored as readings."""
        one = self.standard
        plain: dict[str, Any] = {"source": self.source, "chosen": self.chosen, "name": one.name}
        plain |= {"origin": one.origin, "notices": list(one.notices)}
        if one.paint is not None:
            return {**plain, "paint": paint_to_json(one.paint)}
        readings = [(m.illumination_deg, m.aspecular_deg, *m.lab) for m in one.readings]
        readings += [(*place, *lab) for place, lab in one.computed().items()]
        gloss = None if one.gloss is None else asdict(one.gloss)
        return {**plain, "readings": readings, "gloss": gloss, "measured": one.reflectance is not None}


def record_from_json(plain: Any) -> Record | None:
    """Return what :meth:`Record.to_json` returned; ``None`` for anything else."""
    try:
        name, origin = str(plain["name"]), str(plain["origin"])
        notices = tuple(map(str, plain["notices"]))
        if "paint" in plain:
            paint = paint_from_json(plain["paint"])
            standard = Standard(name, origin, paint.measurements, paint.gloss, paint, None, notices)
        else:
            gloss = None if plain["gloss"] is None else Gloss(**plain["gloss"])
            standard = Standard(name, origin, tuple(map(_reading, plain["readings"])), gloss, notices=notices)
        return Record(standard, str(plain["source"]), int(plain["chosen"]))
    except (ArithmeticError, KeyError, TypeError, ValueError, SuiteError):
        # Another version's, or damaged: then the paint has no standard, as if none had been kept.
        return None


def _reading(row: Any) -> Measurement:
    light, angle, lightness, a, b = map(float, row)
    return Measurement(light, angle, (lightness, a, b))


def keep(path: Path, record: Record | None) -> None:
    """Keep the record of the paint in file ``path``; ``None``: it has no standard. FileError where that fails."""
    file = _file(path)
    if record is None:
        try:
            file.unlink(missing_ok=True)
        except OSError as error:
            raise FileError(file, f"cannot be removed: {error.strerror or error}") from error
        return
    write_atomically(file, json.dumps({"file": str(path), **record.to_json()}).encode())
    records = sorted(documents_in(file.parent, ".json"), key=lambda one: one.stat().st_mtime, reverse=True)
    for old in records[MOST_RECORDS:]:
        old.unlink(missing_ok=True)


def kept(path: Path) -> Record | None:
    """Return the record of the paint in file ``path``; ``None`` where there is none."""
    try:
        plain = json.loads(read_bytes(_file(path)))
    except (FileError, ValueError, RecursionError):
        # Most paints have none; a damaged one is as good as none.
        return None
    return record_from_json(plain)


def _file(path: Path) -> Path:
    name = hashlib.sha256(str(path.absolute()).encode("utf-8", "surrogateescape")).hexdigest()[:32]
    return state_folder(_FOLDER) / f"{name}.json"


@dataclass(frozen=True)
class Swap:
    """Paint and standard before and after they changed places; undo brings both back."""

    paint_before: Paint
    standard_before: Standard
    paint_after: Paint
    standard_after: Standard


@dataclass
class DocumentStandards:
    """What is kept for one document; ``awaited`` is of an earlier run, and its ``source`` not read again yet."""

    standards: tuple[Standard, ...] = ()
    chosen: int = 0
    source: str = ""
    awaited: Record | None = None
    batches: tuple[Paint, ...] = ()
    swaps: list[Swap] = field(default_factory=list)

    @property
    def standard(self) -> Standard | None:
        return self.standards[self.chosen] if self.standards else None

    def record(self) -> Record | None:
        """Return the standard, to be kept for the next run; ``None`` where there is none."""
        if self.standard is None:
            return None
        return self.awaited or Record(self.standard, self.source, self.chosen)
