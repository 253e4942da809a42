"""When the picture is drawn after an edit, so that no number waits for it: by how long its frames take here."""

from __future__ import annotations

from dataclasses import dataclass

FAST_MS = 8.0
"""A frame that takes no longer is drawn at once: numbers and picture together stay within one of the screen's."""
REST_MS = 40
FULL_REST_MS = 350
"""A pause in the middle of a drag, and one after it."""


@dataclass
class PicturePace:
    """The newest time of a whole frame, milliseconds; ``None``: not yet known."""

    full_ms: float | None = None

    def note(self, milliseconds: float) -> None:
        """Take the time of a whole frame, without what was uploaded before it."""
        self.full_ms = milliseconds

    def after_change(self) -> tuple[tuple[int, bool], ...]:
        """Return when to draw after the newest change: (milliseconds of rest, whether coarser), the earliest first.

        A whole frame that takes long waits for as long a rest: who goes on typing is not held up by it.

        >>> PicturePace(full_ms=3.0).after_change()
        ((0, False),)
        >>> PicturePace(full_ms=900.0).after_change()
        ((40, True), (900, False))
        """
        if self.full_ms is not None and self.full_ms <= FAST_MS:
            return ((0, False),)
        return ((REST_MS, True), (max(FULL_REST_MS, round(self.full_ms or 0.0)), False))
