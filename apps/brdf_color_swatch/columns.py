"""Figures of entries as arrays; an edit costs those that it changed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from brdf_color_swatch.rows import ANGLES_DEG, Rows, gloss_of
from brdf_suite.appearance.colorimetry import WORKING_TO_SRGB, lab_to_working, srgb_encode
from brdf_suite.appearance.flat_colours import flat_labs
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry

_SAME_ANGLE_DEG = 0.5


def rows_of(entries: Sequence[Entry], before: Rows | None = None) -> Rows:
    """Return the rows of some entries; what ``before`` has already of the same contents is taken from it."""
    entries = tuple(entries)
    before = before if before is not None else Rows.empty()
    known = {id(entry.content): place for place, entry in enumerate(before.entries)}
    count = len(entries)
    places = np.fromiter((known.get(id(entry.content), -1) for entry in entries), int, count)
    lab = np.full((count, 3, 3), np.nan)
    gloss, flop = np.full(count, np.nan), np.full(count, np.nan)
    codes = np.full((count, 3, 3), 119, np.uint8)
    kept = places >= 0
    for target, source in (
        (lab, before.lab),
        (gloss, before.gloss),
        (flop, before.flop),
        (codes, before.codes),
    ):
        target[kept] = source[places[kept]]
    new = np.flatnonzero(~kept)
    if len(new):
        fresh = [entries[place] for place in new]
        lab[new] = readings(fresh)
        gloss[new] = [gloss_of(entry) for entry in fresh]
        flop[new] = flops(lab[new])
        codes[new] = codes_of(lab[new])
    return Rows(entries, lab, gloss, flop, codes)


def codes_of(lab: np.ndarray) -> np.ndarray:
    """Return sRGB codes (..., 3) of L*a*b* (D65, 10°), clipped to what a screen shows; mid grey where it is NaN."""
    linear = lab_to_working(np.nan_to_num(lab)) @ WORKING_TO_SRGB.T
    codes = np.rint(255.0 * srgb_encode(np.clip(linear, 0.0, 1.0))).astype(np.uint8)
    codes[~np.isfinite(lab).all(axis=-1)] = 119
    return codes


def readings(entries: Sequence[Entry]) -> np.ndarray:
    """Return L*a*b* (n, 3, 3) at :data:`~brdf_color_swatch.rows.ANGLES_DEG`, NaN where a paint is not read."""
    lab = np.full((len(entries), 3, 3), np.nan)
    flat = [place for place, entry in enumerate(entries) if isinstance(entry.content, FlatColour)]
    if flat:
        colours = [entries[place].content for place in flat]
        lab[flat] = flat_labs([colour for colour in colours if isinstance(colour, FlatColour)])[:, None, :]
    for place, entry in enumerate(entries):
        if isinstance(entry.content, Paint):
            light = entry.content.main_light_deg
            for one in entry.content.measurements:
                for number, angle in enumerate(ANGLES_DEG):
                    if one.illumination_deg == light and abs(one.aspecular_deg - angle) <= _SAME_ANGLE_DEG:
                        lab[place, number] = one.lab
    return lab


def flops(lab: np.ndarray) -> np.ndarray:
    """Return the flop index (n,) of L*a*b* (n, 3, 3); NaN where a reading is missing, 0 where it turns round."""
    l15, l45, l110 = lab[:, 0, 0], lab[:, 1, 0], lab[:, 2, 0]
    with np.errstate(invalid="ignore", divide="ignore"):
        found = 2.69 * np.maximum(l15 - l110, 0.0) ** 1.11 / np.maximum(l45, 1e-6) ** 0.86
    return np.where(np.isfinite(l15 - l110 + l45), found, np.nan)
