"""Reflectances with spectra under another lamp: what an adapted eye sees, metamerism included."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.colour.spectra import DEFAULT_WAVELENGTHS_NM as BANDS
from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.appearance.light.colour import colour_from_spectra
from brdf_suite.documents.view_settings import LightColour
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.lobe_fit import fit_material, refit_under
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.instruments.under_light import Relit, relit
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

EDGE = 0.05 + 0.6 / (1.0 + np.exp(-(BANDS - 590.0) / 8.0))  # a red, whose colour depends on the lamp


def samples() -> ScatteredSamples:
    light = illumination(45.0)
    angles = np.arange(-25.0, 111.0, 5.0)
    views = np.array([aspecular_view(45.0, angle) for angle in angles])
    shape = 1.0 + 2.0 * np.exp(-((angles / 25.0) ** 2))
    spectra = shape[:, None] * EDGE / np.pi
    values = spectrum_to_working(spectra, BANDS)
    return ScatteredSamples(np.tile(light, (len(views), 1)), views, np.maximum(values, 0), spectra, BANDS)


@pytest.mark.parametrize("lamp", ["A", "F11"])
def test_the_colour_is_the_one_that_is_computed_from_the_spectrum(lamp: str) -> None:
    found = relit(samples(), lamp)
    lab = working_to_lab(np.pi * found.values)
    expected = colour_from_spectra(np.pi * samples().spectra, BANDS, lamp).lab
    np.testing.assert_allclose(lab, expected, atol=1e-3)
    assert np.abs(expected[0] - working_to_lab(np.pi * samples().values[0])).max() > 1.0


def test_under_d65_nothing_changes() -> None:
    np.testing.assert_allclose(relit(samples(), "D65").values, samples().values, atol=1e-12)


def test_what_is_no_table_of_samples_is_asked_for_its_spectra() -> None:
    source, light = samples(), illumination(45.0)
    view = aspecular_view(45.0, 45.0)
    got = Relit(source, "A").eval(light, view)
    expected = spectrum_to_working(source.eval_spectra(light, view), BANDS, illuminant="A")
    np.testing.assert_allclose(got, expected)


def test_the_fit_follows_the_lamp_and_is_the_same_where_nothing_is_known() -> None:
    fit = fit_material(Material("red", samples()))
    for colour in (LightColour(), LightColour("D65"), LightColour("environment", adapted=False)):
        assert refit_under(fit, colour) is fit
    under = refit_under(fit, LightColour("A"))
    assert under.name == "red"
    assert (
        under.weights.kd[0] + under.weights.kdd[:, 0].sum() > fit.weights.kd[0] + fit.weights.kdd[:, 0].sum()
    )
    plain = fit_material(Material("plain", ScatteredSamples(samples().wi, samples().wo, samples().values)))
    assert refit_under(plain, LightColour("A")) is plain
