"""Measured samples that lie in a cut, or nearly: the points that are drawn beside its line.

A sample counts where it is as near to the cut as :data:`NEAR_DEG`: in the plane of incidence its light is that near to
the cut's light and its view that near to the plane; over θh or θd the other coordinates are. Samples are reciprocal:
each stands for the pair and its swap; isotropic ones for every azimuth, and for their mirror image.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from functools import lru_cache
from typing import Protocol

import numpy as np

from brdf_suite.arrays import Bools, Floats
from brdf_suite.geometry.directions import half_angle_coordinates
from brdf_suite.inspection.slices.cuts import Slice
from brdf_suite.inspection.slices.values import Cosine, cosine_of

NEAR_DEG = 2.5


class Samples(Hashable, Protocol):
    """``wi``, ``wo`` (n, 3) and ``values`` (n, 3), f_r in 1/sr; compared by identity, and never changed."""

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
    wi, wo, value = _both_ways(samples)
    plane = cut.axis in ("gamma", "theta_o")
    angle, near = (_in_plane if plane else _at_half_angles)(cut, samples, isotropic)
    found = value[near]
    if cosine != "none":
        found = found * cosine_of(cosine, wi[near], wo[near])[:, None]
    return SlicePoints(angle[near], found)


# A drag asks for the points of every step: what does not hang on the cut is worked out once for each set of samples.


@lru_cache(maxsize=8)
def _both_ways(samples: Samples) -> tuple[Floats, Floats, Floats]:
    return (
        np.concatenate((samples.wi, samples.wo)),
        np.concatenate((samples.wo, samples.wi)),
        np.concatenate((samples.values, samples.values)),
    )


@lru_cache(maxsize=8)
def _planes(samples: Samples) -> tuple[Floats, Floats, Floats]:
    """Return, in degrees, the light's polar angle, γ, and how far the view is out of the light's own plane."""
    wi, wo, _ = _both_ways(samples)
    # At the normal any plane is the light's own: the view's.
    flat = np.hypot(wi[:, 0], wi[:, 1]) > 1e-9
    turn = np.where(flat, np.arctan2(-wi[:, 1], -wi[:, 0]), np.arctan2(wo[:, 1], wo[:, 0]))
    return _seen_from(wi, wo, turn)


@lru_cache(maxsize=8)
def _half_angles(samples: Samples) -> tuple[Floats, Floats, Floats, Floats]:
    wi, wo, _ = _both_ways(samples)
    theta_h, phi_h, theta_d, phi_d = half_angle_coordinates(wi, wo)
    return theta_h, phi_h, theta_d, phi_d


def _seen_from(wi: Floats, wo: Floats, turn: Floats) -> tuple[Floats, Floats, Floats]:
    cos, sin = np.cos(turn), np.sin(turn)
    along, across = cos * wo[:, 0] + sin * wo[:, 1], cos * wo[:, 1] - sin * wo[:, 0]
    polar = np.degrees(np.arctan2(along, wo[:, 2]))
    theta = np.degrees(np.arccos(np.clip(wi[:, 2], -1.0, 1.0)))
    # A sample keeps its distance from its own mirror direction, which is where peaks are.
    return theta, theta - polar, np.degrees(np.arcsin(np.clip(np.abs(across), 0.0, 1.0)))


def _in_plane(cut: Slice, samples: Samples, isotropic: bool) -> tuple[Floats, Bools]:
    light = cut.wi[0]
    theta = float(np.degrees(np.arccos(np.clip(light[2], -1.0, 1.0))))
    if isotropic:
        # Turned until the light stands in the plane.
        own, gamma, beside = _planes(samples)
        apart = np.abs(own - theta)
    else:
        wi, wo, _ = _both_ways(samples)
        _, gamma, beside = _seen_from(wi, wo, np.full(len(wi), np.arctan2(-light[1], -light[0])))
        apart = np.degrees(np.arccos(np.clip(wi @ light, -1.0, 1.0)))
    near = (apart <= NEAR_DEG) & (beside <= NEAR_DEG)
    return (gamma if cut.axis == "gamma" else theta - gamma), near


def _at_half_angles(cut: Slice, samples: Samples, isotropic: bool) -> tuple[Floats, Bools]:
    middle = len(cut.angle_deg) // 2
    wanted = half_angle_coordinates(cut.wi[middle], cut.wo[middle])
    found = _half_angles(samples)
    running, other = (0, 2) if cut.axis == "theta_h" else (2, 0)
    tolerance = np.radians(NEAR_DEG)
    near = np.abs(found[other] - wanted[other]) <= tolerance
    # cosθi - cosθo = 2 sinθh sinθd cosφd: all that φd does to an isotropic pair.
    tipped = np.sin(found[0]) * np.sin(found[2])
    near &= np.abs(tipped * (np.cos(found[3]) - np.cos(wanted[3]))) <= np.sin(tolerance)
    if not isotropic:
        near &= np.abs(_turn(found[1] - wanted[1])) * np.sin(found[0]) <= tolerance
        near &= np.abs(_turn(found[3] - wanted[3])) * tipped <= tolerance
    return np.degrees(found[running]), near


def _turn(angle: Floats) -> Floats:
    """Return angles (...) in radians brought into [-π, π)."""
    return np.asarray((angle + np.pi) % (2.0 * np.pi) - np.pi)
