"""Directions in the local frame of a surface and the angles used by the paint trade.

The frame is right-handed, z along the normal and x along the tangent. ``wi`` points to the light and ``wo``
to the viewer, both away from the surface and of unit length, arrays (..., 3) that broadcast.

In the plane of incidence the light stands on the -x side, so its mirror direction leans to +x; an aspecular
angle γ turns the view from there towards the normal and past it to the light. With the light at 45° the
view's polar angle, counted to +x, is 45° - γ.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats

_MIRROR = np.array([-1.0, -1.0, 1.0])

# Out of the plane by less than this (sine of the angle) is rounding, not geometry.
_IN_PLANE = 1e-9


def spherical(theta: npt.ArrayLike, phi: npt.ArrayLike) -> Floats:
    """Return unit directions (..., 3) at polar angle ``theta`` from z and azimuth ``phi`` from x, radians."""
    theta, phi = np.broadcast_arrays(np.asarray(theta, float), np.asarray(phi, float))
    sin_theta = np.sin(theta)
    return np.stack((sin_theta * np.cos(phi), sin_theta * np.sin(phi), np.cos(theta)), axis=-1)


def mirror(w: npt.ArrayLike) -> Floats:
    """Return the mirror directions of ``w`` (..., 3) about the normal."""
    mirrored: Floats = np.asarray(w, float) * _MIRROR
    return mirrored


def mirror_cosine(wi: Floats, wo: Floats) -> Floats:
    """Return R·V (...), the cosine between the light's mirror direction and the view; 0 behind it."""
    dot = wi[..., 2] * wo[..., 2] - wi[..., 0] * wo[..., 0] - wi[..., 1] * wo[..., 1]
    return np.clip(dot, 0.0, 1.0)


def about_y(angle: float) -> Floats:
    """Return the rotation (3, 3) by ``angle`` (radians) about +y, counter-clockwise seen from above."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.array([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]])


def from_horizon(azimuth_deg: float, elevation_deg: float) -> Floats:
    """Return the unit direction (3,), y up, at an elevation and an azimuth from +z towards +x, degrees."""
    azimuth, elevation = np.radians([azimuth_deg, elevation_deg])
    level = np.cos(elevation)
    return np.array([level * np.sin(azimuth), np.sin(elevation), level * np.cos(azimuth)])


def illumination(illumination_deg: npt.ArrayLike) -> Floats:
    """Return ``wi`` (..., 3) of a light at a polar angle in degrees, on the -x side."""
    theta = np.radians(np.asarray(illumination_deg, float))
    return np.stack((-np.sin(theta), np.zeros_like(theta), np.cos(theta)), axis=-1)


def aspecular_view(illumination_deg: npt.ArrayLike, aspecular_deg: npt.ArrayLike) -> Floats:
    """Return ``wo`` (..., 3) at an aspecular angle, degrees, for the light of :func:`illumination`.

    >>> aspecular_view(45.0, 45.0).tolist()
    [0.0, 0.0, 1.0]
    """
    polar = np.radians(np.asarray(illumination_deg, float) - np.asarray(aspecular_deg, float))
    return np.stack((np.sin(polar), np.zeros_like(polar), np.cos(polar)), axis=-1)


def angle_between(u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
    """Return the angle (...) between unit vectors, radians, 0 to π, exact also where it is tiny."""
    u, v = np.asarray(u, float), np.asarray(v, float)
    difference, total = u - v, u + v
    half: Floats = np.arctan2(
        np.sqrt(np.einsum("...i,...i", difference, difference)), np.sqrt(np.einsum("...i,...i", total, total))
    )
    return 2.0 * half


def aspecular_angle(wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
    """Return γ (...), radians: the angle between the mirror direction of ``wi`` and ``wo``.

    In the plane of incidence it is signed: negative where the view lies beyond the mirror direction, away
    from the normal. Out of the plane there is no such side and it is unsigned.
    """
    wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
    gamma = angle_between(mirror(wi), wo)
    across = wi[..., 0] * wo[..., 1] - wi[..., 1] * wo[..., 0]
    # Along the tangential mirror direction the view's tangential part exceeds that of the mirror itself.
    sine_i = np.hypot(wi[..., 0], wi[..., 1])
    along = -(wi[..., 0] * wo[..., 0] + wi[..., 1] * wo[..., 1])
    beyond = (np.abs(across) <= _IN_PLANE) & (along > sine_i * sine_i) & (sine_i > _IN_PLANE)
    return np.where(beyond, -gamma, gamma)


def half_angle_coordinates(wi: npt.ArrayLike, wo: npt.ArrayLike) -> tuple[Floats, Floats, Floats, Floats]:
    """Return Rusinkiewicz' (θh, φh, θd, φd), each (...), radians.

    h = normalize(wi + wo) has the polar angle θh and the azimuth φh; (θd, φd) are those of ``wi`` in the
    frame of h: first turned by -φh about z, then by -θh about y. φh and φd lie in (-π, π].
    """
    wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
    total = wi + wo
    half = total / np.sqrt(np.einsum("...i,...i", total, total))[..., None]
    sin_h = np.hypot(half[..., 0], half[..., 1])
    theta_h = np.arctan2(sin_h, half[..., 2])
    phi_h = np.arctan2(half[..., 1], half[..., 0])
    cos_p, sin_p = np.cos(phi_h), np.sin(phi_h)
    cos_t, sin_t = np.cos(theta_h), np.sin(theta_h)
    x = cos_p * wi[..., 0] + sin_p * wi[..., 1]
    y = cos_p * wi[..., 1] - sin_p * wi[..., 0]
    dx = cos_t * x - sin_t * wi[..., 2]
    dz = sin_t * x + cos_t * wi[..., 2]
    return theta_h, phi_h, np.arctan2(np.hypot(dx, y), dz), np.arctan2(y, dx)


def from_half_angle_coordinates(
    theta_h: npt.ArrayLike, phi_h: npt.ArrayLike, theta_d: npt.ArrayLike, phi_d: npt.ArrayLike
) -> tuple[Floats, Floats]:
    """Return (``wi``, ``wo``), each (..., 3); the inverse of :func:`half_angle_coordinates`."""
    theta_h, phi_h = np.asarray(theta_h, float), np.asarray(phi_h, float)
    d = spherical(theta_d, phi_d)
    cos_t, sin_t = np.cos(theta_h), np.sin(theta_h)
    x = cos_t * d[..., 0] + sin_t * d[..., 2]
    z = cos_t * d[..., 2] - sin_t * d[..., 0]
    cos_p, sin_p = np.cos(phi_h), np.sin(phi_h)
    wi = np.stack((cos_p * x - sin_p * d[..., 1], sin_p * x + cos_p * d[..., 1], z), axis=-1)
    half = spherical(theta_h, phi_h)
    wo = 2.0 * np.einsum("...i,...i", wi, half)[..., None] * half - wi
    return wi, wo
