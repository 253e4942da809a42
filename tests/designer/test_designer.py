"""Designer driven through its real widgets."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from brdf_designer.assembly import Designer
from brdf_qt.link.link import LiveLink
from brdf_qt.window.command_palette import commands
from brdf_qt.window.dialogs import Answer
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.documents.paint import Measurement
from brdf_suite.documents.store import load_paint, paint_from_json, save_paint
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.instruments.glossmeter import total_gloss


@pytest.fixture
def designer(program) -> Designer:
    """The Designer of the module: a window of its own for each test would take most of the time."""
    return program


@pytest.fixture
def dialogs(asked) -> object:
    """What its questions for files are answered with."""
    return asked


def action(designer, path: str):
    return dict(commands(designer.window))[path]


def slider(designer, index: int, component: int):
    return designer.window.editors.editors[index].sliders[component]


def field(designer, index: int, component: int):
    return designer.window.editors.editors[index].fields[component]


def drag(widget, distances: list[int]) -> None:
    low, high = widget.positions()[[0, -1]]
    start = QPoint(round(widget.width() * (widget.amount() - low) / (high - low)), widget.height() // 2)
    QTest.mousePress(widget, Qt.MouseButton.LeftButton, pos=start)
    for dx in distances:
        place = start + QPoint(dx, 0)
        event = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(place),
            QPointF(widget.mapToGlobal(place)),
            Qt.MouseButton.NoButton,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
        )
        QApplication.sendEvent(widget, event)
    QTest.mouseRelease(widget, Qt.MouseButton.LeftButton, pos=start + QPoint(distances[-1], 0))


def type_in(number, text: str) -> None:
    number.setFocus()
    number.selectAll()
    QTest.keyClicks(number, text)
    QTest.keyClick(number, Qt.Key.Key_Return)


def test_a_drag_on_a_slider_is_one_step_with_its_name(designer):
    before = designer.store.value
    drag(slider(designer, 0, 0), [5, 9, 14, 20])
    assert designer.store.value.lab_at(15.0)[0] > before.lab_at(15.0)[0]
    assert designer.store.stack.count() == 1
    assert designer.window.undo_action.text() == "&Undo Change L* at 15°"
    designer.window.undo_action.trigger()
    assert designer.store.value == before
    assert designer.window.redo_action.text() == "&Redo Change L* at 15°"
    assert not designer.window.undo_action.isEnabled()


def test_a_typed_number_moves_slider_patch_curve_and_readouts(designer):
    window = designer.window
    patch = window.patches.patches[1].field
    before = patch.grab().toImage().pixelColor(30, 30)
    flop = window.status.cell("Flop index").text()
    type_in(field(designer, 1, 0), "40")
    assert designer.store.value.lab_at(45.0) == (40.0, 4.0, -38.0)
    assert slider(designer, 1, 0).amount() == 40.0
    after = patch.grab().toImage().pixelColor(30, 30)
    assert after.lightness() > before.lightness()
    assert window.status.cell("Flop index").text() != flop
    window.plot.draw_now()
    assert window.plot.plots[0].points[1].pos().y() == 40.0
    assert "40.0" in window.patches.patches[1].numbers.text()


def test_undo_by_keyboard_reaches_the_document_from_a_number_field(own_designer, qtbot):
    number = field(own_designer, 2, 1)
    type_in(number, "12")
    number.setFocus()
    QTest.keySequence(number, "Ctrl+Z")
    assert own_designer.store.value == load_shipped_paint("blue")
    assert number.value() == 8.0


def test_a_point_of_the_plot_is_dragged_as_one_step(designer):
    point = designer.window.plot.plots[0].points[1]

    class Drag:
        def __init__(self, y: float, start: bool = False, finish: bool = False) -> None:
            self.y, self.start, self.finish = y, start, finish

        def button(self):
            return Qt.MouseButton.LeftButton

        def accept(self) -> None:
            pass

        def pos(self):
            return point.mapFromParent(QPointF(45.0, self.y))

        # The names are those of pyqtgraph's event.
        def buttonDownPos(self):  # noqa: N802
            return point.mapFromParent(QPointF(45.0, 25.0))

        def isStart(self) -> bool:  # noqa: N802
            return self.start

        def isFinish(self) -> bool:  # noqa: N802
            return self.finish

    point.mouseDragEvent(Drag(26.0, start=True))
    point.mouseDragEvent(Drag(35.0))
    point.mouseDragEvent(Drag(33.0, finish=True))
    assert designer.store.value.lab_at(45.0)[0] == pytest.approx(33.0)
    assert designer.store.stack.count() == 1


def test_the_picker_is_one_step_and_does_not_stop_the_work(designer, qtbot):
    designer.window.editors.editors[1].swatch.click()
    dialog = designer.window.pickers.dialogs[1]
    assert not dialog.isModal()
    for name in ("#808080", "#c02020"):
        dialog.setCurrentColor(QColor(name))
    patch = designer.window.patches.patches[1].field
    assert patch.grab().toImage().pixelColor(30, 30).name() == "#c02020"
    dialog.close()
    assert designer.window.pickers.dialogs == {}
    assert [designer.store.stack.text(i) for i in range(designer.store.stack.count())] == [
        "Pick Colour at 45°"
    ]


def test_the_picker_shows_the_paint_and_changes_nothing_by_opening(designer):
    designer.window.pick_colour(0)
    shown = designer.window.pickers.dialogs[0].currentColor()
    patch = designer.window.patches.patches[0].field.grab().toImage().pixelColor(30, 30)
    assert shown == patch
    designer.window.pickers.dialogs[0].close()
    assert designer.store.is_clean


def test_a_picker_goes_with_its_document(designer):
    designer.window.pick_colour(0)
    designer.documents.new()
    assert designer.window.pickers.dialogs == {}
    assert designer.store.is_clean


def test_an_unreachable_gloss_is_reported_in_the_window_and_mended(designer, qtbot):
    window = designer.window
    qtbot.waitUntil(lambda: designer.controller.is_idle)
    strip = window.strip.band.grab().toImage()
    gloss = window.coat.daily.fields["gloss.gu_20"]
    type_in(gloss, "199")
    assert designer.store.value.gloss.gu_20 == 199.0
    assert "199 GU" in window.messages.shown()["fit"].what
    assert "last possible paint" in window.strip.caption.text()
    assert window.strip.band.grab().toImage() == strip
    assert window.status.cell("Fit").text().startswith("(")
    for width in (720, 1400):  # captions are chosen anew when the window changes
        window.resize(width, 800)
        assert any(word in window.plot.caption.text() for word in ("last possible paint", "Earlier"))
        assert "last possible paint" in window.plot.caption.accessibleName()
    type_in(gloss, "88")
    qtbot.waitUntil(lambda: designer.controller.is_idle)
    assert "last possible paint" not in window.plot.caption.accessibleName()
    assert window.messages.shown() == {}
    assert "last possible paint" not in window.strip.caption.text()


def test_the_60_degree_reading_is_optional(designer):
    coat = designer.window.coat
    type_in(coat.daily.fields["gloss.gu_20"], "40")
    assert not coat.panel.fields["gloss.gu_60"].isEnabled()
    # At once, before the work that is done at idle: the reading is of this paint, and not of the one before.
    _, due = total_gloss(designer.session.fit.reflectance.base, designer.session.fit.reflectance.coat)
    coat.has_60.click()
    assert designer.store.value.gloss.gu_60 == pytest.approx(due, abs=0.06)
    designer.session.undo()
    designer.session.undo()
    coat.has_60.click()
    # What the coat reads at 60° as it is: switching the reading on changes nothing of the look.
    assert designer.store.value.gloss.gu_60 == pytest.approx(94.6, abs=0.06)
    assert coat.panel.fields["gloss.gu_60"].isEnabled()
    designer.session.undo()
    assert designer.store.value.gloss.gu_60 is None
    assert not coat.has_60.isChecked()


def test_flakes_and_model_are_edited(designer):
    window = designer.window
    type_in(window.flakes.daily.fields["flakes.size_um"], "33")
    assert designer.store.value.flakes.size_um == 33.0
    window.flakes.has_flakes.click()
    assert designer.store.value.flakes is None
    window.flakes.has_flakes.click()
    assert designer.store.value.flakes.size_um == 33.0
    window.model.rule.setCurrentIndex(1)
    window.model.rule.activated.emit(1)
    assert designer.store.value.interpolation == "monotone"


def test_the_unmeasured_range_is_shown_by_the_nearest_angle_on_either_side(designer):
    paint = designer.store.value
    both_sides = (*paint.measurements, Measurement(45.0, -20.0, (50.0, 0.0, 0.0)))
    designer.store.replace(replace(paint, measurements=both_sides), None)
    assert "than 15°" in designer.window.model.note.text()


def test_a_shipped_name_is_that_paint_as_for_the_command(designer, qtbot, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "copper").write_text("a file of that name")
    designer.open("copper")
    assert designer.store.value.name == "Copper"
    designer.open("x" * 300)
    qtbot.waitUntil(lambda: "open" in designer.window.messages.shown())
    assert "annot be read" in designer.window.messages.shown()["open"].what
    assert designer.store.value.name == "Copper"


def test_a_measured_paint_of_table_1_is_measured_and_a_design_starts_from_it(designer, qtbot):
    designer.open("table1_blue")
    qtbot.waitUntil(lambda: "table1_blue" in designer.store.value.source)
    assert not designer.store.is_clean
    assert designer.store.path is None
    designer.open("table1_blau")
    qtbot.waitUntil(lambda: "open" in designer.window.messages.shown())
    what = designer.window.messages.shown()["open"].what
    assert "did you mean table1_blue" in what


def test_a_name_typed_is_one_step(designer):
    line = designer.window.texts.name
    line.setFocus()
    line.selectAll()
    QTest.keyClicks(line, "Midnight")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert designer.store.value.name == "Midnight"
    assert designer.store.stack.count() == 1


def test_save_and_reopen_give_the_identical_paint(designer, dialogs, tmp_path):
    type_in(field(designer, 0, 2), "-40.25")
    edited = designer.store.value
    dialogs.path = tmp_path / "mine"
    action(designer, "File ▸ Save").trigger()
    assert load_paint(tmp_path / "mine.brdfpaint") == edited
    assert not designer.window.isWindowModified()
    action(designer, "File ▸ New").trigger()
    assert designer.store.value.name == "Untitled"
    action(designer, "File ▸ Open Recent ▸ 1 mine.brdfpaint").trigger()
    assert designer.store.value == edited
    assert designer.window.windowTitle().startswith("mine.brdfpaint")


@pytest.mark.parametrize("answer", list(Answer))
def test_closing_asks_about_unsaved_changes(own_designer, dialogs, tmp_path, own_session, answer):
    type_in(field(own_designer, 0, 0), "70")
    dialogs.answer, dialogs.path = answer, tmp_path / "saved"
    closed = own_designer.window.close()
    assert dialogs.asked == ["Blue"]
    assert closed == (answer is not Answer.CANCEL)
    assert (tmp_path / "saved.brdfpaint").exists() == (answer is Answer.SAVE)
    left = list(own_session.rglob("*.recovery.json"))
    assert answer is Answer.CANCEL or left == []


def test_a_paint_that_another_program_changed_is_not_written_over(designer, dialogs, tmp_path):
    dialogs.path = tmp_path / "mine"
    action(designer, "File ▸ Save").trigger()
    save_paint(load_shipped_paint("red"), tmp_path / "mine.brdfpaint")
    type_in(field(designer, 0, 0), "70")
    action(designer, "File ▸ Save").trigger()
    assert dialogs.asked == ["changed mine.brdfpaint"]
    assert load_paint(tmp_path / "mine.brdfpaint") == load_shipped_paint("red")
    assert designer.window.isWindowModified()


@pytest.mark.parametrize("cure", ["edit", "undo", "save", "new"])
def test_the_message_of_a_failed_save_leaves_when_it_is_no_longer_so(designer, dialogs, tmp_path, cure):
    type_in(field(designer, 0, 0), "70")
    dialogs.path = tmp_path / "missing" / "mine"
    action(designer, "File ▸ Save").trigger()
    assert "save" in designer.window.messages.shown()
    dialogs.path, dialogs.answer = tmp_path / "mine", Answer.DISCARD
    if cure == "edit":
        type_in(field(designer, 0, 0), "71")
    else:
        path = {"undo": "Edit ▸ Undo Change L* at 15°", "save": "File ▸ Save", "new": "File ▸ New"}[cure]
        action(designer, path).trigger()
    assert "save" not in designer.window.messages.shown()


def test_a_bad_file_is_reported_and_the_open_paint_stays(designer, dialogs, qtbot, tmp_path):
    bad = tmp_path / "bad.brdfpaint"
    save_paint(load_shipped_paint("red"), bad)
    content = json.loads(bad.read_text())
    content["measurements"][1]["lab"][0] = "bright"
    bad.write_text(json.dumps(content))
    before = designer.store.value
    dialogs.path = bad
    action(designer, "File ▸ Open…").trigger()
    qtbot.waitUntil(lambda: "open" in designer.window.messages.shown())
    message = designer.window.messages.shown()["open"]
    assert "measurements[1].lab[0]" in message.where
    assert designer.store.value == before


def test_a_shipped_paint_opens_as_a_document_without_a_file(designer):
    action(designer, "File ▸ Open Sample Paint ▸ Fine silver").trigger()
    assert designer.store.value == load_shipped_paint("fine_silver")
    assert designer.store.path is None
    assert "outside" in designer.window.status.cell("Gamut").text().lower()


def test_make_solid(designer):
    action(designer, "Paint ▸ Make Solid From ▸ 45°").trigger()
    assert {m.lab for m in designer.store.value.measurements} == {(25.0, 4.0, -38.0)}
    assert designer.window.status.cell("Flop index").text() == "Flop 0.0, achieved 0.0"


def test_every_edit_reaches_the_other_programs(own_designer, qtbot):
    other = LiveLink("viewer")
    heard = []
    other.received.connect(lambda topic, value: heard.append((topic, value)))
    other.start()
    qtbot.waitUntil(lambda: bool(heard))
    assert paint_from_json(heard[-1][1]) == own_designer.store.value
    qtbot.waitUntil(lambda: own_designer.window.status.cell("Link").text() == "Connected: Viewer")
    type_in(field(own_designer, 1, 0), "44")
    qtbot.waitUntil(lambda: paint_from_json(heard[-1][1]).lab_at(45.0)[0] == 44.0)
    other.close()
    qtbot.waitUntil(lambda: own_designer.window.status.cell("Link").text() == "Not connected")


def test_every_control_has_a_name_for_a_screen_reader(designer):
    from brdf_qt.fields.colour_slider import ColourSlider
    from brdf_qt.fields.number import NumberField

    controls = [*designer.window.findChildren(ColourSlider), *designer.window.findChildren(NumberField)]
    assert len(controls) >= 9 * 2 + 7
    assert all(control.accessibleName() for control in controls)
    names = [c.accessibleName() for c in controls]
    assert len(set(names)) == len(names)


def test_a_double_click_on_a_number_goes_back_to_the_opened_document(designer, tmp_path, qtbot) -> None:

    from brdf_suite.documents.store import save_paint

    file = tmp_path / "matte.brdfpaint"
    paint = load_shipped_paint("satin_blue")
    save_paint(paint, file)
    designer.documents.open(file)
    qtbot.waitUntil(lambda: designer.reading.is_idle)
    gloss = designer.window.coat.daily.fields["gloss.gu_20"]
    lightness = designer.window.editors.editors[0].fields[0]
    for field, value in ((gloss, gloss.value() + 3.0), (lightness, 20.0)):
        opened = field.value()
        field.setValue(value)
        assert field.value() != opened
        field.reset()
        assert field.value() == opened
    assert designer.store.value == paint


def test_the_end_of_the_application_finds_a_closed_designer_ended(qtbot, dialogs) -> None:
    """Its window is deleted by then, and all timers in it: in a process with several programs this comes late."""
    designer = Designer(dialogs=lambda _window: dialogs)
    designer.window.show()
    qtbot.waitUntil(lambda: designer.window.plot.is_built)
    designer.close()
    designer.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    designer.close()
