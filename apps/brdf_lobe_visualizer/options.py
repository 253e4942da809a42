"""What all views share: channel, radius, cosine, what is shown of each subject, which lobes are switched off."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from brdf_suite.arrays import Floats

Channel = Literal["colour", "r", "g", "b", "luminance"]
Radius = Literal["linear", "cbrt", "log"]
Cosine = Literal["none", "light", "both"]
Shown = Literal["target", "fit", "both", "side by side", "difference"]
Part = Literal["diffuse", "directional", "gloss"]

CHANNELS: tuple[Channel, ...] = ("colour", "r", "g", "b", "luminance")
RADII: tuple[Radius, ...] = ("linear", "cbrt", "log")
COSINES: tuple[Cosine, ...] = ("none", "light", "both")
"""What f_r is multiplied with: nothing (1/sr), N·L (reflected radiance), N·L and N·V (intensity)."""
SHOWN: tuple[Shown, ...] = ("target", "fit", "both", "side by side", "difference")
PARTS_OF_FIT: tuple[Part, ...] = ("diffuse", "directional", "gloss")

INCIDENCE_DEG = (45.0, 0.0)
"""Polar angle and azimuth of the light at a first start, and after a reset."""
MOST_THETA_DEG = 89.9


@dataclass(frozen=True)
class Options:
    """The options; the defaults are what a reset goes back to.

    ``lobes_off`` holds ``(part, index)`` of the lobes of a fit that are switched off, the index into its exponents;
    the diffuse part has the index 0.
    """

    channel: Channel = "colour"
    radius: Radius = "cbrt"
    cosine: Cosine = "light"
    shown: Shown = "target"
    lobes_off: frozenset[tuple[Part, int]] = frozenset()


def cosine_factor(cosine: Cosine, wi: Floats, wo: Floats) -> Floats:
    """Return what f_r is multiplied with, (...), for ``wi`` and ``wo`` (..., 3); at least 0.

    >>> float(cosine_factor("both", np.array([0.0, 0.6, 0.8]), np.array([0.0, 0.0, 1.0])))
    0.8
    """
    light, view = np.maximum(wi[..., 2], 0.0), np.maximum(wo[..., 2], 0.0)
    if cosine == "none":
        return np.ones(np.broadcast_shapes(light.shape, view.shape))
    return (
        np.asarray(light * view)
        if cosine == "both"
        else np.broadcast_to(light, np.broadcast_shapes(light.shape, view.shape))
    )
