"""Environment images that are a disc: light probes, mirror balls, domes.

For a direction d of unit length, the place in the disc of radius 1 (to the right, up):

- angular map (light probe): r = acos(d_z)/π along (d_x, d_y); P. Debevec, "Rendering Synthetic Objects into
  Real Scenes", SIGGRAPH 1998, and the page of his light probe gallery. It is what a mirror ball shows, evened
  out, so it is seen from outside as that is: +x is right.
- mirror ball, orthographic, the camera at +z: the place is the ball's normal there, halfway between d and +z.
- dome: r = acos(d_y)/(π/2) about the zenith, the front (+z) below, -x at the right: a fisheye picture taken
  upwards. What is below the horizon is black.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.layouts.names import Layout

_TINY = 1e-12


def look_up(
    pixels: NDArray[np.float32], directions: NDArray[np.float64], layout: Layout
) -> NDArray[np.float32]:
    """Return radiance (n, 3) of a square image (h, h, 3) along unit directions (n, 3), bilinear."""
    right, up = {"angular": _angular, "mirror_ball": _mirror_ball, "dome": _dome}[layout](directions)
    size = pixels.shape[0]
    # The rim of a disc is cut by the corners of the square: places outside are held at the rim's texels.
    column = np.clip((right + 1.0) * (0.5 * size) - 0.5, 0.0, size - 1.0)
    row = np.clip((1.0 - up) * (0.5 * size) - 0.5, 0.0, size - 1.0)
    i = np.minimum(column.astype(np.int64), size - 2)
    j = np.minimum(row.astype(np.int64), size - 2)
    fi = (column - i).astype(np.float32)[:, None]
    fj = (row - j).astype(np.float32)[:, None]
    top = pixels[j, i] * (1.0 - fi) + pixels[j, i + 1] * fi
    bottom = pixels[j + 1, i] * (1.0 - fi) + pixels[j + 1, i + 1] * fi
    result: NDArray[np.float32] = top * (1.0 - fj) + bottom * fj
    if layout == "dome":
        result[directions[:, 1] < 0.0] = 0.0
    return result


def _angular(d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    across = np.hypot(d[:, 0], d[:, 1])
    # arctan2 keeps what arccos loses near the front and the back.
    scale = np.arctan2(across, d[:, 2]) / np.pi / np.maximum(across, _TINY)
    return _inside(d[:, 0] * scale, d[:, 1] * scale, np.arctan2(across, d[:, 2]) / np.pi)


def _mirror_ball(d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    # |d + z| = √(2 + 2 d_z); straight behind the ball every point of the rim shows the same.
    length = np.sqrt(np.maximum(2.0 + 2.0 * d[:, 2], _TINY))
    right, up = d[:, 0] / length, d[:, 1] / length
    return _inside(right, up, np.hypot(right, up))


def _dome(d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    across = np.hypot(d[:, 0], d[:, 2])
    radius = np.arctan2(across, d[:, 1]) / (0.5 * np.pi)
    scale = radius / np.maximum(across, _TINY)
    return _inside(-d[:, 0] * scale, -d[:, 2] * scale, radius)


def _inside(
    right: NDArray[np.float64], up: NDArray[np.float64], radius: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return places no farther than the rim."""
    shrink = 1.0 / np.maximum(radius, 1.0)
    return right * shrink, up * shrink
