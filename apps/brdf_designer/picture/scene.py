"""How the picture comes to its light and form. Imported once the window is painted: it brings files and filters."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.work.scene_loading import SceneLoader
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.picture.contents import recall
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion
from brdf_suite.pipeline.scene import default_view, in_environment
from brdf_suite.pipeline.surface import wants_baking
from brdf_suite.progress import Progress
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh


class PictureScene(SceneLoader):
    """Loads as Viewer does, and knows with which view a start begins."""

    def __init__(self, runner: TaskRunner, parent: QObject) -> None:
        super().__init__(runner, parent)
        last = recall()
        self.first: View = default_view() if last is None else _afresh(last)

    def another(self, runner: TaskRunner, parent: QObject) -> PictureScene:
        """Return one that loads for another picture."""
        return PictureScene(runner, parent)

    @staticmethod
    def in_light(view: View, name: str) -> View:
        """Return a view in a light, with that light's own background and exposure."""
        return in_environment(view, name)

    @staticmethod
    def wants_baking(look: SurfaceLook) -> bool:
        """Whether a picture with this look shows anything that has to be baked."""
        return wants_baking(look)

    @staticmethod
    def bake(form: Mesh, progress: Progress) -> BakedMesh:
        """Return what the ground and the form's own shadows need; for a worker."""
        return baked_occlusion(form, progress)


def _afresh(view: View) -> View:
    """Return a view with camera, exposure and turn of the light as one begins with, as in Viewer.

    A picture that opens too dark or from behind would look like a fault.
    """
    first = default_view(view.environment)
    return replace(view, camera=first.camera, exposure_ev=first.exposure_ev, rotation_deg=first.rotation_deg)
