"""A project in the Viewer: its first view and its main paint are shown, and no file is taken for the view's own."""

from __future__ import annotations

from brdf_suite.documents.project import NamedView, Project, save_project
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
    assert "damaged" in viewer.window.messages.shown()["dropped"].what
