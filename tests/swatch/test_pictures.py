"""Pictures as they come: from a real process that draws, from the disk, and where nothing can be drawn."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from brdf_color_swatch.pictures import Pictures

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.pipeline.swatch_look import SwatchLook, swatch_key
from brdf_suite.pipeline.swatch_store import SwatchStore

RED = Entry(solid_paint("Red", (50.0, 60.0, 40.0)), id="r")
BLUE = Entry(solid_paint("Blue", (30.0, 5.0, -40.0)), id="b")


@pytest.fixture
def made(qapp):
    """Make pictures that are closed at the end."""
    found: list[Pictures] = []

    def make(*program: str) -> Pictures:
        found.append(Pictures(program=program or None))
        found[-1].set_look("flop_strip", "booth", 40, 1.0)
        return found[-1]

    yield make
    for pictures in found:
        pictures.close()


def test_a_process_draws_what_is_wanted_and_the_disk_keeps_it(made, qtbot) -> None:
    first = made()
    heard: set[str] = set()
    first.arrived.connect(heard.update)
    assert first.picture(RED) is None
    first.want([RED, BLUE])
    assert first.waiting == 2
    qtbot.waitUntil(lambda: first.waiting == 0 and heard == {"r", "b"})
    picture = first.picture(RED)
    assert (picture.width(), picture.height()) == (40, 40)
    middle = picture.toImage().pixelColor(20, 20)
    assert middle.red() > middle.blue() + 50
    assert not first.is_stale(RED)
    # The next run finds them: a process that is none would tell that it cannot draw.
    second = made("/nonexistent/program")
    second.want([RED, BLUE])
    qtbot.waitUntil(lambda: second.waiting == 0)
    assert second.problem == ""
    assert second.picture(BLUE) is not None


def test_a_new_size_scales_what_is_kept_and_an_old_picture_stays_meanwhile(made, qtbot) -> None:
    look = SwatchLook(form="flop_strip", environment="booth", size=48)
    store = SwatchStore()
    store.put({swatch_key(RED.content, look): np.full((48, 48, 3), 200, np.uint8)})
    store.close()
    pictures = made("/nonexistent/program")
    pictures.want([RED])
    qtbot.waitUntil(lambda: pictures.picture(RED) is not None)
    assert pictures.picture(RED).toImage().pixelColor(5, 5).red() == 200
    pictures.set_look("panel", "booth", 40, 1.0)
    assert pictures.picture(RED) is not None
    assert pictures.is_stale(RED)


def test_where_nothing_can_be_drawn_it_is_told_once(made, qtbot) -> None:
    pictures = made("/nonexistent/program")
    with qtbot.waitSignal(pictures.unavailable) as told:
        pictures.want([RED])
    assert "cannot be drawn" in told.args[0]
    assert pictures.waiting == 0
    assert not pictures.is_stale(RED)


def test_a_process_that_dies_twice_is_given_up(made, qtbot) -> None:
    pictures = made(sys.executable, "-c", "input()")
    with qtbot.waitSignal(pictures.unavailable) as told:
        pictures.want([RED])
    assert "ended twice" in told.args[0]
