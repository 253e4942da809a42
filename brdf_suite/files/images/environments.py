"""Environment images from files, in the working space; pictures to files.

``read_environment_image`` is the one way in, for environments of every layout: it looks at the content, not the
ending, reads OpenEXR and Radiance pictures, converts to the working space (linear Rec. 2020, D65) and repairs
what cannot be radiance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import open_plain
from brdf_suite.files.images.exr.image import read_exr, write_exr
from brdf_suite.files.images.exr.writer import write_exr_strips
from brdf_suite.files.images.png import write_png, write_png_strips
from brdf_suite.files.images.primaries import REC2020, rgb_to_working
from brdf_suite.files.images.radiance import read_radiance
from brdf_suite.files.images.radiance_repair import clip_negative, note_darkness, repair_non_finite
from brdf_suite.files.memory_limit import within_memory

__all__ = [
    "ImageData",
    "read_environment_image",
    "write_exr",
    "write_exr_strips",
    "write_png",
    "write_png_strips",
]

MIN_SIDE = 2


@dataclass(frozen=True)
class ImageData:
    """An environment image as read.

    Attributes
    ----------
    pixels
        (h, w, 3) float32, linear Rec. 2020 with D65 white, finite and never negative, in the file's own layout.
    notes
        What was assumed or repaired, each a clause for the user; empty where nothing was.
    layout
        The layout that the file names (``exr_cube``); ``None`` where it follows from the shape alone.
    """

    pixels: NDArray[np.float32]
    notes: tuple[str, ...]
    layout: str | None = None


@within_memory
def read_environment_image(path: PathLike) -> ImageData:
    """Read an environment image from an OpenEXR or Radiance file, in whatever layout it has.

    Larger than 8,192 × 4,096 is reduced by area as it is read, in strips.

    Raises
    ------
    FileError
        The file is missing, damaged, too large or too small, or of another kind; the message says which.
    """
    with open_plain(path) as stream:
        start = stream.read(12)
    layout = None
    if start.startswith(b"\x76\x2f\x31\x01"):
        exr = read_exr(path)
        pixels, chromaticities, notes = exr.pixels, exr.chromaticities, exr.notes
        layout = "exr_cube" if exr.is_cube else None
    elif start.startswith(b"#?"):
        pixels, chromaticities, notes = read_radiance(path)
    else:
        raise FileError(path, _what_instead(start), "byte 0")
    height, width = pixels.shape[:2]
    if min(height, width) < MIN_SIDE:
        raise FileError(path, f"is {width} × {height} pixels, too small for an environment")
    if np.isnan(pixels).all():
        raise FileError(path, "holds no number (NaN) in any pixel; there is nothing to repair it from")
    pixels, repairs = repair_non_finite(pixels)
    # Files hold chromaticities as float32 or as text: four digits decide.
    if not np.allclose(chromaticities, REC2020, atol=5e-5):
        try:
            matrix = rgb_to_working(chromaticities).astype(np.float32)
        except ValueError as error:
            raise FileError(path, f"has unusable primaries: {error}", "attribute chromaticities") from error
        pixels = pixels @ matrix.T
    # After the conversion: a saturated colour of narrower primaries is a sound one in the working space.
    pixels, clipped = clip_negative(pixels)
    notices = (*notes, *repairs, *clipped, *note_darkness(pixels))
    return ImageData(np.ascontiguousarray(pixels), notices, layout)


def _what_instead(start: bytes) -> str:
    if not start:
        return "is empty"
    known = {
        b"\x89PNG": "a PNG picture",
        b"\xff\xd8\xff": "a JPEG picture",
        b"II*\0": "a TIFF",
        b"MM\0*": "a TIFF",
    }
    for magic, kind in known.items():
        if start.startswith(magic):
            return f"is {kind}; an environment must be an OpenEXR (.exr) or Radiance (.hdr) file"
    return "is neither an OpenEXR (.exr) nor a Radiance (.hdr) file, whatever its name says"
