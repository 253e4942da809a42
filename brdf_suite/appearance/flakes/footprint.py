"""Pixel footprint of a flake, as a density over the flake's position.

The pixel is an ellipse on the surface, a flake a disc; together they have the covariance

    S = w² J Jᵀ + (s / 4)² I,

J the derivatives of the place on the surface by the pixel, w the pixel's reach in standard deviations, s the flake's
diameter. With t = dᵀ S⁻¹ d the density is

    k(t) = (1 - smoothstep(4 - e, 4 + e, t)) / (4π √det S),

of integral 1 for any e: a disc of S's size where flakes are large (e near 0), a soft spot where they are small
(e = 4). It ends at t = 8.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats

PIXEL_REACH = 0.43
"""Standard deviations of a pixel along an axis, in pixels; the contrast is that of a Gaussian of 0.5."""
FOOTPRINT_END = math.sqrt(8.0)
"""Where a footprint ends, in standard deviations."""
RAREST_TILT = 0.002
"""Of the most frequent tilt: the flake texture is not brighter than for tilts as frequent as this."""
FADE_FROM, FADE_TO = 0.75, 2.0
"""Standard deviations of a footprint, in cells, between which the flake texture fades."""


@dataclass(frozen=True)
class Footprint:
    """Footprints (n,): ``at`` (n, 2) mm, ``inverse`` (n, 3) of S as xx, xy, yy, ``height`` 1/mm², ``edge`` e,
    ``widest`` standard deviation and ``reach`` (n, 2) where it ends along each axis, mm.
    """

    at: Floats
    inverse: Floats
    height: Floats
    edge: Floats
    widest: Floats
    reach: Floats

    def cover(self, x: Floats, y: Floats) -> Floats:
        """Return k (n,), 1/mm², for flakes that lie (x, y) mm (n,) beside the point."""
        xx, xy, yy = self.inverse.T
        t = x * (xx * x + 2.0 * xy * y) + yy * y * y
        s = np.clip((4.0 + self.edge - t) / (2.0 * self.edge), 0.0, 1.0)
        return np.asarray(self.height * s * s * (3.0 - 2.0 * s))


def flake_footprint(at: Floats, across: Floats, down: Floats, size: float) -> Footprint:
    """Return footprints of pixels at ``at`` (n, 2) mm, derivatives (n, 2) mm per pixel, flakes of ``size`` mm."""
    own = (0.25 * size) ** 2
    pixel = PIXEL_REACH**2
    xx = pixel * (across[:, 0] ** 2 + down[:, 0] ** 2) + own
    xy = pixel * (across[:, 0] * across[:, 1] + down[:, 0] * down[:, 1])
    yy = pixel * (across[:, 1] ** 2 + down[:, 1] ** 2) + own
    half_sum = 0.5 * (xx + yy)
    half_gap = np.hypot(0.5 * (xx - yy), xy)
    large = half_sum + half_gap
    det = np.maximum(large * np.maximum(half_sum - half_gap, own), 1e-20)
    sharpest = np.sqrt(np.maximum(large - own, 0.0) / large)
    return Footprint(
        at,
        np.stack([yy, -xy, xx], axis=-1) / det[:, None],
        1.0 / (4.0 * math.pi * np.sqrt(det)),
        4.0 * np.clip(1.5 * sharpest, 0.01, 1.0),
        np.sqrt(large),
        FOOTPRINT_END * np.sqrt(np.stack([xx, yy], axis=-1)),
    )
