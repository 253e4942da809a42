"""Error of an approximation at its samples: the rows of Table 1 of McCool, Ang and Ahmad 2001."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True)
class Accuracy:
    """Means over all samples and channels, f_r in 1/sr; relative errors are of samples that are not 0.

    ``snr_db``: 20 log10(RMS of the samples / RMS of the error).
    """

    mean: float
    mean_found: float
    bias: float
    mean_absolute: float
    largest_absolute: float
    mean_relative: float
    median_relative: float
    largest_relative: float
    rms: float
    snr_db: float

    def to_json(self) -> dict[str, float]:
        """Return the figures by their names."""
        return asdict(self)


def accuracy(wanted: npt.ArrayLike, found: npt.ArrayLike) -> Accuracy:
    """Return the figures of an approximation ``found`` of ``wanted``, arrays of one shape."""
    truth, guess = np.asarray(wanted, np.float64), np.asarray(found, np.float64)
    error = guess - truth
    seen = np.abs(truth) > 0.0
    relative = np.abs(error[seen]) / np.abs(truth[seen])
    size, rms = float(np.sqrt(np.mean(truth**2))), float(np.sqrt(np.mean(error**2)))
    return Accuracy(
        mean=float(truth.mean()),
        mean_found=float(guess.mean()),
        bias=float(error.mean()),
        mean_absolute=float(np.abs(error).mean()),
        largest_absolute=float(np.abs(error).max()),
        mean_relative=float(relative.mean()) if relative.size else 0.0,
        median_relative=float(np.median(relative)) if relative.size else 0.0,
        largest_relative=float(relative.max()) if relative.size else 0.0,
        rms=rms,
        snr_db=20.0 * math.log10(size / rms) if size > 0.0 < rms else math.inf,
    )
