"""The response of a camera comes back from exposures alone, and with it the noise."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from brdf_suite.acquisition.response.fit import ResponseFit, calibrate_response
from brdf_suite.acquisition.response.response import linear_response, middle_code
from brdf_suite.acquisition.response.samples import ResponseSamples, spread
from brdf_suite.errors import AcquisitionError, Cancelled, ValueRangeError

TIMES = np.geomspace(0.00025, 0.328, 16)
FULL_WELL, READ = 20_000.0, 8.0
PIXELS = 30_000

CURVES: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "linear": lambda x: x,
    "gamma": lambda x: x ** (1.0 / 2.2),
    "film": lambda x: 1.25 * x**0.75 / (x**0.75 + 0.25),
    "steep": lambda x: 0.35 * x + 0.9 * x**0.6 - 0.25 * x**2,
}


@dataclass
class Camera:
    """Codes (16, 1, p, 1) of random radiances, and the exposure of each code at the gauge."""

    stack: np.ndarray
    truth: np.ndarray


def shoot(curve: str, bits: int = 12, black: int = 0, times: np.ndarray = TIMES, seed: int = 0) -> Camera:
    rng = np.random.default_rng(seed)
    radiance = np.exp(rng.uniform(np.log(0.02), np.log(3000.0), PIXELS))
    filling = np.minimum(times[:, None] * radiance, 3.0)
    electrons = rng.poisson(filling * FULL_WELL) + READ * rng.standard_normal(filling.shape)
    grid = np.linspace(0.0, 1.0, 100_001)
    values = CURVES[curve](grid) / CURVES[curve](np.ones(1))
    scale = 2**bits - 1 - black
    codes = np.rint(black + scale * np.interp(electrons / FULL_WELL, grid, values))
    truth = np.interp((np.arange(2**bits) - black) / scale, values, grid)
    kind = np.uint8 if bits == 8 else np.uint16
    return Camera(codes.astype(kind)[:, None, :, None], truth * 0.5 / truth[middle_code(bits)])


def recovered(camera: Camera, bits: int, black: float | None = 0.0, times: np.ndarray = TIMES) -> ResponseFit:
    samples = ResponseSamples(times, bits, 1)
    samples.add(camera.stack)
    return calibrate_response(samples, None if black is None else [black])


def rms(fit: ResponseFit, truth: np.ndarray, black: float = 0.0) -> float:
    """Return the RMS of the logarithm over the codes from 4 % to 98 % of the scale, gauge included."""
    scale = len(truth) - 1 - black
    codes = slice(int(black + 0.04 * scale), int(black + 0.98 * scale))
    return float(np.sqrt(np.mean(np.log(fit.response.exposure[0, codes] / truth[codes]) ** 2)))


@pytest.mark.parametrize("bits", [8, 12, 16])
@pytest.mark.parametrize("curve", ["gamma", "film", "steep"])
def test_the_curve_comes_back(curve: str, bits: int) -> None:
    camera = shoot(curve, bits)
    fit = recovered(camera, bits)
    assert rms(fit, camera.truth) < 0.01
    assert not fit.response.linear
    assert fit.response.exposure[0, middle_code(bits)] == pytest.approx(0.5)
    assert np.abs(fit.time_residuals).max() < 0.02


@pytest.mark.parametrize("count", [4, 6, 9])
def test_few_exposures_far_apart_leave_no_ripples(count: int) -> None:
    times = np.geomspace(0.002, 0.328, count)
    fit = recovered(shoot("film", times=times), 12, times=times)
    assert rms(fit, shoot("film", times=times).truth) < 0.015
    assert np.all(np.diff(fit.response.exposure[0, 40:4050]) > 0.0)


@pytest.mark.parametrize("black", [0, 64])
def test_a_linear_camera_is_reported_as_such_and_its_noise_measured(black: int) -> None:
    camera = shoot("linear", black=black)
    fit = recovered(camera, 12, float(black))
    assert fit.response.linear
    np.testing.assert_allclose(fit.response.exposure[0, 100:], camera.truth[100:], rtol=1e-6)
    unit = camera.truth[-1]  # the full well
    assert fit.response.shot[0] == pytest.approx(unit / FULL_WELL, rel=0.1)
    assert fit.response.read[0] == pytest.approx(unit * READ / FULL_WELL, rel=0.15)


def test_the_noise_of_a_known_curve_is_measured() -> None:
    camera = shoot("gamma")
    known = linear_response(12, 1)
    known = dataclasses.replace(known, exposure=camera.truth[None], linear=False)
    samples = ResponseSamples(TIMES, 12, 1)
    samples.add(camera.stack)
    fit = calibrate_response(samples, known=known)
    np.testing.assert_array_equal(fit.response.exposure, known.exposure)
    assert fit.response.shot[0] == pytest.approx(camera.truth[-1] / FULL_WELL, rel=0.1)
    assert fit.response.shot[0] != known.shot[0]


def test_photographs_that_contradict_a_known_curve_are_reported() -> None:
    samples = ResponseSamples(TIMES, 12, 1)
    samples.add(shoot("gamma").stack)
    with pytest.raises(AcquisitionError, match="not linear"):
        calibrate_response(samples, [0.0], linear=True)


def test_without_dark_frames_black_is_found_in_what_the_lamp_leaves_dark() -> None:
    camera = shoot("film", black=64)
    unlit = np.random.default_rng(5).normal(64.0, 1.5, (16, 1, 4000, 1))
    camera.stack = np.concatenate((camera.stack, np.rint(unlit).astype(np.uint16)), axis=2)
    fit = recovered(camera, 12, None)
    assert fit.response.black[0] == pytest.approx(64.0, abs=1.0)
    assert rms(fit, camera.truth, 64.0) < 0.015


def test_a_wrong_time_stands_out() -> None:
    camera = shoot("film")
    stated = TIMES.copy()
    stated[9] *= 1.25
    residuals = recovered(camera, 12, times=stated).time_residuals
    assert int(np.argmin(residuals)) == 9
    assert residuals[9] < -0.1


def test_full_scale_below_the_largest_code_is_found() -> None:
    camera = shoot("linear")
    camera.stack = np.minimum(camera.stack, 3700)
    samples = ResponseSamples(TIMES, 12, 1)
    samples.add(camera.stack)
    assert 3600 < samples.highest()[0] < 3700
    assert calibrate_response(samples, [0.0]).response.linear


def test_the_same_photographs_give_the_same_curve() -> None:
    camera = shoot("film")
    first, second = recovered(camera, 12), recovered(camera, 12)
    np.testing.assert_array_equal(first.response.exposure, second.response.exposure)


def test_the_curve_never_falls_and_covers_every_code() -> None:
    exposure = recovered(shoot("gamma", black=0), 12).response.exposure
    assert exposure.shape == (1, 4096)
    assert np.all(np.diff(exposure) >= 0.0)


def test_masked_pixels_take_no_part() -> None:
    camera = shoot("film")
    spoiled = camera.stack.copy()
    spoiled[:, :, ::2] = np.random.default_rng(1).integers(0, 4096, spoiled[:, :, ::2].shape)
    mask = np.ones((1, PIXELS), bool)
    mask[:, ::2] = False
    samples = ResponseSamples(TIMES, 12, 1)
    samples.add(spoiled, mask)
    assert rms(calibrate_response(samples, [0.0]), camera.truth) < 0.01


def test_too_few_pixels_are_reported() -> None:
    samples = ResponseSamples(TIMES, 12, 1)
    samples.add(np.full((16, 4, 4, 1), 4095, np.uint16))
    with pytest.raises(AcquisitionError, match="neither black nor clipped"):
        calibrate_response(samples, [0.0])


def test_a_code_beyond_the_bits_is_reported() -> None:
    with pytest.raises(AcquisitionError, match=r"5000.*12 bits"):
        ResponseSamples(TIMES, 12, 1).add(np.full((16, 4, 4, 1), 5000, np.uint16))


@pytest.mark.parametrize("times", [[0.1], [0.2, 0.1], [0.0, 0.1]], ids=["one", "falling", "zero"])
def test_times_that_are_no_series_are_refused(times: list[float]) -> None:
    with pytest.raises(ValueRangeError, match="exposures_s"):
        ResponseSamples(times, 12, 1)


def test_photographs_that_do_not_fit_are_refused() -> None:
    samples = ResponseSamples(TIMES, 12, 1)
    with pytest.raises(ValueRangeError, match="stack"):
        samples.add(np.zeros((15, 4, 4, 1), np.uint16))
    with pytest.raises(ValueRangeError, match="float32"):
        samples.add(np.zeros((16, 4, 4, 1), np.float32))  # type: ignore[arg-type] # refused at run time


def test_the_fit_can_be_cancelled() -> None:
    samples = ResponseSamples(TIMES, 12, 1)
    samples.add(shoot("film").stack)

    def stop(fraction: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        calibrate_response(samples, [0.0], progress=stop)


def test_positions_are_spread_over_the_arc() -> None:
    assert spread(180, 4) == [0, 60, 119, 179]
    assert spread([3, 5, 9], 8) == [3, 5, 9]
