"""A project in Designer: its paints as tabs beside the standard, and the scene of its first view."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.documents.projects import OpenedProject

from brdf_designer.documents.tabs import OpenDocument
from brdf_designer.from_measurement.control import MOST_TABS
from brdf_designer.picture.control import PictureControl
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison.control import StandardControl
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.project import NamedView, Project
from brdf_suite.documents.store import AnyPaint
from brdf_suite.documents.view import View
from brdf_suite.paint_design.standard import paint_like, standard_of

_SCENE = (
    "camera",
    "environment",
    "environment_layout",
    "surface",
    "rotation_deg",
    "exposure_ev",
    "background",
)
"""What Designer's picture has of a view; the rest of it is Viewer's."""


class DesignerProject:
    """Opens the paints of a project as tabs, and gives back tabs, standard and scene."""

    def __init__(self, session: PaintSession, picture: PictureControl, standards: StandardControl) -> None:
        self._session, self._picture, self._standards = session, picture, standards
        self._tabs: dict[int, OpenDocument] = {}
        """The tabs of paints of the project, by their places in it."""
        self._standard: Paint | None = None
        self._scene: View | None = None

    def show_project(self, opened: OpenedProject) -> None:
        """Open the paints in tabs, the main one in front, each beside the standard, and show the first view."""
        project, documents = opened.project, self._session.documents
        self._tabs, self._standard, self._scene = {}, None, None
        designed = [(place, one) for place, one in enumerate(project.paints) if isinstance(one, Paint)]
        standard = project.standard
        for place, paint in designed[:MOST_TABS]:
            self._session.open_paint(paint, clean=True)
            self._tabs[place] = documents.front
            if isinstance(standard, Paint):
                self._standards.set_standards([standard_of(standard, project.name)])
                self._standard = standard
        if self._tabs:
            documents.show(self._tabs[min(self._tabs)])
        for named in project.views[:1]:
            self._scene = _scene_of(named.view, self._picture.view)
            self._picture.take_view(self._scene)

    def gather_project(self, project: Project) -> Project:
        """Return the project with every open tab, the standard in front and the scene; a closed tab's paint stays."""
        row = self._session.documents.row
        paints: list[AnyPaint] = list(project.paints)
        for place, tab in self._tabs.items():
            if tab in row and place < len(paints):
                paints[place] = tab.store.value
        known = list(self._tabs.values())
        paints += [one.store.value for one in row if one not in known and self._is_work(one)]
        standard = project.standard
        present = self._standards.standard
        if present is not None:
            taken = paint_like(present, self._session.paint)
            # Unchanged since the project was opened: also a standard that is no paint of Designer's stays.
            standard = standard if taken == self._standard else taken
        return replace(project, paints=tuple(paints), standard=standard, views=self._views(project))

    def project_saved(self, opened: OpenedProject) -> None:
        """Take the tabs that have no file of their own for saved: the project has them."""
        paints = opened.project.paints
        self._tabs = {}
        for tab in self._session.documents.row:
            value = tab.store.value
            places = [n for n, one in enumerate(paints) if one == value and n not in self._tabs]
            if not places:
                continue  # edited while it was being written
            self._tabs[places[0]] = tab
            if tab.store.path is None:
                tab.store.end_gesture()
                tab.store.stack.setClean()
        standard = opened.project.standard
        self._standard = standard if isinstance(standard, Paint) else None
        self._scene = self._picture.view

    def _is_work(self, tab: OpenDocument) -> bool:
        return not (tab.pristine and tab.is_untouched) or len(self._session.documents.row) == 1

    def _views(self, project: Project) -> tuple[NamedView, ...]:
        if not self._picture.has_scene:
            return project.views
        now = self._picture.view
        if not project.views:
            return (NamedView("Designer", now),)
        first = project.views[0]
        if self._scene is None or _scene_of(now, self._scene) == self._scene:
            return project.views
        return (NamedView(first.name, _scene_of(now, first.view)), *project.views[1:])


def _scene_of(view: View, rest: View) -> View:
    """Return ``rest`` with camera, light and form of ``view``."""
    return replace(rest, **{name: getattr(view, name) for name in _SCENE})
