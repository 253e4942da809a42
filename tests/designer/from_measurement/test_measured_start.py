"""New from a measurement: by menu, by opening, by dropping; with the report, or why a file cannot be read."""

from __future__ import annotations

from dataclasses import replace

import pytest
from brdf_designer.from_measurement.control import MeasuredControl
from brdf_designer.standard_comparison.control import StandardControl
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent

from brdf_suite.documents.store import save_paint
from brdf_suite.files.exports import FORMATS
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.pipeline.material import load_document, load_shipped_paint


@pytest.fixture
def control(program) -> MeasuredControl:
    return program.feature(MeasuredControl)


@pytest.fixture
def cook_torrance(tmp_path):
    """A paint of Cook-Torrance lobes in a file."""
    path = tmp_path / "lobes.brdfpaint"
    save_paint(replace(load_document("table1_blue"), name="Lobes"), path)
    return path


def wait_for(qtbot, control) -> None:
    qtbot.waitUntil(lambda: control.start_of_front() is not None)


def test_a_measured_file_by_the_menu(program, control, asked, qtbot, shared_data) -> None:
    asked.path = shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf"
    assert control.host.isHidden()
    control.action.trigger()
    wait_for(qtbot, control)
    paint = program.session.paint
    assert paint.name == "vch_golden_yellow_rgb"
    assert paint.lab_at(15.0) == pytest.approx((101.13, 8.09, 76.7), abs=0.01)
    assert not program.store.is_clean
    section = control.section
    assert not control.host.isHidden()
    assert "17.9 GU 20°" in section.gloss.text()
    # 25 to 105° under the light of the instrument but for 45°, and further angles under the two others.
    assert section.table.rowCount() == 10
    assert section.table.item(1, 1).text() == f"{control.start_of_front().under(45.0)[0].delta_e_2000:.1f}"
    assert "not used" in section.summary.text()
    assert any("flakes" in line for line in section.notices.text().splitlines())
    assert program.window.progress.jobs == ()


def test_a_paint_of_lobes_is_opened_and_read_again_at_more_angles(
    program, control, qtbot, cook_torrance
) -> None:
    program.window.open_requested.emit(cook_torrance)
    wait_for(qtbot, control)
    before = program.session.paint
    assert before.name == "Lobes"
    assert before.gloss.gu_20 == pytest.approx(31.2, abs=0.1)
    assert program.store.path is None
    assert cook_torrance.absolute() in program.files.recent()
    angles = control.section.angles
    angles.setCurrentIndex(angles.findData("five"))
    angles.activated.emit(angles.currentIndex())
    qtbot.waitUntil(lambda: len(program.session.paint.measurements) == 5)
    assert program.window.undo_action.text() == "&Undo Measure Again"
    program.window.undo_action.trigger()
    assert program.session.paint is before
    # The report stays with its tab.
    program.window.new_requested.emit()
    assert control.host.isHidden()
    program.documents.show(program.documents.row[0])
    assert not control.host.isHidden()


def test_a_dropped_file_and_the_original_as_standard(program, control, qtbot, cook_torrance) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(cook_torrance))])
    program.window.dropEvent(
        QDropEvent(
            QPointF(50, 50),
            Qt.DropAction.CopyAction,
            data,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
        )
    )
    wait_for(qtbot, control)
    standards = program.feature(StandardControl)
    control.section.standard.click()
    qtbot.waitUntil(lambda: standards.standard is not None)
    assert standards.section.results.item(0, 1).text() == "0.00"


def test_a_handed_over_file_opens_its_paints(program, control, qtbot, tmp_path) -> None:
    path = tmp_path / "season.cxf"
    form = next(known for known in FORMATS if known.ending == ".cxf")
    blue, red = load_shipped_paint("blue"), load_shipped_paint("red")
    form.write([ExportItem(blue), ExportItem(red)], path, None)
    program.window.open_requested.emit(path)
    qtbot.waitUntil(lambda: program.reading.is_idle)
    opened = [one.store.value for one in program.documents.row]
    assert [paint.name for paint in opened] == [blue.name, red.name]
    assert opened[1].lab_at(45.0) == pytest.approx(red.lab_at(45.0), abs=1e-3)
    path.write_text(path.read_text("utf-8")[:-300], "utf-8")
    program.window.open_requested.emit(path)
    qtbot.waitUntil(lambda: program.reading.is_idle)
    assert "season.cxf" in program.window.messages.shown()["open"].what
    assert len(program.documents.row) == 2


def test_an_instruments_export_by_the_menu_and_as_standard(program, control, asked, qtbot, tmp_path) -> None:
    asked.path = tmp_path / "export.csv"
    asked.path.write_text(
        "Name;L*15;a*15;b*15;L*45;a*45;b*45;L*110;a*110;b*110;G\n"
        "Silver;120,5;0;-1;62;0;-1,5;38;0;-2;3,1\nSilver;120,7;0;-1;62;0;-1,5;38;0;-2;3,3\n"
        "Blue;40;1;-30;25;2;-28;10;3;-20;2\n",
        "utf-16",
    )
    control.action.trigger()
    qtbot.waitUntil(lambda: program.reading.is_idle)
    silver, blue = (one.store.value for one in program.documents.row)
    assert (silver.name, blue.name) == ("Silver", "Blue")
    assert silver.lab_at(15.0) == pytest.approx((120.6, 0.0, -1.0))
    assert "graininess 3.2" in silver.notes
    assert "mean of 2 measurements" in program.window.messages.shown()["open"].what
    standards = program.feature(StandardControl)
    standards.load(asked.path)
    qtbot.waitUntil(lambda: standards.standard is not None)
    assert standards.standard.name == "Silver"
    assert standards.standard.gloss is None


def test_what_is_neither_is_reported(program, control, qtbot, tmp_path) -> None:
    text = tmp_path / "notes.txt"
    text.write_text("nothing measured")
    program.window.open_requested.emit(text)
    qtbot.waitUntil(lambda: program.reading.is_idle)
    assert "notes.txt" in program.window.messages.shown()["open"].what
    broken = tmp_path / "broken.bsdf"
    broken.write_bytes(b"tensor_file\0\1\0" + b"\xff" * 40)
    before = program.session.paint
    program.window.open_requested.emit(broken)
    qtbot.waitUntil(lambda: "broken.bsdf" in program.window.messages.shown()["open"].what)
    assert program.session.paint is before
    assert program.window.progress.jobs == ()


def test_every_kind_of_material_is_opened(program, materials, qtbot) -> None:
    for asked in materials.values():
        before = program.store.value
        program.open(asked)
        qtbot.waitUntil(lambda before=before: program.store.value is not before)


def test_readings_that_no_sample_supports_are_marked(program, control, qtbot, shared_data) -> None:
    program.window.open_requested.emit(shared_data / "brdf" / "bird_example.json")
    wait_for(qtbot, control)
    section = control.section
    assert "15° (47°), 45° (35°), 110° (74°)" in section.support.text()
    assert "† No sample of the original within 10°" in section.support.text()
    assert section.table.item(1, 1).text().endswith("†")
    program.window.open_requested.emit(shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf")
    qtbot.waitUntil(
        lambda: control.start_of_front() is not None and "vch" in control.start_of_front().paint.name
    )
    assert section.support.text() == ""
    assert "†" not in section.table.item(1, 1).text()
