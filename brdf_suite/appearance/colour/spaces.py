"""Further colour spaces: LCh, XYZ of the 2° observer, Bradford adaptation, and those of screens and picture files.

The working space itself (linear Rec. 2020, D65) and L*a*b* are in :mod:`brdf_suite.appearance.colour.colorimetry`; all
colour arrays are (..., 3). From the working space to a device's codes there are two steps: a matrix to the linear light
of its three channels, and for each channel a transfer curve. sRGB and Display P3 share the sRGB curve; a monitor has
its own, as a table. A monitor whose channels do not simply add up has one table of three dimensions in place of the
curves.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from numpy.typing import ArrayLike, NDArray

from brdf_suite.appearance.colour.colorimetry import (
    REC709_PRIMARIES,
    REC2020_PRIMARIES,
    WHITE_XY,
    WORKING_TO_SRGB,
    WORKING_TO_XYZ,
    AdaptationTransform,
    adaptation,
    lab_to_working,
    primaries_to_xyz,
    srgb_decode,
    srgb_encode,
)
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

P3_PRIMARIES = ((0.680, 0.320), (0.265, 0.690), (0.150, 0.060))
"""Chromaticities x, y of the primaries of Display P3 (SMPTE EG 432-1), with the white of D65."""

WORKING_TO_P3: Floats = np.asarray(
    np.linalg.solve(primaries_to_xyz(P3_PRIMARIES), WORKING_TO_XYZ), np.float64
)
"""Working space to linear Display P3 (the same white: no adaptation)."""

_XYZ_TO_WORKING: Floats = np.asarray(np.linalg.inv(WORKING_TO_XYZ) / 100.0, np.float64)
_DISPLAYS: dict[str, Floats] = {"sRGB": WORKING_TO_SRGB, "Display P3": WORKING_TO_P3}


def lab_to_lch(lab: npt.ArrayLike) -> Floats:
    """Return L*, C*ab, hab: hue in degrees, 0 to 360, counter-clockwise from +a*; 0 for a grey.

    >>> lab_to_lch([50.0, 0.0, 10.0]).tolist()
    [50.0, 10.0, 90.0]
    """
    lab = np.asarray(lab, float)
    hue = np.degrees(np.arctan2(lab[..., 2], lab[..., 1])) % 360.0
    # A hue of -1e-15° comes out of the modulus as 360 itself.
    hue = np.where(hue >= 360.0, 0.0, hue)
    return np.stack((lab[..., 0], np.hypot(lab[..., 1], lab[..., 2]), hue), axis=-1)


def lch_to_lab(lch: npt.ArrayLike) -> Floats:
    """Return L*a*b* of L*, C*ab and hue in degrees; the inverse of :func:`lab_to_lch`."""
    lch = np.asarray(lch, float)
    hue = np.radians(lch[..., 2])
    return np.stack((lch[..., 0], lch[..., 1] * np.cos(hue), lch[..., 1] * np.sin(hue)), axis=-1)


def working_to_xyz(rho: npt.ArrayLike) -> Floats:
    """Return XYZ of the 2° observer, the D65 white's Y = 100, of working-space values."""
    return np.asarray(100.0 * (np.asarray(rho, float) @ WORKING_TO_XYZ.T))


def xyz_to_working(xyz: npt.ArrayLike) -> Floats:
    """Return working-space values of XYZ for the 2° observer under D65; no adaptation."""
    return np.asarray(np.asarray(xyz, float) @ _XYZ_TO_WORKING.T)


def adapt_xyz(
    xyz: npt.ArrayLike,
    white_from: npt.ArrayLike,
    white_to: npt.ArrayLike,
    transform: AdaptationTransform = "CAT16",
) -> Floats:
    """Return XYZ adapted completely from one white to another, by CAT16 or Bradford."""
    return np.asarray(np.asarray(xyz, float) @ adaptation(white_from, white_to, transform).T)


_OKLAB_TO_LMS = np.array(
    (
        (1.0, 0.3963377774, 0.2158037573),
        (1.0, -0.1055613458, -0.0638541728),
        (1.0, -0.0894841775, -1.2914855480),
    )
)
_LMS_TO_SRGB = np.array(
    (
        (4.0767416621, -3.3077115913, 0.2309699292),
        (-1.2684380046, 2.6097574011, -0.3413193965),
        (-0.0041960863, -0.7034186147, 1.7076147010),
    )
)
"""Ottosson, A perceptual color space for image processing (2020)."""


def oklab_to_srgb(lightness: npt.ArrayLike, a: npt.ArrayLike, b: npt.ArrayLike) -> Floats:
    """Return linear sRGB (..., 3), not clipped, of OKLab's lightness (0 to 1), a and b (...)."""
    responses = np.stack((lightness, a, b), axis=-1) @ _OKLAB_TO_LMS.T
    return np.asarray(responses**3 @ _LMS_TO_SRGB.T)


def in_display_gamut(
    lab: npt.ArrayLike, display: str = "sRGB", tolerance: float = 1e-6
) -> npt.NDArray[np.bool_]:
    """Return whether (...) a display (``sRGB`` or ``Display P3``) can show L*a*b*; ``tolerance`` in linear light."""
    if display not in _DISPLAYS:
        raise ValueRangeError("display", f"expected one of {', '.join(_DISPLAYS)}, not {display!r}")
    linear = lab_to_working(lab) @ _DISPLAYS[display].T
    return np.asarray(np.all((linear >= -tolerance) & (linear <= 1.0 + tolerance), axis=-1))


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
    table
        (n, n, n, 3), codes 0…1 for the linear light ``srgb_decode(i / (n - 1))`` of red, green and blue, one axis
        each, in place of ``codes``. Between its points tetrahedra are linear, so greys come of greys alone.
    """

    title: str
    from_working: Floats
    primaries: Primaries | None = None
    codes: NDArray[np.float32] | None = None
    table: NDArray[np.float32] | None = None

    def __post_init__(self) -> None:
        if self.from_working.shape != (3, 3) or not np.isfinite(self.from_working).all():
            raise ValueRangeError("from_working", "expected a matrix of 3 by 3 finite numbers")
        if self.codes is not None and (
            self.codes.ndim != 2 or self.codes.shape[1] != 3 or len(self.codes) < 2
        ):
            raise ValueRangeError("codes", f"expected a table of n by 3, not {self.codes.shape}")
        if self.table is not None:
            shape = self.table.shape
            if len(shape) != 4 or shape[0] < 2 or shape != (shape[0],) * 3 + (3,):
                raise ValueRangeError("table", f"expected n by n by n by 3, not {shape}")
            if self.codes is not None:
                raise ValueRangeError("table", "expected a table or codes, not both")

    @property
    def white_xy(self) -> tuple[float, float]:
        """White of a space that is defined by primaries: D65."""
        return WHITE_XY

    def encode(self, linear: ArrayLike) -> Floats:
        """Return codes (..., 3), 0…1, of linear light of the device, clipped to 0…1."""
        encoded = srgb_encode(np.clip(np.asarray(linear, float), 0.0, 1.0))
        if self.table is not None:
            return interpolate_table(self.table, encoded)
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


def interpolate_table(table: ArrayLike, places: ArrayLike) -> Floats:
    """Return values (..., 3) of a table (n, n, n, 3) at places (..., 3), 0…1, by tetrahedral interpolation.

    Each cell is cut into the six tetrahedra that share its diagonal from black to white. From the cell's lowest corner
    the way leads along the axis of the largest remainder, then of the next, then of the smallest; the values at these
    four corners are weighted by the differences of the remainders.

    >>> identity = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, 3)] * 3, indexing="ij"), axis=-1)
    >>> interpolate_table(identity, [0.2, 0.7, 1.0]).round(12).tolist()
    [0.2, 0.7, 1.0]
    """
    table = np.asarray(table, float)
    places = np.asarray(places, float)
    steps = len(table) - 1
    scaled = np.clip(places, 0.0, 1.0).reshape(-1, 3) * steps
    corner = np.minimum(scaled.astype(np.intp), steps - 1)
    remainder = scaled - corner
    order = np.argsort(-remainder, axis=-1, kind="stable")
    sorted_remainders = np.take_along_axis(remainder, order, axis=-1)
    bounds = np.concatenate(
        (np.ones((len(scaled), 1)), sorted_remainders, np.zeros((len(scaled), 1))), axis=-1
    )
    weights = -np.diff(bounds, axis=-1)
    rows = np.arange(len(scaled))
    values = weights[:, :1] * table[tuple(corner.T)]
    for step in range(3):
        corner[rows, order[:, step]] += 1
        values += weights[:, step + 1, None] * table[tuple(corner.T)]
    return np.asarray(values.reshape(places.shape))


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
