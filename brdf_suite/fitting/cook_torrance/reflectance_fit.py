"""Cook-Torrance lobes for a reflectance of any kind, with their errors, and a paint made of them."""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.fitting.cook_torrance.fit import StartsFile, fit_checked_samples
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit
from brdf_suite.fitting.cook_torrance.samples import FitErrors, errors_of, half_and_difference, samples_of
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical
from brdf_suite.notebook import Shown
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

THETA_D_DEG = (5.0, 30.0, 50.0, 65.0)
"""Differences at which it is drawn; of a table, the nearest bins."""
_POINTS = 90
_WINDOW_DEG = 6.0
_JUDGED_DEG = (0.0, 45.0, 60.0, 75.0)
# Noise, and a scale that is known to a few per cent, are no fault of the lobes.
_MOST_ALBEDO = 1.03


@dataclass(frozen=True, eq=False)
class FitPlot:
    """What Figure 5 of Günther et al. 2005 draws: f_r, 1/sr, against θh, for each of a few θd, at φd = 90° or near.

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


@dataclass(frozen=True, eq=False)
class FileFit(Shown):
    """Cook-Torrance lobes beside what they were fitted to.

    ``errors`` are over every measured bin or sample; ``errors_within`` over those not beyond the grazing angle of the
    settings, which alone the fit may look at. ``paint`` is there for Cook-Torrance lobes. ``seconds``: from the
    call to the errors.
    """

    name: str
    reflectance: Reflectance
    fit: CookTorranceFit
    paint: CookTorrancePaint | None
    errors: FitErrors
    errors_within: FitErrors
    seconds: float

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return what was fitted, f_r (..., 3) in 1/sr, linear Rec. 2020, without the cosine; 0 below the horizon.

        Parameters
        ----------
        wi, wo
            Unit directions (..., 3) to the light and to the viewer, z along the normal; they broadcast.

        >>> import brdf_suite as bs
        >>> found = bs.fit_cook_torrance("table1_white", lobes=1, starts=1, samples=300)
        >>> found.eval(bs.spherical([0.2, 0.4], 0.0), [0.0, 0.0, 1.0]).shape
        (2, 3)
        """
        return self.fit.eval(wi, wo)

    @cached_property
    def plot(self) -> FitPlot:
        """Measured and fitted f_r against θh."""
        return fit_plot(self.reflectance, self.fit)

    @cached_property
    def notices(self) -> tuple[str, ...]:
        """What a user should know: of the fit, and where it would send back more light than it gets."""
        albedo = directional_albedo(self.fit, spherical(np.radians(_JUDGED_DEG), np.pi), 32).max(axis=1)
        over = np.flatnonzero(albedo > _MOST_ALBEDO)
        if not over.size:
            return self.fit.notices
        return (
            *self.fit.notices,
            f"Lit at {_JUDGED_DEG[over[0]]:g}° and beyond, the lobes send back up to {albedo.max():.2f} times the "
            "light: their rise towards grazing is more than a surface has.",
        )

    def to_json(self) -> dict[str, object]:
        """Return everything but the plot as plain values, as JSON holds them.

        >>> import brdf_suite as bs
        >>> plain = bs.fit_cook_torrance("table1_white", lobes=1, starts=1, samples=300).to_json()
        >>> 0.0 < plain["errors"]["l1_mean"] < 1.0
        True
        """
        return {
            "name": self.name,
            **self.fit.to_json(),
            "notices": list(self.notices),
            "errors": asdict(self.errors),
            "errors_within_grazing": asdict(self.errors_within),
            "seconds": self.seconds,
        }


def fit_cook_torrance(
    name: str,
    reflectance: Reflectance,
    settings: Settings | None = None,
    *,
    state: Path | None = None,
    progress: Progress | None = None,
) -> FileFit:
    """Fit lobes to a reflectance: a table, samples, a model, or a paint.

    Parameters
    ----------
    name
        The name of the fit and of its paint.
    settings
        What is fitted and how; :class:`Settings` if left out.
    state
        A file in which the ends of the starts are kept, and looked for; the same fit resumes from it.

    Raises
    ------
    FittingError
        The reflectance does not determine the lobes.
    Cancelled
        The progress callback asked for it.
    """
    settings = settings or Settings()
    start = time.perf_counter()
    report(progress, 0.0, "samples")
    samples = samples_of(reflectance, settings)
    kept = None if state is None else StartsFile(state)
    fit = fit_checked_samples(samples, settings, kept=kept, progress=subrange(progress, 0.02, 0.8))
    errors, within = errors_of(
        fit, reflectance, (90.0, settings.grazing_deg), samples.floor, subrange(progress, 0.8, 1.0)
    )
    paint = None
    if settings.model == "cook-torrance":
        count = fit.model.lobes - len(fit.dropped)
        source = (
            f"{count} Cook-Torrance {'lobe' if count == 1 else 'lobes'} fitted to {name}: mean |ln(fit/measured)| "
            f"{errors.l1_mean:.3f} over {errors.compared:,} values."
        )
        paint = fit.paint(name[:200] or "fit", source=source)
    report(progress, 1.0, "done")
    return FileFit(name, reflectance, fit, paint, errors, within, time.perf_counter() - start)
