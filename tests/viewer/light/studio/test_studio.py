"""The studio editor in the running Viewer: begin, edit, drag, undo, save, and the picture that follows."""

from __future__ import annotations

import dataclasses
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.program.settings import state_folder
from brdf_qt.window.dialogs import Answer, Overwrite
from brdf_viewer.export.job import FORMATS, ExportSettings
from brdf_viewer.light.studio.panel import lamp_line
from PySide6.QtCore import QCoreApplication, QPoint, QPointF, Qt
from PySide6.QtGui import QKeySequence, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QWidget

from brdf_suite.documents.studio import Backdrop, Sky, Studio, StudioLamp, load_light, save_light
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.files.images.environments import write_exr
from brdf_suite.pipeline.environments import draw_light

PLAIN = Studio("Plain", (StudioLamp("box", (0.0, 2.0, 2.0), (1.0, 1.0)),), None, Backdrop(luminance=0.2))


class Script:
    """Answers what the program asks."""

    def __init__(self) -> None:
        self.answer, self.save_to, self.asked = Answer.DISCARD, None, []

    def unsaved(self, name: str) -> Answer:
        self.asked.append(name)
        return self.answer

    def changed_file(self, path: Path) -> Overwrite:
        return Overwrite.OVERWRITE

    def open_path(self, folder: Path, filters: str) -> Path | None:
        return None

    def save_path(self, suggested: Path, filters: str) -> Path | None:
        return self.save_to


@pytest.fixture
def script() -> Script:
    return Script()


def lit_by(path: Path) -> View:
    """A sphere in the light of a file, without single flakes."""
    return View(environment=str(path), surface="sphere", sparkle=Sparkle(mode="off"))


@pytest.fixture
def edited(start, script, tmp_path, qtbot):
    """A Viewer whose studio of one lamp is open in the editor."""
    path = tmp_path / "plain.brdfstudio"
    save_light(PLAIN, path)
    viewer = start(dialogs=script, size=(900, 640), view=lit_by(path))
    viewer.window.environment.edit.click()
    viewer.wait_idle()
    viewer.path, viewer.control, viewer.panel = path, viewer.controller.studio, viewer.window.studio
    assert viewer.window.studio_dock.isVisible()
    return viewer


def settle(viewer) -> None:
    """Wait until the whole light is in the picture."""
    control = viewer.controller.studio
    viewer.qtbot.waitUntil(
        lambda: (
            control.is_lit()
            and viewer.state.environment.value.is_final
            and viewer.state.environment.value.name == control.store.value.name
        )
    )


def value(viewer) -> Studio:
    return viewer.controller.studio.store.value


def test_a_studio_is_begun_from_a_template(start, script, qtbot) -> None:
    viewer = start(dialogs=script)
    view, before = viewer.view, viewer.pixels()
    assert viewer.window.studio_dock.isHidden()
    saving = [action for action in viewer.window.commands.studio.actions() if "ave Studio" in action.text()]
    assert len(saving) == 2
    assert not any(action.isEnabled() for action in saving)  # nothing is open
    assert viewer.controller.studio.new("three")
    panel = viewer.window.studio
    assert panel.list.count() == 3
    assert panel.state.text() == "Not saved to a file yet"
    seen = []
    viewer.state.contents_changed.emit()  # as of a paint or a surface: the light goes on being drawn
    viewer.state.contents_changed.connect(lambda: seen.append(viewer.state.environment.value))
    settle(viewer)
    seen = [light.draft for light in seen if light.name == "My studio"]
    assert seen[0] is True  # a draft first
    assert seen[-1] is False
    assert viewer.window.status.cell("environment").text() == "My studio"
    assert viewer.view == view  # it cannot name what no file holds
    assert not np.array_equal(viewer.pixels()[:100, :100], before[:100, :100])
    assert not panel.preview.panorama.isNull()
    assert viewer.controller.studio.may_close()
    assert script.asked == []  # nothing of the user's would be lost
    panel.lamp.luminance.setValue(9.0)
    script.answer = Answer.CANCEL
    assert not viewer.controller.studio.may_close()
    assert script.asked == ["My studio"]
    script.answer = Answer.DISCARD


def test_fields_of_a_lamp_are_edits_that_can_be_undone(edited) -> None:
    form, panel = edited.panel.lamp, edited.panel
    dark = edited.state.environment.value.environment.average()
    form.azimuth.setValue(90.0)
    assert value(edited).lamps[0].position_m == pytest.approx((2.0, 2.0, 0.0))
    form.first.setValue(60.0)
    assert value(edited).lamps[0].size_m[0] == pytest.approx(2 * 8**0.5 * np.tan(np.radians(30)))
    form.luminance.setValue(50.0)
    form.colour.neutral.click()
    form.colour.kelvin.setValue(3000.0)
    assert value(edited).lamps[0].colour_temperature_k == 3000.0
    assert panel.list.item(0).text() == lamp_line(0, value(edited).lamps[0])
    assert panel.state.text() == "plain.brdfstudio, changed"
    settle(edited)
    warm = edited.state.environment.value.environment.average()
    assert warm[0] / warm[2] > 1.3 * dark[0] / dark[2]
    for _ in range(10):
        panel.undo.click()
    assert value(edited) == PLAIN
    assert form.azimuth.value() == 0.0
    assert panel.state.text() == "plain.brdfstudio"
    panel.redo.click()
    assert value(edited).lamps[0].position_m == pytest.approx((2.0, 2.0, 0.0))


def test_what_cannot_be_is_reported_and_the_field_goes_back(edited) -> None:
    panel = edited.panel
    panel.add_requested.emit("ring")
    assert panel.list.currentRow() == 1
    before = value(edited)
    panel.lamp.second.setValue(80.0)  # a band wider than half of the ring
    assert value(edited) == before
    assert "band" in panel.mistake.text()
    assert panel.lamp.second.value() < 20.0
    panel.lamp.second.setValue(5.0)
    assert panel.mistake.text() == ""
    panel.name.edited.emit("")
    assert "name" in panel.mistake.text()
    assert value(edited).name == "Plain"


def test_lamps_are_added_doubled_and_removed(edited) -> None:
    panel = edited.panel
    panel.add_requested.emit("strip")
    panel.double.click()
    assert [lamp.shape for lamp in value(edited).lamps] == ["box", "strip", "strip"]
    assert panel.list.currentRow() == 2
    panel.list.setCurrentRow(0)
    panel.remove.click()
    assert [lamp.shape for lamp in value(edited).lamps] == ["strip", "strip"]
    panel.remove.click()
    panel.remove.click()
    assert value(edited).lamps == ()
    assert panel.lamp.isHidden()
    panel.around.backdrop_luminance.setValue(0.0)  # nothing would give light
    assert "nothing gives light" in panel.mistake.text()


def test_a_lamp_is_clicked_and_dragged_in_the_panorama(edited, qtbot) -> None:
    edited.panel.add_requested.emit("box")
    preview = edited.panel.preview
    qtbot.waitUntil(lambda: preview.width() > 100)
    steps, before = edited.control.store.stack.index(), value(edited).lamps[0]
    start = preview.place_of(0).toPoint()
    assert preview.lamp_at(QPointF(start)) == 0
    QTest.mousePress(preview, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, start)
    assert edited.panel.list.currentRow() == 0
    for dx in range(0, 41, 8):
        QTest.mouseMove(preview, start + QPoint(dx, dx // 2))
        qtbot.wait(5)
    QTest.mouseRelease(
        preview, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, start + QPoint(40, 20)
    )
    after = value(edited).lamps[0]
    there = preview.place_of(0)
    assert (there.x(), there.y()) == pytest.approx((start.x() + 40, start.y() + 20), abs=1.5)
    assert np.linalg.norm(after.position_m) == pytest.approx(np.linalg.norm(before.position_m))
    assert edited.control.store.stack.index() == steps + 1
    edited.panel.undo.click()
    assert value(edited).lamps[0] == before
    empty = QPoint(4, preview.height() - 4)
    assert preview.lamp_at(QPointF(empty)) == -1
    QTest.mouseClick(preview, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, empty)
    assert edited.panel.lamp.isHidden()


def test_the_wheel_sizes_a_lamp_and_arrow_keys_move_it(edited, qtbot) -> None:
    preview = edited.panel.preview
    qtbot.waitUntil(lambda: preview.width() > 100)
    place, before = preview.place_of(0), value(edited).lamps[0]
    event = QWheelEvent(
        place,
        preview.mapToGlobal(place),
        QPoint(),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(preview, event)
    assert value(edited).lamps[0] == before
    preview.setFocus()
    qtbot.waitUntil(preview.hasFocus)
    QApplication.sendEvent(preview, event)
    assert value(edited).lamps[0].size_m[0] > before.size_m[0]
    QTest.keyClick(preview, Qt.Key.Key_Up)
    assert value(edited).lamps[0].position_m[1] > before.position_m[1]


def test_a_room_is_edited_and_keeps_its_lamps(edited) -> None:
    around = edited.panel.around
    around.edits.changed.emit("around", "room")
    assert value(edited).room is not None
    around.room["wall_albedo"].setValue(0.8)
    assert value(edited).room.wall_albedo == 0.8
    edited.panel.lamp.distance.setValue(90.0)  # as far as the wall
    assert value(edited).room.holds(value(edited).lamps[0].position_m)
    around.room["height_m"].setValue(1.2)  # the lamp would be above the ceiling
    assert "room" in edited.panel.mistake.text()


def test_a_sky_is_edited_and_its_sun_dragged(start, script, tmp_path, qtbot) -> None:
    path = tmp_path / "sky.brdfstudio"
    save_light(Sky("s"), path)
    viewer = start(dialogs=script, view=lit_by(path))
    assert viewer.controller.studio.edit()
    viewer.wait_idle()
    panel = viewer.window.studio
    assert panel.list.isHidden() or not panel.list.isVisible()
    panel.preview.dragged.emit(0, -30.0, 20.0)
    sky = viewer.controller.studio.store.value
    assert (sky.sun_azimuth_deg, sky.sun_elevation_deg) == (-30.0, 20.0)
    panel.sky.turbidity.setValue(6.0)
    panel.sky.edits.changed.emit("model", "overcast")
    assert viewer.controller.studio.store.value == dataclasses.replace(sky, turbidity=6.0, model="overcast")
    assert not panel.sky.elevation.isEnabled()


def test_it_is_saved_and_then_named_by_the_view(start, script, tmp_path, qtbot) -> None:
    viewer = start(dialogs=script)
    control = viewer.controller.studio
    control.new("empty")
    settle(viewer)
    form = FORMATS["picture"][0]
    viewer.controller.export.export(ExportSettings("picture", form, (64, 48)))
    assert "unsaved changes" in viewer.messages()["export"]  # an export would read another light
    script.save_to = tmp_path / "mine.brdfview"
    assert viewer.controller.views.save()
    assert "unsaved edits" in viewer.messages()["view"]  # a view cannot name it
    script.save_to = tmp_path / "mine.brdfstudio"
    viewer.window.studio.save.click()
    assert not viewer.state.edited_light
    assert load_light(script.save_to) == control.store.value
    assert viewer.view.environment == str(script.save_to)
    assert viewer.window.studio.state.text() == "mine.brdfstudio"
    assert viewer.window.status.cell("environment").text() == "mine.brdfstudio"
    viewer.wait_idle()
    assert viewer.state.environment.key == str(script.save_to)
    assert control.may_close()
    assert script.asked == []


def test_a_folder_that_cannot_be_written_is_reported(edited, script, tmp_path) -> None:
    (tmp_path / "file").write_text("")
    script.save_to = tmp_path / "file" / "x.brdfstudio"
    edited.panel.lamp.luminance.setValue(9.0)
    edited.panel.save_as.click()
    assert "save" in edited.messages()
    assert edited.panel.state.text() == "plain.brdfstudio, changed"


def test_unsaved_changes_are_asked_about(edited, script) -> None:
    edited.panel.lamp.luminance.setValue(9.0)
    script.answer = Answer.CANCEL
    assert not edited.controller.studio.new("three")
    assert not edited.window.close()
    assert edited.window.isVisible()
    assert script.asked == ["plain.brdfstudio"] * 2
    assert value(edited).lamps[0].luminance == 9.0
    script.answer = Answer.SAVE
    assert edited.controller.studio.new("three")
    assert load_light(edited.path).lamps[0].luminance == 9.0
    script.answer = Answer.DISCARD


def test_another_light_takes_the_picture_and_gives_it_back(edited, lights) -> None:
    assert edited.panel.relight.isHidden()
    edited.controller.open_file(str(lights["bright"]))
    edited.wait_idle()
    assert edited.state.environment.key == str(lights["bright"])
    assert not edited.panel.relight.isHidden()
    assert not edited.window.environment.edit.isEnabled()
    edited.panel.relight.click()
    settle(edited)
    assert edited.panel.relight.isHidden()
    assert edited.view.environment == str(edited.path)


def test_a_draft_of_another_studio_does_not_reach_the_light_that_is_edited(edited) -> None:
    seen = []
    edited.state.contents_changed.connect(lambda: seen.append(edited.state.environment.value.name))
    assert edited.control.new("three")
    edited.window.environment.edit.click()
    edited.qtbot.waitUntil(lambda: value(edited) == PLAIN)
    edited.panel.lamp.luminance.setValue(9.0)
    settle(edited)
    assert set(seen) == {"Plain"}


def test_keys_of_the_panel_are_the_documents(edited, qtbot) -> None:
    steps = edited.state.history.steps
    edited.panel.lamp.luminance.setValue(9.0)
    edited.panel.list.setFocus()
    QTest.keySequence(edited.panel.list, QKeySequence(QKeySequence.StandardKey.Undo))
    assert value(edited) == PLAIN
    assert edited.state.history.steps == steps
    edited.panel.lamp.luminance.setValue(7.0)
    QTest.keySequence(edited.panel.list, QKeySequence(QKeySequence.StandardKey.Save))
    assert load_light(edited.path).lamps[0].luminance == 7.0


def test_a_studio_that_is_slow_to_read_holds_nothing_up_and_is_cancelled(edited, slow) -> None:
    reader = slow(edited.control.files, "read")
    assert edited.control.new("three")
    edited.window.environment.edit.click()
    edited.qtbot.waitUntil(reader.begun.is_set)
    assert edited.panel.name.text() != "Plain"
    strip = edited.window.progress
    edited.qtbot.waitUntil(strip.isVisible)
    button = next(one for one in strip.findChildren(QAbstractButton) if one.isVisible())
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert edited.control.is_idle
    reader.go.set()
    edited.qtbot.wait(100)
    assert value(edited) != PLAIN
    edited.window.environment.edit.click()
    edited.qtbot.waitUntil(lambda: value(edited) == PLAIN)


def test_a_studio_that_is_read_too_late_leaves_one_that_was_made_meanwhile(edited, slow) -> None:
    reader = slow(edited.control.files, "read")
    assert edited.control.new("three")
    edited.window.environment.edit.click()
    edited.qtbot.waitUntil(reader.begun.is_set)
    assert edited.control.new("tunnel")
    made = value(edited)
    reader.go.set()
    edited.qtbot.waitUntil(lambda: edited.control.is_idle)
    settle(edited)
    assert value(edited) == made != PLAIN


def test_an_image_has_no_lamps_to_edit(start, script, tmp_path) -> None:
    path = tmp_path / "x.exr"
    write_exr(path, np.ones((8, 16, 3), np.float32))
    viewer = start(dialogs=script, view=lit_by(path))
    assert not viewer.controller.studio.edit()
    assert "image" in viewer.messages()["studio"]


def test_only_the_newest_of_many_edits_is_drawn_last(edited) -> None:
    for luminance in range(1, 30):
        edited.panel.lamp.luminance.setValue(float(luminance))
        QApplication.processEvents()
    settle(edited)
    drawn = edited.state.environment.value.environment.radiance
    assert np.array_equal(drawn, draw_light(value(edited)).radiance)


def test_unsaved_work_of_a_killed_run_is_offered_and_taken(start, script, qtbot) -> None:
    """A process dies with a changed studio; the window that comes after it gives it back."""
    code = (
        "import os\n"
        "from PySide6.QtCore import QCoreApplication\n"
        "from brdf_qt.documents.open_document import DocumentStore\n"
        "from brdf_qt.documents.recovery import Recovery\n"
        "from brdf_viewer.light.studio.document import FORMAT\n"
        "app = QCoreApplication([])\n"
        f"QCoreApplication.setApplicationName({QCoreApplication.applicationName()!r})\n"
        "store = DocumentStore(FORMAT.new())\n"
        "recovery = Recovery(store, FORMAT, print)\n"
        "store.replace(FORMAT.from_json(FORMAT.to_json(FORMAT.new()) | {'name': 'Lost and found'}, 'x'), None,"
        " clean=False)\n"
        "assert recovery.write()\n"
        "os.kill(os.getpid(), 9)\n"
    )
    died = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True)
    assert died.returncode == -signal.SIGKILL, died.stderr
    viewer = start(dialogs=script, size=(900, 640))
    assert "Lost and found" in viewer.messages()["recovery"]
    assert viewer.window.studio_dock.isHidden()
    viewer.window.findChild(QWidget, "message_action_Recover").click()
    assert viewer.messages() == {}
    assert viewer.window.studio_dock.isVisible()
    assert value(viewer).name == "Lost and found"
    assert not viewer.controller.studio.store.is_clean
    script.answer = Answer.CANCEL
    assert not viewer.controller.studio.may_close()  # it is asked about like any unsaved work
    script.answer = Answer.DISCARD
    folder = state_folder("autosave")
    assert len(list(folder.glob("*.recovery.json"))) == 1
    viewer.close()
    assert list(folder.glob("*.recovery.json")) == []
