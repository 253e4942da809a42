from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles import AngleGrid


@given(st.integers(3, 64), st.floats(0.4, 4.0), st.floats(0.005, 0.3))
def test_cosines_rise_to_one_and_one_is_45_degrees(count: int, power: float, lowest: float) -> None:
    grid = AngleGrid(count, power, lowest)
    assert grid.cosines.shape == (count,)
    assert (np.diff(grid.cosines) > 0.0).all()
    assert grid.cosines[[0, -1]] == pytest.approx([lowest, 1.0])
    assert grid.cosines[grid.measured] == np.cos(np.pi / 4)


@given(st.integers(3, 64), st.floats(0.4, 4.0))
@settings(max_examples=settings.default.max_examples // 2)
def test_texel_centres_are_the_grid(count: int, power: float) -> None:
    grid = AngleGrid(count, power)
    np.testing.assert_allclose(grid.coordinate(grid.cosines), (np.arange(count) + 0.5) / count, atol=1e-12)
    lower, share = grid.shares(grid.cosines)
    np.testing.assert_allclose(lower + share, np.arange(count), atol=1e-9)


def test_held_beyond_its_ends() -> None:
    grid = AngleGrid(8)
    assert grid.coordinate([-1.0, 0.0, 2.0]) == pytest.approx([0.5 / 8, 0.5 / 8, 7.5 / 8])


def test_denser_towards_grazing_with_a_larger_power() -> None:
    low, high = AngleGrid(16, 1.0), AngleGrid(16, 2.5)
    assert (high.cosines < 0.3).sum() > (low.cosines < 0.3).sum()


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ((2,), "at least 3 angles"),
        ((257,), "at most 256, not 257"),
        ((3000,), "at most 256, not 3000"),
        ((16, 0.0), "power"),
        ((16, float("nan")), "power"),
        ((16, 1.5, 0.0), "smallest cosine"),
        ((16, 1.5, 0.8), "smallest cosine"),
    ],
)
def test_refusals(values: tuple[float, ...], words: str) -> None:
    with pytest.raises(FittingError, match=words):
        AngleGrid(*values)  # type: ignore[arg-type]  # the test's own mixture of types
