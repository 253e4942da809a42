"""The paint strip below the picture: a click shows a paint, with Shift as B; Tab hides it; its pictures are drawn."""

from __future__ import annotations

from pathlib import Path

from brdf_qt.choosing.thumbnails import SIZE, placeholder
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette


def click(
    viewer, key: str, held: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier, *, on_mark: bool = False
) -> None:
    strip = viewer.window.strip
    index = strip.sources.index(strip.sources.row_of(key), 0)
    strip.view.scrollTo(index)
    box = strip.view.visualRect(index)
    place = strip.view.mark_box(box).center() if on_mark else box.center()
    QTest.mouseClick(strip.view.viewport(), Qt.MouseButton.LeftButton, held, place)


def test_a_click_shows_a_paint_and_shift_click_compares(viewer) -> None:
    click(viewer, "candy_red")
    assert viewer.state.paint_key == "candy_red"
    assert viewer.window.paint.chooser.list.currentData() == "candy_red"
    assert viewer.window.strip.sources.model.present == "candy_red"
    click(viewer, "white_pearl", Qt.KeyboardModifier.ShiftModifier)
    viewer.qtbot.waitUntil(
        lambda: viewer.state.second is not None and viewer.state.second.key == "white_pearl"
    )
    assert viewer.state.paint_key == "candy_red"
    assert viewer.state.view.compare.mode == "side"


def test_the_mark_of_a_paint_compares_with_it_and_again_ends_that(viewer) -> None:
    click(viewer, "candy_red")
    click(viewer, "silver_metallic", on_mark=True)
    viewer.qtbot.waitUntil(lambda: viewer.window.strip.view.second == "silver_metallic")
    assert viewer.state.paint_key == "candy_red"
    assert viewer.state.view.compare.mode == "side"
    click(viewer, "silver_metallic", on_mark=True)
    assert viewer.state.view.compare.mode == "off"
    assert viewer.window.strip.view.second == ""


def test_a_swatch_of_the_open_palette_is_compared_by_its_name(viewer, tmp_path: Path) -> None:
    file = tmp_path / "two.brdfpalette"
    paints = [solid_paint("first", (30.0, 0.0, 0.0)), solid_paint("second", (70.0, 0.0, 0.0))]
    save_palette(Palette("Two", tuple(Entry(paint) for paint in paints)), file)
    viewer.controller.open_file(str(file))
    viewer.wait_idle()
    keys = viewer.controller.paint._palette.keys
    click(viewer, keys[1], Qt.KeyboardModifier.ShiftModifier)
    viewer.qtbot.waitUntil(lambda: viewer.state.second is not None)
    assert (viewer.state.fit.name, viewer.state.second.value.name) == ("first", "second")
    assert viewer.window.compare.chooser.list.currentText() == "second"


def test_tab_on_the_picture_hides_the_strip_with_the_panels(viewer) -> None:
    viewer.canvas.setFocus()
    viewer.qtbot.waitUntil(viewer.canvas.hasFocus)
    assert viewer.window.strip.isVisible()
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Tab)
    viewer.qtbot.waitUntil(lambda: not viewer.window.strip.isVisible())
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Tab)
    viewer.qtbot.waitUntil(viewer.window.strip.isVisible)


def test_paints_and_an_own_mesh_get_their_pictures(drawn_swatches, start, tmp_path: Path) -> None:
    viewer = start()  # of its own: one that other tests had was made without what draws the pictures
    window = viewer.window
    model = window.strip.sources.model
    source = model.source_at(0)
    thumbnails = window.paint_thumbnails
    viewer.qtbot.waitUntil(lambda: thumbnails.content(source.key) is not None, timeout=60_000)
    stand_in = placeholder(thumbnails.content(source.key), SIZE).toImage()
    viewer.qtbot.waitUntil(lambda: thumbnails.picture(source.key).toImage() != stand_in, timeout=120_000)
    forms = window.surface.chooser.sources.thumbnails
    file = tmp_path / "pyramid.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n")
    forms.request("test", [(str(file), None)])
    blank = forms.picture("no such form").toImage()
    viewer.qtbot.waitUntil(lambda: forms.picture(str(file)).toImage() != blank, timeout=120_000)
