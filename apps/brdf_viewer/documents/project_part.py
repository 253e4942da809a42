"""A project in the Viewer: its paints as A, B and what the arrow keys go through; its views and lights in a menu."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from brdf_qt.documents.projects import OpenedProject
from brdf_qt.program.translation import tr

from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.project import NamedView, Project
from brdf_suite.documents.store import AnyPaint
from brdf_suite.documents.view import View
from brdf_suite.foreign_text import make_visible
from brdf_viewer.documents.view_files import ViewFiles
from brdf_viewer.paint.control import PaintControl
from brdf_viewer.scene.control import SceneControl
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

_FIRST_VIEW = "View"


class ViewerProject:
    """Shows the first view of a project with its first two paints, and gives back the view on show."""

    def __init__(
        self,
        state: ViewerState,
        window: ViewerWindow,
        paint: PaintControl,
        scene: SceneControl,
        views: ViewFiles,
    ) -> None:
        self._state, self._paint, self._scene, self._views = state, paint, scene, views
        self._opened: OpenedProject | None = None
        self._shown = ""
        self._menu = window.view_menu.addMenu(tr("Pro&ject"))
        self._menu.setEnabled(False)

    def show_project(self, opened: OpenedProject) -> None:
        """Show the first view, the main paint as A and the next as B; all paints follow one another by arrow keys."""
        self._opened, project = opened, opened.project
        self._list(opened)
        self._shown = ""
        for named in project.views[:1]:
            self._show_view(named.name)
        if project.paints:
            entries = tuple(Entry(paint, id=f"paint-{n}") for n, paint in enumerate(project.paints))
            self._paint.go_through(str(opened.path), Palette(project.name, entries))
        if len(opened.paints) > 1 and self._state.view.compare.paint is None:
            self._state.change_part("compare", paint=str(opened.paints[1]))

    def gather_project(self, project: Project) -> Project:
        """Return the project with the view on show under its name, and the paint on show where it has it not yet."""
        name = self._shown or _FIRST_VIEW
        view = self._own(self._views.seen())
        views = [NamedView(one.name, view if one.name == name else one.view) for one in project.views]
        if name not in (one.name for one in project.views):
            views.append(NamedView(name, view))
        paints: tuple[AnyPaint, ...] = project.paints
        shown = self._state.paint
        if shown is not None and shown not in paints:
            paints = (*paints, shown)
        return replace(project, paints=paints, views=tuple(views))

    def project_saved(self, opened: OpenedProject) -> None:
        """Offer the views and lights as they were written."""
        self._opened = opened
        self._shown = self._shown or _FIRST_VIEW
        self._list(opened)

    def _own(self, view: View) -> View:
        """Return a view without the B that opening the project gave it: the project has that among its paints."""
        given = [] if self._opened is None else [str(path) for path in self._opened.paints]
        if view.compare.paint in given:
            return replace(view, compare=replace(view.compare, paint=None))
        return view

    def _list(self, opened: OpenedProject) -> None:
        self._menu.clear()
        for named in opened.project.views:
            action = self._menu.addAction(make_visible(named.name).replace("&", "&&"))
            action.setObjectName(f"project_view_{named.name}")
            action.triggered.connect(partial(self._show_view, named.name))
        self._menu.addSeparator()
        for light, path in zip(opened.project.lights, opened.lights, strict=True):
            action = self._menu.addAction(tr("Light: {name}").format(name=light.name.replace("&", "&&")))
            action.setObjectName(f"project_light_{light.name}")
            action.triggered.connect(partial(self._show_light, path))
        self._menu.setEnabled(not self._menu.isEmpty())

    def _show_view(self, name: str, _checked: bool = False) -> None:
        views = [] if self._opened is None else self._opened.project.views
        for named in views:
            if named.name == name:
                self._shown = name
                self._views.show(named.view)

    def _show_light(self, path: Path, _checked: bool = False) -> None:
        self._scene.open("environment", str(path))
