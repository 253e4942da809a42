"""Irradiance from a photograph of a white of known reflectance, which sets the scale of all samples."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, in_rig
from brdf_suite.acquisition.session.session import Session
from brdf_suite.arrays import triple
from brdf_suite.errors import AcquisitionError

_LEAST_COSINE = 0.05


def irradiance_from_white(
    session: Session, radiance: npt.ArrayLike, geometry: RigGeometry | None = None
) -> tuple[float, float, float]:
    """Return what arrives at the turntable's axis on a surface that faces the lamp, each channel.

    A Lambertian white of reflectance ρ reflects L = ρ E cosθ / π; at the axis there is (d_white/d_axis)² as much, and
    the lamp's intensity along its axis over that towards the white.

    Parameters
    ----------
    session
        With :attr:`~brdf_suite.acquisition.session.session.Session.white`, which says where the white stood
        and how it was turned.
    radiance
        (3,) mean over the white's region, the photographs' unit per second.
    geometry
        The refined rig: the lamp then stands where its highlights say. Half a degree of the turntable's zero is half
        a percent of the scale at 30°. None: where the session says.

    Raises
    ------
    AcquisitionError
        There is no white reference, its radiance is not positive, or the lamp hardly reaches it.
    """
    white = session.white
    if white is None:
        raise AcquisitionError("The session names no white reference.")
    seen = np.asarray(radiance, float)
    if seen.shape != (3,) or not np.all(np.isfinite(seen) & (seen > 0.0)):
        dark = f"The white reference ({white.photographs[0]} …) is dark where it should show the white"
        raise AcquisitionError(f"{dark}: check its region.")
    lamp = np.array(session.light_m(float(white.angle_deg)))
    if geometry is not None:
        lamp = np.array(in_rig(geometry, geometry.light(white.angle_deg)))
    way = lamp - np.array(white.centre_m)
    distance = float(np.linalg.norm(way))
    normal = np.array(white.normal) / np.linalg.norm(white.normal)
    cosine = float(way @ normal) / distance
    if cosine < _LEAST_COSINE:
        raise AcquisitionError(
            f"The lamp at {white.angle_deg:g}° does not light the white reference, which faces "
            f"({normal[0]:.2f}, {normal[1]:.2f}, {normal[2]:.2f}): check white.angle_deg and white.normal."
        )
    axis = float(np.linalg.norm(lamp))
    falling = 1.0
    if session.light.profile:
        angles, values = np.array(session.light.profile).T
        off = math.degrees(math.acos(float(np.clip((way @ lamp) / (distance * axis), -1.0, 1.0))))
        falling = float(values[0]) / float(np.interp(off, angles, values))
    scale = math.pi / cosine * (distance / axis) ** 2 * falling
    red, green, blue = seen / np.array(white.reflectance) * scale
    return float(red), float(green), float(blue)


def with_refined_white(session: Session, geometry: RigGeometry) -> RigGeometry:
    """Return the refined geometry with the irradiance measured on the white target in place of the stated one.

    ``geometry.irradiance_rgb`` is what :func:`irradiance_from_white` gave without a geometry; where the session states
    the irradiance itself, or there is none, nothing changes.
    """
    if session.light.irradiance_rgb is not None or session.white is None or geometry.irradiance_rgb is None:
        return geometry
    even = np.ones(3)
    change = np.array(irradiance_from_white(session, even, geometry)) / irradiance_from_white(session, even)
    return replace(geometry, irradiance_rgb=triple(np.array(geometry.irradiance_rgb) * change))
