"""How well one reflectance is followed by bases of 1, 2, 3 … lobes: the error of the search, for it alone.

What is of two layers gets the error of equation 4's database, base and coat half and half
(:mod:`brdf_suite.fitting.basis_search.error`). What nothing divides has no coat whose energy could be counted: its
error is that of the colour alone, at the same angles from 10° on and in the same unit, of the fit that the suite makes
of it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.fitting.basis_search.database import (
    BETWEEN_DEG,
    COAT_FROM_DEG,
    LIGHT_DEG,
    MEASURED_DEG,
    reflectances,
)
from brdf_suite.fitting.basis_search.error import MEASURED_UNIT, BasisError
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.lobes.measured import fit_undivided
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.designed.layers import split_layers
from brdf_suite.reflectance.protocol import Reflectance

Exponents = tuple[float, ...]


@dataclass(frozen=True)
class ErrorsOverCount:
    """``counts`` rising and ``errors`` for each; ``whole``: base and coat, else the colour alone."""

    counts: tuple[int, ...]
    errors: tuple[float, ...]
    whole: bool


def errors_over_count(
    reflectance: Reflectance, bases: Mapping[int, Exponents], progress: Progress | None = None
) -> ErrorsOverCount:
    """Return the errors of ``reflectance`` for bases by their count of lobes.

    Raises
    ------
    FittingError
        The reflectance is negative or not finite where a fit looks.
    Cancelled
        The progress callback asked for it.
    """
    counts = tuple(sorted(bases))
    layers = split_layers(reflectance)
    error = None if layers is None else BasisError(reflectances({"": layers}))
    errors = []
    for number, count in enumerate(counts):
        report(progress, number / len(counts), f"{count}")
        found = _colour_error(reflectance, bases[count]) if error is None else float(error(bases[count])[0])
        errors.append(found)
    report(progress, 1.0, "done")
    return ErrorsOverCount(counts, tuple(errors), error is not None)


def _colour_error(reflectance: Reflectance, exponents: Exponents) -> float:
    weights = fit_undivided(reflectance, LobeBasis(exponents)).weights
    angles = np.array([angle for angle in BETWEEN_DEG if angle >= COAT_FROM_DEG])
    light, views = illumination(LIGHT_DEG), aspecular_view(LIGHT_DEG, angles)
    labs = (working_to_lab(np.pi * np.asarray(one.eval(light, views))) for one in (reflectance, weights))
    difference = delta_e_2000(*labs)
    weight = np.where(np.isin(angles, MEASURED_DEG), MEASURED_UNIT, 1.0) ** -2.0
    return float(np.sqrt(difference**2 @ (weight / weight.sum())))
