"""Analysis and synthesis against scipy's spherical harmonics and each other."""

import numpy as np
import pytest
from scipy.special import sph_harm_y

from brdf_suite.errors import Cancelled
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.filter.harmonics import analyse, synthesise
from brdf_suite.lighting.filter.ring_to_cube import cube_from_rings, rings_for
from brdf_suite.lighting.latlong import angles, fejer_weights, ring_angles


def random_coefficients(bandlimit: int) -> np.ndarray:
    """Return coefficients (m, k, 2) of a real function; those of order 0 are real, those beyond the limit 0."""
    rng = np.random.default_rng(bandlimit)
    m, k = np.arange(bandlimit + 1)[:, None, None], np.arange(bandlimit + 1)[None, :, None]
    shape = (bandlimit + 1, bandlimit + 1, 2)
    return np.where(m + k <= bandlimit, rng.normal(size=shape) + 1j * rng.normal(size=shape) * (m > 0), 0.0)


def direct_sum(coefficients: np.ndarray, theta: np.ndarray, phi: np.ndarray) -> np.ndarray:
    total = np.zeros((*theta.shape, coefficients.shape[2]))
    bandlimit = coefficients.shape[0] - 1
    for m in range(bandlimit + 1):
        for k in range(bandlimit + 1 - m):
            # (-1)^m: scipy's functions carry the Condon-Shortley phase, ours do not.
            value = sph_harm_y(m + k, m, theta, phi) * (-1) ** m * (1 if m == 0 else 2)
            total += (value[..., None] * coefficients[m, k]).real
    return total


@pytest.mark.parametrize(("bandlimit", "rings"), [(5, 12), (40, 90), (40, 91), (300, 640)])
def test_analysis_undoes_synthesis(bandlimit: int, rings: int) -> None:
    coefficients = random_coefficients(bandlimit)
    cosines = np.cos(ring_angles(rings))
    orders = synthesise(coefficients, cosines)
    back = analyse(orders.transpose(1, 0, 2), fejer_weights(rings), cosines, bandlimit)
    assert np.abs(back - coefficients).max() < 1e-11


@pytest.mark.parametrize(("bandlimit", "size"), [(3, 2), (24, 32)])
def test_cube_holds_the_sum_of_harmonics(bandlimit: int, size: int) -> None:
    coefficients = random_coefficients(bandlimit)
    orders = synthesise(coefficients, np.cos(ring_angles(rings_for(bandlimit))))
    faces = cube_from_rings(orders, size)
    truth = direct_sum(coefficients, *angles(texel_directions(size)))
    assert np.abs(faces - truth).max() < 3e-7 * np.abs(truth).max()


def test_high_degrees_obey_the_addition_theorem_at_every_ring() -> None:
    """Σ_m |Y_lm|² = (2l+1)/4π for every direction, poles included, though single terms span 10^±300."""
    degree = 1000
    coefficients = np.zeros((degree + 1, degree + 1, 1), dtype=np.complex128)
    m = np.arange(degree + 1)
    coefficients[m, degree - m, 0] = 1.0
    orders = synthesise(coefficients, np.cos(ring_angles(300)))[:, :, 0].real
    total = orders[0] ** 2 + 2.0 * (orders[1:] ** 2).sum(axis=0)
    assert np.abs(total * 4.0 * np.pi / (2 * degree + 1) - 1.0).max() < 1e-10


def test_a_cancelled_transform_stops() -> None:
    def cancel(fraction: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        synthesise(random_coefficients(60), np.cos(ring_angles(128)), cancel)
