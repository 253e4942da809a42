"""An environment from an image file, whatever its layout, or from the description of a studio or a sky."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import cast

from brdf_suite.documents.studio import STUDIO_ENDING, LightDocument, Sky, load_light
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.layouts import LAYOUTS, Layout, as_latlong, detect_layout
from brdf_suite.lighting.procedural import ProceduralEnvironment, sky, studio
from brdf_suite.progress import Progress

AUTOMATIC = "auto"
DRAFT_ROWS = 256


def read_environment(
    path: str | os.PathLike[str], layout: str = AUTOMATIC, progress: Progress | None = None
) -> Environment:
    """Return the environment in a file, as a latitude-longitude map in the working space.

    Parameters
    ----------
    path
        An image, or a ``.brdfstudio`` file, which is drawn at 1,024 × 512.
    layout
        One of :data:`brdf_suite.lighting.layouts.LAYOUTS`, or ``auto``: what the file says of itself, else what
        its shape gives it; the environment's notes say what was assumed.

    Raises
    ------
    FileError
        The file cannot be read, or its image cannot have the layout; the message says why.
    DocumentError
        The description of a studio or a sky is not valid; with the place.
    ValueRangeError
        There is no such layout.
    """
    return read_environment_file(path, layout, progress).environment


@dataclass(frozen=True, eq=False)
class EnvironmentFile:
    """An environment and what its file was: the layout that was read, and the size of the image, pixels.

    A description has the layout ``studio`` or ``sky`` and the size at which it was drawn.
    """

    environment: Environment
    layout: str
    image_width: int
    image_height: int


def read_environment_file(
    path: str | os.PathLike[str], layout: str = AUTOMATIC, progress: Progress | None = None
) -> EnvironmentFile:
    """Return an environment and what its file was; arguments and errors as :func:`read_environment`."""
    if layout != AUTOMATIC and layout not in LAYOUTS:
        raise ValueRangeError("layout", f"must be {AUTOMATIC} or one of {', '.join(LAYOUTS)}, not {layout!r}")
    if Path(path).suffix.lower() == STUDIO_ENDING:
        return _drawn(path, progress)
    image = read_environment_image(path)
    height, width = image.pixels.shape[:2]
    assumed: tuple[str, ...] = ()
    try:
        if layout != AUTOMATIC:
            chosen = cast(Layout, layout)
        elif image.layout is not None:
            chosen = cast(Layout, image.layout)
        else:
            chosen, assumed = detect_layout(width, height)
        pixels = as_latlong(image.pixels, chosen, progress)
        environment = Environment(Path(path).stem, pixels, (*image.notes, *assumed))
        return EnvironmentFile(environment, chosen, width, height)
    except ValueRangeError as error:
        raise FileError(path, error.reason, error.place) from error


def draw_light(
    light: LightDocument, progress: Progress | None = None, *, draft: bool = False
) -> ProceduralEnvironment:
    """Return the map of a studio or a sky, 1,024 × 512; a ``draft`` has half as many rows and rougher edges."""
    if isinstance(light, Sky):
        return sky(light, DRAFT_ROWS, progress=progress) if draft else sky(light, progress=progress)
    return studio(light, DRAFT_ROWS, 2, progress) if draft else studio(light, progress=progress)


def _drawn(path: str | os.PathLike[str], progress: Progress | None) -> EnvironmentFile:
    light = load_light(path)
    made = draw_light(light, progress)
    height, width = made.radiance.shape[:2]
    environment = Environment(Path(path).stem, made.radiance, (made.comment.rstrip("."),))
    return EnvironmentFile(environment, "sky" if isinstance(light, Sky) else "studio", width, height)
