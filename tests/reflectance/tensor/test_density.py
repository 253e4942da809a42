"""Bilinear densities on the square: they integrate to 1, and the two directions of the warp are inverse."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import dblquad

from brdf_suite.reflectance.tensor.density import GridDensity, bilinear, blend_weights

SIZES = st.integers(2, 9)


def grids(seed: int, ny: int, nx: int, count: int = 3) -> np.ndarray:
    rng = np.random.default_rng(seed)
    values = rng.random((count, ny, nx)) + 0.01
    values[0, : ny // 2] *= 1e-3  # a steep one
    return values


@given(st.integers(0, 10_000), SIZES, SIZES)
def test_sampling_and_inverting_undo_each_other(seed: int, ny: int, nx: int) -> None:
    density = GridDensity(grids(seed, ny, nx))
    rng = np.random.default_rng(seed)
    u = rng.random((200, 2))
    blend = blend_weights([np.array([0.0, 0.3, 1.0])], [rng.uniform(-0.2, 1.2, 200)])
    place, at_place = density.sample(u, blend)
    assert ((place >= 0.0) & (place <= 1.0)).all()
    back, at_back = density.invert(place, blend)
    np.testing.assert_allclose(back, u, atol=1e-9)
    np.testing.assert_allclose(at_place, at_back, rtol=1e-6)
    np.testing.assert_allclose(at_place, density.density(place, blend), rtol=1e-6)


def test_a_blend_integrates_to_one_and_its_mass_is_that_of_the_samples() -> None:
    density = GridDensity(grids(3, 5, 4))
    axis = [np.array([0.0, 0.3, 1.0])]

    def value(x: float, y: float) -> float:
        return float(density.density(np.array([[x, y]]), blend_weights(axis, [np.array([0.7])]))[0])

    whole = sum(
        dblquad(lambda y, x: value(x, y), i / 3, (i + 1) / 3, j / 4, (j + 1) / 4)[0]
        for i in range(3)
        for j in range(4)
    )
    assert whole == pytest.approx(1.0, abs=1e-9)
    # The share of the samples in a corner is the integral over the corner.
    u = np.random.default_rng(0).random((200_000, 2))
    place, _ = density.sample(u, blend_weights(axis, [np.full(len(u), 0.7)]))
    corner = sum(
        dblquad(lambda y, x: value(x, y), i / 3, (i + 1) / 3, j / 4, (j + 1) / 4)[0]
        for i in range(2)
        for j in range(2)
    )
    share = ((place[:, 0] < 2 / 3) & (place[:, 1] < 0.5)).mean()
    assert abs(share - corner) < 5.0 * np.sqrt(corner * (1.0 - corner) / len(u))


def test_bilinear_by_hand() -> None:
    grid = np.array([[[0.0, 1.0], [2.0, 7.0]]])
    one = [(np.zeros(3, np.intp), np.ones(3))]
    found = bilinear(grid, np.array([[0.0, 0.0], [0.5, 0.5], [1.0, 1.0]]), one)
    np.testing.assert_allclose(found, [0.0, 2.5, 7.0])


def test_blends_hold_beyond_their_ends() -> None:
    axis = [np.array([1.0, 2.0, 4.0])]
    (low, at_low), (high, at_high) = blend_weights(axis, [np.array([0.0, 1.5, 3.0, 9.0])])
    np.testing.assert_array_equal(low, [0, 0, 1, 1])
    np.testing.assert_array_equal(high, [1, 1, 2, 2])
    np.testing.assert_allclose(at_low, [1.0, 0.5, 0.5, 0.0])
    np.testing.assert_allclose(at_high, [0.0, 0.5, 0.5, 1.0])
