"""The images' directions, their peaks, and how values become codes."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.geometry.directions import half_angle_coordinates, mirror
from brdf_suite.inspection.slices.cuts import light_at
from brdf_suite.inspection.slices.images import (
    colour_codes,
    half_angle_pairs,
    image_error,
    image_of,
    mapped_codes,
    place_of,
    share_of,
    share_of_theta_h,
    theta_h_at,
    unrolled_pairs,
    value_at,
    view_of,
)
from brdf_suite.reflectance.models.lambertian import Lambertian

SIZE = 32


class Spike:
    def eval(self, wi, wo):
        dot = np.einsum("...i,...i", mirror(wi), wo)
        return np.repeat((np.maximum(dot, 0.0) ** 1e5)[..., None], 3, axis=-1)


@pytest.mark.parametrize(
    ("theta", "phi"), [(10.0, 0.0), (40.0, 0.0), (70.0, 0.0), (40.0, 90.0), (55.0, -135.0)]
)
def test_the_peak_of_the_unrolled_hemisphere_is_at_the_mirror_direction(theta: float, phi: float) -> None:
    pairs = unrolled_pairs(theta, phi, SIZE)
    image = image_of(Spike(), pairs, cosine="none")
    row, column = np.unravel_index(np.argmax(image[..., 0]), (SIZE, SIZE))
    assert image[row, column, 0] == pytest.approx(1.0)
    assert (column, row) == place_of(mirror(light_at(theta, phi)), SIZE)
    # To the right for azimuth 0, up for 90°.
    right, up = column - (SIZE - 1) / 2.0, (SIZE - 1) / 2.0 - row
    along = np.cos(np.radians(phi)) * right + np.sin(np.radians(phi)) * up
    assert along > 0.0


def test_every_pixel_has_its_view() -> None:
    pairs = unrolled_pairs(40.0, 0.0, SIZE)
    for row, column in ((0, 0), (5, 20), (31, 31), (16, 3)):
        assert np.allclose(pairs.wo[row, column], view_of((column + 0.5) / SIZE, (row + 0.5) / SIZE))
        assert place_of(pairs.wo[row, column], SIZE) == (column, row)
    flat = image_of(Lambertian((0.5, 0.25, 0.75)), pairs, cosine="light")
    assert flat[3, 4] == pytest.approx(np.array([0.5, 0.25, 0.75]) / np.pi * np.cos(np.radians(40.0)))
    # Equal areas are equal solid angles: the mean of the views' cosine is a half.
    assert pairs.wo[..., 2].mean() == pytest.approx(0.5, abs=2e-3)


@pytest.mark.parametrize("by_root", [True, False])
def test_half_angle_images_have_their_angles(by_root: bool) -> None:
    pairs = half_angle_pairs(70.0, 15.0, SIZE, by_root=by_root)
    row, column = 10, 12
    theta_h, phi_h, theta_d, phi_d = half_angle_coordinates(pairs.wi[row, column], pairs.wo[row, column])
    share = (column + 0.5) / SIZE
    assert theta_h == pytest.approx(theta_h_at(share, by_root=by_root))
    assert share_of_theta_h(theta_h, by_root=by_root) == pytest.approx(share)
    assert np.degrees(theta_d) == pytest.approx(90.0 * (1.0 - (row + 0.5) / SIZE))
    assert (np.degrees(phi_h), np.degrees(phi_d)) == pytest.approx((15.0, 70.0))
    image = image_of(Spike(), pairs, cosine="none")
    assert image[:, 0, 0] == pytest.approx(1.0)
    assert np.isnan(image[0, -1]).all()  # grazing and tipped: one of the two is below the horizon


def test_errors_of_images() -> None:
    target = np.full((4, 4, 3), 2.0)
    fit = target.copy()
    fit[0, 0] = 4.0
    target[3, 3] = np.nan
    error = image_error(target, fit)
    assert error.rms == pytest.approx(np.sqrt(4.0 / 15.0))
    assert error.relative == pytest.approx(error.rms / 2.0)
    assert image_error(np.full((2, 2, 3), np.nan), np.zeros((2, 2, 3))) is None


def test_codes_of_a_screen() -> None:
    grey = np.array([[[0.0] * 3, [0.18] * 3, [1.0] * 3, [7.0] * 3, [np.nan] * 3]])
    assert colour_codes(grey, "gamma", 1.0)[0].tolist() == [[0] * 3, [118] * 3, [255] * 3, [255] * 3, [0] * 3]
    assert colour_codes(grey, "log", 10.0)[0, 2].tolist() == [191] * 3  # a decade of four below white
    for tone in ("gamma", "log"):
        places = np.array([0.25, 0.5, 1.0])
        assert share_of(value_at(places, tone, 3.0), tone, 3.0) == pytest.approx(places)
        assert np.isnan(share_of(np.nan, tone, 1.0))
        assert share_of(0.0, tone, 1.0) == 0.0
    table = np.arange(30, dtype=np.uint8).reshape(10, 3)
    assert mapped_codes(np.array([0.0, 1.0, np.nan]), table).tolist() == [[0, 1, 2], [27, 28, 29], [0, 1, 2]]
