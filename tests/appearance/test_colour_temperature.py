"""Colour temperature to colour: the standard illuminants, and no jump where the loci meet."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.light.matrix import daylight_xyz, lamp_colour, planck_xyz
from brdf_suite.errors import ValueRangeError


def chromaticity(xyz: np.ndarray) -> np.ndarray:
    return xyz[:2] / xyz.sum()


def test_standard_illuminants_are_met() -> None:
    # CIE 15: A is Planck's radiator at 2,856 K; D50, D65 and D75 with their correlated colour temperatures.
    np.testing.assert_allclose(chromaticity(planck_xyz(2855.5)), [0.44758, 0.40745], atol=1.5e-4)
    for kelvin, xy in (
        (5003.0, (0.34567, 0.35850)),
        (6504.0, (0.31272, 0.32903)),
        (7504.0, (0.29902, 0.31485)),
    ):
        np.testing.assert_allclose(chromaticity(daylight_xyz(kelvin)), xy, atol=2e-4)
    np.testing.assert_allclose(lamp_colour(6504.0), 1.0, atol=1e-3)


@given(st.floats(1500.0, 24000.0))
def test_a_lamp_grows_bluer_with_its_temperature_and_never_jumps(kelvin: float) -> None:
    colour, warmer = lamp_colour(kelvin), lamp_colour(kelvin * 1.002)
    assert colour @ LUMINANCE == pytest.approx(1.0, abs=1e-9)
    assert warmer[2] > colour[2]
    assert warmer[0] < colour[0]
    assert np.abs(warmer - colour).max() < 0.006


@pytest.mark.parametrize("kelvin", [999.0, 25001.0, float("nan")])
def test_what_is_no_colour_temperature_is_refused(kelvin: float) -> None:
    with pytest.raises(ValueRangeError, match="25,000 K"):
        lamp_colour(kelvin)
