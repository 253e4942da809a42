"""Groups, and a palette's own name, colour and notes: made, named, moved, dissolved; each a named step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from brdf_qt.program.translation import mark, tr

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette import Entry, Group, GroupPath, Palette


class GroupCommands(SwatchFeature):
    """Commands on groups and palettes, and what the library's names are changed to."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        add = window.add_command
        window.menus["edit"].addSeparator()
        self._new_group = add(
            "edit", mark("New G&roup"), "new_group", self.new_group, "new_group", icon="folder-plus",
            tip=mark("New group from selection"),
        )  # fmt: skip
        self._of_group = [
            add("edit", mark("Rena&me Group"), "rename_group", self.rename_group, "rename_group"),
            add("edit", mark("Dissol&ve Group"), "dissolve_group", self.dissolve_group, "dissolve_group"),
            add("edit", mark("Remo&ve Group and Swatches"), None, self.remove_group, "remove_group"),
        ]
        window.add_library_button(self._new_group)
        window.palette_panel.edited.connect(self.write_palette)
        window.tree.renamed.connect(self.rename_scope)
        window.tree.group_dropped.connect(self.move_group)
        self._enable_always()

    def write_palette(self, key: str, text: str) -> None:
        """Write a field of the palette, or of the group that is shown."""
        group = self._session.state.scope.group
        if key == "name":
            self.rename_scope(self._session.state.scope, text)
            return
        name = tr("Change colour") if key == "colour" else tr("Change notes")
        field: dict[str, Any] = {key: text}
        if group:
            self._session.edit(
                name, lambda old: edits.change_group(old, group, lambda one: replace(one, **field))
            )
        else:
            self._session.edit(name, lambda palette: replace(palette, **field))

    def new_group(self) -> None:
        """Make a group within the one that is shown, of what is selected, and let it be named."""
        palette, scope = self._session.palette, self._session.state.scope
        if palette is None:
            return
        known = {group.path for group in palette.groups}
        name, number = tr("New group"), 1
        while (*scope.group, name) in known:
            number += 1
            name = tr("New group {number}").format(number=number)
        path = (*scope.group, name)
        ids = self._session.selected

        def make(old: Palette) -> Palette:
            old = edits.with_group(old, Group(path))
            return edits.change_entries(old, ids, lambda entry: replace(entry, group=path)) if ids else old

        if self._session.edit(tr("New group"), make):
            self._window.tree.rename(Scope(scope.palette, path))

    def rename_group(self) -> None:
        scope = self._session.state.scope
        self._window.tree.rename(scope if scope.group else Scope(scope.palette))

    def dissolve_group(self) -> None:
        """Take the group away; its swatches move to the group around it."""
        self._drop_group(tr("Dissolve group"), keep=True)

    def remove_group(self) -> None:
        """Take the group away, with its swatches."""
        self._drop_group(tr("Remove group"), keep=False)

    def _drop_group(self, name: str, *, keep: bool) -> None:
        path = self._session.state.scope.group
        if path:
            self._session.edit(name, lambda palette: edits.remove_group(palette, path, keep_entries=keep))

    def rename_scope(self, scope: Scope, name: str) -> None:
        title = tr("Rename to “{name}”").format(name=name[:40])
        if scope.tag:

            def retag(entry: Entry) -> Entry:
                tags = dict.fromkeys(name if tag == scope.tag else tag for tag in entry.tags)
                return replace(entry, tags=tuple(tags))

            palette = self._session.library.palette(scope.palette)
            entries = () if palette is None else palette.entries
            ids = [entry.id for entry in entries if scope.tag in entry.tags]
            done = self._session.edit(title, lambda old: edits.change_entries(old, ids, retag), scope.palette)
            new = replace(scope, tag=name)
        elif scope.group:
            done = self._session.edit(
                title, lambda old: edits.rename_group(old, scope.group, name), scope.palette
            )
            new = replace(scope, group=(*scope.group[:-1], name))
        else:
            self._session.edit(title, lambda old: replace(old, name=name), scope.palette)
            return
        if done:
            for pane, state in enumerate(self._session.states):
                if state.scope == scope or (not scope.tag and _inside(state.scope, scope)):
                    path = (*new.group, *state.scope.group[len(scope.group) :]) if scope.group else ()
                    tag = new.tag if scope.tag else state.scope.tag
                    self._session.show_scope(Scope(scope.palette, path, tag), pane)

    def move_group(self, moved: Scope, onto: Scope, moves: bool = False) -> None:
        """Move a group into another or to the palette's top; to another palette it is copied, or with ``moves`` moved.

        All that is in it goes along. Out of a read-only palette it is always copied.
        """
        if onto.palette != moved.palette:
            moves = moves and not self._session.library.is_read_only(moved.palette)
            self._session.loader.load(onto.palette, lambda: self._carry_group(moved, onto, moves=moves))
            return
        if onto.group[: len(moved.group)] == moved.group:
            return
        to = (*onto.group, moved.group[-1])
        if to != moved.group:
            name = tr("Move group")
            self._session.edit(
                name, lambda palette: edits.move_group(palette, moved.group, to), moved.palette
            )

    def _carry_group(self, moved: Scope, onto: Scope, *, moves: bool) -> None:
        """Copy or move a group to another palette; a move is one step of both."""
        source = self._session.library.palette(moved.palette)
        if source is None:
            return
        depth = len(moved.group)

        def there(path: GroupPath) -> GroupPath:
            return (*onto.group, moved.group[-1], *path[depth:])

        groups = [group for group in source.groups if group.path[:depth] == moved.group]
        inside = (entry for entry in source.entries if entry.group[:depth] == moved.group)
        entries = [replace(entry, group=there(entry.group)) for entry in inside]

        def take(palette: Palette) -> Palette:
            known = {group.path for group in palette.groups}
            fresh = [replace(group, path=there(group.path)) for group in groups]
            fresh = [group for group in fresh if group.path not in known]
            return edits.add_entries(replace(palette, groups=(*palette.groups, *fresh)), entries)

        changes: dict[str, Callable[[Palette], Palette]] = {onto.palette: take}
        if moves:
            changes[moved.palette] = lambda palette: edits.remove_group(palette, moved.group)
        name = tr("Move group “{name}”") if moves else tr("Copy group “{name}”")
        self._session.edit_many(name.format(name=moved.group[-1][:40]), changes)

    def _enable(self) -> None:
        editable = not self._session.is_read_only
        self._new_group.setEnabled(self._session.palette is not None and editable)
        for action in self._of_group:
            action.setEnabled(bool(self._session.state.scope.group) and editable)


def _inside(scope: Scope, around: Scope) -> bool:
    path = around.group
    return scope.palette == around.palette and bool(path) and scope.group[: len(path)] == path
