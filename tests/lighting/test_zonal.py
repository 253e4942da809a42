"""The lobe's Legendre coefficients against quadrature."""

import numpy as np
import pytest

from brdf_suite.lighting.filter.harmonics import (
    largest_exponent,
    lobe_bandlimit,
    lobe_coefficients,
    lobe_tail,
)


@pytest.mark.parametrize("exponent", [0.7, 1.0, 2.0, 7.5, 160.0, 5000.0])
def test_coefficients_are_the_lobes_integrals(exponent: float) -> None:
    nodes, weights = np.polynomial.legendre.leggauss(600)
    x = 0.5 * (nodes + 1.0)
    # x = y^4 takes the root at 0 of a fractional exponent away.
    y, jacobian = x**4, 4.0 * x**3
    degrees = np.arange(60)
    legendre = np.polynomial.legendre.legvander(y, 59)
    integrals = (exponent + 1.0) * ((0.5 * weights * jacobian * y**exponent)[:, None] * legendre).sum(axis=0)
    assert np.abs(lobe_coefficients(exponent, 59)[degrees] - integrals).max() < 1e-10


def test_bandlimit_follows_the_square_root_and_is_bounded_below() -> None:
    assert lobe_bandlimit(20.0) == 32
    assert lobe_bandlimit(10000.0) == 600
    assert lobe_bandlimit(1.0) == 255  # a kink: its tail is long
    assert largest_exponent(430) == pytest.approx(10000.0)


@pytest.mark.parametrize("exponent", [20.0, 300.0, 4000.0])
def test_what_the_bandlimit_leaves_out_is_nothing(exponent: float) -> None:
    _, tail = lobe_tail(exponent, lobe_bandlimit(exponent))
    assert np.abs(tail).max() < 1e-6 * (exponent + 1.0) / (2.0 * np.pi)
