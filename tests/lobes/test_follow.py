"""Designer's paint as a subject of its own, and the fits of all subjects."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import replace

import numpy as np
import pytest
from brdf_lobe_visualizer.subjects.fits import KEY
from brdf_qt.link.link import LiveLink

from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import Material, load_shipped_paint
from brdf_suite.reflectance.registry import MODELS


@pytest.fixture
def following(program, monkeypatch):
    """The program as it follows; fits are exact at once, however busy the machine is."""
    monkeypatch.setitem(PaintFitter.__init__.__kwdefaults__, "time_limit_s", 60.0)
    program.followed.close()
    program.followed.action.setChecked(True)
    yield program
    program.followed.close()


def publish(program, paint) -> None:
    program.followed.receive("paint", paint_to_json(paint))


def front_lab(program) -> float:
    return program.session.subject(KEY).material.document.measurements[0].lab[0]


def test_designers_paint_comes_over_the_link_and_changes_with_it(following, qtbot, own_session) -> None:
    following.link.start()
    designer = LiveLink("designer", name=following.link.name)
    designer.start()
    try:
        qtbot.waitUntil(lambda: designer.peers == ("lobes",) and following.link.peers == ("designer",))
        paint = load_shipped_paint("copper")
        designer.publish("paint", paint_to_json(paint))
        qtbot.waitUntil(lambda: following.session.subject(KEY) is not None)
        subject = following.session.subject(KEY)
        assert (subject.material.document, following.session.front.key) == (paint, KEY)
        assert subject.fit.worst_delta_e is not None
        assert "Designer" in following.window.status.cell("link").text()
        lighter = replace(
            paint,
            measurements=tuple(replace(m, lab=(m.lab[0] + 3.0, *m.lab[1:])) for m in paint.measurements),
        )
        designer.publish("paint", paint_to_json(lighter))
        qtbot.waitUntil(lambda: following.session.subject(KEY).material.document == lighter)
        now = following.session.subject(KEY)
        assert (now.colour, now.dash) == (subject.colour, subject.dash)
        assert len(following.session.subjects) == 1
    finally:
        designer.close()


def test_of_many_edits_the_newest_is_shown(following, qtbot) -> None:
    for lightness in (30.0, 40.0, 50.0, 60.0):
        publish(following, solid_paint("Grey", (lightness, 0.0, 0.0)))
    qtbot.waitUntil(lambda: following.followed.is_idle)
    qtbot.waitUntil(lambda: front_lab(following) == 60.0)


def test_a_paint_that_cannot_be_leaves_the_one_before(following, qtbot) -> None:
    good = solid_paint("Grey", (50.0, 0.0, 0.0))
    publish(following, good)
    qtbot.waitUntil(lambda: following.session.subject(KEY) is not None)
    bad = replace(good, gloss=Gloss(90.0, 40.0))
    publish(following, bad)
    qtbot.waitUntil(lambda: "designer's paint" in following.window.messages.shown())
    assert following.session.subject(KEY).material.document == good
    publish(following, good)
    qtbot.waitUntil(lambda: "designer's paint" not in following.window.messages.shown())


def test_taken_out_of_the_legend_it_is_followed_no_more_until_requested(following, qtbot) -> None:
    publish(following, solid_paint("Grey", (50.0, 0.0, 0.0)))
    qtbot.waitUntil(lambda: following.session.subject(KEY) is not None)
    following.session.remove(KEY)
    assert not following.followed.action.isChecked()
    publish(following, solid_paint("Grey", (60.0, 0.0, 0.0)))
    assert following.followed.is_idle
    following.followed.action.setChecked(True)
    qtbot.waitUntil(lambda: following.session.subject(KEY) is not None)
    assert front_lab(following) == 60.0


def test_every_subject_is_fitted_and_the_status_bar_shows_it(opened, program) -> None:
    opened("blue", "table1_white", "lambertian")
    blue, white, matt = program.session.subjects
    assert blue.fit.worst_delta_e < 0.5
    assert {s.fit.kind for s in (blue, white)} == {"designed", "cook_torrance"}
    np.testing.assert_allclose(matt.fit.weights.kd, np.array([0.8, 0.5, 0.2]) / np.pi, rtol=0.05)
    program.session.set_front(blue.key)
    assert "fit" in program.window.status.cell("fit").text()
    assert "ΔE00" in program.window.status.cell("fit").text()
    assert program.window.progress.jobs == ()


def test_a_fit_that_time_has_limited_says_so(opened, program) -> None:
    opened("blue")
    (blue,) = program.session.subjects
    limited = replace(blue.fit, weights=replace(blue.fit.weights, time_limited=True))
    program.session.change(blue.key, fit=replace(limited, exact=Future()))
    assert "exact fit follows" in program.window.status.cell("fit").text()
    program.session.change(blue.key, fit=limited)
    assert "best result so far" in program.window.status.cell("fit").text()


def test_a_subject_that_changes_is_fitted_anew(opened, program, qtbot) -> None:
    opened("lambertian")
    (matt,) = program.session.subjects
    program.session.change(matt.key, material=Material("Phong", MODELS["phong"].default))
    qtbot.waitUntil(lambda: program.session.subject(matt.key).fit is not matt.fit, timeout=30_000)
    assert (
        program.session.subject(matt.key).fit.weights.kg.any()
        or program.session.subject(matt.key).fit.weights.kdd.any()
    )


def test_what_cannot_be_fitted_is_shown_without_one(program, qtbot) -> None:
    class Broken:
        def eval(self, wi, wo):
            return np.full(np.broadcast_shapes(np.shape(wi), np.shape(wo)), np.nan)

    from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial

    key = program.sources.add(PlottedMaterial("", "No numbers", Material("No numbers", Broken())))
    qtbot.waitUntil(lambda: f"fit {key}" in program.window.messages.shown(), timeout=30_000)
    assert program.session.subject(key).fit is None
    program.session.remove(key)
    assert f"fit {key}" not in program.window.messages.shown()


def test_a_drag_is_shown_while_it_lasts(following, qtbot) -> None:
    """Each paint comes while the one before is still fitted; the last of them is shown in the end."""
    shown = []
    following.followed.arrived.connect(lambda: shown.append(front_lab(following)))
    publish(following, solid_paint("Grey", (10.0, 0.0, 0.0)))
    for lightness in range(11, 60):
        assert not following.followed.is_idle
        publish(following, solid_paint("Grey", (float(lightness), 0.0, 0.0)))
    qtbot.waitUntil(lambda: following.followed.is_idle)
    assert shown[0] == 10.0
    assert shown[-1] == 59.0
    following.followed.arrived.disconnect()
    following.followed.arrived.connect(following.drop_default)
