"""What the window's own pieces do: grid, panes, map, notes and titles."""

from __future__ import annotations

from brdf_color_swatch.assembly import ColorSwatch
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit


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
