"""The matrix on the picture is the adaptation of single colours."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WHITE_D65_10, WORKING_TO_XYZ, lab_to_working
from brdf_suite.appearance.colour.spaces import adapt_xyz
from brdf_suite.appearance.colour.spectra import ILLUMINANTS, Illuminant
from brdf_suite.appearance.light.colour import adapt_colour
from brdf_suite.appearance.light.matrix import ILLUMINANT_OF, light_matrix
from brdf_suite.documents.view_settings import ILLUMINANTS as LAMPS


def test_every_lamp_of_a_view_has_an_illuminant() -> None:
    assert {"environment", *ILLUMINANT_OF} == set(LAMPS)
    assert set(ILLUMINANT_OF.values()) == set(ILLUMINANTS) == set(get_args(Illuminant))


@pytest.mark.parametrize("lamp", LAMPS)
def test_to_an_adapted_eye_nothing_changes(lamp: str) -> None:
    assert np.array_equal(light_matrix(lamp, adapted=True), np.eye(3))


@pytest.mark.parametrize("lamp", ILLUMINANT_OF)
def test_it_is_the_adaptation_of_colours(lamp: str) -> None:
    lab = np.random.default_rng(7).uniform([5.0, -60.0, -60.0], [100.0, 60.0, 60.0], (500, 3))
    seen = lab_to_working(lab) @ light_matrix(lamp, adapted=False).T
    white = 100.0 * WORKING_TO_XYZ.sum(axis=1)
    xyz_10 = adapt_xyz(100.0 * seen @ WORKING_TO_XYZ.T, white, WHITE_D65_10)
    expected = adapt_colour(lab, ILLUMINANT_OF[lamp]).xyz
    ratio = xyz_10 / expected
    assert np.ptp(ratio) < 2e-3 * ratio.mean()  # one factor, of the luminance that greys keep
    assert ratio.mean() == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("lamp", ILLUMINANT_OF)
def test_greys_keep_their_luminance(lamp: str) -> None:
    tint = light_matrix(lamp, adapted=False).sum(axis=1)
    assert LUMINANCE @ tint == pytest.approx(1.0)
    assert lamp == "D65" or tint[0] > tint[1] > tint[2]
