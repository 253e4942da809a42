"""Parts in the picture: clicked, outlined, given paints and materials by the menu."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from brdf_qt.choosing.drag import carry
from PySide6.QtCore import QEvent, QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDragLeaveEvent, QDragMoveEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, new_id
from brdf_suite.documents.store import load_paint, save_paint
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook, TwoTone
from brdf_suite.pipeline.material import load_shipped_paint

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
NONE, CTRL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def balls(start, lights, two_balls):
    """Two balls side by side seen from the front: the left of paint, the right neutral."""
    view = View(
        environment=str(lights["dim"]),
        surface=str(two_balls),
        surface_look=SurfaceLook(occlusion=False),
        sparkle=Sparkle("off"),
        camera=Camera(azimuth_deg=0.0, elevation_deg=0.0),
    )
    return start(view=view)


def place(viewer, part: str) -> QPoint:
    """The middle of a ball in the picture."""
    size = viewer.canvas.size()
    side = 0.28 if part == "left" else 0.72
    return QPoint(round(side * size.width()), size.height() // 2)


def click(viewer, part: str, button=LEFT, modifiers=NONE) -> None:
    QTest.mouseClick(viewer.canvas, button, modifiers, place(viewer, part))


def picked(viewer) -> list[str]:
    return viewer.window.surface.parts.picked()


def layer(viewer):
    return viewer.controller.parts.layer


def menu_of(viewer) -> QMenu:
    viewer.qtbot.waitUntil(lambda: QApplication.activePopupWidget() is not None)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def choose(viewer, text: str) -> None:
    """Take the entry of the open menu that begins with a text, by a click."""
    menu = menu_of(viewer)
    action = next(action for action in menu.actions() if action.text().startswith(text))
    QTest.mouseClick(menu, LEFT, NONE, menu.actionGeometry(action).center())


def mean_colour(viewer, part: str) -> np.ndarray:
    spot = place(viewer, part)
    return viewer.pixels()[spot.y() - 6 : spot.y() + 6, spot.x() - 6 : spot.x() + 6].mean(axis=(0, 1))


def test_a_click_selects_and_outlines_what_is_seen(balls, qtbot) -> None:
    click(balls, "left")
    assert picked(balls) == ["left"]
    qtbot.waitUntil(lambda: bool(layer(balls).marks))
    assert layer(balls).label == "left – Paint"
    outline = layer(balls).marks[0].outline
    drawn = np.array(
        [
            [outline.pixelColor(x, y).alpha() > 0 for x in range(outline.width())]
            for y in range(outline.height())
        ]
    )
    columns = np.nonzero(drawn.any(axis=0))[0] / outline.width()
    assert columns.max() < 0.5
    assert columns.max() - columns.min() > 0.2
    click(balls, "right", modifiers=CTRL)
    assert picked(balls) == ["left", "right"]
    QTest.mouseClick(balls.canvas, LEFT, NONE, QPoint(4, 4))
    assert picked(balls) == []
    qtbot.waitUntil(lambda: not layer(balls).isVisible())


def test_a_drag_selects_nothing_and_takes_the_outline_away_while_it_lasts(balls, qtbot) -> None:
    click(balls, "left")
    qtbot.waitUntil(lambda: bool(layer(balls).marks))
    before = layer(balls).marks[0].above
    middle = place(balls, "right")
    QTest.mousePress(balls.canvas, LEFT, NONE, middle)
    QTest.mouseMove(balls.canvas, middle + QPoint(40, 0))
    qtbot.waitUntil(lambda: not layer(balls).marks)
    QTest.mouseRelease(balls.canvas, LEFT, NONE, middle + QPoint(40, 0))
    assert picked(balls) == ["left"]
    qtbot.waitUntil(lambda: bool(layer(balls).marks))
    assert layer(balls).marks[0].above != before


def test_the_menu_gives_a_part_the_second_paint_and_its_own_back(balls, qtbot) -> None:
    first = mean_colour(balls, "left")
    click(balls, "left", RIGHT)
    choose(balls, "Second paint")
    assert balls.view.surface_look.chosen == {"left": "second_paint"}
    assert balls.view.two_tone.paint == "fine_silver"
    qtbot.waitUntil(lambda: balls.controller.relief.is_idle)
    qtbot.waitUntil(lambda: np.abs(mean_colour(balls, "left") - first).max() > 15)
    silver = mean_colour(balls, "left")
    assert np.ptp(silver) < 12 < np.ptp(first)  # silver is grey, and blue is not
    balls.state.change_view(two_tone=TwoTone(paint="red"))
    qtbot.waitUntil(lambda: mean_colour(balls, "left").argmax() == 0)
    click(balls, "left", RIGHT)
    checked = [action.text() for action in menu_of(balls).actions() if action.isChecked()]
    assert checked == ["Second paint (Red)"]
    choose(balls, "Reset")
    assert balls.view.surface_look.chosen == {}
    np.testing.assert_allclose(mean_colour(balls, "left"), first, atol=2)
    balls.controller.undo()
    assert balls.view.surface_look.chosen == {"left": "second_paint"}


def test_the_menu_is_of_all_selected_parts(balls, qtbot) -> None:
    click(balls, "left")
    click(balls, "right", modifiers=CTRL)
    click(balls, "right", RIGHT)
    choose(balls, "Chrome")
    assert balls.view.surface_look.chosen == {"left": "chrome", "right": "chrome"}
    assert {row.text(1) for row in balls.window.surface.parts.list.selectedItems()} == {"Chrome"}
    qtbot.waitUntil(lambda: layer(balls).label == "left, right – Chrome")


def test_the_menu_puts_the_highlight_where_it_was_opened(balls) -> None:
    spot = place(balls, "left") - QPoint(12, 12)
    QTest.mouseClick(balls.canvas, RIGHT, NONE, spot)
    choose(balls, "Put the Highlight")
    (lamp,) = balls.view.lamps
    _, ray = balls.controller.seen.ray_at(QPointF(spot))
    hit = balls.controller.seen.hit_at(QPointF(spot))
    mirrored = ray - 2.0 * (ray @ hit.normal) * hit.normal
    elevation = np.radians(lamp.elevation_deg)
    assert np.degrees(np.arcsin(mirrored[1])) == pytest.approx(lamp.elevation_deg, abs=0.5)
    assert np.hypot(mirrored[0], mirrored[2]) == pytest.approx(np.cos(elevation), abs=0.01)
    assert mirrored[0] < 0.0 < mirrored[1]
    balls.controller.undo()
    assert balls.view.lamps == ()


def test_a_right_drag_turns_the_light_and_opens_no_menu(balls) -> None:
    middle = place(balls, "left")
    QTest.mousePress(balls.canvas, RIGHT, NONE, middle)
    QTest.mouseMove(balls.canvas, middle + QPoint(30, 0))
    QTest.mouseRelease(balls.canvas, RIGHT, NONE, middle + QPoint(30, 0))
    assert balls.view.rotation_deg != 0.0
    assert QApplication.activePopupWidget() is None


def dragged(viewer, kind: QEvent.Type, data: QMimeData, part: str, modifiers=NONE) -> bool:
    """Send an event of a drag at a part to the canvas; whether it was taken."""
    at = place(viewer, part) if part else QPoint(4, 4)
    make = {QEvent.Type.DragEnter: QDragEnterEvent, QEvent.Type.DragMove: QDragMoveEvent}.get(kind)
    if make is None:
        event = QDropEvent(QPointF(at), Qt.DropAction.CopyAction, data, LEFT, modifiers)
    else:
        event = make(at, Qt.DropAction.CopyAction, data, LEFT, modifiers)
    event.ignore()
    QApplication.sendEvent(viewer.canvas, event)
    return event.isAccepted()


def drop(viewer, data: QMimeData, part: str, modifiers=NONE) -> str:
    """Drag over a part and drop there; return what the picture said before."""
    assert dragged(viewer, QEvent.Type.DragEnter, data, part, modifiers)
    assert dragged(viewer, QEvent.Type.DragMove, data, part, modifiers)
    said = layer(viewer).label
    assert dragged(viewer, QEvent.Type.Drop, data, part, modifiers)
    return said


def swatch(paint) -> QMimeData:
    return carry([Entry(paint, id=new_id())], ["#808080"], "", "")


def test_a_paint_file_is_dropped_on_a_part(balls, qtbot, tmp_path) -> None:
    file = tmp_path / "roof.brdfpaint"
    save_paint(replace(load_shipped_paint("red"), name="Roof"), file)
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(file))])
    assert drop(balls, data, "right") == "Second paint of right"
    assert balls.view.surface_look.chosen == {"right": "second_paint"}
    assert balls.view.two_tone.paint == str(file)
    qtbot.waitUntil(lambda: balls.controller.relief.is_idle)
    qtbot.waitUntil(lambda: mean_colour(balls, "right").argmax() == 0)
    assert balls.state.paint_key == "blue"
    balls.controller.undo()
    assert (balls.view.surface_look.chosen, balls.view.two_tone.paint) == ({}, None)


def test_a_swatch_becomes_the_paint_of_all_or_the_second_with_ctrl_or_of_the_selected(balls) -> None:
    assert drop(balls, swatch(load_shipped_paint("red")), "") == "Paint"
    assert balls.state.paint_key == "red"
    assert drop(balls, swatch(load_shipped_paint("copper")), "left").startswith("Paint – with Ctrl")
    assert balls.state.paint_key == "copper"
    assert drop(balls, swatch(load_shipped_paint("gunmetal")), "left", CTRL) == "Second paint of left"
    assert (balls.view.surface_look.chosen, balls.view.two_tone.paint) == (
        {"left": "second_paint"},
        "gunmetal",
    )
    own = replace(load_shipped_paint("pearl"), name="Own / pearl")
    click(balls, "left")
    click(balls, "right", modifiers=CTRL)
    assert drop(balls, swatch(own), "right") == "Second paint of left, right"
    assert balls.view.surface_look.chosen == {"left": "second_paint", "right": "second_paint"}
    assert load_paint(balls.view.two_tone.paint) == own


def test_a_flat_colour_is_a_paint_too_and_what_is_none_is_refused(balls) -> None:
    drop(balls, swatch(FlatColour("Signal", "RGB", (1.0, 0.1, 0.1), space="sRGB")), "right")
    assert load_paint(balls.view.two_tone.paint).name == "Signal"
    before = balls.view
    damaged = QMimeData()
    damaged.setData("application/x-brdf-paint", b"{]")
    drop(balls, damaged, "right")
    assert "no paint" in balls.messages()["dropped"]
    assert balls.view == before
    mesh = QMimeData()
    mesh.setUrls([QUrl.fromLocalFile("/somewhere/form.glb")])
    assert dragged(balls, QEvent.Type.DragEnter, mesh, "right")  # the window takes it
    assert not layer(balls).marks
    assert layer(balls).label == ""


def test_the_part_under_a_dragged_paint_is_marked_until_it_leaves(balls) -> None:
    data = swatch(load_shipped_paint("red"))
    dragged(balls, QEvent.Type.DragEnter, data, "right")
    assert len(layer(balls).marks) == 1
    assert layer(balls).marks[0].above.x() > 0.5
    QApplication.sendEvent(balls.canvas, QDragLeaveEvent())
    assert not layer(balls).marks
