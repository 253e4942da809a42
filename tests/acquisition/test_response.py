"""A response holds its curve at the gauge, refuses what is none, and survives JSON."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.acquisition.response.response import (
    Response,
    default_highest,
    linear_response,
    middle_code,
    srgb_response,
)
from brdf_suite.errors import ValueRangeError


@settings(max_examples=settings.default.max_examples // 2)
@given(st.integers(8, 16), st.floats(0.0, 100.0), st.integers(1, 4))
def test_half_the_scale_is_half_the_exposure(bits: int, black: float, channels: int) -> None:
    response = linear_response(bits, channels, black)
    assert response.exposure.shape == (channels, 2**bits)
    np.testing.assert_allclose(response.exposure[:, middle_code(bits)], 0.5)
    codes = np.arange(2**bits)
    np.testing.assert_allclose(np.interp(black, codes, response.exposure[0]), 0.0, atol=1e-12)
    np.testing.assert_allclose(srgb_response(bits, channels).exposure[:, middle_code(bits)], 0.5)


def test_srgb_is_the_standard_curve() -> None:
    response = srgb_response(8)
    ratio = response.exposure[1, 200] / response.exposure[1, 20]
    assert ratio == pytest.approx(((200 / 255 + 0.055) / 1.055) ** 2.4 / ((20 / 255 + 0.055) / 1.055) ** 2.4)
    assert response.exposure[1, 5] / response.exposure[1, 10] == pytest.approx(0.5)


def test_rounding_is_a_twelfth_of_a_step_squared() -> None:
    np.testing.assert_allclose(linear_response(10).rounding_variance(), (1 / 1024) ** 2 / 12)


def test_a_margin_below_saturation_counts_as_clipped() -> None:
    assert default_highest(8) == 252
    assert default_highest(12, 3900) == 3861


def test_json_keeps_every_number() -> None:
    response = linear_response(9, 3, [3.25, 4.0, 5.5], [1e-4, 2e-4, 3e-4], 7e-5)
    again = Response.from_json(json.loads(json.dumps(response.to_json())))
    for name in ("exposure", "black", "lowest", "highest", "read", "shot"):
        np.testing.assert_array_equal(getattr(again, name), getattr(response, name))
    assert again.linear


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"bit_depth": "12"}, "response.bit_depth"),
        ({"exposure": [[1.0, 2.0]]}, "response.exposure"),
        ({"exposure": [[0.0] * 255 + [float("nan")]]}, "response.exposure"),
        ({"exposure": [[float(255 - i) for i in range(256)]]}, "response.exposure"),
        ({"black": [-1.0]}, "response.black"),
        ({"read": None}, "response.read"),
        ({"shot": [0.1, 0.1]}, "response.shot"),
        ({"highest": [256]}, "response.highest"),
    ],
    ids=["bits", "shape", "nan", "falling", "black", "none", "channels", "highest"],
)
def test_what_is_no_response_is_named(change: dict[str, object], place: str) -> None:
    values = {**linear_response(8, 1).to_json(), **change}
    with pytest.raises(ValueRangeError) as caught:
        Response.from_json(values)
    assert caught.value.place == place


def test_bits_beyond_16_are_refused() -> None:
    with pytest.raises(ValueRangeError, match="8 to 16"):
        linear_response(17)
