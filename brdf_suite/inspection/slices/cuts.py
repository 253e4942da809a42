"""Cuts through a reflectance along one angle: which pairs of directions each looks at, and at which angles.

Every cut belongs to a plane of incidence of azimuth φ (0: the light on the -x side, as in
:func:`brdf_suite.geometry.directions.illumination`); for what is anisotropic φ matters. The cuts:

- the **plane of incidence** (:func:`plane_slice`): the light stands, the view turns from one horizon over the normal to
  the other. Its angle is θo, positive on the mirror direction's side, or the aspecular angle γ = θi - θo;
- **over θh** (:func:`half_slice`): the half vector tips in the plane of incidence at fixed θd and φd, away from
  (θh = 0) the mirror configuration: the shape of the highlight;
- **over θd** (:func:`difference_slice`): light and view part at a fixed half vector: at θh = 0 the mirror's own
  reflectance, with Fresnel's rise.

Angles are even where a look at the whole needs them, and close about the mirror direction, evenly in log from
:data:`FINEST_DEG` on: half of a cosine lobe of exponent 10⁵ lies within .21°, and no even grid would meet it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical

Axis = Literal["gamma", "theta_o", "theta_h", "theta_d"]
AXES: tuple[Axis, ...] = ("gamma", "theta_o", "theta_h", "theta_d")

FINEST_DEG = 0.01
"""The step nearest to the mirror direction."""
NEAR_DEG = 12.0
"""Up to so far from it the steps grow."""
NEAR_STEPS = 30
EVEN_STEP_DEG = 1.5
HORIZON_DEG = 89.9
"""Views end here: at 90° every reflectance is 0 by definition, and a line would fall that is not there."""

_EVEN = np.linspace(-HORIZON_DEG, HORIZON_DEG, round(2.0 * HORIZON_DEG / EVEN_STEP_DEG) + 1)
_SIDE = np.geomspace(FINEST_DEG, NEAR_DEG, NEAR_STEPS)
_NEAR = np.concatenate((-_SIDE[::-1], [0.0], _SIDE))
# Not np.unique, which imports numpy.ma: 20 ms of each start.
_HALF_ANGLES = np.array(
    sorted({0.0, *np.geomspace(FINEST_DEG, 90.0, 72).tolist(), *np.linspace(1.5, 90.0, 60).tolist()})
)
_DIFFERENCE_ANGLES = np.linspace(0.0, HORIZON_DEG, 91)


@dataclass(frozen=True, eq=False)
class Slice:
    """A cut: ``angle_deg`` (n,) rising, ``wi`` and ``wo`` (n, 3), and ``above`` (n,), both above the horizon.

    ``axis`` says which angle it is. Where ``above`` is not set there is nothing to be seen, and a line has a gap.
    """

    axis: Axis
    angle_deg: Floats
    wi: Floats
    wo: Floats
    above: Bools

    def over(self, axis: Axis, theta_deg: float) -> Slice:
        """Return a cut of the plane of incidence over γ or θo, the other way round; the light is at ``theta_deg``."""
        if axis == self.axis:
            return self
        turn = np.ascontiguousarray((theta_deg - self.angle_deg)[::-1])
        return Slice(axis, turn, self.wi[::-1], self.wo[::-1], self.above[::-1])


def light_at(theta_deg: float, phi_deg: float) -> Floats:
    """Return the unit direction (3,) to the light in the plane of incidence of azimuth ``phi_deg``.

    >>> light_at(90.0, 0.0).round(9).tolist()
    [-1.0, 0.0, 0.0]
    """
    return spherical(np.radians(theta_deg), np.radians(phi_deg) + np.pi)


def view_at(theta_o_deg: npt.ArrayLike, phi_deg: float) -> Floats:
    """Return views (..., 3) of the plane of incidence at signed polar angles, positive on the mirror's side."""
    return spherical(np.radians(theta_o_deg), np.radians(phi_deg))


def plane_slice(theta_deg: float, phi_deg: float) -> Slice:
    """Return the plane of incidence of a light at ``theta_deg``, 0…90, over θo in degrees."""
    angles = np.concatenate((_EVEN, theta_deg + _NEAR))
    angles = np.unique(angles[np.abs(angles) <= HORIZON_DEG])
    wi = np.broadcast_to(light_at(theta_deg, phi_deg), (len(angles), 3))
    return Slice("theta_o", angles, wi, view_at(angles, phi_deg), np.ones(len(angles), np.bool_))


def half_slice(theta_d_deg: float, phi_d_deg: float, phi_deg: float) -> Slice:
    """Return the cut over θh, 0…90°, at θd and φd in degrees; the half vector tips towards the mirror's side."""
    angles = _HALF_ANGLES
    wi, wo = from_half_angle_coordinates(
        np.radians(angles), np.radians(phi_deg), np.radians(theta_d_deg), np.radians(phi_d_deg)
    )
    return Slice("theta_h", angles, wi, wo, _above(wi, wo))


def difference_slice(theta_h_deg: float, phi_d_deg: float, phi_deg: float) -> Slice:
    """Return the cut over θd, 0…90°, at θh and φd in degrees."""
    angles = _DIFFERENCE_ANGLES
    wi, wo = from_half_angle_coordinates(
        np.radians(theta_h_deg), np.radians(phi_deg), np.radians(angles), np.radians(phi_d_deg)
    )
    return Slice("theta_d", angles, wi, wo, _above(wi, wo))


def _above(wi: Floats, wo: Floats) -> Bools:
    # The last hundredth of a degree is left out: there the light's cosine is rounding.
    least = np.cos(np.radians(HORIZON_DEG))
    return np.asarray((wi[:, 2] > least) & (wo[:, 2] > least))
