"""What Figure 5 of Günther et al. 2005 draws: measured and fitted f_r against θh, and the parts of the fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit
from brdf_suite.fitting.cook_torrance.samples import half_and_difference
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

THETA_D_DEG = (5.0, 30.0, 50.0, 65.0)
"""Differences at which it is drawn; of a table, the nearest bins."""
_POINTS = 90
_WINDOW_DEG = 6.0


@dataclass(frozen=True, eq=False)
class FitPlot:
    """Curves of f_r, 1/sr, against θh: one for each of a few θd, at φd = 90° or near.

    ``theta_h_deg`` (k,) rising; ``theta_d_deg`` (c,); ``measured``, ``fitted`` (c, k, 3), NaN where nothing was
    measured, or the fit is 0 there; ``parts`` (1 + N, c, k, 3) of the matt part and each lobe, which sum to ``fitted``.
    """

    theta_h_deg: Floats
    theta_d_deg: Floats
    measured: Floats
    fitted: Floats
    parts: Floats


def fit_plot(reflectance: Reflectance, fit: CookTorranceFit) -> FitPlot:
    """Return the curves; of a table at the measured bins nearest to φd = 90°, of samples the medians of those near."""
    if isinstance(reflectance, ScatteredSamples):
        return _of_samples(reflectance, fit)
    if isinstance(reflectance, IsotropicTable):
        return _of_table(reflectance, fit)
    theta_h = 0.5 * np.pi * ((np.arange(_POINTS) + 0.5) / _POINTS) ** 2
    theta_d = np.radians(THETA_D_DEG)
    wi, wo = from_half_angle_coordinates(theta_h[None, :], 0.0, theta_d[:, None], 0.5 * np.pi)
    measured = np.asarray(reflectance.eval(wi, wo), np.float64)
    return _curves(theta_h, theta_d, wi, wo, measured, fit)


def _of_table(table: IsotropicTable, fit: CookTorranceFit) -> FitPlot:
    theta_h, all_d, all_p = table.grid.centres()
    known = table.measured_mask()
    # A rig's steps leave rows of θd without a reading; the fullest of those near is taken.
    filled = known.any(axis=2).sum(axis=0)
    at_d = []
    for wanted in np.radians(THETA_D_DEG).tolist():
        near = np.flatnonzero(np.abs(all_d - wanted) <= np.radians(_WINDOW_DEG / 2.0) + 0.5 * all_d[0])
        order = np.lexsort((np.abs(all_d[near] - wanted), -filled[near]))
        at_d.append(int(near[order[0]]) if near.size else int(np.argmin(np.abs(all_d - wanted))))
    # Across the plane of incidence, where the pair is symmetric and both directions are above the horizon.
    across = np.abs(np.abs(np.mod(all_p, np.pi)) - 0.5 * np.pi)
    rows = known[:, at_d]
    at_p = np.argmin(np.where(rows, across, across + 10.0), axis=2)
    h, c = np.meshgrid(np.arange(len(theta_h)), np.arange(len(at_d)), indexing="ij")
    found = np.where(rows[h, c, at_p][..., None], table.values[h, np.array(at_d)[c], at_p], np.nan)
    wi, wo = from_half_angle_coordinates(theta_h[None, :], 0.0, all_d[at_d][:, None], all_p[at_p].T)
    return _curves(theta_h, all_d[at_d], wi, wo, found.transpose(1, 0, 2).astype(np.float64), fit)


def _curves(
    theta_h: Floats, theta_d: Floats, wi: Floats, wo: Floats, measured: Floats, fit: CookTorranceFit
) -> FitPlot:
    parts = fit.parts(wi, wo)
    above = ((wi[..., 2] > 0.0) & (wo[..., 2] > 0.0))[..., None]
    return FitPlot(
        np.degrees(theta_h),
        np.degrees(theta_d),
        np.where(above, measured, np.nan),
        np.where(above, parts.sum(axis=0), np.nan),
        np.where(above, parts, np.nan),
    )


def _of_samples(samples: ScatteredSamples, fit: CookTorranceFit) -> FitPlot:
    theta_h, theta_d = half_and_difference(samples.wi, samples.wo)
    edges = 0.5 * np.pi * (np.arange(_POINTS // 2 + 1) / (_POINTS // 2)) ** 2
    middle = 0.5 * np.pi * ((np.arange(_POINTS // 2) + 0.5) / (_POINTS // 2)) ** 2
    shape = (len(THETA_D_DEG), len(middle), 3)
    measured = np.full(shape, np.nan)
    parts = np.full((1 + fit.model.lobes, *shape), np.nan)
    box = np.clip(np.searchsorted(edges, theta_h, side="right") - 1, 0, len(middle) - 1)
    found = fit.parts(samples.wi, samples.wo)
    for c, wanted in enumerate(np.radians(THETA_D_DEG).tolist()):
        near = np.abs(theta_d - wanted) <= np.radians(_WINDOW_DEG)
        for k in np.unique(box[near]).tolist():
            mine = near & (box == k)
            measured[c, k] = np.median(samples.values[mine], axis=0)
            parts[:, c, k] = np.mean(found[:, mine], axis=1)
            # The whole at the sample in the middle: parts of different samples would not sum to it.
            whole = np.median(found[:, mine].sum(axis=0), axis=0)
            parts[:, c, k] *= whole / np.maximum(parts[:, c, k].sum(axis=0), 1e-300)
    return FitPlot(np.degrees(middle), np.array(THETA_D_DEG), measured, parts.sum(axis=0), parts)
