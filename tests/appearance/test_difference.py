"""CIEDE2000 against the published test data and against another program."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.difference.formulas import delta_e_2000

# Sharma, Wu and Dalal 2005, Table 1.
SHARMA = [
    ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
    ((50.0, 3.1571, -77.2803), (50.0, 0.0, -82.7485), 2.8615),
    ((50.0, 2.8361, -74.0200), (50.0, 0.0, -82.7485), 3.4412),
    ((50.0, -1.3802, -84.2814), (50.0, 0.0, -82.7485), 1.0000),
    ((50.0, -1.1848, -84.8006), (50.0, 0.0, -82.7485), 1.0000),
    ((50.0, -0.9009, -85.5211), (50.0, 0.0, -82.7485), 1.0000),
    ((50.0, 0.0, 0.0), (50.0, -1.0, 2.0), 2.3669),
    ((50.0, -1.0, 2.0), (50.0, 0.0, 0.0), 2.3669),
    ((50.0, 2.4900, -0.0010), (50.0, -2.4900, 0.0009), 7.1792),
    ((50.0, 2.4900, -0.0010), (50.0, -2.4900, 0.0010), 7.1792),
    ((50.0, 2.4900, -0.0010), (50.0, -2.4900, 0.0011), 7.2195),
    ((50.0, 2.4900, -0.0010), (50.0, -2.4900, 0.0012), 7.2195),
    ((50.0, -0.0010, 2.4900), (50.0, 0.0009, -2.4900), 4.8045),
    ((50.0, -0.0010, 2.4900), (50.0, 0.0010, -2.4900), 4.8045),
    ((50.0, -0.0010, 2.4900), (50.0, 0.0011, -2.4900), 4.7461),
    ((50.0, 2.5, 0.0), (50.0, 0.0, -2.5), 4.3065),
    ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
    ((50.0, 2.5, 0.0), (61.0, -5.0, 29.0), 22.8977),
    ((50.0, 2.5, 0.0), (56.0, -27.0, -3.0), 31.9030),
    ((50.0, 2.5, 0.0), (58.0, 24.0, 15.0), 19.4535),
    ((50.0, 2.5, 0.0), (50.0, 3.1736, 0.5854), 1.0000),
    ((50.0, 2.5, 0.0), (50.0, 3.2972, 0.0), 1.0000),
    ((50.0, 2.5, 0.0), (50.0, 1.8634, 0.5757), 1.0000),
    ((50.0, 2.5, 0.0), (50.0, 3.2592, 0.3350), 1.0000),
    ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
    ((63.0109, -31.0961, -5.8663), (62.8187, -29.7946, -4.0864), 1.2630),
    ((61.2901, 3.7196, -5.3901), (61.4292, 2.2480, -4.9620), 1.8731),
    ((35.0831, -44.1164, 3.7933), (35.0232, -40.0716, 1.5901), 1.8645),
    ((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619), 2.0373),
    ((36.4612, 47.8580, 18.3852), (36.2715, 50.5065, 21.2231), 1.4146),
    ((90.8027, -2.0831, 1.4410), (91.1528, -1.6435, 0.0447), 1.4441),
    ((90.9257, -0.5406, -0.9208), (88.6381, -0.8985, -0.7239), 1.5381),
    ((6.7747, -0.2908, -2.4247), (5.8714, -0.0985, -2.2286), 0.6377),
    ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
]


@pytest.mark.parametrize(("first", "second", "expected"), SHARMA)
def test_the_published_pairs(first: tuple, second: tuple, expected: float) -> None:
    assert round(float(delta_e_2000(first, second)), 4) == expected


def test_it_agrees_with_another_program_on_random_values(colour: ModuleType) -> None:
    rng = np.random.default_rng(7)
    low, high = np.array([0.0, -90.0, -90.0]), np.array([130.0, 90.0, 90.0])
    first, second = rng.uniform(low, high, (10_000, 3)), rng.uniform(low, high, (10_000, 3))
    second[:5000] = first[:5000] + rng.normal(0.0, 1.0, (5000, 3))
    expected = colour.delta_E(first, second, method="CIE 2000")
    np.testing.assert_allclose(delta_e_2000(first, second), expected, atol=1e-9)


labs = st.tuples(st.floats(0.0, 150.0), st.floats(-120.0, 120.0), st.floats(-120.0, 120.0))


@given(labs, labs)
def test_it_is_symmetric_and_zero_on_itself(first: tuple, second: tuple) -> None:
    there, back = delta_e_2000(first, second), delta_e_2000(second, first)
    assert there >= 0.0
    # Where the hues are opposite the mean hue may be taken either way round; elsewhere it is symmetric.
    turn = np.arctan2(first[2], first[1]) - np.arctan2(second[2], second[1])
    if abs(abs(turn) - np.pi) > 1e-6:
        assert float(there) == pytest.approx(float(back), abs=1e-9)
    assert float(delta_e_2000(first, first)) == 0.0


def test_shapes_broadcast() -> None:
    assert delta_e_2000(np.zeros((4, 1, 3)), np.zeros((5, 3))).shape == (4, 5)
