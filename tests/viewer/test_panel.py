"""The five tabs of Viewer's panel, counted and used on the real window."""

from __future__ import annotations

import pytest
from brdf_qt.program.settings import settings
from brdf_viewer.camera.turntable import Turntable
from brdf_viewer.commands import NO_TRACED
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QMenu,
    QSlider,
    QWidget,
)

MOST = 14
CONTROLS = (QAbstractButton, QComboBox, QAbstractSpinBox, QSlider, QLineEdit, QAbstractItemView)
TABS = ("paint", "light", "form", "compare", "export")


def controls(window) -> list[QWidget]:
    """Return all widgets of the panel that can be operated and are on show, tabs and folds among them."""
    found = [widget for widget in window.panel.findChildren(QWidget) if isinstance(widget, CONTROLS)]
    parts = QAbstractSpinBox, QComboBox  # which have a line and a list of their own
    return [one for one in found if one.isVisible() and not isinstance(one.parentWidget(), parts)]


def test_at_most_fourteen_controls_are_seen_at_the_start_and_behind_each_tab(start) -> None:
    window = start().window
    assert list(window.panel.pages) == list(TABS)
    assert window.panel.pages["paint"].isVisible()
    assert 5 < len(controls(window)) <= MOST
    for key in TABS:
        window.command(f"tab_{key}").trigger()
        assert window.panel.pages[key].isVisible()
        assert 5 < len(controls(window)) <= MOST


def test_what_is_for_experts_is_in_the_folds_and_in_no_menu(viewer, qtbot) -> None:
    window = viewer.window
    assert not window.fresnel.look_up.isVisible()
    window.panel.bring_in_sight(window.fresnel)
    qtbot.waitUntil(window.fresnel.look_up.isVisible)
    titles = {menu.title().replace("&", "") for menu in window.menuBar().findChildren(QMenu)}
    assert not titles & {"Fresnel", "Look-up", "Sparkle"}
    everything = {section.objectName() for section in window.panel.sections}
    for name in ("sparkle", "relief", "lighting", "tone", "environment", "fresnel", "camera", "surface"):
        assert f"section_{name}" in everything


def test_tab_fold_and_size_are_remembered(start) -> None:
    first = start(size=(1000, 640), fill=True)
    QTest.mouseClick(first.window.panel.buttons["light"], Qt.MouseButton.LeftButton)
    QTest.mouseClick(first.window.panel.pages["light"].more.header, Qt.MouseButton.LeftButton)
    QApplication.processEvents()
    size = first.window.size()
    first.close()
    settings().sync()
    from brdf_viewer.window import ViewerWindow

    again = ViewerWindow(lambda _context: None)
    assert again.panel.page is again.panel.pages["light"]
    assert again.panel.pages["light"].more.is_open
    assert not again.panel.pages["form"].more.is_open
    assert again.size() == size
    again.deleteLater()


def test_the_panel_is_used_by_the_keyboard_alone(viewer, qtbot) -> None:
    window = viewer.window
    viewer.canvas.setFocus()
    QTest.keyClick(viewer.canvas, Qt.Key.Key_F3, Qt.KeyboardModifier.ControlModifier)
    assert window.panel.pages["form"].isVisible()
    assert QApplication.focusWidget() is window.panel.buttons["form"]
    reached = []
    for _ in range(12):
        QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
        reached.append(QApplication.focusWidget())
    order = [window.surface.chooser.view, window.surface.ground, window.camera.frame]
    places = [reached.index(widget) for widget in order]
    assert places == sorted(places)
    assert window.panel.pages["form"].more.header in reached


def test_nothing_moves_with_the_mode_of_a_comparison_or_the_renderer(viewer) -> None:
    window = viewer.window
    viewer.controller.compare.choose("solid_white")
    viewer.qtbot.waitUntil(lambda: viewer.state.second is not None)
    window.panel.show_page("compare")
    places = set()
    for mode in ("side", "swipe", "difference", "blink"):
        viewer.controller.compare.set_mode(mode)
        QApplication.processEvents()
        places.add(window.panel.page.more.y())
    assert len(places) == 1
    viewer.controller.compare.set_mode("swipe")
    assert window.compare.divider.isVisible()
    assert not window.compare.scale.isVisible()


def test_what_is_said_of_b_goes_with_the_comparison(viewer) -> None:
    viewer.controller.compare.choose("solid_white")
    viewer.qtbot.waitUntil(lambda: viewer.state.second is not None)
    assert viewer.window.compare.facts.text()
    viewer.controller.compare.set_mode("off")
    assert viewer.window.compare.facts.text() == ""


def test_a_blink_changes_picture_and_label_in_one_pass(viewer, monkeypatch) -> None:
    viewer.controller.compare.choose("solid_white")
    viewer.qtbot.waitUntil(lambda: viewer.state.second is not None)
    viewer.controller.compare.set_mode("blink")
    picture, control = viewer.window.picture, viewer.controller.compare
    control._blink.stop()
    picture.frame_ms = 1e4  # so slow that other widgets go first
    QTest.qWait(100)
    drawer, seen = viewer.controller.drawer, []
    draw, before = drawer.draw, viewer.window.overlay.labels
    monkeypatch.setattr(drawer, "draw", lambda *given: seen.append(viewer.state.shows_second) or draw(*given))
    control.flip()
    assert viewer.window.overlay.labels != before
    QApplication.processEvents()  # one pass draws both
    assert seen == [viewer.state.shows_second]


def test_the_turntable_turns_for_all_the_time_that_passes(viewer) -> None:
    table = Turntable(viewer.state.history, "Turn", 90.0, viewer.controller)
    turned = []
    table.turned.connect(turned.append)
    table.set_running(True)
    QTest.qSleep(400)  # a frame that takes long
    QApplication.processEvents()
    table.set_running(False)
    assert turned[0] >= 90.0 * 0.4


def test_one_export_has_a_preview_and_a_cancel_button(viewer, qtbot) -> None:
    window, dialog = viewer.window, viewer.controller.export.dialog
    window.panel.show_page("export")
    QTest.mouseClick(window.export.export, Qt.MouseButton.LeftButton)
    assert dialog.isVisible()
    qtbot.waitUntil(lambda: not dialog.preview.image.isNull())
    first = dialog.preview.image
    assert first.width() / first.height() == pytest.approx(
        dialog.size_chosen[0] / dialog.size_chosen[1], rel=0.05
    )
    viewer.state.change_view(exposure_ev=-6.0)
    qtbot.waitUntil(lambda: dialog.preview.image != first)
    middle = first.width() // 2, first.height() // 2
    assert dialog.preview.image.pixelColor(*middle).lightness() < first.pixelColor(*middle).lightness()
    dialog.width_field.setValue(100)
    dialog.height_field.setValue(400)
    qtbot.waitUntil(lambda: dialog.preview.image.height() == 4 * dialog.preview.image.width())
    QTest.mouseClick(dialog.cancel_button, Qt.MouseButton.LeftButton)
    assert not dialog.isVisible()
    assert not viewer.controller.export.running


def test_the_dialog_writes_the_picture_on_screen_too(start, tmp_path) -> None:
    viewer = start(ask_picture=lambda _parent, _name: str(tmp_path / "seen.png"))
    dialog = viewer.controller.export.dialog
    dialog.open_for("screen")
    assert not dialog.width_field.isVisible()
    dialog.export_button.click()
    assert (tmp_path / "seen.png").is_file()


def test_a_traced_picture_is_offered_where_there_is_one_and_the_reason_where_not(viewer) -> None:
    dialog = viewer.controller.export.dialog
    dialog.open_for("picture")
    place = dialog.kind.findData("traced")
    save = viewer.window.findChild(QAction, "action_Save Traced Picture")
    assert not dialog.kind.model().item(place).isEnabled()
    assert dialog.kind.itemData(place, Qt.ItemDataRole.ToolTipRole) == NO_TRACED
    assert not save.isEnabled()
    assert NO_TRACED in save.toolTip()
    dialog.reject()


def test_the_status_bar_names_its_numbers_and_is_whole_at_900_pixels(start, qtbot) -> None:
    viewer = start(size=(900, 600))
    frame = viewer.window.status.cell("frame")
    qtbot.waitUntil(lambda: bool(frame.text()))
    assert frame.text().startswith("Frame ")
    assert frame.text().endswith(" ms")
    for name in ("frame", "fit", "exposure", "environment", "link"):
        cell = viewer.window.status.cell(name)
        assert cell.text()
        assert cell.shown_text == cell.text()
