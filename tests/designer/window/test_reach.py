"""Everything can be reached by keyboard, and has a name for a screen reader: all widgets of the window, walked."""

from __future__ import annotations

import time
from itertools import pairwise

import pytest
from brdf_designer.assembly import Designer
from brdf_designer.window.menu_letters import with_letters
from brdf_qt.window.command_palette import commands
from brdf_qt.window.section import Section
from brdf_qt.work import pictures
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QScrollBar,
    QTabBar,
    QTextEdit,
    QToolButton,
    QWidget,
)

CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QTabBar,
    QTextEdit,
)


@pytest.fixture(scope="module")
def window(qapp, tmp_path_factory):
    """One window for all of these: nothing is changed in it."""
    patch = pytest.MonkeyPatch()
    patch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
    patch.setenv("BRDF_SUITE_LINK", f"reach-{id(patch)}")
    patch.setattr(pictures, "child_command", lambda _module: [])
    designer = Designer()
    designer.window.resize(1400, 900)
    for section in designer.window.findChildren(Section):
        section.set_open(True)
    for drawer in designer.window.stage.drawers.values():
        drawer.set_open(True)
    designer.window.panel.show_page("paint")
    designer.window.show()
    named = [widget for widget in controls(designer.window) if widget.objectName().startswith("variation_")]
    end = time.monotonic() + 300.0
    while not (designer.window.plot.is_built and designer.session.is_quiet and all(map(said, named))):
        assert time.monotonic() < end, [described(widget) for widget in named if not said(widget)]
        qapp.processEvents()
    yield designer.window
    designer.close()
    designer.window.close()
    designer.window.deleteLater()
    patch.undo()


def controls(window) -> list[QWidget]:
    """What a user operates; the inner parts of Qt's own controls belong to those."""
    return [
        widget
        for widget in window.findChildren(QWidget)
        if isinstance(widget, CONTROLS) and not is_inner(widget)
    ]


def is_inner(widget: QWidget) -> bool:
    if isinstance(widget, QScrollBar) or (widget.objectName() or "").startswith("qt_"):
        return True
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, (QAbstractSpinBox, QComboBox, QAbstractItemView, QLineEdit)):
            return True
        around = around.parentWidget()
    return False


def said(widget: QWidget) -> str:
    """What a screen reader has to go by: the name, or the text on it."""
    text = widget.text() if isinstance(widget, QAbstractButton) else ""
    return widget.accessibleName() or text.replace("&", "")


def described(widget: QWidget) -> str:
    return f"{type(widget).__name__} {widget.objectName()!r} {said(widget)!r} in {path(widget)}"


def path(widget: QWidget) -> str:
    names = []
    while (widget := widget.parentWidget()) is not None:
        names.append(widget.objectName() or type(widget).__name__)
    return " < ".join(names[:4])


def test_every_control_has_a_name_for_a_screen_reader(window):
    found = controls(window)
    assert len(found) > 60
    assert [described(widget) for widget in found if not said(widget)] == []


def test_every_name_of_a_number_has_its_unit_or_has_none(window):
    """A number with a suffix says it: 5.0 µm is spoken with its unit."""
    from brdf_qt.fields.number import NumberField

    fields = window.findChildren(NumberField)
    assert len(fields) > 15
    assert [described(f) for f in fields if f.unit and f.unit not in f.accessibleName()] == []


def test_every_control_explains_itself(window):
    """A tooltip on the control or on the label that stands for it."""
    labels = {label.buddy(): label for label in window.findChildren(QLabel) if label.buddy() is not None}

    def explained(widget: QWidget) -> bool:
        label = labels.get(widget)
        return bool(widget.toolTip()) or (label is not None and bool(label.toolTip()))

    quiet = (QPlainTextEdit, QTextEdit, QLineEdit, QTabBar)
    silent = [
        described(widget)
        for widget in controls(window)
        if not explained(widget)
        and not isinstance(widget, quiet)
        and not isinstance(widget.parentWidget(), QTabBar)
        and not said(widget).startswith("Section ")
    ]
    assert silent == []


@pytest.mark.parametrize("term", ["aspecular", "flop", "ΔE00", "GU", "L*", "°"])
def test_the_terms_of_the_trade_are_explained_somewhere(window, term):
    tips = [widget.toolTip() for widget in window.findChildren(QWidget)]
    assert any(term.lower() in tip.lower() and len(tip) > 20 for tip in tips), term


def test_every_control_that_is_shown_takes_the_focus_by_tab(window):
    """Except what stands for a command that has a shortcut, a slider whose number has the focus, and the pictures of a
    row beyond the first one, which the arrow keys reach."""
    from brdf_designer.variations.section import PictureButton
    from brdf_qt.fields.colour_slider import ColourSlider

    quiet = [
        described(widget)
        for widget in controls(window)
        if widget.isVisibleTo(window)
        and widget.isEnabled()
        and not widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        and not isinstance(widget.parentWidget(), (QTabBar,))
        and not isinstance(widget, ColourSlider)
        and not (isinstance(widget, PictureButton) and widget.focusPolicy() == Qt.FocusPolicy.ClickFocus)
        and not (isinstance(widget, QToolButton) and has_other_way(window, widget))
    ]
    assert quiet == []


def has_other_way(window, button: QToolButton) -> bool:
    """A tool button of a command in the menus, one of a group that the arrow keys go through, or the head of a panel
    that View ▸ Panels shows and hides."""
    group = button.group()
    if group is not None and group.checkedButton().focusPolicy() & Qt.FocusPolicy.TabFocus:
        return True
    if button.defaultAction() in [action for _path, action in commands(window, also_disabled=True)]:
        return True
    return (button.objectName() or "").startswith("qt_dock")


def test_tab_goes_through_the_window_from_top_to_bottom_of_the_inspector(window, qtbot):
    window.activateWindow()
    first = window.editors.editors[0].fields[0]
    first.setFocus(Qt.FocusReason.TabFocusReason)
    seen: list[QWidget] = []
    for _ in range(400):
        QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
        now = QApplication.focusWidget()
        if now is first:
            break
        assert now not in seen, described(now)
        seen.append(now)
    assert len(seen) > 30
    inspector = window.inspector.widget()
    # The buttons of the readings come together behind all their numbers: Tab goes from number to number.
    editors = window.editors.editors
    picks = [editor.swatch for editor in editors]
    numbers = [field for editor in editors for field in editor.fields]
    assert seen[: len(numbers) - 1 + len(picks)] == [*numbers[1:], *picks]
    heights = [
        widget.mapTo(inspector, QPoint(0, 0)).y()
        for widget in seen
        if inspector.isAncestorOf(widget)
        and widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        and widget not in picks
    ]
    # One turn through the inspector: it goes down but for the wrap, and for fields side by side.
    jumps = sum(after < before - 40 for before, after in pairwise(heights))
    assert jumps <= 1, heights


def test_no_two_commands_have_one_shortcut(window):
    taken: dict[str, str] = {}
    for name, action in commands(window, also_disabled=True):
        for keys in action.shortcuts():
            text = keys.toString(QKeySequence.SequenceFormat.PortableText)
            assert text not in taken, (name, taken.get(text), text)
            taken[text] = name
    assert {"Ctrl+K", "Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+W", "Ctrl+Tab", "Ctrl+S", "Ctrl+O", "Ctrl+N"} <= set(
        taken
    )


def test_the_menus_open_by_their_letters_and_none_is_there_twice(window):
    letters = [action.text().partition("&")[2][:1].lower() for action in window.menuBar().actions()]
    assert "" not in letters
    assert len(set(letters)) == len(letters)
    for top in window.menuBar().actions():
        inside = [action.text() for action in top.menu().actions() if not action.isSeparator()]
        marks = [text.replace("&&", "").partition("&")[2][:1].lower() for text in inside]
        used = [mark for mark in marks if mark]
        assert len(set(used)) == len(used), (top.text(), inside)


def test_a_letter_is_given_once_and_a_wish_for_it_counts():
    given = with_letters(["&Save", "&Standard", "S&wap", "&&", "Rough"])
    assert given == ["&Save", "S&tandard", "S&wap", "&&", "&Rough"]
    assert with_letters(["&Colour: &&", "C"]) == ["&Colour: &&", "C"]


def test_every_command_is_found_by_its_name(window):
    window.palette_window.open()
    window.palette_window.query.setText("close tab")
    found = window.palette_window.findChild(QAbstractItemView)
    assert any("Close Tab" in found.item(row).text() for row in range(found.count()))
    window.palette_window.hide()
