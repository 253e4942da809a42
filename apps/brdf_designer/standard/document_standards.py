"""What is kept of the standard of one document, and the files that standards are loaded from."""

from __future__ import annotations

from dataclasses import dataclass, field

from brdf_designer.standard.records import Record
from brdf_suite.documents.paint import Paint
from brdf_suite.paint_design.standard import Standard
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.progress import Progress

MOST_READ_AHEAD = 20


@dataclass(frozen=True)
class Swap:
    """Paint and standard before and after they changed places; undo brings both back."""

    paint_before: Paint
    standard_before: Standard
    paint_after: Paint
    standard_after: Standard


@dataclass(frozen=True)
class Request:
    """A file to load, and where (illumination, aspecular angle) it is going to be read."""

    path: str
    geometries: tuple[tuple[float, float], ...]


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


def load_request(request: Request, progress: Progress) -> tuple[Standard, ...]:
    """Read the standards of a file, and what they will be asked for; on a thread."""
    found = load_standards(request.path, progress)
    # What has to be measured of it is measured here, and not in the first edit that is judged.
    for standard in found[:MOST_READ_AHEAD]:
        for illumination, aspecular in request.geometries:
            standard.lab_at(illumination, aspecular)
    return found
