"""The camera as matrices, and its movements as pure functions of :class:`documents.view.Camera`.

World axes are right-handed with y up. At azimuth 0 the camera is on the +z side and looks along -z; azimuth
grows counter-clockwise seen from above, elevation upwards. Matrices are float64 for column vectors.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import SENSOR_WIDTH_MM, Camera

Floats = NDArray[np.float64]

MARGIN = 1.08
"""A framed object leaves 8 % of free space around it."""

HIGHEST_ELEVATION_DEG = 89.0
"""Orbiting stops short of the pole, where "up" has no meaning."""


@dataclass(frozen=True)
class Bounds:
    """An axis-aligned box in metres."""

    minimum: tuple[float, float, float]
    maximum: tuple[float, float, float]

    @staticmethod
    def of(points: Iterable[NDArray[np.float32]]) -> Bounds:
        """Return the box around all points, arrays (n, 3); a unit box where there are none."""
        boxes = [(p.min(axis=0), p.max(axis=0)) for p in points if len(p)]
        if not boxes:
            return Bounds((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5))
        low = np.min([b[0] for b in boxes], axis=0)
        high = np.max([b[1] for b in boxes], axis=0)
        return Bounds(_triple(low), _triple(high))

    @property
    def centre(self) -> tuple[float, float, float]:
        """The middle of the box."""
        (a, b, c), (d, e, f) = self.minimum, self.maximum
        return ((a + d) / 2, (b + e) / 2, (c + f) / 2)

    @property
    def radius(self) -> float:
        """Half the diagonal, at least a tenth of a millimetre."""
        return max(float(np.linalg.norm(np.subtract(self.maximum, self.minimum))) / 2, 1e-4)

    @property
    def corners(self) -> Floats:
        """(8, 3)."""
        low, high = self.minimum, self.maximum
        return np.array([[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)])


@dataclass(frozen=True, eq=False)
class CameraMatrices:
    """What a frame needs of a camera.

    ``view_to_world`` (3, 3) has the camera's right, up and backward axes as columns; ``half_tangents`` are
    those of half the horizontal and vertical field of view; ``near`` and ``far`` (m) enclose the bounds.
    """

    eye: Floats
    view_to_world: Floats
    world_to_view: Floats
    view_to_clip: Floats
    half_tangents: tuple[float, float]
    near: float
    far: float

    @property
    def world_to_clip(self) -> Floats:
        """(4, 4), float64."""
        return np.asarray(self.view_to_clip @ self.world_to_view)


def axes(camera: Camera) -> Floats:
    """Return (3, 3): right, up and backward (from the target to the eye) of the camera as columns."""
    a, e = np.radians(camera.azimuth_deg), np.radians(camera.elevation_deg)
    right = np.array([np.cos(a), 0.0, -np.sin(a)])
    back = np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])
    return np.stack([right, np.cross(back, right), back], axis=1)


def half_tangents(camera: Camera, size: tuple[int, int]) -> tuple[float, float]:
    """Return the tangents of half the horizontal and half the vertical field of view; ``size`` = (w, h)."""
    horizontal = SENSOR_WIDTH_MM / 2 / camera.focal_length_mm
    return horizontal, horizontal * size[1] / size[0]


def resolve(camera: Camera, bounds: Bounds, size: tuple[int, int]) -> Camera:
    """Return the camera with distance and target filled in, such that the whole box is in the picture.

    A moving camera should be resolved once, at the start of the movement: then it keeps its distance while it
    turns, instead of framing the object anew from each side.
    """
    target = bounds.centre if camera.target is None else camera.target
    if camera.distance is not None:
        return replace(camera, target=target)
    local = (bounds.corners - np.asarray(target)) @ axes(camera)
    tangents = np.array(half_tangents(camera, size)) / MARGIN
    # A corner at (x, y, z) is inside where |x| <= tan (d - z), and the same for y.
    needed = local[:, 2:] + np.abs(local[:, :2]) / tangents
    distance = max(float(needed.max()), float(local[:, 2].max()) + 0.02 * bounds.radius, 2e-4)
    return replace(camera, target=target, distance=distance)


def matrices(camera: Camera, bounds: Bounds, size: tuple[int, int]) -> CameraMatrices:
    """Return the matrices of ``camera`` for ``size`` (width, height) pixels around ``bounds``."""
    camera = resolve(camera, bounds, size)
    if camera.distance is None or camera.target is None:
        raise AssertionError("resolve() fills distance and target")
    basis = axes(camera)
    eye = np.asarray(camera.target) + basis[:, 2] * camera.distance
    world_to_view = np.eye(4)
    world_to_view[:3, :3] = basis.T
    world_to_view[:3, 3] = -basis.T @ eye

    depth = (eye - bounds.corners) @ basis[:, 2]
    far = max(float(depth.max()) * 1.01, bounds.radius * 1e-2, 2e-4)
    # Depth keeps its resolution by never starting closer than 1/5000 of the far plane (24 bits).
    near = min(max(float(depth.min()) * 0.99, far / 5000.0), far / 1.02)
    tangents = half_tangents(camera, size)
    clip = np.zeros((4, 4))
    clip[0, 0], clip[1, 1] = 1 / tangents[0], 1 / tangents[1]
    clip[2, 2], clip[2, 3] = -(far + near) / (far - near), -2 * far * near / (far - near)
    clip[3, 2] = -1
    return CameraMatrices(eye, basis, world_to_view, clip, tangents, near, far)


def crop(size: tuple[int, int], corner: tuple[int, int], tile: tuple[int, int]) -> Floats:
    """Return (4, 4) that spreads one tile of a picture over the whole clip space.

    ``corner`` is the tile's lower left pixel in a picture of ``size``, counted from the lower left.
    """
    matrix = np.eye(4)
    for axis in range(2):
        scale = size[axis] / tile[axis]
        matrix[axis, axis] = scale
        matrix[axis, 3] = scale - 1 - 2 * corner[axis] / tile[axis]
    return matrix


def orbit(camera: Camera, azimuth_deg: float, elevation_deg: float) -> Camera:
    """Return the camera turned about its target by these angles; elevation stops at ±89°."""
    limit = HIGHEST_ELEVATION_DEG
    return replace(
        camera,
        azimuth_deg=(camera.azimuth_deg + azimuth_deg) % 360.0,
        elevation_deg=float(np.clip(camera.elevation_deg + elevation_deg, -limit, limit)),
    )


def pan(camera: Camera, bounds: Bounds, size: tuple[int, int], right_px: float, down_px: float) -> Camera:
    """Return the camera moved sideways such that the target follows the cursor by so many pixels."""
    camera = resolve(camera, bounds, size)
    if camera.distance is None or camera.target is None:
        raise AssertionError("resolve() fills distance and target")
    metres_per_pixel = 2 * half_tangents(camera, size)[0] * camera.distance / size[0]
    basis = axes(camera)
    target = np.asarray(camera.target) + metres_per_pixel * (-right_px * basis[:, 0] + down_px * basis[:, 1])
    return replace(camera, target=_triple(target))


def dolly(camera: Camera, bounds: Bounds, size: tuple[int, int], factor: float) -> Camera:
    """Return the camera at ``factor`` times its distance, kept between 1/50 and 50 radii of the object."""
    camera = resolve(camera, bounds, size)
    if camera.distance is None:
        raise AssertionError("resolve() fills distance")
    low, high = bounds.radius / 50, bounds.radius * 50 * max(1.0, camera.focal_length_mm / 50)
    return replace(camera, distance=float(np.clip(camera.distance * factor, low, high)))


def frame(camera: Camera) -> Camera:
    """Return the camera that looks from the same side at the whole object."""
    return replace(camera, distance=None, target=None)


def _triple(point: NDArray[Any]) -> tuple[float, float, float]:
    x, y, z = (float(c) for c in point)
    return x, y, z
