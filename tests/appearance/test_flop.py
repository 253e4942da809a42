"""The flop index."""

from __future__ import annotations

import math

import pytest

from brdf_suite.appearance.flop.travel import flop_index

# L* at 15, 45 and 110° of measured paints, and the index in the project's table of them.
PAINTS = [
    (108.6, 40.9, 8.7, 18.3),
    (101.9, 53.1, 33.4, 9.6),
    (61.8, 22.3, 4.6, 16.6),
    (87.8, 37.8, 13.6, 14.1),
    (75.2, 26.9, 9.9, 16.4),
    (68.2, 26.0, 17.0, 12.9),
    (43.4, 10.8, 2.3, 21.5),
    (84.5, 54.9, 48.1, 4.6),
]


@pytest.mark.parametrize(("l15", "l45", "l110", "expected"), PAINTS)
def test_the_table(l15: float, l45: float, l110: float, expected: float) -> None:
    found = flop_index(l15, l45, l110)
    # The table was computed before its L* were rounded to 0.1.
    assert found.value == pytest.approx(expected, abs=0.11)
    assert (found.notice is not None) == (l45 < 12.0)


def test_a_solid_colour_has_none() -> None:
    assert flop_index(50.0, 50.0, 50.0).value == 0.0
    assert flop_index(50.0, 50.0, 50.0).notice is None
    assert flop_index(0.0, 0.0, 0.0).value == 0.0


def test_where_it_means_little_it_says_so() -> None:
    assert flop_index(20.0, 25.0, 30.0).value == 0.0
    assert "lighter at 110°" in (flop_index(20.0, 25.0, 30.0).notice or "")
    assert "uncertain" in (flop_index(30.0, 11.9, 3.0).notice or "")
    black = flop_index(30.0, 0.0, 0.0)
    assert math.isnan(black.value)
    assert "no flop index" in (black.notice or "")
