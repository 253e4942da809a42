"""A curved panel, 0.6 × 0.4 m: a piece of door skin with a soft feature line and a flange all around.

Built flat as a rounded rectangle and then folded and bulged. Along the outline, over a given length of surface,
the skin turns by 90° with a curvature that rises and falls smoothly, and ends in a short flange. The bulge adds
a height over the flat place, so that normals follow in closed form.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.surface.mesh import Mesh, PartGeometry
from meshes.forms.grid import grid_triangles, smooth_step, with_area

# Millimetres.
_HALF_WIDTH, _HALF_HEIGHT = 300.0, 200.0
_CORNER = 45.0
_FLAT, _FOLD, _FLANGE = 33.0, 20.0, 14.0
_BEND_X, _BEND_Y = 2400.0, 800.0
_LINE_Y, _LINE_SLOPE, _LINE_RADIUS = 45.0, 0.075, 9.0
_LEAN_DEG = 22.0
_THICKNESS = 0.8
_CELL = 4.0


def _profile(length: Floats) -> tuple[Floats, Floats, Floats]:
    """Return distance outwards, depth and turn (radians) ``length`` along the skin from a corner's centre."""
    fine = np.linspace(0.0, _FLAT + _FOLD + _FLANGE, 6001)
    turn = 0.5 * np.pi * smooth_step(fine, _FLAT, _FLAT + _FOLD)
    middle = 0.5 * (turn[1:] + turn[:-1])
    step = fine[1] - fine[0]
    out = np.concatenate([[0.0], np.cumsum(np.cos(middle)) * step])
    depth = np.concatenate([[0.0], np.cumsum(np.sin(middle)) * step])
    return np.interp(length, fine, out), np.interp(length, fine, depth), np.interp(length, fine, turn)


def _bulge(x: Floats, y: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the height over the flat panel and its slopes along x and y."""
    from_line = y - _LINE_Y
    rounded = np.sqrt(from_line**2 + _LINE_RADIUS**2)
    height = -(x**2) / (2.0 * _BEND_X) - y**2 / (2.0 * _BEND_Y) - _LINE_SLOPE * rounded
    return height, -x / _BEND_X, -y / _BEND_Y - _LINE_SLOPE * from_line / rounded


def _bent(centre: Floats, direction: Floats, length: Floats) -> tuple[Floats, Floats, Floats]:
    """Return points, normals and texture coordinates of flat places.

    ``centre`` (..., 2) a place in the inner rectangle, ``direction`` (..., 2) outwards from it (unit, or zero
    inside), ``length`` (...) along the skin in that direction.
    """
    out, depth, turn = _profile(length)
    flat = centre + direction * out[..., None]
    height, slope_x, slope_y = _bulge(flat[..., 0], flat[..., 1])
    points = np.stack([flat[..., 0], flat[..., 1], height - depth], axis=-1)
    facing = np.cos(turn)
    sideways = direction * np.sin(turn)[..., None]
    slopes = np.stack([slope_x, slope_y], axis=-1)
    normals = np.concatenate([sideways - slopes * facing[..., None], facing[..., None]], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return points, normals, centre + direction * length[..., None]


def panel() -> Mesh:
    """Return the panel, facing +z and leaning back by 22°, standing on y = 0: painted skin and plain back."""
    across, up = _HALF_WIDTH - _CORNER, _HALF_HEIGHT - _CORNER
    xs = np.linspace(-across, across, round(across / _CELL) + 1)
    # Rows crowd around the feature line, whose radius is small.
    ys = np.union1d(np.linspace(-up, up, round(2 * up / _CELL) + 1), _LINE_Y + np.linspace(-24.0, 24.0, 33))
    lengths = np.concatenate(
        [np.linspace(0.0, _FLAT, 9)[:-1], np.linspace(_FLAT, _FLAT + _FOLD, 17), [_FLAT + _FOLD + _FLANGE]]
    )
    arc = np.linspace(0.0, 0.5 * np.pi, 25)
    zero, one = np.zeros((1, 1)), np.ones((1, 1))
    patches = [_patch(xs[:, None], ys[None, :], zero, zero, zero)]
    # The outline counter-clockwise: right side, upper right corner, and so on.
    for place_x, place_y, normal_x, normal_y in (
        (across * one, ys[:, None], one, zero),
        (xs[::-1, None], up * one, zero, one),
        (-across * one, ys[::-1, None], -one, zero),
        (xs[:, None], -up * one, zero, -one),
    ):
        patches.append(_patch(place_x, place_y, normal_x, normal_y, lengths[None, :], flip=True))
    for sign_x, sign_y, start in ((1, 1, 0.0), (-1, 1, 0.5), (-1, -1, 1.0), (1, -1, 1.5)):
        angle = arc[:, None] + start * np.pi
        place_x, place_y = sign_x * across * one, sign_y * up * one
        patches.append(_patch(place_x, place_y, np.cos(angle), np.sin(angle), lengths[None, :], flip=True))
    points, normals, uvs = (np.concatenate([patch[k] for patch in patches]) for k in range(3))
    offsets = np.cumsum([0] + [len(patch[0]) for patch in patches[:-1]])
    triangles = np.concatenate([patch[3] + start for patch, start in zip(patches, offsets, strict=True)])
    lean = np.radians(_LEAN_DEG)
    turned = np.array([[1, 0, 0], [0, np.cos(lean), np.sin(lean)], [0, -np.sin(lean), np.cos(lean)]])
    points, normals = points @ turned.T, normals @ turned.T
    points[:, 1] -= points[:, 1].min()
    triangles = with_area(points, triangles)
    skin = PartGeometry("skin", "paint", points / 1000.0, normals, uvs, triangles)
    behind = (points - _THICKNESS * normals) / 1000.0
    back = PartGeometry("back", "trim", behind, -normals, uvs, triangles[:, ::-1])
    return Mesh("panel", (skin, back))


def _patch(
    x: Floats, y: Floats, normal_x: Floats, normal_y: Floats, length: Floats, flip: bool = False
) -> tuple[Floats, Floats, Floats, NDArray[np.int64]]:
    """Return points, normals, uvs and triangles of one grid; the arguments broadcast to (rows, columns)."""
    x, y, normal_x, normal_y, length = np.broadcast_arrays(x, y, normal_x, normal_y, length)
    parts = _bent(np.stack([x, y], axis=-1), np.stack([normal_x, normal_y], axis=-1), length)
    triangles = grid_triangles(*x.shape)
    if flip:
        triangles = triangles[:, ::-1]
    points, normals, uvs = (part.reshape(-1, part.shape[-1]) for part in parts)
    return points, normals, uvs, triangles
