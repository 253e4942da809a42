"""A project in the Viewer: its first view and its main paint are shown, and no file is taken for the view's own."""

from __future__ import annotations

from brdf_qt.window.dialogs import QtDialogs
from PySide6.QtGui import QAction

from brdf_suite.documents.project import NamedView, Project, load_project, save_project
from brdf_suite.documents.view import View
from brdf_suite.pipeline.material import load_shipped_paint


def test_a_project_shows_its_view_and_its_paint(viewer, qtbot, tmp_path) -> None:
    path = tmp_path / "spring.brdfproject"
    view = View(surface="sphere", exposure_ev=0.75)
    save_project(Project("Spring", (load_shipped_paint("copper"),), views=(NamedView("Day", view),)), path)
    viewer.window.files_dropped.emit([path])
    qtbot.waitUntil(lambda: viewer.state.view.exposure_ev == 0.75)
    qtbot.waitUntil(lambda: viewer.state.fit is not None and viewer.state.fit.name == "Copper")
    assert viewer.state.view.surface == "sphere"
    assert viewer.controller.views.path is None
    path.write_bytes(b"PK")
    viewer.window.files_dropped.emit([path])
    qtbot.waitUntil(lambda: "project" in viewer.messages())
    assert "damaged" in viewer.window.messages.shown()["project"].what


def test_paints_are_a_b_and_a_row_and_views_and_lights_are_in_the_menu(
    viewer, qtbot, tmp_path, monkeypatch
) -> None:
    path = tmp_path / "spring.brdfproject"
    paints = tuple(load_shipped_paint(name) for name in ("copper", "red"))
    day, night = (
        NamedView(name, View(surface="sphere", exposure_ev=ev))
        for name, ev in (("Day", 0.5), ("Night", -1.0))
    )
    project = Project("Spring", paints, load_shipped_paint("pearl"), (day, night), notes="Kept")
    save_project(project, path)
    viewer.window.files_dropped.emit([path])
    qtbot.waitUntil(lambda: viewer.state.second is not None and viewer.state.fit.name == "Copper")
    assert viewer.state.second.value.name == "Red"
    viewer.controller.paint.step(1)
    qtbot.waitUntil(lambda: viewer.state.fit.name == "Red")
    viewer.window.findChild(QAction, "project_view_Night").trigger()
    assert viewer.state.view.exposure_ev == -1.0
    viewer.state.change_view(exposure_ev=-2.0)
    monkeypatch.setattr(QtDialogs, "save_path", lambda *_asked: path)
    with qtbot.waitSignal(viewer.controller.projects.saved):
        viewer.window.command("save_project").trigger()
    found = load_project(path)
    assert [one.name for one in found.views] == ["Day", "Night"]
    assert (found.views[0], found.views[1].view.exposure_ev) == (day, -2.0)
    assert found.views[1].view.compare.paint is None
    assert (found.paints, found.standard, found.notes) == (paints, project.standard, "Kept")
