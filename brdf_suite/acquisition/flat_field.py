"""The flat field: how much of an even light each pixel gives, by vignetting and by its own sensitivity."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.merge import DARK, GOOD, Merged
from brdf_suite.errors import AcquisitionError

Floats32 = npt.NDArray[np.float32]

_SMOOTH_SHARE = 0.01
_CENTRE_SHARE = 0.05
_LEAST = 0.02


def flat_field(merged: Merged) -> Floats32:
    """Return (h, w, channels) the flat field, 1 at the picture's centre, from photographs of an evenly lit screen.

    Differences between neighbours are kept by the share of them that the noise does not explain, so that the screen's
    photographs do not stamp their noise on every other: flat = smooth + k·(seen - smooth), k = 1 - noise / seen
    variance about the smooth picture, 0…1 (Wiener).

    Raises
    ------
    AcquisitionError
        More than a hundredth of the picture is clipped or dark, or the screen is not even in the least.
    """
    from scipy.ndimage import gaussian_filter  # a sixth of a second to import

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
    answer = np.empty_like(seen)
    for c in range(channels):
        level = float(np.median(seen[..., c]))
        plane = np.where(bad[..., c], level, seen[..., c]) / level
        sigma = max(1.0, _SMOOTH_SHARE * max(height, width))
        # A straight continuation at the borders: reflection or repetition would flatten the fall-off there.
        edge = int(4.0 * sigma + 0.5)
        padded = np.pad(plane, edge, mode="reflect", reflect_type="odd")
        smooth = gaussian_filter(padded, sigma)[edge:-edge, edge:-edge]
        apart = (plane - smooth)[~bad[..., c]]
        noise = float(np.mean(merged.variance[..., c][~bad[..., c]])) / level**2
        kept = float(np.clip(1.0 - noise / max(float(np.mean(apart**2)), 1e-30), 0.0, 1.0))
        answer[..., c] = np.where(bad[..., c], smooth, smooth + kept * (plane - smooth))
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
