"""The clear sky and the sun of Hošek and Wilkie.

Sky: L. Hošek and A. Wilkie, "An Analytic Model for Full Spectral Sky-Dome Radiance", ACM Trans. Graph. 31(4), 2012.
Sun: the same, "Adding a Solar-Radiance Function to the Hošek-Wilkie Skylight Model", IEEE CG&A 33(3), 2013; its
darkening towards the limb is that of the same data. Both are spectral, in W/(m²·sr·nm) at 11 wavelengths from 320 to
720 nm; here they become luminance and colour through the CIE 1931 observer, so that a sky is in kcd/m² without any
factor of taste. The tables are the authors' (``packaging/generators/sky_tables.py``).
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_XYZ
from brdf_suite.appearance.colour.spectra import colour_matching, table_wavelengths
from brdf_suite.arrays import Floats
from brdf_suite.resources import resource

WAVELENGTHS_NM = np.arange(320.0, 721.0, 40.0)
_LM_PER_W = 683.002  # SI, luminous efficacy at 540 THz over the observer's peak
_SEGMENTS = 45
_MODEL_DISC_DEG = 0.5358  # for which the sun's radiance is given


@cache
def _tables() -> dict[str, Floats]:
    with np.load(resource("sky", "hosek_wilkie.npz"), allow_pickle=False) as stored:
        return {name: stored[name].astype(np.float64) for name in stored.files}


@cache
def spectrum_to_working() -> Floats:
    """Return the matrix (11, 3) from radiance at the model's wavelengths, W/(m²·sr·nm), to the working space, kcd/m².

    Between the wavelengths radiance is linear; beyond 720 nm, where it is not given, the eye sees 0.03 % of it.
    """
    at = table_wavelengths()
    hats = np.stack([np.interp(at, WAVELENGTHS_NM, unit, right=0.0) for unit in np.eye(len(WAVELENGTHS_NM))])
    xyz = hats @ colour_matching(2) * (_LM_PER_W / 1000.0)  # the tables are in steps of 1 nm
    return np.asarray(np.linalg.solve(WORKING_TO_XYZ, xyz.T).T)


def _of_turbidity(table: Floats, turbidity: float) -> Floats:
    low = min(int(turbidity) - 1, len(table) - 2)
    share = turbidity - 1.0 - low
    return np.asarray(table[low] * (1.0 - share) + table[low + 1] * share)


class HosekWilkieSky:
    """The Hošek-Wilkie sky for one position of the sun.

    Parameters
    ----------
    sun
        Unit direction (3,) to the sun, above the horizon.
    turbidity
        1 to 10.
    albedo
        Of the ground, 0 to 1, the same at all wavelengths.
    """

    def __init__(self, sun: Floats, turbidity: float, albedo: float) -> None:
        self._sun = sun
        # Quintic Bézier curves over the cube root of the elevation (eq. 11 of the paper).
        x = (math.asin(min(1.0, float(sun[1]))) / (0.5 * np.pi)) ** (1.0 / 3.0)
        weights = np.array([math.comb(5, i) * (1.0 - x) ** (5 - i) * x**i for i in range(6)])

        def chosen(name: str) -> Floats:
            grid = _of_turbidity(_tables()[name], turbidity)
            return np.asarray(np.tensordot(weights, grid[0] * (1.0 - albedo) + grid[1] * albedo, axes=1))

        self._configuration = chosen("sky_params_spec")  # (11, 9)
        self._mean = chosen("sky_rad_spec")  # (11,)

    def spectral(self, toward: Floats) -> Floats:
        """Return the radiance (..., 11), W/(m²·sr·nm), in unit directions (..., 3) above the horizon (eq. 8)."""
        cos_theta = np.maximum(toward[..., 1], 0.0)[..., None]
        cos_gamma = np.clip(toward @ self._sun, -1.0, 1.0)[..., None]
        gamma = np.arccos(cos_gamma)
        a, b, c, d, e, f, g, i, h = self._configuration.T
        chi = (1.0 + cos_gamma**2) / (1.0 + h * h - 2.0 * h * cos_gamma) ** 1.5
        gradient = 1.0 + a * np.exp(b / (cos_theta + 0.01))
        scattering = c + d * np.exp(e * gamma) + f * cos_gamma**2 + g * chi + i * np.sqrt(cos_theta)
        return np.asarray(np.maximum(gradient * scattering * self._mean, 0.0))

    def radiance(self, toward: Floats) -> Floats:
        """Return working-space radiance (..., 3), kcd/m²; below the horizon that of the horizon is held."""
        return np.maximum(self.spectral(toward) @ spectrum_to_working(), 0.0)


def sun_spectral(elevation_rad: float, turbidity: float, disc_deg: float, cos_psi: Floats) -> Floats:
    """Return the radiance (..., 11) of the sun's disc, W/(m²·sr·nm), at places ``cos_psi`` (...) on it.

    Parameters
    ----------
    disc_deg
        How wide the disc is drawn; what the sun gives stays that of the model, whose disc is 0.5358° wide.
    cos_psi
        Cosine between the sun's surface and the line of sight: 1 in the middle, 0 at the limb.
    """
    part = min(int(np.cbrt(elevation_rad / (0.5 * np.pi)) * _SEGMENTS), _SEGMENTS - 1)
    start = 0.5 * np.pi * (part / _SEGMENTS) ** 3
    coefficients = _of_turbidity(_tables()["sun_rad_spec"], turbidity)[part]  # (11, 4)
    middle = coefficients @ (elevation_rad - start) ** np.arange(4.0)
    limb = cos_psi[..., None] ** np.arange(6.0) @ _tables()["sun_ld_spec"].T
    half = np.radians(0.5 * np.array([_MODEL_DISC_DEG, disc_deg]))
    wider = (1.0 - np.cos(half[0])) / (1.0 - np.cos(half[1]))
    return np.asarray(middle * limb * wider)
