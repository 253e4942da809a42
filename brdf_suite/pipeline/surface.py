"""From the view's words about its surface to what is drawn: read, shaped, and baked where that is wanted."""

from __future__ import annotations

from dataclasses import replace

from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion
from brdf_suite.pipeline.scene import load_surface
from brdf_suite.progress import Progress, report, stage
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh
from brdf_suite.surface.repair import shape_mesh


def wants_baking(look: SurfaceLook) -> bool:
    """Whether a picture with this look shows anything that has to be baked."""
    return look.occlusion or look.ground


def load_shaped(name_or_path: str, look: SurfaceLook, progress: Progress | None = None) -> Mesh:
    """Return a surface by packaged name or by file, in the unit, scale and place that ``look`` says.

    Raises :class:`FileError`: there is no such surface, or its file cannot be read; the message says why.
    """
    report(progress, 0.0, "reading the surface")
    mesh = load_surface(name_or_path, look)
    report(progress, 0.8, "shaping the surface")
    mesh = shape_mesh(mesh, look)
    report(progress, 1.0, "reading the surface")
    return mesh


def bake_or_explain(
    mesh: Mesh, look: SurfaceLook, progress: Progress | None = None
) -> tuple[Mesh, BakedMesh | None]:
    """Return as :func:`baked_where_wanted`; where this machine has no ray tracer, the mesh with a note and None."""
    try:
        return mesh, baked_where_wanted(mesh, look, progress)
    except Cancelled:
        raise
    except SuiteError as error:  # all else can be drawn
        note = f"{error} The picture is drawn without occlusion and ground."
        return replace(mesh, notes=(*mesh.notes, note)), None


def baked_where_wanted(mesh: Mesh, look: SurfaceLook, progress: Progress | None = None) -> BakedMesh | None:
    """Return what is baked for a mesh, or None where ``look`` shows nothing of it; Cancelled by ``progress``."""
    if not wants_baking(look):
        return None
    return baked_occlusion(mesh, stage(progress, 0.0, 1.0, "computing ambient occlusion"))
