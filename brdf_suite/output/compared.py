"""What a paint is compared with: another paint, a measured file, or a picture."""

from __future__ import annotations

import os
from pathlib import Path

from brdf_suite.files.bounded_reading import most_made_bytes
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.images.pictures import read_rgb
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.progress import Progress, report
from brdf_suite.realtime.pictures.comparison import ComparedPicture

LIGHT_ENDING = ".exr"
SHOWN_ENDING = ".png"
PICTURE_ENDINGS = (LIGHT_ENDING, SHOWN_ENDING)


def is_picture(name_or_path: str | os.PathLike[str]) -> bool:
    """Return whether a name is that of a picture, by its ending, and not that of a paint.

    >>> is_picture("/pictures/reference.EXR"), is_picture("blue")
    (True, False)
    """
    return Path(name_or_path).suffix.lower() in PICTURE_ENDINGS


def load_compared(
    name_or_path: str | os.PathLike[str],
    progress: Progress | None = None,
    settings: FitSettings | None = None,
) -> LobeFit | ComparedPicture:
    """Return the fit of a paint or of a measured file, as ``settings`` say, or a picture.

    Raises
    ------
    SuiteError
        It cannot be read, or no lobes can be fitted; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    if is_picture(name_or_path):
        report(progress, 0.0, "reading the picture")
        return read_compared_picture(name_or_path)
    return fit_material(load_material(name_or_path), settings, progress=progress)


def read_compared_picture(path: str | os.PathLike[str]) -> ComparedPicture:
    """Return the picture in an EXR file, taken for light, or in a PNG, taken for what a screen shows (sRGB).

    Raises :class:`brdf_suite.errors.FileError` where it cannot be read.
    """
    if Path(path).suffix.lower() == LIGHT_ENDING:
        return ComparedPicture(read_environment_image(path).pixels, is_light=True)
    return ComparedPicture(read_rgb(path, ("PNG",), most_bytes=most_made_bytes()), is_light=False)
