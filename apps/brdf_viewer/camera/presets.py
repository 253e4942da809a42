"""The named directions to look from; azimuth 0 is in front (+z), growing counter-clockwise seen from above."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.program.translation import mark

from brdf_suite.documents.view import Camera

PRESETS: dict[str, tuple[str, float, float]] = {
    "front": (mark("Front"), 0.0, 6.0),
    "three_quarter": (mark("¾ view"), 35.0, 7.0),
    "side": (mark("Side"), 90.0, 4.0),
    "top": (mark("Top"), 0.0, 89.0),
}
"""Key: title, azimuth and elevation in degrees; the first is on key 1."""


def look_from(camera: Camera, preset: str) -> Camera:
    """Return the camera at a preset, framing the whole object with its present lens."""
    _, azimuth, elevation = PRESETS[preset]
    return replace(camera, azimuth_deg=azimuth, elevation_deg=elevation, distance=None, target=None)


def signed_deg(angle_deg: float) -> float:
    """Return the same angle from -180 (excluded) to 180.

    >>> signed_deg(350.0), signed_deg(180.0)
    (-10.0, 180.0)
    """
    return 180.0 - (180.0 - angle_deg) % 360.0
