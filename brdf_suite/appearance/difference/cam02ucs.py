"""CAM02-UCS: the uniform space of the colour appearance model CIECAM02, and differences in it.

CIECAM02 (CIE 159:2004) predicts lightness J, colourfulness M and hue h under stated viewing conditions; Luo, Cui and
Li 2006 made them uniform:

    J' = 1.7 J / (1 + .007 J),   M' = ln(1 + .0228 M) / .0228,   a' = M' cos h,   b' = M' sin h.

L*a*b* here is of D65 and the 10° observer, as paint is measured. The default conditions are those of a light booth:
1,000 lx on a grey of 20 % in an average surround.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import WHITE_D65_10, lab_to_xyz
from brdf_suite.appearance.difference.formulas import delta_e_76
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

SURROUNDS: dict[str, tuple[float, float, float]] = {
    "average": (1.0, 0.69, 1.0),
    "dim": (0.9, 0.59, 0.9),
    "dark": (0.8, 0.525, 0.8),
}
"""F, c and Nc by the surround's name."""

BOOTH_LUX = 1000.0

_CAT02 = np.array([[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0030, 0.0136, 0.9834]])
_HUNT = np.array([[0.38971, 0.68898, -0.07868], [-0.22981, 1.18340, 0.04641], [0.0, 0.0, 1.0]])
_CAT02_TO_HUNT: Floats = np.asarray(_HUNT @ np.linalg.inv(_CAT02), np.float64)


@dataclass(frozen=True)
class ViewingConditions:
    """The adaptation state of the observer.

    ``adapting_luminance`` in cd/m² (a fifth of the white's, as a rule), ``background`` the relative luminance
    of the background in percent, ``surround`` a key of :data:`SURROUNDS`.
    """

    adapting_luminance: float = BOOTH_LUX / math.pi / 5.0
    background: float = 20.0
    surround: str = "average"

    def __post_init__(self) -> None:
        if not self.adapting_luminance > 0.0:
            raise ValueRangeError("adapting_luminance", "expected a positive luminance in cd/m²")
        if not 0.0 < self.background <= 100.0:
            raise ValueRangeError("background", "expected a relative luminance above 0 and to 100")
        if self.surround not in SURROUNDS:
            raise ValueRangeError(
                "surround", f"expected one of {', '.join(SURROUNDS)}, not {self.surround!r}"
            )


BOOTH = ViewingConditions()


def xyz_to_cam02ucs(
    xyz: npt.ArrayLike, white: npt.ArrayLike, conditions: ViewingConditions = BOOTH
) -> Floats:
    """Return J'a'b' (..., 3) of XYZ (..., 3) under a white (3,); both on the scale where the white's Y is 100.

    Colours outside the spectrum, of which the model says nothing, give finite values: negative responses are
    carried by their size and sign.
    """
    white = np.asarray(white, float)
    surround_f, surround_c, induction = SURROUNDS[conditions.surround]
    five = 5.0 * conditions.adapting_luminance
    k4 = (1.0 / (five + 1.0)) ** 4
    level = 0.2 * k4 * five + 0.1 * (1.0 - k4) ** 2 * five ** (1.0 / 3.0)
    n = conditions.background / white[1]
    background = 0.725 * n**-0.2
    z = 1.48 + math.sqrt(n)
    adapted = surround_f * (1.0 - math.exp((-conditions.adapting_luminance - 42.0) / 92.0) / 3.6)
    gains = adapted * white[1] / (_CAT02 @ white) + 1.0 - adapted
    to_cones = _CAT02_TO_HUNT @ (gains[:, None] * _CAT02)

    def respond(tristimulus: Floats) -> Floats:
        cones = tristimulus @ to_cones.T
        raised = (level * np.abs(cones) / 100.0) ** 0.42
        return np.asarray(np.copysign(400.0 * raised / (raised + 27.13), cones) + 0.1)

    def achromatic(response: Floats) -> Floats:
        return np.asarray((response @ np.array([2.0, 1.0, 0.05]) - 0.305) * background)

    response = respond(np.asarray(xyz, float))
    red, green, blue = (response[..., i] for i in range(3))
    a, b = red - 12.0 * green / 11.0 + blue / 11.0, (red + green - 2.0 * blue) / 9.0
    hue = np.arctan2(b, a)
    eccentricity = 0.25 * (np.cos(hue + 2.0) + 3.8)
    lightness = achromatic(response) / achromatic(respond(white))
    j = 100.0 * np.copysign(np.abs(lightness) ** (surround_c * z), lightness)
    t = 50_000.0 / 13.0 * induction * background * eccentricity * np.hypot(a, b)
    # Black gives .305 here; only colours outside of the spectrum give less, and the model says nothing of them.
    t = t / np.maximum(red + green + 1.05 * blue, 0.305)
    chroma = t**0.9 * np.sqrt(np.maximum(j, 0.0) / 100.0) * (1.64 - 0.29**n) ** 0.73
    m = np.log1p(0.0228 * chroma * level**0.25) / 0.0228
    return np.stack((1.7 * j / (1.0 + 0.007 * j), m * np.cos(hue), m * np.sin(hue)), axis=-1)


def lab_to_cam02ucs(lab: npt.ArrayLike, conditions: ViewingConditions = BOOTH) -> Floats:
    """Return J'a'b' (..., 3) of L*a*b* (D65, 10°).

    >>> lab_to_cam02ucs([100.0, 0.0, 0.0]).round(1)[0].item()
    100.0
    """
    return xyz_to_cam02ucs(lab_to_xyz(lab), WHITE_D65_10, conditions)


def delta_e_cam02ucs(
    lab1: npt.ArrayLike, lab2: npt.ArrayLike, conditions: ViewingConditions = BOOTH
) -> Floats:
    """Return the distance (...) in CAM02-UCS between L*a*b* arrays (..., 3) that broadcast."""
    return delta_e_76(lab_to_cam02ucs(lab1, conditions), lab_to_cam02ucs(lab2, conditions))
