"""Matrix on radiance that approximates another illuminant where only colours and no spectra are known.

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
from brdf_suite.appearance.colour.spectra import white_xyz
from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import LightColour

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
