"""Photographs as sensor codes: PNG and TIFF of 8 or 16 bits, JPEG, OpenEXR and Radiance floats, and raw files.

What a file is, is seen from its content; raw files alone are known by their endings, as most of them begin as TIFF.
Nothing is converted: codes are those of the file, and of three equal channels where the picture is grey.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from brdf_suite.acquisition.photographs.jpeg import jpeg_parts, jpeg_pixels
from brdf_suite.acquisition.photographs.png import SIGNATURE, Content, FileContent, png_parts, png_pixels
from brdf_suite.acquisition.photographs.tiff import first_page, read_exposure, tiff_facts, tiff_pixels
from brdf_suite.errors import ExtraError, FileError, PathLike
from brdf_suite.extras import import_extra
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.files.images.radiance import read_radiance
from brdf_suite.regular_files import open_regular, within_memory

Kind = Literal["png", "tiff", "jpeg", "exr", "hdr", "raw"]

RAW_ENDINGS = (
    *(".dng", ".nef", ".cr2", ".cr3", ".crw", ".arw", ".raf"),
    *(".orf", ".rw2", ".pef", ".srw", ".iiq", ".3fr"),
)
"""Of camera files, which are known by their names alone: most begin as TIFF. LibRaw reads them, by rawpy."""

ENDINGS = (".png", ".tif", ".tiff", ".jpg", ".jpeg", ".exr", ".hdr", *RAW_ENDINGS)
"""Of files that can be photographs."""

LARGEST_FILE = 2 << 30

_MAGIC: dict[bytes, Kind] = {
    SIGNATURE: "png",
    b"II*\0": "tiff",
    b"MM\0*": "tiff",
    b"\xff\xd8\xff": "jpeg",
    b"\x76\x2f\x31\x01": "exr",
    b"#?": "hdr",
}


@dataclass(frozen=True)
class PhotographFacts:
    """Facts about a photograph known before its pixels are unpacked.

    ``bits`` a channel, None of floats; ``exposure_s`` from EXIF, None where it is absent.
    """

    kind: Kind
    width: int
    height: int
    bits: int | None
    exposure_s: float | None


@dataclass(frozen=True, eq=False)
class Photograph:
    """A photograph: ``codes`` (h, w, 3) uint8, uint16 or float32, and its facts."""

    codes: NDArray[Any]
    facts: PhotographFacts


def photograph_facts(path: PathLike) -> PhotographFacts:
    """Return the facts in a file's header without unpacking its pixels, where it is whole.

    Raises
    ------
    FileError
        It is missing, empty, cut off, or no photograph; the message says which.
    """
    with _opened(path) as content:
        return _facts(content, path)


@within_memory
def read_photograph(path: PathLike) -> Photograph:
    """Read a photograph; errors as :func:`photograph_facts`, and where its pixels are damaged."""
    with _opened(path) as content:
        facts = _facts(content, path)
        if facts.kind == "png":
            codes: NDArray[Any] = png_pixels(content, path)
        elif facts.kind == "tiff":
            codes = tiff_pixels(path)
        elif facts.kind == "jpeg":
            codes = jpeg_pixels(content[:], path)
        elif facts.kind == "raw":
            codes = raw_pixels(path)
        else:
            codes = _float_pixels(facts.kind, path)
    return Photograph(_three_channels(codes, path), facts)


@contextmanager
def _opened(path: PathLike) -> Iterator[Content]:
    """Yield a file's content; of what is not asked for, nothing is read."""
    if "\0" not in os.fspath(path) and not os.path.lexists(path):
        raise FileError(path, "is missing")
    with open_regular(path, LARGEST_FILE) as file:
        if os.fstat(file.fileno()).st_size == 0:
            raise FileError(path, "is empty; it was not copied whole")
        yield FileContent(file)


def _facts(content: Content, path: PathLike) -> PhotographFacts:
    kind = _kind(content[:16], path)
    if kind == "png":
        parts = png_parts(content, path)
        time = None if parts.exif is None else _exposure(parts.exif.removeprefix(b"Exif\0\0"), path)
        return PhotographFacts(kind, parts.width, parts.height, parts.bits, time)
    if kind == "tiff":
        return PhotographFacts(kind, *tiff_facts(path))
    if kind == "jpeg":
        jpeg = jpeg_parts(content[:], path)
        time = _exposure(jpeg.exif, path) if jpeg.exif else None
        return PhotographFacts(kind, jpeg.width, jpeg.height, 8, time)
    if kind == "raw":
        return PhotographFacts(kind, *raw_facts(path))
    height, width = _float_pixels(kind, path).shape[:2]
    return PhotographFacts(kind, width, height, None, None)


def _kind(start: bytes, path: PathLike) -> Kind:
    if Path(path).suffix.lower() in RAW_ENDINGS:
        return "raw"
    for magic, kind in _MAGIC.items():
        if start.startswith(magic):
            return kind
    known = "PNG, TIFF, JPEG, OpenEXR, Radiance or a camera's raw file"
    raise FileError(path, f"is no photograph that is read here: {known}", "byte 0")


def _exposure(block: bytes, path: PathLike) -> float | None:
    """Return the time in an EXIF block; None for a damaged one, as the pixels do not depend on it."""
    try:
        with first_page(block, path) as page:
            return read_exposure(page)
    except FileError:
        return None


def _float_pixels(kind: Kind, path: PathLike) -> NDArray[np.float32]:
    pixels = read_exr(path).pixels if kind == "exr" else read_radiance(path)[0]
    if not np.isfinite(pixels).all():
        raise FileError(path, "holds values that are no numbers (NaN or infinite)")
    return pixels


def _three_channels(codes: NDArray[Any], path: PathLike) -> NDArray[Any]:
    """Return (h, w, 3): grey three times, and without an alpha channel."""
    if codes.dtype == np.float16:
        codes = codes.astype(np.float32)
    channels = codes.shape[2]
    if channels in (1, 2):
        return np.repeat(codes[..., :1], 3, axis=2)
    if channels not in (3, 4):
        raise FileError(path, f"has {channels} channels; expected grey or red, green, blue")
    return np.ascontiguousarray(codes[..., :3])


@contextmanager
def _opened_raw(path: PathLike) -> Iterator[tuple[Any, Any]]:
    """Yield the module and the opened file; whatever LibRaw says becomes :class:`FileError`."""
    try:
        rawpy = import_extra(
            "rawpy", purpose="a camera's raw file", instead="a TIFF of 16 bits needs nothing more"
        )
    except ExtraError as error:
        raise FileError(path, error.reason) from error
    try:
        with rawpy.imread(os.fspath(path)) as raw:
            yield rawpy, raw
    except rawpy.LibRawError as error:
        detail = error.args[0] if error.args else ""
        text = detail.decode("utf-8", "replace") if isinstance(detail, bytes) else str(detail)
        raise FileError(path, f"cannot be read as a raw file ({text or type(error).__name__})") from error


def raw_facts(path: PathLike) -> tuple[int, int, int, float | None]:
    """Return width, height, bits and exposure time of the picture; unpacks its data to detect truncation."""
    with _opened_raw(path) as (_, raw):
        if not raw.raw_image_visible.size:
            raise FileError(path, "holds no picture")
        seconds = float(raw.other.shutter_speed)
        return int(raw.sizes.iwidth), int(raw.sizes.iheight), 16, seconds if seconds > 0.0 else None


def raw_pixels(path: PathLike) -> NDArray[np.uint16]:
    """Return (h, w, 3) uint16, linear: demosaiced and black taken off, in the sensor's own channels.

    Neither white balance nor brightening nor a curve is applied, and the scale is that of full saturation, so that
    photographs of one camera can be compared. Fine detail is interpolated as LibRaw's AHD does.
    """
    with _opened_raw(path) as (rawpy, raw):
        pixels = raw.postprocess(
            gamma=(1.0, 1.0),
            no_auto_bright=True,
            output_bps=16,
            use_camera_wb=False,
            use_auto_wb=False,
            user_wb=[1.0, 1.0, 1.0, 1.0],
            output_color=rawpy.ColorSpace.raw,
            highlight_mode=rawpy.HighlightMode.Clip,
            user_flip=0,
            no_auto_scale=False,
            adjust_maximum_thr=0.0,
        )
    return np.asarray(pixels, np.uint16)
