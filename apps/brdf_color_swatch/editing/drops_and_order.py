"""Where swatches stand: dropped on panes and on the library, moved by keys, put in the order that is shown."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QMimeData, Qt
from PySide6.QtGui import QDropEvent

from brdf_color_swatch.editing.entry_edits import OWNER, as_added, count_words, what_words, with_date
from brdf_color_swatch.editing.paint_files import take_data
from brdf_color_swatch.editing.transfer import Carried, source_of
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette import GroupPath, Palette


class DropsAndOrder(SwatchFeature):
    """Drops and order. A drag within a palette moves (Ctrl copies), one between palettes copies (Shift moves).

    What moves from one palette to another is one step of both.
    """

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        add = window.add_command
        window.menus["edit"].addSeparator()
        self._of_selected = [
            add("edit", mark("Move Up"), "earlier", lambda: self.step(-1), "earlier"),
            add("edit", mark("Move Do&wn"), "later", lambda: self.step(1), "later"),
        ]
        self._fix_order = add(
            "edit", mark("Appl&y Current Sort"), None, self.keep_order, "keep_order",
            tip=mark("Make the current sort the palette order"),
        )  # fmt: skip
        window.tree.dropped.connect(self.drop_on_scope)
        for pane in window.panes:
            number = pane.number
            pane.dropped.connect(lambda event, row, number=number: self.drop_on_pane(number, event, row))
            pane.grid.drop_action = partial(self._action_on_pane, number)
        window.tree.drop_action = lambda event, scope: self._action_on(event, scope.palette)
        self._enable_always()

    def keep_order(self) -> None:
        """Make the order that is shown the palette's own."""
        shown = self._session.shown[self._session.front]
        ids = [shown.rows.ids[place] for place in shown.places]
        if self._session.edit(tr("Apply current sort"), lambda palette: edits.reorder_entries(palette, ids)):
            self._session.set_state(replace(self._session.state, sort="own", descending=False))

    def step(self, by: int) -> None:
        """Move what is selected one place up or down within what is shown, where that is the user's own order."""
        pane, palette = self._window.panes[self._session.front], self._session.palette
        ids = self._session.selected
        if palette is None or not ids or not self._session.state.keeps_order:
            return
        rows = sorted(row for key in ids if (row := pane.model.row_of(key)) is not None)
        count = pane.model.rowCount()
        at = rows[0] - 1 if by < 0 else rows[-1] + 2
        if not 0 <= at <= count:
            return
        beside = pane.model.entry_at(rows[0] - 1 if by < 0 else rows[-1] + 1)
        before = pane.model.id_at(at) if at < count else None
        name = tr("Move {what}").format(what=count_words(len(ids)))
        self._place(name, self._session.front, list(ids), beside.group, before)

    def drop_on_pane(self, number: int, event: QDropEvent, row: int) -> None:
        """Take what fell on a pane before a row."""
        session, pane = self._session, self._window.panes[number]
        session.set_front(number)
        model = pane.model
        count = model.rowCount()
        own = session.states[number].keeps_order
        before = model.id_at(row) if own and row < count else None
        group: GroupPath | None = session.states[number].scope.group
        if own and count:
            # The group of what it fell beside: within a part before a swatch, at its end behind the last.
            beside = model.entry_at(row if row < count else count - 1)
            group = beside.group
        if not own and not session.states[number].scope.group:
            group = None
        self._drop(event, session.states[number].scope, group, before)

    def drop_on_scope(self, event: QDropEvent, scope: Scope) -> None:
        """Take what fell on a palette, a group or a tag of the library."""
        if not scope.palette:
            for url in event.mimeData().urls():
                if url.isLocalFile():
                    self._window.open_requested.emit(Path(url.toLocalFile()))
            event.acceptProposedAction()
            return
        if self._session.library.palette(scope.palette) is None:
            # It is read first; what was dropped is kept for that time.
            data = _copy_mime(event.mimeData())
            moves = self._moves(event, scope.palette)
            event.acceptProposedAction()
            self._session.loader.load(
                scope.palette, lambda: self._drop_data(data, scope, scope.group, None, moves=moves)
            )
            return
        self._drop(event, scope, scope.group, None)

    def _drop(self, event: QDropEvent, scope: Scope, group: GroupPath | None, before: str | None) -> None:
        moves = self._moves(event, scope.palette)
        # The palettes are changed here, both in one step: the source of the drag has nothing to remove.
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()
        self._drop_data(event.mimeData(), scope, group, before, moves=moves)

    def _drop_data(
        self, data: QMimeData, scope: Scope, group: GroupPath | None, before: str | None, *, moves: bool
    ) -> None:
        library = self._session.library
        take_data(
            data,
            self._session.reading,
            lambda carried: self._put_in(carried, scope, group, before, moves=moves),
            lambda error: library.fails(error, "edit", tr("The palette is unchanged.")),
            self._window.open_requested.emit,
        )

    def _put_in(
        self, carried: Carried, scope: Scope, group: GroupPath | None, before: str | None, *, moves: bool
    ) -> None:
        session = self._session
        if not carried.entries:
            return
        target = scope.palette
        if scope.tag and carried.owner == OWNER and carried.source == target:
            ids, what = list(carried.ids), what_words(carried.entries)
            session.edit(
                tr("Tag {what}").format(what=what),
                lambda palette: with_date(edits.tag_entries(palette, ids, [scope.tag]), ids),
                target,
            )
            return
        if not target or session.library.palette(target) is None:
            target = session.library.add_palette(Palette(tr("Untitled")))
            session.show_scope(Scope(target))
        name = (tr("Move {what}") if moves else tr("Copy {what}")).format(what=what_words(carried.entries))
        if moves and carried.source == target:
            pane = next(
                (p for p, state in enumerate(session.states) if state.scope.palette == target), session.front
            )
            self._place(name, pane, list(carried.ids), group, before)
            return
        known = set(session.library.palette(target).by_id)  # type: ignore[union-attr]  # it is there
        if before not in known:
            before = None  # it was removed while files were read
        entries = as_added(carried.entries, scope.tag)
        fall = () if group is None else group
        changes: dict[str, Callable[[Palette], Palette]] = {
            target: lambda palette: edits.add_entries(palette, entries, fall, before)
        }
        if moves:
            source = session.library.palette(carried.source)
            there = [key for key in carried.ids if source is not None and key in source.by_id]
            if there:
                changes[carried.source] = lambda palette: edits.remove_entries(palette, there)
        if session.edit_many(name, changes):
            after = session.library.palette(target)
            fresh = tuple(key for key in after.by_id if key not in known) if after is not None else ()
            for pane, state in enumerate(session.states):
                if state.scope.palette == target and (pane == 0 or self._window.has_two_panes):
                    session.reveal(fresh, pane)

    def _moves(self, event: QDropEvent, target: str) -> bool:
        """Whether what falls on a palette leaves its old place."""
        owner, source = source_of(event.mimeData())
        if owner != OWNER or self._session.library.is_read_only(source):
            return False
        keys = Qt.KeyboardModifier
        if source == target:
            return not event.modifiers() & keys.ControlModifier
        return bool(event.modifiers() & keys.ShiftModifier)

    def _action_on_pane(self, number: int, event: QDropEvent) -> Qt.DropAction:
        return self._action_on(event, self._session.states[number].scope.palette)

    def _action_on(self, event: QDropEvent, target: str) -> Qt.DropAction:
        """Return what the pointer shows over a palette: that it would move, copy, or take nothing."""
        if self._session.library.is_read_only(target):
            return Qt.DropAction.IgnoreAction
        moves = self._moves(event, target)
        return Qt.DropAction.MoveAction if moves else Qt.DropAction.CopyAction

    def _place(
        self, name: str, pane: int, ids: list[str], group: GroupPath | None, before: str | None
    ) -> None:
        key = self._session.states[pane].scope.palette
        if self._session.edit(name, lambda palette: edits.move_entries(palette, ids, group, before), key):
            self._session.reveal(tuple(ids), pane)

    def _enable(self) -> None:
        state, editable = self._session.state, not self._session.is_read_only
        for action in self._of_selected:
            action.setEnabled(bool(self._session.selected) and state.keeps_order and editable)
        sorted_by = state.sort not in ("own", "nearest")
        self._fix_order.setEnabled(self._session.palette is not None and sorted_by and editable)


def _copy_mime(data: QMimeData) -> QMimeData:
    kept = QMimeData()
    for kind in data.formats():
        kept.setData(kind, data.data(kind))
    return kept
