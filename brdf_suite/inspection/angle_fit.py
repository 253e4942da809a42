"""A paint's lobes at several incidences: for work without a screen and for looking at what a fit does.

Not the edit path: the time limit is a patient one, and the errors are worked out with the fit.
"""

from __future__ import annotations

import os
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles import AngleFit, AngleFitter, AngleGrid, AngleWeights
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.metrics import aspecular_delta_e
from brdf_suite.pipeline.fit_errors import JUDGED_GAMMAS_DEG
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.designed.layers import depends_on_halfway, split_layers

#: Where the errors are evaluated: incidences, each at the judged aspecular angles as far as a view stands no lower.
JUDGED_INCIDENCES_DEG = (10.0, 20.0, 30.0, 45.0, 60.0, 65.0, 75.0, 80.0)
LOWEST_VIEW_DEG = 85.0


@dataclass(frozen=True)
class IncidenceError:
    """ΔE00 between paint and fit at one geometry, degrees."""

    illumination_deg: float
    aspecular_deg: float
    delta_e_2000: float


@dataclass(frozen=True, eq=False)
class AnglePaintFit:
    """A paint and its weights at several incidences; ``errors`` at the judged geometries."""

    name: str
    fit: AngleFit
    errors: tuple[IncidenceError, ...]
    notices: tuple[str, ...]

    @property
    def weights(self) -> AngleWeights:
        """The weights, linear Rec. 2020."""
        return self.fit.weights

    @property
    def worst_delta_e(self) -> float:
        """The largest ΔE00 of ``errors``."""
        return max(row.delta_e_2000 for row in self.errors)

    def to_json(self) -> dict[str, object]:
        """Return weights, errors and times as plain values; times in milliseconds, angles in degrees."""
        weights = self.weights
        return {
            "paint": self.name,
            "exponents": weights.exponents.tolist(),
            "angles": weights.grid.count,
            "cosines": weights.cosines.tolist(),
            "incidences_deg": np.degrees(np.arccos(weights.cosines)).tolist(),
            "power": weights.grid.power,
            "kd": weights.kd.tolist(),
            "kdd": weights.kdd.tolist(),
            "kg": weights.kg.tolist(),
            "ior": weights.ior,
            "base_under_coat": weights.base_under_coat,
            "base_at_halfway": weights.base_at_halfway,
            "ms": self.fit.seconds * 1e3,
            "time_limited": self.fit.time_limited,
            "l1_relative": {
                "base": self.fit.base_error.relative.tolist(),
                "coat": self.fit.coat_error.relative.tolist(),
            },
            "errors": [asdict(row) for row in self.errors],
            "delta_e_2000_worst": self.worst_delta_e,
            "notices": list(self.notices),
        }


def judged_gammas(illumination_deg: float) -> tuple[float, ...]:
    """Return the aspecular angles, degrees, that have a view well above the horizon at an incidence."""
    return tuple(g for g in JUDGED_GAMMAS_DEG if abs(illumination_deg - g) <= LOWEST_VIEW_DEG)


def fit_at_angles(
    name_or_path: str | os.PathLike[str],
    count: int = 16,
    basis: LobeBasis | None = None,
    *,
    time_limit_s: float = PATIENT_TIME_LIMIT_S,
) -> AnglePaintFit:
    """Fit one paint, designed or Cook-Torrance, at ``count`` incidences; ``name_or_path`` is what the user called it.

    Raises
    ------
    UnreachableError, FittingError
        No such paint can be, or it cannot be fitted at so few or so many angles, or is measured data; the paint's name
        stands before the message.
    FileError, DocumentError
        There is no such paint, or its file is not valid.
    """
    grid = AngleGrid(count)
    material = load_material(name_or_path)
    reflectance = material.reflectance
    try:
        layers = split_layers(reflectance)
        if layers is None:
            raise FittingError(
                "nothing divides measured data into coat and base, so they cannot be fitted at several angles; leave "
                "out the number of angles."
                if material.facts
                else "it has no coat and base to be fitted at several angles; leave out the number of angles."
            )
        halfway = depends_on_halfway(layers)
        fitter = AngleFitter(basis, grid=grid, halfway=halfway, time_limit_s=time_limit_s)
        try:
            fit = fitter.fit(layers)
        finally:
            fitter.close()
    except FittingError as error:
        raise FittingError(f"{Path(name_or_path).name}: {error}") from error
    errors = tuple(
        IncidenceError(theta, gamma, float(difference))
        for theta in JUDGED_INCIDENCES_DEG
        for gamma, difference in zip(
            judged_gammas(theta),
            aspecular_delta_e(reflectance, fit.weights, judged_gammas(theta), theta),
            strict=True,
        )
    )
    return AnglePaintFit(material.name, fit, errors, material.notices)
