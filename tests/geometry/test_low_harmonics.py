from __future__ import annotations

import numpy as np
import pytest
from scipy.special import sph_harm_y

from brdf_suite.geometry.low_harmonics import low_harmonics, rotate_harmonics

DEGREE = 6


def directions(count: int = 300) -> np.ndarray:
    d = np.random.default_rng(3).normal(size=(count, 3))
    return d / np.linalg.norm(d, axis=1, keepdims=True)


def test_against_the_complex_harmonics() -> None:
    d = directions()
    theta, phi = np.arccos(d[:, 1]), np.arctan2(d[:, 0], d[:, 2])
    found = low_harmonics(d, DEGREE)
    for degree in range(DEGREE + 1):
        middle = degree * degree + degree
        np.testing.assert_allclose(found[:, middle], sph_harm_y(degree, 0, theta, phi).real, atol=1e-12)
        for order in range(1, degree + 1):
            # The Condon-Shortley phase is not ours.
            wanted = np.sqrt(2.0) * (-1.0) ** order * sph_harm_y(degree, order, theta, phi)
            np.testing.assert_allclose(found[:, middle + order], wanted.real, atol=1e-12)
            np.testing.assert_allclose(found[:, middle - order], wanted.imag, atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 0.7, -2.5])
def test_a_turned_function_has_at_the_turned_place_what_it_had(angle: float) -> None:
    coefficients = np.random.default_rng(5).normal(size=(DEGREE + 1) ** 2)
    d = directions(50)
    x, y, z = d.T
    moved = np.stack(
        [np.cos(angle) * x + np.sin(angle) * z, y, np.cos(angle) * z - np.sin(angle) * x], axis=1
    )
    before = low_harmonics(d, DEGREE) @ coefficients
    after = low_harmonics(moved, DEGREE) @ rotate_harmonics(coefficients, angle)
    np.testing.assert_allclose(after, before, atol=1e-12)


def test_angles_may_differ_from_function_to_function() -> None:
    coefficients = np.random.default_rng(6).normal(size=(4, (DEGREE + 1) ** 2))
    angles = np.array([0.1, 0.2, -3.0, 1.0])
    together = rotate_harmonics(coefficients, angles)
    for row, angle, one in zip(coefficients, angles, together, strict=True):
        np.testing.assert_allclose(one, rotate_harmonics(row, float(angle)), atol=1e-14)
