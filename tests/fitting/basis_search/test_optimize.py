"""One start to its optimum, on errors whose best exponents are known."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import Cancelled
from brdf_suite.fitting.basis_search.error import equation_4
from brdf_suite.fitting.basis_search.optimize import LARGEST_EXPONENT, optimize

WANTED = np.log([3.0, 40.0, 2_000.0])


def distances(exponents: AnyArray) -> AnyArray:
    """Six paints: each is as far off as its own lobe, and a floor."""
    away = np.log(exponents) - WANTED
    return np.concatenate((0.1 + np.abs(away), 0.05 + away**2))


def test_it_finds_the_exponents_and_says_what_they_are_worth() -> None:
    found = optimize(distances, (5.0, 20.0, 9_000.0))
    np.testing.assert_allclose(np.log(found.exponents), WANTED, atol=0.02)
    assert found.value == pytest.approx(equation_4(distances(np.array(found.exponents))), rel=1e-12)
    assert found.value < equation_4(distances(np.array((5.0, 20.0, 9_000.0))))
    again = optimize(distances, (20.0, 9_000.0, 5.0))
    assert (again.exponents, again.value) == (found.exponents, found.value)


def test_only_equation_4_decides() -> None:
    """Larger exponents lower the mean, and with it the 2-norm, but raise the maximum more: the start stays."""

    def traded(exponents: AnyArray) -> AnyArray:
        above = float(np.log(exponents[0] / 8.0))
        return np.array([3.0 + 2.0 * abs(above), *([2.5 - 0.9 * above] * 9)])

    assert (traded(np.array([10.0])) ** 2).sum() < (traded(np.array([8.0])) ** 2).sum()
    assert optimize(traded, (8.0,)).exponents == (8.0,)


def test_exponents_stay_inside_their_ends_and_apart() -> None:
    up = optimize(lambda e: 20.0 - np.log(e) + np.zeros(2), (50.0, 60.0)).exponents
    assert up[1] <= LARGEST_EXPONENT
    assert up[0] > 0.99 * LARGEST_EXPONENT
    assert up[1] > up[0] * 1.0005
    down = optimize(lambda e: 1.0 + np.log(e) + np.zeros(2), (50.0, 60.0)).exponents
    assert 1.0 <= down[0] < 1.01
    assert down[1] > down[0]


def test_a_watcher_can_end_it() -> None:
    seen = []

    def watch() -> None:
        seen.append(1)
        if len(seen) == 7:
            raise Cancelled

    with pytest.raises(Cancelled):
        optimize(distances, (5.0, 20.0, 9_000.0), watch)
    assert len(seen) == 7


def test_a_narrow_valley_across_the_axes_needs_its_slopes() -> None:
    """Steps along axes leave such a valley at every turn: tried without Levenberg-Marquardt, they end at .33."""
    turned = np.array([[1.0, 1.0, 1.0], [1.0, -1.0, 0.0], [1.0, 1.0, -2.0]]) / np.sqrt([[3.0], [2.0], [6.0]])
    across = np.array([[100.0], [1.0], [0.03]]) * turned

    def valley(exponents: AnyArray) -> AnyArray:
        return np.sqrt(0.01 + (across @ (np.log(exponents) - WANTED)) ** 2)

    assert optimize(valley, (10.0, 60.0, 9_000.0)).value < 0.21


def test_the_kink_of_the_maximum_needs_its_polish() -> None:
    """The 16-norm of these has its least value at 1.86; where maximum plus mean is least, one has an edge."""

    def edge(exponents: AnyArray) -> AnyArray:
        above = float(np.log(exponents[0] / 8.0))
        return np.array([max(1.0 + above, 0.0), *([max(0.9 - 0.2 * above, 0.0)] * 9)])

    assert optimize(edge, (20.0,)).value == pytest.approx(11.0 / 6.0, abs=0.003)
