"""Camera matrices, and camera movements as pure functions of :class:`documents.view.Camera`.

World axes are right-handed with y up. At azimuth 0 the camera is on the +z side and looks along -z; azimuth
grows counter-clockwise seen from above, elevation upwards. Matrices are float64 for column vectors.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.view import SENSOR_WIDTH_MM, Camera

MARGIN = 1.18
"""A framed object leaves this much space around it: its size times 1.18 fills the picture."""

_CENTRING_STEPS = 6
"""Each leaves a few percent of the shift that the step before left."""

HIGHEST_ELEVATION_DEG = 89.0
"""Orbiting stops short of the pole, where "up" has no meaning."""


OUTLINE_DIRECTIONS = 160
"""In how many directions the farthest point of an object is known; between them at most 1 % is missed."""


@dataclass(frozen=True)
class Bounds:
    """An axis-aligned box in metres; ``outline`` (n, 3) holds the extreme points of its content.

    A rounded object fills its box badly: framed by its own outline it fills the picture.
    """

    minimum: tuple[float, float, float]
    maximum: tuple[float, float, float]
    outline: Floats | None = field(default=None, compare=False, repr=False)

    @staticmethod
    def of(points: Iterable[NDArray[np.float32]]) -> Bounds:
        """Return the bounds of all points, arrays (n, 3); a unit box where there are none."""
        found = [_farthest(p) for p in points if len(p)]
        if not found:
            return Bounds((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5))
        outline = _farthest(np.concatenate(found))
        # The axes are among the directions, so the outline has the box's own extremes.
        return Bounds(triple(outline.min(axis=0)), triple(outline.max(axis=0)), outline)

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
    def frame_points(self) -> Floats:
        """(n, 3): the points that must be in a picture of the whole; the corners where no outline is known."""
        return self.corners if self.outline is None else self.outline

    @property
    def corners(self) -> Floats:
        """(8, 3)."""
        low, high = self.minimum, self.maximum
        return np.array([[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)])


@dataclass(frozen=True, eq=False)
class CameraMatrices:
    """Camera matrices of a frame.

    ``view_to_world`` (3, 3) has the camera's right, up and backward axes as columns; ``half_tangents`` are
    those of half the horizontal and vertical field of view; ``near`` and ``far`` (m) enclose the bounds, but for
    what of them is not ``outside``: behind the eye, or too close to it to be drawn. ``shift`` is the tangent, to the
    right and up, by which the picture's middle lies aside of the axis, that of an eye beside the middle of a lens.
    """

    eye: Floats
    view_to_world: Floats
    world_to_view: Floats
    view_to_clip: Floats
    half_tangents: tuple[float, float]
    near: float
    far: float
    outside: bool
    shift: tuple[float, float] = (0.0, 0.0)

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
    """Return the camera with distance and target filled in, such that the whole object is in the picture.

    A moving camera should be resolved once, at the start of the movement: then it keeps its distance while it
    turns, instead of framing the object anew from each side.
    """
    target = bounds.centre if camera.target is None else camera.target
    if camera.distance is not None:
        return replace(camera, target=target)
    local = (bounds.frame_points - np.asarray(target)) @ axes(camera)
    distance = _fitting_distance(local, half_tangents(camera, size), bounds.radius)
    return replace(camera, target=target, distance=distance)


def compose(camera: Camera, bounds: Bounds, size: tuple[int, int]) -> Camera:
    """Return the camera with the whole object in the middle of a still picture, and as large as it gets.

    Perspective draws the near side larger, so an object whose middle is the target stands off the middle of the
    picture; here the target moves sideways until it does not. A camera that then turns would swing the object,
    so one that moves is resolved instead. A camera with a target or a distance of its own is left as it is.
    """
    if camera.target is not None or camera.distance is not None:
        return resolve(camera, bounds, size)
    basis, tangents = axes(camera), half_tangents(camera, size)
    local = (bounds.frame_points - np.asarray(bounds.centre)) @ basis
    shift = np.zeros(3)
    for _ in range(_CENTRING_STEPS):
        moved = local - shift
        distance = _fitting_distance(moved, tangents, bounds.radius)
        picture = moved[:, :2] / (distance - moved[:, 2:])
        shift[:2] += 0.5 * (picture.max(axis=0) + picture.min(axis=0)) * distance
    distance = _fitting_distance(local - shift, tangents, bounds.radius)
    return replace(camera, target=triple(np.asarray(bounds.centre) + basis @ shift), distance=distance)


def _fitting_distance(local: Floats, tangents: tuple[float, float], radius: float) -> float:
    """Return the distance from which all points, relative to the target in camera axes, are in the picture."""
    # A point at (x, y, z) is inside where |x| <= tan (d - z), and the same for y.
    needed = local[:, 2:] + np.abs(local[:, :2]) * (MARGIN / np.array(tangents))
    return max(float(needed.max()), float(local[:, 2].max()) + 0.02 * radius, 2e-4)


@dataclass(frozen=True)
class LensPoint:
    """A place of a lens's opening, metres to the right and up of its middle, and the distance of the sharp plane, m."""

    right: float
    up: float
    focus: float


MIDDLE = LensPoint(0.0, 0.0, 1.0)
"""All of a pinhole."""


def matrices(
    camera: Camera, bounds: Bounds, size: tuple[int, int], lens: LensPoint = MIDDLE
) -> CameraMatrices:
    """Return the matrices of ``camera`` for ``size`` (width, height) pixels around ``bounds``.

    They are those of an eye at a place of the ``lens``, for which the sharp plane stands still.
    """
    camera = resolve(camera, bounds, size)
    if camera.distance is None or camera.target is None:
        raise AssertionError("resolve() fills distance and target")
    basis = axes(camera)
    eye = np.asarray(camera.target) + basis @ [lens.right, lens.up, camera.distance]
    shift = (-lens.right / lens.focus, -lens.up / lens.focus)
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
    clip[0, 2], clip[1, 2] = shift[0] / tangents[0], shift[1] / tangents[1]
    outside = near <= float(depth.min())
    return CameraMatrices(eye, basis, world_to_view, clip, tangents, near, far, outside, shift)


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
    return replace(camera, target=triple(target))


def dolly(camera: Camera, bounds: Bounds, size: tuple[int, int], factor: float) -> Camera:
    """Return the camera at ``factor`` times its distance, kept between 1/50 and 50 radii of the object."""
    camera = resolve(camera, bounds, size)
    if camera.distance is None:
        raise AssertionError("resolve() fills distance")
    low, high = bounds.radius / 50, bounds.radius * 50 * max(1.0, camera.focal_length_mm / 50)
    return replace(camera, distance=float(np.clip(camera.distance * factor, low, high)))


def dolly_to(
    camera: Camera, bounds: Bounds, size: tuple[int, int], factor: float, place: tuple[float, float]
) -> Camera:
    """Return the camera at ``factor`` times its distance, with what is at ``place`` kept there.

    ``place`` is (right, up) from the middle of the picture, as fractions of its height. The point that stays is the
    one at the target's depth, so going in and out by the same factor ends where it began.
    """
    start = resolve(camera, bounds, size)
    nearer = dolly(start, bounds, size, factor)
    if start.distance is None or start.target is None or nearer.distance is None:
        raise AssertionError("resolve() fills distance and target")
    # A fraction of the height is this long at the target.
    shrunk = 2 * half_tangents(camera, size)[1] * (start.distance - nearer.distance)
    basis = axes(camera)
    target = np.asarray(start.target) + shrunk * (place[0] * basis[:, 0] + place[1] * basis[:, 1])
    return replace(nearer, target=triple(target))


def frame(camera: Camera) -> Camera:
    """Return the camera that looks from the same side at the whole object."""
    return replace(camera, distance=None, target=None)


def _farthest(points: NDArray[Any]) -> Floats:
    """Return the points (n, 3) that lie farthest along the axes and along evenly spread directions."""
    # A Fibonacci lattice: equal steps in height, golden-angle steps around.
    k = np.arange(OUTLINE_DIRECTIONS) + 0.5
    height, turn = 1.0 - 2.0 * k / OUTLINE_DIRECTIONS, np.pi * (1.0 + 5.0**0.5) * k
    radius = np.sqrt(1.0 - height**2)
    spread = np.stack([radius * np.cos(turn), height, radius * np.sin(turn)], axis=1)
    directions = np.concatenate([np.eye(3), -np.eye(3), spread])
    farthest = [int(np.argmax(points @ direction.astype(points.dtype))) for direction in directions]
    return np.asarray(points[farthest], np.float64)
