"""The Texture section by mouse and keyboard: readings after edits, targets of the paint, flakes with undo."""

from __future__ import annotations

import json

import pytest
from brdf_designer.standard_comparison.records import Record, record_from_json
from brdf_designer.texture.control import TextureControl
from brdf_qt.program.settings import settings
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.appearance.texture import NO_TEXTURE
from brdf_suite.documents.paint import Flakes, TextureTargets
from brdf_suite.documents.store import load_paint, save_paint
from brdf_suite.inspection.texture.camera import measure_texture
from brdf_suite.inspection.texture.expectation import expected_scales
from brdf_suite.inspection.texture.readings import paint_light
from brdf_suite.paint_design.standard import standard_of
from brdf_suite.pipeline.material import load_shipped_paint


@pytest.fixture
def control(designer, qtbot) -> TextureControl:
    found = next(part for part in designer.window.children() if isinstance(part, TextureControl))
    designer.window.show_section("texture")
    settle(found, qtbot)
    return found


def settle(control: TextureControl, qtbot) -> None:
    qtbot.waitUntil(lambda: control.is_idle and control.readings is not None, timeout=120_000)


def type_in(field, text: str) -> None:
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)


def shown(control: TextureControl, row: int, column: int) -> str:
    return control.section.table.item(row, column).text()


def test_readings_are_those_of_the_instrument_and_follow_edits(designer, control, qtbot) -> None:
    fit = designer.session.fit
    expected = measure_texture(paint_light(fit.weights), fit.flakes)
    assert control.readings == expected
    assert shown(control, 1, 1) == f"{100 * expected.sparkle[1].grade:.1f} %"
    assert shown(control, 3, 1) == f"{100 * expected.graininess:.2f} %"
    type_in(designer.window.flakes.daily.fields["flakes.density_per_mm2"], "300")
    qtbot.waitUntil(lambda: control.readings != expected, timeout=120_000)
    assert control.readings.graininess > 2.0 * expected.graininess
    designer.window.flakes.has_flakes.click()
    qtbot.waitUntil(lambda: control.readings == NO_TEXTURE, timeout=120_000)
    assert "no flakes" in control.section.note.text()
    assert not control.section.table.isVisible()


def test_a_reading_beyond_its_tolerance_is_told_from_one_within(control, qtbot) -> None:
    section = control.section
    QTest.mouseClick(section.take, Qt.MouseButton.LeftButton)
    assert [shown(control, row, 4) for row in range(4)] == ["+0 %"] * 4
    grain = control.readings.graininess
    type_in(section.targets["graininess"], f"{200 * grain:.2f}")
    assert shown(control, 3, 4) == "−50 %"
    assert section.table.item(3, 4).font().bold()
    assert section.table.item(3, 4).toolTip() == "beyond tolerance"
    type_in(section.tolerance, "60")
    assert not section.table.item(3, 4).font().bold()
    assert float(settings().value("texture/tolerance")) == 60.0


def test_flakes_are_found_by_targets_and_undone(designer, control, qtbot) -> None:
    light = paint_light(designer.session.fit.weights)
    wanted = expected_scales(light, Flakes(1500.0, 22.0, 0.165))
    for field, value in zip(control.section.targets.values(), wanted.tolist(), strict=True):
        type_in(field, f"{100 * value:.2f}")
    before = designer.store.value
    QTest.mouseClick(control.section.search, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: designer.store.value != before, timeout=120_000)
    assert designer.store.stack.undoText() == "Find Flakes"
    assert "Flakes found" in control.section.answer.text()
    assert designer.store.value.flakes.colour_spread == before.flakes.colour_spread
    settle(control, qtbot)
    assert control.readings.scales() == pytest.approx(wanted, rel=0.06)
    designer.session.undo()
    assert designer.store.value == before


def test_what_cannot_be_reached_is_said(designer, control, qtbot) -> None:
    for key, text in (("grade_15", "0.1"), ("grade_45", "0.1"), ("graininess", "20")):
        type_in(control.section.targets[key], text)
    QTest.mouseClick(control.section.search, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "Not reachable" in control.section.answer.text(), timeout=120_000)
    assert "nearest" in control.section.answer.text()


def test_each_document_has_targets_of_its_own(designer, control, qtbot) -> None:
    type_in(control.section.targets["grade_15"], "33")
    designer.documents.add(load_shipped_paint("red"))
    assert control.section.wanted() == (None,) * 4
    assert not control.section.search.isEnabled()
    designer.documents.step(-1)
    assert control.section.wanted()[0] == pytest.approx(0.33)
    settle(control, qtbot)


def test_targets_are_edits_of_the_paint_and_saved_with_it(designer, control, qtbot, tmp_path) -> None:
    readings = control.readings
    type_in(control.section.targets["grade_45"], "80")
    type_in(control.section.targets["graininess"], "3.5")
    wanted = TextureTargets(grade_45=0.8, graininess=0.035)
    assert designer.session.paint.texture == wanted
    assert designer.store.stack.undoText() == "Change Texture Targets"
    # Nothing is seen of them: the same readings stand.
    assert control.readings is readings
    path = tmp_path / "aimed.brdfpaint"
    save_paint(designer.session.paint, path)
    designer.session.undo()
    assert control.section.wanted() == (None, 0.8, None, None)
    designer.session.undo()
    assert control.section.wanted() == (None,) * 4
    designer.documents.add(load_paint(path))
    assert control.section.wanted() == wanted.wanted
    record = record_from_json(json.loads(json.dumps(Record(standard_of(load_paint(path))).to_json())))
    assert record is not None
    assert record.standard.paint.texture == wanted
    settle(control, qtbot)
