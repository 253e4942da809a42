"""Pictures for the screen: values of a photograph or of a merged picture, with an exposure that can be changed at once.

Values are kept as 16-bit codes with a table of what each code stands for, so that another exposure is one look-up.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from brdf_suite.appearance.colour.colorimetry import srgb_encode

LONGEST_SIDE = 1200
"""Pictures beyond it are drawn from every second, third … pixel; what is counted is counted over all."""
_LEVELS = 65536
_DARKEST, _BRIGHTEST = -6.0, 2.0
_DECADES = _BRIGHTEST - _DARKEST


@dataclass(frozen=True, eq=False)
class Tones:
    """A picture: ``codes`` uint16 (rows, columns) or (rows, columns, 3), and the linear value (65536) of each code.

    A value of 1 is white at an exposure of 0 EV.
    """

    codes: NDArray[np.uint16]
    values: NDArray[np.float64]


def tones_of_codes(codes: NDArray[np.uint16], bits: int, values: NDArray[np.float64] | None = None) -> Tones:
    """Return a photograph's tones; ``values`` is what each of its 2^bits codes stands for, linear where not given."""
    top = (1 << bits) - 1
    if values is None:
        values = np.arange(top + 1) / top
    whole = np.full(_LEVELS, values[-1], dtype=float)
    whole[: top + 1] = values
    return Tones(np.ascontiguousarray(codes, dtype=np.uint16), whole)


def tones_of_linear(linear: NDArray[np.floating], white: float | None = None) -> Tones:
    """Return the tones of a merged picture over eight decades, six of them below white.

    ``white`` (usual: its 99th percentile) becomes 1.
    """
    known = np.nan_to_num(np.asarray(linear, dtype=np.float32), nan=0.0, posinf=0.0, neginf=0.0)
    if white is None:
        lit = known[known > 0.0]
        white = float(np.percentile(lit, 99.0)) if lit.size else 1.0
    scaled = np.clip(known / max(white, 1e-30), 10.0**_DARKEST, 10.0**_BRIGHTEST)
    codes = np.rint((np.log10(scaled) - _DARKEST) / _DECADES * (_LEVELS - 1)).astype(np.uint16)
    values = 10.0 ** (np.arange(_LEVELS) / (_LEVELS - 1) * _DECADES + _DARKEST)
    values[0] = 0.0
    return Tones(codes, values)


def drawn(tones: Tones, exposure_ev: float = 0.0) -> QImage:
    """Return the picture as sRGB, ``exposure_ev`` stops brighter; what is beyond white is white."""
    shown = np.clip(tones.values * 2.0**exposure_ev, 0.0, 1.0)
    bytes_of = np.rint(255.0 * np.asarray(srgb_encode(shown))).astype(np.uint8)
    return image_of(bytes_of[tones.codes])


def image_of(pixels: NDArray[np.uint8]) -> QImage:
    """Return an image of its own data: grey (rows, columns) or RGB (rows, columns, 3)."""
    pixels = np.ascontiguousarray(pixels)
    rows, columns = pixels.shape[:2]
    grey = pixels.ndim == 2
    form = QImage.Format.Format_Grayscale8 if grey else QImage.Format.Format_RGB888
    return QImage(pixels.data, columns, rows, columns * (1 if grey else 3), form).copy()


def area_of(inside: NDArray[np.bool_]) -> QImage:
    """Return an area as an image that is opaque where ``inside`` (rows, columns) is true."""
    alpha = np.ascontiguousarray(np.where(inside, 255, 0).astype(np.uint8))
    rows, columns = alpha.shape
    return QImage(alpha.data, columns, rows, columns, QImage.Format.Format_Alpha8).copy()
