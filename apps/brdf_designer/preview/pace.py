"""When the small picture is drawn after an edit, so that no number waits for it: by how long its frames take here."""

from __future__ import annotations

from dataclasses import dataclass

FAST_MS = 8.0
"""A frame that takes no longer is drawn at once: numbers and picture together stay within one of the screen's."""
BEARABLE_MS = 80.0
"""A draft that takes longer is not worth it: a hand that moves on would feel it."""
REST_MS = 40
FULL_REST_MS = 350
"""A pause in the middle of a drag, and one after it."""


@dataclass
class PreviewPace:
    """The newest times of a whole frame and of a draft (one sample a pixel), milliseconds; ``None``: not yet known."""

    full_ms: float | None = None
    draft_ms: float | None = None

    def note(self, milliseconds: float, *, draft: bool) -> None:
        """Take the time of a frame, without what was uploaded before it."""
        if draft:
            self.draft_ms = milliseconds
        else:
            self.full_ms = milliseconds

    def after_change(self) -> tuple[tuple[int, bool], ...]:
        """Return when to draw after the newest change: (milliseconds of rest, whether a draft), the earliest first.

        >>> PreviewPace(full_ms=3.0).after_change()
        ((0, False),)
        """
        if self.full_ms is not None and self.full_ms <= FAST_MS:
            return ((0, False),)
        if self.draft_ms is None or self.draft_ms <= BEARABLE_MS:
            return ((REST_MS, True), (FULL_REST_MS, False))
        return ((FULL_REST_MS, False),)
