"""Geometry of sphere, turntable axis and light in the camera's frame.

All values are given in the camera's frame (x right, y down, z forward, metres), since the camera alone stands still.
The rig's own frame is made of three directions in it: ``up`` along the turntable's axis, ``front`` from the axis to the
camera, level, and ``side`` = up × front. The light at the turntable's angle α stands at

    axis + height · up + distance · (sin(α + offset) · side + cos(α + offset) · front),

where ``axis`` is the point of the axis at the height of the sphere's centre. A mirror image of the light is seen
where the normal halves the angle between the ways to light and camera; that point is found by iteration, since
both are near (Alhazen's problem).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.lens import Lens
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

_ROUNDS = 60
_CLOSE = 1e-12
_LEAST_COSINE = 0.02

Triple = tuple[float, float, float]


def unit(vectors: npt.ArrayLike) -> Floats:
    """Return vectors (..., 3) at length 1."""
    vectors = np.asarray(vectors, float)
    scaled: Floats = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return scaled


@dataclass(frozen=True)
class RigGeometry:
    """Geometry of a rig: first nominal, from the session, then calibrated from photographs.

    Attributes
    ----------
    lens
        The camera's numbers, pixels.
    shape
        Rows and columns of a photograph.
    radius_m
        The sphere's radius, metres.
    centre_m
        The sphere's centre in the camera's frame, metres.
    up
        The turntable's axis in the camera's frame, upward, length 1.
    axis_offset_m
        The sphere's centre less the axis, along side and front, metres.
    light_distance_m, light_height_m
        The light from the axis, and above the sphere's centre, metres.
    angle_offset_deg
        Added to every angle of the turntable, degrees.
    angles_deg
        The turntable's angle at each position as the session states it (K,), degrees; 0 in front of the camera.
    irradiance_rgb
        What arrives on a surface on the axis, as high as the sphere's centre, that faces the light: the photographs'
        unit per second; None where it is not known (values are then relative: irradiance 1).
    profile
        The lamp's radiant intensity: (degrees off the lamp's axis, relative), rising from 0°; empty for a lamp that
        is even over the sphere. The lamp aims at the axis, as high as the sphere's centre.
    housing_radius_m, post_radius_m
        Of the lamp's housing, and of the post from the turntable up to it, metres; 0: hides nothing.
    lens_known
        False where the camera is not calibrated: its focal length then follows from the sphere's outline and its
        stated distance.
    """

    lens: Lens
    shape: tuple[int, int]
    radius_m: float
    centre_m: Triple
    up: Triple
    axis_offset_m: tuple[float, float]
    light_distance_m: float
    light_height_m: float
    angle_offset_deg: float
    angles_deg: tuple[float, ...]
    irradiance_rgb: Triple | None = None
    profile: tuple[tuple[float, float], ...] = ()
    housing_radius_m: float = 0.0
    post_radius_m: float = 0.0
    lens_known: bool = True

    def __post_init__(self) -> None:
        if not 0.0 < self.radius_m < np.linalg.norm(self.centre_m):
            raise ValueRangeError(
                "sphere.radius_m", f"{self.radius_m:g} m; the camera stands outside of the sphere"
            )
        if self.light_distance_m <= self.radius_m:
            raise ValueRangeError(
                "light.distance_m", f"{self.light_distance_m:g} m; the light stands outside of the sphere"
            )

    @property
    def centre(self) -> Floats:
        """Return the sphere's centre (3,), metres, camera's frame."""
        return np.array(self.centre_m)

    @property
    def rig_axes(self) -> Floats:
        """Return side, up and front as rows (3, 3), each in the camera's frame."""
        up = unit(self.up)
        front = -self.centre + (self.centre @ up) * up
        front = unit(front)
        return np.stack((np.cross(up, front), up, front))

    @property
    def axis_point(self) -> Floats:
        """Return the point (3,) of the turntable's axis that is as high as the sphere's centre, metres."""
        side, _, front = self.rig_axes
        point: Floats = self.centre - self.axis_offset_m[0] * side - self.axis_offset_m[1] * front
        return point

    def light(self, angles_deg: npt.ArrayLike) -> Floats:
        """Return where the light stands (..., 3), metres, at angles (...) of the turntable, degrees."""
        side, up, front = self.rig_axes
        angle = np.radians(np.asarray(angles_deg, float) + self.angle_offset_deg)[..., None]
        place: Floats = (
            self.axis_point
            + self.light_height_m * up
            + self.light_distance_m * (np.sin(angle) * side + np.cos(angle) * front)
        )
        return place

    def highlight_normals(self, lights: npt.ArrayLike) -> tuple[Floats, npt.NDArray[np.bool_]]:
        """Return the normals (..., 3) at which lights (..., 3) are mirrored to the camera, and which are seen."""
        lights, centre = np.asarray(lights, float), self.centre
        normals = unit(unit(lights - centre) - unit(centre))
        for _ in range(_ROUNDS):
            points = centre + self.radius_m * normals
            halved = unit(unit(lights - points) - unit(points))
            moved = float(np.max(np.abs(halved - normals), initial=0.0))
            normals = halved
            if not moved > _CLOSE:
                break
        points = centre + self.radius_m * normals
        cosine = np.einsum("...i,...i", normals, unit(lights - points))
        return normals, cosine > _LEAST_COSINE

    def highlights(self, angles_deg: npt.ArrayLike) -> Floats:
        """Return the pixels (..., 2) where the light is mirrored at angles (...), degrees; NaN: not seen."""
        normals, seen = self.highlight_normals(self.light(angles_deg))
        pixels = self.lens.pixels(self.centre + self.radius_m * normals)
        return np.where(seen[..., None], pixels, np.nan)

    @property
    def outline_angle(self) -> float:
        """Return the angle between the sphere's centre and its outline as the camera sees it, radians."""
        return math.asin(self.radius_m / float(np.linalg.norm(self.centre_m)))

    def outline(self, azimuths: npt.ArrayLike) -> Floats:
        """Return the pixels (..., 2) of the outline at azimuths (...), radians from image x towards image y."""
        azimuths = np.asarray(azimuths, float)
        axis = unit(self.centre)
        right = unit(np.cross((0.0, 1.0, 0.0), axis))
        down = np.cross(axis, right)
        across = np.cos(azimuths)[..., None] * right + np.sin(azimuths)[..., None] * down
        return self.lens.pixels(math.cos(self.outline_angle) * axis + math.sin(self.outline_angle) * across)

    def with_centre(self, centre: npt.ArrayLike) -> RigGeometry:
        """Return the geometry with the sphere's centre elsewhere; the turntable goes with it."""
        return replace(self, centre_m=triple(centre))

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON keeps exactly."""
        return {
            "lens": self.lens.to_json(),
            "shape": list(self.shape),
            "radius_m": self.radius_m,
            "centre_m": list(self.centre_m),
            "up": list(self.up),
            "axis_offset_m": list(self.axis_offset_m),
            "light_distance_m": self.light_distance_m,
            "light_height_m": self.light_height_m,
            "angle_offset_deg": self.angle_offset_deg,
            "angles_deg": list(self.angles_deg),
            "irradiance_rgb": None if self.irradiance_rgb is None else list(self.irradiance_rgb),
            "profile": [list(pair) for pair in self.profile],
            "housing_radius_m": self.housing_radius_m,
            "post_radius_m": self.post_radius_m,
            "lens_known": self.lens_known,
        }

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> RigGeometry:
        """Return the geometry that :meth:`to_json` gave as plain values."""
        return cls(
            lens=Lens(**value["lens"]),
            shape=(int(value["shape"][0]), int(value["shape"][1])),
            radius_m=float(value["radius_m"]),
            centre_m=triple(value["centre_m"]),
            up=triple(value["up"]),
            axis_offset_m=(float(value["axis_offset_m"][0]), float(value["axis_offset_m"][1])),
            light_distance_m=float(value["light_distance_m"]),
            light_height_m=float(value["light_height_m"]),
            angle_offset_deg=float(value["angle_offset_deg"]),
            angles_deg=tuple(map(float, value["angles_deg"])),
            irradiance_rgb=None if value["irradiance_rgb"] is None else triple(value["irradiance_rgb"]),
            profile=tuple((float(pair[0]), float(pair[1])) for pair in value["profile"]),
            housing_radius_m=float(value["housing_radius_m"]),
            post_radius_m=float(value["post_radius_m"]),
            lens_known=bool(value["lens_known"]),
        )


def triple(values: npt.ArrayLike) -> Triple:
    """Return three numbers as a tuple of floats."""
    x, y, z = np.asarray(values, float)
    return float(x), float(y), float(z)
