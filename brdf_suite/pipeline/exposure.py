"""Automatic exposure: the object's median luminance becomes 0.18, as a meter that is pointed at it would have it.

It is measured from a small picture of the very view, before exposure and tone curve, so it follows whatever the
object is lit and painted with, and takes no part of the background.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.documents.view import PARAMETERS, View
from brdf_suite.realtime.pictures.renderer import Renderer

MIDDLE_GREY = 0.18
LONGEST_EDGE = 160
_WHOLE = 0.99
_LARGEST_EV = 20.0


def automatic_ev(renderer: Renderer, view: View, size: tuple[int, int]) -> float | None:
    """Return the exposure (EV) at which the object's median luminance is 0.18; its context must be current.

    ``size`` is the picture's, width and height; a picture of its shape and at most 160 pixels wide or high is
    measured. None where no pixel shows the object, or it is black.
    """
    scale = min(1.0, LONGEST_EDGE / max(size))
    small = (max(1, round(size[0] * scale)), max(1, round(size[1] * scale)))
    # Exposure and background have no part in it.
    plain = replace(view, exposure_ev=0.0, exposure_mode="locked", background="grey")
    return ev_of(renderer.linear_image(plain, small, 1))


def ev_of(radiance: NDArray[np.floating]) -> float | None:
    """Return the exposure for radiance of the working space with the object's share, (h, w, 4); see above."""
    inside = radiance[radiance[..., 3] >= _WHOLE][:, :3].astype(np.float64)
    if not len(inside):
        return None
    median = float(np.median(inside @ LUMINANCE))
    if not median > 0.0:
        return None
    return min(_LARGEST_EV, max(-_LARGEST_EV, math.log2(MIDDLE_GREY / median)))


def metered(renderer: Renderer, view: View, size: tuple[int, int]) -> View:
    """Return the view with its exposure measured where it is automatic; the renderer's context must be current."""
    if view.exposure_mode == "locked":
        return view
    return exposed(view, automatic_ev(renderer, view, size))


def exposed(view: View, metered_ev: float | None) -> View:
    """Return the view with the metered exposure put into ``exposure_ev``, which counts from it.

    A locked view is returned as it is.
    """
    if view.exposure_mode == "locked":
        return view
    limits = PARAMETERS["exposure_ev"]
    ev = view.exposure_ev + (metered_ev or 0.0)
    return replace(view, exposure_mode="locked", exposure_ev=min(limits.high, max(limits.low, ev)))
