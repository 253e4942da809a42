"""The two-dimensional example of Figure 2: what two factors can hold, and what the third adds."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError, ValueRangeError
from brdf_suite.fitting.homomorphic.factorization import accuracy
from tools.evaluation.picture_factors import factor_picture


def noise(size: int = 48, cells: int = 6, seed: int = 4) -> np.ndarray:
    """Perlin's gradient noise, two octaves, moved above 0."""
    rng = np.random.default_rng(seed)
    total = np.zeros((size, size))
    for octave in (1, 2):
        count = cells * octave
        turn = rng.uniform(0.0, 2.0 * np.pi, (count + 1, count + 1))
        slope = np.stack((np.cos(turn), np.sin(turn)), axis=-1)
        at = (np.arange(size) + 0.5) / size * count
        low, share = at.astype(int), at - at.astype(int)
        ease = share**3 * (share * (6.0 * share - 15.0) + 10.0)
        corners = {}
        for row in (0, 1):
            for column in (0, 1):
                g = slope[low[:, None] + row, low[None, :] + column]
                corners[row, column] = g[..., 0] * (share[None, :] - column) + g[..., 1] * (
                    share[:, None] - row
                )
        top = corners[0, 0] + ease[None, :] * (corners[0, 1] - corners[0, 0])
        foot = corners[1, 0] + ease[None, :] * (corners[1, 1] - corners[1, 0])
        total += (top + ease[:, None] * (foot - top)) / octave
    return 0.5 + 0.45 * total / np.abs(total).max()


def test_two_factors_are_separable_and_the_third_comes_nearer() -> None:
    picture = noise()
    two, _ = factor_picture(picture, ("x", "y"))
    three, factors = factor_picture(picture, ("x", "y", "x-y"))
    # A product of functions of x and y has rank 1; with one of x - y it has more.
    assert np.linalg.svd(two, compute_uv=False)[1] < 1e-6 * np.linalg.norm(two)
    assert np.linalg.svd(three, compute_uv=False)[1] > 1e-3 * np.linalg.norm(three)
    near = [accuracy(picture, found).snr_db for found in (np.full_like(picture, picture.mean()), two, three)]
    assert near[0] + 0.3 < near[1]
    assert near[1] + 0.3 < near[2]
    assert all((values > 0.0).all() and np.isfinite(values).all() for values in factors.values())


def test_two_factors_are_the_least_squares_of_the_logarithm() -> None:
    picture = noise(24)
    found, _ = factor_picture(picture, ("x", "y"), smooth=0.0, bias=1e-12)
    logs = np.log(picture)
    # Means of rows and columns are that solution in closed form.
    wanted = logs.mean(axis=0)[None, :] + logs.mean(axis=1)[:, None] - logs.mean()
    np.testing.assert_allclose(np.log(found), wanted, atol=1e-5)


def test_a_product_along_the_diagonal_is_found() -> None:
    at = (np.arange(20) + 0.5) / 20
    x, y = np.meshgrid(at, at)
    picture = np.exp(np.sin(5.0 * x) + y * y - 2.0 * (x - y) ** 2)
    found, _ = factor_picture(picture, ("x", "y", "x-y"), smooth=1e-3)
    np.testing.assert_allclose(found, picture, rtol=0.03)


def test_what_is_no_picture_is_refused() -> None:
    with pytest.raises(ValueRangeError, match="picture"):
        factor_picture(np.ones(5), ("x",))
    with pytest.raises(ValueRangeError, match="projections"):
        factor_picture(np.ones((4, 4)), ("z",))
    with pytest.raises(FittingError, match="0"):
        factor_picture(np.zeros((4, 4)), ("x", "y"))
