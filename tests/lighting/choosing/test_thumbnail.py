"""The small picture of a light: upright, cropped, the same at any brightness."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.thumbnail import light_thumbnail


def light(scale: float = 1.0) -> Environment:
    radiance = np.full((60, 120, 3), 0.2, np.float32)
    radiance[:30] = (0.3, 0.5, 0.9)
    radiance[20, 70] = 5000.0
    return Environment("a sky", radiance * np.float32(scale))


@given(st.floats(1e-3, 1e3))
def test_the_picture_is_the_same_at_any_brightness(scale: float) -> None:
    difference = light_thumbnail(light(scale), 32).astype(int) - light_thumbnail(light(), 32)
    assert np.abs(difference).max() <= 1


@pytest.mark.parametrize("size", [8, 32, 128])
def test_the_sky_is_above_and_the_sun_white(size: int) -> None:
    codes = light_thumbnail(light(), size).astype(int)
    assert codes.shape == (size, size, 3)
    assert codes[0, 0, 2] > codes[0, 0, 0], "a blue sky above"
    assert np.ptp(codes[-1, 0]) <= 1, "a grey ground below"
    row, column = np.unravel_index(codes.min(axis=-1).argmax(), codes.shape[:2])
    assert codes[row, column].min() == 255
    assert row < size // 2 < column, "the sun is above the horizon, right of the middle"
