"""Samples of undivided data: rows of the fitting system, each a weighted mean over direction pairs.

A reflectance that can be evaluated everywhere is sampled at fixed view angles, with lights on rings around the
view's mirror direction: what a picture gathers. Each ring is one row, its mean over the azimuths, because a
round lobe cannot follow a measured one that is narrower across the plane of incidence than in it; the sum over
the rings, the directional reflectance at that angle, is a row of its own that keeps the energy. In the plane of
incidence of 45°, where paints are measured, single directions are added for the colours.

Scattered samples are rows as they are: nothing is interpolated. Each represents the solid angle of views that lie
nearest to it among the samples of its incidence.

The choices were made by measurement (docs/method/measured_fits.md).
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Bools, Floats, Indices
from brdf_suite.geometry.directions import aspecular_view, illumination, mirror
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

#: Incidences of the rings, degrees, and the one at which paints are measured.
INCIDENCES_DEG = (10.0, 30.0, 45.0, 60.0, 75.0)
PLANE_DEG = 45.0
#: Aspecular angles in the plane of incidence of 45°. The usual -15, 25 and 75° are left for judging the fit.
PLANE_GAMMAS_DEG = (-30.0, 8.0, 15.0, 20.0, 35.0, 45.0, 60.0, 92.0, 110.0, 130.0)
#: Weights of a row in the plane and of a sum over rings, beside the solid angles of the rings, sr.
PLANE_WEIGHT = 5.0
ENERGY_WEIGHT = 2.0
#: Rings: the first, the ratio of two (as a logarithm) and the widest step, radians; azimuths on half a ring.
FIRST_RING_RAD = 0.001
LOG_STEP = 0.4
WIDEST_STEP_RAD = np.radians(10.0)
AZIMUTHS = 6
#: Azimuths at which an anisotropic reflectance is turned; its lobes are fitted to the mean.
TURNS = 8
#: Incidences that differ by less are one: their cosines, by which directional-diffuse and gloss are separated.
SAME_COSINE = 0.01
#: Nearer to grazing a measurement says nothing, and f_r may be without bound.
_LOWEST_COSINE = 1e-3
_SOLID_ANGLE_POINTS = 40_000
_INCIDENCE_BIN_RAD = np.radians(2.5)


@dataclass(frozen=True, eq=False)
class UndividedRows:
    """Rows of the system: row j is ``Σ share·value`` over its pairs.

    Attributes
    ----------
    wi, wo
        ``(p, 3)`` unit directions of the pairs, above the horizon.
    row, share
        ``(p,)`` the row that each pair belongs to, and its share of it.
    weights
        ``(n,)`` > 0: what the row's error counts, in sr.
    theta_rad
        ``(n,)`` polar angle of the light of each row, or of the mirror direction about which its lights lie.
    incidences_rad
        The different ones of these angles, rising, at which enough is known; angles whose cosines differ by less than
        :data:`SAME_COSINE` are one.
    notices
        For the user.
    """

    wi: Floats
    wo: Floats
    row: Indices
    share: Floats
    weights: Floats
    theta_rad: Floats
    incidences_rad: tuple[float, ...]
    notices: tuple[str, ...] = ()

    def gather(self, values: Floats) -> Floats:
        """Return the rows ``(n, c)`` of values ``(p, c)`` at the pairs."""
        result = np.zeros((self.weights.size, values.shape[1]))
        np.add.at(result, self.row, self.share[:, None] * values)
        return result

    def subset(self, keep: Bools) -> UndividedRows:
        """Return the rows ``keep`` (n,), with those incidences of the whole at which one of them is."""
        used = keep[self.row]
        order = np.cumsum(keep) - 1
        kept = np.cos(self.theta_rad[keep])
        return UndividedRows(
            self.wi[used],
            self.wo[used],
            order[self.row[used]],
            self.share[used],
            self.weights[keep],
            self.theta_rad[keep],
            tuple(a for a in self.incidences_rad if (np.abs(np.cos(a) - kept) <= SAME_COSINE).any()),
            self.notices,
        )


def distinct_incidences(theta_rad: Floats) -> tuple[float, ...]:
    """Return the polar angles that count as different, rising, radians: each the mean of its group."""
    theta = np.sort(np.asarray(theta_rad, np.float64).ravel())
    cosine = np.cos(theta)
    groups: list[list[float]] = []
    start = np.inf
    for angle, c in zip(theta.tolist(), cosine.tolist(), strict=True):
        if not groups or start - c > SAME_COSINE:
            groups.append([])
            start = c
        groups[-1].append(angle)
    return tuple(float(np.mean(group)) for group in groups)


def used_samples(samples: ScatteredSamples) -> Bools:
    """Return which samples (n,) are fitted: those above the horizon by more than .06°."""
    return np.asarray((samples.wi[:, 2] > _LOWEST_COSINE) & (samples.wo[:, 2] > _LOWEST_COSINE))


def scattered_rows(samples: ScatteredSamples) -> UndividedRows:
    """Return one row for each of the :func:`used_samples`."""
    used = used_samples(samples)
    wi, wo = samples.wi[used], samples.wo[used]
    count = len(wi)
    theta = np.arccos(np.clip(wi[:, 2], 0.0, 1.0))
    notices = []
    if count < used.size:
        notices.append(f"{used.size - count} samples at the horizon are left out.")
    if not samples.isotropic:
        notices.append(
            "The samples differ with the surface's azimuth; the lobes, which do not, show their mean."
        )
    angles, weights = distinct_incidences(theta) if count else (), _solid_angles(wi, wo, theta)
    return UndividedRows(wi, wo, np.arange(count), np.ones(count), weights, theta, angles, tuple(notices))


def views_with_light_at_minus_x(wi: Floats, wo: Floats) -> Floats:
    """Return views (p, 3), each turned about the normal with its light until that has azimuth π."""
    turn = np.pi - np.arctan2(wi[:, 1], wi[:, 0])
    x = np.cos(turn) * wo[:, 0] - np.sin(turn) * wo[:, 1]
    y = np.sin(turn) * wo[:, 0] + np.cos(turn) * wo[:, 1]
    return np.stack((x, y, wo[:, 2]), axis=-1)


def _solid_angles(wi: Floats, wo: Floats, theta: Floats) -> Floats:
    """Return the solid angle (n,), sr, of the views' hemisphere nearest to each sample among those of its incidence."""
    # scipy.spatial takes longer to import than a paint to edit, so only measured data load it.
    from scipy.spatial import cKDTree

    k = np.arange(_SOLID_ANGLE_POINTS) + 0.5
    height = k / _SOLID_ANGLE_POINTS
    around = k * (np.pi * (3.0 - np.sqrt(5.0)))
    radius = np.sqrt(1.0 - height * height)
    points = np.stack((radius * np.cos(around), radius * np.sin(around), height), axis=-1)
    views = views_with_light_at_minus_x(wi, wo)
    # To one side of the plane of incidence.
    views[:, 1] = np.abs(views[:, 1])
    points[:, 1] = np.abs(points[:, 1])
    result = np.zeros(len(wi))
    bins = np.round(theta / _INCIDENCE_BIN_RAD)
    for one in np.unique(bins):
        mine = np.flatnonzero(bins == one)
        if len(mine) == 1:  # of scattered samples most have an incidence of their own
            result[mine] = 2.0 * np.pi
            continue
        # Views measured twice share their place.
        places, which = np.unique(np.round(views[mine], 6), axis=0, return_inverse=True)
        _, nearest = cKDTree(places).query(points)
        area = np.bincount(np.asarray(nearest, np.intp), minlength=len(places)) + 0.5
        area *= 2.0 * np.pi / area.sum()
        which = which.ravel()
        result[mine] = (area / np.bincount(which))[which]
    return result


def reflectance_rows(
    reflectance: Reflectance, incidences_deg: tuple[float, ...] = INCIDENCES_DEG
) -> UndividedRows:
    """Return the rings about the mirror directions of ``incidences_deg``, their sums, and the plane at 45°.

    Bins of a table that were not measured are left out of the rings that touch them. An incidence counts as one
    where more than half of its rings, by their weights, is left.
    """
    notices: list[str] = []
    turns = TURNS if differs_with_azimuth(reflectance) else 1
    if turns > 1:
        notices.append(
            "It differs with the surface's azimuth; the lobes, which do not, show the mean over it."
        )
    theta = np.radians(np.array(incidences_deg))
    parts = [_rings(angle, turns) for angle in theta.tolist()]
    parts.append(_plane(turns))
    wi, wo, weights, at = [np.empty((0, 3))], [np.empty((0, 3))], [], []
    row, share = [np.empty(0, np.intp)], [np.empty(0)]
    left = np.zeros(len(parts))
    count = lost = 0
    for number, part in enumerate(parts):
        there = measured_pairs(reflectance, part.wi, part.wo)
        lost += int((~there).sum())
        for group in part.groups:
            used = group.pairs[there[group.pairs]]
            if used.size == 0:
                continue
            given = group.share[there[group.pairs]]
            # A mean is one over what is known; a sum stays a sum.
            given = given / given.sum() if group.is_mean else given
            wi.append(part.wi[used])
            wo.append(part.wo[used])
            row.append(np.full(used.size, count))
            share.append(given)
            weights.append(group.weight * (used.size / group.pairs.size if group.is_mean else 1.0))
            at.append(part.theta_rad)
            count += 1
            if group.is_mean:
                left[number] += weights[-1]
        left[number] /= sum(group.weight for group in part.groups if group.is_mean)
    # An incidence counts of which more than half is left, or the one with the most.
    left = left[: theta.size]
    known = left > 0.5
    if lost:
        notices.append(f"{lost} directions of the fit were not measured and are left out.")
    return UndividedRows(
        np.concatenate(wi),
        np.concatenate(wo),
        np.concatenate(row),
        np.concatenate(share),
        np.array(weights),
        np.array(at),
        distinct_incidences(theta[known] if known.any() else theta[[np.argmax(left)]]),
        tuple(notices),
    )


@dataclass(frozen=True, eq=False)
class _Group:
    """One row: places among the pairs, their shares, its weight, and whether it is a mean or a sum."""

    pairs: Indices
    share: Floats
    weight: float
    is_mean: bool


@dataclass(frozen=True, eq=False)
class _Part:
    wi: Floats
    wo: Floats
    groups: tuple[_Group, ...]
    theta_rad: float


def _rings(theta: float, turns: int) -> _Part:
    """Return rings of lights about the mirror direction of a view at ``theta``."""
    gamma = ring_angles()
    edges = np.concatenate(([0.0], 0.5 * (gamma[1:] + gamma[:-1]), [np.pi]))
    area = 2.0 * np.pi * (np.cos(edges[:-1]) - np.cos(edges[1:]))
    view = illumination(np.degrees(theta))
    centre = mirror(view)
    up = np.array([-np.cos(theta), 0.0, np.sin(theta)])
    # One side is enough where the reflectance is symmetric about the plane; another is turned about the normal.
    steps = AZIMUTHS if turns == 1 else 2 * AZIMUTHS
    azimuth = (np.arange(steps) + 0.5) * (np.pi if turns == 1 else 2.0 * np.pi) / steps
    around = np.cos(azimuth)[:, None] * up + np.sin(azimuth)[:, None] * np.array([0.0, 1.0, 0.0])
    lights = np.cos(gamma)[:, None, None] * centre + np.sin(gamma)[:, None, None] * around
    ring = np.repeat(np.arange(gamma.size), steps)
    lights = lights.reshape(-1, 3)
    lit = lights[:, 2] > _LOWEST_COSINE
    ring, lights = ring[lit], lights[lit]
    wi, wo, ring = _turned(lights, np.broadcast_to(view, lights.shape), ring, turns)
    pairs = np.arange(ring.size)
    groups = []
    for k in np.unique(ring).tolist():
        mine = pairs[ring == k]
        above = mine.size / (steps * turns)
        groups.append(_Group(mine, np.full(mine.size, 1.0 / mine.size), float(area[k] * above), True))
    groups.append(_Group(pairs, area[ring] / (steps * turns), ENERGY_WEIGHT, False))
    return _Part(wi, wo, tuple(groups), theta)


def _plane(turns: int) -> _Part:
    """Return single views in the plane of incidence, with the light at 45°."""
    views = aspecular_view(PLANE_DEG, np.array(PLANE_GAMMAS_DEG))
    lights = np.broadcast_to(illumination(PLANE_DEG), views.shape)
    wi, wo, place = _turned(lights, views, np.arange(len(views)), turns)
    pairs = np.arange(place.size)
    groups = tuple(
        _Group(pairs[place == k], np.full(turns, 1.0 / turns), PLANE_WEIGHT, True) for k in range(len(views))
    )
    return _Part(wi, wo, groups, float(np.radians(PLANE_DEG)))


def ring_angles() -> Floats:
    """Return the rings' angles from the mirror direction, radians: itself, then even in log γ, then every 10°.

    Out to where even the widest ring has left the hemisphere of lights.
    """
    angles = [0.0, FIRST_RING_RAD]
    while (following := min(angles[-1] * np.exp(LOG_STEP), angles[-1] + WIDEST_STEP_RAD)) < 0.9 * np.pi:
        angles.append(float(following))
    return np.array(angles)


def _turned(wi: Floats, wo: Floats, label: Indices, turns: int) -> tuple[Floats, Floats, Indices]:
    """Repeat pairs (p, 3) at ``turns`` azimuths of the surface."""
    if turns == 1:
        return np.array(wi), np.array(wo), label
    angle = np.arange(turns) * 2.0 * np.pi / turns
    cos, sin, zero = np.cos(angle), np.sin(angle), np.zeros(turns)
    turn = np.stack((cos, -sin, zero, sin, cos, zero, zero, zero, zero + 1.0), axis=-1).reshape(-1, 3, 3)
    return (
        np.einsum("tij,pj->tpi", turn, wi).reshape(-1, 3),
        np.einsum("tij,pj->tpi", turn, wo).reshape(-1, 3),
        np.tile(label, turns),
    )


def differs_with_azimuth(reflectance: Reflectance) -> bool:
    """Whether turning the surface changes the values of a few pairs by more than a thousandth."""
    pairs = ((35.0, 20.0), (35.0, 70.0), (60.0, 12.0))
    lights = illumination(np.array([light for light, _ in pairs]))
    views = np.stack([aspecular_view(light, gamma) for light, gamma in pairs])
    wi, wo, _ = _turned(lights, views, np.arange(3), TURNS)
    values = np.asarray(reflectance.eval(wi, wo), np.float64).reshape(TURNS, 3, 3)
    return bool(np.any(np.ptp(values, axis=0) > 1e-3 * np.abs(values).max(axis=0) + 1e-12))


def measured_pairs(reflectance: Reflectance, wi: Floats, wo: Floats) -> Bools:
    """Return whether each pair (p,) rests on measured bins alone; what is not a table with holes always does.

    Photographs of a sphere leave holes between measured bins everywhere, which its readings filled: few of the pairs
    in a table with coverage have no hole about them, and one measured bin of the eight is enough there.
    """
    holes = reflectance.holes if isinstance(reflectance, IsotropicTable) else None
    if not isinstance(reflectance, IsotropicTable) or holes is None or not holes.any():
        return np.ones(len(wi), np.bool_)
    places = reflectance.grid.index_of(np.ascontiguousarray(wi.T), np.ascontiguousarray(wo.T))
    touched = np.zeros(len(wi), np.intp)
    # The eight bins between whose centres a look-up lies: held at the ends of θh and θd, round along φd.
    bins = holes.shape
    low = [np.floor(place - 0.5).astype(np.intp) for place in places]
    for step in itertools.product((0, 1), repeat=3):
        h, d, p = (base + more for base, more in zip(low, step, strict=True))
        touched += holes[np.clip(h, 0, bins[0] - 1), np.clip(d, 0, bins[1] - 1), p % bins[2]]
    return touched == 0 if reflectance.coverage is None else touched < 8
