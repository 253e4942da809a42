"""LCh, XYZ, Display P3 and Bradford against another program and backwards."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import (
    WHITE_D65_10,
    WORKING_TO_XYZ,
    adaptation,
    in_srgb_gamut,
    lab_to_working,
    lab_to_xyz,
    srgb_encode,
    working_to_display,
)
from brdf_suite.appearance.colour.spaces import (
    DISPLAY_P3_SPACE,
    adapt_xyz,
    in_display_gamut,
    lab_to_lch,
    lch_to_lab,
    working_to_xyz,
    xyz_to_working,
)
from brdf_suite.errors import ValueRangeError


@pytest.fixture(scope="module")
def labs() -> np.ndarray:
    rng = np.random.default_rng(17)
    return rng.uniform([0.0, -90.0, -90.0], [140.0, 90.0, 90.0], (10_000, 3))


def test_lch_agrees_with_another_program(colour: ModuleType, labs: np.ndarray) -> None:
    np.testing.assert_allclose(lab_to_lch(labs), colour.models.Lab_to_LCHab(labs), atol=1e-9)
    np.testing.assert_allclose(lch_to_lab(lab_to_lch(labs)), labs, atol=1e-9)
    assert lab_to_lch([50.0, 0.0, 0.0]).tolist() == [50.0, 0.0, 0.0]
    assert 0.0 <= lab_to_lch([50.0, 10.0, -1e-16])[2] < 360.0


def test_xyz_and_p3_agree_with_another_program(colour: ModuleType, labs: np.ndarray) -> None:
    rho = lab_to_working(labs)
    wide = colour.RGB_COLOURSPACES["ITU-R BT.2020"]
    to_xyz = colour.normalised_primary_matrix(wide.primaries, wide.whitepoint)
    np.testing.assert_allclose(working_to_xyz(rho), 100.0 * rho @ to_xyz.T, atol=1e-6)
    np.testing.assert_allclose(xyz_to_working(working_to_xyz(rho)), rho, atol=1e-12)
    screen = colour.RGB_COLOURSPACES["Display P3"]
    to_p3 = np.linalg.inv(colour.normalised_primary_matrix(screen.primaries, screen.whitepoint)) @ to_xyz
    linear = rho @ to_p3.T
    expected = np.copysign(colour.models.eotf_inverse_sRGB(np.abs(linear)), linear)
    np.testing.assert_allclose(srgb_encode(DISPLAY_P3_SPACE.of_working(rho)), expected, atol=1e-6)


def test_bradford_agrees_with_another_program(colour: ModuleType, labs: np.ndarray) -> None:
    white = 100.0 * WORKING_TO_XYZ.sum(axis=1)
    for name in ("CAT16", "Bradford"):
        expected = colour.chromatic_adaptation(
            lab_to_xyz(labs) / 100.0, WHITE_D65_10 / 100.0, white / 100.0, method="Von Kries", transform=name
        )
        actual = adapt_xyz(lab_to_xyz(labs), WHITE_D65_10, white, name)
        np.testing.assert_allclose(actual, 100.0 * expected, atol=1e-6)
    with pytest.raises(ValueRangeError, match="CAT16, Bradford"):
        adaptation([95, 100, 108], [95, 100, 108], "von Kries")


def test_the_wider_display_shows_more(labs: np.ndarray) -> None:
    narrow, wide = in_display_gamut(labs), in_display_gamut(labs, "Display P3")
    np.testing.assert_array_equal(narrow, in_srgb_gamut(labs))
    assert np.all(wide[narrow])
    assert wide.sum() > 1.2 * narrow.sum()
    with pytest.raises(ValueRangeError, match="sRGB, Display P3"):
        in_display_gamut(labs, "Rec. 2020")
    # The red primary of Display P3 is no colour of sRGB, and the other way it is a paler one.
    red = np.array([1.0, 0.0, 0.0])
    assert working_to_display(xyz_to_working(100.0 * np.array([0.4866, 0.2290, 0.0]))).max() > 1.0
    wide_red = DISPLAY_P3_SPACE.of_working(xyz_to_working(100.0 * np.array([0.48657, 0.22897, 0.0])))
    np.testing.assert_allclose(srgb_encode(wide_red), red, atol=3e-3)


@given(st.floats(0.0, 250.0), st.floats(0.0, 250.0), st.floats(0.0, 359.999))
def test_any_lch_comes_back(lightness: float, chroma: float, hue: float) -> None:
    back = lab_to_lch(lch_to_lab([lightness, chroma, hue]))
    np.testing.assert_allclose(back[:2], [lightness, chroma], atol=1e-9)
    if chroma > 1e-6:
        assert abs((back[2] - hue + 180.0) % 360.0 - 180.0) < 1e-6


def test_shapes_are_kept() -> None:
    for function in (lab_to_lch, lch_to_lab, working_to_xyz, xyz_to_working):
        assert function(np.zeros((2, 0, 3))).shape == (2, 0, 3)
        assert np.isnan(function([np.nan, np.nan, np.nan])).any()
    assert in_display_gamut(np.zeros((4, 5, 3)), "Display P3").shape == (4, 5)
