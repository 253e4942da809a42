"""Pictures as they come: from a real process that draws, from the disk, and where nothing can be drawn."""

from __future__ import annotations

import sys
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from brdf_qt.work.pictures import IDLE_MS, Pictures
from PySide6.QtCore import QTimer

from brdf_suite.documents.paint import Gloss, Paint, solid_paint
from brdf_suite.palettes.swatches.look import SwatchLook, swatch_key
from brdf_suite.palettes.swatches.store import SwatchStore

RED, BLUE = solid_paint("Red", (50.0, 60.0, 40.0)), solid_paint("Blue", (30.0, 5.0, -40.0))
STRIP = SwatchLook("flop_strip", size=48)
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
    paints = {item["key"]: item["paint"] for item in request["items"]}
    if request["look"]["environment"] == "nowhere":
        say(failed="no such light")
        continue
    if request["look"]["environment"] == "no_graphics":
        say(unavailable="No OpenGL 3.3 context could be made.")
        break
    if any(paint["name"].startswith("dies") for paint in paints.values()):
        os._exit(1)
    for key, paint in paints.items():
        level = round(2.5 * paint["measurements"][0]["lab"][0]) % 256
        if paint["name"] == "impossible":
            say(key=key, refused="No clearcoat gives this gloss.")
        elif paint["name"] == "faulty":
            say(key=key, refused="a fault", fault="Traceback of it")
        else:
            picture = base64.b64encode(bytes([level]) * (3 * request["look"]["size"] ** 2)).decode()
            say(key=key, picture=picture)
    say(done=True)
""",
)
"""One that speaks as the drawing process does, and dies or fails as names and lights say."""


@cache
def some(name: str, lightness: float = 50.0) -> Paint:
    """Return a paint of which no picture is on the disk."""
    return solid_paint(name, (lightness, sum(name.encode()) / 10.0, 3.0))


@pytest.fixture
def made(qapp):
    """Make pictures that are closed at the end."""
    found: list[Pictures] = []

    def make(*program: str) -> Pictures:
        found.append(Pictures(program=program or None))
        return found[-1]

    yield make
    for pictures in found:
        pictures.close()


def level(pictures: Pictures, paint: Paint, look: SwatchLook = STRIP) -> int:
    """Return the red of the middle of a picture."""
    image = pictures.picture(paint, look).toImage()
    return image.pixelColor(image.width() // 2, image.height() // 2).red()


def drawn(pictures: Pictures, *paints: Paint) -> bool:
    """Return whether these pictures are there."""
    return all(pictures.picture(paint, STRIP) is not None for paint in paints)


def test_a_process_draws_what_is_wanted_and_the_disk_keeps_it(made, qtbot) -> None:
    first = made()
    heard: set[str] = set()
    first.arrived.connect(heard.update)
    assert first.picture(RED, STRIP) is None
    first.request("view", [RED, BLUE], STRIP, 40)
    assert first.waiting == 2
    qtbot.waitUntil(lambda: first.waiting == 0 and heard == {first.key(one, STRIP) for one in (RED, BLUE)})
    picture = first.picture(RED, STRIP)
    assert (picture.width(), picture.height()) == (40, 40)
    middle = picture.toImage().pixelColor(20, 20)
    assert middle.red() > middle.blue() + 50
    assert first.is_settled(RED, STRIP)
    # The next run finds them: a command that does not exist would report that it cannot render.
    second = made("/nonexistent/program")
    second.request("view", [RED, BLUE], STRIP, 40)
    qtbot.waitUntil(lambda: second.waiting == 0)
    assert second.problem(STRIP) == ""
    assert second.picture(BLUE, STRIP) is not None


def test_a_new_size_scales_what_is_kept_and_an_old_picture_stays_meanwhile(made, qtbot) -> None:
    store = SwatchStore()
    store.put({swatch_key(RED, STRIP): np.full((48, 48, 3), 200, np.uint8)})
    store.close()
    pictures = made("/nonexistent/program")
    pictures.request("view", [RED], STRIP, 20, 2.0)
    qtbot.waitUntil(lambda: pictures.picture(RED, STRIP) is not None)
    picture = pictures.picture(RED, STRIP)
    assert (picture.width(), picture.devicePixelRatioF()) == (40, 2.0)
    assert picture.toImage().pixelColor(5, 5).red() == 200
    panel = SwatchLook("panel", size=48)
    assert pictures.latest(RED).cacheKey() == picture.cacheKey()
    assert pictures.picture(RED, panel) is None
    assert not pictures.is_settled(RED, panel)


def test_pictures_come_and_are_kept(made, qtbot) -> None:
    pictures = made(*PROCESS)
    paints = [some("one", 20.0), some("two", 40.0)]
    waiting: list[int] = []
    pictures.waiting_changed.connect(waiting.append)
    pictures.request("history", paints, STRIP)
    qtbot.waitUntil(lambda: drawn(pictures, *paints))
    assert [level(pictures, paint) for paint in paints] == [50, 100]
    qtbot.waitUntil(lambda: waiting[-1] == 0)
    assert waiting[0] == 2
    came: list[str] = []
    pictures.arrived.connect(came.extend)
    # The same paint under another name is not drawn again.
    pictures.request("history", [replace(paints[0], name="renamed"), some("three")], STRIP)
    qtbot.waitUntil(lambda: bool(came))
    assert came == [pictures.key(some("three"), STRIP)]


def test_the_newest_owner_goes_first_and_an_older_list_is_forgotten(made, qtbot) -> None:
    pictures = made(*PROCESS)
    came: list[str] = []
    pictures.arrived.connect(came.extend)
    pictures.request("variations", [some("a"), some("b")], STRIP)
    pictures.request("history", [some("c")], SwatchLook("panel", size=48))
    pictures.request("variations", [some("d")], STRIP)
    qtbot.waitUntil(lambda: len(came) == 2)
    assert not drawn(pictures, some("a"))
    assert not drawn(pictures, some("b"))
    assert set(came) == {
        pictures.key(some("d"), STRIP),
        pictures.key(some("c"), SwatchLook("panel", size=48)),
    }


def test_a_paint_that_cannot_be_is_refused_and_the_others_come(made, qtbot) -> None:
    pictures = made(*PROCESS)
    wrong = some("impossible")
    pictures.request("variations", [wrong, some("p")], STRIP)
    with qtbot.waitSignal(pictures.arrived) as reported:
        pass
    assert pictures.key(wrong, STRIP) in reported.args[0]
    assert pictures.refusal(wrong, STRIP) == "No clearcoat gives this gloss."
    assert pictures.is_settled(wrong, STRIP)
    qtbot.waitUntil(lambda: drawn(pictures, some("p")))


def test_failure_to_render_is_reported_once(made, qtbot) -> None:
    pictures = made("/nonexistent/program")
    with qtbot.waitSignal(pictures.unavailable) as reported:
        pictures.request("view", [some("p")], STRIP)
    assert reported.args[0] == STRIP
    assert "cannot be rendered" in reported.args[1]
    assert pictures.waiting == 0
    assert pictures.is_settled(some("p"), STRIP)


def test_without_graphics_it_is_reported_once(made, qtbot) -> None:
    pictures = made(*PROCESS)
    look = replace(STRIP, environment="no_graphics")
    reported: list[str] = []
    pictures.unavailable.connect(lambda _look, why: reported.append(why))
    pictures.request("history", [some("p")], look)
    qtbot.waitUntil(lambda: bool(reported))
    assert "OpenGL" in reported[0] == pictures.problem(look)
    pictures.request("history", [some("q")], look)
    pictures.request("variations", [some("q")], STRIP)
    qtbot.waitUntil(lambda: drawn(pictures, some("q")))
    assert len(reported) == 1


def test_a_process_that_dies_over_everything_is_given_up(made, qtbot) -> None:
    pictures = made(sys.executable, "-c", "input()")
    with qtbot.waitSignal(pictures.unavailable) as reported:
        pictures.request("view", [some(f"p{number}") for number in range(5)], STRIP)
    assert "ended repeatedly" in reported.args[1]


def test_a_paint_over_which_the_process_dies_costs_no_other_its_picture(made, qtbot) -> None:
    pictures = made(*PROCESS)
    good, bad = [some(f"p{number}") for number in range(4)], [some("dies1"), some("dies2")]
    pictures.request("view", [bad[0], *good[:2], bad[1], *good[2:]], STRIP)
    qtbot.waitUntil(lambda: pictures.waiting == 0)
    assert pictures.problem(STRIP) == ""
    assert drawn(pictures, *good)
    assert all("ended while rendering this paint" in pictures.refusal(paint, STRIP) for paint in bad)


def test_what_cannot_be_drawn_in_one_light_is_tried_in_another(made, qtbot) -> None:
    pictures = made(*PROCESS)
    nowhere, overcast = replace(STRIP, environment="nowhere"), SwatchLook("panel", "overcast", 48)
    with qtbot.waitSignal(pictures.unavailable) as reported:
        pictures.request("view", [RED], nowhere)
    assert reported.args[1] == "no such light"
    pictures.request("view", [RED], replace(nowhere, size=64))
    assert pictures.problem(replace(nowhere, size=64)) == "no such light"
    pictures.request("view", [some("p")], overcast)
    assert pictures.problem(overcast) == ""
    # What was still to be said of the look before.
    for late in ("failed", "unavailable"):
        pictures.receive({"id": pictures.request_number - 1, late: "no such light"})
    assert pictures.problem(overcast) == ""
    qtbot.waitUntil(lambda: pictures.picture(some("p"), overcast) is not None)
    # Shown again, the light is tried anew.
    with qtbot.waitSignal(pictures.unavailable):
        pictures.request("view", [RED], nowhere)


def test_a_fault_of_the_process_is_in_the_log(made, qtbot, caplog) -> None:
    pictures = made(*PROCESS)
    odd = some("faulty")
    pictures.request("view", [odd], STRIP)
    qtbot.waitUntil(lambda: pictures.waiting == 0)
    assert pictures.refusal(odd, STRIP) == "a fault"
    assert "Traceback of it" in caplog.text


def test_an_error_of_the_disk_is_in_the_log_and_pictures_are_drawn(made, qtbot, caplog, monkeypatch) -> None:
    def broken(*_: object) -> None:
        raise RuntimeError("a broken store")

    monkeypatch.setattr(SwatchStore, "get", broken)
    pictures = made(*PROCESS)
    pictures.request("view", [some("p")], STRIP)
    qtbot.waitUntil(lambda: drawn(pictures, some("p")))
    assert "a broken store" in caplog.text


def test_a_process_at_rest_is_started_again_when_there_is_work(made, qtbot) -> None:
    pictures = made(*PROCESS)
    pictures.request("history", [some("p")], STRIP)
    qtbot.waitUntil(lambda: drawn(pictures, some("p")))
    (idle,) = (timer for timer in pictures.findChildren(QTimer) if timer.interval() == IDLE_MS)
    idle.timeout.emit()
    # Asked while the process is still ending, and once it has.
    pictures.request("history", [some("q")], STRIP)
    qtbot.waitUntil(lambda: drawn(pictures, some("q")))
    assert not pictures.problem(STRIP)


@pytest.mark.usefixtures("shared_cache")
def test_the_real_process_draws_a_lit_sphere_and_refuses_what_cannot_be(made, qtbot) -> None:
    pictures = made()
    look = SwatchLook(size=128)
    blue = solid_paint("blue", (30.0, 10.0, -45.0))
    wrong = replace(blue, gloss=Gloss(199.0))
    pictures.request("history", [wrong, blue], look)
    qtbot.waitUntil(lambda: pictures.is_settled(blue, look))
    assert pictures.problem(look) == ""
    assert "199" in pictures.refusal(wrong, look)
    image = pictures.picture(blue, look).toImage()
    corner, low = image.pixelColor(2, 2), image.pixelColor(64, 96)
    assert abs(corner.red() - 117) <= 2
    assert corner.red() == corner.green() == corner.blue()
    assert low.blue() > 1.3 * low.red()
