"""Where the pictures of a grid and its scale bar go, so that they are as large as the room lets them be.

A grid may be turned, its rows becoming columns, and its bar may stand at the right or lie below: of the four ways the
one with the largest pictures is taken; the grid as it was asked for where the others gain little.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QRectF

GAP = 8.0
BAR = 12.0
_GAINS = 1.15
"""Another way than the first is taken where pictures become so much larger."""


@dataclass(frozen=True)
class Room:
    """What texts need, in pixels: a line's height, the widths of a row's title, of ticks at the left and at the bar."""

    line: float
    titled_rows: bool
    titled_columns: bool
    y_ticks: float
    y_name: bool
    x_ticks: bool
    x_name: bool
    bar_ticks: float | None
    """None where there is no bar."""


@dataclass(frozen=True)
class Layout:
    """``side`` of a picture, the first one's corner, whether rows and columns are ``turned``, where the bar is."""

    side: float
    left: float
    top: float
    turned: bool
    bar_below: bool
    rows: int
    columns: int
    step_x: float
    step_y: float

    def place_of(self, row: int, column: int) -> QRectF:
        row, column = (column, row) if self.turned else (row, column)
        return QRectF(self.left + column * self.step_x, self.top + row * self.step_y, self.side, self.side)

    @property
    def whole(self) -> QRectF:
        return QRectF(
            self.left,
            self.top,
            (self.columns - 1) * self.step_x + self.side,
            (self.rows - 1) * self.step_y + self.side,
        )


def best_layout(width: float, height: float, rows: int, columns: int, room: Room) -> Layout:
    """Return the layout of ``rows`` by ``columns`` pictures in a widget of this size."""
    rows, columns = max(1, rows), max(1, columns)
    ways = [
        _layout(width, height, rows, columns, room, turned, below)
        for turned in (False, True)
        for below in ((False,) if room.bar_ticks is None else (False, True))
    ]
    best = max(ways, key=lambda way: way.side)
    return best if best.side > _GAINS * ways[0].side else ways[0]


def _layout(
    width: float, height: float, rows: int, columns: int, room: Room, turned: bool, below: bool
) -> Layout:
    if turned:
        rows, columns = columns, rows
    titled_rows, titled_columns = (
        (room.titled_columns, room.titled_rows) if turned else (room.titled_rows, room.titled_columns)
    )
    left = (room.line + 4.0 if titled_rows else 2.0) + room.y_ticks + (room.line if room.y_name else 0.0)
    top = room.line + 4.0 if titled_columns else 0.5 * room.line + 2.0 if room.y_ticks else 4.0
    under = (room.line + 4.0 if room.x_ticks else 0.0) + (room.line if room.x_name else 0.0) + 2.0
    right = 4.0
    if room.bar_ticks is not None:
        if below:
            under += GAP + BAR + 2.0 * room.line + 6.0
            left, right = max(left, 0.5 * room.bar_ticks), right + 0.5 * room.bar_ticks
        else:
            right += GAP + BAR + 8.0 + room.bar_ticks + room.line
            # The numbers at the bar's ends reach half a line beyond it.
            top, under = max(top, 0.5 * room.line), max(under, 0.5 * room.line)
    # Numbers of one row's foot and the next one's top would lie on each other.
    gap_y = max(GAP, room.line) if room.y_ticks else GAP
    wide = (width - left - right - GAP * (columns - 1)) / columns
    high = (height - top - under - gap_y * (rows - 1)) / rows
    side = max(8.0, min(wide, high))
    # What is left over is shared by both sides.
    left += 0.5 * max(0.0, columns * (wide - side))
    top += 0.5 * max(0.0, rows * (high - side))
    return Layout(side, left, top, turned, below, rows, columns, side + GAP, side + gap_y)
