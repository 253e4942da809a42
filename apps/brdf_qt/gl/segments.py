"""Straight segments in three dimensions as arrays, without pyqtgraph, which takes a quarter of a second to import."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Rgba = tuple[float, float, float, float]
Segments = npt.NDArray[np.void]
"""Rows of :data:`SEGMENT`."""
SEGMENT = np.dtype([("ends", "f4", (2, 3)), ("widths", "f4", 2), ("colour", "f4", 4)])
"""Start and end, the widths there in logical pixels, and the colour, 0 to 1."""


def segments(start: npt.ArrayLike, end: npt.ArrayLike, widths: npt.ArrayLike, colour: Rgba) -> Segments:
    """Return segments from ``start`` to ``end`` (n, 3), with the widths at both (2,) in logical pixels."""
    ends = np.stack((np.atleast_2d(start), np.atleast_2d(end)), axis=1)
    rows = np.zeros(len(ends), SEGMENT)
    rows["ends"], rows["widths"], rows["colour"] = ends, widths, colour
    return rows


def polyline(points: npt.ArrayLike, width: float, colour: Rgba) -> Segments:
    """Return the segments between neighbouring points (n, 3)."""
    points = np.asarray(points, np.float32)
    return segments(points[:-1], points[1:], (width, width), colour)
