"""Latitude-longitude conventions, quadrature and look-up."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.lighting.latlong import (
    angles,
    column_angles,
    direction,
    fejer_weights,
    ring_angles,
    sample,
)


def test_centre_looks_along_z_and_u_grows_to_minus_x() -> None:
    columns = column_angles(8)
    equator = np.array(np.pi / 2)
    centre = 0.5 * (direction(equator, columns[3]) + direction(equator, columns[4]))
    assert centre[2] > 0.9
    assert abs(centre[0]) < 1e-12
    assert direction(equator, columns[4])[0] < 0.0
    assert direction(ring_angles(16)[0], np.array(0.3))[1] > 0.99


@given(st.floats(1e-6, np.pi - 1e-6), st.floats(-3.14, 3.14))
def test_angles_invert_direction(theta: float, phi: float) -> None:
    back = angles(direction(np.array(theta), np.array(phi)) * 3.0)
    assert np.allclose(back, (theta, phi), atol=1e-9)


@pytest.mark.parametrize("rings", [4, 7, 32, 129])
def test_fejer_weights_integrate_polynomials_exactly(rings: int) -> None:
    x, weights = np.cos(ring_angles(rings)), fejer_weights(rings)
    assert weights.min() > 0.0
    for power in range(rings):
        exact = 2.0 / (power + 1) if power % 2 == 0 else 0.0
        assert abs(weights @ x**power - exact) < 1e-13


def test_sample_returns_the_texel_at_its_centre_and_is_even_across_seam_and_pole() -> None:
    rng = np.random.default_rng(3)
    pixels = rng.random((16, 32, 3)).astype(np.float32)
    theta, phi = np.meshgrid(ring_angles(16), column_angles(32), indexing="ij")
    assert np.allclose(sample(pixels, direction(theta, phi)), pixels, atol=1e-5)
    seam = sample(pixels, direction(ring_angles(16)[5], np.array([-np.pi, np.pi])))
    assert np.allclose(seam, 0.5 * (pixels[5, 0] + pixels[5, -1]), atol=1e-5)
    pole = sample(pixels, direction(np.array(1e-9), column_angles(32)[3]))
    assert np.allclose(pole, 0.5 * (pixels[0, 3] + pixels[0, 19]), atol=1e-5)
