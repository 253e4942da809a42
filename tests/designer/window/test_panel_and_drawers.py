"""The tabs at the right, their folds, and the drawers over the picture: by real clicks and keys."""

from __future__ import annotations

import pytest
from brdf_designer.assembly import Designer
from brdf_designer.lobes.control import LobesControl
from brdf_qt.fields.number import NumberField
from brdf_qt.program.settings import settings
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox, QToolButton

SHARE = 0.55


@pytest.fixture
def window(program):
    """The window as a first start has it: all drawers closed, the paint in front."""
    window = program.window
    window.activateWindow()
    for drawer in window.stage.drawers.values():
        drawer.set_open(False)
    yield window
    for drawer in window.stage.drawers.values():
        drawer.set_open(True)


def test_the_picture_has_more_than_half_of_the_window(window, qtbot):
    window.resize(1920, 1080)
    window.fit_inspector()
    qtbot.waitUntil(lambda: not any(drawer.isVisible() for drawer in window.stage.drawers.values()))
    qtbot.waitUntil(lambda: window.stage.width() * window.stage.height() >= SHARE * 1920 * 1080)
    assert (window.width(), window.height()) == (1920, 1080)


@pytest.mark.parametrize(
    ("key", "title"),
    [("paint", "Paint"), ("light", "Light"), ("form", "Form"), ("compare", "Compare"), ("export", "Export")],
)
def test_a_click_brings_a_tab_to_the_front_and_that_is_remembered(window, key, title):
    button = window.panel.buttons[key]
    assert button.text() == title
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert [name for name, page in window.panel.pages.items() if page.isVisible()] == [key]
    assert [name for name, one in window.panel.buttons.items() if one.isChecked()] == [key]
    other = "light" if key == "paint" else "paint"
    QTest.mouseClick(window.panel.buttons[other], Qt.MouseButton.LeftButton)
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert settings().value("panel/page") == key


def test_the_tabs_are_reached_by_keys(window, qtbot):
    window.command("tab_form").trigger()
    assert window.panel.pages["form"].isVisible()
    assert QApplication.focusWidget() is window.panel.buttons["form"]
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Right)
    assert window.panel.pages["compare"].isVisible()


def test_what_is_not_used_daily_is_in_the_fold_and_opens_by_a_click(window, qtbot):
    page = window.panel.pages["paint"]
    gloss = window.coat.panel.fields["gloss.gu_60"]
    page.more.set_open(False)
    assert not gloss.isVisible()
    width = window.panel.width()
    QTest.mouseClick(page.more.header, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(gloss.isVisible)
    assert page.more.is_open
    # Nothing beside it has moved.
    assert window.panel.width() == width
    QTest.mouseClick(page.more.header, Qt.MouseButton.LeftButton)
    assert not gloss.isVisible()


@pytest.mark.parametrize("key", ["light", "form", "compare", "export"])
def test_a_tab_shows_few_controls_before_its_fold_is_opened(window, key):
    window.panel.show_page(key)
    page = window.panel.page
    if page.more is not None:
        page.more.set_open(False)
    rows = [
        widget
        for kind in (NumberField, QComboBox, QAbstractButton)
        for widget in page.findChildren(kind)
        if widget.isVisible() and not (widget.objectName() or "").startswith("qt_")
    ]
    # Lights and forms are a choice of several buttons each.
    choices = [one for one in rows if isinstance(one, QToolButton)]
    assert 1 <= len(rows) - len(choices) <= 8


def test_a_drawer_slides_over_the_picture_which_keeps_its_place(program: Designer, window, qtbot):
    stage = window.stage
    qtbot.waitUntil(lambda: not any(drawer.isVisible() for drawer in stage.drawers.values()))
    before = (stage.geometry(), window.patches.geometry())
    handle = next(one for one in stage.bar.findChildren(QToolButton) if one.text() == "Lobes")
    QTest.mouseClick(handle, Qt.MouseButton.LeftButton)
    drawer = stage.drawers["lobes"]
    qtbot.waitUntil(lambda: drawer.isVisible() and drawer.x() == 0)
    assert (stage.geometry(), window.patches.geometry()) == before
    assert settings().value("drawer/lobes", type=bool) is True
    QTest.mouseClick(handle, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not drawer.isVisible())
    assert settings().value("drawer/lobes", type=bool) is False


def test_the_lobes_follow_the_paint_while_their_drawer_is_open(program: Designer, window, qtbot):
    control = program.feature(LobesControl)
    window.command("drawer_lobes").trigger()
    qtbot.waitUntil(lambda: control.is_idle and control.plot.lines is not None)
    before = control.plot.lines
    # Model and lobes agree but for grazing views, and none leaves the radius.
    steep = abs(before.view_deg) < 60.0
    assert abs(before.model - before.fitted)[steep].max() < 0.05
    assert 0.0 < before.model.max() <= 1.0
    program.open("red")
    qtbot.waitUntil(lambda: control.plot.lines is not before)
    shown = control.plot.lines
    window.command("drawer_lobes").trigger()
    program.open("copper")
    qtbot.wait(60)
    assert control.plot.lines is shown


def test_drawers_at_the_bottom_make_way_where_those_at_the_left_would_be_too_low(window, qtbot):
    drawers = window.stage.drawers
    window.resize(1280, 720)
    for drawer in drawers.values():
        drawer.set_open(True)
    qtbot.waitUntil(lambda: all(drawer.reach == 1.0 for drawer in drawers.values()))
    places = {key: drawer.geometry() for key, drawer in drawers.items()}
    assert min(places["curves"].height(), places["lobes"].height()) >= 140
    assert not any(places["curves"].intersects(places[key]) for key in ("history", "paints"))
    drawers["curves"].set_open(False)
    drawers["lobes"].set_open(False)
    qtbot.waitUntil(lambda: drawers["history"].width() == window.stage.width())
