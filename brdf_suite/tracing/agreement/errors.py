"""How far one picture is from another: ΔE00 and FLIP over the pixels of an object."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import display_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.extras import import_extra

PIXELS_PER_DEGREE = 67.0


@dataclass(frozen=True)
class PictureErrors:
    """ΔE00 over the object's pixels: mean and 99th percentile; and the mean FLIP of them."""

    mean: float
    p99: float
    flip: float


def errors_of(test: Floats, reference: Floats, inside: NDArray[np.bool_]) -> PictureErrors:
    """Return the errors of a picture against another, both encoded sRGB (h, w, 3), where ``inside`` (h, w)."""
    away = delta_e_of(test, reference)[inside]
    if not len(away):
        return PictureErrors(0.0, 0.0, 0.0)
    flip = flip_of(reference, test)[inside]
    return PictureErrors(float(away.mean()), float(np.quantile(away, 0.99)), float(flip.mean()))


def flip_of(reference: Floats, test: Floats) -> Floats:
    """Return the FLIP error (h, w), 0 to 1, of encoded sRGB pictures (h, w, 3) seen at 67 pixels per degree.

    Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020, by its authors' own program.
    Raise :class:`ExtraError` where that is missing or cannot be loaded.
    """
    evaluate = import_extra("flip_evaluator", purpose="the comparison of pictures").evaluate
    planes = [np.ascontiguousarray(np.clip(image, 0.0, 1.0), np.float32) for image in (reference, test)]
    found, _, _ = evaluate(
        *planes, "LDR", applyMagma=False, computeMeanError=False, parameters={"ppd": PIXELS_PER_DEGREE}
    )
    return np.asarray(found, np.float64).reshape(reference.shape[:2])


def delta_e_of(first: Floats, second: Floats) -> Floats:
    """Return ΔE00 (h, w) between pictures (h, w, 3), encoded sRGB."""
    return delta_e_2000(display_to_lab(first), display_to_lab(second))
