"""What the window shows of the library: pane states, look and active pane. Contains no widgets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import QObject, Signal

from brdf_color_swatch.grid.filtering import filter_and_sort, is_slow
from brdf_color_swatch.grid.layout import Part
from brdf_color_swatch.grid.model import VisibleRows
from brdf_color_swatch.grid.rows import Rows, group_title
from brdf_color_swatch.grid.view_state import Look, PaneState, Scope
from brdf_color_swatch.library.library import Item, Library
from brdf_color_swatch.library.loading import PaletteLoader
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import SuiteError

Edit = Callable[[Palette], Palette]


class _Selection(NamedTuple):
    """Of the ids that are ``wanted`` those that a palette has, with their entries."""

    palette: Palette | None
    wanted: tuple[str, ...]
    ids: tuple[str, ...]
    entries: tuple[Entry, ...]


class PaletteSession(QObject):
    """The state between library and window.

    Signals:

    - ``shown_changed(pane)``: a pane shows other swatches, or the same in another order.
    - ``state_changed(pane)``: the filter or order of a pane changed.
    - ``front_changed()``: the other pane is worked in.
    - ``selection_changed(pane)``: other swatches are selected in a pane.
    - ``look_changed(old, new)``: form, size, light, or list for grid.
    - ``reveal_requested(pane, ids)``: these swatches are to be selected and seen.
    - ``working_changed(pane)``: the order of a pane is being worked out, or is there.
    """

    shown_changed = Signal(int)
    state_changed = Signal(int)
    front_changed = Signal()
    selection_changed = Signal(int)
    look_changed = Signal(object, object)
    reveal_requested = Signal(int, object)
    working_changed = Signal(int)

    def __init__(self, library: Library, reading: FileReading, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.library, self.reading = library, reading
        self.loader = PaletteLoader(library)
        self.states = [PaneState(), PaneState()]
        self.shown = [VisibleRows(Rows.empty()), VisibleRows(Rows.empty())]
        self._selected: list[tuple[str, ...]] = [(), ()]
        self._selections = [_Selection(None, (), (), ())] * 2
        self._busy = [False, False]
        self.front = 0
        """The number of the pane that is worked in: 0, or 1 for the second."""
        self.look = Look()
        library.palette_changed.connect(self._palette_changed)
        library.items_changed.connect(self._items_changed)
        library.history.travelled.connect(lambda step: self._show_step(library.keys_of(step)))

    @property
    def state(self) -> PaneState:
        return self.states[self.front]

    @property
    def item(self) -> Item | None:
        return self.library.item(self.state.scope.palette)

    @property
    def palette(self) -> Palette | None:
        return self.library.palette(self.state.scope.palette)

    @property
    def is_read_only(self) -> bool:
        """Whether the palette in front comes with the suite and cannot be changed."""
        return self.library.is_read_only(self.state.scope.palette)

    def set_front(self, pane: int) -> None:
        if pane != self.front:
            self.front = pane
            self.front_changed.emit()

    def set_state(self, state: PaneState, pane: int | None = None) -> None:
        pane = self.front if pane is None else pane
        before = self.states[pane]
        if state == before:
            return
        self.states[pane] = state
        if state.scope.palette != before.scope.palette and self.library.item(state.scope.palette) is not None:
            self.loader.load(state.scope.palette)
        self.state_changed.emit(pane)
        self.refresh(pane)

    def show_scope(self, scope: Scope, pane: int | None = None) -> None:
        """Show a palette, a group or a tag; filters of the pane stay only within one palette."""
        pane = self.front if pane is None else pane
        state = self.states[pane]
        if scope.palette != state.scope.palette:
            state = state.cleared()
        self.set_state(replace(state, scope=scope), pane)

    def set_look(self, **changes: Any) -> None:
        old, self.look = self.look, replace(self.look, **changes)
        if old != self.look:
            self.look_changed.emit(old, self.look)
            self.remember()

    def refresh(self, pane: int) -> None:
        state = self.states[pane]
        rows = self.library.rows(state.scope.palette)
        task = f"order {pane}"
        if is_slow(rows, state):
            self._working(pane, True)
            self.library.tasks.submit(
                task,
                lambda request, progress: filter_and_sort(request[0], request[1], progress),
                (rows, state),
                partial(self._take, pane),
                partial(self._fail, pane),
            )
        else:
            self.library.tasks.cancel(task)
            self._take(pane, filter_and_sort(rows, state))

    def is_working(self, pane: int) -> bool:
        """Whether what a pane shows is that of before, and the new order still to come."""
        return self._busy[pane]

    def _take(self, pane: int, shown: VisibleRows) -> None:
        state = self.states[pane]
        self._working(pane, False)
        self.shown[pane] = _with_empty_groups(shown, state, self.library.palette(state.scope.palette))
        self.shown_changed.emit(pane)

    def _fail(self, pane: int, error: Exception) -> None:
        self._working(pane, False)
        self.library.fails(error, "order")

    def _working(self, pane: int, busy: bool) -> None:
        if self._busy[pane] != busy:
            self._busy[pane] = busy
            self.working_changed.emit(pane)

    def _palette_changed(self, key: str) -> None:
        for pane, state in enumerate(self.states):
            if state.scope.palette == key:
                palette = self.library.palette(key)
                scope = _still_there(state.scope, palette)
                if scope != state.scope:
                    self.states[pane] = replace(state, scope=scope)
                    self.state_changed.emit(pane)
                self.refresh(pane)

    def _items_changed(self) -> None:
        for pane, state in enumerate(self.states):
            if state.scope.palette and self.library.item(state.scope.palette) is None:
                self.set_state(PaneState(), pane)

    def _show_step(self, keys: list[str]) -> None:
        """Let what was undone or done again be seen."""
        shown = {state.scope.palette for state in self.states}
        if keys and not shown.intersection(keys):
            self.show_scope(Scope(keys[0]))

    def set_selected(self, pane: int, ids: tuple[str, ...]) -> None:
        """Note what is selected in a pane, in the order of its rows."""
        if ids != self._selected[pane]:
            self._selected[pane] = ids
            self.selection_changed.emit(pane)

    @property
    def selected(self) -> tuple[str, ...]:
        """The ids that are selected in the pane in front."""
        return self._selection(self.front).ids

    @property
    def selected_entries(self) -> tuple[Entry, ...]:
        """The entries that are selected in the pane in front, in the order of its rows."""
        return self.selected_in(self.front)

    def selected_in(self, pane: int) -> tuple[Entry, ...]:
        """Return the entries that are selected in a pane."""
        return self._selection(pane).entries

    def _selection(self, pane: int) -> _Selection:
        """Return what is selected in a pane and still there; looked up once for all that follows from it."""
        palette, ids = self.library.palette(self.states[pane].scope.palette), self._selected[pane]
        known = self._selections[pane]
        if known.palette is not palette or known.wanted is not ids:
            found = ids
            entries: tuple[Entry, ...] = ()
            if palette is None:
                found = ()
            elif ids:
                places = list(map(palette.by_id.get, ids))
                if None in places:
                    found = tuple(key for key, place in zip(ids, places, strict=True) if place is not None)
                entries = tuple([palette.entries[place] for place in places if place is not None])
            known = self._selections[pane] = _Selection(palette, ids, found, entries)
        return known

    def reveal(self, ids: tuple[str, ...], pane: int | None = None) -> None:
        self.reveal_requested.emit(self.front if pane is None else pane, ids)

    def edit(self, name: str, change: Edit, key: str | None = None) -> bool:
        """Change a palette (that in front) in one step; a refusal is reported, and nothing changes."""
        key = self.state.scope.palette if key is None else key
        return self.edit_many(name, {key: change})

    def edit_many(self, name: str, changes: dict[str, Edit]) -> bool:
        """Change some palettes, all of it one step; where one is refused, none changes."""
        locked = next((key for key in changes if self.library.is_read_only(key)), None)
        if locked is not None:
            self._refuse(locked)
            return False
        edits = []
        try:
            for key, change in changes.items():
                palette = self.library.palette(key)
                if palette is None:
                    return False
                edits.append((key, change(palette)))
        except SuiteError as error:
            self.library.fails(error, "edit", tr("The palette is unchanged."))
            return False
        self.library.settled.emit("edit")
        return self.library.edit(name, *edits)

    def copy_palette(self, key: str) -> None:
        """Show a copy of a palette that has no file yet and can be changed."""
        palette = self.library.palette(key)
        if palette is not None:
            name = tr("{name} (copy)").format(name=palette.name[:180])
            self.show_new(replace(palette, name=name), clean=False)

    def show_new(self, palette: Palette, *, clean: bool = True) -> None:
        """Show a palette that has no file yet; one that is not ``clean`` has something to be saved."""
        self.show_scope(Scope(self.library.add_palette(palette, clean=clean)))

    def show_new_in(self, path: Path, palette: Palette) -> None:
        """Show a new palette and save it to a file; where that cannot be written, it is still to be saved."""
        key = self.library.add_palette(palette, clean=False)
        self.show_scope(Scope(key))
        self.library.save_to(key, path)

    def _refuse(self, key: str) -> None:
        item = self.library.item(key)
        text = tr("“{name}” comes with the suite and cannot be changed.")
        copy = (tr("Make an Editable Copy"), partial(self.copy_palette, key))
        name = "" if item is None else item.title[:80]
        self.library.message.emit(Message("edit", text.format(name=name), actions=(copy,)))

    def remember(self) -> None:
        """Keep the look for the next start."""
        for key, value in self.look.to_json().items():
            settings().setValue(f"look/{key}", value)

    def recall(self) -> None:
        """Take up the look of the last run; what is damaged there is left as it is at a first start."""
        store, known = settings(), self.look.to_json()
        found = {key: store.value(f"look/{key}", value, type=type(value)) for key, value in known.items()}
        self.look = Look.from_json(found)


def _still_there(scope: Scope, palette: Palette | None) -> Scope:
    if palette is None or not scope.group:
        return scope
    known = {group.path for group in palette.groups}
    group = scope.group
    while group and group not in known:
        group = group[:-1]
    return replace(scope, group=group)


def _with_empty_groups(shown: VisibleRows, state: PaneState, palette: Palette | None) -> VisibleRows:
    """Show the headings of empty groups too, so that something can be put there; not while a search narrows."""
    if palette is None or state.is_filtered or not state.keeps_order or state.scope.tag:
        return shown
    depth = len(state.scope.group)
    titles = {part.title for part in shown.parts}
    end = shown.parts[-1].first + shown.parts[-1].count if shown.parts else 0
    around = {other.path[:length] for other in palette.groups for length in range(1, len(other.path))}
    more = tuple(
        Part(title, end, 0)
        for group in palette.groups
        if group.path[:depth] == state.scope.group
        and len(group.path) > depth
        and (title := group_title(group.path)) not in titles
        and group.path not in around
    )
    return replace(shown, parts=(*shown.parts, *more)) if more else shown
