"""Colour spaces of screens and picture files: sRGB, Display P3, or a measured monitor.

From the working space to codes there are two steps: a matrix to the linear light of the device's three channels,
and for each channel a transfer curve. sRGB and Display P3 share the sRGB curve; a monitor has its own, as a table.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.appearance.colour.colorimetry import (
    REC709_PRIMARIES,
    REC2020_PRIMARIES,
    WHITE_XY,
    WORKING_TO_SRGB,
    srgb_decode,
    srgb_encode,
)
from brdf_suite.appearance.colour.spaces import P3_PRIMARIES, WORKING_TO_P3
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

Primaries = tuple[tuple[float, float], tuple[float, float], tuple[float, float]]


@dataclass(frozen=True, eq=False)
class DisplaySpace:
    """Colour space and code range of a device.

    Attributes
    ----------
    title
        What the user reads.
    from_working
        (3, 3), working space to linear light of the device; working-space white is (1, 1, 1) there too.
    primaries
        CIE x, y of red, green and blue where they define the space (its white is then D65); None of a monitor.
    codes
        (n, 3), codes 0…1 of each channel for the linear light ``srgb_decode(i / (n - 1))``; None: the sRGB curve.
        Against sRGB-encoded light a screen's curve is nearly a straight line, so few steps are exact.
    """

    title: str
    from_working: Floats
    primaries: Primaries | None = None
    codes: NDArray[np.float32] | None = None

    def __post_init__(self) -> None:
        if self.from_working.shape != (3, 3) or not np.isfinite(self.from_working).all():
            raise ValueRangeError("from_working", "expected a matrix of 3 by 3 finite numbers")
        if self.codes is not None and (
            self.codes.ndim != 2 or self.codes.shape[1] != 3 or len(self.codes) < 2
        ):
            raise ValueRangeError("codes", f"expected a table of n by 3, not {self.codes.shape}")

    @property
    def white_xy(self) -> tuple[float, float]:
        """White of a space that is defined by primaries: D65."""
        return WHITE_XY

    def encode(self, linear: ArrayLike) -> Floats:
        """Return codes (..., 3), 0…1, of linear light of the device, clipped to 0…1."""
        encoded = srgb_encode(np.clip(np.asarray(linear, float), 0.0, 1.0))
        if self.codes is None:
            return encoded
        places = np.linspace(0.0, 1.0, len(self.codes))
        channels = [np.interp(encoded[..., i], places, self.codes[:, i]) for i in range(3)]
        return np.stack(channels, axis=-1)

    def of_working(self, rho: ArrayLike) -> Floats:
        """Return the device's linear light (..., 3) of working-space values; outside of 0…1 it cannot be shown."""
        return np.asarray(np.asarray(rho, float) @ self.from_working.T)


SRGB_SPACE = DisplaySpace("sRGB", WORKING_TO_SRGB, REC709_PRIMARIES)
DISPLAY_P3_SPACE = DisplaySpace("Display P3", WORKING_TO_P3, P3_PRIMARIES)

SPACES = {"srgb": SRGB_SPACE, "display-p3": DISPLAY_P3_SPACE}
"""The spaces that pictures are written in, by the words of the command line."""

WORKING_SPACE = DisplaySpace("Rec. 2020", np.eye(3), REC2020_PRIMARIES)
"""The working space itself, for pictures of radiance."""


def inverse_codes(curves: ArrayLike, steps: int = 1024) -> NDArray[np.float32]:
    """Return the table of :attr:`DisplaySpace.codes` for a device whose curves go the other way.

    ``curves`` (m, 3) is the linear light, 0…1 and never falling, of the codes i / (m - 1). Where a curve rests at one
    value, the lowest code gives it.
    """
    curves = np.asarray(curves, float)
    light = srgb_decode(np.linspace(0.0, 1.0, steps))
    codes = np.linspace(0.0, 1.0, len(curves))
    table = np.empty((steps, 3), np.float32)
    for channel in range(3):
        rising = np.concatenate([[True], np.diff(curves[:, channel]) > 0.0])
        table[:, channel] = np.interp(light, curves[rising, channel], codes[rising])
    return table
