"""Stateless quasi-random numbers: additive recurrences, rotated for each pixel by a hash.

``u_i = frac(turn + i α)`` fills the cube evenly for any count, so that the s samples of a pixel are stratified however
they are shared out among its p samples (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
Worked in whole numbers of 32 bits, whose overflow is the fraction.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.flakes.cells import scramble
from brdf_suite.reference.mitsuba_modules import dr, mi

Words = Any  # mi.UInt32

_ALPHA_2 = (0xC13FA9A9, 0x91E10DA5)
"""1/g and 1/g² of g³ = g + 1, times 2³²."""
_ALPHA_3 = (0xD1B54A32, 0xABC98388, 0x8CB92BA7)
"""1/g, 1/g², 1/g³ of g⁴ = g + 1, times 2³²."""


def fraction(word: Words) -> Any:
    """Return words as numbers in [0, 1)."""
    return mi.Float(word >> 8) * (1.0 / (1 << 24))


def in_pixel(index: Words) -> Any:
    """Return places in a pixel, (0, 1)²: the middle for index 0, even for any run of indices."""
    return mi.Point2f(*(fraction(index * mi.UInt32(alpha) + mi.UInt32(0x80000000)) for alpha in _ALPHA_2))


def in_cube(index: Words, turn: Words) -> tuple[Any, Any]:
    """Return a number and a pair, all even, for the sample ``index`` of the pixel given by ``turn``."""
    a, b, c = (
        fraction(index * mi.UInt32(alpha) + scramble(turn + mi.UInt32(0x9E3779B9 * (k + 1) & 0xFFFFFFFF)))
        for k, alpha in enumerate(_ALPHA_3)
    )
    return a, mi.Point2f(b, c)


def copy_to_device(values: npt.NDArray[Any], kind: Any) -> Any:
    """Return values (n,) as an array of ``kind`` in memory of the renderer's own.

    What numpy lends may begin anywhere, and a program that walks along it is compiled for where it begins.
    """
    found = dr.zeros(kind, len(values))
    dr.scatter(found, kind(np.ascontiguousarray(values)), dr.arange(mi.UInt32, len(values)))
    dr.eval(found)
    return found
