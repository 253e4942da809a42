"""What a patch shows of the standard: its colour beside the batch's, the difference, and whether it passes."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class StandardPatch:
    """One angle against the standard.

    ``rgb`` is the standard's sRGB code, ``None`` where it has no colour at this angle. ``forms`` are the difference
    and the verdict from the longest text to the shortest, ``words`` the difference in words, likewise. ``passes`` is
    ``None`` where the angle is not judged.
    """

    rgb: tuple[int, int, int] | None
    in_gamut: bool
    forms: tuple[str, ...]
    words: tuple[str, ...]
    passes: bool | None
    tip: str = ""
