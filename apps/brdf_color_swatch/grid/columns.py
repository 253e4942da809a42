"""Figures of entries with the colours that a screen shows; an edit costs those that it changed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from brdf_color_swatch.grid.rows import Rows
from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, lab_to_working, srgb_encode
from brdf_suite.documents.palette import Entry
from brdf_suite.palettes.columns import ColumnsWork
from brdf_suite.progress import Progress

_STEP = 25


def rows_of(entries: Sequence[Entry], before: Rows | None = None) -> Rows:
    """Return the rows of entries, with what is read; what ``before`` has of the same contents is taken from it."""
    work = ColumnsWork(entries, known=None if before is None else before.columns)
    columns = work.columns
    codes = np.empty((len(columns), 3, 3), np.uint8)
    known = {} if before is None else {id(e.content): place for place, e in enumerate(before.entries)}
    places = np.fromiter((known.get(id(e.content), -1) for e in columns.entries), int, len(columns))
    kept = places >= 0
    if before is not None:
        codes[kept] = before.codes[places[kept]]
    codes[~kept] = codes_of(columns.main[~kept])
    return Rows(columns, codes)


def finish_rows(rows: Rows, progress: Progress) -> Rows:
    """Return rows with what was not read worked out from the reflectances: a millisecond a paint, for a thread."""
    work = ColumnsWork(rows.entries, known=rows.columns)
    whole = max(1, work.left)
    while work.step(_STEP):
        progress(1.0 - work.left / whole, "")
    columns = work.columns
    return Rows(columns, codes_of(columns.main))


def codes_of(lab: np.ndarray) -> np.ndarray:
    """Return sRGB codes (..., 3) of L*a*b* (D65, 10°), clipped to what a screen shows; mid grey where it is NaN."""
    linear = lab_to_working(np.nan_to_num(lab)) @ WORKING_TO_SRGB.T
    codes = np.rint(255.0 * srgb_encode(np.clip(linear, 0.0, 1.0))).astype(np.uint8)
    codes[~np.isfinite(lab).all(axis=-1)] = 119
    return codes
