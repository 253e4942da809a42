"""When the error of a fit is large, and how that is reported: the same in every program."""

from __future__ import annotations

from brdf_qt.fields.marks import Mark
from brdf_qt.program.translation import decimal, mark, tr

LARGE_DELTA_E = 1.0
"""ΔE00 above which two plain patches side by side are seen as different colours."""


def is_large(delta_e_2000: float) -> bool:
    """Return whether the fit misses a colour by more than an eye lets pass."""
    return delta_e_2000 > LARGE_DELTA_E


def fit_mark(worst_delta_e: float | None, time_limited: bool = False) -> Mark | None:
    """Return the mark of a fit: its error is large, or the time limit stopped it; None where neither is.

    ``worst_delta_e`` is its largest ΔE00, at the readings and between them; None where there is nothing to compare.
    """
    if worst_delta_e is not None and is_large(worst_delta_e):
        return Mark.BAD
    return Mark.LIMITED if time_limited else None


LIMITED_TIP = mark(
    "The fit reached its time limit. This is the best result so far; the exact one follows automatically."
)
FINAL_TIP = mark(
    "The fit reached its time limit. This is the best result that was found; no exact one will follow."
)


def large_error_tip(time_limited: bool, exact_follows: bool = False) -> str:
    """Return why the error is large; ``exact_follows``: the optimum is still looked for."""
    if time_limited and exact_follows:
        text = tr(
            "ΔE00 above {limit}: the fit reached its time limit; the exact result follows automatically."
        )
    elif time_limited:
        text = tr("ΔE00 above {limit}: the fit reached its time limit; no exact result will follow.")
    else:
        text = tr(
            "ΔE00 above {limit}: no non-negative sum of the lobes reaches this colour. The picture shows what they "
            "do give."
        )
    return text.format(limit=decimal(f"{LARGE_DELTA_E:g}"))


def fit_tips(worst_delta_e: float | None, time_limited: bool, exact_follows: bool) -> str:
    """Return what is to be known of a fit beside its number; empty where it is near and exact.

    ``worst_delta_e`` is None where there is no angle to compare at.
    """
    if worst_delta_e is not None and is_large(worst_delta_e):
        return large_error_tip(time_limited, exact_follows)
    if not time_limited:
        return ""
    return tr(LIMITED_TIP) if exact_follows else tr(FINAL_TIP)
