"""Raw camera files through rawpy (LibRaw): linear sensor RGB, 16 bits, without white balance or gain."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import ExtraError, FileError
from brdf_suite.extras import import_extra

RAW_ENDINGS = (
    ".dng",
    ".nef",
    ".cr2",
    ".cr3",
    ".crw",
    ".arw",
    ".raf",
    ".orf",
    ".rw2",
    ".pef",
    ".srw",
    ".iiq",
    ".3fr",
)


@contextmanager
def _opened(path: str | os.PathLike[str]) -> Iterator[tuple[Any, Any]]:
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


def raw_facts(path: str | os.PathLike[str]) -> tuple[int, int, int, float | None]:
    """Return width, height, bits and exposure time of the picture; unpacks its data to detect truncation."""
    with _opened(path) as (_, raw):
        if not raw.raw_image_visible.size:
            raise FileError(path, "holds no picture")
        seconds = float(raw.other.shutter_speed)
        return int(raw.sizes.iwidth), int(raw.sizes.iheight), 16, seconds if seconds > 0.0 else None


def raw_pixels(path: str | os.PathLike[str]) -> NDArray[np.uint16]:
    """Return (h, w, 3) uint16: demosaiced and black taken off, in the sensor's own channels.

    Neither white balance nor brightening nor a curve is applied, and the scale is that of full saturation, so that
    photographs of one camera can be compared. Fine detail is interpolated as LibRaw's AHD does.
    """
    with _opened(path) as (rawpy, raw):
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
    found: NDArray[np.uint16] = np.asarray(pixels, np.uint16)
    return found
