"""Lobes fitted to the table, and what becomes of them, on a thread."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from brdf_qt.program.translation import tr

from brdf_designer.acquire.states import FitState
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.store import save_paint
from brdf_suite.fitting.cook_torrance.reflectance_fit import fit_cook_torrance
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


@dataclass(frozen=True, eq=False)
class FitFound:
    """A fit, what is shown of it, and its paint, where its lobes can be one."""

    found: Any
    state: FitState
    paint: CookTorrancePaint | None


def find_fit(request: FitRequest, progress: Progress) -> FitFound:
    """Fit the lobes."""
    settings = Settings(lobes=request.lobes, model=request.model)  # type: ignore[arg-type] # one of the page's
    found = fit_cook_torrance(request.name, request.table, settings, progress=progress)
    return FitFound(found, fit_state(found), found.paint)


def fit_state(found: Any) -> FitState:
    """Return what the page shows of a fit of a file."""
    fit, plot, errors = found.fit, found.plot, found.errors
    facts = [
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
    spread = fit.standard_errors
    rows = [(tr("diffuse"), *(with_error(fit.kd[c], spread.kd[c]) for c in range(3)), "", "")]
    for lobe in range(len(fit.m)):
        rows.append(
            (
                tr("lobe {number}").format(number=lobe + 1),
                *(with_error(fit.ks[lobe][c], spread.ks[lobe][c]) for c in range(3)),
                with_error(fit.m[lobe], spread.m[lobe]),
                with_error(fit.r[lobe], spread.r[lobe]),
            )
        )
    return FitState(
        np.asarray(plot.theta_h_deg),
        np.asarray(plot.theta_d_deg),
        np.asarray(plot.measured),
        np.asarray(plot.fitted),
        np.asarray(plot.parts),
        tuple(rows),  # type: ignore[arg-type] # six texts each
        tuple(facts),
        tuple(fit.notices),
        found.paint is not None,
    )


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


@dataclass(frozen=True)
class StartRequest:
    """A fitted paint, from which a design is to start."""

    paint: CookTorrancePaint
    source: str


def find_start(request: StartRequest, progress: Progress) -> MeasuredStart:
    """Read the lobes by the virtual spectrophotometer, and start a design from them."""
    paint = request.paint
    item = Material(paint.name, build_reflectance(paint), origin=request.source)
    return measured_start(item, progress=progress)


@dataclass(frozen=True)
class SavePaint:
    """A fitted paint, and where it is to be."""

    paint: CookTorrancePaint
    path: Path


def save_fitted(request: SavePaint, _progress: Progress) -> None:
    """Write the lobes as a paint."""
    save_paint(request.paint, request.path)
