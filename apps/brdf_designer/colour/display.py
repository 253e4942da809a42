"""L*a*b* as the screen shows it: sRGB codes, clipped, with word of what was clipped."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, lab_to_working, srgb_encode
from brdf_suite.appearance.colour.spaces import lch_to_lab
from brdf_suite.arrays import Bools, Bytes

_TOLERANCE = 1e-4


def lab_to_codes(lab: ArrayLike) -> tuple[Bytes, Bools]:
    """Return sRGB codes (..., 3) of L*a*b* (D65, 10°) and whether (...) the screen can show each."""
    return working_to_codes(lab_to_working(lab))


def working_to_codes(rho: ArrayLike) -> tuple[Bytes, Bools]:
    """Return sRGB codes (..., 3) of a reflectance factor in the working space, and whether each is shown."""
    linear = np.asarray(rho, float) @ WORKING_TO_SRGB.T
    inside = np.all((linear >= -_TOLERANCE) & (linear <= 1.0 + _TOLERANCE), axis=-1)
    codes = np.rint(255.0 * srgb_encode(np.minimum(np.maximum(linear, 0.0), 1.0))).astype(np.uint8)
    return codes, np.asarray(inside)


def component_tracks(
    colours: NDArray[np.float64], positions: list[NDArray[np.float64]], *, in_lch: bool = False
) -> list[list[tuple[Bytes, Bools]]]:
    """Return what each position of each slider would give, all else kept: by colour, then by component.

    ``colours`` (n, 3) are L*a*b*, or LCh with the hue in degrees where ``in_lch``; ``positions`` three arrays.
    """
    counts = [len(p) for p in positions]
    stack = np.repeat(colours[:, None, :], sum(counts), axis=1)
    at = 0
    for component, values in enumerate(positions):
        stack[:, at : at + len(values), component] = values
        at += len(values)
    codes, inside = lab_to_codes(lch_to_lab(stack) if in_lch else stack)
    ends = np.cumsum(counts)[:-1]
    return [
        list(zip(np.split(row, ends), np.split(flags, ends), strict=True))
        for row, flags in zip(codes, inside, strict=True)
    ]
