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


LIMITED_TIP = (
    "The time limit came first: this is the best answer at hand, and the exact one follows by itself."
)
FINAL_TIP = (
    "The time limit came first: this is the best answer that was found. There is no exact one to follow."
)


def large_error_tip(time_limited: bool, exact_follows: bool = False) -> str:
    """Return why the error is large; ``exact_follows``: the optimum is still looked for."""
    if time_limited:
        rest = (
            "the exact answer follows by itself." if exact_follows else "there is no exact answer to follow."
        )
        return f"ΔE00 above {LARGE_DELTA_E:g}: the fit ended at its time limit; {rest}"
    return (
        f"ΔE00 above {LARGE_DELTA_E:g}: no non-negative sum of the lobes reaches this colour. "
        "The picture shows what they do give."
    )


def fit_tips(worst_delta_e: float | None, time_limited: bool, exact_follows: bool) -> str:
    """Return what is to be known of a fit beside its number; empty where it is near and exact.

    ``worst_delta_e`` is None where there is no angle to compare at.
    """
    if worst_delta_e is not None and is_large(worst_delta_e):
        return large_error_tip(time_limited, exact_follows)
    if not time_limited:
        return ""
    return LIMITED_TIP if exact_follows else FINAL_TIP
