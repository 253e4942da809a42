"""An object that turns before a camera and a light that stand still: in a file, and on the screen."""

from __future__ import annotations

import math
from dataclasses import replace

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp

Point = tuple[float, float, float]


def turned(view: View, degrees: float, centre: Point = (0.0, 0.0, 0.0)) -> View:
    """Return the view of the object turned by ``degrees`` counter-clockwise seen from above, about ``centre`` (m).

    The object has no angle in a view: camera, light and lamps turn about it, the other way.
    """
    azimuth = view.camera.azimuth_deg - degrees
    target = view.camera.target
    camera = replace(
        view.camera,
        azimuth_deg=(azimuth + 180.0) % 360.0 - 180.0,
        target=None if target is None else _about(target, -degrees, centre),
    )
    lamps = tuple(_turned_lamp(lamp, -degrees, centre) for lamp in view.lamps)
    rotation = (view.rotation_deg - degrees + 180.0) % 360.0 - 180.0
    return replace(view, camera=camera, rotation_deg=rotation, lamps=lamps)


def _about(point: Point, degrees: float, centre: Point) -> Point:
    angle = math.radians(degrees)
    x, z = point[0] - centre[0], point[2] - centre[2]
    cos, sin = math.cos(angle), math.sin(angle)
    return centre[0] + x * cos + z * sin, point[1], centre[2] + z * cos - x * sin


def _turned_lamp(lamp: Lamp, degrees: float, centre: Point) -> Lamp:
    azimuth = (lamp.azimuth_deg + degrees + 180.0) % 360.0 - 180.0
    return replace(lamp, position=_about(lamp.position, degrees, centre), azimuth_deg=azimuth)
