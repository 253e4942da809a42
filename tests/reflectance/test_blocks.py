"""Blocks on threads: every pair gets its own value, in its own place, and what fails is heard of."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.reflectance.blocks import in_blocks


@pytest.mark.parametrize("count", [0, 1, 10, 11, 95])
def test_each_pair_keeps_its_place(count: int) -> None:
    wi = np.arange(3.0 * count).reshape(count, 3)
    sizes = []

    def evaluate(light: np.ndarray, view: np.ndarray) -> np.ndarray:
        sizes.append(len(light))
        return light + 2.0 * view

    found = in_blocks(evaluate, wi, np.array([1.0, 2.0, 3.0]), block=10)
    np.testing.assert_array_equal(found, wi + np.array([2.0, 4.0, 6.0]))
    assert max(sizes) <= 10


def test_shapes_broadcast() -> None:
    found = in_blocks(lambda i, o: i * o, np.ones((4, 1, 3)), np.full((5, 3), 2.0), block=3)
    assert found.shape == (4, 5, 3)
    assert np.all(found == 2.0)


def test_a_failing_block_is_heard_of() -> None:
    def evaluate(light: np.ndarray, view: np.ndarray) -> np.ndarray:
        if light[0, 0] > 50.0:
            raise ValueError("the last block")
        return light

    with pytest.raises(ValueError, match="the last block"):
        in_blocks(evaluate, np.arange(300.0).reshape(100, 3), np.zeros(3), block=10)
