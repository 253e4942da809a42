"""When the error of a fit is large, and how that is told: the same in every program."""

from __future__ import annotations

LARGE_DELTA_E = 1.0
"""ΔE00 above which two plain patches side by side are seen as different colours."""

MARK = "!"


def is_large(delta_e_2000: float) -> bool:
    """Return whether the fit misses a colour by more than an eye lets pass."""
    return delta_e_2000 > LARGE_DELTA_E


def marked(text: str, delta_e_2000: float) -> str:
    """Return ``text`` with a mark before it where the error is large: bold type alone may be overlooked."""
    return f"{MARK} {text}" if is_large(delta_e_2000) else text


def large_error_tip(time_limited: bool) -> str:
    """Return why the error is large."""
    if time_limited:
        return f"ΔE00 above {LARGE_DELTA_E:g}: the fit ended at its time limit before it came nearer."
    return (
        f"ΔE00 above {LARGE_DELTA_E:g}: no non-negative sum of the lobes reaches this colour. "
        "The picture shows what they do give."
    )
