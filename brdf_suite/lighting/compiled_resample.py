"""An environment's own pixels as a cube map, compiled: a bilinear look-up for each texel.

Imported by :mod:`.compiled` alone. The cube's symmetry saves nearly all of the arc tangents: sixteen texels have their
longitudes and latitudes in common, up to quarter turns and mirrors.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.lighting.compiled_decorator import Array, compiled

# The faces whose centres lie at φ = 0, 90°, 180° and 270°: +Z, -X, -Z, +X.
_SIDES = (4, 1, 5, 0)


@compiled
def _look_up(pixels: Array, theta: float, phi: float, target: Array) -> None:
    """Set target (3) to the map (h, w, 3) at θ 0…π and φ (-π…2π), over the seam and the poles."""
    height, width = pixels.shape[0], pixels.shape[1]
    row = theta * height / math.pi - 0.5
    column = (phi + math.pi) * width / (2.0 * math.pi) - 0.5
    above = math.floor(row)
    left = math.floor(column)
    down = np.float32(row - above)
    right = np.float32(column - left)
    row_0, row_1 = int(above), int(above) + 1
    a = int(left)
    if a < 0:
        a += width
    elif a >= width:
        a -= width
    b = a + 1 if a + 1 < width else 0
    d, e = a, b
    if row_0 < 0:
        row_0 = 0
        a, b = (a + width // 2) % width, (b + width // 2) % width
    if row_1 > height - 1:
        row_1 = height - 1
        d, e = (d + width // 2) % width, (e + width // 2) % width
    one = np.float32(1.0)
    for c in range(3):
        top = pixels[row_0, a, c] * (one - right) + pixels[row_0, b, c] * right
        bottom = pixels[row_1, d, c] * (one - right) + pixels[row_1, e, c] * right
        target[c] = top * (one - down) + bottom * down


@compiled
def resample_rows(pixels: Array, first: int, end: int, faces: Array) -> None:
    """Fill rows ``first`` … ``end - 1`` ≤ F/2 of all faces (6, F, F, 3), and their mirror images from below.

    Both are float32, F is even; the same look-up as :func:`.latlong.sample`.
    """
    size = faces.shape[1]
    half = size // 2
    longitudes = np.empty(half)
    latitudes = np.empty(half)
    for j in range(first, end):
        t = 1.0 - (2.0 * j + 1.0) / size
        for i in range(half):
            s = (2.0 * i + 1.0) / size
            longitudes[i] = math.atan(s)
            latitudes[i] = math.atan(t / math.sqrt(1.0 + s * s))
        for turn in range(4):
            face = faces[_SIDES[turn]]
            centre = turn * 0.5 * math.pi
            if turn > 1:
                centre -= 2.0 * math.pi  # the map runs from φ = -π to π
            for i in range(size):
                inner = half - 1 - i if i < half else i - half
                # φ = φ_f - atan(s): columns right of the middle lie at smaller φ.
                phi = centre + (longitudes[inner] if i < half else -longitudes[inner])
                _look_up(pixels, 0.5 * math.pi - latitudes[inner], phi, face[j, i])
                _look_up(pixels, 0.5 * math.pi + latitudes[inner], phi, face[size - 1 - j, i])
        for i in range(half):
            s = (2.0 * i + 1.0) / size
            longitudes[i] = math.atan(s / t)  # from the nearest of φ = 0 and 180°
            latitudes[i] = math.atan(math.sqrt(s * s + t * t))  # from the pole
        for i in range(size):
            inner = half - 1 - i if i < half else i - half
            turned = longitudes[inner] if i < half else -longitudes[inner]
            # On +Y rows run from z = -1 (φ = 180°) to z = 1 (φ = 0); on -Y the other way.
            _look_up(pixels, latitudes[inner], -math.pi - turned, faces[2, j, i])
            _look_up(pixels, latitudes[inner], turned, faces[2, size - 1 - j, i])
            _look_up(pixels, math.pi - latitudes[inner], turned, faces[3, j, i])
            _look_up(pixels, math.pi - latitudes[inner], -math.pi - turned, faces[3, size - 1 - j, i])
