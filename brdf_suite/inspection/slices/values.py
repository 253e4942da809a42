"""The values along cuts: all directions of one reflectance in one call, one channel of them, target against fit.

Measured samples that lie in a cut, or nearly, are drawn beside its line. A sample counts where it is as near to the cut
as :data:`NEAR_DEG`: in the plane of incidence its light is that near to the cut's light and its view that near to the
plane; over θh or θd the other coordinates are. Samples are reciprocal: each stands for the pair and its swap; isotropic
ones for every azimuth, and for their mirror image.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal, Protocol

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Bools, Floats
from brdf_suite.foreign_text import guard_formula
from brdf_suite.geometry.directions import half_angle_coordinates
from brdf_suite.inspection.slices.cuts import Slice

Channel = Literal["colour", "r", "g", "b", "luminance"]
Scale = Literal["linear", "cbrt", "log"]
Cosine = Literal["none", "light", "both"]
"""What f_r is multiplied with: nothing (1/sr), N·L (reflected radiance), N·L and N·V (intensity)."""
_CHANNELS = ("r", "g", "b")

LOG_DECADES = 6.0
"""A logarithmic radius goes from so many decades below its outer end, the middle of the plot, to there."""


class Evaluated(Protocol):
    """Anything with ``eval``: a reflectance, or the lobes of a fit."""

    def eval(self, wi: Floats, wo: Floats, /) -> npt.ArrayLike:
        """Return f_r (..., 3) in 1/sr, linear Rec. 2020, without the cosine."""
        ...


def evaluate(reflectance: Evaluated, slices: Sequence[Slice], *, cosine: Cosine) -> list[Floats]:
    """Return f_r (n, 3) in 1/sr along each cut, times ``cosine``; NaN below the horizon.

    One call of ``eval`` for all cuts: what a model does before it looks at directions is done once. What the
    reflectance itself gives as not finite becomes NaN.
    """
    if not slices:
        return []
    wi = np.concatenate([cut.wi for cut in slices])
    wo = np.concatenate([cut.wo for cut in slices])
    above = np.concatenate([cut.above for cut in slices])
    with np.errstate(all="ignore"):  # a reflectance with holes of NaN is shown, and its holes with it
        value = np.array(reflectance.eval(wi, wo), np.float64)
    if cosine != "none":
        value *= cosine_of(cosine, wi, wo)[:, None]
    value[~(above & np.isfinite(value).all(axis=1))] = np.nan
    ends = np.cumsum([len(cut.angle_deg) for cut in slices])[:-1]
    return np.split(value, ends)


def cosine_of(cosine: Cosine, wi: Floats, wo: Floats) -> Floats:
    """Return what f_r is multiplied with, (...), for directions (..., 3) that broadcast."""
    light, view = np.broadcast_arrays(wi[..., 2], wo[..., 2])
    if cosine == "both":
        return np.asarray(light * view)
    return np.asarray(light) if cosine == "light" else np.ones(light.shape)


def channel_of(value: Floats, channel: Channel) -> Floats:
    """Return one channel (...) of values (..., 3); for ``"colour"`` the luminance Y, which stands for it in a line."""
    if channel in _CHANNELS:
        return np.asarray(value[..., _CHANNELS.index(channel)])
    return np.asarray(value @ LUMINANCE)


def radius_of(value: Floats, scale: Scale, outer: float) -> Floats:
    """Return distances (...) from the middle, 1 for the value ``outer`` > 0; NaN stays NaN.

    ``"log"``: :data:`LOG_DECADES` below ``outer`` and less is the middle.
    """
    share = np.maximum(np.asarray(value, float), 0.0) / outer
    if scale == "linear":
        return np.asarray(share)
    if scale == "cbrt":
        return np.asarray(np.cbrt(share))
    with np.errstate(divide="ignore"):
        return np.asarray(np.maximum(1.0 + np.log10(share) / LOG_DECADES, 0.0))


@dataclass(frozen=True)
class SliceError:
    """How far a line is from another: ``rms`` in the line's unit, ``relative`` to the first's own RMS, both ≥ 0.

    ``worst`` is the largest difference, at ``worst_deg``. Along a cut, weighted by the steps between its angles:
    angles that lie close about the mirror direction count no more than the others.
    """

    rms: float
    relative: float
    worst: float
    worst_deg: float


def slice_error(angle_deg: Floats, target: Floats, fit: Floats) -> SliceError | None:
    """Return the error of ``fit`` (n,) against ``target`` (n,) over ``angle_deg`` (n,); None: nothing is common."""
    known = np.isfinite(target) & np.isfinite(fit)
    if not known.any():
        return None
    steps = np.gradient(angle_deg) if len(angle_deg) > 1 else np.ones(1)
    weight = np.where(known, steps, 0.0)
    difference = np.where(known, fit - target, 0.0)
    whole = weight.sum()
    rms = float(np.sqrt((weight * difference**2).sum() / whole))
    own = float(np.sqrt((weight * np.where(known, target, 0.0) ** 2).sum() / whole))
    worst = int(np.argmax(np.abs(difference)))
    relative = rms / own if own > 0.0 else (0.0 if rms == 0.0 else np.inf)
    return SliceError(rms, relative, float(difference[worst]), float(angle_deg[worst]))


_NICE = (1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)


def nice_above(value: float) -> float:
    """Return the smallest round number at or above ``value`` > 0: ends of axes that stay while a line moves a little.

    >>> nice_above(0.0123), nice_above(5.0)
    (0.015, 5.0)
    """
    decade = 10.0 ** np.floor(np.log10(value))
    for step in _NICE:
        if value <= step * decade * (1.0 + 1e-9):
            return float(f"{step * decade:.3g}")
    return float(f"{10.0 * decade:.3g}")


def slices_csv(angle: str, angle_deg: Floats, columns: Sequence[tuple[str, Floats]], comment: str) -> str:
    """Return the text: ``angle`` and each of ``columns`` (name with unit, (n,)) over ``angle_deg`` (n,).

    ``comment`` is one line at the top.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([angle, *(guard_formula(name) for name, _ in columns)])
    out.write("# " + " ".join(comment.split()) + "\n")
    for row, place in enumerate(angle_deg.tolist()):
        values = [float(value[row]) for _, value in columns]
        writer.writerow([repr(place), *(repr(v) if math.isfinite(v) else "" for v in values)])
    return out.getvalue()


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
    return half_angle_coordinates(wi, wo)


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
