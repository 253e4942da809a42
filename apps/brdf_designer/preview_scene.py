"""What the small picture is made of: the speed form, and a shipped light on small maps, which are kept in the cache."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from brdf_suite.documents.view import View

if TYPE_CHECKING:
    from brdf_suite.lighting.environment import Environment
    from brdf_suite.pipeline.scene import PreparedEnvironment
    from brdf_suite.progress import Progress
    from brdf_suite.surface.mesh import Mesh

SURFACE = "speed_form"
LIGHTS = ("booth", "sunny", "overcast")
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


def load_scene(light: str, progress: Progress | None = None) -> PreviewScene:
    """Load the scene with the shipped light of that name.

    Raises
    ------
    SuiteError
        It cannot be read; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    # Deferred: only a window that shows the picture pays for these, and on a thread.
    from brdf_suite.lighting.cache import MapCache
    from brdf_suite.pipeline.environments import AUTOMATIC, read_environment
    from brdf_suite.pipeline.scene import find_environment, load_surface, prepare_environment

    name, path = find_environment(light)
    small = smaller(read_environment(path, AUTOMATIC, None), LIGHT_WIDTH)
    prepared = prepare_environment(name, small, MapCache().get_or_compute, progress)
    _ = prepared.glint_lights  # found here, so that the first frame does not wait for them
    return PreviewScene(prepared, load_surface(SURFACE))


def smaller(environment: Environment, width: int) -> Environment:
    """Return a lat-long light of at most ``width`` columns: the mean of whole blocks, so no light is lost.

    Rows of a lat-long image differ in solid angle by cos(elevation); within a block of a few rows that is the same
    to below a percent, except at the poles, whose rows hold next to nothing.
    """
    rows, columns = environment.radiance.shape[:2]
    block = columns // width
    if block < 2 or rows % block or columns % block:
        return environment
    split = environment.radiance.reshape(rows // block, block, columns // block, block, 3)
    return dataclasses.replace(environment, radiance=split.mean((1, 3)).astype(np.float32))
