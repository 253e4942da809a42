"""Export of paints to other programs: a registry of formats, each with the losses of its conversion."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.exports import csv_table, cxf3, gltf, json_document, luxcore, openpbr, rgl, usd_preview
from brdf_suite.files.exports.format import ExportFormat, ImportedPaints
from brdf_suite.plugins import Call, Registry
from brdf_suite.regular_files import open_regular, within_memory

_BUILT_IN = (
    cxf3.FORMAT,
    csv_table.FORMAT,
    json_document.FORMAT,
    luxcore.FORMAT,
    openpbr.FORMAT,
    gltf.FORMAT,
    usd_preview.FORMAT,
    rgl.FORMAT,
)
REPORTS = ("html", "pdf")
"""Names of the reports, which are made of several rooms (:mod:`brdf_suite.reports`) and offered beside the exports."""


def _are_sentences(found: object) -> bool:
    return isinstance(found, tuple) and all(isinstance(sentence, str) for sentence in found)


FORMATS = Registry(
    "brdf_suite.exports",
    ExportFormat,
    _BUILT_IN,
    calls={
        "losses": Call(_are_sentences, "a tuple of sentences"),
        "write": Call(_are_sentences, "a tuple of sentences"),
        "read": Call(lambda found: isinstance(found, ImportedPaints), "ImportedPaints"),
        "sniff": Call(lambda found: isinstance(found, bool), "True or False", False),
    },
    endings=lambda known: (known.ending,),
    reserved=REPORTS,
)
"""In the order in which they are offered, those of plug-ins last."""

_HEAD = 1 << 16
_LARGEST = 64 << 20


@within_memory
def read_paints(path: PathLike, formats: Sequence[ExportFormat] = FORMATS) -> ImportedPaints:
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
