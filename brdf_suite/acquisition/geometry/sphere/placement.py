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

from brdf_suite.acquisition.geometry.lens import lens_pixels, lens_rays
from brdf_suite.acquisition.session.session import Lens, Session
from brdf_suite.arrays import Bools, Floats, Triple, triple
from brdf_suite.errors import ValueRangeError

_ROUNDS = 60
_CLOSE = 1e-12
_LEAST_COSINE = 0.02


def unit(vectors: npt.ArrayLike) -> Floats:
    """Return vectors (..., 3) at length 1."""
    vectors = np.asarray(vectors, float)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def across(axis: Floats) -> tuple[Floats, Floats]:
    """Return right and down (3,) as the camera sees them, of length 1, across a unit ``axis`` (3,)."""
    right = unit(np.cross((0.0, 1.0, 0.0), axis))
    return right, np.cross(axis, right)


def azimuths_about(axis: Floats, rays: Floats) -> Floats:
    """Return the azimuths (n,) of rays (n, 3) about a unit ``axis`` (3,), radians from image x towards image y."""
    right, down = across(axis)
    return np.asarray(np.arctan2(rays @ down, rays @ right))


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
            reason = f"{self.radius_m:g} m; the camera stands outside of the sphere"
            raise ValueRangeError("sphere.radius_m", reason)
        if self.light_distance_m <= self.radius_m:
            reason = f"{self.light_distance_m:g} m; the light stands outside of the sphere"
            raise ValueRangeError("light.distance_m", reason)

    @property
    def centre(self) -> Floats:
        """Return the sphere's centre (3,), metres, camera's frame."""
        return np.array(self.centre_m)

    @property
    def rig_axes(self) -> Floats:
        """Return side, up and front as rows (3, 3), each in the camera's frame."""
        up = unit(self.up)
        front = unit(-self.centre + (self.centre @ up) * up)
        return np.stack((np.cross(up, front), up, front))

    @property
    def axis_point(self) -> Floats:
        """Return the point (3,) of the turntable's axis that is as high as the sphere's centre, metres."""
        side, _, front = self.rig_axes
        return np.asarray(self.centre - self.axis_offset_m[0] * side - self.axis_offset_m[1] * front)

    def light(self, angles_deg: npt.ArrayLike) -> Floats:
        """Return where the light stands (..., 3), metres, at angles (...) of the turntable, degrees."""
        side, up, front = self.rig_axes
        angle = np.radians(np.asarray(angles_deg, float) + self.angle_offset_deg)[..., None]
        level = self.light_distance_m * (np.sin(angle) * side + np.cos(angle) * front)
        return np.asarray(self.axis_point + self.light_height_m * up + level)

    def highlight_normals(self, lights: npt.ArrayLike) -> tuple[Floats, Bools]:
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
        pixels = lens_pixels(self.lens, self.centre + self.radius_m * normals)
        return np.where(seen[..., None], pixels, np.nan)

    def meet(self, pixels: npt.ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Return the rays of pixels (..., 2), where these meet the sphere, (..., 3) each, and how far within they go.

        The last (...) is the square of half of the way through the sphere, m²; below 0 a ray passes beside, and its
        point is the one nearest to the centre.
        """
        rays = lens_rays(self.lens, pixels)
        along = rays @ self.centre
        rest = along * along - (self.centre @ self.centre - self.radius_m**2)
        return rays, (along - np.sqrt(np.maximum(rest, 0.0)))[..., None] * rays, rest

    @property
    def outline_angle(self) -> float:
        """Return the angle between the sphere's centre and its outline as the camera sees it, radians."""
        return math.asin(self.radius_m / float(np.linalg.norm(self.centre_m)))

    @property
    def pixel_rad(self) -> float:
        """Return the angle of the sphere that a pixel covers in its middle, radians."""
        away = float(np.linalg.norm(self.centre_m)) - self.radius_m
        return away / (math.sqrt(self.lens.fx * self.lens.fy) * self.radius_m)

    def outline(self, azimuths: npt.ArrayLike) -> Floats:
        """Return the pixels (..., 2) of the outline at azimuths (...), radians from image x towards image y."""
        azimuths = np.asarray(azimuths, float)
        axis = unit(self.centre)
        right, down = across(axis)
        turned = np.cos(azimuths)[..., None] * right + np.sin(azimuths)[..., None] * down
        rays = math.cos(self.outline_angle) * axis + math.sin(self.outline_angle) * turned
        return lens_pixels(self.lens, rays)

    def with_centre(self, centre: npt.ArrayLike) -> RigGeometry:
        """Return the geometry with the sphere's centre elsewhere; the turntable goes with it."""
        return replace(self, centre_m=triple(centre))

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> RigGeometry:
        """Return the geometry whose fields (``asdict``) JSON has kept."""
        fields = {name: _tuples(item) for name, item in value.items()}
        return cls(**{**fields, "lens": Lens(**value["lens"])})


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def nominal_geometry(session: Session, shape: tuple[int, int], lens: Lens | None = None) -> RigGeometry:
    """Return the stated geometry.

    Parameters
    ----------
    session
        What the folder says of camera, sphere, light and positions.
    shape
        Rows and columns of a photograph.
    lens
        A calibrated camera; None: the session's own numbers. Where it has none either, the focal length is the one
        with which the sphere fills half of the picture's height, and :attr:`Geometry.lens_known` is False.
    """
    camera, light = session.camera, session.light
    lens = lens or camera.intrinsics
    known = lens is not None
    tilt = math.radians(camera.tilt_deg)
    up = np.array((0.0, -math.cos(tilt), math.sin(tilt)))
    away = np.array((0.0, math.sin(tilt), math.cos(tilt)))  # level, from the camera to the axis
    centre = camera.distance_m * away - camera.height_m * up
    offset = (0.0, 0.0)
    if session.sphere.centre_m is not None:
        x, y, z = session.sphere.centre_m
        centre = centre + np.array((x, 0.0, 0.0)) + y * up - z * away
        offset = (x, z)
    if lens is None:
        angle = math.asin(min(0.9, session.sphere.radius_m / float(np.linalg.norm(centre))))
        focal = 0.25 * shape[0] / math.tan(angle)
        lens = Lens(focal, focal, 0.5 * (shape[1] - 1), 0.5 * (shape[0] - 1))
    return RigGeometry(
        lens=lens,
        shape=(int(shape[0]), int(shape[1])),
        radius_m=session.sphere.radius_m,
        centre_m=triple(centre),
        up=triple(up),
        axis_offset_m=offset,
        light_distance_m=light.distance_m,
        light_height_m=light.height_m,
        angle_offset_deg=light.angle_offset_deg,
        angles_deg=tuple(position.angle_deg for position in session.positions),
        irradiance_rgb=light.irradiance_rgb,
        profile=light.profile,
        housing_radius_m=light.housing_radius_m,
        post_radius_m=light.post_radius_m,
        lens_known=known,
    )


def in_rig(geometry: RigGeometry, points: np.ndarray) -> Triple:
    """Return a point (3,) of the camera's frame in the rig's own: side, up and front of the axis, metres."""
    return triple(geometry.rig_axes @ (np.asarray(points, float) - geometry.axis_point))
