"""Centre of a sphere of known radius from its outline: the cone of rays tangent to the sphere.

A camera sees a sphere not as a circle but as an ellipse, bent further by the lens. The rays to its outline, though,
all make the same angle ρ with the ray to the centre C, and sin ρ = r/|C|. So the fit is made in rays: three numbers,
the direction of C and ρ, minimize the distances of the edge's points to the outline, in pixels and robustly. With
|d| = 1 the outline is also d·a = 1 for a = C/√(|C|² - r²), which is linear, and three points give it: from this the
first outline is drawn by lot (RANSAC), so that stand, arm and the sphere's own shadow are left out.

Where the camera is not calibrated the stated distance takes the place of the focal length, which is then found.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import median_filter

from brdf_suite.acquisition.geometry.lens import lens_pixels, lens_rays
from brdf_suite.acquisition.geometry.sphere.edge import (
    LEAST_LIT,
    Edge,
    PhotographUnion,
    circle,
    find_edge,
    lit_share,
)
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, azimuths_about, unit
from brdf_suite.arrays import Bools, Floats, Triple, triple
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, report

_DRAWS = 1500
_BINS = 72
_LEVELS = (0.4, 0.16, 0.06, 0.025, 0.01, 0.004)  # of the bright end of the picture
_CLOSE_PX = 1.5
_ROUNDS = 4
_LEAST_POINTS = 12
_LEAST_ARC = 1.2  # radians of outline that must be lit
_SPREAD = 1.4826  # of a normal distribution, over the median absolute deviation
_STEPS = 30
_SYSTEMATIC_PX = 0.03
_EIGHT = np.arange(8) * (math.pi / 4.0)


@dataclass(frozen=True)
class SphereOutline:
    """The sphere fitted to an outline.

    Attributes
    ----------
    points
        (n, 2) places of the edge, pixels x and y.
    used
        (n,) False: left out as not of the sphere.
    residuals_px
        (n,) distance to the fitted outline, positive inside.
    centre_m
        (3,) the sphere's centre, camera's frame, metres.
    covariance
        (3, 3) of ``centre_m``, m², with 0.03 pixels for what all points have in common.
    rms_px
        Root mean square of the residuals of the points used.
    blur_px
        The edge's σ, of pixel and lens together.
    geometry
        The geometry with this centre (and with the found focal length where it was not known).
    """

    points: Floats
    used: Bools
    residuals_px: Floats
    centre_m: Triple
    covariance: Floats
    rms_px: float
    blur_px: float
    geometry: RigGeometry


def find_outline(
    union: PhotographUnion, geometry: RigGeometry, mask: Bools | None = None, progress: Progress | None = None
) -> SphereOutline:
    """Return the sphere's outline in a sum of photographs.

    Parameters
    ----------
    union
        Photographs whose light reaches different parts of the outline.
    geometry
        What is known so far. Its light determines which part of the outline is lit; its distance of the sphere is a
        first guess, and taken as exact where its lens is not known.
    mask
        (h, w), False: not to be looked at.

    Raises
    ------
    AcquisitionError
        No sphere of this radius can be seen.
    """
    report(progress, 0.0, "looking for the sphere")
    current = _coarse(union, geometry, mask)
    edge = find_edge(union, current, mask)
    for turn in range(_ROUNDS):
        report(progress, 0.3 + 0.7 * turn / _ROUNDS, "measuring the sphere's outline")
        _require(edge, current)
        fitted = _fit(edge, current)
        moved = float(np.abs(fitted.geometry.outline(_EIGHT) - current.outline(_EIGHT)).max())
        current = fitted.geometry
        if moved < 0.02:
            break
        edge = find_edge(union, current, mask)
    return fitted


def _require(edge: Edge, geometry: RigGeometry) -> None:
    """Refuse an edge from which no sphere can be determined."""
    if len(edge.pixels) < _LEAST_POINTS:
        raise AcquisitionError(
            "The sphere's outline was not found. It is seen where the light reaches it from the side: add positions "
            "of the light between 40° and 150°, and check the radius, the camera's distance and the mask."
        )
    rays = lens_rays(geometry.lens, edge.pixels)
    axis = unit(geometry.centre)
    tangents = unit(rays - (rays @ axis)[:, None] * axis)
    if math.acos(float(np.clip((tangents @ tangents.T).min(), -1.0, 1.0))) < _LEAST_ARC:
        raise AcquisitionError(
            "Too little of the sphere's outline is lit or free to locate its centre. Add light positions between "
            "40° and 150°, or free more of the sphere in the mask."
        )


def _coarse(union: PhotographUnion, geometry: RigGeometry, mask: Bools | None) -> RigGeometry:
    """Return the geometry with the outline that most pixels between bright and dark lie on."""
    points = _border(union, mask)
    rays = lens_rays(geometry.lens, points)
    angle = geometry.outline_angle
    # Without a calibration the angle is not known: any sphere from 2 % of the picture on.
    low, high = (0.8 * angle, 1.25 * angle) if geometry.lens_known else (0.04 * angle, 2.5 * angle)
    draw = np.random.default_rng(1)  # the same lot each time: the same photographs give the same answer
    best, best_count = np.zeros(3), 0
    close = _CLOSE_PX / geometry.lens.fx
    # Only where the light reaches it: the rest ends in its own shadow, which is nearly as round.
    lit = lit_share(geometry, union, circle(_BINS)) > LEAST_LIT
    if len(points) >= _LEAST_POINTS:
        picks = draw.integers(0, len(points), (_DRAWS, 3))
        volume = np.linalg.det(rays[picks])
        for three in picks[np.abs(volume) > 1e-12]:
            a = np.linalg.solve(rays[three], np.ones(3))
            length = float(np.linalg.norm(a))  # 1/cos ρ
            if not math.cos(low) > 1.0 / length > math.cos(min(high, 1.5)):
                continue
            # d·a - 1 changes by sin ρ/cos ρ for each radian across the outline.
            near = np.abs(rays @ a - 1.0) < close * math.sqrt(length * length - 1.0)
            turn = azimuths_about(a / length, rays[near]) / (2.0 * math.pi) % 1.0
            count = int(np.count_nonzero(lit[np.minimum((turn * _BINS).astype(np.intp), _BINS - 1)]))
            if count > best_count:
                best, best_count = a, count
    if best_count < _LEAST_POINTS:
        raise AcquisitionError(
            "No sphere was found in the photographs. Check the sphere's radius, the camera's distance and the mask, "
            "and that the background is dark."
        )
    length = float(np.linalg.norm(best))
    return _placed(geometry, best / length, math.acos(1.0 / length))


def _border(union: PhotographUnion, mask: Bools | None) -> Floats:
    """Return pixels (n, 2) of bright beside dark at several thresholds.

    The outline is a step and lies on the border at each of them; a highlight's slope and the sphere's own shadow do
    only once. Borders that are mostly noise are left out.
    """
    usable = np.ones(union.picture.shape, bool) if mask is None else mask
    picture = median_filter(union.picture, 3)
    top = float(np.quantile(picture[usable], 0.98)) if usable.any() else 0.0
    points = []
    for level in _LEVELS:
        bright = (picture > level * top) & usable
        edge = np.zeros_like(bright)
        edge[1:-1, 1:-1] = bright[1:-1, 1:-1] & ~(
            bright[:-2, 1:-1] & bright[2:, 1:-1] & bright[1:-1, :-2] & bright[1:-1, 2:]
        )
        if not 0 < np.count_nonzero(edge) <= 6 * max(picture.shape):
            continue
        points.append(np.argwhere(edge)[:, ::-1].astype(float))
    return np.concatenate(points) if points and top > 0.0 else np.empty((0, 2))


def _placed(geometry: RigGeometry, axis: Floats, rho: float) -> RigGeometry:
    """Return the geometry with the sphere along ``axis``, as large as ρ says, or else as far as is stated."""
    if geometry.lens_known:
        return geometry.with_centre(axis * (geometry.radius_m / math.sin(rho)))
    distance = float(np.linalg.norm(geometry.centre_m))
    stretch = math.tan(rho) / math.tan(geometry.outline_angle)
    lens = replace(geometry.lens, fx=geometry.lens.fx * stretch, fy=geometry.lens.fy * stretch)
    pixel = lens_pixels(geometry.lens, axis)
    return replace(geometry, lens=lens, centre_m=triple(lens_rays(lens, pixel) * distance))


def _fit(edge: Edge, geometry: RigGeometry) -> SphereOutline:
    """Return the sphere whose outline runs through the points of an edge."""

    def moved(x: Floats) -> RigGeometry:
        """The sphere's centre seen at pixel x[:2], its outline x[2] pixels around it."""
        return _placed(geometry, lens_rays(geometry.lens, x[:2]), math.atan(x[2] / geometry.lens.fx))

    def distances(x: Floats) -> Floats:
        return outline_distances(moved(x), edge.pixels)

    radius = math.tan(geometry.outline_angle) * geometry.lens.fx
    x = np.append(lens_pixels(geometry.lens, geometry.centre), radius)
    certainty = 1.0 / np.hypot(edge.sigma_px, _SYSTEMATIC_PX)
    used = np.ones(len(edge.pixels), bool)
    for _ in range(_STEPS):
        off = distances(x)
        spread = max(_SPREAD * float(np.median(np.abs(off[used]))), _SYSTEMATIC_PX)
        used = np.abs(off) < 4.0 * spread
        # Huber's weights: squares near the outline, absolute values away from it.
        weight = certainty * np.sqrt(np.minimum(1.0, 1.5 * spread / np.maximum(np.abs(off), 1e-12))) * used
        slopes = np.stack([(distances(x + e) - distances(x - e)) / 0.1 for e in 0.05 * np.eye(3)], axis=-1)
        step = np.linalg.lstsq(slopes * weight[:, None], -off * weight)[0]
        x = x + step
        if float(np.abs(step).max()) < 1e-5:
            break
    found = moved(x)
    off = distances(x)
    rms = math.sqrt(float(np.mean(off[used] ** 2)))
    return SphereOutline(
        points=edge.pixels,
        used=used,
        residuals_px=off,
        centre_m=found.centre_m,
        covariance=_covariance(found, edge.pixels[used], rms),
        rms_px=rms,
        blur_px=edge.blur_px,
        geometry=found,
    )


def outline_distances(geometry: RigGeometry, pixels: Floats) -> Floats:
    """Return the distances (n,) of pixels (n, 2) to the sphere's outline, pixels, positive inside."""
    azimuth = azimuths_about(unit(geometry.centre), lens_rays(geometry.lens, pixels))
    inward = np.stack((-np.cos(azimuth), -np.sin(azimuth)), axis=-1)
    # Along the radius the two differ only by the ellipse's and the lens's slant, a cosine of almost 1.
    return np.asarray(np.einsum("ni,ni->n", pixels - geometry.outline(azimuth), inward))


def _covariance(geometry: RigGeometry, pixels: Floats, rms: float) -> Floats:
    """Return the covariance (3, 3) of the centre, m²."""
    step = 1e-4 * geometry.radius_m

    def distances(shift: Floats) -> Floats:
        return outline_distances(geometry.with_centre(geometry.centre + shift), pixels)

    shifts = step * np.eye(3)
    slopes = np.stack([(distances(e) - distances(-e)) / (2.0 * step) for e in shifts], axis=-1)
    inverse = np.linalg.pinv(slopes.T @ slopes)
    # What all points have in common moves across and to the eye as one point of this error would.
    common = np.linalg.pinv(slopes.T @ slopes / len(pixels)) * _SYSTEMATIC_PX**2
    return np.asarray(inverse * rms**2 + common)
