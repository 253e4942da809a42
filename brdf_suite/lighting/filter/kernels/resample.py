"""Compiled resampling of an environment's own pixels to a cube map by bilinear look-up.

Imported by :mod:`brdf_suite.lighting.filter.kernels.compilation` alone. The cube's symmetry saves nearly all of the
arc tangents: sixteen texels have their longitudes and latitudes in common, up to quarter turns and mirrors.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.compilation import Array, compiled

# The faces whose centres lie at φ = 0, 90°, 180° and 270°: +Z, -X, -Z, +X.
_SIDES = (4, 1, 5, 0)


@compiled
def _look_up(pixels: Array, theta: float, phi: float, target: Array, at: int) -> None:
    """Set target[at : at + 3] to the map (h, w, 3) at θ 0…π and φ (-2π…2π), over the seam and the poles."""
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
    turn = width - width // 2  # beyond the pole lies the same ring, half a turn further
    if row_0 < 0:
        row_0 = 0
        a, b = (a + turn) % width, (b + turn) % width
    if row_1 > height - 1:
        row_1 = height - 1
        d, e = (d + turn) % width, (e + turn) % width
    one = np.float32(1.0)
    for c in range(3):
        top = pixels[row_0, a, c] * (one - right) + pixels[row_0, b, c] * right
        bottom = pixels[row_1, d, c] * (one - right) + pixels[row_1, e, c] * right
        target[at + c] = top * (one - down) + bottom * down


@compiled
def resample_rows(pixels: Array, first: int, end: int, faces: Array) -> None:
    """Fill rows ``first`` … ``end - 1`` ≤ F/2 of all faces (6, F, F, 3), and their mirror images from below.

    Both are float32, F is even; the same look-up as :func:`brdf_suite.lighting.latlong.sample`.
    """
    size = faces.shape[1]
    half = size // 2
    flat = faces.reshape(faces.size)  # to cut a texel out of the faces takes longer than to fill it
    longitudes = np.empty(half)
    latitudes = np.empty(half)
    for j in range(first, end):
        t = 1.0 - (2.0 * j + 1.0) / size
        for i in range(half):
            s = (2.0 * i + 1.0) / size
            longitudes[i] = math.atan(s)
            latitudes[i] = math.atan(t / math.sqrt(1.0 + s * s))
        for turn in range(4):
            upper = 3 * size * (size * _SIDES[turn] + j)
            lower = 3 * size * (size * _SIDES[turn] + size - 1 - j)
            centre = turn * 0.5 * math.pi
            if turn > 1:
                centre -= 2.0 * math.pi  # the map runs from φ = -π to π
            for i in range(size):
                inner = half - 1 - i if i < half else i - half
                # φ = φ_f - atan(s): columns right of the middle lie at smaller φ.
                phi = centre + (longitudes[inner] if i < half else -longitudes[inner])
                _look_up(pixels, 0.5 * math.pi - latitudes[inner], phi, flat, upper + 3 * i)
                _look_up(pixels, 0.5 * math.pi + latitudes[inner], phi, flat, lower + 3 * i)
        for i in range(half):
            s = (2.0 * i + 1.0) / size
            longitudes[i] = math.atan(s / t)  # from the nearest of φ = 0 and 180°
            latitudes[i] = math.atan(math.sqrt(s * s + t * t))  # from the pole
        upper = 3 * size * (2 * size + j)
        lower = 3 * size * (3 * size - 1 - j)
        face = 3 * size * size
        for i in range(size):
            inner = half - 1 - i if i < half else i - half
            turned = longitudes[inner] if i < half else -longitudes[inner]
            # On +Y rows run from z = -1 (φ = 180°) to z = 1 (φ = 0); on -Y the other way.
            _look_up(pixels, latitudes[inner], -math.pi - turned, flat, upper + 3 * i)
            _look_up(pixels, latitudes[inner], turned, flat, lower + 3 * i)
            _look_up(pixels, math.pi - latitudes[inner], turned, flat, face + upper + 3 * i)
            _look_up(pixels, math.pi - latitudes[inner], -math.pi - turned, flat, face + lower + 3 * i)
