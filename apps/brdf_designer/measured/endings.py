"""The endings of files that something can be read of, as a dialog's filter has them."""

from __future__ import annotations

from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.documents.store import PAINT_ENDING

CXF_ENDING = ".cxf"


def patterns(*more: str) -> str:
    """Return the patterns of every measured format and of ``more`` endings: ``*.bsdf *.brdf …``."""
    # Every reader comes with the list of formats; a start that opens no such dialog does without.
    from brdf_suite.files.measured import FORMATS

    endings = dict.fromkeys((*more, *(ending for known in FORMATS for ending in known.endings)))
    return " ".join(f"*{ending}" for ending in endings)


def standard_patterns() -> str:
    """Return the patterns of whatever may hold a standard."""
    return patterns(PAINT_ENDING, PALETTE_ENDING, CXF_ENDING, ".csv")
