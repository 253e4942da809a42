"""Where each swatch of a grid lies: rows of equal tiles under headings. Numbers alone, no widget."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

Box = tuple[int, int, int, int]
"""Left, top, width and height in pixels of the contents, before any scrolling."""

GAP = 8
HEADING = 32


@dataclass(frozen=True)
class Part:
    """Swatches under one heading: the places ``first`` … ``first + count - 1``. An empty title takes no room."""

    title: str
    first: int
    count: int


class GridLayout:
    """Tiles of ``tile`` (width, height) pixels, flowing within ``width`` pixels, part under part.

    A place is found by halving, whatever the number of swatches: nothing is kept for each of them.
    """

    def __init__(self, parts: Sequence[Part], tile: tuple[int, int], width: int) -> None:
        self.parts = tuple(parts)
        self.tile = tile
        self.width = width
        self.columns = max(1, (width - GAP) // (tile[0] + GAP))
        # What is left at the right goes between the columns.
        self.stride = max(tile[0] + GAP, (width - GAP) // self.columns)
        self._firsts = [part.first for part in self.parts]
        self._tops: list[int] = []
        top = 0
        for part in self.parts:
            self._tops.append(top)
            lines = -(-part.count // self.columns)
            top += (HEADING if part.title else GAP) + lines * (tile[1] + GAP)
        self.height = top
        self.count = self.parts[-1].first + self.parts[-1].count if self.parts else 0

    def box(self, place: int) -> Box:
        part = bisect_right(self._firsts, place) - 1
        # An empty part begins where the next one does, which holds the swatch.
        line, column = divmod(place - self._firsts[part], self.columns)
        return GAP + column * self.stride, self._body(part) + line * (self.tile[1] + GAP), *self.tile

    def heading(self, part: int) -> Box:
        return (GAP, self._tops[part], max(0, self.width - 2 * GAP), HEADING if self.parts[part].title else 0)

    def at(self, x: int, y: int) -> int | None:
        """Return the place of the swatch under a point; ``None`` between them."""
        found = self.near(x, y)
        if found is None:
            return None
        left, top, width, height = self.box(found)
        return found if left <= x < left + width and top <= y < top + height else None

    def near(self, x: int, y: int) -> int | None:
        """Return the place of the swatch that a point is nearest to in its line; ``None`` where there is none."""
        if not self.count:
            return None
        part = max(0, bisect_right(self._tops, y) - 1)
        line = max(0, (y - self._body(part)) // (self.tile[1] + GAP))
        column = min(self.columns - 1, max(0, (x - GAP // 2) // self.stride))
        count = self.parts[part].count
        place = self.parts[part].first + min(max(count - 1, 0), line * self.columns + column)
        return min(place, self.count - 1)

    def between(self, top: int, bottom: int) -> Iterator[tuple[int, range]]:
        """Yield (part, places) of what may be seen between two heights; whole lines, each part once."""
        for part in range(max(0, bisect_right(self._tops, top) - 1), len(self.parts)):
            if self._tops[part] > bottom:
                return
            body, count = self._body(part), self.parts[part].count
            step = self.tile[1] + GAP
            first = max(0, (top - body) // step) * self.columns
            last = max(0, (bottom - body) // step + 1) * self.columns
            start = self.parts[part].first
            yield part, range(start + min(first, count), start + min(last, count))

    def inside(self, box: Box) -> list[int]:
        left, top, width, height = box
        found = []
        for _part, places in self.between(top, top + height):
            for place in places:
                x, y, w, h = self.box(place)
                if x < left + width and left < x + w and y < top + height and top < y + h:
                    found.append(place)
        return found

    def step(self, place: int, lines: int) -> int:
        """Return the place ``lines`` lines further down (up where below 0), in the same column where there is one."""
        x, y, width, height = self.box(place)
        if lines == 0:
            return place
        for _ in range(abs(lines)):
            target = y + (height + GAP if lines > 0 else -(GAP + 1))
            if target < 0 or target >= self.height:
                break
            found = self.near(x + width // 2, target)
            if found is None or self.box(found)[1] == y:
                # Over a heading, to the part beyond it.
                found = self._beyond(place, 1 if lines > 0 else -1, x + width // 2)
            if found is None:
                break
            place = found
            y = self.box(place)[1]
        return place

    def _beyond(self, place: int, way: int, x: int) -> int | None:
        part = bisect_right(self._firsts, place) - 1 + way
        while 0 <= part < len(self.parts) and not self.parts[part].count:
            part += way
        if not 0 <= part < len(self.parts):
            return None
        rows = -(-self.parts[part].count // self.columns)
        line = 0 if way > 0 else rows - 1
        return self.near(x, self._body(part) + line * (self.tile[1] + GAP))

    def _body(self, part: int) -> int:
        return self._tops[part] + (HEADING if self.parts[part].title else GAP)
