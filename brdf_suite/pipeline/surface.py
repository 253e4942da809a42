"""From the view's words about its surface to what is drawn: read, shaped, and baked where that is wanted."""

from __future__ import annotations

from dataclasses import dataclass

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.pipeline.occlusion import baked_occlusion
from brdf_suite.pipeline.scene import load_surface
from brdf_suite.progress import Progress, part, report
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.baked import BakedMesh
from brdf_suite.surface.shaping import shaped

_READING_SHARE = 0.2


@dataclass(frozen=True, eq=False)
class PreparedSurface:
    """A mesh in its final shape; ``baked`` is None where the view wants neither occlusion nor a ground."""

    mesh: Mesh
    baked: BakedMesh | None = None


def wants_baking(look: SurfaceLook) -> bool:
    """Whether a picture with this look shows anything that has to be baked."""
    return look.occlusion or look.ground


def load_shaped(name_or_path: str, look: SurfaceLook, progress: Progress | None = None) -> Mesh:
    """Return a surface by packaged name or by file, in the unit, scale and place that ``look`` says.

    Raises
    ------
    FileError
        There is no such surface, or its file cannot be read; the message says why.
    """
    report(progress, 0.0, "reading the surface")
    mesh = load_surface(name_or_path, look.unit)
    report(progress, 0.8, "shaping the surface")
    mesh = shaped(mesh, look)
    report(progress, 1.0, "reading the surface")
    return mesh


def prepare_surface(view: View, progress: Progress | None = None) -> PreparedSurface:
    """Return the surface of ``view``, all of it; errors as :func:`load_shaped`, and Cancelled by ``progress``."""
    mesh = load_shaped(view.surface, view.surface_look, part(progress, 0.0, _READING_SHARE))
    if not wants_baking(view.surface_look):
        return PreparedSurface(mesh)
    return PreparedSurface(mesh, baked_occlusion(mesh, part(progress, _READING_SHARE, 1.0)))
