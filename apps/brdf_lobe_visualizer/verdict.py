"""Whether an error is good, visible or bad."""

from __future__ import annotations

from brdf_qt.fields.marks import Mark
from brdf_qt.program.translation import mark, tr

DELTA_E_LIMITS = (1.0, 3.0)
"""ΔE00 up to which an error is good, and up to which it is fair: hardly seen side by side; seen at once."""
RMS_LIMITS = (0.05, 0.20)
"""The same of a relative root mean square, where there is no colour to compare."""
_WORDS = {
    Mark.GOOD: mark("within tolerance"),
    Mark.WARNING: mark("visible difference"),
    Mark.BAD: mark("out of tolerance"),
}


def verdict_of(value: float, limits: tuple[float, float]) -> Mark:
    """Return the mark of an error; one that is not known is bad.

    >>> verdict_of(0.4, DELTA_E_LIMITS).name, verdict_of(22.78, DELTA_E_LIMITS).name
    ('GOOD', 'BAD')
    """
    if value <= limits[0]:
        return Mark.GOOD
    return Mark.WARNING if value <= limits[1] else Mark.BAD


def words_of(verdict: Mark) -> str:
    """Return a verdict in words."""
    return tr(_WORDS[verdict])
