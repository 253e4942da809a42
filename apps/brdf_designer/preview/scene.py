"""What the small picture is made of: the speed form on the ground, and a shipped light on small maps, which are kept in
the cache.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from brdf_suite.documents.view import View
    from brdf_suite.fitting.lobes.basis import LobeBasis
    from brdf_suite.pipeline.scene import PreparedEnvironment
    from brdf_suite.progress import Progress
    from brdf_suite.surface.mesh import Mesh
    from brdf_suite.surface.occlusion.rays import BakedMesh

SURFACE = "speed_form"
LIGHTS = ("photo_studio", "booth", "street", "light_tunnel", "overcast", "sunny")


@dataclass(frozen=True, eq=False)
class PreviewScene:
    """A light, the form that it falls on, what is baked for that, and how it is looked at first.

    The exposure of ``view`` is locked: a darker paint shall look darker.
    """

    light: PreparedEnvironment
    surface: Mesh
    baked: BakedMesh | None
    view: View


def load_scene(request: tuple[str, LobeBasis], progress: Progress | None = None) -> PreviewScene:
    """Load the scene with the shipped light of a name, filtered for a basis.

    Raises
    ------
    SuiteError
        It cannot be read; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    # Deferred: only a window that shows the picture pays for these, and on a thread.
    from brdf_suite.lighting.environment import SMALL_COLUMNS
    from brdf_suite.pipeline.scene import default_view, load_environment, load_surface
    from brdf_suite.pipeline.surface import baked_where_wanted

    light, basis = request
    prepared = load_environment(light, progress, columns=SMALL_COLUMNS, basis=basis)
    _ = prepared.glint_lights  # found here, so that the first frame does not wait for them
    view = replace(default_view(prepared.name), surface=SURFACE, background="blurred", glare="off")
    surface = load_surface(SURFACE)
    return PreviewScene(prepared, surface, baked_where_wanted(surface, view.surface_look), view)
