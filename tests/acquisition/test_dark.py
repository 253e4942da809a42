"""The dark frame holds current and offset of each pixel, and little of the noise of its photographs."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.acquisition.radiance.merge import merge
from brdf_suite.acquisition.radiance.sensor_maps import black_codes, dark_model, flat_field, shrunk
from brdf_suite.acquisition.response.response import linear_response
from brdf_suite.errors import AcquisitionError, ValueRangeError

TIMES = np.geomspace(0.00025, 0.328, 16)
BLACK = 64.0
RESPONSE = linear_response(12, 3, BLACK)
READ = 4e-4


def dark_stack(rate: np.ndarray, offset: np.ndarray | float = 0.0, seed: int = 2) -> np.ndarray:
    rng = np.random.default_rng(seed)
    exposure = TIMES[:, None, None, None] * rate + offset
    exposure = exposure + READ * rng.standard_normal(exposure.shape)
    return np.clip(np.rint(BLACK + exposure * 2.0 * (2048.0 - BLACK)), 0, 4095).astype(np.uint16)


def test_smooth_current_is_found_with_a_fraction_of_the_noise() -> None:
    x = np.linspace(0.0, 1.0, 60)
    rate = np.repeat((0.002 + 0.004 * x * np.ones((50, 1)))[..., None], 3, axis=2)
    dark = dark_model(dark_stack(rate), TIMES, RESPONSE)
    error = float(np.sqrt(np.mean((dark.rate - rate) ** 2)))
    single = READ / TIMES[-1]  # the longest photograph alone
    assert error < 0.25 * single
    assert not dark.hot.any()


def test_hot_pixels_keep_their_own_current_and_are_reported() -> None:
    rate = np.full((50, 60, 3), 0.002)
    rate[20, 30] = 0.5
    dark = dark_model(dark_stack(rate), TIMES, RESPONSE)
    assert np.argwhere(dark.hot).tolist() == [[20, 30]]
    np.testing.assert_allclose(dark.rate[20, 30], 0.5, rtol=0.03)
    assert abs(float(np.delete(dark.rate.reshape(-1, 3), 20 * 60 + 30, axis=0).mean()) - 0.002) < 2e-4


def test_a_pattern_of_offsets_is_found() -> None:
    offset = np.where(np.arange(60) % 2 == 0, 0.002, -0.002)[None, :, None] * np.ones((50, 1, 3))
    dark = dark_model(dark_stack(np.zeros((50, 60, 3)), offset), TIMES, RESPONSE)
    assert np.sqrt(np.mean((dark.offset - offset) ** 2)) < 0.5 * READ


def test_one_dark_photograph_is_an_offset() -> None:
    dark = dark_model(dark_stack(np.zeros((20, 30, 3)), 0.01)[:1], TIMES[:1], RESPONSE)
    assert np.all(dark.rate == 0.0)
    assert dark.offset.mean() == pytest.approx(0.01, rel=0.02)


def test_noise_that_is_cut_off_at_code_0_is_no_offset() -> None:
    rate = np.zeros((40, 50, 3))
    rate[7, 9] = 0.8
    stack = np.maximum(dark_stack(rate).astype(int) - 64, 0).astype(np.uint16)
    dark = dark_model(stack, TIMES, linear_response(12))
    assert np.all(dark.offset == 0.0)
    assert np.count_nonzero(dark.rate) == 3
    assert dark.rate[7, 9, 0] == pytest.approx(0.8, rel=0.1)


def test_a_part_is_cut_out() -> None:
    dark = dark_model(dark_stack(np.zeros((20, 30, 3))), TIMES, RESPONSE)
    part = dark.cropped(slice(2, 9), slice(4, 20))
    assert part.offset.shape == (7, 16, 3)
    np.testing.assert_array_equal(part.rate, dark.rate[2:9, 4:20])


def test_black_is_the_level_of_the_shortest_photograph() -> None:
    np.testing.assert_allclose(black_codes(dark_stack(np.zeros((40, 50, 3)))), BLACK, atol=0.2)
    cut_off = np.random.default_rng(0).normal(0.0, 3.0, (2, 40, 50, 3)).clip(0).astype(np.uint16)
    assert np.all(black_codes(cut_off) == 0.0)


def test_photographs_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueRangeError, match="dark"):
        dark_model(np.zeros((16, 4, 5, 1), np.uint16), TIMES, RESPONSE)


def test_noise_is_taken_out_by_its_share() -> None:
    rng = np.random.default_rng(0)
    pattern = 0.02 * rng.standard_normal((80, 90))
    noise = 0.03 * rng.standard_normal(pattern.shape)
    found, standing_out = shrunk(1.0 + pattern + noise, 0.03**2, 5.0)
    before, after = np.std(noise), np.std(found - 1.0 - pattern)
    assert after < 0.65 * before
    assert after == pytest.approx(0.02 * 0.03 / np.hypot(0.02, 0.03), rel=0.1)  # what Wiener's filter leaves
    assert standing_out.mean() < 1e-3


def test_a_flat_field_that_is_not_lit_is_refused() -> None:
    black = merge(dark_stack(np.zeros((20, 30, 3))), TIMES, RESPONSE)
    with pytest.raises(AcquisitionError, match="flat field is dark"):
        flat_field(black)
    clipped = merge(np.full((16, 20, 30, 3), 4095, np.uint16), TIMES, RESPONSE)
    with pytest.raises(AcquisitionError, match="clipped"):
        flat_field(clipped)
