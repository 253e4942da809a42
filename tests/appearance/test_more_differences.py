"""ΔE*ab, CMC(l:c) and CAM02-UCS against another program and by hand."""

from __future__ import annotations

import math
from types import ModuleType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import WHITE_D65_10, lab_to_xyz
from brdf_suite.appearance.difference.cam02ucs import (
    SURROUNDS,
    ViewingConditions,
    delta_e_cam02ucs,
    lab_to_cam02ucs,
    xyz_to_cam02ucs,
)
from brdf_suite.appearance.difference.formulas import delta_e_76, delta_e_cmc
from brdf_suite.errors import ValueRangeError

COUNT = 10_000


@pytest.fixture(scope="module")
def pairs() -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(23)
    low, high = np.array([0.0, -90.0, -90.0]), np.array([130.0, 90.0, 90.0])
    first, second = rng.uniform(low, high, (2, COUNT, 3))
    second[: COUNT // 2] = first[: COUNT // 2] + rng.normal(0.0, 1.0, (COUNT // 2, 3))
    return first, second


def test_delta_e_76_agrees_with_another_program(colour: ModuleType, pairs: tuple) -> None:
    np.testing.assert_allclose(delta_e_76(*pairs), colour.delta_E(*pairs, method="CIE 1976"), atol=1e-9)


@pytest.mark.parametrize(("lightness", "chroma"), [(2.0, 1.0), (1.0, 1.0), (1.4, 0.7)])
def test_cmc_agrees_with_another_program(
    colour: ModuleType, pairs: tuple, lightness: float, chroma: float
) -> None:
    expected = colour.delta_E(*pairs, method="CMC", l=lightness, c=chroma)
    np.testing.assert_allclose(delta_e_cmc(*pairs, lightness, chroma), expected, rtol=1e-7, atol=1e-9)


def test_cmc_by_hand() -> None:
    """A dark grey: S_L = .511, S_C = .638, f = 0, so S_H = S_C."""
    expected = math.sqrt((1.0 / (2 * 0.511)) ** 2 + (3.0 / 0.638) ** 2)
    assert float(delta_e_cmc([10.0, 0.0, 0.0], [11.0, 3.0, 0.0])) == pytest.approx(expected)
    # The weights are the reference's: the other way round another number comes out.
    assert float(delta_e_cmc([11.0, 3.0, 0.0], [10.0, 0.0, 0.0])) != pytest.approx(expected, rel=1e-3)
    with pytest.raises(ValueRangeError, match="positive weights"):
        delta_e_cmc([50, 0, 0], [50, 0, 0], 0.0, 1.0)


@pytest.mark.parametrize("surround", SURROUNDS)
def test_cam02ucs_agrees_with_another_program(colour: ModuleType, surround: str) -> None:
    # Inside the gamut of real colours, where both programs are defined.
    rng = np.random.default_rng(29)
    lab = np.concatenate(
        [
            rng.uniform([5.0, -30.0, -30.0], [130.0, 30.0, 30.0], (COUNT, 3)),
            rng.uniform([40.0, -60.0, -60.0], [100.0, 60.0, 60.0], (COUNT, 3)),
        ]
    )
    conditions = ViewingConditions(63.66, 20.0, surround)
    induction = colour.VIEWING_CONDITIONS_CIECAM02[surround.capitalize()]
    specification = colour.XYZ_to_CIECAM02(lab_to_xyz(lab), WHITE_D65_10, 63.66, 20.0, induction)
    jmh = np.stack((specification.J, specification.M, specification.h), axis=-1)
    expected = colour.models.JMh_CIECAM02_to_CAM02UCS(jmh)
    actual = lab_to_cam02ucs(lab, conditions)
    # The other program rounds the inverse of CAT02 nowhere, but its exponents' order differs: 1e-6 is rounding.
    np.testing.assert_allclose(actual, expected, atol=1e-5)
    distance = np.linalg.norm(expected[1:] - expected[:-1], axis=-1)
    np.testing.assert_allclose(delta_e_cam02ucs(lab[1:], lab[:-1], conditions), distance, atol=2e-5)


def test_the_published_example() -> None:
    """CIE 159 / Moroney et al. 2002: J = 41.73, M = .1088, h = 219.0 for the grey of their example."""
    ucs = xyz_to_cam02ucs([19.01, 20.00, 21.78], [95.05, 100.0, 108.88], ViewingConditions(318.31, 20.0))
    assert ucs[0] == pytest.approx(1.7 * 41.73109 / (1.0 + 0.007 * 41.73109), abs=1e-4)
    assert math.hypot(ucs[1], ucs[2]) == pytest.approx(math.log1p(0.0228 * 0.10884) / 0.0228, abs=1e-4)
    assert math.degrees(math.atan2(ucs[2], ucs[1])) % 360 == pytest.approx(219.048, abs=0.01)


def test_conditions_are_checked() -> None:
    for bad in ({"adapting_luminance": 0.0}, {"background": 0.0}, {"surround": "bright"}):
        with pytest.raises(ValueRangeError, match=next(iter(bad))):
            ViewingConditions(**bad)


labs = st.tuples(st.floats(0.0, 150.0), st.floats(-120.0, 120.0), st.floats(-120.0, 120.0))


@given(labs, labs)
def test_they_are_finite_and_zero_on_themselves(first: tuple, second: tuple) -> None:
    for difference in (delta_e_76, delta_e_cmc):
        assert np.isfinite(difference(first, second))
        assert float(difference(first, second)) >= 0.0
        assert float(difference(first, first)) == 0.0
    assert float(delta_e_cam02ucs(first, first)) == 0.0


def test_shapes_broadcast() -> None:
    for difference in (delta_e_76, delta_e_cmc, delta_e_cam02ucs):
        assert difference(np.ones((4, 1, 3)), np.ones((5, 3))).shape == (4, 5)
