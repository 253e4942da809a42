"""Tag names of this suite's extensions in CxF3."""

from __future__ import annotations

GROUP, CODE, LABELS, USAGE, DATE, NOTES, FLAT = (
    "palette.group", "palette.code", "palette.tags", "palette.usage", "palette.date", "palette.notes", "palette.flat",
)  # fmt: skip
"""Of an entry."""
PALETTE, COLUMNS, COLOUR, GROUPS = "palette.name", "palette.columns", "palette.colour", "palette.groups"
"""Of the file, with ``palette.notes``."""
SPECTRA = "cxf.spectra"
"""Under this name an entry keeps the spectra of a multi-angle sample, so that they can go back."""
