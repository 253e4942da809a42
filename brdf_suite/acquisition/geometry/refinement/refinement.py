"""Joint robust least-squares fit of sphere, turntable and light to the highlights at all angles.

Ten numbers place everything (:mod:`brdf_suite.acquisition.geometry.refinement.fit` says what the photographs
determine of each). For each the session's statement, or the outline's, counts as one measurement with its own
uncertainty; each highlight gives two, its place in pixels. All are met in the sense of least squares, with Huber's
weights for the highlights (:mod:`brdf_suite.acquisition.geometry.refinement.fit`). So a number that no highlight
determines stays as stated, and one that they determine is taken from them.

Mirrored places are sharp on directions and nearly blind to the size of the rig: the way to the light is known to
some hundredths of a degree afterwards, while its distance is hardly better known than before. Numbers that turn the
light alike, as the turntable's zero and a sphere beside the axis, are determined only as a sum.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.refinement.fit import (
    PARAMETERS,
    HighlightSeries,
    Movement,
    RefinedValue,
    apply,
    find_movements,
    find_outliers,
    fit_rig,
    priors,
    stray,
)
from brdf_suite.acquisition.geometry.sphere.highlight import Highlight
from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, unit
from brdf_suite.arrays import Bools, Floats
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, report, subrange

_LEAST_HIGHLIGHTS = 4
_LEAST_COSINE = 0.02


@dataclass(frozen=True)
class Refinement:
    """Result of a refinement of the rig by highlights.

    Attributes
    ----------
    geometry
        The refined geometry.
    parameters
        Each number with what was stated, what was found, and how far the highlights determine it.
    positions
        (n,) indices of the light's positions with a highlight.
    pixels
        (n, 2) where it was seen.
    residuals_px
        (n, 2) seen less expected.
    residuals_deg
        (n,) angle between the light's direction from the highlight and that of the geometry.
    outliers
        (n,) highlights that do not belong.
    rms_px, rms_deg
        Root mean square over the others, each counted by one over its variance: of the distance in pixels, of the
        angle in degrees. Without it the few highlights next to the outline, where a pixel is ten degrees of the
        light, would say nearly all.
    before_px, before_deg
        The same of the stated geometry with the outline's centre.
    movements
        Where the sphere has moved between two positions.
    """

    geometry: RigGeometry
    parameters: tuple[RefinedValue, ...]
    positions: npt.NDArray[np.intp]
    pixels: Floats
    residuals_px: Floats
    residuals_deg: Floats
    outliers: Bools
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
        # Beyond the last movement before the part that is kept, and the first one after it.
        low = max((row.after for row in self.movements if row.after <= kept[0]), default=0)
        count = len(self.geometry.angles_deg)
        high = min((row.before for row in self.movements if row.before >= kept[-1]), default=count)
        return tuple(k for k in range(count) if k < low or k > high)


def refine(
    geometry: RigGeometry,
    outline: SphereOutline | None,
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
        At four positions of the light or more; spread over the half turn, 20 determine nearly as much as 180.

    Raises
    ------
    AcquisitionError
        Fewer than four highlights.
    """
    report(progress, 0.0, "refining the light's position")
    start = geometry if outline is None else outline.geometry
    if len(highlights) < _LEAST_HIGHLIGHTS:
        raise AcquisitionError(
            f"The light's mirror image was found at {len(highlights)} positions of the light; refining its "
            "place needs 4. Free the highlights in the mask, or continue without refinement."
        )
    series = HighlightSeries.of(start, highlights)
    prior = priors(start, outline)
    every = np.ones(len(series.positions), bool)
    fit = fit_rig(series, prior, every, progress)
    kept = ~stray(fit.off, series.sigma)
    if not kept.all() and np.count_nonzero(kept) >= _LEAST_HIGHLIGHTS:
        fit = fit_rig(series, prior, kept, progress)
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
            fit = fit_rig(series, prior, kept, progress)
    outliers = find_outliers(fit.off, series.sigma, kept)
    if np.any(outliers & kept) and np.count_nonzero(kept & ~outliers) >= _LEAST_HIGHLIGHTS:
        # Huber's weights leave a stray highlight some pull; without it the fit is what the others say.
        kept &= ~outliers
        fit = fit_rig(series, prior, kept, progress)
        outliers = find_outliers(fit.off, series.sigma, kept)
    length = np.linalg.norm(fit.off, axis=-1)
    found = apply(start, fit.x)
    degrees = _degrees(found, series.angles, series.seen)
    before = series.residuals(np.zeros(len(PARAMETERS)))
    sigma_deg = series.sigma * _degrees_per_pixel(found, series.seen)
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
        rms_px=_rms(length[~outliers], series.sigma[~outliers]),
        rms_deg=_rms(degrees[~outliers], sigma_deg[~outliers]),
        before_px=_rms(np.linalg.norm(before, axis=-1), series.sigma),
        before_deg=_rms(_degrees(start, series.angles, series.seen), sigma_deg),
        movements=movements,
    )


def calibrate_geometry(
    outline: SphereOutline,
    find: Callable[[RigGeometry], Sequence[Highlight]],
    progress: Progress | None = None,
) -> Refinement:
    """Return the rig refined from an outline: highlights are found, the rig is fitted, and both once more.

    ``find`` returns the highlights that a geometry leads to
    (:func:`~brdf_suite.acquisition.geometry.sphere.highlight.find_highlight` for each merged photograph available).
    The second turn finds also those that the stated place of the light missed.

    Raises
    ------
    AcquisitionError
        Fewer than four highlights.
    """
    first = refine(outline.geometry, outline, find(outline.geometry), subrange(progress, 0.0, 0.5))
    return refine(outline.geometry, outline, find(first.geometry), subrange(progress, 0.5, 1.0))


def format_movement_notice(refinement: Refinement, names: Sequence[str]) -> str:
    """Return the notice about the sphere's movements, ``names`` (K,) being those of the positions; "" for none."""
    if not refinement.movements:
        return ""
    moved = "".join(
        f"The sphere has moved by {row.distance_px:.1f} pixels between {names[row.before]} and {names[row.after]}. "
        for row in refinement.movements
    )
    left_out = len(refinement.moved_positions)
    return f"{moved}The geometry is that of the longest part without movement; {left_out} positions are not of it."


def _longest(positions: npt.NDArray[np.intp], movements: Sequence[Movement]) -> Bools:
    """Return which of the positions lie in the longest part between two movements."""
    part_of = np.zeros(len(positions), np.intp)
    for movement in movements:
        part_of += positions >= movement.after
    return np.asarray(part_of == int(np.argmax(np.bincount(part_of))))


def _degrees(geometry: RigGeometry, angles: Floats, seen: Floats) -> Floats:
    """Return the angle (n,) in degrees between the light and where the highlight's pixel mirrors the camera to."""
    rays, points, _ = geometry.meet(seen)
    normals = unit(points - geometry.centre)
    mirrored = rays - 2.0 * np.einsum("ni,ni->n", rays, normals)[:, None] * normals
    way = geometry.light(angles) - points
    way /= np.linalg.norm(way, axis=-1, keepdims=True)
    chord = np.linalg.norm(mirrored - way, axis=-1)
    return np.asarray(np.degrees(2.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))))


def _degrees_per_pixel(geometry: RigGeometry, seen: Floats) -> Floats:
    """Return by how many degrees (n,) the mirrored direction turns for a pixel towards the outline."""
    rays, points, _ = geometry.meet(seen)
    cosine = np.maximum(-np.einsum("ni,ni->n", rays, unit(points - geometry.centre)), _LEAST_COSINE)
    return np.asarray(np.degrees(2.0 / (math.tan(geometry.outline_angle) * geometry.lens.fx * cosine)))


def _rms(values: Floats, sigma: Floats) -> float:
    """Return the root mean square, each value counted by one over the square of its standard error ``sigma``."""
    return math.sqrt(float(np.average(values * values, weights=sigma**-2.0))) if len(values) else math.nan
