"""Compiled decoding of PNG row filters: each byte depends on earlier ones, so numpy cannot vectorise it."""

from __future__ import annotations

from brdf_suite.compilation import Array, compiled


@compiled
def unfilter(rows: Array, filters: Array, step: int) -> None:
    """Turn filtered ``rows`` (h, bytes) uint8 into plain ones in place; ``step`` is the bytes of a pixel."""
    height, width = rows.shape
    for y in range(height):
        kind = filters[y]
        if kind == 0:
            continue
        for x in range(width):
            left = int(rows[y, x - step]) if x >= step else 0
            above = int(rows[y - 1, x]) if y > 0 else 0
            if kind == 1:
                guess = left
            elif kind == 2:
                guess = above
            elif kind == 3:
                guess = (left + above) >> 1
            else:
                corner = int(rows[y - 1, x - step]) if x >= step and y > 0 else 0
                # Paeth: whichever of the three lies nearest to left + above - corner.
                by_left, by_above = abs(above - corner), abs(left - corner)
                by_corner = abs(left + above - 2 * corner)
                if by_left <= by_above and by_left <= by_corner:
                    guess = left
                elif by_above <= by_corner:
                    guess = above
                else:
                    guess = corner
            rows[y, x] = (int(rows[y, x]) + guess) & 255
