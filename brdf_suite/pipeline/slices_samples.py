"""Measured samples that lie in a cut, or nearly: the points that are drawn beside its line.

A sample counts where it is as near to the cut as :data:`NEAR_DEG`: in the plane of incidence its light is that near to
the cut's light and its view that near to the plane; over θh or θd the other coordinates are. Samples are reciprocal:
each stands for the pair and its swap; isotropic ones for every azimuth, and for their mirror image.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from brdf_suite.geometry.directions import Floats, half_angle_coordinates
from brdf_suite.pipeline.slices import Bools, Slice
from brdf_suite.pipeline.slices_values import Cosine, cosine_of

NEAR_DEG = 2.5


class Samples(Protocol):
    """``wi``, ``wo`` (n, 3) and ``values`` (n, 3), f_r in 1/sr."""

    @property
    def wi(self) -> Floats:
        """Directions to the light."""
        ...

    @property
    def wo(self) -> Floats:
        """Directions to the viewer."""
        ...

    @property
    def values(self) -> Floats:
        """f_r in 1/sr."""
        ...


@dataclass(frozen=True, eq=False)
class SlicePoints:
    """Samples near a cut: their place along its angle, degrees (k,), and their values, (k, 3) or one channel (k,)."""

    angle_deg: Floats
    value: Floats


def points_near(cut: Slice, samples: Samples, *, isotropic: bool, cosine: Cosine) -> SlicePoints:
    """Return the samples near ``cut``, their values times ``cosine``."""
    wi = np.concatenate((samples.wi, samples.wo))
    wo = np.concatenate((samples.wo, samples.wi))
    value = np.concatenate((samples.values, samples.values))
    if cosine != "none":
        value = value * cosine_of(cosine, wi, wo)[:, None]
    plane = cut.axis in ("gamma", "theta_o")
    angle, near = (_in_plane if plane else _at_half_angles)(cut, wi, wo, isotropic)
    return SlicePoints(angle[near], value[near])


def _in_plane(cut: Slice, wi: Floats, wo: Floats, isotropic: bool) -> tuple[Floats, Bools]:
    light = cut.wi[0]
    azimuth = np.arctan2(-light[1], -light[0])
    theta = np.degrees(np.arccos(np.clip(light[2], -1.0, 1.0)))
    if isotropic:
        # Turned until the light stands in the plane; at the normal it does anyway.
        turn = np.where(np.hypot(wi[:, 0], wi[:, 1]) > 1e-9, np.arctan2(-wi[:, 1], -wi[:, 0]), azimuth)
    else:
        turn = np.full(len(wi), azimuth)
    cos, sin = np.cos(turn), np.sin(turn)
    along, across = cos * wo[:, 0] + sin * wo[:, 1], cos * wo[:, 1] - sin * wo[:, 0]
    polar = np.degrees(np.arctan2(along, wo[:, 2]))
    beside = np.degrees(np.arcsin(np.clip(np.abs(across), 0.0, 1.0)))
    if isotropic:
        apart = np.abs(np.degrees(np.arccos(np.clip(wi[:, 2], -1.0, 1.0))) - theta)
    else:
        apart = np.degrees(np.arccos(np.clip(wi @ light, -1.0, 1.0)))
    near = (apart <= NEAR_DEG) & (beside <= NEAR_DEG)
    # A sample keeps its distance from its own mirror direction, which is where peaks are.
    own = np.degrees(np.arccos(np.clip(wi[:, 2], -1.0, 1.0)))
    gamma = own - polar
    return (gamma if cut.axis == "gamma" else theta - gamma), near


def _at_half_angles(cut: Slice, wi: Floats, wo: Floats, isotropic: bool) -> tuple[Floats, Bools]:
    middle = len(cut.angle_deg) // 2
    fixed = np.degrees(half_angle_coordinates(cut.wi[middle], cut.wo[middle]))
    found = np.degrees(half_angle_coordinates(wi, wo))
    running, other = (0, 2) if cut.axis == "theta_h" else (2, 0)
    near = np.abs(found[other] - fixed[other]) <= NEAR_DEG
    # cosθi - cosθo = 2 sinθh sinθd cosφd: all that φd does to an isotropic pair.
    own, wanted = (np.radians(angles) for angles in (found, fixed))
    tipped = np.sin(own[0]) * np.sin(own[2])
    near &= np.abs(tipped * (np.cos(own[3]) - np.cos(wanted[3]))) <= np.sin(np.radians(NEAR_DEG))
    if not isotropic:
        facing = np.abs((found[1] - fixed[1] + 180.0) % 360.0 - 180.0)
        near &= facing * np.sin(own[0]) <= NEAR_DEG
        turned = np.abs((found[3] - fixed[3] + 180.0) % 360.0 - 180.0)
        near &= turned * tipped <= NEAR_DEG
    return np.asarray(found[running]), near
