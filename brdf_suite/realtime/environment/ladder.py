"""Exponents of an environment's broad lobe maps, and interpolation between them.

Plain numbers, because the preparation of maps needs them without OpenGL.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

BROADEST_SHARP = 100.0
"""Lobes above this exponent keep a cube map of their own: the stack would have to be finer for all."""


@dataclass(frozen=True)
class Ladder:
    """The exponents of the stack's slices, rising; after them is the slice of diffuse light through a coat.

    >>> ladder = Ladder((1.0, 4.0))
    >>> float(ladder.level(2.5)) * ladder.slices
    1.0
    """

    exponents: tuple[float, ...]

    def level(self, exponent: ArrayLike) -> NDArray[np.float64]:
        """Return the texture coordinate (...) of exponents (...): linear in E between slices, held outside.

        A lobe's peak is linear in E too, and the mixture of two is nearest so: the error is half that of log E.
        """
        place = np.interp(np.asarray(exponent, np.float64), self.exponents, np.arange(len(self.exponents)))
        return np.asarray((place + 0.5) / self.slices)

    @property
    def slices(self) -> int:
        """How many slices the stack has."""
        return len(self.exponents) + 1

    @property
    def through_coat(self) -> float:
        """The texture coordinate of diffuse light through a coat."""
        return (self.slices - 0.5) / self.slices

    @property
    def octave(self) -> float:
        """How much of the texture coordinate doubles an exponent, on average over the slices."""
        octaves = float(np.log2(self.exponents[-1] / self.exponents[0]))
        return (len(self.exponents) - 1) / self.slices / octaves if octaves > 0.0 else 0.0
