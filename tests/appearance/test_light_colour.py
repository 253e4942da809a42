"""Colours under another light, and metamerism."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from scipy.optimize import least_squares

from brdf_suite.appearance.colour.colorimetry import WHITE_D65_10
from brdf_suite.appearance.colour.spectra import (
    DEFAULT_WAVELENGTHS_NM,
    spectrum_to_lab,
    spectrum_to_xyz,
    spectrum_weights,
    white_xyz,
)
from brdf_suite.appearance.difference.formulas import delta_e_76, delta_e_2000
from brdf_suite.appearance.light.colour import adapt_colour, colour_from_spectra, metamerism_index
from brdf_suite.errors import ValueRangeError

BANDS = DEFAULT_WAVELENGTHS_NM


def edge(at: float, low: float = 0.05, high: float = 0.7) -> np.ndarray:
    return low + (high - low) / (1.0 + np.exp(-(BANDS - at) / 15.0))


def test_adaptation_agrees_with_another_program(colour: ModuleType) -> None:
    rng = np.random.default_rng(31)
    lab = rng.uniform([0.0, -80.0, -80.0], [130.0, 80.0, 80.0], (10_000, 3))
    for light in ("A", "F11"):
        white = white_xyz(light, 10)
        source = colour.Lab_to_XYZ(lab, WHITE_D65_10[:2] / WHITE_D65_10.sum())
        expected = colour.chromatic_adaptation(
            source, WHITE_D65_10 / 100.0, white / 100.0, method="Von Kries", transform="CAT16"
        )
        seen = adapt_colour(lab, light)
        np.testing.assert_allclose(seen.xyz, 100.0 * expected, atol=1e-6)
        assert "adapted from D65" in seen.label
        assert light in seen.label
    assert adapt_colour(lab, "D65").road == "measured"
    np.testing.assert_array_equal(adapt_colour(lab, "D65").lab, lab)


def test_white_stays_white_and_a_spectrum_says_more() -> None:
    np.testing.assert_allclose(adapt_colour([100.0, 0.0, 0.0], "A").lab, [100, 0, 0], atol=1e-9)
    np.testing.assert_allclose(colour_from_spectra(np.ones(31), BANDS, "A").lab, [100, 0, 0], atol=1e-9)
    red = edge(600.0)
    seen = colour_from_spectra(red, BANDS, "A")
    assert "recomputed" in seen.label
    guessed = adapt_colour(spectrum_to_lab(red), "A")
    # A red is lighter under a reddish lamp; adaptation alone cannot know by how much.
    assert seen.lab[0] > spectrum_to_lab(red)[0] + 2.0
    assert delta_e_2000(seen.lab, guessed.lab) > 1.0


@pytest.fixture(scope="module")
def metamers() -> tuple[np.ndarray, np.ndarray]:
    """A reddish grey, and three bands that match it under D65 for the 10° observer."""
    first = 0.25 + 0.1 * edge(580.0)
    bells = np.exp(-(((BANDS - np.array([[450.0], [540.0], [610.0]])) / 25.0) ** 2))
    wanted = spectrum_to_xyz(first)
    found = least_squares(lambda c: spectrum_to_xyz(0.1 + c @ bells) - wanted, [0.2, 0.2, 0.2], xtol=1e-15)
    return first, 0.1 + found.x @ bells


def test_metamers_part_under_another_light(metamers: tuple) -> None:
    first, second = metamers
    assert delta_e_76(spectrum_to_lab(first), spectrum_to_lab(second)) < 1e-5
    for light in ("A", "F11"):
        index = float(metamerism_index(first, second, BANDS, light))
        # They match under D65, so the index is their plain difference under the test light.
        plain = delta_e_76(
            spectrum_to_lab(first, illuminant=light), spectrum_to_lab(second, illuminant=light)
        )
        assert index == pytest.approx(float(plain), abs=1e-4)
        assert index > 1.0
    assert float(metamerism_index(first, second, BANDS, "D65")) == pytest.approx(0.0, abs=1e-9)
    assert float(metamerism_index(first, first, BANDS)) == 0.0
    other = float(metamerism_index(first, second, BANDS, difference=delta_e_2000))
    assert other != pytest.approx(float(metamerism_index(first, second, BANDS)))


def test_a_mismatch_is_taken_out_by_ratios(metamers: tuple) -> None:
    """By hand: twice the reflectance is no metamerism, and a mismatched pair is corrected per tristimulus value."""
    first, second = metamers
    assert float(metamerism_index(first, 2.0 * first, BANDS)) == pytest.approx(0.0, abs=1e-9)
    lighter = second * 1.1
    assert float(metamerism_index(first, lighter, BANDS)) == pytest.approx(
        float(metamerism_index(first, second, BANDS)), abs=1e-5
    )
    ratio = spectrum_to_xyz(first) / spectrum_to_xyz(edge(520.0))
    corrected = edge(520.0) @ spectrum_weights(BANDS, "A") * ratio
    white = white_xyz("A")
    root = np.cbrt(np.stack((corrected, first @ spectrum_weights(BANDS, "A"))) / white)
    d = root[0] - root[1]
    by_hand = np.sqrt((116 * d[1]) ** 2 + (500 * (d[0] - d[1])) ** 2 + (200 * (d[1] - d[2])) ** 2)
    assert float(metamerism_index(first, edge(520.0), BANDS)) == pytest.approx(by_hand)


def test_black_cannot_be_corrected() -> None:
    with pytest.raises(ValueRangeError, match="no light"):
        metamerism_index(edge(520.0), np.zeros(31), BANDS)
