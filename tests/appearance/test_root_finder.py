"""The root finder."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.clearcoat_gloss import bracketed_root


@settings(max_examples=2 * settings.default.max_examples)
@given(st.floats(-5.0, 5.0), st.floats(0.1, 30.0), st.booleans())
def test_it_finds_the_root_of_steep_and_flat_curves(root: float, steepness: float, falling: bool) -> None:
    sign = -1.0 if falling else 1.0
    found = bracketed_root(lambda x: sign * math.expm1(steepness * (x - root)), -6.0, 6.0, tolerance=1e-12)
    assert found == pytest.approx(root, abs=1e-10)


def test_it_needs_few_evaluations() -> None:
    calls = []

    def cubic(x: float) -> float:
        calls.append(x)
        return x**3 - 2.0

    assert bracketed_root(cubic, 0.0, 10.0) == pytest.approx(2.0 ** (1.0 / 3.0), abs=1e-12)
    assert len(calls) < 20


def test_ends_and_refusal() -> None:
    assert bracketed_root(lambda x: x, 0.0, 1.0) == 0.0
    assert bracketed_root(lambda x: x - 1.0, 0.0, 1.0) == 1.0
    assert bracketed_root(lambda x: -1.0 if x < 0.25 else 1.0, 0.0, 1.0) == pytest.approx(0.25, abs=1e-11)
    with pytest.raises(ValueError, match="no sign change"):
        bracketed_root(lambda x: x + 1.0, 0.0, 1.0)
