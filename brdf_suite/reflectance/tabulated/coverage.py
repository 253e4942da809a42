"""Coverage of a measured table: number of readings and uncertainty of each bin."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Singles
from brdf_suite.errors import ValueRangeError


@dataclass(frozen=True, eq=False)
class Coverage:
    """Number of readings and uncertainty of each bin; without readings, the table's value was filled in.

    Attributes
    ----------
    samples
        (θh, θd, φd) float32, the number of readings in a bin, 0 or more.
    deviation
        (θh, θd, φd) float32, standard error of the bin's value over the value; 0 where there are no readings.

    Raises
    ------
    ValueRangeError
        The shapes differ, or a number is negative or not finite.
    """

    samples: Singles
    deviation: Singles

    def __post_init__(self) -> None:
        for name in ("samples", "deviation"):
            array = np.ascontiguousarray(getattr(self, name), np.float32).view()
            if array.ndim != 3 or array.shape != self.samples.shape:
                raise ValueRangeError(
                    name, f"has the shape {array.shape}; expected (θh, θd, φd), alike for both"
                )
            # A NaN is neither.
            if not (array.min() >= 0.0 and array.max() < np.inf):
                raise ValueRangeError(name, "holds a number that is negative or not finite")
            array.flags.writeable = False
            object.__setattr__(self, name, array)

    @property
    def shape(self) -> tuple[int, ...]:
        """Return the numbers of bins along (θh, θd, φd)."""
        return self.samples.shape

    def folded(self) -> Coverage:
        """Return the coverage of a table whose pairs and their swaps were made one: φd halved.

        The readings add; the uncertainty is that of the mean of the two, or of the one that was measured.
        """
        half = self.shape[2] // 2
        one, other = self.samples[:, :, :half], self.samples[:, :, half:]
        squares = self.deviation[:, :, :half] ** 2 + self.deviation[:, :, half:] ** 2
        both = (one > 0.0) & (other > 0.0)
        return Coverage(one + other, np.sqrt(np.where(both, 0.25, 1.0) * squares))
