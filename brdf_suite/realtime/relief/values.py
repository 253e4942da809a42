"""Surface images as input of the renderer: relief slopes, the orange peel tile, a mask."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import ValueRangeError

LARGEST_SIDE = 8192


@dataclass(frozen=True, eq=False)
class SlopeMap:
    """A relief as ``slopes`` (h, w, 2): dh/du and dh/dv, rows along v from its lower edge; it repeats."""

    slopes: NDArray[Any]

    def __post_init__(self) -> None:
        object.__setattr__(self, "slopes", _image(self.slopes, 2, "slopes"))

    @property
    def aspect(self) -> float:
        """Height over width."""
        return float(self.slopes.shape[0] / self.slopes.shape[1])


@dataclass(frozen=True, eq=False)
class TangentMap:
    """Directions of the tangent: ``turns`` (h, w, 2), cosine and sine of the angle from u towards v.

    Rows go along v from its lower edge; it repeats. Where directions are mixed it is shorter than 1.
    """

    turns: NDArray[Any]

    def __post_init__(self) -> None:
        object.__setattr__(self, "turns", _image(self.turns, 2, "turns"))

    @property
    def aspect(self) -> float:
        """Height over width."""
        return float(self.turns.shape[0] / self.turns.shape[1])


@dataclass(frozen=True, eq=False)
class PeelTile:
    """A tile of orange peel: ``slopes`` (n, n, 2) with a mean square of 1 in all; ``waves`` along an edge."""

    slopes: NDArray[Any]
    waves: int

    def __post_init__(self) -> None:
        object.__setattr__(self, "slopes", _image(self.slopes, 2, "peel"))
        if self.waves < 1:
            raise ValueRangeError("waves", f"expected 1 or more, not {self.waves}")


@dataclass(frozen=True, eq=False)
class MaskImage:
    """Mask of the second paint: ``share`` (h, w), 0…1, rows from the lower edge; it repeats."""

    share: NDArray[Any]

    def __post_init__(self) -> None:
        share = _image(np.asarray(self.share)[..., None], 1, "mask")[..., 0]
        if share.size and (share.min() < 0.0 or share.max() > 1.0):
            raise ValueRangeError("mask", "expected shares of 0 to 1")
        object.__setattr__(self, "share", share)

    @property
    def aspect(self) -> float:
        """Height over width."""
        return float(self.share.shape[0] / self.share.shape[1])


def _image(values: NDArray[Any], channels: int, place: str) -> NDArray[np.float32]:
    array: NDArray[np.float32] = np.ascontiguousarray(values, np.float32)
    if array.ndim != 3 or array.shape[2] != channels or min(array.shape[:2]) < 1:
        raise ValueRangeError(place, f"expected rows, columns and {channels} numbers, not {array.shape}")
    if max(array.shape[:2]) > LARGEST_SIDE:
        raise ValueRangeError(place, f"at most {LARGEST_SIDE} texels along an edge, not {array.shape[:2]}")
    if not np.isfinite(array).all():
        raise ValueRangeError(place, "not every number is finite")
    return array
