"""Marks of states: each has a shape of its own and a colour, so that either alone says which it is.

A mark stands before a text, in a cell of a table or in a list; its word is for screen readers and tips.
"""

from __future__ import annotations

from enum import Enum

from PySide6.QtCore import QRect
from PySide6.QtGui import QIcon, QPainter

from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr

SIZE = 14
"""Height and width of a mark in a line of text, pixels."""


class Mark(Enum):
    """A state that is marked: the icon, the kind of colour, and the word."""

    GOOD = ("check-circle-fill", "good", mark("passes"))
    WARNING = ("warning-fill", "warning", mark("warning"))
    BAD = ("x-square-fill", "bad", mark("fails"))
    LIMITED = ("hourglass-medium-fill", "warning", mark("stopped by the time limit"))
    OUTSIDE = ("eye-slash-fill", "warning", mark("cannot be shown on this screen"))
    CHANGED = ("swap-fill", "warning", mark("changed"))

    @property
    def word(self) -> str:
        """What it says, translated."""
        return tr(self.value[2])

    @property
    def icon(self) -> QIcon:
        """Its shape in its colour, as the theme has it."""
        name, kind, _word = self.value
        return icon(name, kind)


def draw_mark(painter: QPainter, what: Mark, x: float, middle: float) -> None:
    """Draw a mark with its left edge at ``x``, about the height ``middle``."""
    what.icon.paint(painter, QRect(round(x), round(middle - SIZE / 2), SIZE, SIZE))


def verdict_mark(passes: bool | None) -> Mark | None:
    """Return the mark of a verdict, None where nothing was judged."""
    return None if passes is None else Mark.GOOD if passes else Mark.BAD
