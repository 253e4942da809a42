"""Picture from sums over pixels, and sums in an EXR file: a regular picture with the state to resume from.

Channels ``R G B`` hold the whole picture's radiance, ``A`` the object's coverage, ``object.R`` … its own light and
``ground.R`` … the darkness of its shadow, all as means over the samples. A text attribute holds their number,
and of which scene.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.reference.state_file import reading_state, write_state


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


ATTRIBUTE = "brdfSuiteRaytraced"


def write_sums(
    path: str | os.PathLike[str],
    sums: Sums,
    picture: Floats,
    key: str,
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write sums atomically; ``picture`` (h, w, 3) is their light with the backdrop, ``key`` identifies the scene."""
    planes = {"A": sums.coverage}
    for index, name in enumerate("RGB"):
        planes[name] = picture[..., index]
        planes[f"object.{name}"] = sums.radiance[..., index]
        planes[f"ground.{name}"] = sums.darkness[..., index]
    state = {"key": key, "samples": sums.samples, "seconds": sums.seconds}
    write_state(path, ATTRIBUTE, state, planes, metadata)


def read_sums(path: str | os.PathLike[str], key: str) -> Sums | None:
    """Return the sums of a file that :func:`write_sums` wrote for the same ``key``; None for another scene.

    Raises
    ------
    FileError
        The file cannot be read, or was not written by this program.
    """
    with reading_state(path, ATTRIBUTE) as (state, planes):
        if state["key"] != key:
            return None
        names = [*(f"object.{n}" for n in "RGB"), "A", *(f"ground.{n}" for n in "RGB")]
        samples = int(state["samples"])
        values = np.stack([planes[name] for name in names], axis=-1) * samples
        return Sums(values, samples, float(state["seconds"]))
