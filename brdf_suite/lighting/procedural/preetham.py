"""The clear sky of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight" (SIGGRAPH 1999).

Perez's function of the angle from the zenith and the angle from the sun, fitted for luminance and for the
chromaticities x and y over turbidity; all constants are those of the paper's appendix.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import colour_from_chromaticity

# Rows: luminance Y, x, y. Columns: A, B, C, D, E. Each is a slope over turbidity and a constant.
_SLOPE = np.array(
    [
        [0.1787, -0.3554, -0.0227, 0.1206, -0.0670],
        [-0.0193, -0.0665, -0.0004, -0.0641, -0.0033],
        [-0.0167, -0.0950, -0.0079, -0.0441, -0.0109],
    ]
)
_CONSTANT = np.array(
    [
        [-1.4630, 0.4275, 5.3251, -2.5771, 0.3703],
        [-0.2592, 0.0008, 0.2125, -0.8989, 0.0452],
        [-0.2608, 0.0092, 0.2102, -1.6537, 0.0529],
    ]
)
# Zenith chromaticity: rows for turbidity², turbidity, 1; columns for the sun's zenith angle³, ², ¹, 1.
_ZENITH_X = np.array(
    [
        [0.00166, -0.00375, 0.00209, 0.0],
        [-0.02903, 0.06377, -0.03202, 0.00394],
        [0.11693, -0.21196, 0.06052, 0.25886],
    ]
)
_ZENITH_Y = np.array(
    [
        [0.00275, -0.00610, 0.00317, 0.0],
        [-0.04214, 0.08970, -0.04153, 0.00516],
        [0.15346, -0.26756, 0.06670, 0.26688],
    ]
)


def zenith(turbidity: float, sun_zenith: float) -> Floats:
    """Return luminance (kcd/m²) and chromaticity x, y of the zenith, (3,); ``sun_zenith`` in radians."""
    chi = (4.0 / 9.0 - turbidity / 120.0) * (np.pi - 2.0 * sun_zenith)
    luminance = (4.0453 * turbidity - 4.9710) * np.tan(chi) - 0.2155 * turbidity + 2.4192
    haze = turbidity ** np.array([2.0, 1.0, 0.0])
    angle = sun_zenith ** np.array([3.0, 2.0, 1.0, 0.0])
    return np.array([luminance, haze @ _ZENITH_X @ angle, haze @ _ZENITH_Y @ angle])


def _perez(cos_zenith: Floats, cos_sun: Floats, turbidity: float) -> Floats:
    """Return Perez's function (..., 3) for Y, x and y."""
    a, b, c, d, e = (_SLOPE * turbidity + _CONSTANT).T
    cos_zenith, cos_sun = cos_zenith[..., None], cos_sun[..., None]
    from_sun = np.arccos(np.clip(cos_sun, -1.0, 1.0))
    gradient = 1.0 + a * np.exp(b / cos_zenith)
    return np.asarray(gradient * (1.0 + c * np.exp(d * from_sun) + e * cos_sun**2))


def sky_radiance(toward: Floats, sun: Floats, turbidity: float = 3.0) -> Floats:
    """Return the sky's radiance (..., 3), working space, kcd/m², without the sun's disc.

    Parameters
    ----------
    toward
        Unit directions (..., 3); below the horizon the colour of the horizon is held.
    sun
        Unit direction (3,) to the sun, above the horizon.
    turbidity
        Haze: 2 very clear, 3 clear, 6 hazy; the model holds from 2 to about 6.
    """
    cos_zenith = np.maximum(toward[..., 1], 0.01)
    cos_sun = toward @ sun
    at_zenith = _perez(np.ones(1), np.array([sun[1]]), turbidity)[0]
    values = zenith(turbidity, float(np.arccos(sun[1]))) * _perez(cos_zenith, cos_sun, turbidity) / at_zenith
    colours = np.maximum(colour_from_chromaticity(values[..., 1], values[..., 2]), 0.0)
    return np.asarray(colours * values[..., :1])
