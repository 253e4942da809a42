"""Sphere, turntable and light together, from the highlights at all angles: a robust least-squares fit.

Ten numbers place everything (:mod:`brdf_suite.acquisition.refined_parameters` says what the photographs can tell
of each). For each the session's statement, or the outline's, counts as one measurement with its own uncertainty; each
highlight gives two, its place in pixels. All are met in the sense of least squares, with Huber's weights for the
highlights, by Gauss and Newton's steps. So a number that no highlight can tell stays as stated, and one that they can
tell is told by them.

The sum of the mirrored places is nearly blind to the size of the rig, and sharp on angles: that is why the light's
distance is hardly better known afterwards, while the zero of the turntable is, to some thousandths of a degree.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.refined_movement import Movement, find_movements
from brdf_suite.acquisition.refined_parameters import PARAMETERS, Refined, apply, priors
from brdf_suite.acquisition.sphere_geometry import Geometry
from brdf_suite.acquisition.sphere_highlight import Highlight
from brdf_suite.acquisition.sphere_outline import Outline
from brdf_suite.errors import AcquisitionError
from brdf_suite.geometry.directions import Floats
from brdf_suite.progress import Progress, part, report

_STEPS = 40
_LEAST_HIGHLIGHTS = 4
_SPREAD = 1.4826
_HUBER = 1.5
_OUTLIER = 5.0
_OUTLIER_PX = 0.5
_STEADY = 1e-4  # of a standard deviation

Valid = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Refinement:
    """What the highlights say of the rig.

    Attributes
    ----------
    geometry
        The refined geometry.
    parameters
        Each number with what was stated, what was found, and how much of it the highlights tell.
    positions
        (n,) indices of the light's positions with a highlight.
    pixels
        (n, 2) where it was seen.
    residuals_px
        (n, 2) seen less expected.
    residuals_deg
        (n,) angle between the light's direction that the highlight tells and that of the geometry.
    outliers
        (n,) highlights that do not belong.
    rms_px, rms_deg
        Root mean square over the others: of the distance in pixels, of the angle in degrees.
    before_px, before_deg
        The same of the stated geometry with the outline's centre.
    movements
        Where the sphere has moved between two positions.
    """

    geometry: Geometry
    parameters: tuple[Refined, ...]
    positions: npt.NDArray[np.intp]
    pixels: Floats
    residuals_px: Floats
    residuals_deg: Floats
    outliers: Valid
    rms_px: float
    rms_deg: float
    before_px: float
    before_deg: float
    movements: tuple[Movement, ...] = ()

    @property
    def moved_positions(self) -> tuple[int, ...]:
        """Return the indices of all positions at which the sphere may stand elsewhere than ``geometry`` says."""
        if not self.movements:
            return ()
        kept = self.positions[_longest(self.positions, self.movements)]
        return tuple(k for k in range(len(self.geometry.angles_deg)) if not self._stands(k, kept))

    def _stands(self, k: int, kept: npt.NDArray[np.intp]) -> bool:
        """Return whether no movement lies between position ``k`` and the part of the series that is ``kept``."""
        first, last = int(kept[0]), int(kept[-1])
        return all(
            not (
                (movement.after <= first and k < movement.after)
                or (movement.before >= last and k > movement.before)
            )
            for movement in self.movements
        )

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON keeps exactly."""
        return {
            "geometry": self.geometry.to_json(),
            "parameters": [row.to_json() for row in self.parameters],
            "positions": self.positions.tolist(),
            "pixels": self.pixels.tolist(),
            "residuals_px": self.residuals_px.tolist(),
            "residuals_deg": self.residuals_deg.tolist(),
            "outliers": self.outliers.tolist(),
            "rms_px": self.rms_px,
            "rms_deg": self.rms_deg,
            "before_px": self.before_px,
            "before_deg": self.before_deg,
            "movements": [row.to_json() for row in self.movements],
        }

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> Refinement:
        """Return the refinement that :meth:`to_json` gave as plain values."""
        return cls(
            geometry=Geometry.from_json(value["geometry"]),
            parameters=tuple(Refined.from_json(row) for row in value["parameters"]),
            positions=np.array(value["positions"], np.intp),
            pixels=np.array(value["pixels"], float).reshape(-1, 2),
            residuals_px=np.array(value["residuals_px"], float).reshape(-1, 2),
            residuals_deg=np.array(value["residuals_deg"], float),
            outliers=np.array(value["outliers"], bool),
            rms_px=float(value["rms_px"]),
            rms_deg=float(value["rms_deg"]),
            before_px=float(value["before_px"]),
            before_deg=float(value["before_deg"]),
            movements=tuple(Movement.from_json(row) for row in value["movements"]),
        )


def refine(
    geometry: Geometry,
    outline: Outline | None,
    highlights: Sequence[Highlight],
    progress: Progress | None = None,
) -> Refinement:
    """Return the geometry that the highlights agree with best.

    Parameters
    ----------
    geometry
        As the session states it; with ``outline``, that outline's geometry is taken.
    outline
        The sphere's outline, whose centre and its uncertainty count as measurements.
    highlights
        At four positions of the light or more; spread over the half turn, 20 tell nearly as much as 180.

    Raises
    ------
    AcquisitionError
        Fewer than four highlights.
    """
    report(progress, 0.0, "refining the light's position")
    start = geometry if outline is None else outline.geometry
    if len(highlights) < _LEAST_HIGHLIGHTS:
        raise AcquisitionError(
            f"The light's mirror image was found at {len(highlights)} positions of the light, and 4 are wanted to "
            "refine its place. Free the highlights in the mask, or go on without refinement."
        )
    series = _Series.of(start, highlights)
    prior = priors(start, outline)
    every = np.ones(len(series.positions), bool)
    fit = _solve(series, prior, every, progress)
    kept = ~_stray(fit.off, series.sigma)
    if not kept.all() and np.count_nonzero(kept) >= _LEAST_HIGHLIGHTS:
        fit = _solve(series, prior, kept, progress)
    movements = find_movements(
        series.positions[kept],
        fit.off[kept],
        fit.slopes[kept],
        series.sigma[kept],
        np.linalg.inv(np.linalg.cholesky(prior)),
    )
    if movements:
        # The outline of a sum of photographs is then one of two spheres: it is trusted less by as much.
        kept &= _longest(series.positions, movements)
        shift = sum(row.distance_px for row in movements) * start.centre_m[2] / start.lens.fx
        prior[:3, :3] += shift**2 * np.diag((1.0, 1.0, (start.centre_m[2] / start.radius_m) ** 2))
        if np.count_nonzero(kept) >= _LEAST_HIGHLIGHTS:
            fit = _solve(series, prior, kept, progress)
    outliers = _outliers(fit.off, series.sigma, kept)
    if np.any(outliers & kept) and np.count_nonzero(kept & ~outliers) >= _LEAST_HIGHLIGHTS:
        # Huber's weights leave a stray highlight some pull; without it the fit is what the others say.
        kept &= ~outliers
        fit = _solve(series, prior, kept, progress)
        outliers = _outliers(fit.off, series.sigma, kept)
    length = np.linalg.norm(fit.off, axis=-1)
    found = apply(start, fit.x)
    degrees = _degrees(found, series.angles, series.seen)
    before = series.residuals(np.zeros(len(PARAMETERS)))
    return Refinement(
        geometry=found,
        parameters=tuple(
            row.refined(start, found, math.sqrt(prior[i, i]), math.sqrt(fit.posterior[i, i]))
            for i, row in enumerate(PARAMETERS)
        ),
        positions=series.positions,
        pixels=series.seen,
        residuals_px=fit.off,
        residuals_deg=degrees,
        outliers=outliers,
        rms_px=_rms(length[~outliers]),
        rms_deg=_rms(degrees[~outliers]),
        before_px=_rms(np.linalg.norm(before, axis=-1)),
        before_deg=_rms(_degrees(start, series.angles, series.seen)),
        movements=movements,
    )


def calibrate_geometry(
    outline: Outline,
    find: Callable[[Geometry], Sequence[Highlight]],
    progress: Progress | None = None,
) -> Refinement:
    """Return the rig refined from an outline: highlights are found, the rig is fitted, and both once more.

    ``find`` returns the highlights that a geometry leads to (:func:`~.sphere_highlight.find_highlight` for each merged
    photograph at hand). The second turn finds also those that the stated place of the light missed.

    Raises
    ------
    AcquisitionError
        Fewer than four highlights.
    """
    first = refine(outline.geometry, outline, find(outline.geometry), part(progress, 0.0, 0.5))
    return refine(outline.geometry, outline, find(first.geometry), part(progress, 0.5, 1.0))


def moved_sphere(refinement: Refinement, names: Sequence[str]) -> str:
    """Return what to tell of the sphere's movements, ``names`` (K,) being those of the positions; "" for none."""
    sentences = [movement.sentence(names) for movement in refinement.movements]
    if not sentences:
        return ""
    left_out = len(refinement.moved_positions)
    return (
        ". ".join(sentences)
        + f". The geometry is that of the longest part without movement; {left_out} positions are not of it."
    )


@dataclass(frozen=True)
class _Series:
    """The highlights as arrays, and the rig as stated."""

    start: Geometry
    positions: npt.NDArray[np.intp]
    angles: Floats
    seen: Floats
    sigma: Floats

    @classmethod
    def of(cls, start: Geometry, highlights: Sequence[Highlight]) -> _Series:
        rows = sorted(highlights, key=lambda row: row.position)
        positions = np.array([row.position for row in rows], np.intp)
        return cls(
            start,
            positions,
            np.array(start.angles_deg)[positions],
            np.array([row.pixel for row in rows]),
            np.array([row.sigma_px for row in rows]),
        )

    def residuals(self, x: Floats) -> Floats:
        """Return seen less expected (n, 2), pixels, with the rig's numbers changed by ``x``."""
        expected = apply(self.start, x).highlights(self.angles)
        # Out of sight at a step too far: as wrong as the sphere is large.
        lost = math.tan(self.start.outline_angle) * self.start.lens.fx
        return np.where(np.isfinite(expected), self.seen - expected, lost)


@dataclass(frozen=True)
class _Fit:
    x: Floats
    off: Floats
    slopes: Floats
    posterior: Floats


def _solve(series: _Series, prior: Floats, kept: Valid, progress: Progress | None) -> _Fit:
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
    return _Fit(x, off, slopes, np.linalg.inv(white.T @ white + lower.T @ lower))


def _weights(off: Floats, sigma: Floats, kept: Valid) -> Floats:
    """Return Huber's weights (n,) over the standard errors, these as large as the residuals show them to be."""
    length = np.linalg.norm(off, axis=-1) / sigma
    spread = max(_SPREAD * float(np.median(length[kept])), 1.0)
    weight: Floats = np.sqrt(np.minimum(1.0, _HUBER * spread / np.maximum(length, 1e-12)))
    return weight * kept / (sigma * spread)


def _stray(off: Floats, sigma: Floats) -> Valid:
    """Return the highlights (n,) that are far from where both of their neighbours in the series say.

    Where the sphere has moved a highlight still agrees with one of them.
    """
    step = np.linalg.norm(np.diff(off, axis=0), axis=-1)
    usual = _SPREAD * float(np.median(step))
    # The first and the last are compared with the two next to them.
    before = np.concatenate((np.linalg.norm(off[:1] - off[2:3], axis=-1), step))
    after = np.concatenate((step, np.linalg.norm(off[-1:] - off[-3:-2], axis=-1)))
    stray: Valid = np.minimum(before, after) > np.maximum(_OUTLIER * np.maximum(usual, sigma), _OUTLIER_PX)
    return stray


def _outliers(off: Floats, sigma: Floats, kept: Valid) -> Valid:
    """Return the highlights (n,) that are off by far more than those ``kept`` usually are."""
    length = np.linalg.norm(off, axis=-1)
    middle = _SPREAD * float(np.median(length[kept]))
    far: Valid = length > np.maximum(_OUTLIER * np.maximum(middle, sigma), _OUTLIER_PX)
    return far


def _longest(positions: npt.NDArray[np.intp], movements: Sequence[Movement]) -> Valid:
    """Return which of the positions lie in the longest part between two movements."""
    part_of = np.zeros(len(positions), np.intp)
    for movement in movements:
        part_of += positions >= movement.after
    longest: Valid = part_of == int(np.argmax(np.bincount(part_of)))
    return longest


def _slopes(residuals: Callable[[Floats], Floats], x: Floats, scale: Floats) -> Floats:
    """Return the derivatives (n, 2, parameters) of the residuals."""
    steps = 0.01 * scale * np.eye(len(x))
    columns = [(residuals(x + e) - residuals(x - e)) / (2.0 * e.sum()) for e in steps]
    return np.stack(columns, axis=-1)


def _degrees(geometry: Geometry, angles: Floats, seen: Floats) -> Floats:
    """Return the angle (n,) in degrees between the light and where the highlight's pixel mirrors the camera to."""
    rays = geometry.lens.rays(seen)
    along = rays @ geometry.centre
    rest = along * along - (geometry.centre @ geometry.centre - geometry.radius_m**2)
    points = (along - np.sqrt(np.maximum(rest, 0.0)))[:, None] * rays
    normals = (points - geometry.centre) / geometry.radius_m
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    mirrored = rays - 2.0 * np.einsum("ni,ni->n", rays, normals)[:, None] * normals
    way = geometry.light(angles) - points
    way /= np.linalg.norm(way, axis=-1, keepdims=True)
    chord = np.linalg.norm(mirrored - way, axis=-1)
    angle: Floats = np.degrees(2.0 * np.arcsin(np.minimum(0.5 * chord, 1.0)))
    return angle


def _rms(values: Floats) -> float:
    return math.sqrt(float(np.mean(values * values))) if len(values) else math.nan
