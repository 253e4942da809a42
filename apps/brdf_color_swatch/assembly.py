"""Puts Color Swatch together: library, session, window, parts, pictures, link."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.recovery_offer import offer_recovery
from brdf_qt.program.application import error_relay
from brdf_qt.program.program import Program
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.fit_choice import FitCommand
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QWidget

from brdf_color_swatch.colour_map.panel import ColourMap
from brdf_color_swatch.controller import PaletteController
from brdf_color_swatch.editing.drops_and_order import DropsAndOrder
from brdf_color_swatch.editing.edit_commands import EditCommands
from brdf_color_swatch.editing.group_commands import GroupCommands
from brdf_color_swatch.export.contact_sheet import ContactSheets
from brdf_color_swatch.export.dialog import QtExportDialogs
from brdf_color_swatch.export.palette_export import PaletteExport
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.thumbnails import VisiblePictures
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.changed_files import ChangedFiles
from brdf_color_swatch.library.cmyk_profile import CmykProfile
from brdf_color_swatch.library.file_commands import FileCommands, new_palette
from brdf_color_swatch.library.library import Library
from brdf_color_swatch.library.loading import UnsavedWork
from brdf_color_swatch.paint_exchange import PaintExchange
from brdf_color_swatch.search.colour_search import ColourSearch
from brdf_color_swatch.search.comparison import PaintComparison
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.view_commands import ViewCommands
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import (
    PALETTE_ENDING,
    load_palette,
    palette_from_json,
    palette_to_json,
    save_palette,
)
from brdf_suite.resources import resource_names

FEATURES: tuple[Callable[[PaletteSession, SwatchWindow], SwatchFeature], ...] = (
    FileCommands,
    PaletteExport,
    ContactSheets,
    CmykProfile,
    EditCommands,
    DropsAndOrder,
    GroupCommands,
    ViewCommands,
    ColourSearch,
    PaintComparison,
    PaintExchange,
    ColourMap,
    ChangedFiles,
    VisiblePictures,
)
"""What makes each feature, in the order of the menus: it adds itself to the window and listens to the session."""


def palette_format() -> DocumentFormat[Palette]:
    """Return how palettes are made, read and written."""
    return DocumentFormat(
        kind=mark("palette"),
        ending=PALETTE_ENDING,
        new=new_palette,
        load=load_palette,
        save=save_palette,
        to_json=palette_to_json,
        from_json=palette_from_json,
        name_of=lambda palette: palette.name,
    )


class ColorSwatch(Program):
    """The running Color Swatch."""

    window: SwatchWindow

    def __init__(self, dialogs: Callable[[QWidget], QtExportDialogs] = QtExportDialogs) -> None:
        lights = resource_names("environments", ".exr")
        super().__init__(SwatchWindow(lights))
        self.library = Library(
            palette_format(),
            dialogs(self.window),
            lambda error: error_relay().report(error, "autosave"),
            self.window,
        )
        self.unsaved = UnsavedWork(self.library)
        reading = FileReading(self.window.progress, self.window)
        self.session = PaletteSession(self.library, reading, self.window)
        self.session.recall()
        self.controller = PaletteController(self.session, self.window, self.window)
        self.features += (feature(self.session, self.window) for feature in FEATURES)
        files = self.feature(FileCommands)
        self.features += (files.projects, reading, self.feature(PaintExchange).link)
        note = tr("Takes effect in Viewer and Designer at their next start, in Lobe Visualizer at once.")
        FitCommand(self.window, note).add_to_menu()
        self.window.complete()
        self.controller.start()
        self.window.close_requested.connect(self._may_close)
        self.start_when_painted()

    @property
    def is_idle(self) -> bool:
        return not self.library.tasks.busy and super().is_idle

    def start(self) -> None:
        """Do what can wait until the window is painted: the library of the last run, link, unsaved work."""
        self.library.restore()
        super().start()
        self.offer_recovery()

    def open(self, name: str) -> None:
        """Open a file, or with ``shipped`` the paints that come with the suite."""
        if name == "shipped":
            self.feature(FileCommands).open_shipped()
        else:
            self.window.open_requested.emit(Path(name))

    def do(self, action: str) -> bool:
        """Do what a script asks for: ``search=TEXT`` and the like, or a command by its key; False: none such."""
        key, _, value = action.partition("=")
        session = self.session
        if key == "search":
            session.set_state(replace(session.state, text=value))
        elif key == "sort":
            session.set_state(replace(session.state, sort=value))
        elif key == "palette":
            session.show_scope(Scope(self.library.items[int(value)].key))
        elif key == "group":
            session.show_scope(replace(session.state.scope, group=tuple(value.split("/")) if value else ()))
        elif key == "select":
            pane = self.window.panes[session.front]
            session.reveal(tuple(pane.model.id_at(int(number)) for number in value.split(",")))
        elif key == "section":
            self.window.section(value).set_open(True)
        else:
            return super().do(action)
        return True

    def close(self) -> None:
        """Leave the link; unsaved work of a program that has to end is kept for the next start. Only once."""
        if self.closed:
            return
        super().close()
        self.unsaved.close()
        self.library.keep_unsaved()

    def _may_close(self, question: QCloseEvent) -> None:
        if self.library.may_close_all():
            self.library.remember()
            question.accept()
        else:
            question.ignore()

    def offer_recovery(self) -> None:
        """Show a message with the unsaved work of earlier runs; nothing where there is none."""
        offer_recovery(
            self.window.show_message,
            self.unsaved.find(),
            lambda found: self.session.show_scope(Scope(self.unsaved.recover(found))),
            self.unsaved.discard,
            tr("Color Swatch closed unexpectedly. Recover your unsaved work on “{name}” of {when}?"),
            tr(
                "Color Swatch closed unexpectedly. Recover unsaved work on {count} palettes (newest: {when}): "
                "{names}?"
            ),
        )
