"""What the small picture is made of: the speed form, and a shipped light on small maps, which are kept in the cache."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from brdf_suite.documents.view import View

if TYPE_CHECKING:
    from brdf_suite.fitting.lobes.basis import LobeBasis
    from brdf_suite.pipeline.scene import PreparedEnvironment
    from brdf_suite.progress import Progress
    from brdf_suite.surface.mesh import Mesh

SURFACE = "speed_form"
LIGHTS = ("booth", "photo_studio", "street", "light_tunnel", "overcast", "sunny")
LIGHT_WIDTH = 512
"""Columns of the light: in a picture some 400 pixels wide, mirrored in a curved body, more are not seen."""


@dataclass(frozen=True, eq=False)
class PreviewScene:
    """A light and the form that it falls on."""

    light: PreparedEnvironment
    surface: Mesh

    def view(self) -> View:
        """Return how it is looked at first. The exposure is locked: a darker paint shall look darker."""
        return View(environment=self.light.name, surface=SURFACE, background="blurred")


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
    from brdf_suite.pipeline.scene import load_environment, load_surface

    light, basis = request
    prepared = load_environment(light, progress, columns=LIGHT_WIDTH, basis=basis)
    _ = prepared.glint_lights  # found here, so that the first frame does not wait for them
    return PreviewScene(prepared, load_surface(SURFACE))
