"""Gloss units and the coat that gives them."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.clearcoat_gloss import (
    black_glass,
    gloss_units,
    nearest_coat,
    receptor_fraction,
)
from brdf_suite.errors import ValueRangeError


@pytest.mark.parametrize(("ior", "gu"), [(1.50, 82.0), (1.52, 87.3), (1.53, 90.0), (1.54, 92.7)])
def test_smooth_coats(ior: float, gu: float) -> None:
    assert gloss_units(20, ior, 0.0) == pytest.approx(gu, abs=0.06)


@pytest.mark.parametrize(
    ("roughness", "g20", "g60"),
    [(0.003, 90, 94), (0.005, 85, 94), (0.01, 59, 93), (0.02, 27, 77), (0.05, 6, 39)],
)
def test_rough_coats(roughness: float, g20: float, g60: float) -> None:
    assert gloss_units(20, 1.53, roughness) == pytest.approx(g20, abs=0.51)
    assert gloss_units(60, 1.53, roughness) == pytest.approx(g60, abs=0.51)


@pytest.mark.parametrize("angle", [20, 60])
@pytest.mark.parametrize("roughness", [0.005, 0.01, 0.02, 0.05])
def test_the_captured_share_agrees_with_traced_rays(angle: int, roughness: float) -> None:
    """Rays of a source of the standard's size, mirrored by Beckmann facets, counted in the receptor."""
    rng = np.random.default_rng(5)
    count = 400_000
    widths = {20: (1.8, 3.6), 60: (4.4, 11.7)}[angle]

    def share(alpha: float) -> float:
        polar = np.radians(angle + rng.uniform(-0.375, 0.375, count))
        side = np.radians(rng.uniform(-1.25, 1.25, count))
        light = np.stack((-np.sin(polar) * np.cos(side), np.sin(side), np.cos(polar) * np.cos(side)), axis=1)
        # A Beckmann surface has Gaussian slopes of variance α²/2 in each direction.
        slopes = rng.normal(0.0, alpha / np.sqrt(2.0), (count, 2))
        facet = np.column_stack((-slopes, np.ones(count)))
        facet /= np.linalg.norm(facet, axis=1, keepdims=True)
        cosine = np.sum(facet * light, axis=1)
        view = 2.0 * cosine[:, None] * facet - light
        out = np.degrees(np.arctan2(view[:, 0], view[:, 2])) - angle
        across = np.degrees(np.arcsin(np.clip(view[:, 1], -1.0, 1.0)))
        inside = (np.abs(out) <= widths[0] / 2) & (np.abs(across) <= widths[1] / 2)
        # Facets are seen by their projected area towards the light.
        weight = cosine / facet[:, 2]
        return float(np.sum(weight * inside) / np.sum(weight))

    assert share(0.0) == 1.0
    assert receptor_fraction(angle, roughness) == pytest.approx(share(roughness), abs=0.003)


@given(st.sampled_from([20, 60, 85]), st.floats(1e-6, 0.5), st.floats(1.0, 2.0))
def test_the_captured_share_falls_from_1_as_the_coat_grows_rougher(
    angle: int, roughness: float, factor: float
) -> None:
    assert receptor_fraction(angle, 0.0) == 1.0
    assert 0.0 < receptor_fraction(angle, factor * roughness) <= receptor_fraction(angle, roughness) + 1e-12
    assert receptor_fraction(angle, roughness) <= 1.0 + 1e-12


def test_black_glass_reads_100() -> None:
    for angle in (20, 60, 85):
        assert gloss_units(angle, 1.567, 0.0) == pytest.approx(100.0)
    assert black_glass(85) == pytest.approx(0.61915, abs=5e-6)
    with pytest.raises(ValueRangeError, match="20, 60 or 85"):
        gloss_units(45, 1.5, 0.0)


@given(st.floats(1.0, 118.0), st.floats(0.0, 8.0))
def test_one_reading_is_met_by_the_rule(gu_20: float, base: float) -> None:
    coat, refusal = nearest_coat(gu_20 + base, base_gu_20=base)
    assert refusal is None
    assert gloss_units(20, coat.ior, coat.roughness) == pytest.approx(gu_20, abs=1e-5)
    assert coat.ior == 1.5 or coat.roughness == 0.002


@given(st.floats(1.31, 1.69), st.floats(0.0021, 0.2))
def test_two_readings_give_the_coat_back(ior: float, roughness: float) -> None:
    """Of a rough coat the two receptors see nearly the same, so only its gloss is known, not its index."""
    readings = gloss_units(20, ior, roughness) + 3.0, gloss_units(60, ior, roughness) + 8.0
    coat, refusal = nearest_coat(*readings, 3.0, 8.0)
    assert refusal is None
    assert gloss_units(20, coat.ior, coat.roughness) == pytest.approx(
        gloss_units(20, ior, roughness), abs=1e-4
    )
    assert gloss_units(60, coat.ior, coat.roughness) == pytest.approx(
        gloss_units(60, ior, roughness), abs=0.5
    )
    if roughness < 0.02:
        assert coat.ior == pytest.approx(ior, abs=1e-4)
        assert coat.roughness == pytest.approx(roughness, rel=1e-3)


@pytest.mark.parametrize(
    ("readings", "words"),
    [
        ((170.0,), r"170 GU at 20° cannot be reached.* to 13\d\.\d GU"),
        ((3.0, None, 5.0), r"3 GU at 20° cannot be reached.*gives 5\.0 GU itself.*from 5\.\d"),
        ((90.0, 40.0), r"With 90 GU at 20°.*from 9\d\.\d to 1\d\d\.\d GU at 60°; 40 GU cannot"),
        ((20.0, 190.0), r"190 GU cannot be reached"),
        ((190.0, 90.0), r"190 GU at 20° cannot be reached"),
        ((2.0, 90.0, 5.0), r"2 GU at 20° cannot be reached"),
    ],
)
def test_what_cannot_be_reached_is_refused_by_name(readings: tuple, words: str) -> None:
    coat, refusal = nearest_coat(*readings)
    assert refusal is not None
    assert re.search(words, refusal)
    assert 1.3 <= coat.ior <= 1.7
    assert 0.002 <= coat.roughness <= 0.5


def test_a_smooth_coat_is_not_refused_for_half_a_unit() -> None:
    coat, refusal = nearest_coat(90.0, gloss_units(60, 1.531, 0.002) - 0.4)
    assert refusal is None
    assert coat.roughness == pytest.approx(0.002)
    assert gloss_units(20, coat.ior, coat.roughness) == pytest.approx(90.0, abs=1e-6)
