"""Picture from sums over pixels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats


@dataclass(frozen=True, eq=False)
class Sums:
    """Sums (h, w, 7) over ``samples`` of each pixel, traced in ``seconds``: the object's radiance in the working space,
    its coverage, and the darkness of the ground beside it, 0 where it is as light as an open one.
    """

    values: Floats
    samples: int
    seconds: float = 0.0

    @classmethod
    def nothing(cls, size: tuple[int, int]) -> Sums:
        """Return the sums before the first sample."""
        return cls(np.zeros((size[1], size[0], 7)), 0)

    def plus(self, values: Floats, samples: int, seconds: float) -> Sums:
        """Return the sums with more samples."""
        return Sums(self.values + values, self.samples + samples, self.seconds + seconds)

    @property
    def radiance(self) -> Floats:
        """(h, w, 3): of the object, times its coverage."""
        return np.asarray(self.values[..., :3] / max(self.samples, 1))

    @property
    def coverage(self) -> Floats:
        """(h, w): the object's share of each pixel."""
        return np.asarray(self.values[..., 3] / max(self.samples, 1))

    @property
    def darkness(self) -> Floats:
        """(h, w, 3): the fraction of the backdrop's light removed by the object's shadow."""
        return np.asarray(self.values[..., 4:] / max(self.samples, 1))

    def before(self, behind: Floats | npt.NDArray[np.float32]) -> Floats:
        """Return the whole picture's radiance (h, w, 3) before the backdrop ``behind`` (h, w, 3)."""
        room = np.clip(1.0 - self.coverage[..., None] - self.darkness, 0.0, None)
        return np.asarray(self.radiance + room * behind)
