"""What the window's own pieces do: grid, panes, map, notes and titles."""

from __future__ import annotations

from brdf_color_swatch.assembly import ColorSwatch
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QLineEdit


def test_the_return_that_ends_a_name_opens_nothing(swatch: ColorSwatch, select, qtbot) -> None:
    pane = swatch.window.panes[0]
    opened: list[str] = []
    pane.opened.connect(opened.append)
    try:
        select(swatch, "Red")
        pane.rename_current()
        (editor,) = pane.grid.findChildren(QLineEdit)
        editor.setText("Scarlet")
        QTest.keyClick(editor, Qt.Key.Key_Return)
        qtbot.waitUntil(lambda: "Scarlet" in [entry.name for entry in swatch.desk.palette.entries])
        qtbot.waitUntil(lambda: pane.grid.state() == pane.grid.State.NoState)
        assert opened == []
        QTest.keyClick(pane.grid, Qt.Key.Key_Return)
        assert opened == ["red"]
    finally:
        pane.opened.disconnect(opened.append)


def marked(swatch: ColorSwatch) -> list[bool]:
    """Return which panes have the mark of the one that is worked in."""
    return [not pane.findChild(QLabel, "front_mark").isHidden() for pane in swatch.window.panes]


def test_a_click_on_a_title_makes_the_pane_the_one_worked_in(swatch: ColorSwatch) -> None:
    assert marked(swatch) == [False, False]
    swatch.controller.show_second(True)
    assert marked(swatch) == [False, True]
    for number in (0, 1):
        head = swatch.window.panes[number].head
        QTest.mouseClick(head.childAt(head.rect().center()), Qt.MouseButton.LeftButton)
        assert swatch.desk.front == number
        assert marked(swatch) == [number == 0, number == 1]
