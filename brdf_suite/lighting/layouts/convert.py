"""Conversion of any layout to a latitude-longitude map."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.lighting.layouts import cube_faces, round_images
from brdf_suite.lighting.layouts.detect import check_shape, face_size
from brdf_suite.lighting.layouts.names import Layout
from brdf_suite.progress import Progress, report

_MIN_HEIGHT = 8
_MAX_HEIGHT = 4096
# Samples along a side of a texel, and rows done at a time: about 30 MB of directions for a 4k map.
_SAMPLES = 2
_STRIP = 32


def as_latlong(
    pixels: NDArray[np.float32], layout: Layout, progress: Progress | None = None
) -> NDArray[np.float32]:
    """Return a latitude-longitude map (H, 2H, 3) float32 of an image (h, w, 3) in another layout.

    H is two faces of a cube, the diameter of a probe, or two diameters of a dome (whose picture is half the
    sphere), so that nothing of the image is lost; at most 4,096. Each texel is the mean of four bilinear samples.
    A latitude-longitude map is returned as it is.

    >>> as_latlong(np.ones((96, 128, 3), np.float32), "horizontal_cross").shape
    (64, 128, 3)

    Raises
    ------
    ValueRangeError
        The image cannot have this layout; the message says what it should look like.
    """
    rows, columns = pixels.shape[:2]
    check_shape(layout, columns, rows)
    if layout == "latlong":
        return pixels
    if layout in ("angular", "mirror_ball", "dome"):
        natural = 2 * rows if layout == "dome" else rows
        faces = None
    else:
        natural = 2 * face_size(layout, columns)
        faces = cube_faces.cut_faces(pixels, layout)
    height = int(np.clip(natural, _MIN_HEIGHT, _MAX_HEIGHT))
    theta, phi = ring_angles(height * _SAMPLES), column_angles(2 * height * _SAMPLES)
    result = np.empty((height, 2 * height, 3), np.float32)
    for first in range(0, height, _STRIP):
        report(progress, first / height, "laying the environment out")
        last = min(first + _STRIP, height)
        towards = direction(theta[first * _SAMPLES : last * _SAMPLES, None], phi[None, :])
        flat = towards.reshape(-1, 3)
        along = (
            round_images.look_up(pixels, flat, layout) if faces is None else cube_faces.look_up(faces, flat)
        )
        cells = along.reshape(last - first, _SAMPLES, 2 * height, _SAMPLES, 3)
        result[first:last] = cells.mean(axis=(1, 3))
    return result
