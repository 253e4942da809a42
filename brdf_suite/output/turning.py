"""An object that turns before a camera and a light that stand still: in a file, and on the screen."""

from __future__ import annotations

import math
from dataclasses import replace

from brdf_suite.documents.view import View

Point = tuple[float, float, float]


def turned(view: View, degrees: float, centre: Point = (0.0, 0.0, 0.0)) -> View:
    """Return the view of the object turned by ``degrees`` counter-clockwise seen from above, about ``centre`` (m).

    The object has no angle in a view: camera, light and lamps turn about it, the other way.
    """

    def within_turn(angle: float) -> float:
        return (angle - degrees + 180.0) % 360.0 - 180.0

    target = view.camera.target
    target = None if target is None else _about(target, -degrees, centre)
    camera = replace(view.camera, azimuth_deg=within_turn(view.camera.azimuth_deg), target=target)
    lamps = tuple(
        replace(
            lamp,
            position=_about(lamp.position, -degrees, centre),
            azimuth_deg=within_turn(lamp.azimuth_deg),
        )
        for lamp in view.lamps
    )
    return replace(view, camera=camera, rotation_deg=within_turn(view.rotation_deg), lamps=lamps)


def _about(point: Point, degrees: float, centre: Point) -> Point:
    angle = math.radians(degrees)
    x, z = point[0] - centre[0], point[2] - centre[2]
    cos, sin = math.cos(angle), math.sin(angle)
    return centre[0] + x * cos + z * sin, point[1], centre[2] + z * cos - x * sin
