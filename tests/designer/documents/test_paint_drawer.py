"""The drawer Paints: what is taken opens in a tab of its own, and a palette's designs are listed."""

from __future__ import annotations

from pathlib import Path

from brdf_designer.documents.paint_drawer import PaintDrawer

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.pipeline.material import load_document, load_shipped_paint, paint_names

RED = solid_paint("Signal red", (45.0, 60.0, 40.0))


def test_a_shipped_paint_and_a_recent_file_open_in_tabs(designer, tmp_path: Path, qtbot) -> None:
    drawer = designer.feature(PaintDrawer)
    file = tmp_path / "mine.brdfpaint"
    save_paint(RED, file)
    drawer.strip.view.taken.emit("candy_red", False)
    assert designer.store.value == load_shipped_paint("candy_red")
    assert designer.store.is_clean
    designer.documents.open(file)
    qtbot.waitUntil(lambda: designer.reading.is_idle)
    drawer.strip.taken.emit("candy_red")
    assert designer.documents.front.store.path is None
    drawer.strip.taken.emit(str(file))
    assert designer.documents.front.store.path == file
    assert drawer.model.present == str(file)


def test_the_designs_of_a_palette_are_listed_and_the_rest_is_said(qtbot, designer, tmp_path: Path) -> None:
    drawer = designer.feature(PaintDrawer)
    flat = FlatColour("Sky", "RGB", (0.3, 0.5, 0.8), space="sRGB")
    lobes = load_document("table1_ford_f8")
    assert isinstance(lobes, CookTorrancePaint)
    file = tmp_path / "three.brdfpalette"
    save_palette(Palette("Three", tuple(Entry(one) for one in (RED, flat, lobes))), file)
    drawer.open_palette(str(file))
    qtbot.waitUntil(lambda: drawer.strip.sources.rowCount() == 2)
    assert [drawer.strip.sources.index(row, 0).data() for row in (0, 1)] == ["Signal red", "Sky"]
    assert "1 of 3" in designer.window.messages.shown()["palette"].what
    drawer.strip.taken.emit(drawer.strip.sources.key_at(1))
    assert designer.store.value.measurements == to_paint(flat).measurements
    drawer.strip.origin.picked.emit("shipped")
    assert drawer.strip.sources.rowCount() == len(paint_names())


def test_a_file_that_is_no_palette_is_reported_and_the_list_stays(qtbot, designer, tmp_path: Path) -> None:
    drawer = designer.feature(PaintDrawer)
    file = tmp_path / "broken.brdfpalette"
    file.write_text("{")
    drawer.open_palette(str(file))
    qtbot.waitUntil(lambda: "palette" in designer.window.messages.shown())
    message = designer.window.messages.shown()["palette"]
    assert file.name in message.what
    assert str(file.parent) in message.where
    assert drawer.model.rowCount() == len(paint_names())
