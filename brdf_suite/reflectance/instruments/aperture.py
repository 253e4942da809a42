"""Finite apertures of an instrument: cones of incidence and collection.

The reading of an instrument whose light fills the cone Ωi evenly and whose receptor collects from the cone Ωo evenly,
relative to a perfect diffuser, is

    ρ = π ∫∫ f_r cosθi cosθo dωi dωo / ∫∫ cosθi cosθo dωi dωo,    wi in Ωi, wo in Ωo, both above the horizon.

Each cone is a disc of directions, integrated by Gauss-Legendre rings, even in solid angle, and evenly spaced azimuths:
the same numbers on every run.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.protocol import Reflectance

LARGEST_HALF_ANGLE_DEG = 20.0
_AZIMUTHS_PER_RING = 3
_RING_COUNTS = (2, 4, 8)
# Relative to the reading: a tenth of what a colour difference of .05 would be.
_SETTLED = 3e-4


@dataclass(frozen=True)
class Aperture:
    """Half-angles of the light's and of the receptor's cone, degrees; 0 is a single direction."""

    name: str
    light_deg: float
    receptor_deg: float

    def __post_init__(self) -> None:
        for place, value in (("light_deg", self.light_deg), ("receptor_deg", self.receptor_deg)):
            if not 0.0 <= value <= LARGEST_HALF_ANGLE_DEG:
                raise ValueRangeError(
                    place, f"expected a half-angle from 0 to {LARGEST_HALF_ANGLE_DEG:g}°, not {value:g}°"
                )

    @property
    def title(self) -> str:
        """Return the half-angles as text."""
        if self.light_deg == self.receptor_deg == 0.0:
            return "no aperture (single directions)"
        return f"half-angles: light {self.light_deg:g}°, receptor {self.receptor_deg:g}°"


POINT = Aperture("point", 0.0, 0.0)
NARROW = Aperture("narrow", 1.0, 2.0)
WIDE = Aperture("wide", 2.0, 4.0)
APERTURES: dict[str, Aperture] = {aperture.name: aperture for aperture in (POINT, NARROW, WIDE)}
"""Named apertures. The makers of instruments do not publish theirs: these are ours, for comparison."""


def aperture(text: str) -> Aperture:
    """Return a named aperture, or one from ``RECEPTOR`` or ``LIGHT,RECEPTOR``, half-angles in degrees.

    >>> aperture("3").title
    'half-angles: light 0°, receptor 3°'
    """
    if text in APERTURES:
        return APERTURES[text]
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) not in (1, 2):
        raise ValueRangeError(
            "aperture",
            f"{text!r} is neither a name ({', '.join(APERTURES)}) nor half-angles in degrees, RECEPTOR or "
            "LIGHT,RECEPTOR",
        )
    return Aperture("user-defined", 0.0 if len(numbers) == 1 else numbers[0], numbers[-1])


def reflectance_factor(
    reflectance: Reflectance, wi: npt.ArrayLike, wo: npt.ArrayLike, through: Aperture = POINT
) -> tuple[Floats, float]:
    """Return ρ (3,), working space, about the directions ``wi``, ``wo`` (3,), and how sure the integral is.

    The second is the largest change of a channel, relative to the largest channel, between the last two refinements;
    0 without an aperture.
    """
    wi, wo = np.asarray(wi, float), np.asarray(wo, float)
    if through.light_deg == through.receptor_deg == 0.0:
        return np.asarray(math.pi * reflectance.eval(wi, wo)), 0.0
    value, change = _integrate(reflectance, wi, wo, through, _RING_COUNTS[0]), math.inf
    for rings in _RING_COUNTS[1:]:
        finer = _integrate(reflectance, wi, wo, through, rings)
        change = float(np.abs(finer - value).max() / max(float(finer.max()), 1e-12))
        value = finer
        if change <= _SETTLED:
            break
    return value, change


def _integrate(reflectance: Reflectance, wi: Floats, wo: Floats, through: Aperture, rings: int) -> Floats:
    lights, light_weights = cone(wi, through.light_deg, rings)
    views, view_weights = cone(wo, through.receptor_deg, rings)
    seen = light_weights * np.maximum(lights[:, 2], 0.0)
    collected = view_weights * np.maximum(views[:, 2], 0.0)
    values = reflectance.eval(lights[:, None, :], views[None, :, :])
    total = np.einsum("i,j,ijc->c", seen, collected, values)
    return np.asarray(math.pi * total / (seen.sum() * collected.sum()))


def cone(axis: npt.ArrayLike, half_angle_deg: float, rings: int) -> tuple[Floats, Floats]:
    """Return directions (n, 3) in a cone about ``axis`` (3,) and weights (n,) that sum to 1, even in solid angle."""
    axis = np.asarray(axis, float)
    if half_angle_deg == 0.0:
        return axis[None, :], np.ones(1)
    directions, weights = _cone_about_z(math.cos(math.radians(half_angle_deg)), rings)
    # Any frame about the axis will do; this one keeps the disc symmetric about the plane of incidence.
    side = np.array([0.0, 1.0, 0.0]) if abs(axis[1]) < 0.9 else np.array([1.0, 0.0, 0.0])
    along = np.cross(side, axis)
    along /= np.linalg.norm(along)
    frame = np.stack((along, np.cross(axis, along), axis))
    return np.asarray(directions @ frame), weights


@cache
def _cone_about_z(cos_half: float, rings: int) -> tuple[Floats, Floats]:
    nodes, shares = np.polynomial.legendre.leggauss(rings)
    cos_theta = 1.0 - (1.0 - cos_half) * 0.5 * (nodes + 1.0)
    count = _AZIMUTHS_PER_RING * rings
    # Half a step off the plane of incidence, and every other ring a further half, so that rings do not line up.
    steps = np.arange(count)[None, :] + 0.5 * (np.arange(rings) % 2)[:, None] + 0.5
    phi = 2.0 * math.pi * steps / count
    sin_theta = np.sqrt(np.maximum(1.0 - cos_theta**2, 0.0))[:, None]
    directions = np.stack(
        (sin_theta * np.cos(phi), sin_theta * np.sin(phi), np.broadcast_to(cos_theta[:, None], phi.shape)),
        axis=-1,
    )
    weights = np.broadcast_to(0.5 * shares[:, None] / count, phi.shape)
    return directions.reshape(-1, 3), weights.reshape(-1)
