"""Pictures as they come: from a real process that draws, from the disk, and where nothing can be drawn."""

from __future__ import annotations

import sys
from functools import cache

import numpy as np
import pytest
from brdf_color_swatch.pictures.pictures import Pictures

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.palettes.swatches.look import SwatchLook, swatch_key
from brdf_suite.palettes.swatches.store import SwatchStore

RED = Entry(solid_paint("Red", (50.0, 60.0, 40.0)), id="r")
BLUE = Entry(solid_paint("Blue", (30.0, 5.0, -40.0)), id="b")
PROCESS = (
    sys.executable,
    "-c",
    """
import base64, json, os, sys
for line in sys.stdin:
    request = json.loads(line)
    start = {"id": request["id"]}
    def say(**answer):
        print(json.dumps({**start, **answer}), flush=True)
    names = {item["key"]: item["paint"]["name"] for item in request["items"]}
    if request["look"]["environment"] == "nowhere":
        say(failed="no such light")
        continue
    if any(name.startswith("dies") for name in names.values()):
        os._exit(1)
    picture = base64.b64encode(bytes(3 * request["look"]["size"] ** 2)).decode()
    for key, name in names.items():
        if name == "faulty":
            say(key=key, refused="a fault", fault="Traceback of it")
        else:
            say(key=key, picture=picture)
    say(done=True)
""",
)
"""One that speaks as the drawing process does, and dies or fails as names and lights say."""


@cache
def some(name: str) -> Entry:
    """Return a paint of which no picture is on the disk."""
    return Entry(solid_paint(name, (50.0, sum(name.encode()) / 10.0, 3.0)), id=name)


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
    first.request([RED, BLUE])
    assert first.waiting == 2
    qtbot.waitUntil(lambda: first.waiting == 0 and heard == {"r", "b"})
    picture = first.picture(RED)
    assert (picture.width(), picture.height()) == (40, 40)
    middle = picture.toImage().pixelColor(20, 20)
    assert middle.red() > middle.blue() + 50
    assert not first.is_stale(RED)
    # The next run finds them: a command that does not exist would report that it cannot render.
    second = made("/nonexistent/program")
    second.request([RED, BLUE])
    qtbot.waitUntil(lambda: second.waiting == 0)
    assert second.problem == ""
    assert second.picture(BLUE) is not None


def test_a_new_size_scales_what_is_kept_and_an_old_picture_stays_meanwhile(made, qtbot) -> None:
    look = SwatchLook(form="flop_strip", environment="booth", size=48)
    store = SwatchStore()
    store.put({swatch_key(RED.content, look): np.full((48, 48, 3), 200, np.uint8)})
    store.close()
    pictures = made("/nonexistent/program")
    pictures.request([RED])
    qtbot.waitUntil(lambda: pictures.picture(RED) is not None)
    assert pictures.picture(RED).toImage().pixelColor(5, 5).red() == 200
    pictures.set_look("panel", "booth", 40, 1.0)
    assert pictures.picture(RED) is not None
    assert pictures.is_stale(RED)


def test_failure_to_render_is_reported_once(made, qtbot) -> None:
    pictures = made("/nonexistent/program")
    with qtbot.waitSignal(pictures.unavailable) as reported:
        pictures.request([RED])
    assert "cannot be rendered" in reported.args[0]
    assert pictures.waiting == 0
    assert not pictures.is_stale(RED)


def test_a_process_that_dies_over_everything_is_given_up(made, qtbot) -> None:
    pictures = made(sys.executable, "-c", "input()")
    with qtbot.waitSignal(pictures.unavailable) as reported:
        pictures.request([some(f"p{number}") for number in range(5)])
    assert "ended repeatedly" in reported.args[0]


def test_a_paint_over_which_the_process_dies_costs_no_other_its_picture(made, qtbot) -> None:
    pictures = made(*PROCESS)
    good, bad = [some(f"p{number}") for number in range(4)], [some("dies1"), some("dies2")]
    pictures.request([bad[0], *good[:2], bad[1], *good[2:]])
    qtbot.waitUntil(lambda: pictures.waiting == 0)
    assert pictures.problem == ""
    assert all(pictures.picture(entry) is not None for entry in good)
    assert all("ended while rendering this paint" in pictures.refusal(entry) for entry in bad)


def test_what_cannot_be_drawn_in_one_light_is_tried_in_another(made, qtbot) -> None:
    pictures = made(*PROCESS)
    pictures.set_look("flop_strip", "nowhere", 40, 1.0)
    with qtbot.waitSignal(pictures.unavailable) as reported:
        pictures.request([RED])
    assert reported.args[0] == "no such light"
    pictures.set_look("flop_strip", "nowhere", 64, 1.0)
    assert pictures.problem == "no such light"
    pictures.set_look("panel", "overcast", 40, 1.0)
    assert pictures.problem == ""
    # What was still to be said of the look before.
    for late in ("failed", "unavailable"):
        pictures.receive({"id": pictures.request_number - 1, late: "no such light"})
    assert pictures.problem == ""
    pictures.request([some("p")])
    qtbot.waitUntil(lambda: pictures.picture(some("p")) is not None)


def test_a_fault_of_the_process_is_in_the_log(made, qtbot, caplog) -> None:
    pictures = made(*PROCESS)
    odd = some("faulty")
    pictures.request([odd])
    qtbot.waitUntil(lambda: pictures.waiting == 0)
    assert pictures.refusal(odd) == "a fault"
    assert "Traceback of it" in caplog.text


def test_an_error_of_the_disk_is_in_the_log_and_pictures_are_drawn(made, qtbot, caplog, monkeypatch) -> None:
    def broken(*_: object) -> None:
        raise RuntimeError("a broken store")

    monkeypatch.setattr(SwatchStore, "get", broken)
    pictures = made(*PROCESS)
    pictures.request([some("p")])
    qtbot.waitUntil(lambda: pictures.picture(some("p")) is not None)
    assert "a broken store" in caplog.text
