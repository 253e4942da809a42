"""Uniforms of background.frag.glsl: the environment or colour behind the surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, srgb_decode
from brdf_suite.documents.view import View
from brdf_suite.realtime.environment.ladder import Ladder

BLUR_EXPONENT = 60.0
"""A cosine lobe of this exponent blurs the environment: 17° wide at half its height."""

_GREY = 0.18
_KINDS = {"environment": 0, "blurred": 1, "grey": 2, "colour": 2}


def plain_backdrop(view: View) -> NDArray[np.float64]:
    """Return the colour (3,) of a plain backdrop, working space, after the exposure: the view's, or 18 % grey."""
    if view.background != "colour":
        return np.full(3, _GREY)
    return np.asarray(REC709_TO_WORKING @ srgb_decode(view.background_colour))


def backdrop(view: View, ladder: Ladder) -> dict[str, object]:
    """Return the uniforms; ``ladder`` are the exponents of the environment's stack of lobes."""
    return {
        "backdrop": _KINDS[view.background],
        "backdrop_colour": tuple(plain_backdrop(view).tolist()),
        "backdrop_level": float(ladder.level(BLUR_EXPONENT)) if ladder.exponents else 0.0,
    }
