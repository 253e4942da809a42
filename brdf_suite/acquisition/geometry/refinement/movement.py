"""Detection of a movement of the sphere between two positions of the light.

A sphere that moves takes its highlights with it, from one position on. For each place in the series the fit is
asked how much better it would be with the sphere shifted from there on - two numbers more, in the linear form of the
fit, all others free to follow. The best place is taken where that cannot be chance and the shift can be seen; then the
next one, with the first in place.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats

_LEAST_PX = 0.4
_LEAST_SIGNIFICANCE = 8.0
_MOST = 4
_LEAST_EACH_SIDE = 2
_SPREAD = 1.4826  # of a normal distribution, over the median absolute deviation
_CLIP = 12.0  # standard deviations that one coordinate may count for
# The stated values have entered the fit already and should not hold the shift back.
_LOOSE = 0.1


@dataclass(frozen=True)
class Movement:
    """The sphere moved after position ``before`` and not later than position ``after`` (indices).

    ``pixels``: by how much, x and y, in the picture; ``significance``: in standard deviations.
    """

    before: int
    after: int
    pixels: tuple[float, float]
    significance: float

    @property
    def distance_px(self) -> float:
        """Return how far, pixels."""
        return math.hypot(*self.pixels)

    def sentence(self, names: Sequence[str]) -> str:
        """Return the notice for the user; ``names`` (K,) are the positions', such as their first photographs."""
        return (
            f"The sphere has moved by {self.distance_px:.1f} pixels between {names[self.before]} and "
            f"{names[self.after]}"
        )

    def to_json(self) -> dict[str, Any]:
        """Return the fields as plain values."""
        return {**vars(self), "pixels": list(self.pixels)}

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> Movement:
        """Return what :meth:`to_json` gave as plain values."""
        return cls(**{**value, "pixels": (float(value["pixels"][0]), float(value["pixels"][1]))})


def find_movements(
    positions: npt.NDArray[np.intp], off: Floats, slopes: Floats, sigma: Floats, lower: Floats
) -> tuple[Movement, ...]:
    """Return the movements, in order of the positions.

    Parameters
    ----------
    positions
        (n,) rising indices of the light's positions with a highlight.
    off
        (n, 2) seen less expected, pixels, after the fit.
    slopes
        (n, 2, p) derivatives of ``off``; of these the first three are the sphere's centre.
    sigma
        (n,) standard errors, pixels.
    lower
        (p, p) whitens the stated numbers' errors.
    """
    count, parameters = len(positions), slopes.shape[-1]
    splits: list[int] = []
    found: dict[int, tuple[Floats, float]] = {}
    if count < 4 * _LEAST_EACH_SIDE:
        return ()
    # Only what changes from one highlight to the next is noise; a movement is one such step among many.
    noise = _SPREAD * float(np.median(np.abs(np.diff(off, axis=0)) / sigma[1:, None])) / math.sqrt(2.0)
    weight = 1.0 / np.maximum(sigma * max(noise, 0.1), 0.02)
    base = np.concatenate(((slopes * weight[:, None, None]).reshape(-1, parameters), _LOOSE * lower), axis=0)
    wanted = np.concatenate((-(off * weight[:, None]).ravel(), np.zeros(parameters)))

    def step(split: int) -> Floats:
        columns = np.zeros((count, 2, 2))
        columns[split:] = np.eye(2)
        return np.concatenate(((columns * weight[:, None, None]).reshape(-1, 2), np.zeros((parameters, 2))))

    def misfit(chosen: Sequence[int]) -> tuple[float, Floats]:
        system = np.concatenate((base, *(step(split) for split in chosen)), axis=1)
        answer = np.asarray(np.linalg.lstsq(system, wanted)[0], float)
        rest = np.clip(system @ answer - wanted, -_CLIP, _CLIP)
        return float(rest @ rest), answer[parameters:].reshape(-1, 2)

    current = misfit(())[0]
    for _ in range(_MOST):
        tried = [s for s in range(_LEAST_EACH_SIDE, count - _LEAST_EACH_SIDE + 1) if s not in splits]
        sums = [misfit((*splits, s))[0] for s in tried]
        place = int(np.argmin(sums))
        better, shifts = misfit((*splits, tried[place]))
        significance = math.sqrt(max(current - better, 0.0))
        if significance < _LEAST_SIGNIFICANCE or float(np.linalg.norm(shifts[-1])) < _LEAST_PX:
            break
        splits.append(tried[place])
        found = {s: (shift, significance) for s, shift in zip(splits, shifts, strict=True)}
        current = better
    return tuple(
        Movement(
            int(positions[s - 1]),
            int(positions[s]),
            (float(-found[s][0][0]), float(-found[s][0][1])),
            found[s][1],
        )
        for s in sorted(found)
    )
