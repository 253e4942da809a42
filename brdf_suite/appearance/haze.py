"""Haze: light that a nearly glossy surface scatters just beside the mirror direction."""

from __future__ import annotations


def haze_units(gu_20: float, gu_60: float) -> float:
    """Return the haze index G60 - G20, gloss units.

    The difference of the two gloss readings, as practice reads ASTM D4039; from expert memory, not read in the
    standard. It grows where the narrow 20° receptor loses light that the wide 60° receptor still sees; a smooth
    clear coat of index 1.5 already has about 12, because its 60° reading is higher.

    >>> haze_units(82.0, 94.0)
    12.0
    """
    return gu_60 - gu_20
