"""Azimuth, elevation and distance about the middle of a scene: where a lamp is, as one thinks of it.

Azimuth counts from +z (in front) towards +x, elevation from the horizon.
"""

from __future__ import annotations

from math import atan2, cos, degrees, hypot, radians, sin

Point = tuple[float, float, float]


def polar(point: Point) -> tuple[float, float, float]:
    """Return azimuth and elevation (°) and distance (m) of a point.

    >>> [round(value, 2) for value in polar((1.0, 0.0, 1.0))]
    [45.0, 0.0, 1.41]
    """
    x, y, z = point
    level = hypot(x, z)
    return degrees(atan2(x, z)), degrees(atan2(y, level)), hypot(level, y)


def point_at(azimuth_deg: float, elevation_deg: float, distance: float) -> Point:
    """Return the point in a direction; the inverse of :func:`polar`."""
    azimuth, elevation = radians(azimuth_deg), radians(elevation_deg)
    level = distance * cos(elevation)
    return (level * sin(azimuth), distance * sin(elevation), level * cos(azimuth))
