"""Rich display in notebooks: a value shows the drawing that the library makes of it.

Values of every room can be displayed, and drawing stands above all rooms; so the library gives its function to this
module when it is first used. Without it a value has its plain text.
"""

from __future__ import annotations

from collections.abc import Callable

_drawers: list[Callable[[object], str]] = []


class Shown:
    """Base of values that have a picture in notebooks."""

    __slots__ = ()  # values of which there are many may have slots

    def _repr_html_(self) -> str | None:
        return _drawers[-1](self) if _drawers else None


def draw_with(drawer: Callable[[object], str]) -> None:
    """Have every :class:`Shown` value drawn by ``drawer``, which returns HTML."""
    _drawers[:] = [drawer]
