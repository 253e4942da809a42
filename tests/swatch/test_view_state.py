"""The look is remembered between runs, and what is damaged of it is as it is at a first start, each for itself."""

from __future__ import annotations

import pytest
from brdf_color_swatch.view_state import Look
from brdf_qt.settings import settings

GOOD = Look("panel", 64, "overcast", True)


@pytest.mark.parametrize(
    ("key", "damaged"),
    [
        ("form", "foo"),
        ("form", ["panel"]),
        ("size", "abc"),
        ("size", 0),
        ("size", 10**9),
        ("size", True),
        ("booth", "nowhere"),
        ("booth", None),
        ("as_list", "perhaps"),
    ],
)
def test_what_is_damaged_falls_back_alone(key: str, damaged: object) -> None:
    found = Look.from_json({**GOOD.to_json(), key: damaged, "colour": "unknown"})
    assert found.to_json() == {**GOOD.to_json(), key: Look().to_json()[key]}


def test_a_program_begins_with_the_look_of_the_run_before(swatch) -> None:
    swatch.desk.set_look(**GOOD.to_json())
    swatch.desk.recall()
    assert swatch.desk.look == GOOD
    for key, damaged in (("form", "foo"), ("size", "abc"), ("booth", "nowhere")):
        settings().setValue(f"look/{key}", damaged)
    swatch.desk.recall()
    assert swatch.desk.look == Look(as_list=True)
