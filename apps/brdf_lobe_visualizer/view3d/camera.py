"""From where the lobes are seen: angles, distance, and the places that keys 1 to 9 go to."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from brdf_qt.program.translation import mark
from PySide6.QtCore import QRectF
from PySide6.QtGui import QMatrix4x4, QVector3D

FIELD_DEG = 28.0
"""Of the smaller side of the picture: narrow, so that lengths near and far are compared."""
HOME = (-62.0, 24.0)
NEAREST, FARTHEST = 0.02, 40.0
_HOME_DISTANCE = 4.9


@dataclass(frozen=True)
class Camera:
    """Azimuth and elevation of the eye in degrees about ``centre``, and how far it is; z is up, the radius 1 is 1."""

    azimuth_deg: float = HOME[0]
    elevation_deg: float = HOME[1]
    distance: float = _HOME_DISTANCE
    centre: tuple[float, float, float] = (0.0, 0.0, 0.42)

    def orbit(self, azimuth_deg: float, elevation_deg: float) -> Camera:
        """Return the camera turned by angles; it stays below the zenith and above the nadir."""
        elevation = min(90.0, max(-90.0, self.elevation_deg + elevation_deg))
        azimuth = (self.azimuth_deg + azimuth_deg + 180.0) % 360.0 - 180.0
        return replace(self, azimuth_deg=azimuth, elevation_deg=elevation)

    def pan(self, right: float, up: float) -> Camera:
        """Return the camera moved so that the picture moves by fractions of its height."""
        reach = 2.0 * self.distance * math.tan(math.radians(0.5 * FIELD_DEG))
        side, top = self.axes()
        x, y, z = (c - reach * (right * s + up * t) for c, s, t in zip(self.centre, side, top, strict=True))
        return replace(self, centre=(x, y, z))

    def zoom(self, factor: float, right: float, up: float) -> Camera:
        """Return the camera nearer or farther; what is at the place, as fractions of the height, stays there."""
        distance = min(FARTHEST, max(NEAREST, self.distance * factor))
        share = distance / self.distance - 1.0
        return replace(self.pan(right * share, up * share), distance=distance)

    def axes(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Return the directions to the right and to the top of the picture."""
        (sin_a, cos_a), (sin_e, cos_e) = self._turn()
        return (-sin_a, cos_a, 0.0), (-sin_e * cos_a, -sin_e * sin_a, cos_e)

    def eye(self) -> tuple[float, float, float]:
        (sin_a, cos_a), (sin_e, cos_e) = self._turn()
        x, y, z = self.centre
        far = self.distance
        return x + far * cos_e * cos_a, y + far * cos_e * sin_a, z + far * sin_e

    def _turn(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return sine and cosine of azimuth and of elevation."""
        azimuth, elevation = math.radians(self.azimuth_deg), math.radians(self.elevation_deg)
        return (math.sin(azimuth), math.cos(azimuth)), (math.sin(elevation), math.cos(elevation))

    def to_eye(self) -> QMatrix4x4:
        """Return the matrix from the local frame to the eye's."""
        matrix = QMatrix4x4()
        matrix.translate(0.0, 0.0, -self.distance)
        matrix.rotate(self.elevation_deg - 90.0, 1.0, 0.0, 0.0)
        matrix.rotate(self.azimuth_deg + 90.0, 0.0, 0.0, -1.0)
        matrix.translate(QVector3D(*(-c for c in self.centre)))
        return matrix

    def to_screen(self, width: float, height: float) -> QMatrix4x4:
        """Return the projection onto a picture of that shape."""
        # Near and far are close about the lobes, or depths could not be distinguished.
        reach = 3.0 + math.dist(self.centre, (0.0, 0.0, 0.4))
        near = max(0.02 * self.distance, self.distance - reach, 1e-3)
        far = self.distance + reach
        half = near * math.tan(math.radians(0.5 * FIELD_DEG)) / min(width, height)
        matrix = QMatrix4x4()
        matrix.frustum(-half * width, half * width, -half * height, half * height, near, far)
        return matrix

    def to_clip(self, room: QRectF) -> QMatrix4x4:
        """Return the matrix from the local frame to the clip coordinates of a panel that lies in ``room``."""
        return self.to_screen(room.width(), room.height()) * self.to_eye()


def parse_camera(text: str) -> Camera:
    """Return the camera that :func:`format_camera` wrote; that of a first start where the text is none."""
    try:
        azimuth, elevation, distance, x, y, z = numbers = [float(part) for part in text.split()]
    except ValueError:
        return Camera()
    sound = all(map(math.isfinite, numbers)) and NEAREST <= distance <= FARTHEST and abs(elevation) <= 90.0
    return Camera(azimuth, elevation, distance, (x, y, z)) if sound else Camera()


def format_camera(camera: Camera) -> str:
    """Return a camera as text, to be remembered."""
    values = (camera.azimuth_deg, camera.elevation_deg, camera.distance, *camera.centre)
    return " ".join(f"{value:.6g}" for value in values)


def frame_hemisphere(camera: Camera) -> Camera:
    """Return the camera where all of the hemisphere is seen, from the side that it looks from now."""
    home = Camera()
    return replace(camera, distance=home.distance, centre=home.centre)


PRESETS: tuple[tuple[str, str], ...] = (
    ("three_quarters", mark("Three-quarter view")),
    ("plane", mark("Side view of the plane of incidence")),
    ("light", mark("From the light")),
    ("mirror", mark("From the mirror direction")),
    ("top", mark("From above")),
    ("behind", mark("Three-quarter view from behind")),
    ("back", mark("Side view from behind")),
    ("along", mark("Low, along the plane of incidence")),
    ("below", mark("From below")),
)
"""Key and title of what keys 1 to 9 go to."""


def preset(key: str, theta_deg: float, phi_deg: float) -> Camera:
    """Return the camera of a preset for an incidence: they follow the plane of incidence.

    The light's azimuth in the local frame is ``phi_deg + 180``, its mirror direction's is ``phi_deg``.
    """
    angles = {
        "three_quarters": (phi_deg + HOME[0], HOME[1]),
        "plane": (phi_deg - 90.0, 0.0),
        "light": (phi_deg + 180.0, 90.0 - theta_deg),
        "mirror": (phi_deg, 90.0 - theta_deg),
        "top": (phi_deg - 90.0, 90.0),
        "behind": (phi_deg + 118.0, HOME[1]),
        "back": (phi_deg + 90.0, 0.0),
        "along": (phi_deg, 8.0),
        "below": (phi_deg + HOME[0], -35.0),
    }
    azimuth, elevation = angles[key]
    return Camera().orbit(azimuth - HOME[0], elevation - HOME[1])
