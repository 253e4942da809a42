"""Camera response: the exposure and the noise for each code of each channel.

A photograph's code y is f(t·L) where L is the radiance, t the exposure time and f the response. What is kept is the
inverse, g(y) = t·L, as a table over all codes (Robertson, Borman and Stevenson 2003, "Estimation-theoretic approach
to dynamic range enhancement using multiple exposures"). A scale of g cannot be determined from photographs, as every
radiance takes it up; it is fixed for each channel by g(2^(bits-1)) = 0.5 above black. For a linear camera without
black level that is code / 2^bits.

The variance of one pixel's exposure X is modelled as read² + shot·X, and that of rounding to whole codes comes on top.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Integers
from brdf_suite.errors import ValueRangeError

MIDDLE_EXPOSURE = 0.5
"""The exposure that the middle code represents, in the unit of the photographs."""

_TOP_MARGIN = 0.01
# Of a linear sensor of 20,000 electrons and 8 electrons of read noise, where nothing better is known.
_READ = 4e-4
_SHOT = 5e-5
_SRGB_KNEE = 0.04045
_PER_CHANNEL = ("black", "lowest", "highest", "read", "shot")


@dataclass(frozen=True, eq=False)
class Response:
    """The inverse response and the noise of each channel.

    Attributes
    ----------
    bit_depth
        Codes run from 0 to 2^bit_depth - 1.
    exposure
        (channels, 2^bit_depth) float64, the exposure of each code, never falling; negative below black, so that
        the noise of a black pixel averages to nothing.
    black
        (channels,) the code without light, may be fractional.
    lowest, highest
        (channels,) codes between which the response was measured; a code above ``highest`` counts as clipped.
    read, shot
        (channels,) the noise: variance of an exposure X = read² + shot·X, in exposure².
    linear
        Whether exposure is proportional to the code above black.
    """

    bit_depth: int
    exposure: Floats
    black: Floats
    lowest: Integers
    highest: Integers
    read: Floats
    shot: Floats
    linear: bool

    def __post_init__(self) -> None:
        check_bit_depth(self.bit_depth)
        exposure = np.asarray(self.exposure, float)
        if exposure.ndim != 2 or exposure.shape[1] != 1 << self.bit_depth:
            reason = f"the shape is {exposure.shape}; expected a row of codes"
            raise ValueRangeError("response.exposure", reason)
        if not np.all(np.isfinite(exposure)) or np.any(np.diff(exposure, axis=1) < 0.0):
            reason = "exposures must be finite and must not fall as codes grow"
            raise ValueRangeError("response.exposure", reason)
        object.__setattr__(self, "exposure", exposure)
        for name in _PER_CHANNEL:
            value = np.array(getattr(self, name), np.int64 if name in ("lowest", "highest") else float)
            if value.shape != exposure.shape[:1] or not np.all(np.isfinite(value)) or np.any(value < 0):
                raise ValueRangeError(f"response.{name}", "one finite number of 0 or more for each channel")
            object.__setattr__(self, name, value)
        if np.any(self.highest >= exposure.shape[1]) or np.any(self.lowest > self.highest):
            raise ValueRangeError("response.highest", "it lies between the lowest and the largest code")

    @property
    def channels(self) -> int:
        """Return how many channels there are."""
        return int(self.exposure.shape[0])

    def rounding_variance(self) -> Floats:
        """Return (channels, 2^bit_depth) the variance of an exposure by rounding to whole codes, step²/12."""
        step = np.gradient(self.exposure, axis=1)
        return np.asarray(step * step / 12.0)

    def to_json(self) -> dict[str, object]:
        """Return plain values from which :meth:`from_json` makes the same response."""
        arrays = {name: getattr(self, name).tolist() for name in ("exposure", *_PER_CHANNEL)}
        return {"bit_depth": self.bit_depth, "linear": self.linear, **arrays}

    @classmethod
    def from_json(cls, values: Mapping[str, object]) -> Response:
        """Make a response from what :meth:`to_json` gave.

        Raises
        ------
        ValueRangeError
            A value is missing or out of its range; ``place`` names it.
        """
        bit_depth = values.get("bit_depth")
        if not isinstance(bit_depth, int):
            raise ValueRangeError("response.bit_depth", "expected a whole number")
        arrays: dict[str, Any] = {}
        for name in ("exposure", *_PER_CHANNEL):
            try:
                arrays[name] = np.asarray(values[name], float)
            except (KeyError, TypeError, ValueError) as error:
                raise ValueRangeError(f"response.{name}", "expected numbers for each channel") from error
        return cls(bit_depth, **arrays, linear=bool(values.get("linear", False)))


def check_bit_depth(bit_depth: int) -> None:
    """Raise :class:`ValueRangeError` where codes have fewer than 8 or more than 16 bits."""
    if not 8 <= bit_depth <= 16:
        raise ValueRangeError("bit_depth", f"{bit_depth} is outside the range 8 to 16")


def middle_code(bit_depth: int) -> int:
    """Return the code that represents an exposure of 0.5."""
    return 1 << (bit_depth - 1)


def linear_response(
    bit_depth: int,
    channels: int = 3,
    black: npt.ArrayLike = 0.0,
    read: npt.ArrayLike = _READ,
    shot: npt.ArrayLike = _SHOT,
    highest: npt.ArrayLike | None = None,
) -> Response:
    """Return the response of a camera whose codes above ``black`` are proportional to the exposure.

    >>> linear_response(12).exposure[0, [0, 2048]].tolist()
    [0.0, 0.5]
    """
    check_bit_depth(bit_depth)
    dark = np.broadcast_to(np.asarray(black, float), (channels,))
    codes = np.arange(1 << bit_depth)
    exposure = (codes - dark[:, None]) * (MIDDLE_EXPOSURE / (middle_code(bit_depth) - dark[:, None]))
    lowest = np.minimum(np.ceil(dark).astype(np.int64), codes[-1])
    top = default_highest(bit_depth) if highest is None else highest
    last, deviation, slope = (np.broadcast_to(value, (channels,)) for value in (top, read, shot))
    return Response(bit_depth, exposure, dark, lowest, last, deviation, slope, True)


def srgb_response(bit_depth: int, channels: int = 3) -> Response:
    """Return the response of photographs stored by the transfer curve of sRGB (IEC 61966-2-1)."""
    check_bit_depth(bit_depth)
    value = np.arange(1 << bit_depth) / ((1 << bit_depth) - 1.0)
    light = np.where(value <= _SRGB_KNEE, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    light *= MIDDLE_EXPOSURE / light[middle_code(bit_depth)]
    exposure, full = np.tile(light, (channels, 1)), np.ones(channels)
    lowest, highest = np.ones(channels, np.int64), np.full(channels, default_highest(bit_depth))
    return Response(bit_depth, exposure, 0.0 * full, lowest, highest, _READ * full, _SHOT * full, False)


def default_highest(bit_depth: int, largest: int | None = None) -> int:
    """Return the last code that does not count as clipped, a margin for noise below the ``largest``."""
    top = (1 << bit_depth) - 1 if largest is None else largest
    return top - max(2, math.ceil(_TOP_MARGIN * top))
