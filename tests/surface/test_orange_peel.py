from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.surface.orange_peel import height_rms_um, peel_slopes


def test_the_slopes_have_a_mean_square_of_one_and_no_direction() -> None:
    slopes = peel_slopes(8, 128).astype(float)
    assert (slopes**2).sum(axis=-1).mean() == pytest.approx(1.0, rel=1e-5)
    assert np.abs(slopes.mean(axis=(0, 1))) == pytest.approx(0.0, abs=1e-6)
    along_u, along_v = (slopes**2).mean(axis=(0, 1))
    assert along_u == pytest.approx(along_v, rel=0.2)


def test_they_are_those_of_one_height_field() -> None:
    slopes = peel_slopes(8, 128).astype(float)
    number = np.fft.fftfreq(128, 1 / 128)
    u, v = np.fft.fft2(slopes[..., 0]), np.fft.fft2(slopes[..., 1])
    # dh/du and dh/dv of the same h: the curl is nothing.
    curl = number[:, None] * u - number[None, :] * v
    assert np.abs(curl).max() < 1e-3 * np.abs(number[:, None] * u).max()


def test_the_waves_are_as_long_as_they_are_said_to_be() -> None:
    waves, texels = 8, 128
    slopes = peel_slopes(waves, texels).astype(float)
    number = np.fft.fftfreq(texels, 1 / texels)
    power = (np.abs(np.fft.fft2(slopes, axes=(0, 1))) ** 2).sum(axis=-1)
    frequency = np.hypot(number[None, :], number[:, None])
    mean = np.exp((np.log(np.maximum(frequency, 1e-9)) * power).sum() / power.sum())
    assert mean == pytest.approx(waves, rel=0.12)
    inside = (frequency > waves / 2) & (frequency < waves * 2)
    assert power[inside].sum() > 0.99 * power.sum()


def test_the_tile_is_the_same_on_every_call_and_has_no_seam() -> None:
    one = peel_slopes(8, 128)
    assert np.array_equal(one, peel_slopes(8, 128))
    step = np.abs(np.diff(one, axis=1)).max()
    assert np.abs(one[:, 0] - one[:, -1]).max() <= step


def test_the_height_of_a_sine() -> None:
    # h = a sin(2 pi x / l): slope rms is a 2 pi / l / sqrt 2, height rms a / sqrt 2.
    slope = 2e-6 * 2 * np.pi / 4e-3
    assert height_rms_um(float(np.degrees(np.arctan(slope))), 4.0) == pytest.approx(2.0, rel=1e-6)
