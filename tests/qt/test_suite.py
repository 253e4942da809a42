"""What all four programs have in common: keys, settings, manual, places of windows, marks."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest
from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import PlainLabel, RoomyLabel
from brdf_qt.fields.marks import Mark
from brdf_qt.program import theme
from brdf_qt.program.names import ENVIRONMENTS, SURFACES, title_of
from brdf_qt.program.suite import MEMBERS, connected_words
from brdf_qt.window.help_windows import ShortcutsWindow
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.manual import Manual
from brdf_qt.window.message_bar import Message
from brdf_qt.window.placement import WindowPlaces, free_place, halves
from brdf_qt.window.shortcuts import PRESETS, SHORTCUTS
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QRect, QSize, QUrl
from PySide6.QtGui import QColor, QFont, QPalette, QPixmap
from PySide6.QtWidgets import QApplication, QLineEdit, QTreeWidget, QWidget

from brdf_suite.library.reference import list_pages
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.resources import document_root, resource_names

APPS = Path(__file__).resolve().parent.parent.parent / "apps"
LEAST = QSize(720, 520)
RANGES = ((0, 2000), (0, 1200), (720, 1600), (520, 1000))
"""Of the places and sizes of windows."""


@pytest.fixture
def window(qtbot) -> SuiteWindow:
    window = SuiteWindow("Trial")
    qtbot.addWidget(window)
    window.set_centre(QWidget())
    window.restore_layout()
    with qtbot.waitExposed(window):
        window.show()
    return window


def test_no_key_of_the_table_means_two_things() -> None:
    keys = Counter(key for shortcut in SHORTCUTS.values() for key in shortcut.keys)
    assert [key for key, count in keys.items() if count > 1] == []


def test_the_keys_that_everybody_knows_are_there() -> None:
    wanted = {
        "export": "Ctrl+E",
        "find_command": "Ctrl+K",
        "frame": "F",
        "play": "Space",
        "panels_of_picture": "Tab",
        "blink": "B",
    } | {f"preset_{n}": f"{n}" for n in range(1, PRESETS + 1)}
    assert {name: SHORTCUTS[name].keys[0] for name in wanted} == wanted


def test_the_list_of_keys_has_the_whole_table_and_is_searched(window, qtbot) -> None:
    shown = ShortcutsWindow(window)
    qtbot.addWidget(shown)
    rows = shown.findChild(QTreeWidget)
    texts = [
        (rows.topLevelItem(n).text(0), rows.topLevelItem(n).text(1)) for n in range(rows.topLevelItemCount())
    ]
    written = " ".join(keys for _, keys in texts)
    for name, shortcut in SHORTCUTS.items():
        if name[-1:].isdigit():
            continue
        assert shortcut.keys[0] in written, name
    assert ("View ▸ Settings…", "Ctrl+,") in texts
    find = next(child for child in shown.children() if hasattr(child, "setPlaceholderText"))
    find.setText("turntable")
    left = [
        rows.topLevelItem(n).text(1)
        for n in range(rows.topLevelItemCount())
        if not rows.topLevelItem(n).isHidden()
    ]
    assert left == ["Space"]


def test_the_settings_hold_at_once_and_for_all_programs(window, qapp) -> None:
    window.command("Settings").trigger()
    page = window.settings_window
    page.theme.setCurrentIndex(page.theme.findData("light"))
    page.theme.activated.emit(page.theme.currentIndex())
    assert qapp.palette().color(QPalette.ColorRole.Window) == theme.grey(85)
    qapp.setApplicationName("Another")
    try:
        assert theme.current() == "light"
    finally:
        qapp.setApplicationName("")


def test_any_program_opens_the_others(qtbot, monkeypatch) -> None:
    started = []
    monkeypatch.setattr(
        "brdf_qt.window.main_window.start_member", lambda role, place: started.append((role, place)) or True
    )
    for own, member in MEMBERS.items():
        window = SuiteWindow(member.name)
        qtbot.addWidget(window)
        window.show()
        assert set(window.openers) == set(MEMBERS) - {own}
        for action in window.openers.values():
            action.trigger()
    assert len(started) == 12
    room = QApplication.primaryScreen().availableGeometry()
    for _role, place in started:
        assert (place is None) == (room.width() < 2 * LEAST.width())


def test_a_program_that_cannot_be_started_is_named_with_its_command(window, monkeypatch) -> None:
    monkeypatch.setattr("brdf_qt.window.main_window.start_member", lambda _role, _place: False)
    window.openers["lobes"].trigger()
    message = window.messages.shown()["start"]
    assert "Lobe Visualizer" in message.what
    assert "brdf-lobes" in message.todo


def test_programs_on_the_link_are_named_as_everywhere() -> None:
    assert connected_words(["lobes", "swatch"]) == "Connected: Lobe Visualizer, Color Swatch"
    assert connected_words([]) == "Not connected"


# Places of windows.


def test_two_windows_share_a_wide_screen() -> None:
    left, right = halves(QRect(0, 40, 1921, 1040), LEAST)
    assert not left.intersects(right)
    assert left.united(right) == QRect(0, 40, 1921, 1040)
    assert halves(QRect(0, 0, 1400, 900), LEAST) is None


@given(
    st.integers(800, 4000),
    st.integers(600, 2200),
    st.lists(
        st.tuples(st.integers(0, 2000), st.integers(0, 1200), st.integers(720, 1600), st.integers(520, 1000)),
        max_size=4,
    ),
)
def test_a_window_is_on_the_screen_and_hides_no_more_than_it_must(width: int, height: int, others) -> None:
    room, taken = QRect(0, 0, width, height), [QRect(*one) for one in others]
    wanted = QRect(0, 0, min(1440, width), min(900, height))
    place = free_place(room, wanted, LEAST, taken)
    assert room.contains(place)
    assert place.width() >= LEAST.width()
    assert place.height() >= LEAST.height()

    def hidden(at: QRect) -> int:
        common = [at.intersected(one) for one in taken]
        return sum(max(0, one.width()) * max(0, one.height()) for one in common)

    assert hidden(place) <= hidden(wanted)


def test_a_free_strip_beside_a_window_is_taken_whole() -> None:
    place = free_place(QRect(0, 0, 2560, 1400), QRect(0, 0, 1440, 900), LEAST, [QRect(0, 0, 1440, 900)])
    assert place == QRect(1440, 0, 1120, 900)


def test_a_second_window_steps_aside_and_a_dead_one_is_forgotten(qtbot) -> None:
    first, second = QWidget(), QWidget()
    for widget in (first, second):
        qtbot.addWidget(widget)
        widget.setMinimumSize(300, 200)
    first.setGeometry(0, 0, 400, 300)
    places = WindowPlaces(first)
    first.show()
    other = WindowPlaces(second)
    qtbot.waitUntil(lambda: other.others() == [first.frameGeometry()])
    second.setGeometry(0, 0, 400, 300)
    other.step_aside()
    assert not second.geometry().intersects(first.geometry())
    places.close()
    assert other.others() == []
    other.close()


# What comes and goes.


def geometries(window: QWidget) -> dict[int, QRect]:
    """Return where every widget of a window is, without those that float."""
    floating = (window.messages, window.progress)
    return {
        id(widget): QRect(widget.mapTo(window, QPoint(0, 0)), widget.size())
        for widget in window.findChildren(QWidget)
        if widget.isVisible() and not any(part is widget or part.isAncestorOf(widget) for part in floating)
    }


def test_notices_and_progress_move_nothing(window, qtbot) -> None:
    cells = [
        window.status.cell("fit"),
        window.status.cell("gamut"),
        window.status.cell("place", elastic=True),
    ]
    for cell in cells:
        cell.set("a text of some length")
    qtbot.wait(20)
    before = geometries(window)
    window.show_message(Message("a", "Something was written. " * 5, severity="warning"))
    window.show_message(Message("b", "Something else"))
    window.progress.set_job("light", 0.5, "Preparing the light", lambda: None)
    cells[0].set("short")
    cells[1].set("")
    qtbot.wait(20)
    assert window.messages.isVisible()
    assert window.progress.isVisible()
    assert window.messages.geometry().bottom() < window.progress.geometry().top()
    assert {key: place for key, place in geometries(window).items() if before.get(key, place) != place} == {}
    assert window.centralWidget().rect().contains(window.messages.geometry())


def test_a_text_that_comes_and_goes_moves_nothing_below_it(qtbot) -> None:
    place, label, below = QWidget(), RoomyLabel(lines=2), QLineEdit()
    qtbot.addWidget(place)
    fill_column(place, label, below, None)
    place.resize(260, 400)
    label.hide()
    place.show()
    qtbot.waitExposed(place)
    before = below.geometry()
    for text in ("one line", "two lines, which are a little longer than the place is wide", ""):
        label.setText(text)
        label.setVisible(bool(text))
        qtbot.wait(5)
        assert below.geometry() == before
    label.setText("many words " * 30)
    label.show()
    qtbot.waitUntil(lambda: below.y() > before.y())
    after = below.geometry()
    label.setText("short")
    label.hide()
    qtbot.wait(5)
    assert below.geometry() == after


def test_a_note_goes_by_itself_and_a_warning_stays(window, qtbot) -> None:
    window.messages.note_ms = 1
    window.show_message(Message("kept", "Look", severity="warning"))
    window.show_message(Message("asks", "Recover?", actions=(("Yes", lambda: None),)))
    window.show_message(Message("note", "Written"))
    qtbot.waitUntil(lambda: "note" not in window.messages.shown())
    assert set(window.messages.shown()) == {"kept", "asks"}


# Marks.


def shape(what: Mark) -> bytes:
    """Return which pixels a mark covers, whatever its colour."""
    image = what.icon.pixmap(32, 32).toImage()
    return bytes(
        image.pixelColor(x, y).alpha() > 127 for y in range(image.height()) for x in range(image.width())
    )


def test_every_mark_has_a_shape_of_its_own() -> None:
    shapes = [shape(what) for what in Mark]
    assert all(any(pixels) for pixels in shapes)
    assert len(set(shapes)) == len(Mark)


@pytest.mark.parametrize("name", ["dark", "booth", "light"])
def test_every_mark_stands_out_in_every_theme(name: str) -> None:
    def luminance(colour: QColor) -> float:
        codes = [colour.redF(), colour.greenF(), colour.blueF()]
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in codes]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    ground = theme.palette(name).color(QPalette.ColorRole.Window)
    for kind in ("good", "warning", "bad"):
        pair = sorted(luminance(QColor(one)) for one in (theme.state_colour(kind, ground), ground))
        assert (pair[1] + 0.05) / (pair[0] + 0.05) >= 3.0, kind


def test_a_marked_label_draws_the_mark_and_says_its_word(qtbot) -> None:
    label = PlainLabel("ΔE 3")
    qtbot.addWidget(label)
    plain = label.sizeHint().width()
    label.set_mark(Mark.BAD)
    label.resize(label.sizeHint())
    assert label.sizeHint().width() > plain
    assert label.accessibleDescription() == "fails"
    drawn = QPixmap(label.size())
    label.render(drawn)
    picture = drawn.toImage()
    colours = [picture.pixelColor(x, y) for x in range(16) for y in range(picture.height())]
    assert any(colour.hsvSaturation() > 80 for colour in colours)


# The manual.


def test_the_manual_has_every_document_but_its_list() -> None:
    root = document_root()
    pages = [page for chapter in list_pages(root).values() for _, _, page in chapter]
    assert sorted(pages) == sorted(set(root.rglob("*.md")) - {root / "README.md"})


@pytest.mark.parametrize("program", ["designer", "viewer", "lobe_visualizer", "color_swatch"])
def test_the_manual_opens_at_the_guide_of_its_program(program: str, window, qtbot) -> None:
    manual = Manual(window, program)
    qtbot.addWidget(manual)
    page = manual.text.page
    assert page.parent == document_root() / "guides"
    (command,) = (member.command for member in MEMBERS.values() if member.package == f"brdf_{program}")
    assert f"`{command}`" in page.read_text("utf-8")


def test_pages_and_pictures_of_the_manual_are_shown_and_links_followed(window, qtbot) -> None:
    manual = Manual(window, "viewer")
    qtbot.addWidget(manual)
    manual.show()
    page = manual.text
    qtbot.wait(20)
    assert page.verticalScrollBar().value() == 0
    page.show_page(document_root() / "start" / "first_paint.md")
    assert "Type the readings" in page.toPlainText()
    assert page.loadResource(2, QUrl("../images/designer.png")).width() > 100
    page.follow(QUrl("../guides/colourist.md"))
    assert page.page == (document_root() / "guides" / "colourist.md").resolve()
    qtbot.wait(20)
    page.show_page(document_root() / "method" / "fit.md")
    assert "<!--" not in page.toPlainText()
    paragraph = page.document().begin().next()
    assert paragraph.begin().fragment().charFormat().fontWeight() == QFont.Weight.Normal
    page.follow(QUrl("basis.md#a-basis-of-your-own"))
    heading = page.cursorForPosition(QPoint(20, 5)).block()
    assert "A basis of your own" in (heading.text(), heading.next().text())


def test_the_manual_shows_the_names_of_the_library_with_their_docstrings(window, qtbot) -> None:
    manual = Manual(window, "viewer")
    qtbot.addWidget(manual)
    manual.text.show_page(document_root() / "library" / "reference.md")
    text = manual.text.toPlainText()
    assert ":::" not in text
    assert "(width, height) in pixels, each 1 to 65,536." in text
    assert "Rendering.save" in text
    assert "L*a*b* is CIE 1976" in text


# Names.


def test_lights_surfaces_and_paints_are_called_as_their_documents_say() -> None:
    assert [title_of(name) for name in ("booth", "speed_form", "gold_green_shift", "burnt_orange")] == [
        "Light booth",
        "Speed form",
        "Gold-green shift",
        "Burnt orange",
    ]
    assert {name: title_of(name) for name in paint_names()} == {
        name: load_shipped_paint(name).name for name in paint_names()
    }
    assert set(ENVIRONMENTS) == set(resource_names("environments", ".exr"))
    assert set(SURFACES) == set(resource_names("meshes", ".glb"))
    assert title_of("/somewhere/my_light.exr") == "my_light.exr"


def test_no_other_module_has_names_of_its_own_for_what_is_shipped() -> None:
    names, titles = (
        "|".join((*ENVIRONMENTS, *SURFACES)),
        "|".join((*ENVIRONMENTS.values(), *SURFACES.values())),
    )
    own = re.compile(rf'"({names})"[:,] mark\("({titles})"\)|replace\("_", " "\)\.capitalize\(\)')
    for path in APPS.rglob("*.py"):
        if path.name != "names.py":
            assert not own.search(path.read_text("utf-8")), path
