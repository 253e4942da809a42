"""Measured files, palettes, and the arrow keys that go through paints."""

from __future__ import annotations

import pytest
from brdf_viewer.documents.file_kinds import ENDINGS
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.pipeline.material import paint_names

COLOURS = {"white": (95.0, 0.0, 1.0), "sky": (60.0, -10.0, -30.0), "brick": (40.0, 40.0, 30.0)}


@pytest.fixture
def palette(tmp_path):
    groups = ((), ("Warm",), ("Warm",), ("Warm",))
    entries = [
        Entry(solid_paint(name, lab), group=group)
        for (name, lab), group in zip(COLOURS.items(), groups, strict=False)
    ]
    path = tmp_path / "summer.brdfpalette"
    save_palette(Palette("Summer", tuple(entries)), path)
    return path


def focus(viewer) -> None:
    viewer.canvas.setFocus()
    viewer.qtbot.waitUntil(viewer.canvas.hasFocus)


def test_the_arrow_keys_go_through_the_shipped_paints_round_and_round(start) -> None:
    names = paint_names()
    viewer = start(paint=names[-1], follow=True)
    focus(viewer)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Right)
    assert viewer.state.paint_key == names[0]
    assert not viewer.controller.paint.following
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Left)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Left)
    assert viewer.state.paint_key == names[-2]
    assert viewer.window.paint.chooser.list.currentData() == names[-2]


def test_a_palette_is_gone_through_and_closed(viewer, palette) -> None:
    viewer.controller.open_file(str(palette))
    viewer.wait_idle()
    cell = viewer.window.status.cell("palette")
    assert (viewer.state.fit.name, cell.text()) == ("white", "Summer, 1 of 3")
    focus(viewer)
    for name, words in (("sky", "Summer, 2 of 3"), ("brick", "Summer, 3 of 3"), ("white", "Summer, 1 of 3")):
        QTest.keyClick(viewer.canvas, Qt.Key.Key_Right)
        assert (viewer.state.fit.name, cell.text()) == (name, words)
    viewer.window.commands.step_requested.emit(-1)
    assert viewer.state.fit.name == "brick"
    box = viewer.window.paint.chooser.list
    assert box.currentText() == "brick"
    assert [box.itemText(i) for i in range(3)] == list(COLOURS)
    box.activated.emit(1)
    assert viewer.state.fit.name == "sky"
    assert viewer.window.commands.palette_close.isEnabled()
    viewer.window.commands.palette_close.trigger()
    assert viewer.state.fit.name == "sky"
    assert cell.text() == ""
    assert not viewer.window.commands.palette_close.isEnabled()
    viewer.window.commands.step_requested.emit(1)
    assert viewer.state.paint_key in paint_names()


def test_a_paint_of_a_palette_that_cannot_be_is_reported_and_gone_past(viewer, tmp_path) -> None:
    from dataclasses import replace

    good, other = (solid_paint(name, COLOURS[name]) for name in ("sky", "brick"))
    impossible = replace(other, name="too glossy", gloss=replace(other.gloss, gu_20=200.0, gu_60=1.0))
    path = tmp_path / "mixed.brdfpalette"
    save_palette(Palette("Mixed", (Entry(good), Entry(impossible), Entry(other))), path)
    viewer.controller.open_file(str(path))
    viewer.wait_idle()
    viewer.window.commands.step_requested.emit(1)
    assert "paint" in viewer.messages()
    assert viewer.state.fit.name == "sky"
    viewer.window.commands.step_requested.emit(1)
    assert viewer.state.fit.name == "brick"
    assert "paint" not in viewer.messages()


def test_a_palette_that_cannot_be_read_is_reported(viewer, tmp_path) -> None:
    bad = tmp_path / "bad.brdfpalette"
    bad.write_text("{}")
    viewer.controller.open_file(str(bad))
    viewer.wait_idle()
    assert "bad.brdfpalette" in viewer.messages()["paint"]
    assert viewer.state.fit is not None


def test_a_measured_file_is_fitted_in_the_background(viewer, shared_data, qtbot) -> None:
    file = shared_data / "brdf" / "krylon_blue.brdf"
    name = viewer.state.fit.name
    viewer.window.files_dropped.emit([str(file)])
    assert viewer.state.fit.name == name
    qtbot.waitUntil(lambda: viewer.state.paint_key == str(file))
    assert viewer.state.fit.kind == "measured"
    assert viewer.window.paint.chooser.list.currentData() == str(file)
    assert not viewer.controller.paint.following
    viewer.controller.compare.freeze()
    assert viewer.view.compare.paint == str(file)


def test_another_paint_gives_a_measured_file_up(viewer, shared_data, qtbot) -> None:
    file = shared_data / "brdf" / "krylon_blue.brdf"
    viewer.controller.paint.open(str(file))
    viewer.controller.paint.open("solid_red")
    qtbot.wait(300)
    assert viewer.state.paint_key == "solid_red"
    assert viewer.window.paint.chooser.list.currentData() == "solid_red"


def test_a_file_that_is_not_measured_is_reported(viewer, tmp_path, qtbot) -> None:
    bad = tmp_path / "bad.bsdf"
    bad.write_bytes(b"no measurement")
    viewer.controller.open_file(str(bad))
    qtbot.waitUntil(lambda: "paint" in viewer.messages())
    assert "bad.bsdf" in viewer.messages()["paint"]
    assert viewer.window.paint.chooser.list.currentData() == viewer.state.paint_key


def test_every_measured_format_is_opened() -> None:
    from brdf_suite.files.measured import FORMATS

    assert {ending for known in FORMATS for ending in known.endings} <= set(ENDINGS["paint"])


def test_every_kind_of_material_is_opened(viewer, materials, qtbot) -> None:
    for kind, asked in materials.items():
        before = viewer.state.fit
        viewer.controller.paint.open(asked)
        qtbot.waitUntil(lambda before=before: viewer.state.fit is not before)
        assert "paint" not in viewer.messages(), kind
