"""Ideal virtual spectrophotometer: one light, one view, no aperture."""

from __future__ import annotations

import math

import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.protocol import Reflectance


def measure_lab(
    reflectance: Reflectance, illumination_deg: npt.ArrayLike, aspecular_deg: npt.ArrayLike
) -> Floats:
    """Return CIE L*a*b* (..., 3), D65 and 10° observer, in the plane of incidence; angles in degrees.

    The reading of a whole paint: base and coat. ρ = π f_r, so a perfect diffuser reads L* = 100.
    """
    wi, wo = illumination(illumination_deg), aspecular_view(illumination_deg, aspecular_deg)
    return working_to_lab(math.pi * reflectance.eval(wi, wo))
