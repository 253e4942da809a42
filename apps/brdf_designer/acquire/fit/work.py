"""Lobes fitted to the table, and what becomes of them, on a thread."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from brdf_qt.program.translation import tr

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit, fit_cook_torrance
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.paint_design.measured_start import MeasuredStart, measured_start
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress
from brdf_suite.reflectance.designed.build import build_reflectance


@dataclass(frozen=True, eq=False)
class FitRequest:
    """A table by its name, and how lobes are to be fitted to it."""

    name: str
    table: Any
    model: str
    lobes: int


def find_fit(request: FitRequest, progress: Progress) -> FileFit:
    """Fit the lobes."""
    settings = Settings(lobes=request.lobes, model=request.model)  # type: ignore[arg-type] # one of the page's
    found = fit_cook_torrance(request.name, request.table, settings, progress=progress)
    _ = found.plot  # worked out here, and not when it is shown
    return found


def fit_facts(found: FileFit) -> list[tuple[str, str, str]]:
    """Return names, values and explanations of the errors of a fit."""
    fit, errors = found.fit, found.errors
    return [
        (
            tr("Mean |ln|"),
            f"{errors.l1_mean:.4f}",
            tr(
                "Mean of |ln(fit/measured)| over all measured bins: the energy of equation 2 "
                "divided by its number of terms"
            ),
        ),
        (
            tr("RMS ln"),
            f"{errors.log_rms:.4f}",
            tr("Root mean square of ln(fit/measured) over every measured bin"),
        ),
        (
            tr("Median"),
            f"{100.0 * errors.median_relative:.1f} %",
            tr("Median relative difference over every measured bin"),
        ),
        (
            tr("Energy"),
            f"{fit.energy:.1f}",
            tr("Equation 2 of Günther et al. 2005 over the samples of the solver"),
        ),
        (
            tr("Samples"),
            f"{fit.samples}",
            tr("Samples used by the solver; errors are computed over all measured bins"),
        ),
        (tr("Time"), tr("{seconds:.1f} s").format(seconds=found.seconds), tr("Duration of the fit")),
    ]


def fit_rows(fit: CookTorranceFit) -> list[tuple[str, ...]]:
    """Return (part, red, green, blue, slope m, reflectance r) with their uncertainties, the diffuse part first."""
    spread = fit.standard_errors
    return [
        (tr("diffuse"), *map(with_error, fit.kd, spread.kd), "", ""),
        *(
            (
                tr("lobe {number}").format(number=lobe + 1),
                *map(with_error, fit.ks[lobe], spread.ks[lobe]),
                with_error(fit.m[lobe], spread.m[lobe]),
                with_error(fit.r[lobe], spread.r[lobe]),
            )
            for lobe in range(len(fit.m))
        ),
    ]


def with_error(value: float, error: float) -> str:
    """Return a value with its standard uncertainty, to one digit of that.

    >>> with_error(0.31234, 0.0123)
    '0.31 ± 0.01'
    """
    value, error = float(value), float(error)
    if not math.isfinite(error):
        return f"{value:.3g} ± ?"
    if error <= 0.0:
        return f"{value:.4g}"
    digits = max(0, -math.floor(math.log10(error)))
    return f"{value:.{digits}f} ± {error:.{digits}f}"


def find_start(request: tuple[CookTorrancePaint, str], progress: Progress) -> MeasuredStart:
    """Read the lobes of a paint by the virtual spectrophotometer, and start a design from them; with their source."""
    paint, source = request
    return measured_start(Material(paint.name, build_reflectance(paint), origin=source), progress=progress)
