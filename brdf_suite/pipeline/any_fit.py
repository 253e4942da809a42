"""Lobes for anything that reflects: designed paints, Cook-Torrance paints, measured files of every format.

The weights are of one kind, whatever they were fitted to, and the renderer draws them all. What differs is how:

- A designed paint and a Cook-Torrance one are two layers, each fitted for itself (``reflectance.layers``).
- What nothing divides is fitted as one (``fitting.lobes.undivided``).

Errors are given where the fit did not look, as docs/method/measured_fits.md tells.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from brdf_suite.documents.paint import Flakes, OrangePeel, Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.lobes.fitter import LobeFitter
from brdf_suite.fitting.lobes.undivided import fit_undivided
from brdf_suite.fitting.lobes.undivided_samples import PLANE_GAMMAS_DEG
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.pipeline.factored_maps import TOO_MANY, too_many_maps
from brdf_suite.pipeline.fit_errors import (
    AngleError,
    HeldOut,
    held_out_errors,
    judged,
    judged_samples,
    three,
)
from brdf_suite.pipeline.measuring import SCATTERED, is_measured_file, load_measurable
from brdf_suite.pipeline.paint import PATIENT_TIME_LIMIT_S, PaintFit, fit_patiently
from brdf_suite.pipeline.scene import find_any_paint
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.build import build_reflectance
from brdf_suite.reflectance.layers import split_layers
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.protocol import Layered, Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

#: ``split_layers`` is what has a coat and a base but is neither of the two kinds of paint.
Kind = Literal["designed", "cook_torrance", "layered", "measured"]


@dataclass(frozen=True, eq=False)
class AnyFit:
    """Something that reflects and the lobes fitted to it.

    ``l1_errors``: per part of the fit and channel, Σ w·|M x - b| over Σ w·b. ``held_out`` is None where there are
    too few samples to leave some out. ``incidences_deg`` are those of the fit. ``paint_fit`` is there for the
    documents of designed paints, ``flakes`` where the paint has some. ``fit_seconds``: samples in hand to weights.
    """

    name: str
    kind: Kind
    reflectance: Reflectance
    weights: LobeWeights
    l1_errors: dict[str, tuple[float, float, float]]
    split_determined: bool
    incidences_deg: tuple[float, ...]
    samples: int
    angles: tuple[AngleError, ...]
    held_out: HeldOut | None
    notices: tuple[str, ...]
    fit_seconds: float
    paint_fit: PaintFit | None = None
    flakes: Flakes | None = None

    @property
    def orange_peel(self) -> OrangePeel | None:
        """The waviness of the coat, where the fit is of a paint that says so."""
        return None if self.paint_fit is None else self.paint_fit.orange_peel

    @property
    def time_limited(self) -> bool:
        """True where the time limit came before the optimum."""
        return self.weights.time_limited if self.paint_fit is None else self.paint_fit.time_limited

    @property
    def worst_delta_e(self) -> float | None:
        """The largest ΔE00 at a designed paint's readings, or where the fit looked among the judged geometries.

        None where there is no such angle.
        """
        if self.paint_fit is not None:
            return self.paint_fit.worst_delta_e
        return max((row.delta_e_2000 for row in self.angles if row.fitted), default=None)

    def to_json(self) -> dict[str, object]:
        """Return everything as plain values; angles in degrees, times in milliseconds."""
        weights = self.weights
        plain: dict[str, object] = {
            "name": self.name,
            "kind": self.kind,
            "exponents": weights.exponents.tolist(),
            "kd": weights.kd.tolist(),
            "kdd": weights.kdd.tolist(),
            "kg": weights.kg.tolist(),
            "theta_fit_deg": float(np.degrees(weights.theta_fit_rad)),
            "ior": weights.ior,
            "base_under_coat": weights.base_under_coat,
            "ms": self.fit_seconds * 1e3,
            "time_limited": self.time_limited,
            "split_determined": self.split_determined,
            "incidences_deg": list(self.incidences_deg),
            "samples": self.samples,
            "l1_relative": {part: list(errors) for part, errors in self.l1_errors.items()},
            "angles": [
                {
                    "illumination_deg": row.illumination_deg,
                    "aspecular_deg": row.aspecular_deg,
                    "lab": list(row.lab),
                    "lab_fitted": list(row.lab_fitted),
                    "delta_e_2000": row.delta_e_2000,
                    "fitted": row.fitted,
                }
                for row in self.angles
            ],
            "delta_e_2000_worst": self.worst_delta_e,
            "held_out": None if self.held_out is None else asdict(self.held_out),
            "notices": list(self.notices),
        }
        if self.paint_fit is not None:
            # What was asked at the readings themselves stands under the words it has always had.
            designed = self.paint_fit.to_json()
            plain["judged_angles"] = plain["angles"]
            plain.update(designed)
            plain["notices"] = list(self.notices)
        return plain


def fit_any(
    name_or_path: str | os.PathLike[str],
    basis: LobeBasis | None = None,
    *,
    errors: bool = True,
    progress: Progress | None = None,
) -> AnyFit:
    """Fit lobes to a shipped paint, a paint file of any kind, or a measured file.

    Parameters
    ----------
    basis
        The lobes' exponents; the default set if left out.
    errors
        Whether ``held_out`` is worked out, which takes longer than the fit.

    Raises
    ------
    SuiteError
        There is nothing of that name, the file is not valid, or no lobes can be fitted; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    report(progress, 0.0, "reading")
    path = Path(name_or_path)
    if is_measured_file(path):
        item = load_measurable(path)
        report(progress, 0.1, "fitting")
        # That samples are interpolated is true of reading them, not of fitting them.
        notices = tuple(notice for notice in item.notices if notice != SCATTERED)
        fitting = subrange(progress, 0.1, 0.3)
        found = _named(
            path,
            lambda: fit_reflectance(item.name, item.reflectance, basis, notices=notices, progress=fitting),
        )
    else:
        paint = find_any_paint(name_or_path)
        report(progress, 0.1, "fitting")
        found = fit_document(paint, name_or_path, basis)
    if errors:
        judging = subrange(progress, 0.3, 1.0)
        held_out = held_out_errors(found.reflectance, found.weights, basis, judging)
        found = replace(found, held_out=held_out)
    report(progress, 1.0, "done")
    return found


def fit_document(
    paint: AnyPaint, origin: str | os.PathLike[str] | None = None, basis: LobeBasis | None = None
) -> AnyFit:
    """Fit lobes to a paint of any kind; ``origin`` is what messages call it, its name if left out.

    Raises
    ------
    UnreachableError
        No such paint can have the gloss or colour that the document asks for.
    FittingError
        No lobes can be fitted.
    """
    origin = paint.name if origin is None else origin
    if isinstance(paint, Paint):
        found = _designed(paint, origin, basis)
    else:
        found = _named(Path(origin), lambda: fit_reflectance(paint.name, build_reflectance(paint), basis))
    return replace(found, flakes=paint.flakes)


def fit_reflectance(
    name: str,
    reflectance: Reflectance,
    basis: LobeBasis | None = None,
    *,
    notices: tuple[str, ...] = (),
    progress: Progress | None = None,
) -> AnyFit:
    """Fit lobes to any reflectance: as layers where it has them, else undivided; ``notices`` go before the fit's own.

    Raises :class:`FittingError` where a value is negative or not finite, or nothing lies above the horizon, and
    :class:`Cancelled` where the progress callback asked for it.
    """
    layers = split_layers(reflectance)
    found = (
        _undivided(name, reflectance, basis, progress)
        if layers is None
        else _of_layers(name, reflectance, layers, basis)
    )
    told = (TOO_MANY,) if too_many_maps(reflectance) else ()
    return replace(found, notices=(*notices, *found.notices, *told))


def _named(path: Path, fit: Callable[[], AnyFit]) -> AnyFit:
    """Fit, with the file's name before what cannot be fitted."""
    try:
        return fit()
    except FittingError as error:
        raise FittingError(f"{path.name}: {error}") from error


def _designed(paint: Paint, name_or_path: str | os.PathLike[str], basis: LobeBasis | None) -> AnyFit:
    fit = fit_patiently(paint, name_or_path, basis)
    return AnyFit(
        name=paint.name,
        kind="designed",
        reflectance=fit.reflectance,
        weights=fit.weights,
        l1_errors={
            "base": three(fit.fit.base_error.relative),
            "coat": three(fit.fit.coat_error.relative),
        },
        split_determined=True,
        incidences_deg=(float(np.degrees(fit.weights.theta_fit_rad)),),
        samples=0,
        angles=judged(fit.reflectance, fit.weights),
        held_out=None,
        notices=fit.notices,
        fit_seconds=fit.fit.seconds,
        paint_fit=fit,
    )


def _of_layers(name: str, reflectance: Reflectance, layers: Layered, basis: LobeBasis | None) -> AnyFit:
    fitter = LobeFitter(basis, time_limit_s=PATIENT_TIME_LIMIT_S)
    try:
        fit = fitter.fit(layers)
    finally:
        fitter.close()
    weights = fit.weights
    kind = _kind_of_layers(reflectance)
    notices: tuple[str, ...] = tuple(getattr(reflectance, "notices", ()))
    if kind == "cook_torrance" and weights.ior == 1.0:
        notices += ("It has no sharp lobe that would be a coat: everything is fitted as base.",)
    return AnyFit(
        name=name,
        kind=kind,
        reflectance=reflectance,
        weights=weights,
        l1_errors={"base": three(fit.base_error.relative), "coat": three(fit.coat_error.relative)},
        split_determined=True,
        incidences_deg=(float(np.degrees(weights.theta_fit_rad)),),
        samples=0,
        angles=judged(reflectance, weights),
        held_out=None,
        notices=notices,
        fit_seconds=fit.seconds,
    )


def _kind_of_layers(reflectance: Reflectance) -> Kind:
    if isinstance(reflectance, PaintReflectance):
        return "designed"
    below = reflectance.base if isinstance(reflectance, Coated) else reflectance
    return "cook_torrance" if isinstance(below, CookTorrance) else "layered"


def _undivided(
    name: str, reflectance: Reflectance, basis: LobeBasis | None, progress: Progress | None
) -> AnyFit:
    fit = fit_undivided(reflectance, basis, progress=progress)
    if isinstance(reflectance, ScatteredSamples):
        angles = judged_samples(reflectance, fit)
    else:
        angles = judged(reflectance, fit.weights, PLANE_GAMMAS_DEG)
    return AnyFit(
        name=name,
        kind="measured",
        reflectance=reflectance,
        weights=fit.weights,
        l1_errors={"whole": three(fit.relative_error)},
        split_determined=fit.split_determined,
        incidences_deg=tuple(float(np.degrees(angle)) for angle in fit.incidences_rad),
        samples=fit.samples,
        angles=angles,
        held_out=None,
        notices=fit.notices,
        fit_seconds=fit.seconds,
    )
