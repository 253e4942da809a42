"""Picture reader for 8 or 16 bits through Pillow, the only module that uses Pillow to open files.

Pillow knows forty formats, some of which start other programs (PostScript: Ghostscript) or are hardly ever tried. So a
format that is not asked for is refused, whatever the file's name says; so are pipes and devices, and pictures that
would take more memory than a picture of the suite needs.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import open_regular, within_memory

if TYPE_CHECKING:
    from PIL.Image import Image as PillowImage

PICTURE_FORMATS = ("PNG", "JPEG", "TIFF", "BMP", "TGA", "WEBP")
"""Pillow's names of the formats that maps and masks may have."""
MOST_BYTES = 1 << 29
"""Of memory for a picture: Pillow's and ours. 8,192 × 8,192 pixels in colour; Pillow refuses more than 179 million."""

_PIXEL_BYTES = {"1": 1, "L": 1, "P": 1, "I;16": 2, "I;16L": 2, "I;16B": 2, "I;16N": 2}
"""Bytes a pixel of Pillow's modes; all others take 4."""
_COLOUR_BYTES = 7
"""The same in colour, with our copy. Others count as much, since they take as long."""
_WEBP_BYTES = 17
"""The same of a WebP picture: libwebp's two canvases, its answer, Pillow's copy of it and the pixels."""
_STRIP_BYTES = 1 << 22
"""Of a strip that is converted, which is there three times meanwhile."""


@within_memory
def read_picture(path: PathLike, formats: Sequence[str] = PICTURE_FORMATS) -> NDArray[Any]:
    """Return pixels (h, w, 3) in colour or (h, w, 1) in grey, the first row at the top; alpha is dropped.

    uint8 0…255; uint16 or int32 0…65535 for grey of 16 bits; float32, as in the file, for grey of floats.

    Raises
    ------
    FileError
        The file cannot be read, is no plain file, has none of ``formats``, is damaged or too large.
    """
    return _read(path, None, formats, None, MOST_BYTES)


def read_rgb(
    path: PathLike,
    formats: Sequence[str],
    *,
    content: bytes | None = None,
    most_bytes: int = MOST_BYTES,
) -> NDArray[np.uint8]:
    """Return pixels (h, w, 3) uint8, the first row at the top; errors as :func:`read_picture`.

    With ``content`` the file's bytes are taken from there, and ``path`` only names it in messages. For what the suite
    or a camera made, ``most_bytes`` is :func:`brdf_suite.files.bounded_reading.most_made_bytes`: 151 million pixels in
    colour, and more where the setting allows it.
    """
    return np.asarray(_read(path, content, formats, "RGB", most_bytes), np.uint8)


def _read(
    path: PathLike,
    content: bytes | None,
    formats: Sequence[str],
    mode: str | None,
    most_bytes: int,
) -> NDArray[Any]:
    # Imported here: most of the suite needs no Pillow.
    from PIL import Image, UnidentifiedImageError

    kind = f"{formats[0]} picture" if len(formats) == 1 else f"picture ({', '.join(formats)})"
    with open_regular(path) if content is None else BytesIO(content) as stream:
        try:
            with warnings.catch_warnings():
                # The size is checked below. No other warning is left out: other threads give theirs.
                warnings.simplefilter("ignore", Image.DecompressionBombWarning)
                with Image.open(stream, formats=tuple(formats)) as image:
                    return _pixels(path, image, mode, most_bytes)
        except UnidentifiedImageError as error:
            raise FileError(path, f"is no {kind} that can be read") from error
        except FileError:
            raise
        except (Image.DecompressionBombError, MemoryError) as error:
            raise FileError(path, "has too many pixels to be read") from error
        except Exception as error:  # Pillow's readers raise whatever a damaged file runs them into
            raise FileError(path, f"is damaged, or no {kind} that can be read: {error}") from error


def _pixels(path: PathLike, image: PillowImage, mode: str | None, most_bytes: int) -> NDArray[Any]:
    if mode is None and image.mode != "F" and not image.mode.startswith("I"):
        mode = "L" if image.mode in ("1", "L", "LA") else "RGB"
    channels = 3 if mode == "RGB" else 1
    stored = _PIXEL_BYTES.get(image.mode, 4)
    item = 1 if mode is not None else stored
    each = max(_COLOUR_BYTES, stored + channels * item, _decoding_bytes(image, stored))
    most = max(0, most_bytes - 3 * _STRIP_BYTES) // each
    if image.width * image.height > most:
        raise FileError(
            path,
            f"is {image.width} × {image.height} pixels, too large to be read: "
            f"at most {most / 1e6:.0f} million pixels are",
        )
    image.load()
    image.info.pop("transparency", None)  # Pillow warns where it drops it
    rows = max(1, _STRIP_BYTES // max(1, 4 * image.width))
    pixels: NDArray[Any] | None = None
    for top in range(0, image.height, rows):  # whole, the conversion and its array would be held beside both
        strip = image.crop((0, top, image.width, min(top + rows, image.height)))
        part = np.asarray(strip if mode is None or strip.mode == mode else strip.convert(mode))
        if pixels is None:
            pixels = np.empty((image.height, image.width, channels), part.dtype)
        pixels[top : top + rows] = part.reshape(*part.shape[:2], channels)
    assert pixels is not None  # Pillow refuses a picture without rows
    return pixels


def _decoding_bytes(image: PillowImage, stored: int) -> int:
    """Return the bytes a pixel that decoding takes with Pillow's own ``stored`` ones."""
    if image.format == "WEBP":
        return _WEBP_BYTES
    # A progressive JPEG is decoded from all of its coefficients, two bytes each.
    return stored + (2 * len(image.getbands()) if image.info.get("progressive") else 0)
