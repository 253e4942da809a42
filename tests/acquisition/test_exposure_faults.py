"""Photographs that do not fit their series are named, with the reason."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.acquisition.photographs.exposure_faults import (
    ExposureFault,
    exposure_faults,
    time_errors,
)
from brdf_suite.acquisition.radiance.merge import merge
from brdf_suite.acquisition.response.response import linear_response
from brdf_suite.errors import FileError

TIMES = np.geomspace(0.00025, 0.328, 12)
NAMES = [f"000/{i:02d}.png" for i in range(12)]
RESPONSE = linear_response(12)


def shoot(times: np.ndarray = TIMES, top: float = 2000.0) -> np.ndarray:
    rng = np.random.default_rng(4)
    radiance = np.exp(rng.uniform(np.log(0.05), np.log(top), (40, 50, 3)))
    exposure = times[:, None, None, None] * radiance
    noise = np.sqrt(1e-7 + 5e-5 * np.minimum(exposure, 2.0)) * rng.standard_normal(exposure.shape)
    return np.clip(np.rint((exposure + noise) * 4096), 0, 4095).astype(np.uint16)


def faults_of(stack: np.ndarray, times: np.ndarray = TIMES) -> list[ExposureFault]:
    return exposure_faults(merge(stack, times, RESPONSE), times, NAMES)


def test_a_good_series_has_none() -> None:
    assert faults_of(shoot()) == []


@pytest.mark.parametrize(("a", "b"), [(3, 4), (0, 1), (10, 11), (2, 7)])
def test_exchanged_photographs_are_named_together(a: int, b: int) -> None:
    stack = shoot()
    stack[[a, b]] = stack[[b, a]]
    faults = faults_of(stack)
    named = " ".join(f"{fault.name} {fault.reason}" for fault in faults)
    assert all(fault.fatal for fault in faults)
    assert NAMES[a] in named
    assert NAMES[b] in named
    assert "exchanged" in named
    with pytest.raises(FileError, match="exchanged"):
        raise faults[0].error()


def test_a_wrong_time_is_named_with_the_true_one() -> None:
    shot = TIMES.copy()
    shot[5] *= 0.7
    faults = faults_of(shoot(shot))
    assert [fault.name for fault in faults] == [NAMES[5]]
    assert f"stated as {TIMES[5]:g} s" in faults[0].reason
    shown = float(faults[0].reason.split("about ")[1].split(" s")[0])
    assert shown == pytest.approx(shot[5], rel=0.05)


def test_an_exposure_clipped_everywhere_is_named_and_the_others_are_used() -> None:
    stack = shoot(top=100.0)
    stack[11] = 4095
    faults = faults_of(stack)
    assert [(fault.name, fault.fatal) for fault in faults] == [(NAMES[11], False)]
    assert "clipped everywhere" in faults[0].reason


def test_a_series_clipped_from_the_shortest_on_is_fatal() -> None:
    faults = faults_of(np.full((12, 8, 9, 3), 4095, np.uint16))
    assert faults[0] == ExposureFault(NAMES[0], faults[0].reason, True)


def test_a_series_without_light_is_fatal() -> None:
    faults = faults_of(np.zeros((12, 8, 9, 3), np.uint16))
    assert [fault.name for fault in faults] == [NAMES[11]]
    assert "shows no light" in faults[0].reason


def test_a_gap_in_what_is_seen_parts_the_series() -> None:
    ratios = np.log(TIMES[1:] / TIMES[:-1])
    ratios[2] += 0.3
    ratios[3] -= 0.3
    ratios[6] = np.nan
    errors = time_errors(ratios, TIMES)
    assert errors[3] == pytest.approx(0.3)
    np.testing.assert_allclose(np.delete(errors, 3), 0.0, atol=1e-12)
