"""Named geometries, travel and haze."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.clearcoat_gloss import gloss_units, haze_units
from brdf_suite.appearance.flop.travel import travel
from brdf_suite.appearance.geometries import (
    DEFAULT_SET,
    GEOMETRY_SETS,
    Geometry,
    GeometrySet,
    geometry_set,
    measured_set,
)
from brdf_suite.errors import ValueRangeError


def test_the_named_sets() -> None:
    names = {name: [geometry.name for geometry in entry.geometries] for name, entry in GEOMETRY_SETS.items()}
    assert names["e2194"] == ["45as15", "45as45", "45as110"]
    assert len(names["five"]) == 5
    assert names["six"] == ["45as-15", "45as15", "45as25", "45as45", "45as75", "45as110"]
    assert names["e2539"] == [*names["six"], "15as-15", "15as15"]
    assert DEFAULT_SET in names
    # ASTM writes the same by polar angles, light:view, views on the light's side positive: 45:-60 … 45:65, 15:0.
    views = [-geometry.view_deg for geometry in GEOMETRY_SETS["e2539"].geometries]
    assert views == [-60.0, -30.0, -20.0, 0.0, 30.0, 65.0, -30.0, 0.0]


def test_a_user_defines_a_set() -> None:
    own = geometry_set("45: -15, 15,110.5 ; 20:10")
    assert [(g.illumination_deg, g.aspecular_deg) for g in own.geometries] == [
        (45, -15), (45, 15), (45, 110.5), (20, 10),
    ]  # fmt: skip
    assert measured_set([(45.0, 15.0)]).geometries[0].view_deg == 30.0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("twelve", "e2194, five, six, e2539"),
        ("45:", "neither a named set"),
        ("45:15;", "neither a named set"),
        ("45:nan", "neither a named set"),
        ("45:140", "below the surface"),
        ("95:15", "polar angle from 0"),
        ("45:15,15", "named twice"),
        ("45:" + ",".join(str(i / 10) for i in range(101)), "1 to 100"),
    ],
)
def test_bad_sets_are_refused(text: str, words: str) -> None:
    with pytest.raises(ValueRangeError, match=words):
        geometry_set(text)


def test_values_are_checked() -> None:
    with pytest.raises(ValueRangeError, match="finite"):
        Geometry(45.0, float("nan"))
    with pytest.raises(ValueRangeError, match="1 to 100"):
        GeometrySet("none", "", ())


def test_travel_by_hand() -> None:
    readings = [[60.0, 30.0, 0.0], [40.0, 0.0, 30.0], [20.0, -10.0, 0.0]]
    result = travel([15.0, 45.0, 110.0], readings)
    assert result.length == pytest.approx(30.0 * np.sqrt(2.0) + np.hypot(10.0, 30.0))
    assert result.hue_deg == pytest.approx(180.0)
    assert (result.chroma, result.lightness) == (-20.0, -40.0)
    assert result.notice is None
    # Out and back: the path counts both ways, the turn cancels; beyond 15 to 110° nothing counts.
    there = travel([-15.0, 15.0, 45.0, 110.0], [[90.0, -80.0, 5.0], readings[0], readings[1], readings[0]])
    assert there.hue_deg == pytest.approx(0.0)
    assert there.hue_path_deg == pytest.approx(180.0)
    across = travel([15.0, 110.0], [[50.0, 20.0, -1.0], [50.0, 20.0, 1.0]])
    assert across.hue_deg == pytest.approx(2.0 * np.degrees(np.arctan2(1.0, 20.0)))
    assert "uncertain" in str(travel([15.0, 110.0], [[50.0, 0.5, 0.0], [20.0, 0.0, 0.5]]).notice)


@given(st.permutations([15.0, 25.0, 45.0, 75.0, 110.0]), st.integers(0, 1000))
def test_the_order_of_readings_does_not_matter(angles: list, seed: int) -> None:
    table = dict(
        zip((15.0, 25.0, 45.0, 75.0, 110.0), np.random.default_rng(seed).normal(0, 30, (5, 3)), strict=True)
    )
    expected = travel(list(table), np.array(list(table.values())))
    assert travel(angles, np.array([table[angle] for angle in angles])) == expected
    assert expected.hue_path_deg >= abs(expected.hue_deg) - 1e-9


def test_travel_needs_its_ends() -> None:
    for angles in ([15.0, 45.0], [25.0, 110.0], [45.0], []):
        with pytest.raises(ValueRangeError, match="15° and at 110°"):
            travel(angles, np.zeros((len(angles), 3)))


def test_haze_grows_with_a_rough_coat() -> None:
    values = [haze_units(gloss_units(20, 1.53, a), gloss_units(60, 1.53, a)) for a in (0.003, 0.005, 0.01)]
    # 94.1 - 89.6, 94.1 - 84.7 and 93.2 - 59.1 by the standards' apertures.
    np.testing.assert_allclose(values, [4.5, 9.4, 34.1], atol=0.15)
