"""How far fitted lobes are from what they were fitted to, where the fit did not look, and in the trade's geometries.

A reflectance that can be evaluated everywhere is judged on 4,096 direction pairs over both hemispheres. Scattered
samples are judged where they are: each fifth of them by a fit to the other four. Nothing is interpolated.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats, triple
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.lobes.measured import UndividedFit, fit_rows, fit_undivided, scattered_values
from brdf_suite.fitting.lobes.measured_samples import (
    PLANE_GAMMAS_DEG,
    measured_pairs,
    scattered_rows,
    used_samples,
    views_with_light_at_minus_x,
)
from brdf_suite.fitting.lobes.weights import LobeWeights, RaisedWeights
from brdf_suite.fitting.metrics import AngleError, HeldOut, value_errors
from brdf_suite.geometry.directions import (
    angle_between,
    aspecular_angle,
    aspecular_view,
    illumination,
    mirror,
    spherical,
)
from brdf_suite.progress import Progress, subrange
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

ANGLE_SET = "8 light directions by 16 x 32 views, even in solid angle over both hemispheres (midpoints in cos θ and φ)"

NEAR_MIRROR_DEG = 5.0

_LIGHTS, _VIEW_RINGS, _VIEW_AZIMUTHS = 8, 16, 32


JUDGED_GAMMAS_DEG = (-15.0, 15.0, 25.0, 45.0, 75.0, 110.0)
JUDGED_INCIDENCE_DEG = 45.0
#: How far a measured direction may lie from a usual geometry to stand for it.
_NEAR_GEOMETRY_DEG = 5.0
_FOLDS = 5
_FEWEST_FOR_FOLDS = 50
# A fit to 100,000 samples takes 10 s, and there are five; a fifth of that judges as well.
_MOST_IN_A_FOLD = 20_000
_FOLDED = "each fifth of the samples by a fit to the other four, weighted by the solid angle of views they stand for"


def fit_and_compare(
    reflectance: Reflectance, basis: LobeBasis | None, progress: Progress | None
) -> tuple[UndividedFit, tuple[AngleError, ...]]:
    """Fit lobes to what has no layers; return them and their errors at the usual geometries."""
    fit = fit_undivided(reflectance, basis, progress=progress)
    if isinstance(reflectance, ScatteredSamples):
        return fit, sample_errors(reflectance, fit)
    return fit, angle_errors(reflectance, fit.weights, PLANE_GAMMAS_DEG)


def angle_errors(
    reflectance: Reflectance, weights: LobeWeights, looked_at: Sequence[float] = (15.0, 45.0, 110.0)
) -> tuple[AngleError, ...]:
    """Data and lobes at the usual geometries with the light at 45°."""
    wi = illumination(JUDGED_INCIDENCE_DEG)
    wo = aspecular_view(JUDGED_INCIDENCE_DEG, np.array(JUDGED_GAMMAS_DEG))
    data = np.asarray(reflectance.eval(wi, wo))
    lobes = RaisedWeights(weights).eval(np.broadcast_to(wi, wo.shape), wo)
    known = measured_pairs(reflectance, np.broadcast_to(wi, wo.shape), wo)
    fitted = [gamma in looked_at for gamma in JUDGED_GAMMAS_DEG]
    return _angle_errors(
        [(JUDGED_INCIDENCE_DEG, gamma) for gamma in JUDGED_GAMMAS_DEG], data, lobes, fitted, known
    )


def sample_errors(samples: ScatteredSamples, fit: UndividedFit) -> tuple[AngleError, ...]:
    """The measured directions nearest to the usual geometries, with their own angles; none is interpolated."""
    used = used_samples(samples)
    wi, wo, values = samples.wi[used], samples.wo[used], samples.values[used]
    theta = np.degrees(np.arccos(np.clip(wi[:, 2], 0.0, 1.0)))
    incidences = np.degrees(np.array(fit.incidences_rad))
    near = incidences[np.argmin(np.abs(incidences - JUDGED_INCIDENCE_DEG))]
    mine = np.flatnonzero(np.abs(theta - near) <= 1.0)
    if mine.size == 0:
        return ()
    # The usual geometries have their light on the -x side.
    views = views_with_light_at_minus_x(wi[mine], wo[mine])
    chosen, places = [], []
    for gamma in JUDGED_GAMMAS_DEG:
        away = np.degrees(angle_between(views, aspecular_view(near, gamma)))
        k = int(np.argmin(away))
        place = int(mine[k])
        if away[k] > _NEAR_GEOMETRY_DEG or place in places:
            continue
        places.append(place)
        # Slightly out of the plane an aspecular angle has no sign; the geometry that it stands for has.
        size = abs(float(np.degrees(aspecular_angle(wi[place], wo[place]))))
        chosen.append((float(theta[place]), math.copysign(size, gamma)))
    if not places:
        return ()
    lobes = fit.weights.eval(wi[places], wo[places])
    return _angle_errors(chosen, values[places], lobes, [True] * len(places), np.ones(len(places), np.bool_))


def _angle_errors(
    geometries: Sequence[tuple[float, float]],
    data: Floats,
    lobes: Floats,
    fitted: Sequence[bool],
    known: NDArray[np.bool_],
) -> tuple[AngleError, ...]:
    lab, lab_fitted = working_to_lab(np.pi * data), working_to_lab(np.pi * lobes)
    difference = delta_e_2000(lab, lab_fitted)
    return tuple(
        AngleError(light, gamma, triple(lab[k]), triple(lab_fitted[k]), float(difference[k]), fitted[k])
        for k, (light, gamma) in enumerate(geometries)
        if known[k]
    )


def held_out_errors(
    reflectance: Reflectance,
    weights: LobeWeights,
    basis: LobeBasis | None = None,
    progress: Progress | None = None,
) -> HeldOut | None:
    """Return the errors of ``weights`` where the fit did not look; None for a handful of samples.

    Fresnel factors, where the weights have a coat, are taken at the light's angle. ``basis`` is that of the weights.
    """
    if isinstance(reflectance, ScatteredSamples):
        return _by_folds(reflectance, basis, progress)
    wi, wo, weight = hemisphere_pairs()
    known = measured_pairs(reflectance, wi, wo)
    wi, wo, weight = wi[known], wo[known], weight[known]
    data, lobes = reflectance.eval(wi, wo), RaisedWeights(weights).eval(wi, wo)
    return _held_out(ANGLE_SET, data, lobes, wi, wo, weight)


def _held_out(name: str, data: Floats, lobes: Floats, wi: Floats, wo: Floats, weight: Floats) -> HeldOut:
    """The errors, all and away from the mirror direction; relative ones are over √(Σ w cos²θi f²), 0 for black data."""
    scale = weight[:, None] * wi[:, 2:3] ** 2
    whole = float((scale * data**2).sum())
    relative = float(np.sqrt((scale * (data - lobes) ** 2).sum() / whole)) if whole > 0.0 else 0.0
    away = angle_between(mirror(wi), wo) >= np.radians(NEAR_MIRROR_DEG)
    elsewhere = value_errors(data, lobes, wi, np.where(away, weight, 0.0)) if away.any() else None
    return HeldOut(name, len(wi), value_errors(data, lobes, wi, weight), relative, elsewhere)


def _by_folds(
    samples: ScatteredSamples, basis: LobeBasis | None, progress: Progress | None
) -> HeldOut | None:
    """Every sample by a fit that did not see it; of very many, such a fit sees a share."""
    rows, values = scattered_rows(samples), scattered_values(samples)
    if len(values) < _FEWEST_FOR_FOLDS:
        return None
    random = np.random.default_rng(0)
    fold = random.permutation(np.arange(len(values)) % _FOLDS)
    share = min(1.0, _MOST_IN_A_FOLD / len(values))
    seen = random.random(len(values)) < share
    lobes = np.zeros_like(values)
    for k in range(_FOLDS):
        rest, mine = (fold != k) & seen, fold == k
        fold_progress = subrange(progress, k / _FOLDS, (k + 1) / _FOLDS)
        weights = fit_rows(rows.subset(rest), values[rest], basis, progress=fold_progress).weights
        lobes[mine] = weights.eval(rows.wi[mine], rows.wo[mine])
    return _held_out(_FOLDED, values, lobes, rows.wi, rows.wo, rows.weights)


def hemisphere_pairs() -> tuple[Floats, Floats, Floats]:
    """Return wi, wo (n, 3) and the weights (n,), all alike, of :data:`ANGLE_SET`."""
    cos_light = (np.arange(_LIGHTS) + 0.5) / _LIGHTS
    cos_view = (np.arange(_VIEW_RINGS) + 0.5) / _VIEW_RINGS
    phi = 2.0 * math.pi * (np.arange(_VIEW_AZIMUTHS) + 0.5) / _VIEW_AZIMUTHS
    light, view, azimuth = np.meshgrid(np.arccos(cos_light), np.arccos(cos_view), phi, indexing="ij")
    wi = spherical(light.ravel(), math.pi)
    wo = spherical(view.ravel(), azimuth.ravel())
    return wi, wo, np.full(len(wi), (2.0 * math.pi) ** 2 / len(wi))
