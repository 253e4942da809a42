"""The paints of a palette file, as entries that can be chosen."""

from __future__ import annotations

from brdf_qt.choosing.sources import Source
from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.pipeline.material import ENTRY_MARK, load_palette_file
from brdf_suite.progress import Progress, report

PALETTE_ENDINGS = (
    PALETTE_ENDING,
    *(".ase", ".aco", ".acb", ".act", ".gpl", ".kpl", ".sbz", ".soc", ".cxf", ".pal", ".csv", ".css"),
)
"""What the names of palette files end in; they are read by their content."""


def read_palette_sources(path: str, progress: Progress | None = None) -> list[Source]:
    """Return an entry for each colour of a palette, which is loaded by ``PATH#ID``; for a worker.

    Raises :class:`brdf_suite.errors.SuiteError` where the file cannot be read.
    """
    report(progress, 0.0, "reading")
    palette = load_palette_file(path).palette
    return [
        Source(f"{path}{ENTRY_MARK}{entry.id}", entry.name or entry.id, "palette", entry.content)
        for entry in palette
    ]
