"""Small pictures: the newest request goes first, and what goes wrong is reported."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest
from brdf_designer.preview.thumbnail_scene import SIZE, ThumbnailScene, paint_key
from brdf_designer.preview.thumbnails import IDLE_MS, Thumbnails, thumbnails_of
from PySide6.QtCore import QObject, QTimer

from brdf_suite.documents.paint import Flakes, Gloss, Paint, solid_paint

PROGRAM = Path(__file__).parent / "thumbnail_program.py"


def grey(lightness: float, name: str = "grey") -> Paint:
    return solid_paint(name, (lightness, 0.0, 0.0))


@pytest.fixture
def made(qapp):
    """Make clients of the stand-in; all are closed at the end."""
    made = []

    def make(mode: str = "answers") -> Thumbnails:
        made.append(Thumbnails(program=[sys.executable, str(PROGRAM), mode]))
        return made[-1]

    yield make
    for one in made:
        one.close()


def level(thumbnails: Thumbnails, paint: Paint) -> int:
    return thumbnails.picture(paint).pixelColor(SIZE // 2, SIZE // 2).red()


def test_the_key_is_of_what_is_seen() -> None:
    paint = grey(40.0)
    assert paint_key(paint) == paint_key(replace(paint, name="other", notes="n", source="s"))
    seen = [
        paint,
        grey(41.0),
        replace(paint, gloss=Gloss(80.0)),
        replace(paint, flakes=Flakes()),
        replace(paint, near_specular=2.0),
    ]
    assert len({paint_key(one) for one in seen}) == len(seen)
    assert paint_key(paint) != paint_key(paint, ThumbnailScene("sunny"))


def test_pictures_come_and_are_kept(made, qtbot) -> None:
    thumbnails = made()
    paints = [grey(20.0), grey(40.0)]
    busy: list[bool] = []
    thumbnails.busy_changed.connect(busy.append)
    stand_in = thumbnails.picture(paints[0])
    assert stand_in.size().width() == SIZE
    assert not thumbnails.is_drawn(paints[0])
    thumbnails.request("history", paints)
    qtbot.waitUntil(lambda: all(map(thumbnails.is_drawn, paints)))
    assert [level(thumbnails, paint) for paint in paints] == [50, 100]
    qtbot.waitUntil(lambda: len(busy) >= 2)
    assert busy == [True, False]
    came: list[str] = []
    thumbnails.ready.connect(lambda key, _image: came.append(key))
    # The same paint under another name is not drawn again.
    thumbnails.request("history", [grey(20.0, "renamed"), grey(60.0)])
    qtbot.waitUntil(lambda: thumbnails.is_drawn(grey(60.0)))
    assert came == [paint_key(grey(60.0))]


def test_the_newest_owner_goes_first_and_an_older_list_is_forgotten(made, qtbot) -> None:
    thumbnails = made()
    came: list[str] = []
    thumbnails.ready.connect(lambda key, _image: came.append(key))
    thumbnails.request("variations", [grey(10.0), grey(11.0)])
    thumbnails.request("history", [grey(20.0)])
    thumbnails.request("variations", [grey(12.0)])
    qtbot.waitUntil(lambda: thumbnails.is_drawn(grey(20.0)) and thumbnails.is_drawn(grey(12.0)))
    assert not thumbnails.is_drawn(grey(10.0))
    assert not thumbnails.is_drawn(grey(11.0))
    assert set(came) == {paint_key(grey(20.0)), paint_key(grey(12.0))}


def test_a_paint_that_cannot_be_is_reported_and_the_others_come(made, qtbot) -> None:
    thumbnails = made()
    wrong = grey(30.0, "impossible")
    thumbnails.request("variations", [wrong, grey(50.0)])
    with qtbot.waitSignal(thumbnails.failed) as reported:
        pass
    assert reported.args == [paint_key(wrong), "No clearcoat gives this gloss."]
    assert thumbnails.refusal(wrong) == "No clearcoat gives this gloss."
    qtbot.waitUntil(lambda: thumbnails.is_drawn(grey(50.0)))


def test_without_graphics_it_is_said_once_and_placeholders_stay(made, qtbot) -> None:
    thumbnails = made("no graphics")
    with qtbot.waitSignal(thumbnails.unavailable) as reported:
        thumbnails.request("history", [grey(50.0)])
    assert "OpenGL" in reported.args[0] == thumbnails.problem
    thumbnails.request("history", [grey(60.0)])
    assert not thumbnails.picture(grey(60.0)).isNull()


def test_a_process_that_dies_is_started_again_once(made, qtbot) -> None:
    thumbnails = made("dies once")
    thumbnails.request("history", [grey(50.0), grey(60.0), grey(70.0)])
    qtbot.waitUntil(lambda: thumbnails.is_drawn(grey(70.0)))
    assert not thumbnails.problem
    hopeless = made("dies")
    with qtbot.waitSignal(hopeless.unavailable):
        hopeless.request("history", [grey(50.0)])
    missing = Thumbnails(program=["/no/such/program"])
    with qtbot.waitSignal(missing.unavailable) as reported:
        missing.request("history", [grey(50.0)])
    assert "cannot be drawn" in reported.args[0]


def test_a_window_has_one(qapp) -> None:
    window = QObject()
    assert thumbnails_of(window) is thumbnails_of(window)


@pytest.mark.usefixtures("shared_cache")
def test_the_real_process_draws_a_lit_sphere_and_refuses_what_cannot_be(qtbot) -> None:
    thumbnails = Thumbnails()
    try:
        blue = solid_paint("blue", (30.0, 10.0, -45.0))
        wrong = replace(blue, gloss=Gloss(199.0))
        thumbnails.request("history", [wrong, blue])
        qtbot.waitUntil(lambda: thumbnails.is_drawn(blue) or bool(thumbnails.problem))
        assert thumbnails.problem == ""
        assert "199" in thumbnails.refusal(wrong)
        image = thumbnails.picture(blue)
        corner, low = image.pixelColor(2, 2), image.pixelColor(SIZE // 2, 3 * SIZE // 4)
        assert abs(corner.red() - 117) <= 2
        assert corner.red() == corner.green() == corner.blue()
        assert low.blue() > 1.3 * low.red()
    finally:
        thumbnails.close()


def test_a_process_at_rest_is_started_again_when_there_is_work(made, qtbot) -> None:
    thumbnails = made()
    thumbnails.request("history", [grey(50.0)])
    qtbot.waitUntil(lambda: thumbnails.is_drawn(grey(50.0)))
    (idle,) = (timer for timer in thumbnails.findChildren(QTimer) if timer.interval() == IDLE_MS)
    idle.timeout.emit()
    # Asked while the process is still ending, and once it has.
    thumbnails.request("history", [grey(60.0)])
    qtbot.waitUntil(lambda: thumbnails.is_drawn(grey(60.0)))
    assert not thumbnails.problem
