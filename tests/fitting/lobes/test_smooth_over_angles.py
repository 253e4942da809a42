"""Weights at many angles: non-negative, the optimum, calm along the chain, and of few columns."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import nnls

from brdf_suite.fitting.lobes.smooth_over_angles import ColumnGroup, chained_weights


def system(rng: np.random.Generator, angles: int = 5, rows: int = 12, columns: int = 4):
    a = rng.random((angles, rows, columns))
    b = rng.random((angles, rows, 3)) - 0.3
    return a, b


def solved(a, b, **more):
    return chained_weights(
        np.einsum("nrk,nrl->nkl", a, a), np.einsum("nrk,nrc->nkc", a, b), (b**2).sum(axis=1), **more
    )


@pytest.mark.parametrize("alike", [1.0, 0.02])
@pytest.mark.parametrize("smoothness", [0.0, 0.01, 5.0])
@given(seed=st.integers(0, 2**32 - 1))
def test_it_is_the_optimum_of_non_negative_least_squares(smoothness: float, alike: float, seed: int) -> None:
    a, b = system(np.random.default_rng(seed), columns=6)
    a[..., 1:] = (1.0 - alike) * a[..., :1] + alike * a[..., 1:]  # columns that are nearly redundant
    found = solved(a, b, smoothness=smoothness)
    assert (found >= 0.0).all()
    # The same as one system: a block for each angle, and a row for each difference, in columns of unit size.
    n, rows, k = a.shape
    size = np.sqrt((a**2).sum(axis=1).mean(axis=0))
    whole = np.zeros((n * rows + (n - 1) * k, n * k))
    for angle in range(n):
        whole[angle * rows : (angle + 1) * rows, angle * k : (angle + 1) * k] = a[angle] / size
    chain = np.diff(np.eye(n), axis=0)
    whole[n * rows :] = np.sqrt(smoothness) * np.kron(chain, np.eye(k))
    for c in range(3):
        wanted = np.concatenate((b[..., c].ravel(), np.zeros((n - 1) * k)))
        reached = np.linalg.norm(whole @ (found[..., c] * size).ravel() - wanted)
        assert reached <= nnls(whole, wanted)[1] * (1.0 + 1e-7)


def test_known_weights_come_back_whatever_the_columns_size() -> None:
    rng = np.random.default_rng(4)
    a, _ = system(rng)
    a *= [1.0, 1e-4, 1e3, 1.0]
    weights = rng.random((5, 4, 3)) / np.array([1.0, 1e-4, 1e3, 1.0])[:, None]
    found = solved(a, np.einsum("nrk,nkc->nrc", a, weights), smoothness=0.0)
    np.testing.assert_allclose(found, weights, rtol=1e-5)


def test_smoothness_calms() -> None:
    a, b = system(np.random.default_rng(5))
    rough, calm = (np.abs(np.diff(solved(a, b, smoothness=mu), axis=0)).sum() for mu in (0.0, 3.0))
    assert calm < 0.5 * rough


def test_what_says_the_same_is_dropped_and_what_matters_stays() -> None:
    rng = np.random.default_rng(6)
    a, _ = system(rng)
    a = np.concatenate((a, a[..., :1] + 1e-4 * rng.random(a[..., :1].shape)), axis=-1)
    weights = np.ones((5, 4, 3))
    b = np.einsum("nrk,nkc->nrc", a[..., :4], weights)
    found = solved(a, b, groups=[ColumnGroup((0, 1, 2, 3, 4), 5)])
    used = found.max(axis=(0, 2)) > 0.0
    assert used[1:4].all()
    assert used[0] != used[4]
    forced = solved(a, b, groups=[ColumnGroup((0, 1, 4), 1)])
    assert np.count_nonzero(forced.max(axis=(0, 2))[[0, 1, 4]]) == 1
    assert (forced.max(axis=(0, 2))[[2, 3]] > 0.0).all()


def test_a_column_of_zeros_and_one_angle_alone() -> None:
    a, b = system(np.random.default_rng(7), angles=1)
    a[..., 2] = 0.0
    found = solved(a, b)
    assert not found[:, 2].any()
    assert found.shape == (1, 4, 3)
    assert solved(a, np.zeros_like(b)) == pytest.approx(0.0)
