"""The entries of a palette that are nearest to a material."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.arrays import Floats
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.palettes.columns import MAIN_ANGLES_DEG, Columns, labs_of
from brdf_suite.palettes.search import Combine, nearest
from brdf_suite.palettes.swatches.look import colours_at
from brdf_suite.reflectance.material import Material


@dataclass(frozen=True)
class NearEntry:
    """An entry, its ΔE00 combined over the angles, and that at 15, 45 and 110°, NaN where a colour is not known."""

    entry: Entry
    delta_e: float
    per_angle: tuple[float, ...]


def colours_of_material(material: Material) -> Floats:
    """Return L*a*b* (3, 3) at 15, 45 and 110°: of a paint as its document has them, of all else as it reflects."""
    if material.document is not None:
        return labs_of(material.document)
    return working_to_lab(colours_at(material.reflectance, np.array(MAIN_ANGLES_DEG)))


def nearest_entries(
    palette: Palette, lab: Floats, count: int, combine: Combine = "mean"
) -> tuple[NearEntry, ...]:
    """Return the ``count`` entries nearest to L*a*b* (3, 3), the nearest first; errors as :func:`.nearest`."""
    found = nearest(Columns.of(palette.entries), lab, count, combine)
    rows = zip(found.indices.tolist(), found.delta_e.tolist(), found.per_angle.tolist(), strict=True)
    return tuple(NearEntry(palette.entries[place], total, tuple(each)) for place, total, each in rows)
