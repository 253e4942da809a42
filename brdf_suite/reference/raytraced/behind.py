"""Noise-free environment behind each pixel, as ``reference.scene.backdrop``, on the renderer's arrays."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.camera import Pinhole
from brdf_suite.reference.raytraced.sky import TracedSky

PLACES = 3
"""Looks along each edge of a pixel."""


def sky_behind(sky: TracedSky, camera: Pinhole, size: tuple[int, int]) -> npt.NDArray[np.float32]:
    """Return (h, w, 3): the mean radiance of the sky behind each pixel."""
    pixel = dr.arange(mi.UInt32, size[0] * size[1])
    column, row = pixel % camera.width, pixel // camera.width

    def one_more(k: mi.UInt32, total: mi.Color3f) -> tuple[mi.UInt32, mi.Color3f]:
        within = (mi.Point2f(mi.Float(k % PLACES), mi.Float(k // PLACES)) + 0.5) / PLACES
        _, direction = camera.ray(column, row, within)
        return k + 1, total + sky.along(direction, mi.Bool(True))

    _, total = dr.while_loop(
        (mi.UInt32(0), mi.Color3f(0.0)), lambda k, _: k < PLACES**2, one_more, label="places behind a pixel"
    )
    return np.asarray((np.array(total).T / PLACES**2).reshape(size[1], size[0], 3), np.float32)
