"""Theme, messages, sections, command search, icons."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import pytest
from brdf_qt.fields.marks import Mark
from brdf_qt.program import theme
from brdf_qt.program.application import error_relay
from brdf_qt.program.icons import icon
from brdf_qt.window.command_palette import commands
from brdf_qt.window.command_search import search
from brdf_qt.window.dialogs import Answer, QtDialogs
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.window.section import Section
from brdf_qt.window.status_line import StatusLine
from brdf_qt.work.fit_error import fit_mark, is_large, large_error_tip
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon, QPalette
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QCheckBox, QDockWidget, QLabel, QMessageBox

from brdf_suite.errors import DocumentError, FileError

ACCENT = {
    QPalette.ColorRole.Highlight,
    QPalette.ColorRole.Accent,
    QPalette.ColorRole.Link,
    QPalette.ColorRole.LinkVisited,
}


@pytest.fixture
def window(qtbot) -> SuiteWindow:
    window = SuiteWindow("Trial")
    qtbot.addWidget(window)
    window.restore_layout()
    with qtbot.waitExposed(window):
        window.show()
    return window


@pytest.mark.parametrize("name", ["dark", "booth", "light"])
def test_every_grey_is_neutral_and_text_can_be_read(qapp, name):
    palette = theme.palette(name)
    for role in QPalette.ColorRole:
        if role in ACCENT or role in (QPalette.ColorRole.NColorRoles, QPalette.ColorRole.NoRole):
            continue
        colour = palette.color(role)
        assert colour.red() == colour.green() == colour.blue(), role
    for text, ground in (("WindowText", "Window"), ("Text", "Base"), ("ButtonText", "Button")):
        pair = [luminance(palette.color(getattr(QPalette.ColorRole, role))) for role in (text, ground)]
        assert (max(pair) + 0.05) / (min(pair) + 0.05) >= 4.5, (text, ground)


def luminance(colour) -> float:
    code = colour.redF()
    return code / 12.92 if code <= 0.04045 else ((code + 0.055) / 1.055) ** 2.4


@pytest.mark.parametrize(("lightness", "level"), [(0, 0), (20, 48), (50, 119), (85, 212), (100, 255)])
def test_grey_has_its_lightness(lightness, level):
    assert theme.grey(lightness).red() == level


def test_a_theme_is_remembered(qapp):
    theme.apply(qapp, "booth")
    assert theme.current() == "booth"
    assert qapp.palette().color(QPalette.ColorRole.Window) == theme.grey(50)


def test_the_theme_menu_changes_the_palette(window, qapp):
    actions = dict(commands(window))
    actions["View ▸ Theme ▸ Light (L* 85)"].trigger()
    assert qapp.palette().color(QPalette.ColorRole.Window) == theme.grey(85)


def test_an_unhandled_error_is_shown_in_the_window(window):
    error_relay().report(ValueError("boom"))
    assert "boom" in window.messages.shown()["fault"].what
    assert window.messages.isVisible()


def test_a_message_replaces_the_one_with_its_key_and_goes(window):
    window.messages.show_message(Message("k", "one"))
    window.messages.show_message(Message("k", "two"))
    assert [m.what for m in window.messages.shown().values()] == ["two"]
    window.messages.dismiss("k")
    assert not window.messages.isVisible()


def test_several_messages_leave_the_picture_its_room(window, qtbot):
    where, todo = (
        "/a/folder/with/a/long/name/and/a/file.brdfpaint",
        "Choose another file; or do without. " * 4,
    )
    one = Message("0", "What happened is described in a sentence that is long. " * 3, where, todo, "error")
    window.resize(720, 520)
    window.messages.show_message(one)
    alone = window.messages.sizeHint().height()
    for key in ("1", "2", "3"):
        window.messages.show_message(replace(one, key=key))
    assert window.messages.brief() == ("0", "1", "2")
    assert window.messages.sizeHint().height() < alone + 3 * 48
    row = window.messages.findChild(object, "message_1")
    qtbot.mouseClick(row, Qt.MouseButton.LeftButton)
    assert window.messages.brief() == ("0", "2", "3")
    window.messages.dismiss("1")
    assert window.messages.brief() == ("0", "2")
    assert list(window.messages.shown()) == ["0", "2", "3"]


def test_an_action_of_a_message_runs_and_the_message_goes(window, qtbot):
    done = []
    window.messages.show_message(Message("k", "Found", actions=(("Recover", lambda: done.append(1)),)))
    button = window.messages.findChild(object, "message_action_Recover")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert done == [1]
    assert window.messages.shown() == {}


def test_a_file_error_tells_what_where_and_what_to_do():
    message = message_of(
        DocumentError("paints/a.brdfpaint", "expected a number", "gloss.gu_20"), "k", todo="Mend it."
    )
    assert (message.what, message.where, message.todo) == (
        "a.brdfpaint: expected a number.",
        "gloss.gu_20, in paints",
        "Mend it.",
    )


def test_an_error_of_a_folder_names_it_and_a_question_has_no_full_stop():
    message = message_of(
        FileError("shots/day 1/", "holds no cam.json; did you mean camera.json?", "line 2"), "k"
    )
    assert message.what == "day 1: holds no cam.json; did you mean camera.json?"
    assert message.where == "Line 2, in shots"
    assert message_of(FileError("a.json", "is empty"), "k").where == ""


def test_a_section_remembers_that_it_is_closed(qtbot):
    section = Section("Coat")
    qtbot.addWidget(section)
    section.set_open(False)
    again = Section("Coat")
    qtbot.addWidget(again)
    assert not again.is_open


def test_panels_are_hidden_and_shown(window):
    window.toggle_panels()
    assert window.inspector_dock.isHidden()
    window.toggle_panels()
    assert not window.inspector_dock.isHidden()


def test_the_layout_is_remembered(window, qtbot):
    window.toggle_panels()
    window.resize(740, 540)
    window.close()
    again = SuiteWindow("Trial")
    qtbot.addWidget(again)
    again.restore_layout()
    assert again.inspector_dock.isHidden()
    assert (again.width(), again.height()) == (740, 540)


def test_ctrl_k_finds_a_command_and_runs_it(window, qtbot):
    ran = []
    window.add_action(window.paint_menu, "Make &Everything Blue", lambda: ran.append(1))
    window.palette_window.open()
    QTest.keyClicks(window.palette_window.query, "evblu")
    assert window.palette_window.found.item(0).text() == "Paint ▸ Make Everything Blue"
    QTest.keyClick(window.palette_window.query, Qt.Key.Key_Return)
    assert ran == [1]
    assert not window.palette_window.isVisible()


def test_enter_runs_the_selected_command_once_and_no_other(window, qtbot):
    ran = []
    for name in ("Blue", "Blue Metallic"):
        window.add_action(window.paint_menu, name, lambda name=name: ran.append(name))
    palette = window.palette_window
    palette.open()
    QTest.keyClicks(palette.query, "blue")
    assert [palette.found.item(row).text() for row in range(palette.found.count())] == [
        "Paint ▸ Blue",
        "Paint ▸ Blue Metallic",
    ]
    QTest.keyClick(palette.query, Qt.Key.Key_Down)
    QTest.keyClick(palette.query, Qt.Key.Key_Return)
    assert ran == ["Blue Metallic"]
    palette.open()
    QTest.keyClicks(palette.query, "blue")
    item = palette.found.item(0)
    # Some styles activate on the click itself: both signals come then.
    palette.found.itemClicked.emit(item)
    palette.found.itemActivated.emit(item)
    assert ran == ["Blue Metallic", "Blue"]


COMMANDS = [
    "File ▸ Open Shipped Paint ▸ Blue metallic",
    "File ▸ Open Shipped Paint ▸ Blue",
    "View ▸ Surface ▸ Sphere",
    "View ▸ Environment ▸ Overcast sky",
    "Help ▸ Show Subluetooth",
    "Help ▸ About Light, Unusual Effects",
]


@pytest.mark.parametrize(
    ("query", "found"),
    [
        ("blue", [1, 0, 4]),  # a word, a word's beginning, a part of a word; not b…l…u…e in "About Light…"
        ("open paint blue", [1, 0]),
        ("Open paint met", [0]),
        ("sky over", [3]),
        ("env sky", [3]),
        ("phere", [2]),
        ("vwsp", [2]),  # letters only: nothing else fits
        ("xyz", []),
        (" ", [0, 1, 2, 3, 4, 5]),
    ],
)
def test_search_takes_words_before_parts_and_letters_only_where_nothing_else_fits(query, found):
    assert search(query, COMMANDS) == found


def test_a_large_fit_error_is_marked_and_its_reason_reported():
    assert [is_large(value) for value in (0.0, 1.0, 1.01, 30.0)] == [False, False, True, True]
    assert fit_mark(1.0) is None
    assert fit_mark(1.5) is fit_mark(1.5, time_limited=True) is Mark.BAD
    assert fit_mark(0.5, time_limited=True) is fit_mark(None, time_limited=True) is Mark.LIMITED
    assert "no non-negative sum of the lobes reaches this colour" in large_error_tip(time_limited=False)
    # A fit that was cut short proves nothing about what the lobes can do.
    assert "non-negative" not in large_error_tip(time_limited=True)
    assert "time limit" in large_error_tip(time_limited=True)


def test_an_icon_has_ink_and_follows_the_theme(qapp):
    theme.apply(qapp, "dark")
    dark = icon("floppy-disk").pixmap(24, 24).toImage()
    theme.apply(qapp, "light")
    light = icon("floppy-disk").pixmap(24, 24).toImage()
    assert darkest(light) < 60 < lightest(dark)


def inked(image) -> list[int]:
    colours = [image.pixelColor(x, y) for x in range(24) for y in range(24)]
    return [c.red() for c in colours if c.alpha() > 200]


def darkest(image) -> int:
    return min(inked(image))


def lightest(image) -> int:
    return max(inked(image))


def test_the_shared_room_imports_no_program_and_nothing_slow():
    code = (
        "import sys, brdf_qt.window.main_window, brdf_qt.documents.files, brdf_qt.documents.recovery;"
        "import brdf_qt.fields.parameters;"
        "bad = {'pyqtgraph','scipy','trimesh','moderngl','OpenImageIO','colour','superqt',"
        "'brdf_designer','brdf_viewer'} & set(sys.modules); print(sorted(bad))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=240
    )
    assert done.stdout.strip() == "[]"


def test_elastic_cells_give_way_in_a_short_status_line_and_no_other_does(qtbot):
    line = StatusLine()
    qtbot.addWidget(line)
    fixed, elastic = line.cell("frame"), line.cell("link", right=True, elastic=True)
    fixed.set("12.4 ms", "Time to draw a frame")
    elastic.set("Designer is not open, not followed", "No other program")
    line.resize(600, 30)
    with qtbot.waitExposed(line):
        line.show()
    assert elastic.shown_text == elastic.text()
    line.resize(220, 30)
    qtbot.waitUntil(lambda: elastic.shown_text.endswith("…"))
    assert elastic.geometry().right() <= line.width()
    assert fixed.width() >= fixed.sizeHint().width()
    assert elastic.toolTip().splitlines() == ["Designer is not open, not followed", "No other program"]
    assert not line.grab().isNull()


def test_the_signs_of_messages_and_panels_follow_the_theme(window, qapp, qtbot):
    theme.apply(qapp, "dark")
    window.messages.show_message(Message("a", "Something is so."))
    row = window.messages.findChild(object, "message_a")
    sign = next(label for label in row.findChildren(QLabel) if not label.pixmap().isNull())

    def drawn(pixmap) -> list[int]:
        image = pixmap.toImage()
        colours = [image.pixelColor(x, y) for x in range(image.width()) for y in range(image.height())]
        assert all(c.red() == c.green() == c.blue() for c in colours if c.alpha() > 200)
        return [c.red() for c in colours if c.alpha() > 200]

    buttons = [
        button
        for button in window.findChild(QDockWidget).findChildren(QAbstractButton)
        if button.objectName() in ("qt_dockwidget_floatbutton", "qt_dockwidget_closebutton")
    ]
    assert len(buttons) == 2
    pictures = [sign.pixmap, *(lambda b=button: b.icon().pixmap(16, 16) for button in buttons)]
    assert all(max(drawn(picture())) > 180 for picture in pictures)
    theme.apply(qapp, "booth")
    qtbot.waitUntil(lambda: all(min(drawn(picture())) < 40 for picture in pictures))


def test_the_buttons_of_a_question_have_no_icons(window, monkeypatch):
    seen: list[bool] = []

    def with_icons(box, kinds) -> None:
        QMessageBox.setStandardButtons(box, kinds)
        for button in box.buttons():
            button.setIcon(icon("x"))

    def answered(box) -> int:
        seen.extend(button.icon().isNull() for button in box.buttons())
        return QMessageBox.StandardButton.Discard.value

    # As on a desktop whose dialogs have icons on their buttons.
    parts = {"setStandardButtons": with_icons, "exec": answered}
    monkeypatch.setattr("brdf_qt.window.dialogs.QMessageBox", type("Iconed", (QMessageBox,), parts))
    assert QtDialogs(window).unsaved("Blue") is Answer.DISCARD
    assert seen == [True, True, True]


def test_an_icon_of_a_state_is_seen_on_the_accent(qapp):
    theme.apply(qapp, "light")
    sign = icon("check-circle-fill", "good")
    text = qapp.palette().color(QPalette.ColorRole.HighlightedText)
    assert lightest(sign.pixmap(QSize(24, 24), QIcon.Mode.Selected).toImage()) == text.red()
    assert lightest(sign.pixmap(QSize(24, 24), QIcon.Mode.Normal).toImage()) < text.red()


@pytest.mark.parametrize("name", ["dark", "booth", "light"])
def test_a_box_that_is_not_checked_is_seen_and_its_tick_too(qapp, qtbot, name):
    theme.apply(qapp, name)
    box = QCheckBox()
    qtbot.addWidget(box)
    box.ensurePolished()
    shown = [box.palette().color(role) for role in (QPalette.ColorRole.Window, QPalette.ColorRole.Base)]
    window, fill = (luminance(colour) + 0.05 for colour in shown)
    text = luminance(box.palette().color(QPalette.ColorRole.Text)) + 0.05
    assert fill / window > 1.2
    assert max(fill, text) / min(fill, text) > 4.5


def test_the_keys_of_the_chosen_command_have_the_colour_of_text_on_the_accent(window):
    for name in ("Bluer", "Blue Metallic"):
        window.add_action(window.paint_menu, name, lambda: None).setShortcut("Ctrl+Alt+B")
    palette = window.palette_window
    palette.open()
    QTest.keyClicks(palette.query, "blue")
    labels = [palette.found.itemWidget(palette.found.item(row)).findChild(QLabel) for row in range(2)]
    roles = QPalette.ColorRole
    assert [label.foregroundRole() for label in labels] == [roles.HighlightedText, roles.PlaceholderText]
    QTest.keyClick(palette.query, Qt.Key.Key_Down)
    assert [label.foregroundRole() for label in labels] == [roles.PlaceholderText, roles.HighlightedText]


def test_an_icon_of_no_size_is_empty_and_says_nothing(qapp, qtlog):
    """A tab that is squeezed to nothing asks for one."""
    assert icon("folder-open").pixmap(QSize(0, 16)).isNull()
    assert icon("folder-open").pixmap(QSize(0, 0)).isNull()
    assert not icon("folder-open").pixmap(QSize(16, 16)).isNull()
    assert [record.message for record in qtlog.records] == []
