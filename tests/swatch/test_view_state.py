"""The look: remembered between runs, what is damaged of it as at a first start, and messages about the previous one."""

from __future__ import annotations

import pytest
from brdf_color_swatch.grid.thumbnails import VisiblePictures
from brdf_color_swatch.grid.view_state import Look
from brdf_qt.program.settings import settings

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
    swatch.session.set_look(**GOOD.to_json())
    swatch.session.recall()
    assert swatch.session.look == GOOD
    for key, damaged in (("form", "foo"), ("size", "abc"), ("booth", "nowhere")):
        settings().setValue(f"look/{key}", damaged)
    swatch.session.recall()
    assert swatch.session.look == Look(as_list=True)


def test_a_rendering_failure_is_reported_until_another_form_is_shown(swatch, qtbot) -> None:
    part = swatch.feature(VisiblePictures)
    qtbot.waitUntil(lambda: part.is_started)
    part.pictures.give_up(part.look, "no driver")
    assert "pictures" in swatch.window.messages.shown()
    swatch.session.set_look(size=80)
    assert "pictures" in swatch.window.messages.shown()
    swatch.session.set_look(form="flop_strip")
    assert "pictures" not in swatch.window.messages.shown()
