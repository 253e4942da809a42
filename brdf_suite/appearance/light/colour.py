"""Colours under another illuminant than the measured one, and metamerism.

A paint with spectra is *recomputed*: its L*a*b* under the new light is what an instrument would report. A paint of
which only L*a*b* is known is *adapted*: an observer adapted to the new light is assumed to see the same colour, so the
tristimulus values are turned from one white to the other by CAT16. That says nothing about how this paint's spectrum
meets the new light's, and every such value is labelled.

XYZ has the white's Y = 100; L*a*b* is relative to the white of its own light.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import WHITE_D65_10, AdaptationTransform, lab_to_xyz, xyz_to_lab
from brdf_suite.appearance.colour.spaces import adapt_xyz
from brdf_suite.appearance.colour.spectra import spectrum_to_xyz, white_xyz
from brdf_suite.appearance.difference.formulas import delta_e_76
from brdf_suite.appearance.difference.tolerance import Difference
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

Road = Literal["measured", "adapted", "recomputed"]

LABELS: dict[str, str] = {
    "measured": "as measured under D65",
    "adapted": "adapted from D65; the spectrum is not known, so metamerism is not shown",
    "recomputed": "recomputed from the spectrum",
}
"""Notices for the user, by method."""


@dataclass(frozen=True, eq=False)
class ColourUnderLight:
    """XYZ and L*a*b* (..., 3) under an illuminant, and the method of conversion."""

    xyz: Floats
    lab: Floats
    illuminant: str
    observer_deg: int
    road: Road

    @property
    def label(self) -> str:
        """Return the notices for the user about the colour."""
        return f"{self.illuminant}, {self.observer_deg}°: {LABELS[self.road]}"


def adapt_colour(
    lab: npt.ArrayLike, illuminant: str, transform: AdaptationTransform = "CAT16"
) -> ColourUnderLight:
    """Return the colour under ``illuminant`` of L*a*b* (..., 3) measured under D65 with the 10° observer."""
    xyz = lab_to_xyz(lab)
    if illuminant == "D65":
        return ColourUnderLight(xyz, np.asarray(lab, float), illuminant, 10, "measured")
    white = white_xyz(illuminant, 10)
    adapted = adapt_xyz(xyz, WHITE_D65_10, white, transform)
    return ColourUnderLight(adapted, xyz_to_lab(adapted, white), illuminant, 10, "adapted")


def colour_from_spectra(
    values: npt.ArrayLike, wavelengths_nm: npt.ArrayLike, illuminant: str, observer_deg: int = 10
) -> ColourUnderLight:
    """Return the colour under ``illuminant`` of reflectance spectra (..., k)."""
    xyz = spectrum_to_xyz(values, wavelengths_nm, illuminant, observer_deg)
    lab = xyz_to_lab(xyz, white_xyz(illuminant, observer_deg))
    return ColourUnderLight(xyz, lab, illuminant, observer_deg, "recomputed")


def metamerism_index(
    reference: npt.ArrayLike,
    sample: npt.ArrayLike,
    wavelengths_nm: npt.ArrayLike,
    test_illuminant: str = "A",
    reference_illuminant: str = "D65",
    observer_deg: int = 10,
    difference: Difference = delta_e_76,
) -> Floats:
    """Return the special index of metamerism (...), change in illuminant, of spectra (..., k).

    How far two colours part under the test light that match under the reference light (CIE 15, section 9.2). Where
    they do not quite match, the sample's tristimulus values under the test light are first multiplied by the
    ratios reference / sample under the reference light. ``difference`` is ΔE*ab as in the CIE's index; others
    may be given.

    Raises
    ------
    ValueRangeError
        A sample that reflects nothing under the reference light cannot be corrected.
    """
    light, test = (reference_illuminant, observer_deg), (test_illuminant, observer_deg)
    wanted = spectrum_to_xyz(reference, wavelengths_nm, *light)
    given = spectrum_to_xyz(sample, wavelengths_nm, *light)
    if np.any(given <= 0.0):
        raise ValueRangeError("sample", "it has no light in one of X, Y, Z, so it cannot be brought to match")
    first = spectrum_to_xyz(reference, wavelengths_nm, *test)
    second = spectrum_to_xyz(sample, wavelengths_nm, *test) * (wanted / given)
    white = white_xyz(test_illuminant, observer_deg)
    return np.asarray(difference(xyz_to_lab(first, white), xyz_to_lab(second, white)))
