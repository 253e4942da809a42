"""Connects session and window: shows the state, and turns user input into changes of the session."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import QObject
from PySide6.QtGui import QAction

from brdf_color_swatch.grid.pane import Pane
from brdf_color_swatch.grid.rows import group_title
from brdf_color_swatch.grid.view_state import Look, PaneState, Scope
from brdf_color_swatch.library.library import Item
from brdf_color_swatch.panels.swatch import readings_of
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.appearance.colour.flat_colours import display_notes
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry
from brdf_suite.foreign_text import make_visible
from brdf_suite.palettes.columns import Columns


class PaletteController(QObject):
    """Keeps the window in step with the session."""

    def __init__(self, session: PaletteSession, window: SwatchWindow, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._window = session, window
        self._join()

    def start(self) -> None:
        """Show everything for the first time."""
        self._show_items()
        for pane in self._window.panes:
            self._show_rows(pane.number)
        self._show_state(self._session.front)
        self._show_look(None, self._session.look)
        self._show_history()

    def _join(self) -> None:
        session, window, library = self._session, self._window, self._session.library
        session.shown_changed.connect(self._show_rows)
        session.state_changed.connect(self._show_state)
        session.front_changed.connect(self._show_front)
        session.selection_changed.connect(self._show_selection)
        session.working_changed.connect(lambda number: self._show_title(window.panes[number]))
        session.look_changed.connect(self._show_look)
        session.reveal_requested.connect(lambda pane, ids: window.panes[pane].reveal(ids))
        library.items_changed.connect(self._show_items)
        library.palette_changed.connect(lambda _key: self._show_selection(session.front))
        library.message.connect(window.show_message)
        library.settled.connect(window.dismiss_message)
        library.history.changed.connect(self._show_history)
        window.tree.scope_chosen.connect(session.show_scope)
        bar = window.bar
        bar.search.searched.connect(lambda text: session.set_state(replace(session.state, text=text)))
        bar.search.left_downwards.connect(lambda: window.panes[session.front].view.setFocus())
        bar.sort_chosen.connect(lambda key: session.set_state(replace(session.state, sort=key)))
        bar.turned.connect(
            lambda: session.set_state(replace(session.state, descending=not session.state.descending))
        )
        bar.form_chosen.connect(lambda form: session.set_look(form=form, as_list=False))
        bar.size_chosen.connect(lambda size: session.set_look(size=size))
        bar.light_chosen.connect(lambda name: session.set_look(booth=name))
        bar.list_chosen.connect(lambda on: session.set_look(as_list=on))
        filters = window.filters
        filters.range_edited.connect(
            lambda key, low, high: session.set_state(session.state.with_range(key, low, high))
        )
        filters.duplicates_requested.connect(
            lambda value: session.set_state(replace(session.state, duplicates=value))
        )
        filters.cleared.connect(lambda: session.set_state(session.state.cleared()))
        window.second_pane_requested.connect(self.show_second)
        for pane in window.panes:
            number = pane.number
            pane.activated.connect(lambda number=number: session.set_front(number))
            pane.selected.connect(lambda ids, number=number: session.set_selected(number, ids))
            pane.grid.size_requested.connect(lambda size: session.set_look(size=size))
            pane.model.sort_requested.connect(
                lambda key, descending, number=number: session.set_state(
                    replace(session.states[number], sort=key, descending=descending), number
                )
            )
            pane.close_requested.connect(lambda: self.show_second(False))

    def show_second(self, shown: bool) -> None:
        """Show a second pane, of the same palette at first, or one alone."""
        session = self._session
        if shown and not session.states[1].scope.palette:
            session.set_state(PaneState(Scope(session.states[0].scope.palette)), 1)
        self._window.show_second(shown)
        session.set_front(1 if shown else 0)
        for pane in self._window.panes:
            self._show_title(pane)

    def _show_items(self) -> None:
        session, window = self._session, self._window
        window.tree.show_items(session.library.items)
        window.tree.show_scope(session.state.scope)
        for pane in window.panes:
            self._show_title(pane)
            self._show_note(pane)
        self._show_window_title()

    def _show_window_title(self) -> None:
        item = self._session.item
        if item is None:
            self._window.show_title("", None, clean=True)
        else:
            self._window.show_title(item.title[:200], item.path, clean=item.is_clean)

    def _show_rows(self, number: int) -> None:
        pane, shown = self._window.panes[number], self._session.shown[number]
        pane.show_rows(shown)
        self._show_title(pane)
        self._show_note(pane)
        if number == self._session.front:
            self._show_counts()

    def _show_state(self, number: int) -> None:
        state, window = self._session.states[number], self._window
        window.panes[number].show_sort(state.sort, descending=state.descending)
        if number == self._session.front:
            window.bar.show_state(state)
            window.filters.show_state(state)
            window.tree.show_scope(state.scope)
            self._show_palette_fields()
            self._show_window_title()

    def _show_front(self) -> None:
        self._show_state(self._session.front)
        self._show_selection(self._session.front)
        for pane in self._window.panes:
            self._show_title(pane)

    def _show_title(self, pane: Pane) -> None:
        state, item = self._session.states[pane.number], self._item(pane)
        title = "" if item is None else item.title[:200]
        if state.scope.group:
            title = f"{title} › {group_title(state.scope.group)[:200]}"
        if state.scope.tag:
            title = tr("{palette}, tag {tag}").format(palette=title, tag=state.scope.tag)
        if state.near is not None:
            title = tr("{palette}, nearest to {paint}").format(palette=title, paint=state.near.name[:80])
        shown, whole = len(pane.model.shown.places), len(pane.model.shown.rows)
        count = tr("1 swatch") if whole == 1 else tr("{count} swatches").format(count=whole)
        if shown != whole:
            count = tr("{shown} of {count}").format(shown=shown, count=whole)
        elif item is None:
            count = ""
        if self._session.is_working(pane.number):
            count = tr("({count}, working)").format(count=count)
        pane.model.read_only = item is not None and item.read_only
        if pane.model.read_only:
            title = tr("{palette} (read-only)").format(palette=title)
        front = pane.number == self._session.front
        pane.show_title(title, count, front=front, two=self._window.has_two_panes)

    def _item(self, pane: Pane) -> Item | None:
        return self._session.library.item(self._session.states[pane.number].scope.palette)

    def _show_note(self, pane: Pane) -> None:
        """Say why there are no swatches, and offer what to do."""
        item, state = self._item(pane), self._session.states[pane.number]
        new, opened = (tr("New Palette"), "new"), (tr("Open…"), "open")
        if item is None:
            text = tr(
                "Choose a palette in the library, open one, or create a new one.\nFiles can be dropped here."
            )
            pane.show_note(text, (new, opened, (tr("Sample Paints"), "shipped")))
        elif item.state == "reading":
            text = tr("Reading {name}…").format(name=item.title[:200])
            pane.show_note(text, ((tr("Cancel"), "cancel"),), busy=True)
        elif item.state == "wrong":
            text = tr("{problem}\nRepair the file or restore it from a backup, then reload it.").format(
                problem=item.problem[:500]
            )
            pane.show_note(text, ((tr("Reload"), "again"), (tr("Remove from Library"), "close")))
        elif item.state == "closed":
            pane.show_note(tr("This palette is not loaded."), ((tr("Open Palette"), "again"),))
        elif pane.model.rowCount():
            pane.show_note("")
        elif len(self._session.library.rows(item.key)) == 0:
            text = tr(
                "This palette is empty. Drop paints here, paste colours, or add the paint from Designer."
            )
            pane.show_note(text, ((tr("Add Paints…"), "add"), (tr("Add Paint from Designer"), "take")))
        elif state.is_filtered or state.near is not None:
            text = tr("No swatch matches the search and filters.")
            pane.show_note(text, ((tr("Clear Filters"), "clear"),))
        else:
            pane.show_note(tr("This group is empty. Drop swatches here."))

    def _show_counts(self) -> None:
        session = self._session
        shown, selected = len(session.shown[session.front].places), len(session.selected)
        text = tr("{count} shown, {selected} selected") if selected else tr("{count} shown")
        self._window.count_cell.set(text.format(count=shown, selected=selected))
        notes = [tr_core(note) for note in session.shown[session.front].rows.notes]
        self._window.note_cell.set(notes[0] if notes else "", "\n".join(notes))

    def _show_selection(self, number: int) -> None:
        if number == self._session.front:
            entries = self._session.selected_entries
            figures = figures_of(entries[0]) if len(entries) == 1 else ""
            self._window.swatch.show_entries(entries, figures, read_only=self._session.is_read_only)
            self._show_palette_fields()
            self._show_counts()

    def _show_palette_fields(self) -> None:
        palette, scope = self._session.palette, self._session.state.scope
        panel = self._window.palette_panel
        groups = palette.groups if palette is not None and scope.group else ()
        group = next((one for one in groups if one.path == scope.group), None)
        shown = group or palette
        if shown is not None:
            there = not self._session.is_read_only
            panel.show_palette(shown.name, shown.colour, shown.notes, there=there)
        else:
            panel.show_palette("", "", "", there=False)

    def _show_look(self, _old: Look | None, look: Look) -> None:
        self._window.bar.show_look(look)
        for pane in self._window.panes:
            pane.grid.form = look.form
            pane.grid.set_size(look.size)
            pane.show_as_list(look.as_list)
            pane.grid.viewport().update()

    def _show_history(self) -> None:
        history, window = self._session.library.history, self._window
        for key, word, name, can in (
            ("undo", tr("&Undo"), history.undo_name, history.can_undo),
            ("redo", tr("&Redo"), history.redo_name, history.can_redo),
        ):
            action = window.findChild(QAction, f"action_{key}")
            if action is not None:
                action.setText(f"{word} {make_visible(name)}".rstrip())
                action.setIconText(word.replace("&", ""))
                tip = f"{action.text().replace('&', '')} ({action.shortcut().toString()})"
                action.setToolTip(plain_tip(tip))
                action.setEnabled(can)


def figures_of(entry: Entry) -> str:
    """Return the figures of an entry with their units, a line each."""
    lines = [
        (f"{name}  " + decimal(f"L* {lab[0]:.1f}  a* {lab[1]:.1f}  b* {lab[2]:.1f}")).strip()
        for name, lab in readings_of(entry)
    ]
    content = entry.content
    if isinstance(content, Paint):
        flop = Columns.of((entry,)).flop[0]
        if flop == flop:
            lines.append(tr("Flop {flop}").format(flop=f"{flop:.1f}"))
        gloss = tr("Gloss 20°: {gloss} GU").format(gloss=f"{content.gloss.gu_20:g}")
        if content.gloss.gu_60 is not None:
            gloss += ", " + tr("60°: {gloss} GU").format(gloss=f"{content.gloss.gu_60:g}")
        lines.append(gloss)
        if content.flakes is not None:
            density, size = (
                decimal(f"{content.flakes.density_per_mm2:g}"),
                decimal(f"{content.flakes.size_um:g}"),
            )
            lines.append(tr("Flakes: {density} /mm², {size} µm").format(density=density, size=size))
    elif isinstance(content, FlatColour):
        numbers = ", ".join(decimal(f"{value:.4g}") for value in content.values[:6])
        numbers += "…" if len(content.values) > 6 else ""
        lines.append(f"{content.model}  {numbers}" + (f"  ({content.space})" if content.space else ""))
        lines += display_notes([content])
    if entry.usage != "process":
        lines.append(tr("Spot colour") if entry.usage == "spot" else tr("Global colour"))
    if entry.date:
        lines.append(tr("Date {date}").format(date=entry.date[:10]))
    return "\n".join(lines).replace(" -", " −")
