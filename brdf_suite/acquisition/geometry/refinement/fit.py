"""The rig's ten parameters, their robust Gauss-Newton fit to highlights, and detection of outliers and movements.

With x the changes of the ten numbers, S the slopes of the highlights' places, w Huber's weights over their standard
errors and P the covariance of the statements, each step solves

    minimize |w (off + S Δ)|² + (x + Δ)·P⁻¹ (x + Δ)

for Δ. The inverse of the same matrix at the end is the covariance of what was found.

A sphere that moves takes its highlights with it, from one position on. For each place in the series the fit is
asked how much better it would be with the sphere shifted from there on - two numbers more, in the linear form of the
fit, all others free to follow. The best place is taken where that cannot be chance and the shift can be seen; then the
next one, with the first in place.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.acquisition.geometry.sphere.highlight import Highlight
from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, unit
from brdf_suite.arrays import Bools, Floats, Indices, triple
from brdf_suite.progress import Progress, report

# What a stated number is trusted to, where nothing better is known: a careful hand with a ruler.
_ANGLE_DEG = 1.0
_TILT_DEG = 0.3
_LENGTH = 0.01
_LENGTH_M = 0.002
_MOUNT = 0.02
_CENTRE_PX = 3.0
_DISTANCE = 0.01
_STEPS = 40
_SPREAD = 1.4826  # of a normal distribution, over the median absolute deviation
_HUBER = 1.5
_OUTLIER = 5.0
_OUTLIER_PX = 0.5
_STEADY = 1e-4  # of a standard deviation
_LEAST_PX = 0.4
_LEAST_SIGNIFICANCE = 8.0
_MOST = 4
_LEAST_EACH_SIDE = 2
_CLIP = 12.0  # standard deviations that one coordinate may count for
# The stated values have entered the fit already and should not hold the shift back.
_LOOSE = 0.1


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
        stated, value = self.of(before), self.of(after)
        observed = max(0.0, 1.0 - (posterior / prior) ** 2)
        return RefinedValue(self.name, self.unit, stated, prior, value, posterior, observed, self.why)


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


@dataclass(frozen=True)
class HighlightSeries:
    """The highlights as arrays, and the rig as stated."""

    start: RigGeometry
    positions: Indices
    angles: Floats
    seen: Floats
    sigma: Floats

    @classmethod
    def of(cls, start: RigGeometry, highlights: Sequence[Highlight]) -> HighlightSeries:
        """Return the highlights in order of their positions."""
        rows = sorted(highlights, key=lambda row: row.position)
        positions = np.array([row.position for row in rows], np.intp)
        pixels, sigma = np.array([row.pixel for row in rows]), np.array([row.sigma_px for row in rows])
        return cls(start, positions, np.array(start.angles_deg)[positions], pixels, sigma)

    def residuals(self, x: Floats) -> Floats:
        """Return seen less expected (n, 2), pixels, with the rig's numbers changed by ``x``."""
        expected = apply(self.start, x).highlights(self.angles)
        # Out of sight at a step too far: as wrong as the sphere is large.
        lost = math.tan(self.start.outline_angle) * self.start.lens.fx
        return np.where(np.isfinite(expected), self.seen - expected, lost)


@dataclass(frozen=True)
class RigFit:
    """Fitted changes ``x`` (p,) of the parameters, residuals ``off`` (n, 2), and their ``slopes`` (n, 2, p).

    ``posterior`` (p, p): covariance of the numbers, metres² and degrees².
    """

    x: Floats
    off: Floats
    slopes: Floats
    posterior: Floats


def fit_rig(series: HighlightSeries, prior: Floats, kept: Bools, progress: Progress | None) -> RigFit:
    """Return the numbers that the highlights ``kept`` and the statements (covariance ``prior``) agree with best."""
    lower = np.linalg.inv(np.linalg.cholesky(prior))  # whitens the statements' errors
    scale = np.sqrt(np.diag(prior))
    x = np.zeros(len(PARAMETERS))
    for step in range(_STEPS):
        report(progress, step / _STEPS, "refining the light's position")
        off, slopes = series.residuals(x), _slopes(series.residuals, x, scale)
        weight = _weights(off, series.sigma, kept)
        system = np.concatenate(((slopes * weight[:, None, None]).reshape(-1, len(x)), lower))
        wanted = np.concatenate((-(off * weight[:, None]).ravel(), -lower @ x))
        change = np.linalg.lstsq(system, wanted)[0]
        x = x + change
        if float(np.abs(change / scale).max()) < _STEADY:
            break
    off, slopes = series.residuals(x), _slopes(series.residuals, x, scale)
    white = (slopes * _weights(off, series.sigma, kept)[:, None, None]).reshape(-1, len(x))
    return RigFit(x, off, slopes, np.linalg.inv(white.T @ white + lower.T @ lower))


def _weights(off: Floats, sigma: Floats, kept: Bools) -> Floats:
    """Return Huber's weights (n,) over the standard errors, these as large as the residuals show them to be."""
    length = np.linalg.norm(off, axis=-1) / sigma
    spread = max(_SPREAD * float(np.median(length[kept])), 1.0)
    weight: Floats = np.sqrt(np.minimum(1.0, _HUBER * spread / np.maximum(length, 1e-12)))
    return weight * kept / (sigma * spread)


def stray(off: Floats, sigma: Floats) -> Bools:
    """Return the highlights (n,) that are far from where both of their neighbours in the series say.

    Where the sphere has moved a highlight still agrees with one of them.
    """
    step = np.linalg.norm(np.diff(off, axis=0), axis=-1)
    usual = _SPREAD * float(np.median(step))
    # The first and the last are compared with the two next to them.
    before = np.concatenate((np.linalg.norm(off[:1] - off[2:3], axis=-1), step))
    after = np.concatenate((step, np.linalg.norm(off[-1:] - off[-3:-2], axis=-1)))
    return np.asarray(
        np.minimum(before, after) > np.maximum(_OUTLIER * np.maximum(usual, sigma), _OUTLIER_PX)
    )


def find_outliers(off: Floats, sigma: Floats, kept: Bools) -> Bools:
    """Return the highlights (n,) that are off by far more than those ``kept`` usually are."""
    length = np.linalg.norm(off, axis=-1)
    middle = _SPREAD * float(np.median(length[kept]))
    return np.asarray(length > np.maximum(_OUTLIER * np.maximum(middle, sigma), _OUTLIER_PX))


def _slopes(residuals: Callable[[Floats], Floats], x: Floats, scale: Floats) -> Floats:
    """Return the derivatives (n, 2, parameters) of the residuals."""
    steps = 0.01 * scale * np.eye(len(x))
    columns = [(residuals(x + e) - residuals(x - e)) / (2.0 * e.sum()) for e in steps]
    return np.stack(columns, axis=-1)


@dataclass(frozen=True)
class Movement:
    """The sphere moved after position ``before`` and not later than position ``after`` (indices).

    ``pixels``: by how much, x and y, in the picture; ``significance``: in standard deviations.
    """

    before: int
    after: int
    pixels: tuple[float, float]
    significance: float

    @property
    def distance_px(self) -> float:
        """Return how far, pixels."""
        return math.hypot(*self.pixels)


def find_movements(
    positions: Indices, off: Floats, slopes: Floats, sigma: Floats, lower: Floats
) -> tuple[Movement, ...]:
    """Return the movements, in order of the positions.

    Parameters
    ----------
    positions
        (n,) rising indices of the light's positions with a highlight.
    off
        (n, 2) seen less expected, pixels, after the fit.
    slopes
        (n, 2, p) derivatives of ``off``; of these the first three are the sphere's centre.
    sigma
        (n,) standard errors, pixels.
    lower
        (p, p) whitens the stated numbers' errors.
    """
    count, parameters = len(positions), slopes.shape[-1]
    splits: list[int] = []
    found: dict[int, tuple[Floats, float]] = {}
    if count < 4 * _LEAST_EACH_SIDE:
        return ()
    # Only what changes from one highlight to the next is noise; a movement is one such step among many.
    noise = _SPREAD * float(np.median(np.abs(np.diff(off, axis=0)) / sigma[1:, None])) / math.sqrt(2.0)
    weight = 1.0 / np.maximum(sigma * max(noise, 0.1), 0.02)
    base = np.concatenate(((slopes * weight[:, None, None]).reshape(-1, parameters), _LOOSE * lower), axis=0)
    wanted = np.concatenate((-(off * weight[:, None]).ravel(), np.zeros(parameters)))

    def step(split: int) -> Floats:
        columns = np.zeros((count, 2, 2))
        columns[split:] = np.eye(2)
        return np.concatenate(((columns * weight[:, None, None]).reshape(-1, 2), np.zeros((parameters, 2))))

    def misfit(chosen: Sequence[int]) -> tuple[float, Floats]:
        system = np.concatenate((base, *(step(split) for split in chosen)), axis=1)
        answer = np.asarray(np.linalg.lstsq(system, wanted)[0], float)
        rest = np.clip(system @ answer - wanted, -_CLIP, _CLIP)
        return float(rest @ rest), answer[parameters:].reshape(-1, 2)

    current = misfit(())[0]
    for _ in range(_MOST):
        tried = [s for s in range(_LEAST_EACH_SIDE, count - _LEAST_EACH_SIDE + 1) if s not in splits]
        sums = [misfit((*splits, s))[0] for s in tried]
        place = int(np.argmin(sums))
        better, shifts = misfit((*splits, tried[place]))
        significance = math.sqrt(max(current - better, 0.0))
        if significance < _LEAST_SIGNIFICANCE or float(np.linalg.norm(shifts[-1])) < _LEAST_PX:
            break
        splits.append(tried[place])
        found = {s: (shift, significance) for s, shift in zip(splits, shifts, strict=True)}
        current = better
    return tuple(
        Movement(int(positions[s - 1]), int(positions[s]), (float(-x), float(-y)), significance)
        for s, ((x, y), significance) in sorted(found.items())
    )
