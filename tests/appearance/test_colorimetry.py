"""Colorimetry against another program, the standards' numbers, and itself backwards."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import (
    LUMINANCE,
    REC709_PRIMARIES,
    REC709_TO_WORKING,
    WHITE_D65_10,
    WHITE_XY,
    WORKING_TO_SRGB,
    WORKING_TO_XYZ,
    adaptation,
    display_to_lab,
    in_srgb_gamut,
    lab_to_working,
    lab_to_xyz,
    rgb_to_working,
    srgb_decode,
    srgb_encode,
    working_to_display,
    working_to_lab,
    xyz_to_lab,
)

WHITE_10_XY = WHITE_D65_10[:2] / WHITE_D65_10.sum()


@pytest.fixture(scope="module")
def labs() -> np.ndarray:
    rng = np.random.default_rng(3)
    return rng.uniform([0.0, -90.0, -90.0], [140.0, 90.0, 90.0], (10_000, 3))


def test_xyz_agrees_with_another_program(colour: ModuleType, labs: np.ndarray) -> None:
    expected = 100.0 * colour.Lab_to_XYZ(labs, WHITE_10_XY)
    np.testing.assert_allclose(lab_to_xyz(labs), expected, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(xyz_to_lab(lab_to_xyz(labs)), labs, atol=1e-9)


def test_the_working_space_agrees_with_another_program(colour: ModuleType, labs: np.ndarray) -> None:
    space = colour.RGB_COLOURSPACES["ITU-R BT.2020"]
    white = colour.xy_to_XYZ(space.whitepoint)
    xyz = colour.Lab_to_XYZ(labs, WHITE_10_XY)
    adapted = colour.chromatic_adaptation(
        xyz, WHITE_D65_10 / 100.0, white, method="Von Kries", transform="CAT16"
    )
    # The other program prints its matrices to ten digits, and its whites with more.
    expected = adapted @ np.linalg.inv(colour.normalised_primary_matrix(space.primaries, space.whitepoint)).T
    np.testing.assert_allclose(lab_to_working(labs), expected, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(working_to_lab(lab_to_working(labs)), labs, atol=1e-8)


def test_matrices_are_those_of_the_standards() -> None:
    # ITU-R BT.2020 gives Y = 0.2627 R + 0.6780 G + 0.0593 B; IEC 61966-2-1 the sRGB matrix to four digits.
    np.testing.assert_allclose(LUMINANCE, [0.2627, 0.6780, 0.0593], atol=5e-5)
    srgb_to_xyz = WORKING_TO_XYZ @ REC709_TO_WORKING
    expected = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    np.testing.assert_allclose(srgb_to_xyz, expected, atol=6e-5)
    # ITU-R BT.2087, from Rec. 709 to Rec. 2020.
    bt2087 = [[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]]
    np.testing.assert_allclose(REC709_TO_WORKING, bt2087, atol=6e-5)
    np.testing.assert_allclose(WORKING_TO_SRGB @ REC709_TO_WORKING, np.eye(3), atol=1e-14)


def test_white_stays_white_on_every_road() -> None:
    np.testing.assert_allclose(lab_to_working([100.0, 0.0, 0.0]), [1, 1, 1], atol=1e-14)
    np.testing.assert_allclose(working_to_lab([1.0, 1.0, 1.0]), [100, 0, 0], atol=1e-12)
    np.testing.assert_allclose(working_to_display([1.0, 1.0, 1.0]), [1, 1, 1], atol=1e-14)
    np.testing.assert_allclose(display_to_lab([0.5, 0.5, 0.5])[1:], [0, 0], atol=1e-11)
    np.testing.assert_allclose(adaptation([95, 100, 108], [95, 100, 108]), np.eye(3), atol=1e-14)
    for white in (WHITE_XY, (0.3457, 0.3585), (0.31006, 0.31616)):
        matrix = rgb_to_working(REC709_PRIMARIES, white)
        np.testing.assert_allclose(matrix @ [1.0, 1.0, 1.0], [1, 1, 1], atol=1e-13)
    np.testing.assert_allclose(rgb_to_working(REC709_PRIMARIES, WHITE_XY), REC709_TO_WORKING, atol=1e-13)


def test_the_blue_that_made_the_space_wide() -> None:
    """L*a*b* 25, 4, -38 has R = -0.009 in Rec. 709 and is positive in the working space."""
    rho = lab_to_working([25.0, 4.0, -38.0])
    assert rho.min() > 0.0
    assert (WORKING_TO_SRGB @ rho)[0] == pytest.approx(-0.009, abs=5e-4)
    assert not in_srgb_gamut([25.0, 4.0, -38.0])
    assert working_to_display(rho)[0] < 0.0
    np.testing.assert_array_equal(
        in_srgb_gamut([[50.0, 0.0, 0.0], [100.0, 0.0, 0.0], [128.0, 0.0, 0.0]]), [True, True, False]
    )


def test_the_transfer_curve(colour: ModuleType) -> None:
    values = np.linspace(-2.0, 3.0, 1001)
    np.testing.assert_allclose(srgb_decode(srgb_encode(values)), values, atol=1e-12)
    inside = np.linspace(0.0, 1.0, 1001)
    np.testing.assert_allclose(srgb_encode(inside), colour.models.eotf_inverse_sRGB(inside), atol=1e-12)
    assert float(srgb_encode(0.18)) == pytest.approx(0.46135612950044164)


@given(st.tuples(st.floats(0.0, 250.0), st.floats(-250.0, 250.0), st.floats(-250.0, 250.0)))
def test_any_lab_comes_back(lab: tuple) -> None:
    np.testing.assert_allclose(working_to_lab(lab_to_working(lab)), lab, atol=1e-7)


def test_shapes_are_kept() -> None:
    assert lab_to_working(np.zeros((2, 0, 3))).shape == (2, 0, 3)
    assert in_srgb_gamut(np.zeros((4, 5, 3))).shape == (4, 5)
    assert np.isnan(lab_to_working([np.nan, 0.0, 0.0])).all()
