"""The File menu: new, open, save, close, the shipped paints; and the buttons over the library."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from brdf_qt.documents.project_files import ProjectFiles
from brdf_qt.documents.projects import is_project
from brdf_qt.documents.recent_files import RecentFiles
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QPoint

from brdf_color_swatch.editing.entry_edits import add_entries
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.project_part import SwatchProject
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Entry, Palette, new_id
from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.documents.store import PAINT_ENDING, AnyPaint
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.material import ENTRY_MARK, file_kind, load_document, load_shipped_paint, paint_names
from brdf_suite.progress import Progress
from brdf_suite.regular_files import is_file


def new_palette() -> Palette:
    """Return what New opens."""
    return Palette(tr("Untitled"))


class FileCommands(SwatchFeature):
    """Commands on palettes as a whole."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        add = window.add_command
        new = add("file", mark("&New Palette"), "new", self.new, "new", icon="file-plus")
        opened = add("file", mark("&Open…"), "open", lambda: self.open(None), "open", icon="folder-open")
        window.add_recent_menu()
        add("file", mark("Open S&ample Paints"), None, self.open_shipped, "shipped")
        self._copy = add(
            "file", mark("Editable Cop&y"), None, self.copy, "copy_palette",
            tip=mark("Copy this palette to a new one that has no file yet"),
        )  # fmt: skip
        window.menus["file"].addSeparator()
        self._save = add("file", mark("&Save"), "save", self.save, "save", icon="floppy-disk")
        self._save_as = add("file", mark("Save &As…"), "save_as", self.save_as, "save_as")
        add("file", mark("Save A&ll"), None, self.save_all, "save_all")
        self._close = add("file", mark("&Close Palette"), "close", self.close_palette, "close", icon="x")
        window.menus["file"].addSeparator()
        self.projects = ProjectFiles(window, SwatchProject(session), session.library.dialogs)
        for action in (new, opened, self._close):
            window.add_library_button(action)
        for action in (new, opened, self._save):
            window.toolbar.addAction(action)
        window.toolbar.addSeparator()
        window.open_requested.connect(self.open)
        window.files_dropped.connect(self._open_files)
        window.recent_cleared.connect(self._clear_recent)
        window.tree.menu_requested.connect(self._menu)
        for pane in window.panes:
            pane.action_requested.connect(lambda key, number=pane.number: self._act(key, number))
        session.library.settled.connect(lambda _key: window.show_recent(session.library.recent()))
        session.library.items_changed.connect(self._enable)
        session.state_changed.connect(lambda _pane: self._enable())
        session.front_changed.connect(self._enable)
        window.show_recent(session.library.recent())
        self._enable()

    def new(self) -> None:
        """Begin an empty palette, and let it be named at once."""
        self._session.show_new(new_palette())

    def open(self, path: Path | None) -> None:
        """Open a file of any palette format, or ask for one; any other material goes into the palette in front."""
        # Also one of ours waits for those that were asked for before it.
        if path is not None and (path.suffix.lower() != PALETTE_ENDING or not self._session.reading.is_idle):
            self._session.reading.begin(path, self._find_opener, lambda opener: opener(), self._on_add_failed)
        else:
            self._open_palette(path)

    def _open_palette(self, path: Path | None) -> None:
        key = self._session.loader.ask_open(path)
        if key is not None:
            self._session.show_scope(Scope(key))

    def _find_opener(self, path: Path, progress: Progress) -> Callable[[], None]:
        """Return what shows a file, on the thread that reads it; palettes are read by the library."""
        progress(0.0, path.name)
        if is_project(path):
            return partial(self.projects.open, path)
        if not _names_material(path):
            return partial(self._open_palette, path)
        return partial(self._add_paint, _read_paint(str(path), progress))

    def open_shipped(self) -> None:
        """Open the shipped paints as a palette without a file, which is read-only; show it where it is open."""
        for item in self._session.library.items:
            if item.read_only:
                self._session.show_scope(Scope(item.key))
                return
        try:
            entries = [Entry(load_shipped_paint(name), id=name) for name in paint_names()]
        except SuiteError as error:
            self._session.library.fails(error, "open")
            return
        palette = Palette(tr("Sample Paints"), tuple(entries))
        self._session.show_scope(Scope(self._session.library.add_palette(palette, read_only=True)))

    def copy(self) -> None:
        """Show a copy of the palette in front that can be changed."""
        self._finish_typing()
        self._session.copy_palette(self._session.state.scope.palette)

    def save(self) -> None:
        self._finish_typing()
        self._session.library.save(self._session.state.scope.palette)

    def save_as(self) -> None:
        """Save the palette in front to a file that is asked for."""
        self._finish_typing()
        self._session.library.save_as(self._session.state.scope.palette)

    def save_all(self) -> None:
        """Save every palette with changes; the first that is not saved ends it."""
        self._finish_typing()
        for item in self._session.library.items:
            if not item.is_clean and not self._session.library.save(item.key):
                return

    def close_palette(self) -> None:
        """Take the palette in front out of the library; its file stays."""
        self._finish_typing()
        key = self._session.state.scope.palette
        items = self._session.library.items
        place = next((place for place, item in enumerate(items) if item.key == key), None)
        if place is None or not self._session.library.close(key):
            return
        rest = self._session.library.items
        read = [item for item in (*rest[place:], *reversed(rest[:place])) if item.palette is not None]
        if read:
            self._session.show_scope(Scope(read[0].key))

    def _finish_typing(self) -> None:
        """Take what is still being typed: a shortcut leaves no field."""
        focused = self._window.focusWidget()
        if focused is not None:
            focused.clearFocus()
            focused.setFocus()

    def _add_paint(self, paint: AnyPaint) -> None:
        if self._session.palette is None or self._session.is_read_only:
            self.new()
        add_entries(self._session, tr("Add paint"), [Entry(paint, id=new_id())])

    def _on_add_failed(self, error: Exception) -> None:
        self._session.library.fails(error, "open", tr("The palette is unchanged."))

    def _clear_recent(self) -> None:
        RecentFiles().clear()
        self._window.show_recent([])

    def _open_files(self, paths: list[Path]) -> None:
        for path in paths:
            self.open(path)

    def _act(self, what: str, number: int) -> None:
        """Do what a button of an empty page offers."""
        session = self._session
        session.set_front(number)
        key = session.state.scope.palette
        acts: dict[str, Callable[[], object]] = {
            "new": self.new,
            "open": lambda: self.open(None),
            "shipped": self.open_shipped,
            "cancel": lambda: session.loader.cancel_reading(key),
            "again": lambda: session.loader.load(key),
            "close": self.close_palette,
            "clear": lambda: session.set_state(session.state.cleared()),
        }
        if what in acts:  # others are another feature's
            acts[what]()

    def _menu(self, scope: Scope, point: QPoint) -> None:
        if scope.palette and scope.palette != self._session.state.scope.palette:
            self._session.show_scope(scope)
        keys = ["new", "open", "shipped"]
        if scope.palette:
            keys = [
                "save",
                "save_as",
                "copy_palette",
                "export",
                "cmyk_profile",
                "",
                "new_group",
                "rename_group",
                "remove_group",
                "",
                "close",
            ]
        self._window.open_menu(keys, point)

    def _enable(self) -> None:
        item = self._session.item
        there = item is not None and item.palette is not None
        for action in (self._save, self._save_as, self._copy):
            action.setEnabled(there)
        self._close.setEnabled(item is not None)


def _names_material(path: Path) -> bool:
    """Whether a material is asked for, and not a palette; files that cannot be read count as palettes."""
    if not is_file(path):
        return not path.suffix or ENTRY_MARK in path.name or path.suffix.lower() == PAINT_ENDING
    try:
        return file_kind(path) != "palette"
    except SuiteError:
        return False


def _read_paint(name: str, progress: Progress) -> AnyPaint:
    document = load_document(name)
    if document is not None:
        return document
    # Measured data and models have no document: the virtual instruments read a paint from them.
    from brdf_suite.paint_design.measured_start import load_start  # much to import, and few palettes need it

    return load_start(name, progress=progress).paint
