"""Readings under another light, recomputed or adapted."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.spectra import spectrum_to_lab, spectrum_to_working
from brdf_suite.appearance.geometries import Geometry, geometry_set
from brdf_suite.appearance.light.colour import adapt_colour
from brdf_suite.reflectance.instruments.aperture import POINT, WIDE
from brdf_suite.reflectance.instruments.spectrophotometer import measure
from brdf_suite.reflectance.instruments.under_light import (
    has_spectra,
    metamerism,
    readings_under,
    spectrum_at,
)

BANDS = np.linspace(380.0, 780.0, 41)
RED = 0.05 + 0.6 / (1.0 + np.exp(-(BANDS - 600.0) / 15.0))


@dataclass(frozen=True)
class Spectral:
    """A reflectance factor per band, times cosθo."""

    spectrum: np.ndarray
    wavelengths_nm: np.ndarray | None = None

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        return self._cosine(wi, wo) * spectrum_to_working(self.spectrum, BANDS)

    def eval_spectra(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        return self._cosine(wi, wo) * self.spectrum

    def _cosine(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        wi, wo = np.broadcast_arrays(wi, wo)
        return wo[..., 2:] / math.pi


def test_known_spectra_are_recomputed() -> None:
    paint = Spectral(RED, BANDS)
    report = measure(paint, geometry_set("e2194"))
    for light in ("A", "F11", "D65"):
        colours = readings_under(paint, report, light)
        for reading, colour in zip(report.readings, colours, strict=True):
            factor = math.cos(math.radians(reading.geometry.view_deg))
            expected = spectrum_to_lab(RED * factor, BANDS, light)
            np.testing.assert_allclose(colour.lab, expected, atol=1e-9)
            assert colour.road == "recomputed"
    # Under D65 that is what the instrument read.
    np.testing.assert_allclose([c.lab for c in readings_under(paint, report, "D65")], report.lab, atol=1e-9)


def test_unknown_spectra_are_adapted() -> None:
    paint = Spectral(RED, None)
    assert not has_spectra(paint)
    assert has_spectra(Spectral(RED, BANDS))
    report = measure(paint, geometry_set("e2194"))
    colours = readings_under(paint, report, "A")
    np.testing.assert_allclose(colours[0].lab, adapt_colour(report.lab[0], "A").lab)
    assert {colour.road for colour in colours} == {"adapted"}


def test_spectra_are_read_through_the_aperture_too() -> None:
    """cosθ averaged over the receptor's cone, cosine-weighted as an instrument collects."""
    geometry = Geometry(45.0, 45.0)
    c = math.cos(math.radians(4.0))
    single, wide = (spectrum_at(Spectral(RED, BANDS), geometry, a) for a in (POINT, WIDE))
    np.testing.assert_allclose(single, RED)
    np.testing.assert_allclose(wide, RED * (2.0 / 3.0 * (1 - c**3) / (1 - c**2)), rtol=1e-9)


def test_metamerism_of_two_reflectances() -> None:
    first = Spectral(RED, BANDS)
    geometry = Geometry(45.0, 15.0)
    # The same paint measured at fewer bands is no metamer of itself.
    assert metamerism(first, Spectral(RED[::2], BANDS[::2]), geometry, POINT, "A") < 0.2
    assert metamerism(first, first, geometry, POINT, "A") == 0.0
    bump = RED + 0.2 * np.exp(-(((BANDS - 480.0) / 20.0) ** 2))
    assert metamerism(first, Spectral(bump, BANDS), geometry, POINT, "A") > 0.5
