"""Export of paints to other programs: a registry of formats, each with the losses of its conversion."""

from __future__ import annotations

from pathlib import Path

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.exports import csv_table, cxf3, gltf, json_document, luxcore, openpbr, rgl, usd_preview
from brdf_suite.files.exports.format import ExportFormat, ImportedPaints
from brdf_suite.regular_files import open_regular, within_memory

FORMATS: tuple[ExportFormat, ...] = (
    cxf3.FORMAT,
    csv_table.FORMAT,
    json_document.FORMAT,
    luxcore.FORMAT,
    openpbr.FORMAT,
    gltf.FORMAT,
    usd_preview.FORMAT,
    rgl.FORMAT,
)
"""In the order in which they are offered."""

_HEAD = 1 << 16
_LARGEST = 64 << 20


@within_memory
def read_paints(path: PathLike, formats: tuple[ExportFormat, ...] = FORMATS) -> ImportedPaints:
    """Return the paints in a file of any format that is read back, known by its content.

    Raises
    ------
    FileError
        It cannot be read, is of no such format, or is damaged; with the place. Nothing is partly read.
    """
    with open_regular(path, _LARGEST) as stream:
        head = stream.read(_HEAD)
    for known in formats:
        if known.sniff is not None and known.read is not None and known.sniff(head):
            return known.read(path)
    titles = ", ".join(known.title for known in formats if known.read is not None)
    raise FileError(Path(path), f"holds no paints in a format that is read here ({titles})")
