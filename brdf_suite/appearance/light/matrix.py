"""Light of other colours: lamps by their colour temperature, and a matrix on radiance for another illuminant.

Below 4,000 K a lamp is taken for a Planckian radiator, from there on for a phase of daylight, as the field does: the
CIE's daylight illuminants begin at 4,000 K, incandescent lamps end below. The two loci lie Δu'v' = 0.004 apart
there; between 3,900 and 4,100 K one goes over into the other, so that no slider jumps.

The matrix approximates another illuminant where only colours and no spectra are known.

A neutral environment is taken for one of another white. Of a paint of which only L*a*b* is known, an observer who has
adapted to that light is assumed to see the same colour (CAT16); so

- to an adapted eye the picture stays as it is under D65,
- to an eye that stays adapted to D65 every stimulus goes through the same adaptation backwards, from D65 to the
  light's white, which tints it as the light is tinted.

Neither says anything about how the paint's spectrum meets the light's: there is no metamerism in it.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WHITE_D65_10, WORKING_TO_XYZ, adaptation
from brdf_suite.appearance.colour.spectra import colour_matching, table_wavelengths, white_xyz
from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import LightColour
from brdf_suite.errors import ValueRangeError

_SECOND_RADIATION_M_K = 1.438776877e-2  # CODATA 2018
_JOIN_LOW_K, _JOIN_HIGH_K = 3900.0, 4100.0


def planck_xyz(kelvin: float) -> Floats:
    """Return XYZ (3,) with Y = 1 of a Planckian radiator, CIE 1931 observer, 360 to 780 nm."""
    metres = table_wavelengths() * 1e-9
    power = metres**-5 / np.expm1(_SECOND_RADIATION_M_K / (metres * kelvin))
    xyz = power @ colour_matching(2)
    return np.asarray(xyz / xyz[1])


def daylight_xyz(kelvin: float) -> Floats:
    """Return XYZ (3,) with Y = 1 of the phase of daylight of a colour temperature, 4,000 to 25,000 K.

    Source: CIE 15:2004, section 3.1. (The polynomial is continued by 100 K below its range, for the join.)
    """
    t = 1e3 / kelvin
    low, high = (-4.6070, 2.9678, 0.09911, 0.244063), (-2.0064, 1.9018, 0.24748, 0.237040)
    third, second, first, constant = low if kelvin <= 7000.0 else high
    x = ((third * t + second) * t + first) * t + constant
    y = (-3.0 * x + 2.870) * x - 0.275
    return np.array([x / y, 1.0, (1.0 - x - y) / y])


def lamp_colour(kelvin: float) -> Floats:
    """Return the working-space colour (3,) of unit luminance of a lamp; 1,000 to 25,000 K.

    A channel below 0 (blue, under about 1,400 K) is set to 0: the working space holds no redder light.

    >>> lamp_colour(6504.0).round(2).tolist()
    [1.0, 1.0, 1.0]
    """
    if not 1000.0 <= kelvin <= 25000.0:
        raise ValueRangeError("colour temperature", f"{kelvin:g} K is outside the range 1,000 to 25,000 K")
    daylight = float(np.clip((kelvin - _JOIN_LOW_K) / (_JOIN_HIGH_K - _JOIN_LOW_K), 0.0, 1.0))
    xyz = np.zeros(3)
    if daylight > 0.0:
        xyz += daylight * daylight_xyz(kelvin)
    if daylight < 1.0:
        xyz += (1.0 - daylight) * planck_xyz(kelvin)
    return np.asarray(np.maximum(np.linalg.solve(WORKING_TO_XYZ, xyz), 0.0))


ILLUMINANT_OF: dict[str, str] = {
    "D65": "D65",
    "D50": "D50",
    "A": "A",
    "TL84": "F11",
    "CWF": "F2",
    "LED": "LED-B3",
}
"""Lamps of a light booth, by the illuminant of the CIE that represents them."""


@cache
def light_matrix(lamp: str, adapted: bool) -> Floats:
    """Return the matrix (3, 3) on radiance of the working space under ``lamp``, for the observer of 10°.

    ``environment`` leaves the light as it is. Greys keep their luminance.

    >>> (light_matrix("A", adapted=False) @ [1.0, 1.0, 1.0]).round(2).tolist()
    [1.46, 0.88, 0.31]
    """
    matrix: Floats = np.eye(3)
    if not adapted and lamp not in ("environment", "D65"):
        tint = adaptation(WHITE_D65_10, white_xyz(ILLUMINANT_OF[lamp], 10))
        matrix = np.asarray(np.linalg.solve(WORKING_TO_XYZ, tint @ WORKING_TO_XYZ))
        matrix = matrix / (LUMINANCE @ matrix.sum(axis=1))
    matrix.flags.writeable = False  # one for all who ask
    return matrix


def environment_matrix(colour: LightColour) -> Floats:
    """Return the matrix (3, 3) on an environment's radiance for its colour and brightness in a view."""
    return np.asarray(light_matrix(colour.illuminant, colour.adapted) * colour.brightness)
