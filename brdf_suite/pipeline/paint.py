"""Paint to reflectance to lobe weights, with what the fit really gives at the measured angles.

This is the edit path: no file access, no import, no allocation that grows; under a millisecond or two.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from time import perf_counter

import numpy as np

from brdf_suite.appearance.colorimetry import working_to_lab
from brdf_suite.appearance.difference import delta_e_2000
from brdf_suite.documents.paint import Flakes, Lab, OrangePeel, Paint
from brdf_suite.errors import FittingError, UnreachableError
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.lobes.fitter import LayersFit, LobeFitter
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import Floats, aspecular_view, illumination
from brdf_suite.reflectance.build import build_paint
from brdf_suite.reflectance.misses import told_misses
from brdf_suite.reflectance.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.several_lights import SeveralLights

DEFAULT_TIME_LIMIT_S = 0.004
PATIENT_TIME_LIMIT_S = 1.0
"""For work without a screen: no frame waits for the fit, and a busy machine must not make the answer worse."""


@dataclass(frozen=True)
class AngleResult:
    """What was asked and what the lobes give at one measured geometry: L*a*b* (D65, 10°) and ΔE00."""

    illumination_deg: float
    aspecular_deg: float
    asked: Lab
    fitted: Lab
    delta_e_2000: float


@dataclass(frozen=True, eq=False)
class PaintFit:
    """A paint, its reflectance, and the lobes fitted to it. ``seconds`` is the whole way from the paint.

    Where the time limit came first, ``fit.exact`` gets the fit with the optimum, unless the fitter's next paint
    comes before it; :meth:`with_fit` makes it a fit of this paint.
    """

    paint: Paint
    reflectance: PaintReflectance
    fit: LayersFit
    angles: tuple[AngleResult, ...]
    notices: tuple[str, ...]
    seconds: float

    @property
    def name(self) -> str:
        """The paint's name."""
        return self.paint.name

    @property
    def flakes(self) -> Flakes | None:
        """The paint's flakes, where it has any."""
        return self.paint.flakes

    @property
    def orange_peel(self) -> OrangePeel | None:
        """The waviness of the paint's coat, where it has any."""
        return self.paint.orange_peel

    @property
    def fit_seconds(self) -> float:
        """The time from target samples in hand to weights."""
        return self.fit.seconds

    @property
    def weights(self) -> LobeWeights:
        """The lobe weights, linear Rec. 2020."""
        return self.fit.weights

    @property
    def time_limited(self) -> bool:
        """True where the time limit came before the optimum."""
        return self.fit.time_limited

    @property
    def exact_follows(self) -> bool:
        """True while the optimum is still to come by ``fit.exact``; False where it was cancelled or not found."""
        exact = self.fit.exact
        if exact is None or exact.cancelled():
            return False
        return not exact.done() or exact.exception() is None

    @property
    def achieved_lab(self) -> dict[float, Lab]:
        """L*a*b* that the lobes give, by aspecular angle in degrees.

        Where an angle was read under several lights, the first reading's; :meth:`achieved_at` tells them apart.
        """
        return {row.aspecular_deg: row.fitted for row in reversed(self.angles)}

    def achieved_at(self, aspecular_deg: float, illumination_deg: float | None = None) -> Lab:
        """Return the L*a*b* that the lobes give at a measured geometry, degrees.

        Without a light, the first reading at the angle. Raises :class:`ValueRangeError` where none is.
        """
        return self.angles[self.paint.index_of(aspecular_deg, illumination_deg)].fitted

    @property
    def worst_delta_e(self) -> float:
        """The largest ΔE00 between paint and fit over the measured angles."""
        return max(row.delta_e_2000 for row in self.angles)

    def with_fit(self, fit: LayersFit) -> PaintFit:
        """Return the same paint with other lobes fitted to it: those that came after the time limit."""
        seconds = self.seconds + fit.seconds - self.fit.seconds
        return replace(self, fit=fit, angles=_results(self.paint, fit.weights), seconds=seconds)

    def to_json(self) -> dict[str, object]:
        """Return weights, errors and times as plain values; times in milliseconds, angles in degrees."""
        weights = self.weights
        return {
            "paint": self.paint.name,
            "exponents": weights.exponents.tolist(),
            "kd": weights.kd.tolist(),
            "kdd": weights.kdd.tolist(),
            "kg": weights.kg.tolist(),
            "theta_fit_deg": float(np.degrees(weights.theta_fit_rad)),
            "ior": weights.ior,
            "coat_roughness": self.reflectance.roughness,
            "ms": self.fit.seconds * 1e3,
            "paint_to_weights_ms": self.seconds * 1e3,
            "time_limited": self.time_limited,
            "angles": [
                {
                    "illumination_deg": row.illumination_deg,
                    "aspecular_deg": row.aspecular_deg,
                    "lab_asked": list(row.asked),
                    "lab_fitted": list(row.fitted),
                    "delta_e_2000": row.delta_e_2000,
                }
                for row in self.angles
            ],
            "delta_e_2000_worst": self.worst_delta_e,
            "notices": list(self.notices),
        }


class PaintFitter:
    """Fits paint after paint on one kept linear program.

    Parameters
    ----------
    basis
        Lobe exponents; default: the suite's own.
    time_limit_s
        Hard limit of one fit, in seconds.

    :meth:`close`, or losing the last reference, ends the thread that finishes what the limit cut short.
    """

    def __init__(self, basis: LobeBasis | None = None, *, time_limit_s: float = DEFAULT_TIME_LIMIT_S) -> None:
        self._fitter = LobeFitter(basis, time_limit_s=time_limit_s)

    @property
    def basis(self) -> LobeBasis:
        """The exponents that weights are fitted for."""
        return self._fitter.basis

    def close(self) -> None:
        """Drop what is still worked at; a fit whose optimum is to come will not get it."""
        self._fitter.close()

    def fit(self, paint: Paint) -> PaintFit:
        """Return the lobe fit of ``paint``.

        Raises
        ------
        UnreachableError
            The gloss or a colour is one that no such paint can have; the message says which.
        """
        start = perf_counter()
        reflectance = build_paint(paint)
        fit = self._fitter.fit(reflectance)
        seconds = perf_counter() - start
        notices = (
            reflectance.notices + told_misses(paint, reflectance) + _light_notice(reflectance, fit.weights)
        )
        return PaintFit(paint, reflectance, fit, _results(paint, fit.weights), notices, seconds)


def _light_notice(reflectance: PaintReflectance, weights: LobeWeights) -> tuple[str, ...]:
    if not isinstance(reflectance.base, SeveralLights):
        return ()
    # Lobes know the mirror angle only, not how far light and view are apart.
    return (
        f"The lobes are fitted with the light at {np.degrees(weights.theta_fit_rad):.0f}°; the readings under other "
        "lights enter the picture by weights fitted for every angle of the view.",
    )


def fit_patiently(
    paint: Paint, name_or_path: str | os.PathLike[str], basis: LobeBasis | None = None
) -> PaintFit:
    """Fit one paint where no frame waits for it; ``name_or_path`` is what the user called it.

    Raises
    ------
    UnreachableError, FittingError
        As :meth:`PaintFitter.fit`, with the name of the paint or of its file before the message.
    """
    try:
        fitter = PaintFitter(basis, time_limit_s=PATIENT_TIME_LIMIT_S)
        try:
            return fitter.fit(paint)
        finally:
            fitter.close()
    except (UnreachableError, FittingError) as error:
        raise type(error)(f"{Path(name_or_path).name}: {error}") from error


@lru_cache(maxsize=16)
def _directions(geometries: tuple[tuple[float, float], ...]) -> tuple[Floats, Floats]:
    """wi (n, 3) and wo (n, 3) of readings at illumination and aspecular angles, degrees: the same from edit to edit."""
    incidence, aspecular = np.array(geometries).T
    return illumination(incidence), aspecular_view(incidence, aspecular)


def _results(paint: Paint, weights: LobeWeights) -> tuple[AngleResult, ...]:
    asked = np.array([m.lab for m in paint.measurements])
    light, view = _directions(tuple((m.illumination_deg, m.aspecular_deg) for m in paint.measurements))
    fitted = working_to_lab(np.pi * weights.eval(light, view))
    difference = delta_e_2000(asked, fitted)
    return tuple(
        AngleResult(m.illumination_deg, m.aspecular_deg, m.lab, _lab(fitted[i]), float(difference[i]))
        for i, m in enumerate(paint.measurements)
    )


def _lab(row: np.ndarray[tuple[int], np.dtype[np.float64]]) -> Lab:
    return float(row[0]), float(row[1]), float(row[2])
