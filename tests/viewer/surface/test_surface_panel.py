"""The Surface section: occlusion and ground in the background, parts and their materials, scale and normals."""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np
import pytest
from brdf_viewer.surface import control as surface_control
from PySide6.QtCore import QPoint, Qt

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import PartMaterial, Sparkle, SurfaceLook
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress
from brdf_suite.surface.mesh import Mesh

PLAIN = SurfaceLook(occlusion=False)


@pytest.fixture
def balls(start, lights, two_balls):
    smooth = Sparkle("off")
    view = View(environment=str(lights["dim"]), surface=str(two_balls), surface_look=PLAIN, sparkle=smooth)
    return start(view=view)


def section(viewer):
    return viewer.window.surface


def wait_baked(viewer, qtbot) -> None:
    qtbot.waitUntil(lambda: viewer.state.surface.baked is not None)


def wait_shape(viewer, picture: np.ndarray) -> None:
    """Wait until the strip of the work that has ended takes no height from the picture any more."""
    viewer.qtbot.waitUntil(lambda: viewer.pixels().shape == picture.shape)


def test_occlusion_comes_in_the_background_and_goes_with_its_switch(balls, qtbot) -> None:
    before = balls.pixels()
    assert balls.state.surface.baked is None
    section(balls).occlusion.click()
    assert balls.view.surface_look.occlusion
    wait_baked(balls, qtbot)
    assert balls.controller.surface.is_idle
    wait_shape(balls, before)
    after = balls.pixels()
    darker = before.astype(int) - after
    assert darker.max() > 10
    section(balls).occlusion.click()
    assert np.array_equal(balls.pixels(), before)


def test_the_ground_takes_the_shadow(balls, qtbot) -> None:
    before = balls.pixels()
    section(balls).ground.click()
    wait_baked(balls, qtbot)
    wait_shape(balls, before)
    rows = (before.astype(int) - balls.pixels()).max(axis=(1, 2))
    assert rows[-1 - len(rows) // 3 :].max() > 15
    assert rows[: len(rows) // 4].max() <= 1


def test_a_picture_is_settled_only_with_its_occlusion(start, lights, two_balls, qtbot, monkeypatch) -> None:
    go_on = threading.Event()
    bake = surface_control.baked_occlusion

    def held(mesh: Mesh, progress: Progress) -> object:
        go_on.wait(60.0)
        return bake(mesh, progress)

    monkeypatch.setattr(surface_control, "baked_occlusion", held)
    view = View(environment=str(lights["dim"]), surface=str(two_balls), sparkle=Sparkle("off"))
    viewer = start(view=view, wait=False)  # waiting until it is idle would wait for the occlusion
    baked: list[bool] = []
    viewer.controller.settled.connect(lambda: baked.append(viewer.state.surface.baked is not None))
    frame_time = viewer.window.status.cell("frame")
    qtbot.waitUntil(lambda: bool(frame_time.text()))  # the frame's time has been measured and is shown
    go_on.set()
    qtbot.waitUntil(lambda: bool(baked))
    assert all(baked)


def test_baking_is_reported_cancelled_and_offered_again(balls, qtbot, monkeypatch) -> None:
    hold, started = threading.Event(), threading.Event()
    bake = surface_control.baked_occlusion

    def slow(mesh: Mesh, progress: Progress):
        started.set()
        while not hold.wait(0.01):
            progress(0.5, "held by the test")
        return bake(mesh, progress)

    monkeypatch.setattr(surface_control, "baked_occlusion", slow)
    section(balls).occlusion.click()
    qtbot.waitUntil(started.is_set)
    assert section(balls).baking.text() == "Computing ambient occlusion…"
    balls.window.busy_cancelled.emit(surface_control.OCCLUSION)
    assert balls.controller.surface.is_idle
    assert "Shown without ambient occlusion" in section(balls).baking.text()
    assert balls.state.surface.baked is None
    hold.set()
    section(balls).again.click()
    wait_baked(balls, qtbot)
    assert section(balls).again.isHidden()
    assert section(balls).baking.isHidden()


def test_a_failure_is_reported_and_the_picture_stays(balls, qtbot, monkeypatch) -> None:
    def failing(*_: object) -> None:
        raise SuiteError("Occlusion cannot be baked: a test.")

    monkeypatch.setattr(surface_control, "baked_occlusion", failing)
    section(balls).occlusion.click()
    qtbot.waitUntil(lambda: "occlusion" in balls.messages())
    assert "without ambient occlusion" in balls.messages()["occlusion"]
    assert not balls.window.picture.failure


def test_a_click_in_the_picture_picks_the_part(balls, qtbot) -> None:
    canvas = balls.canvas
    middle, quarter = canvas.height() // 2, canvas.width() // 8
    parts = section(balls).parts
    for x, name in ((canvas.width() // 2 - quarter, "left"), (canvas.width() // 2 + quarter, "right")):
        qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x, middle))
        assert parts.picked() == [name]
    # A drag is no click, and a click beside the object lets go.
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(canvas.width() // 2 - quarter, middle))
    qtbot.mouseMove(canvas, QPoint(canvas.width() // 2, middle + 30))
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(canvas.width() // 2, middle + 30))
    assert parts.picked() == ["right"]
    qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=QPoint(2, 2))
    assert parts.picked() == []


def test_picked_parts_take_a_material_and_give_it_back(balls) -> None:
    before = balls.pixels()
    parts = section(balls).parts
    assert not parts.material.isEnabled()
    parts.pick("left")
    parts.pick("right", add=True)
    assert sorted(parts.picked()) == ["left", "right"]
    parts.material.activated.emit(parts.material.findData("chrome"))
    assert {m.part: m.material for m in balls.view.surface_look.materials} == {
        "left": "chrome",
        "right": "chrome",
    }
    assert parts.list.topLevelItem(0).text(1) == "Chrome"
    assert not np.array_equal(balls.pixels(), before)
    parts.material.activated.emit(0)
    assert balls.view.surface_look.materials == ()
    assert parts.list.topLevelItem(0).text(1) == "Paint"
    assert np.array_equal(balls.pixels(), before)


def test_the_paint_goes_on_the_parts_that_are_picked(balls) -> None:
    parts = section(balls).parts
    parts.pick("right")
    parts.material.activated.emit(parts.material.findData("paint"))
    picture = balls.pixels().astype(int)
    blue = picture[..., 2] - picture[..., 0]
    half = blue.shape[1] // 2
    assert blue[:, half:].max() > 20
    balls.state.history.undo()
    assert balls.view.surface_look.materials == ()
    assert parts.list.topLevelItem(1).text(1) == "Neutral grey"


def test_a_scale_loads_the_surface_again(balls, qtbot) -> None:
    old = balls.state.surface
    low, high = old.value.bounds()
    section(balls).scale.edited.emit(3.0)
    qtbot.waitUntil(lambda: balls.state.surface is not old)
    found_low, found_high = balls.state.surface.value.bounds()
    np.testing.assert_allclose(found_high - found_low, 3.0 * (high - low), rtol=1e-5)
    assert "0.72" in section(balls).facts.text() or "1.32" in section(balls).facts.text()


def test_unit_place_and_normals_are_edited(balls, qtbot) -> None:
    own = section(balls)
    for widget, field, wanted in (
        (own.recentre, "recentre", True),
        (own.flip_normals, "flip_normals", True),
    ):
        widget.click()
        assert getattr(balls.view.surface_look, field) is wanted
    for box, field, key in ((own.unit, "unit", "cm"), (own.normals, "normals", "flat")):
        box.activated.emit(box.findData(key))
        assert getattr(balls.view.surface_look, field) == key
    qtbot.waitUntil(lambda: "centimetres" in own.facts.text())
    low, high = balls.state.surface.value.bounds()
    assert (high - low).max() == pytest.approx(0.0044, rel=0.05)
    assert low[1] == pytest.approx(0.0, abs=1e-6)


def test_a_view_from_elsewhere_is_shown(balls) -> None:
    look = replace(PLAIN, ground=True, materials=(PartMaterial("left", "glass"),))
    balls.state.change_view(surface_look=look)
    assert section(balls).ground.isChecked()
    assert section(balls).parts.list.topLevelItem(0).text(1) == "Glass"
    assert section(balls).parts.list.topLevelItem(0).font(1).bold()
