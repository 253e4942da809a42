"""Flat field: relative sensitivity of each pixel, from vignetting and the sensor."""

from __future__ import annotations

import numpy as np

from brdf_suite.acquisition.radiance.merge import DARK, GOOD, MergedRadiance
from brdf_suite.acquisition.radiance.noise_shrinking import shrunk
from brdf_suite.arrays import Singles
from brdf_suite.errors import AcquisitionError

_SMOOTH_SHARE = 0.01
_CENTRE_SHARE = 0.05
_LEAST = 0.02


def flat_field(merged: MergedRadiance) -> Singles:
    """Return (h, w, channels) the flat field, 1 at the picture's centre, from photographs of an evenly lit screen.

    The screen's photographs must not stamp their noise on every other: see
    :mod:`brdf_suite.acquisition.radiance.noise_shrinking`.

    Raises
    ------
    AcquisitionError
        More than a hundredth of the picture is clipped or dark, or the screen is not even in the least.
    """
    seen = merged.radiance.astype(np.float64)
    bad = (merged.state != GOOD) | (seen <= 0.0)
    share = float(bad.mean())
    if share > 0.01:
        what = "dark" if np.mean(merged.state == DARK) > 0.5 * share else "clipped or dark"
        raise AcquisitionError(
            f"The flat field is {what} in {100.0 * share:.0f} % of its pixels; the screen must fill the picture,"
            " with an exposure that is neither."
        )
    height, width, channels = seen.shape
    sigma = max(1.0, _SMOOTH_SHARE * max(height, width))
    answer = np.empty_like(seen)
    for c in range(channels):
        level = float(np.median(seen[..., c]))
        plane = np.where(bad[..., c], level, seen[..., c]) / level
        noise = float(np.mean(merged.variance[..., c][~bad[..., c]])) / level**2
        answer[..., c] = shrunk(plane, noise, sigma)[0]
        rows = slice(*_middle(height))
        columns = slice(*_middle(width))
        answer[..., c] /= answer[rows, columns, c].mean()
    if float(answer.min()) < _LEAST:
        raise AcquisitionError(
            "The flat field falls to nothing within the picture; the screen does not fill it evenly."
        )
    return answer.astype(np.float32)


def _middle(size: int) -> tuple[int, int]:
    half = max(1, int(0.5 * _CENTRE_SHARE * size))
    return max(0, size // 2 - half), min(size, size // 2 + half + size % 2)
