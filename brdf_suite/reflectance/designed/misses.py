"""Residuals of a paint's interpolation rule at its readings.

A rule with fewer numbers than there are readings passes near them only; and readings on both sides of the mirror
direction may contradict each other.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.paint import Paint
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.protocol import Reflectance

TOLERANCE_DELTA_E = 0.05
"""The largest ΔE00 that counts as passing through a reading."""


def interpolation_notices(paint: Paint, reflectance: Reflectance) -> tuple[str, ...]:
    """Return the notice that names every missed reading of ``paint``, or nothing where all are met.

    A colour that the working space does not hold is compared as it is shown; another notice reports it.
    """
    if len(paint.measurements) <= 3:
        # Every rule passes through three readings.
        return ()
    light = [m.illumination_deg for m in paint.measurements]
    view = aspecular_view(light, [m.aspecular_deg for m in paint.measurements])
    shown = working_to_lab(np.maximum(lab_to_working([m.lab for m in paint.measurements]), 0.0))
    return format_interpolation_notice(
        paint, delta_e_2000(shown, working_to_lab(math.pi * reflectance.eval(illumination(light), view)))
    )


def format_interpolation_notice(paint: Paint, missed: npt.ArrayLike) -> tuple[str, ...]:
    """Return the notice for ΔE00 ``missed`` (n,) of the paint's readings, in their order, or nothing."""
    several = len({m.illumination_deg for m in paint.measurements}) > 1
    named = [
        f"{delta:.2f} at {m.aspecular_deg:g}°"
        + (f" with the light at {m.illumination_deg:g}°" if several else "")
        for m, delta in zip(paint.measurements, np.asarray(missed, float).tolist(), strict=True)
        if delta > TOLERANCE_DELTA_E
    ]
    if not named:
        return ()
    return (f"The rule does not pass through every reading of this paint: ΔE00 {', '.join(named)}.",)
