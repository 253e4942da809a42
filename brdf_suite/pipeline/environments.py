"""An environment from an image file, whatever its layout."""

from __future__ import annotations

import os
from pathlib import Path
from typing import cast

from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.layouts import LAYOUTS, Layout, as_latlong, detect_layout
from brdf_suite.progress import Progress

AUTOMATIC = "auto"


def read_environment(
    path: str | os.PathLike[str], layout: str = AUTOMATIC, progress: Progress | None = None
) -> Environment:
    """Return the environment in a file, as a latitude-longitude map in the working space.

    Parameters
    ----------
    layout
        One of :data:`brdf_suite.lighting.layouts.LAYOUTS`, or ``auto``: what the file says of itself, else what
        its shape tells; the environment's notes say what was assumed.

    Raises
    ------
    FileError
        The file cannot be read, or its image cannot have the layout; the message says why.
    ValueRangeError
        There is no such layout.
    """
    from brdf_suite.files.images import read_environment_image

    if layout != AUTOMATIC and layout not in LAYOUTS:
        raise ValueRangeError("layout", f"must be {AUTOMATIC} or one of {', '.join(LAYOUTS)}, not {layout!r}")
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
        return Environment(Path(path).stem, pixels, (*image.notes, *assumed))
    except ValueRangeError as error:
        raise FileError(path, error.reason, error.place) from error
