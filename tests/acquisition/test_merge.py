"""Radiances merged from exposures are unbiased, their variances true, and what is clipped is reported."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.acquisition.radiance.merge import CLIPPED, DARK, GOOD, OUTSIDE, MergedRadiance, merge
from brdf_suite.acquisition.radiance.sensor_maps import dark_model, flat_field
from brdf_suite.acquisition.response.response import Response, linear_response
from brdf_suite.errors import ValueRangeError

TIMES = np.geomspace(0.00025, 0.328, 16)
READ, SHOT = 5e-4, 5e-5
BLACK = 64.0
SHAPE = (40, 60, 3)


def shoot(radiance: np.ndarray, seed: int = 0, dark_rate: np.ndarray | float = 0.0) -> np.ndarray:
    """Return (16, h, w, 3) codes of 12 bits of a linear camera."""
    rng = np.random.default_rng(seed)
    exposure = TIMES[:, None, None, None] * (radiance + dark_rate)
    noise = np.sqrt(READ**2 + SHOT * np.minimum(exposure, 2.0)) * rng.standard_normal(exposure.shape)
    codes = BLACK + (exposure + noise) * (2048.0 - BLACK) / 0.5
    return np.clip(np.rint(codes), 0, 4095).astype(np.uint16)


@dataclass
class Scene:
    radiance: np.ndarray
    stack: np.ndarray
    response: Response
    merged: MergedRadiance


@pytest.fixture(scope="module")
def scene() -> Scene:
    radiance = np.exp(np.random.default_rng(3).uniform(np.log(0.01), np.log(3000.0), SHAPE))
    stack = shoot(radiance)
    response = linear_response(12, 3, BLACK, READ, SHOT)
    return Scene(radiance, stack, response, merge(stack, TIMES, response))


def test_radiances_are_unbiased_and_their_variances_true(scene: Scene) -> None:
    apart = (scene.merged.radiance - scene.radiance) / np.sqrt(scene.merged.variance)
    assert np.all(scene.merged.state != CLIPPED)
    for low, high in ((0.01, 0.1), (0.1, 1.0), (1.0, 100.0), (100.0, 3000.0)):
        chosen = apart[(scene.radiance >= low) & (scene.radiance < high)]
        assert abs(chosen.mean()) < 4.5 / np.sqrt(len(chosen))
        assert chosen.std() == pytest.approx(1.0, abs=4.5 / np.sqrt(2.0 * len(chosen)))


def test_merging_is_better_than_any_single_exposure(scene: Scene) -> None:
    single = np.full(SHAPE, np.inf)
    for time in TIMES:
        known = (READ**2 + SHOT * time * scene.radiance) / time**2
        single = np.minimum(single, np.where(time * scene.radiance < 0.95, known, np.inf))
    share = scene.merged.variance / single
    assert np.median(share) < 0.75
    assert np.percentile(share, 95.0) < 1.1


def test_the_answer_does_not_depend_on_threads_or_the_part_of_the_picture(scene: Scene) -> None:
    again = merge(scene.stack, TIMES, scene.response, threads=1)
    np.testing.assert_array_equal(again.radiance, scene.merged.radiance)
    np.testing.assert_array_equal(again.time_ratios, scene.merged.time_ratios)
    part = merge(scene.stack[:, 5:33, 7:41], TIMES, scene.response)
    np.testing.assert_array_equal(part.radiance, scene.merged.radiance[5:33, 7:41])
    np.testing.assert_array_equal(part.variance, scene.merged.variance[5:33, 7:41])


def test_what_is_clipped_in_all_exposures_is_a_lower_bound_and_flagged(scene: Scene) -> None:
    radiance = np.full((4, 5, 3), 1.0)
    radiance[1, 2, 1] = 9000.0
    merged = merge(shoot(radiance), TIMES, scene.response)
    assert merged.state[1, 2, 1] == CLIPPED
    assert np.count_nonzero(merged.state == CLIPPED) == 1
    assert merged.saturated[1, 2]
    assert not merged.good[1, 2]
    assert 4000.0 < merged.radiance[1, 2, 1] < 9000.0


def test_black_is_flagged_and_averages_to_nothing(scene: Scene) -> None:
    merged = merge(shoot(np.zeros((40, 60, 3))), TIMES, scene.response)
    assert np.mean(merged.state == DARK) > 0.99
    assert np.all(merged.state != CLIPPED)
    deviation = np.sqrt(merged.variance.mean() / merged.radiance.size)
    assert abs(merged.radiance.mean()) < 4.5 * deviation
    assert merged.good.all()


def test_only_the_mask_is_merged(scene: Scene) -> None:
    mask = np.zeros(SHAPE[:2], bool)
    mask[3:9, 10:20] = True
    merged = merge(scene.stack, TIMES, scene.response, mask=mask)
    assert np.all((merged.state == OUTSIDE) == ~mask[..., None])
    np.testing.assert_array_equal(merged.radiance[mask], scene.merged.radiance[mask])
    assert np.all(merged.radiance[~mask] == 0.0)
    assert not merged.good[~mask].any()


def test_flat_field_and_dark_frame_are_taken_out(scene: Scene) -> None:
    y, x = np.mgrid[-1 : 1 : SHAPE[0] * 1j, -1 : 1 : SHAPE[1] * 1j]
    vignette = np.repeat((1.0 - 0.3 * (x * x + y * y))[..., None], 3, axis=2)
    current = np.where(x[..., None] > 0.0, 0.4, 0.1) * np.ones(3)
    dark = dark_model(shoot(np.zeros(SHAPE), 8, current), TIMES, scene.response)
    assert np.sqrt(np.mean((dark.rate - current) ** 2)) < 0.01
    screen = merge(shoot(30.0 * vignette, 9, current), TIMES, scene.response, dark=dark)
    flat = flat_field(screen)
    assert np.abs(flat / (vignette / vignette[SHAPE[0] // 2, SHAPE[1] // 2]) - 1.0).max() < 0.02
    scale = vignette[SHAPE[0] // 2, SHAPE[1] // 2, 0]
    merged = merge(shoot(scene.radiance * vignette, 10, current), TIMES, scene.response, dark=dark, flat=flat)
    bright = scene.radiance > 1.0
    assert np.median(np.abs(merged.radiance[bright] / scene.radiance[bright] / scale - 1.0)) < 0.006
    raw = merge(shoot(scene.radiance * vignette, 10, current), TIMES, scene.response)
    assert np.median(np.abs(raw.radiance[bright] / scene.radiance[bright] / scale - 1.0)) > 0.05


@settings(max_examples=settings.default.max_examples // 4)
@given(st.floats(0.05, 2000.0), st.integers(2, 16), st.sampled_from([8, 12, 16]))
def test_any_radiance_is_found_within_its_error(value: float, count: int, bits: int) -> None:
    times = TIMES[-count:]
    response = linear_response(bits)
    exposure = np.full((count, 3, 4, 2), value) * times[:, None, None, None]
    codes = np.clip(np.rint(exposure * 2.0**bits), 0, 2**bits - 1)
    response = linear_response(bits, 2, read=1e-6, shot=1e-9)
    merged = merge(codes.astype(np.uint8 if bits == 8 else np.uint16), times, response)
    if value * times[0] >= 0.985:
        assert np.all(merged.state == CLIPPED)
    elif merged.state[0, 0, 0] == GOOD:
        assert merged.radiance[0, 0, 0] == pytest.approx(value, abs=2.0 * 2.0**-bits / times[0], rel=0.02)
        assert abs(merged.radiance[0, 0, 0] - value) < 5.0 * np.sqrt(merged.variance[0, 0, 0])


def test_float_pictures_are_merged_as_they_are() -> None:
    radiance = np.random.default_rng(1).uniform(0.0, 5.0, (6, 7, 3)).astype(np.float32)
    merged = merge(radiance[None] * np.float32([0.5, 2.0])[:, None, None, None], [0.5, 2.0])
    np.testing.assert_allclose(merged.radiance, radiance, rtol=1e-5)
    assert np.all(merged.state == GOOD)


def test_a_float_that_is_no_number_is_named() -> None:
    stack = np.ones((2, 4, 5, 3), np.float32)
    stack[1, 2, 3, 0] = np.nan
    with pytest.raises(ValueRangeError, match="exposure 2 is not a number at column 3, row 2"):
        merge(stack, [0.1, 0.2])


@pytest.mark.parametrize(
    ("stack", "times", "named"),
    [
        (np.zeros((2, 3, 4), np.uint16), [0.1, 0.2], "stack"),
        (np.zeros((2, 3, 4, 3), np.uint16), [0.1], "stack"),
        (np.zeros((2, 3, 4, 1), np.uint16), [0.1, 0.2], "channels"),
        (np.full((2, 3, 4, 3), 4096, np.uint16), [0.1, 0.2], "12 bits"),
        (np.zeros((2, 3, 4, 3), np.int32), [0.1, 0.2], "int32"),
    ],
    ids=["axes", "times", "channels", "codes", "type"],
)
def test_what_does_not_fit_is_named(stack: np.ndarray, times: list[float], named: str) -> None:
    with pytest.raises(ValueRangeError, match=named):
        merge(stack, times, linear_response(12))
