"""A project in Color Swatch: its paints as a palette, which is edited and given back."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.documents.projects import OpenedProject
from brdf_qt.program.translation import tr

from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.session import PaletteSession
from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.palette import Entry, Palette, new_id
from brdf_suite.documents.project import Project
from brdf_suite.errors import SuiteError


class SwatchProject:
    """Opens the paints as a palette without a file; saving gives its swatches back as the project's paints."""

    def __init__(self, session: PaletteSession) -> None:
        self._session = session
        self._key = ""

    def show_project(self, opened: OpenedProject) -> None:
        """Show the paints of a project as a palette."""
        project = opened.project
        entries = tuple(Entry(paint, id=new_id()) for paint in project.paints)
        palette = Palette(project.name, entries, notes=project.notes)
        self._key = self._session.library.add_palette(palette)
        self._session.show_scope(Scope(self._key))

    def gather_project(self, project: Project) -> Project:
        """Return the project with the paints of its palette, or of the palette in front where it has none here."""
        palette = self._session.library.palette(self._key) or self._session.palette
        if palette is None:
            raise SuiteError(tr("No palette is open whose paints could be saved in a project."))
        return replace(project, paints=tuple(to_paint(entry.content) for entry in palette))

    def project_saved(self, opened: OpenedProject) -> None:
        """Take the palette that was written for the project's from now on, and for saved where it has no file."""
        library = self._session.library
        if library.palette(self._key) is None:
            self._key = self._session.state.scope.palette
        item = library.item(self._key)
        if item is None or item.palette is None or item.path is not None:
            return
        store = item.palette.store
        if tuple(to_paint(entry.content) for entry in store.value) == opened.project.paints:
            store.end_gesture()
            store.stack.setClean()
