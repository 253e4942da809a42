"""Cook-Torrance lobes for a reflectance of any kind, with their errors, and a paint made of them."""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.fitting.cook_torrance.fit import fit_checked_samples
from brdf_suite.fitting.cook_torrance.plot import FitPlot, fit_plot
from brdf_suite.fitting.cook_torrance.reflectance_samples import FitErrors, errors_of, samples_of
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.fitting.cook_torrance.starts_file import StartsFile
from brdf_suite.geometry.directions import spherical
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.protocol import Reflectance

_JUDGED_DEG = (0.0, 45.0, 60.0, 75.0)
# Noise, and a scale that is known to a few per cent, are no fault of the lobes.
_MOST_ALBEDO = 1.03


@dataclass(frozen=True, eq=False)
class FileFit:
    """Lobes beside what they were fitted to.

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

    @cached_property
    def plot(self) -> FitPlot:
        """Measured and fitted f_r against θh."""
        return fit_plot(self.reflectance, self.fit)

    @cached_property
    def notices(self) -> tuple[str, ...]:
        """What a user should know: of the fit, and where it would send back more light than it gets."""
        return (*self.fit.notices, *_energy(self.fit))

    def to_json(self) -> dict[str, object]:
        """Return everything but the plot as plain values."""
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
        paint = fit.paint(name[:200] or "fit", source=_source(name, fit, errors))
    report(progress, 1.0, "done")
    return FileFit(name, reflectance, fit, paint, errors, within, time.perf_counter() - start)


def _energy(fit: CookTorranceFit) -> tuple[str, ...]:
    albedo = directional_albedo(fit, spherical(np.radians(_JUDGED_DEG), np.pi), 32).max(axis=1)
    over = np.flatnonzero(albedo > _MOST_ALBEDO)
    if not over.size:
        return ()
    return (
        f"Lit at {_JUDGED_DEG[over[0]]:g}° and beyond, the lobes send back up to {albedo.max():.2f} times the light: "
        "their rise towards grazing is more than a surface has.",
    )


def _source(name: str, fit: CookTorranceFit, errors: FitErrors) -> str:
    lobes = fit.model.lobes - len(fit.dropped)
    return (
        f"{lobes} Cook-Torrance {'lobe' if lobes == 1 else 'lobes'} fitted to {name}: mean |ln(fit/measured)| "
        f"{errors.l1_mean:.3f} over {errors.compared:,} values."
    )
