"""How long a traced frame takes: the median of the last few, for a number that can be read."""

from __future__ import annotations

from collections import deque
from statistics import median

_FRAMES = 7


class FrameRate:
    """Takes the seconds of each frame."""

    def __init__(self) -> None:
        self._frames: deque[float] = deque(maxlen=_FRAMES)

    def add(self, seconds: float) -> None:
        """Count one frame."""
        self._frames.append(seconds)

    def clear(self) -> None:
        """Begin anew: with another renderer, or another quality."""
        self._frames.clear()

    @property
    def frame_s(self) -> float:
        """Seconds of a frame; 0 before the first."""
        return median(self._frames) if self._frames else 0.0
