"""Progress reports and cancellation of long functions.

A long function takes ``progress: Progress | None``. It calls ``progress(fraction, what)`` with a fraction
from 0 to 1 and a few words, often enough for a bar to move. The callback cancels the work by raising
:class:`brdf_suite.errors.Cancelled`; the function lets it pass and leaves nothing half done.
"""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[float, str], None]


def report(progress: Progress | None, fraction: float, what: str) -> None:
    """Call ``progress`` where there is one; ``fraction`` is clipped to 0…1."""
    if progress is not None:
        progress(min(1.0, max(0.0, fraction)), what)


def subrange(progress: Progress | None, start: float, end: float) -> Progress | None:
    """Return a callback that maps 0…1 onto ``start``…``end`` of ``progress``, for one step of several."""
    if progress is None:
        return None

    def mapped(fraction: float, what: str) -> None:
        report(progress, start + (end - start) * fraction, what)

    return mapped


def stage(progress: Progress | None, start: float, end: float, name: str) -> Progress | None:
    """As :func:`subrange`, for a step that a user knows by ``name``: its words follow the name and a colon."""
    within = subrange(progress, start, end)
    if within is None:
        return None
    report(within, 0.0, name)

    def named(fraction: float, what: str) -> None:
        report(within, fraction, f"{name}: {what}")

    return named
