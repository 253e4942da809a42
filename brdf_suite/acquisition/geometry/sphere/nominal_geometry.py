"""Nominal geometry of a rig from its session, before any photograph is used."""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.acquisition.geometry.lens import Lens
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, Triple, triple
from brdf_suite.acquisition.session.session import Session


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
    known = lens is not None or camera.intrinsics is not None
    if lens is None:
        lens = camera.intrinsics
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
