"""The Edit menu: undo, clipboard, names, tags, groups; and what is dropped. Every gesture is one named step."""

from __future__ import annotations

import uuid
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from brdf_qt.translation import mark, tr
from PySide6.QtCore import QMimeData, QPoint, Qt
from PySide6.QtGui import QDropEvent, QGuiApplication, QKeySequence
from PySide6.QtWidgets import QMenu

from brdf_color_swatch.desk import Desk
from brdf_color_swatch.swatch_panel import today
from brdf_color_swatch.transfer import Carried, carry, hexes_of, taken
from brdf_color_swatch.view_state import Scope
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette import Entry, Group, GroupPath, Palette
from brdf_suite.errors import SuiteError

OWNER = uuid.uuid4().hex
"""This run of the program: a cut or a drag from another one is a copy."""


def add_entries(
    desk: Desk, name: str, entries: Sequence[Entry], group: GroupPath | None = None, before: str | None = None
) -> bool:
    """Add entries to the palette in front as one step, select and show them; True where that was done."""
    palette = desk.palette
    if palette is None or not entries:
        return False
    known = set(palette.by_id)
    if group is None:
        group = desk.state.scope.group
    tag = desk.state.scope.tag
    if tag:
        # What is put where a tag is shown has that tag; otherwise it would vanish as it comes.
        entries = [replace(e, tags=tuple(dict.fromkeys((*e.tags, tag)))) for e in entries]
    dated = [entry if entry.date else replace(entry, date=today()) for entry in entries]
    if not desk.edit(name, lambda old: edits.added(old, dated, group, before)):
        return False
    after = desk.palette
    assert after is not None
    desk.reveal(tuple(key for key in after.by_id if key not in known))
    return True


class EditPart:
    """Edits of swatches and groups."""

    def __init__(self, desk: Desk, window: SwatchWindow) -> None:
        self._desk, self._window = desk, window
        self._cut: Carried | None = None
        keys = QKeySequence.StandardKey
        add, edit = window.add_command, window.menu("edit")
        undo = add(
            "edit",
            mark("&Undo"),
            keys.Undo,
            desk.library.history.undo,
            "undo",
            icon="arrow-counter-clockwise",
        )
        redo = add(
            "edit", mark("&Redo"), "Ctrl+Shift+Z", desk.library.history.redo, "redo", icon="arrow-clockwise"
        )
        redo.setShortcuts([QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")])
        edit.addSeparator()
        self._of_selected = [
            add("edit", mark("Cu&t"), keys.Cut, self.cut, "cut", icon="scissors"),
            add("edit", mark("&Copy"), keys.Copy, self.copy, "copy", icon="copy"),
        ]
        self._paste = add("edit", mark("&Paste"), keys.Paste, self.paste, "paste", icon="clipboard")
        self._of_selected += [
            add("edit", mark("D&uplicate"), "Ctrl+D", self.duplicate, "duplicate"),
            add("edit", mark("&Delete"), keys.Delete, self.delete, "delete", icon="trash"),
        ]
        edit.addSeparator()
        add("edit", mark("Select &All"), keys.SelectAll, self.select_all, "select_all")
        add(
            "edit",
            mark("Select N&one"),
            "Ctrl+Shift+A",
            lambda: desk.reveal_asked.emit(desk.front, ()),
            "select_none",
        )
        add("edit", mark("&Invert Selection"), "Ctrl+I", self.invert, "invert")
        edit.addSeparator()
        self._of_selected += [
            add("edit", mark("Re&name"), "F2", self.rename, "rename", icon="pencil-simple"),
            add("edit", mark("Ta&gs"), "Ctrl+T", lambda: self._focus("tags"), "tags", icon="tag"),
            add("edit", mark("Not&es"), "Ctrl+E", lambda: self._focus("notes"), "notes"),
            add("edit", mark("Move &Before the One Above"), "Alt+Left", lambda: self.step(-1), "earlier"),
            add("edit", mark("Move Be&hind the One Below"), "Alt+Right", lambda: self.step(1), "later"),
        ]
        edit.addSeparator()
        self._new_group = add(
            "edit", mark("New G&roup"), "Ctrl+G", self.new_group, "new_group", icon="folder-plus",
            tip=mark("New group of what is selected"),
        )  # fmt: skip
        self._of_group = [
            add("edit", mark("Rena&me Group"), "Shift+F2", self.rename_group, "rename_group"),
            add("edit", mark("Dissol&ve Group"), "Ctrl+Shift+G", self.dissolve_group, "dissolve_group"),
            add("edit", mark("Remo&ve Group with its Swatches"), None, self.remove_group, "remove_group"),
        ]
        self._fix_order = add(
            "edit", mark("Keep the Order that Is S&hown"), None, self.keep_order, "keep_order",
            tip=mark("Makes the order that is shown the palette's own"),
        )  # fmt: skip
        for action in (undo, redo):
            window.toolbar.addAction(action)
        window.toolbar.addSeparator()
        window.add_library_button(self._new_group)
        window.swatch.edited.connect(self.write)
        window.palette_panel.edited.connect(self.write_palette)
        window.tree.renamed.connect(self.rename_scope)
        window.tree.dropped.connect(self.drop_on_scope)
        window.tree.group_dropped.connect(self.move_group)
        for pane in window.panes:
            number = pane.number
            pane.renamed.connect(self._renamed)
            pane.dropped.connect(lambda event, row, number=number: self.drop_on_pane(number, event, row))
            pane.menu_asked.connect(self._menu)
            pane.model.mime_of = lambda ids, number=number: self._mime(number, ids)
        desk.selection_changed.connect(lambda _pane: self._enable())
        desk.shown_changed.connect(lambda _pane: self._enable())
        desk.state_changed.connect(lambda _pane: self._enable())
        desk.front_changed.connect(self._enable)
        self._enable()

    # Clipboard.

    def copy(self) -> None:
        """Put what is selected on the clipboard: whole, and as text and colour for other programs."""
        entries = self._desk.selected_entries
        if entries:
            self._cut = None
            QGuiApplication.clipboard().setMimeData(self._carry(entries, self._desk.state.scope.palette))

    def cut(self) -> None:
        """Put what is selected on the clipboard, and take it out of the palette."""
        entries = self._desk.selected_entries
        if entries:
            self.copy()
            self._remove(tr("Cut {what}").format(what=_what(entries)))

    def paste(self) -> None:
        """Put in what the clipboard holds, before the current swatch."""
        try:
            carried = taken(QGuiApplication.clipboard().mimeData())
        except SuiteError as error:
            self._desk.library.fails(error, "edit", tr("The palette is as it was."))
            return
        for path in carried.files:
            self._window.open_asked.emit(path)
        if not carried.entries:
            if not carried.files:
                self._desk.library.fails(
                    SuiteError(tr("The clipboard holds no swatch, paint or colour.")), "edit",
                    tr("Copy swatches, a paint, or text with colours such as #3366cc or L*a*b* numbers."),
                )  # fmt: skip
            return
        if self._desk.palette is None:
            self._desk.show_scope(Scope(self._desk.library.add_palette(Palette(tr("Untitled")))))
        self._desk.library.settled.emit("edit")
        group = self._desk.state.scope.group
        add_entries(
            self._desk, tr("Paste {what}").format(what=_what(carried.entries)), carried.entries, group
        )

    def duplicate(self) -> None:
        """Copy what is selected behind the last of it."""
        entries, palette = self._desk.selected_entries, self._desk.palette
        if entries and palette is not None:
            last = max(palette.by_id[entry.id] for entry in entries)
            before = palette.entries[last + 1].id if last + 1 < len(palette) else None
            name = tr("Duplicate {what}").format(what=_what(entries))
            copies = [replace(entry, id="") for entry in entries]
            known = set(palette.by_id)
            if self._desk.edit(name, lambda old: edits.added(old, copies, None, before)):
                after = self._desk.palette
                assert after is not None
                self._desk.reveal(tuple(key for key in after.by_id if key not in known))

    def delete(self) -> None:
        """Take what is selected out of the palette."""
        entries = self._desk.selected_entries
        if entries:
            self._remove(tr("Delete {what}").format(what=_what(entries)))

    def _remove(self, name: str) -> None:
        ids = self._desk.selected
        pane = self._window.panes[self._desk.front]
        rows = [row for key in ids if (row := pane.model.row_of(key)) is not None]
        self._desk.edit(name, lambda palette: edits.removed(palette, ids))
        # What comes in their place is selected, so that the keys go on from there.
        count = pane.model.rowCount()
        if rows and count:
            pane.reveal((pane.model.id_at(min(min(rows), count - 1)),))

    def _carry(self, entries: Sequence[Entry], source: str) -> QMimeData:
        rows = self._desk.library.rows(source)
        by_id = {key: place for place, key in enumerate(rows.ids)}
        lab = [rows.lab[by_id[entry.id], 1] for entry in entries]
        return carry(entries, hexes_of(np.nan_to_num(lab, nan=50.0).tolist()), source, OWNER)

    def _mime(self, number: int, ids: list[str]) -> QMimeData | None:
        key = self._desk.states[number].scope.palette
        palette = self._desk.library.palette(key)
        return None if palette is None else self._carry([palette.entry(one) for one in ids], key)

    # Selection.

    def select_all(self) -> None:
        """Select all that is shown."""
        self._window.panes[self._desk.front].grid.selectAll()

    def invert(self) -> None:
        """Select what is not selected."""
        pane = self._window.panes[self._desk.front]
        chosen = set(self._desk.selected)
        pane.grid.select_rows(
            [row for row in range(pane.model.rowCount()) if pane.model.id_at(row) not in chosen]
        )

    # Names, tags and notes.

    def rename(self) -> None:
        """Write the current swatch's name anew, in its place."""
        self._window.panes[self._desk.front].rename_current()

    def _focus(self, key: str) -> None:
        self._window.inspector_dock.show()
        self._window.section("swatch").set_open(True)
        self._window.swatch.focus(key)

    def _renamed(self, id_: str, key: str, text: str) -> None:
        if key == "name":
            if text:
                self._desk.edit(
                    tr("Rename to “{name}”").format(name=text[:40]),
                    lambda palette: _dated(edits.renamed(palette, id_, text), [id_]),
                )
        else:
            self._change(tr("Change the code"), [id_], lambda entry: replace(entry, code=text))

    def write(self, key: str, text: str) -> None:
        """Write a field of the inspector into all that is selected."""
        ids = list(self._desk.selected)
        if not ids:
            return
        if key == "name":
            self._change(
                tr("Rename {what}").format(what=_count(len(ids))),
                ids,
                lambda entry: replace(entry, content=replace(entry.content, name=text)),
            )
        elif key == "code":
            self._change(tr("Change the code"), ids, lambda entry: replace(entry, code=text))
        elif key == "notes":
            self._change(tr("Change the notes"), ids, lambda entry: replace(entry, notes=text))
        else:
            self._tag(ids, text)

    def _tag(self, ids: list[str], text: str) -> None:
        words = [word.strip() for word in text.replace(";", ",").split(",") if word.strip()]
        drop = [word[1:].strip() for word in words if word.startswith("-")]
        add = [word.removeprefix("+").strip() for word in words if not word.startswith("-")]
        relative = len(ids) > 1 and all(word[0] in "+-" for word in words) and bool(words)
        name = tr("Change the tags of {what}").format(what=_count(len(ids)))
        if relative:
            self._desk.edit(name, lambda palette: _dated(edits.tagged(palette, ids, add, drop), ids))
        else:
            tags = tuple(dict.fromkeys(word for word in add if word))
            self._change(name, ids, lambda entry: replace(entry, tags=tags))

    def _change(self, name: str, ids: list[str], change: Callable[[Entry], Entry]) -> None:
        self._desk.edit(name, lambda palette: _dated(edits.changed(palette, ids, change), ids))

    def write_palette(self, key: str, text: str) -> None:
        """Write a field of the palette, or of the group that is shown."""
        group = self._desk.state.scope.group
        if key == "name":
            self.rename_scope(self._desk.state.scope, text)
            return
        name = tr("Change the colour") if key == "colour" else tr("Change the notes")
        if group:
            self._desk.edit(
                name,
                lambda palette: edits.changed_group(palette, group, lambda one: replace(one, **{key: text})),
            )
        else:
            self._desk.edit(name, lambda palette: replace(palette, **{key: text}))

    # Groups.

    def new_group(self) -> None:
        """Make a group within the one that is shown, of what is selected, and let it be named."""
        palette, scope = self._desk.palette, self._desk.state.scope
        if palette is None:
            return
        known = {group.path for group in palette.groups}
        name, number = tr("New group"), 1
        while (*scope.group, name) in known:
            number += 1
            name = tr("New group {number}").format(number=number)
        path = (*scope.group, name)
        ids = self._desk.selected

        def make(old: Palette) -> Palette:
            with_it = edits.with_group(old, Group(path))
            return edits.changed(with_it, ids, lambda entry: replace(entry, group=path)) if ids else with_it

        if self._desk.edit(tr("New group"), make):
            self._window.tree.rename(Scope(scope.palette, path))

    def rename_group(self) -> None:
        """Write the name of the group that is shown anew, in the library."""
        scope = self._desk.state.scope
        self._window.tree.rename(scope if scope.group else Scope(scope.palette))

    def dissolve_group(self) -> None:
        """Take the group away; its swatches move to the group around it."""
        self._drop_group(tr("Dissolve a group"), keep=True)

    def remove_group(self) -> None:
        """Take the group away, with its swatches."""
        self._drop_group(tr("Remove a group"), keep=False)

    def _drop_group(self, name: str, *, keep: bool) -> None:
        path = self._desk.state.scope.group
        if path:
            self._desk.edit(name, lambda palette: edits.without_group(palette, path, keep_entries=keep))

    def rename_scope(self, scope: Scope, name: str) -> None:
        """Rename a palette, a group or a tag."""
        told = tr("Rename to “{name}”").format(name=name[:40])
        if scope.tag:

            def retag(entry: Entry) -> Entry:
                tags = dict.fromkeys(name if tag == scope.tag else tag for tag in entry.tags)
                return replace(entry, tags=tuple(tags))

            palette = self._desk.library.palette(scope.palette)
            ids = (
                [entry.id for entry in palette.entries if scope.tag in entry.tags]
                if palette is not None
                else []
            )
            done = self._desk.edit(told, lambda old: edits.changed(old, ids, retag), scope.palette)
            new = replace(scope, tag=name)
        elif scope.group:
            done = self._desk.edit(
                told, lambda old: edits.renamed_group(old, scope.group, name), scope.palette
            )
            new = replace(scope, group=(*scope.group[:-1], name))
        else:
            self._desk.edit(told, lambda old: replace(old, name=name), scope.palette)
            return
        if done:
            for pane, state in enumerate(self._desk.states):
                if state.scope == scope or (not scope.tag and _inside(state.scope, scope)):
                    path = (*new.group, *state.scope.group[len(scope.group) :]) if scope.group else ()
                    tag = new.tag if scope.tag else state.scope.tag
                    self._desk.show_scope(Scope(scope.palette, path, tag), pane)

    def move_group(self, moved: Scope, onto: Scope) -> None:
        """Move a group into another, to the palette's top, or with all that is in it to another palette."""
        if onto.palette != moved.palette:
            self._desk.library.want(onto.palette, lambda: self._carry_group(moved, onto))
            return
        if onto.group[: len(moved.group)] == moved.group:
            return
        to = (*onto.group, moved.group[-1])
        if to != moved.group:
            self._desk.edit(
                tr("Move a group"), lambda palette: edits.moved_group(palette, moved.group, to), moved.palette
            )

    def _carry_group(self, moved: Scope, onto: Scope) -> None:
        """Move a group to another palette: one step of both."""
        source = self._desk.library.palette(moved.palette)
        if source is None:
            return
        depth = len(moved.group)

        def there(path: GroupPath) -> GroupPath:
            return (*onto.group, moved.group[-1], *path[depth:])

        groups = [group for group in source.groups if group.path[:depth] == moved.group]
        entries = [
            replace(entry, group=there(entry.group))
            for entry in source.entries
            if entry.group[:depth] == moved.group
        ]

        def take(palette: Palette) -> Palette:
            known = {group.path for group in palette.groups}
            fresh = [replace(group, path=there(group.path)) for group in groups]
            fresh = [group for group in fresh if group.path not in known]
            return edits.added(replace(palette, groups=(*palette.groups, *fresh)), entries)

        self._desk.edit_many(
            tr("Move the group “{name}”").format(name=moved.group[-1][:40]),
            {onto.palette: take, moved.palette: lambda palette: edits.without_group(palette, moved.group)},
        )

    # Order and drops.

    def keep_order(self) -> None:
        """Make the order that is shown the palette's own."""
        shown = self._desk.shown[self._desk.front]
        ids = [shown.rows.ids[place] for place in shown.places]
        if self._desk.edit(tr("Keep an order"), lambda palette: edits.reordered(palette, ids)):
            self._desk.set_state(replace(self._desk.state, sort="own", descending=False))

    def step(self, by: int) -> None:
        """Move what is selected one place up or down within what is shown, where that is the user's own order."""
        pane, palette = self._window.panes[self._desk.front], self._desk.palette
        ids = self._desk.selected
        if palette is None or not ids or not self._desk.state.keeps_order:
            return
        rows = sorted(row for key in ids if (row := pane.model.row_of(key)) is not None)
        count = pane.model.rowCount()
        at = rows[0] - 1 if by < 0 else rows[-1] + 2
        if not 0 <= at <= count:
            return
        beside = pane.model.entry_at(rows[0] - 1 if by < 0 else rows[-1] + 1)
        before = pane.model.id_at(at) if at < count else None
        self._place(
            tr("Move {what}").format(what=_count(len(ids))), self._desk.front, list(ids), beside.group, before
        )

    def drop_on_pane(self, number: int, event: QDropEvent, row: int) -> None:
        """Take what fell on a pane before a row: swatches of this program are moved, or copied with Ctrl."""
        desk, pane = self._desk, self._window.panes[number]
        desk.set_front(number)
        model = pane.model
        count = model.rowCount()
        own = desk.states[number].keeps_order
        before = model.id_at(row) if own and row < count else None
        group: GroupPath | None = desk.states[number].scope.group
        if own and count:
            # The group of what it fell beside: within a part before a swatch, at its end behind the last.
            beside = model.entry_at(row if row < count else count - 1)
            group = beside.group
        if not own and not desk.states[number].scope.group:
            group = None
        self._drop(event, desk.states[number].scope, group, before)

    def drop_on_scope(self, event: QDropEvent, scope: Scope) -> None:
        """Take what fell on a palette, a group or a tag of the library."""
        if not scope.palette:
            for url in event.mimeData().urls():
                if url.isLocalFile():
                    from pathlib import Path

                    self._window.open_asked.emit(Path(url.toLocalFile()))
            event.acceptProposedAction()
            return
        if self._desk.library.palette(scope.palette) is None:
            # It is read first; what was dropped is kept for that time.
            data = _copied(event.mimeData())
            moves = _moves(event)
            event.acceptProposedAction()
            self._desk.library.want(
                scope.palette, lambda: self._drop_data(data, scope, scope.group, None, moves=moves)
            )
            return
        self._drop(event, scope, scope.group, None)

    def _drop(self, event: QDropEvent, scope: Scope, group: GroupPath | None, before: str | None) -> None:
        moves = _moves(event)
        # The palettes are changed here, both in one step: whoever began the drag has nothing to remove.
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()
        self._drop_data(event.mimeData(), scope, group, before, moves=moves)

    def _drop_data(
        self, data: QMimeData, scope: Scope, group: GroupPath | None, before: str | None, *, moves: bool
    ) -> None:
        desk = self._desk
        try:
            carried = taken(data)
        except SuiteError as error:
            desk.library.fails(error, "edit", tr("The palette is as it was."))
            return
        for path in carried.files:
            self._window.open_asked.emit(path)
        if not carried.entries:
            return
        target = scope.palette
        if scope.tag and carried.owner == OWNER and carried.source == target:
            ids, what = list(carried.ids), _what(carried.entries)
            desk.edit(
                tr("Tag {what}").format(what=what),
                lambda palette: _dated(edits.tagged(palette, ids, [scope.tag]), ids),
                target,
            )
            return
        if not target or desk.library.palette(target) is None:
            target = desk.library.add_palette(Palette(tr("Untitled")))
            desk.show_scope(Scope(target))
        moves = moves and carried.owner == OWNER
        name = (tr("Move {what}") if moves else tr("Copy {what}")).format(what=_what(carried.entries))
        if moves and carried.source == target:
            pane = next(
                (p for p, state in enumerate(desk.states) if state.scope.palette == target), desk.front
            )
            self._place(name, pane, list(carried.ids), group, before)
            return
        known = set(desk.library.palette(target).by_id)  # type: ignore[union-attr]  # it is there
        entries = [entry if entry.date else replace(entry, date=today()) for entry in carried.entries]
        if scope.tag:
            entries = [replace(e, tags=tuple(dict.fromkeys((*e.tags, scope.tag)))) for e in entries]
        fall = () if group is None else group
        changes: dict[str, Callable[[Palette], Palette]] = {
            target: lambda palette: edits.added(palette, entries, fall, before)
        }
        if moves:
            source = desk.library.palette(carried.source)
            there = [key for key in carried.ids if source is not None and key in source.by_id]
            if there:
                changes[carried.source] = lambda palette: edits.removed(palette, there)
        if desk.edit_many(name, changes):
            after = desk.library.palette(target)
            fresh = tuple(key for key in after.by_id if key not in known) if after is not None else ()
            for pane, state in enumerate(desk.states):
                if state.scope.palette == target and (pane == 0 or self._window.has_two_panes):
                    desk.reveal(fresh, pane)

    def _place(
        self, name: str, pane: int, ids: list[str], group: GroupPath | None, before: str | None
    ) -> None:
        key = self._desk.states[pane].scope.palette
        if self._desk.edit(name, lambda palette: edits.moved(palette, ids, group, before), key):
            self._desk.reveal(tuple(ids), pane)

    # Menus.

    def _menu(self, point: QPoint) -> None:
        menu = QMenu(self._window)
        menu.setObjectName("swatch_menu")
        for key in (
            "rename", "tags", "notes", "", "cut", "copy", "paste", "duplicate", "delete", "", "new_group", "",
            "nearest", "compare", "", "to_designer", "to_viewer", "to_lobes",
        ):  # fmt: skip
            action = self._window.command(key) if key else None
            if action is not None:
                menu.addAction(action)
            elif not key:
                menu.addSeparator()
        menu.popup(point)

    def _enable(self) -> None:
        some = bool(self._desk.selected)
        for action in self._of_selected:
            action.setEnabled(some)
        there = self._desk.palette is not None
        self._new_group.setEnabled(there)
        for action in self._of_group:
            action.setEnabled(bool(self._desk.state.scope.group))
        self._fix_order.setEnabled(there and self._desk.state.sort not in ("own", "nearest"))


def _dated(palette: Palette, ids: Sequence[str]) -> Palette:
    """Note when these entries were changed."""
    moment = today()
    return edits.changed(palette, ids, lambda entry: replace(entry, date=moment))


def _inside(scope: Scope, around: Scope) -> bool:
    return (
        scope.palette == around.palette
        and bool(around.group)
        and scope.group[: len(around.group)] == around.group
    )


def _moves(event: QDropEvent) -> bool:
    """Whether it is a move: Ctrl copies, as everywhere."""
    return not event.modifiers() & Qt.KeyboardModifier.ControlModifier


def _copied(data: QMimeData) -> QMimeData:
    kept = QMimeData()
    for kind in data.formats():
        kept.setData(kind, data.data(kind))
    return kept


def _count(count: int) -> str:
    return tr("one swatch") if count == 1 else tr("{count} swatches").format(count=count)


def _what(entries: Sequence[Entry]) -> str:
    return f"“{entries[0].name[:40]}”" if len(entries) == 1 and entries[0].name else _count(len(entries))
