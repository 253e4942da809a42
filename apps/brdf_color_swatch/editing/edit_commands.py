"""The Edit menu: undo, clipboard, selection, names, tags and notes. Every gesture is one named step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from brdf_qt.choosing.drag import carry
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QMimeData, QPoint
from PySide6.QtGui import QGuiApplication

from brdf_color_swatch.editing.entry_edits import (
    OWNER,
    add_entries,
    count_words,
    edit_and_reveal,
    what_words,
    with_date,
)
from brdf_color_swatch.editing.paint_files import take_data
from brdf_color_swatch.editing.transfer import Carried, hexes_of
from brdf_color_swatch.export.palette_export import suggested_file
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.pane import Pane
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.errors import SuiteError


class EditCommands(SwatchFeature):
    """Edits of swatches."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self._cut: Carried | None = None
        add, edit = window.add_command, window.menus["edit"]
        history = session.library.history
        undo = add("edit", mark("&Undo"), "undo", history.undo, "undo", icon="arrow-counter-clockwise")
        redo = add("edit", mark("&Redo"), "redo", history.redo, "redo", icon="arrow-clockwise")
        edit.addSeparator()
        self._of_selected = [add("edit", mark("Cu&t"), "cut", self.cut, "cut", icon="scissors")]
        self._copy = add("edit", mark("&Copy"), "copy", self.copy, "copy", icon="copy")
        self._paste = add("edit", mark("&Paste"), "paste", self.paste, "paste", icon="clipboard")
        self._of_selected += [
            add("edit", mark("D&uplicate"), "duplicate", self.duplicate, "duplicate"),
            add("edit", mark("&Delete"), "delete", self.delete, "delete", icon="trash"),
        ]
        self._new = add(
            "edit",
            mark("New Palette from Se&lection…"),
            None,
            self.new_palette,
            "new_from_selection",
            tip=mark("Copy the selected swatches to a new palette, in a file of its own"),
        )
        edit.addSeparator()
        add("edit", mark("Select &All"), "select_all", lambda: self._pane.grid.selectAll(), "select_all")
        add(
            "edit",
            mark("Select N&one"),
            "select_none",
            lambda: self._pane.grid.clearSelection(),
            "select_none",
        )
        add("edit", mark("&Invert Selection"), "invert_selection", self.invert, "invert")
        edit.addSeparator()
        self._of_selected += [
            add(
                "edit",
                mark("Re&name"),
                "rename",
                lambda: self._pane.rename_current(),
                "rename",
                icon="pencil-simple",
            ),
            add("edit", mark("Ta&gs"), "tags", lambda: self._focus("tags"), "tags", icon="tag"),
            add("edit", mark("Not&es"), "notes", lambda: self._focus("notes"), "notes"),
        ]
        for action in (undo, redo):
            window.toolbar.addAction(action)
        window.toolbar.addSeparator()
        window.swatch.edited.connect(self.write)
        for pane in window.panes:
            number = pane.number
            pane.model.renamed.connect(self._renamed)
            pane.menu_requested.connect(self._menu)
            pane.action_requested.connect(lambda key, number=number: self._act(key, number))
            pane.model.mime_of = lambda ids, number=number: self._mime(number, ids)
        self._enable_always()

    def _act(self, what: str, number: int) -> None:
        """Do what the button over a pane offers for its selection."""
        if what == "new_from_selection":
            self._session.set_front(number)
            self.new_palette()

    def copy(self) -> None:
        """Put what is selected on the clipboard: whole, and as text and colour for other programs."""
        entries = self._session.selected_entries
        if entries:
            self._cut = None
            QGuiApplication.clipboard().setMimeData(self._carry(entries, self._session.state.scope.palette))

    def cut(self) -> None:
        entries = self._session.selected_entries
        if entries:
            self.copy()
            self._remove(tr("Cut {what}").format(what=what_words(entries)))

    def paste(self) -> None:
        """Put in what the clipboard holds; into the palette that is in front now, also where files are read first."""
        scope, library = self._session.state.scope, self._session.library
        take_data(
            QGuiApplication.clipboard().mimeData(),
            self._session.reading,
            lambda carried: self._put_in(carried, scope),
            lambda error: library.fails(error, "edit", tr("The palette is unchanged.")),
            self._window.open_requested.emit,
        )

    def _put_in(self, carried: Carried, scope: Scope) -> None:
        if not carried.entries:
            if not carried.files:
                self._session.library.fails(
                    SuiteError(tr("The clipboard contains no swatch, paint or colour.")), "edit",
                    tr("Copy swatches, a paint, or text with colours such as #3366cc or L*a*b* values."),
                )  # fmt: skip
            return
        if self._session.library.palette(scope.palette) is None:
            self._session.show_new(Palette(tr("Untitled")))
            scope = self._session.state.scope
        self._session.library.settled.emit("edit")
        name = tr("Paste {what}").format(what=what_words(carried.entries))
        add_entries(self._session, name, carried.entries, scope.group, scope=scope)

    def duplicate(self) -> None:
        """Copy what is selected behind the last of it."""
        entries, palette = self._session.selected_entries, self._session.palette
        if entries and palette is not None:
            last = max(palette.by_id[entry.id] for entry in entries)
            before = palette.entries[last + 1].id if last + 1 < len(palette) else None
            name = tr("Duplicate {what}").format(what=what_words(entries))
            copies = [replace(entry, id="") for entry in entries]
            edit_and_reveal(self._session, name, lambda old: edits.add_entries(old, copies, None, before))

    def new_palette(self) -> None:
        """Ask for a file, and copy what is selected to a new palette there; it is called as the file is."""
        entries = self._session.selected_entries
        if not entries:
            return
        library = self._session.library
        suggested = suggested_file(self._session.item, tr("New palette"), PALETTE_ENDING)
        kind = tr("Palette")
        path = library.dialogs.save_path(suggested, f"{kind} (*{PALETTE_ENDING})")
        if path is not None:
            path = path if path.suffix else path.with_name(path.name + PALETTE_ENDING)
            palette = Palette(" ".join(path.stem.split()) or tr("New palette"), tuple(entries))
            self._session.show_new_in(path.absolute(), palette)

    def delete(self) -> None:
        entries = self._session.selected_entries
        if entries:
            self._remove(tr("Delete {what}").format(what=what_words(entries)))

    def _remove(self, name: str) -> None:
        ids = self._session.selected
        pane = self._pane
        rows = [row for key in ids if (row := pane.model.row_of(key)) is not None]
        self._session.edit(name, lambda palette: edits.remove_entries(palette, ids))
        # What comes in their place is selected, so that the keys go on from there.
        count = pane.model.rowCount()
        if rows and count:
            pane.reveal((pane.model.id_at(min(min(rows), count - 1)),))

    def _carry(self, entries: Sequence[Entry], source: str) -> QMimeData:
        rows = self._session.library.rows(source)
        by_id = {key: place for place, key in enumerate(rows.ids)}
        lab = [rows.lab[by_id[entry.id], 1] for entry in entries]
        return carry(entries, hexes_of(np.nan_to_num(lab, nan=50.0).tolist()), source, OWNER)

    def _mime(self, number: int, ids: list[str]) -> QMimeData | None:
        key = self._session.states[number].scope.palette
        palette = self._session.library.palette(key)
        return None if palette is None else self._carry([palette.entry(one) for one in ids], key)

    @property
    def _pane(self) -> Pane:
        return self._window.panes[self._session.front]

    def invert(self) -> None:
        chosen, model = set(self._session.selected), self._pane.model
        rows = range(model.rowCount())
        self._pane.grid.select_rows([row for row in rows if model.id_at(row) not in chosen])

    def _focus(self, key: str) -> None:
        self._window.inspector_dock.show()
        self._window.section("swatch").set_open(True)
        self._window.swatch.focus(key)

    def _renamed(self, id_: str, key: str, text: str) -> None:
        if key == "name":
            if text:
                name = tr("Rename to “{name}”").format(name=text[:40])
                self._edit(name, [id_], lambda palette: edits.rename_entry(palette, id_, text))
        else:
            self._change(tr("Change code"), [id_], lambda entry: replace(entry, code=text))

    def write(self, key: str, text: str) -> None:
        """Write a field of the inspector into all that is selected."""
        ids = list(self._session.selected)
        if not ids:
            return
        if key == "name":
            name = tr("Rename {what}").format(what=count_words(len(ids)))
            self._change(name, ids, lambda entry: replace(entry, content=replace(entry.content, name=text)))
        elif key in ("code", "notes"):
            name = tr("Change code") if key == "code" else tr("Change notes")
            field: dict[str, Any] = {key: text}
            self._change(name, ids, lambda entry: replace(entry, **field))
        else:
            self._tag(ids, text)

    def _tag(self, ids: list[str], text: str) -> None:
        words = [word.strip() for word in text.replace(";", ",").split(",") if word.strip()]
        drop = [word[1:].strip() for word in words if word.startswith("-")]
        add = [word.removeprefix("+").strip() for word in words if not word.startswith("-")]
        relative = len(ids) > 1 and all(word[0] in "+-" for word in words) and bool(words)
        name = tr("Change tags of {what}").format(what=count_words(len(ids)))
        if relative:
            self._edit(name, ids, lambda palette: edits.tag_entries(palette, ids, add, drop))
        else:
            tags = tuple(dict.fromkeys(word for word in add if word))
            self._change(name, ids, lambda entry: replace(entry, tags=tags))

    def _change(self, name: str, ids: list[str], change: Callable[[Entry], Entry]) -> None:
        self._edit(name, ids, lambda palette: edits.change_entries(palette, ids, change))

    def _edit(self, name: str, ids: list[str], change: Callable[[Palette], Palette]) -> None:
        self._session.edit(name, lambda palette: with_date(change(palette), ids))

    def _menu(self, point: QPoint) -> None:
        keys = (
            "rename", "tags", "notes", "", "cut", "copy", "paste", "duplicate", "delete", "new_from_selection", "",
            "new_group", "",
            "nearest", "compare", "", "to_designer", "to_viewer", "to_lobes",
        )  # fmt: skip
        self._window.open_menu(keys, point, "swatch_menu")

    def _enable(self) -> None:
        some = bool(self._session.selected)
        self._copy.setEnabled(some)
        self._new.setEnabled(some)
        self._paste.setEnabled(not self._session.is_read_only)
        for action in self._of_selected:
            action.setEnabled(some and not self._session.is_read_only)
