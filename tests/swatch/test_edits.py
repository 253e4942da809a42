"""What is done to swatches in the window, through its widgets; each is one step with a name."""

from __future__ import annotations

import pytest
from brdf_color_swatch.grid.view_state import Scope
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import load_palette


def undo_text(program) -> str:
    return program.window.command("undo").text()


def test_a_name_is_written_in_its_place(swatch, names, select, qtbot) -> None:
    before = swatch.session.palette
    select(swatch, "Blue")
    swatch.window.activateWindow()
    swatch.window.command("rename").trigger()
    pane = swatch.window.panes[0]
    editor = pane.grid.viewport().findChild(QLineEdit)
    assert editor.text() == "Blue"
    editor.setText("Azure")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: "Azure" in names(swatch))
    assert "Rename to “Azure”" in undo_text(swatch)
    assert swatch.session.palette.entry("blue").date
    swatch.window.command("undo").trigger()
    assert swatch.session.palette == before


def test_fields_of_the_inspector_write_into_all_that_is_selected(swatch, select) -> None:
    before = swatch.session.palette
    select(swatch, "Red", "Blue")
    panel = swatch.window.swatch
    tags = panel.fields["tags"]
    tags.setFocus()
    QTest.keyClicks(tags, "+summer, -car")
    QTest.keyClick(tags, Qt.Key.Key_Return)
    assert swatch.session.palette.entry("red").tags == ("hot", "summer")
    assert swatch.session.palette.entry("blue").tags == ("summer",)
    code = panel.fields["code"]
    QTest.keyClicks(code, "X1")
    QTest.keyClick(code, Qt.Key.Key_Return)
    assert {swatch.session.palette.entry(key).code for key in ("red", "blue")} == {"X1"}
    panel.notes.setPlainText("seen in rain")
    panel.notes.finish()
    assert swatch.session.palette.entry("blue").notes == "seen in rain"
    assert swatch.session.palette.entry("silver") == before.entry("silver")
    for _ in range(3):
        swatch.library.history.undo()
    assert swatch.session.palette == before


def test_copy_and_paste_cut_duplicate_and_delete(swatch, names, select, command) -> None:
    before = swatch.session.palette
    select(swatch, "Red", "Ice")
    command(swatch, "copy")
    assert QGuiApplication.clipboard().text().count("#") == 2
    command(swatch, "paste")
    assert names(swatch).count("Red") == 2
    assert len(swatch.session.selected) == 2
    command(swatch, "duplicate")
    assert names(swatch).count("Red") == 3
    command(swatch, "cut")
    assert names(swatch).count("Red") == 2
    select(swatch, "Ice")
    command(swatch, "delete")
    assert "Ice" not in names(swatch)
    # The next one is selected, so that the keys go on from there.
    assert len(swatch.session.selected) == 1
    assert len(swatch.session.palette.by_id) == len(swatch.session.palette)
    while swatch.library.history.can_undo:
        swatch.library.history.undo()
    assert swatch.session.palette == before


def test_a_new_palette_has_what_is_selected_in_a_file_of_its_own(
    swatch, names, select, dialogs, tmp_path, qtbot
) -> None:
    before, button = swatch.session.palette, swatch.window.panes[0].new_palette
    assert not button.isVisible()
    select(swatch, "Red", "Ice")
    dialogs.path = None
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert swatch.session.palette is before
    dialogs.path = tmp_path / "Spring 2027"
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert sorted(names(swatch)) == ["Ice", "Red"]
    assert swatch.session.palette.name == "Spring 2027"
    assert swatch.session.item.path == tmp_path / "Spring 2027.brdfpalette"
    assert swatch.session.item.is_clean
    assert sorted(entry.name for entry in load_palette(swatch.session.item.path)) == ["Ice", "Red"]
    swatch.window.panes[0].grid.clearSelection()
    assert not button.isVisible()
    assert not swatch.window.command("new_from_selection").isEnabled()


def test_a_new_palette_that_cannot_be_written_is_still_to_be_saved(
    swatch, names, select, command, dialogs, tmp_path
) -> None:
    select(swatch, "Red")
    dialogs.path = tmp_path / "no folder" / "spring.brdfpalette"
    command(swatch, "new_from_selection")
    assert names(swatch) == ["Red"]
    assert not swatch.session.item.is_clean
    assert "cannot be written" in swatch.window.messages.shown()["save"].what


def test_colours_of_other_programs_are_pasted(swatch, names, command) -> None:
    QGuiApplication.clipboard().setText("#ff8800 Sunset\n#003366 Deep")
    command(swatch, "paste")
    assert names(swatch)[:2] == ["Silver", "Black"]
    assert {"Sunset", "Deep"} <= set(names(swatch))
    QGuiApplication.clipboard().setText("only words")
    command(swatch, "paste")
    assert "contains no swatch" in swatch.window.messages.shown()["edit"].what


def test_an_empty_clipboard_has_nothing_to_paste(swatch, names, command) -> None:
    QGuiApplication.clipboard().clear()
    before = names(swatch)
    command(swatch, "paste")
    assert names(swatch) == before
    assert "contains no swatch" in swatch.window.messages.shown()["edit"].what


def test_groups_are_made_named_moved_and_dissolved(swatch, select, command) -> None:
    before = swatch.session.palette
    select(swatch, "Silver", "Black")
    command(swatch, "new_group")
    assert swatch.session.palette.entry("silver").group == ("New group",)
    key = swatch.session.state.scope.palette
    swatch.window.tree.renamed.emit(Scope(key, ("New group",)), "Greys")
    assert swatch.session.palette.entry("black").group == ("Greys",)
    swatch.window.tree.group_dropped.emit(Scope(key, ("Greys",)), Scope(key, ("Cold",)), False)
    assert swatch.session.palette.entry("black").group == ("Cold", "Greys")
    swatch.session.show_scope(Scope(key, ("Cold", "Greys")))
    command(swatch, "dissolve_group")
    assert swatch.session.palette.entry("black").group == ("Cold",)
    assert swatch.session.state.scope.group == ("Cold",)
    command(swatch, "remove_group")
    assert len(swatch.session.palette) == 2
    for _ in range(5):
        swatch.library.history.undo()
    assert swatch.session.palette == before


@pytest.mark.parametrize("moves", [False, True])
def test_a_group_goes_to_another_palette_with_all_that_is_in_it(swatch, command, moves: bool) -> None:
    before, key = swatch.session.palette, swatch.session.state.scope.palette
    swatch.session.show_scope(Scope(key, ("Warm",)))
    swatch.window.palette_panel.edited.emit("colour", "#ff0000")
    other = swatch.library.add_palette(Palette("Other"))
    swatch.window.tree.group_dropped.emit(Scope(key, ("Warm",)), Scope(other), moves)
    arrived = swatch.library.palette(other)
    assert [(entry.name, entry.group) for entry in arrived] == [("Red", ("Warm",)), ("Orange", ("Warm",))]
    assert arrived.groups[0].colour == "#ff0000"
    assert len(swatch.library.palette(key)) == (4 if moves else 6)
    swatch.library.history.undo()
    swatch.library.history.undo()
    assert swatch.library.palette(key) == before
    assert swatch.library.palette(other) == Palette("Other")


def test_a_palette_and_a_group_have_name_colour_and_notes(swatch) -> None:
    panel = swatch.window.palette_panel
    panel.edited.emit("colour", "#336699")
    panel.name.setText("Autumn")
    panel.name.editingFinished.emit()
    assert (swatch.session.palette.name, swatch.session.palette.colour) == ("Autumn", "#336699")
    swatch.session.show_scope(Scope(swatch.session.state.scope.palette, ("Warm",)))
    panel.edited.emit("notes", "for the sun")
    panel.edited.emit("colour", "#ff0000")
    group = next(one for one in swatch.session.palette.groups if one.path == ("Warm",))
    assert (group.notes, group.colour) == ("for the sun", "#ff0000")
    assert panel.name.text() == "Warm"


def test_a_tag_is_renamed_and_what_is_pasted_where_it_is_shown_has_it(swatch, names, command) -> None:
    key = swatch.session.state.scope.palette
    swatch.session.show_scope(Scope(key, (), "car"))
    assert names(swatch) == ["Silver", "Red", "Blue"]
    swatch.window.tree.renamed.emit(Scope(key, (), "car"), "vehicle")
    assert swatch.session.state.scope.tag == "vehicle"
    assert names(swatch) == ["Silver", "Red", "Blue"]
    QGuiApplication.clipboard().setText("#102030 Ink")
    command(swatch, "paste")
    assert "Ink" in names(swatch)


def test_a_drag_within_a_pane_puts_swatches_elsewhere(swatch, names, drop) -> None:
    grid = swatch.window.panes[0].grid
    data = grid.model().mime_of(["blue"])
    target = grid.visualRect(grid.model().index(names(swatch).index("Orange"), 0))
    drop(grid.viewport(), QPoint(target.left() + 3, target.center().y()), data)
    assert swatch.session.palette.entry("blue").group == ("Warm",)
    assert names(swatch).index("Blue") == names(swatch).index("Orange") - 1
    assert "Move “Blue”" in undo_text(swatch)
    assert swatch.session.selected == ("blue",)


def test_a_drag_into_the_room_below_the_last_swatch_puts_behind_it(swatch, names, drop) -> None:
    grid = swatch.window.panes[0].grid
    grid.resize(grid.width(), grid.layout_.height + 200)
    drop(grid.viewport(), QPoint(12, grid.layout_.height + 60), grid.model().mime_of(["silver"]))
    assert names(swatch)[-1] == "Silver"


@pytest.mark.parametrize("key", ["NoModifier", "ControlModifier", "ShiftModifier"])
def test_a_drag_to_another_palette_copies_and_with_shift_moves_in_one_step(
    swatch, names, drop, command, key
) -> None:
    first = swatch.session.palette
    command(swatch, "two_panes")
    other = swatch.library.add_palette(Palette("Other"))
    swatch.session.show_scope(Scope(other), 1)
    data = swatch.window.panes[0].grid.model().mime_of(["red", "ice"])
    page = swatch.window.panes[1].stack.currentWidget()
    assert swatch.window.panes[1].note
    drop(page, QPoint(20, 20), data, Qt.KeyboardModifier[key])
    assert names(swatch, 1) == ["Red", "Ice"]
    assert ("Red" in names(swatch, 0)) is (key != "ShiftModifier")
    swatch.library.history.undo()
    assert swatch.library.palette(other) == Palette("Other")
    assert swatch.library.palette(swatch.session.states[0].scope.palette) == first
    swatch.library.history.redo()
    assert names(swatch, 1) == ["Red", "Ice"]


def test_a_drop_on_a_group_and_on_a_tag_of_the_library(swatch, drop) -> None:
    tree, key = swatch.window.tree, swatch.session.state.scope.palette
    model = swatch.window.panes[0].model
    for scope, wanted in ((Scope(key, ("Cold",)), "group"), (Scope(key, (), "hot"), "tags")):
        item = tree.item_of(scope)
        tree.expandAll()
        drop(tree.viewport(), tree.visualItemRect(item).center(), model.mime_of(["black"]))
        value = getattr(swatch.session.palette.entry("black"), wanted)
        assert value == (("Cold",) if wanted == "group" else ("hot",))


def test_keys_alone_select_move_and_order(swatch, names, select, command) -> None:
    grid = swatch.window.panes[0].grid
    select(swatch, "Silver")
    grid.setFocus()
    QTest.keyClick(grid, Qt.Key.Key_Right)
    assert swatch.session.selected == ("black",)
    QTest.keyClick(grid, Qt.Key.Key_End, Qt.KeyboardModifier.ShiftModifier)
    assert len(swatch.session.selected) == 5
    select(swatch, "Red")
    command(swatch, "later")
    assert names(swatch)[2:4] == ["Orange", "Red"]
    command(swatch, "earlier")
    assert names(swatch)[2:4] == ["Red", "Orange"]
    swatch.window.bar.sort.setCurrentIndex(swatch.window.bar.sort.findData("lightness"))
    swatch.window.bar.sort_chosen.emit("lightness")
    assert names(swatch)[0] == "Black"
    command(swatch, "keep_order")
    assert [entry.name for entry in swatch.session.palette] == [
        "Black",
        "Blue",
        "Red",
        "Silver",
        "Orange",
        "Ice",
    ]
    command(swatch, "select_all")
    command(swatch, "invert")
    assert swatch.session.selected == ()


def test_a_refused_edit_changes_nothing_and_is_reported(swatch, select) -> None:
    before = swatch.session.palette
    select(swatch, "Red")
    swatch.window.swatch.edited.emit("tags", ", ".join(f"t{number}" for number in range(60)))
    assert swatch.session.palette is before
    assert "more than the 50 allowed" in swatch.window.messages.shown()["edit"].what


def test_a_screen_reader_gets_the_current_swatch(swatch, select) -> None:
    grid = swatch.window.panes[0].grid
    select(swatch, "Silver")
    QTest.keyClick(grid, Qt.Key.Key_Right)
    assert grid.accessibleDescription().startswith("Black, L* 5, a* 0, b* 0 at 45°, flop ")
    unnamed = [
        widget
        for widget in swatch.window.findChildren(QLineEdit)
        if widget.isVisible() and not widget.accessibleName() and widget.objectName() != "qt_spinbox_lineedit"
    ]
    assert unnamed == []


def test_the_sample_paints_are_copied_from_and_not_changed(swatch, names, select, drop, command) -> None:
    mine = swatch.session.state.scope.palette
    command(swatch, "two_panes")
    command(swatch, "shipped")
    shipped = swatch.session.state.scope.palette
    before = swatch.library.palette(shipped)
    swatch.session.show_scope(Scope(mine), 0)
    model = swatch.window.panes[1].model
    first = model.id_at(0)
    grid = swatch.window.panes[0].grid
    drop(grid.viewport(), QPoint(12, 60), model.mime_of([first]), Qt.KeyboardModifier.ShiftModifier)
    assert before.entry(first).name in names(swatch, 0)
    assert swatch.library.palette(shipped) is before
    # Nothing is taken by it: the pointer shows that while the drag is over it.
    back = swatch.window.panes[1].grid.viewport()
    drop(back, QPoint(12, 60), swatch.window.panes[0].model.mime_of(["red"]))
    select(swatch, before.entry(first).name, pane=1)
    for key in ("cut", "paste", "delete", "rename", "new_group"):
        assert not swatch.window.command(key).isEnabled()
    assert swatch.window.swatch.fields["name"].isReadOnly()
    swatch.window.swatch.edited.emit("code", "X1")
    assert swatch.library.palette(shipped) is before
    message = swatch.window.messages.shown()["edit"]
    assert "cannot be changed" in message.what
    ((text, act),) = message.actions
    assert text == "Make an Editable Copy"
    act()
    assert not swatch.session.is_read_only
    swatch.window.command("select_all").trigger()
    swatch.window.swatch.edited.emit("code", "X1")
    assert {entry.code for entry in swatch.session.palette} == {"X1"}
    assert len(swatch.library.items) == 3
    swatch.window.command("shipped").trigger()
    assert len(swatch.library.items) == 3


def test_sample_paints_that_are_saved_under_a_name_can_be_changed(swatch, dialogs, command, tmp_path) -> None:
    command(swatch, "shipped")
    assert swatch.session.is_read_only
    dialogs.path = tmp_path / "own.brdfpalette"
    command(swatch, "save_as")
    assert dialogs.path.exists()
    assert not swatch.session.is_read_only
    command(swatch, "select_all")
    command(swatch, "delete")
    assert len(swatch.session.palette) == 0
