"""The ten parameters of the rig's geometry, and how well the highlights determine each."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, triple, unit
from brdf_suite.arrays import Floats

# What a stated number is trusted to, where nothing better is known: a careful hand with a ruler.
_ANGLE_DEG = 1.0
_TILT_DEG = 0.3
_LENGTH = 0.01
_LENGTH_M = 0.002
_MOUNT = 0.02
_CENTRE_PX = 3.0
_DISTANCE = 0.01


@dataclass(frozen=True)
class RefinedValue:
    """A fitted parameter before and after the refinement.

    Attributes
    ----------
    name, unit
        In words; "m" or "°".
    stated, stated_sigma
        By the session or the outline, and what that is trusted to (one standard deviation).
    value, sigma
        After the fit.
    observed
        0: not determined by the highlights, 1: by them alone; 1 - (sigma/stated_sigma)².
    why
        What makes it visible or hides it.
    """

    name: str
    unit: str
    stated: float
    stated_sigma: float
    value: float
    sigma: float
    observed: float
    why: str


@dataclass(frozen=True)
class RefinedParameter:
    """A parameter of the fit: its name, and its value in a geometry."""

    name: str
    unit: str
    of: Callable[[RigGeometry], float]
    why: str

    def refined(
        self, before: RigGeometry, after: RigGeometry, prior: float, posterior: float
    ) -> RefinedValue:
        """Return the number before and after, with standard deviations in its own unit."""
        return RefinedValue(
            self.name,
            self.unit,
            self.of(before),
            prior,
            self.of(after),
            posterior,
            max(0.0, 1.0 - (posterior / prior) ** 2),
            self.why,
        )


PARAMETERS: tuple[RefinedParameter, ...] = (
    RefinedParameter(
        "sphere's centre, to the right",
        "m",
        lambda g: g.centre_m[0],
        "Determined by the outline. A highlight moves with the sphere at any angle of the light, but also with the "
        "turntable's zero; only their difference over the half turn distinguishes them.",
    ),
    RefinedParameter(
        "sphere's centre, downward",
        "m",
        lambda g: g.centre_m[1],
        "Determined by the outline. The highlights add little, as the light's height moves them alike.",
    ),
    RefinedParameter(
        "sphere's centre, away from the camera",
        "m",
        lambda g: g.centre_m[2],
        "Determined by the size of the outline, from the sphere's radius. Highlights far from the middle of the sphere "
        "determine the size as well.",
    ),
    RefinedParameter(
        "turntable's zero",
        "°",
        lambda g: g.angle_offset_deg,
        "Moves every highlight along the sphere, by half the angle; the best observed of all.",
    ),
    RefinedParameter(
        "light's height",
        "m",
        lambda g: g.light_height_m,
        "Raises every highlight alike; well observed as an angle, in metres as well as the light's distance is known.",
    ),
    RefinedParameter(
        "light's distance",
        "m",
        lambda g: g.light_distance_m,
        "Hardly observed: with it all directions to the light stay the same but for the parallax between points of "
        "the sphere, of the order of radius over distance. It enters the irradiance, which is measured at the axis.",
    ),
    RefinedParameter(
        "turntable's tilt to the camera",
        "°",
        lambda g: math.degrees(math.asin(float(np.clip(unit(g.up)[2], -1.0, 1.0)))),
        "Raises the highlights in front and lowers those behind, as the cosine of the angle; the light's height does "
        "it alike at all angles.",
    ),
    RefinedParameter(
        "turntable's tilt to the right",
        "°",
        lambda g: math.degrees(math.asin(float(np.clip(unit(g.up)[0], -1.0, 1.0)))),
        "Lowers the highlights at 90° against those in front and behind; without positions beyond 90° it looks like "
        "the light's height.",
    ),
    RefinedParameter(
        "sphere off the axis, to the right",
        "m",
        lambda g: g.axis_offset_m[0],
        "Turns the light by the offset over its distance in front and behind and not at 90°: weakly observed, and weak "
        "in its effect.",
    ),
    RefinedParameter(
        "sphere off the axis, to the camera",
        "m",
        lambda g: g.axis_offset_m[1],
        "Turns the light at 90° and not in front and behind; half of it looks like the turntable's zero.",
    ),
)


def priors(geometry: RigGeometry, outline: SphereOutline | None) -> Floats:
    """Return the covariance (10, 10) of the stated numbers: metres² and degrees²."""
    across = _CENTRE_PX * geometry.centre_m[2] / geometry.lens.fx
    length = math.hypot(_LENGTH_M, _LENGTH * geometry.light_distance_m)
    mount = _MOUNT * geometry.radius_m + 0.2 * _LENGTH_M
    away = _DISTANCE * geometry.centre_m[2]
    sigma = (across, across, away, _ANGLE_DEG, length, length, _TILT_DEG, _TILT_DEG, mount, mount)
    covariance: Floats = np.diag(np.array(sigma) ** 2)
    if outline is not None:
        covariance[:3, :3] = outline.covariance
    return covariance


def apply(geometry: RigGeometry, x: Floats) -> RigGeometry:
    """Return the geometry with numbers changed by ``x`` (10,): metres, and degrees of angles."""
    up = unit(geometry.up)
    tilted = up + np.array((math.radians(x[7]), 0.0, math.radians(x[6])))
    return replace(
        geometry,
        centre_m=triple(geometry.centre + x[:3]),
        angle_offset_deg=geometry.angle_offset_deg + float(x[3]),
        light_height_m=geometry.light_height_m + float(x[4]),
        light_distance_m=geometry.light_distance_m + float(x[5]),
        up=triple(unit(tilted)),
        axis_offset_m=(geometry.axis_offset_m[0] + float(x[8]), geometry.axis_offset_m[1] + float(x[9])),
    )
