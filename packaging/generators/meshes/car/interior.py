"""What is seen through the windows: lining, floor, dashboard, seats and steering wheel, all in dark trim."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from meshes.car.blends import Field, rounded_max, smooth_max, smooth_min
from meshes.car.body import FLOOR, body
from meshes.car.cutting import PointFunction, at_points, cut, offset
from meshes.car.lathe import grid_triangles, loft
from meshes.car.nets import Soup, extract, normals, project
from meshes.car.outlines import arch, rear_screen, side_window, windscreen
from meshes.car.pieces import Piece

LINING_DEPTH = 0.030
"""How far below the skin the lining lies: as deep as the reveals of the windows."""
_FRONT, _REAR, _LOW = 0.86, -2.0, 0.235
_WINDOW_EDGE = 0.010
_WHEEL = np.array([0.37, 0.835, 0.34])
_TILT = 0.42
"""Of the steering wheel's axis above the horizontal, rad."""


def interior() -> list[Piece]:
    """Return the interior of the half x ≥ 0; the steering wheel is apart, since there is one."""
    pieces = [_lining(), _floor()]
    for name, field, step, box in (
        ("dashboard", _dashboard, 0.065, ((0.0, 0.95), (0.60, 0.98), (0.36, 0.98))),
        ("console", _console, 0.07, ((0.0, 0.25), (0.20, 0.62), (-0.45, 0.60))),
        ("seats", _front_seat, 0.05, ((0.05, 0.70), (0.22, 1.20), (-0.80, 0.30))),
        ("rear_seats", _rear_seat, 0.068, ((0.0, 0.62), (0.22, 1.02), (-1.35, -0.45))),
        ("parcel_shelf", _shelf, 0.08, ((0.0, 0.80), (0.70, 1.00), (-1.85, -1.05))),
    ):
        pieces.append(_solid(name, field, step, box))
    return pieces


def _solid(name: str, field: Field, step: float, box: tuple[tuple[float, float], ...]) -> Piece:
    """Return the surface of a field as a part of the half x ≥ 0."""
    (_, right), (low_y, high_y), (low_z, high_z) = box
    grid = [np.arange(low, high, step) for low, high in ((-step, right), (low_y, high_y), (low_z, high_z))]
    soup = extract(field, *grid)
    soup = Soup(project(field, soup.points), soup.triangles)
    soup = _half(soup)
    return Piece(name, "trim", soup, normals(field, soup.points))


def _half(soup: Soup) -> Soup:
    soup = cut(soup, lambda p: p[:, 0].copy(), snap=True)
    soup.points[np.abs(soup.points[:, 0]) < 1e-5, 0] = 0.0
    return soup.keep(soup.points[soup.triangles].mean(axis=1)[:, 0] > 0.0)


def _inner(x: Floats, y: Floats, z: Floats) -> Floats:
    return body(x, y, z) + LINING_DEPTH


def _lining() -> Piece:
    """Return roof lining and side panels, open at the windows."""
    step = 0.085
    grid = [np.arange(a, b, step) for a, b in ((-step, 1.0), (0.18, 1.45), (_REAR - 0.1, _FRONT + 0.1))]
    soup = extract(_inner, *grid)
    soup = _half(Soup(project(_inner, soup.points), soup.triangles))
    keep: list[PointFunction] = [
        lambda p: p[:, 1] - _LOW,
        lambda p: _FRONT - p[:, 2],
        lambda p: p[:, 2] - _REAR,
        # Nothing is seen below the parcel shelf.
        lambda p: np.maximum(p[:, 1] - 0.72, p[:, 2] + 1.30),
        lambda p: at_points(arch)(p) - 0.02,
    ]
    keep += [offset(at_points(window), _WINDOW_EDGE) for window in (windscreen, rear_screen, side_window)]
    for function in keep:
        soup = cut(soup, function)
        soup = soup.keep(function(soup.points[soup.triangles].mean(axis=1)) > 0.0)
    soup = Soup(soup.points, soup.triangles[:, ::-1])
    return Piece("lining", "trim", soup, -normals(_inner, soup.points))


def _floor() -> Piece:
    """Return the carpet."""
    x, z = np.meshgrid(np.linspace(0.0, 0.95, 9), np.linspace(-1.25, _FRONT, 19), indexing="ij")
    points = np.stack([x, FLOOR(z) + 0.105, z], axis=2).reshape(-1, 3)
    soup = Soup(points, grid_triangles(x.shape[0], x.shape[1], False)[:, ::-1])
    for function in (lambda p: -at_points(_inner)(p), at_points(arch)):
        soup = cut(soup, function)
        soup = soup.keep(function(soup.points[soup.triangles].mean(axis=1)) > 0.0)
    facing = normals(lambda x, y, z: y - FLOOR(z) + 0.0 * x, soup.points)
    a, b, c = (soup.points[soup.triangles[:, k]] for k in range(3))
    turned = np.cross(b - a, c - a)
    if turned[:, 1].mean() < 0.0:
        soup = Soup(soup.points, soup.triangles[:, ::-1])
    return Piece("carpet", "trim", soup, facing)


def _block(
    x: Floats,
    y: Floats,
    z: Floats,
    middle: tuple[float, float, float],
    half: tuple[float, float, float],
    lean: float = 0.0,
    radius: float = 0.05,
) -> Floats:
    """Return the field of a rounded block whose top leans backwards by ``lean`` (rad)."""
    u, v, w = x - middle[0], y - middle[1], z - middle[2]
    up, along = v * np.cos(lean) - w * np.sin(lean), w * np.cos(lean) + v * np.sin(lean)
    soft = np.sqrt(u * u + 1e-6)
    return rounded_max(
        radius, soft - half[0], np.abs(up) - half[1] + 0.0 * u, np.abs(along) - half[2] + 0.0 * u
    )


def _front_seat(x: Floats, y: Floats, z: Floats) -> Floats:
    base = _block(x, y, z, (0.37, 0.37, -0.08), (0.245, 0.095, 0.27), -0.10)
    back = _block(x, y, z, (0.37, 0.70, -0.43), (0.235, 0.31, 0.065), 0.36)
    # Side bolsters: the middle of back and base lies deeper.
    hollow = np.exp(-(((x - 0.37) / 0.13) ** 2))
    seat = smooth_min(base + 0.018 * hollow, back + 0.018 * hollow, 0.05)
    head = _block(x, y, z, (0.37, 1.055, -0.565), (0.125, 0.080, 0.045), 0.25, 0.04)
    return smooth_min(seat, head, 0.04)


def _rear_seat(x: Floats, y: Floats, z: Floats) -> Floats:
    base = _block(x, y, z, (0.27, 0.40, -0.78), (0.255, 0.095, 0.22), -0.10)
    back = _block(x, y, z, (0.27, 0.70, -1.08), (0.255, 0.25, 0.06), 0.45)
    return smooth_min(base, back, 0.05)


def _dashboard(x: Floats, y: Floats, z: Floats) -> Floats:
    board = _block(x, y, z, (0.0, 0.79, 0.72), (1.2, 0.115, 0.24), 0.06, 0.06)
    binnacle = _block(x, y, z, (0.37, 0.87, 0.58), (0.19, 0.055, 0.13), 0.1, 0.05)
    return smooth_max(smooth_min(board, binnacle, 0.05), body(x, y, z) + 0.045, 0.02)


def _console(x: Floats, y: Floats, z: Floats) -> Floats:
    return _block(x, y, z, (0.0, 0.38, 0.08), (0.105, 0.13, 0.46), 0.0, 0.04)


def _shelf(x: Floats, y: Floats, z: Floats) -> Floats:
    shelf = _block(x, y, z, (0.0, 0.80, -1.46), (0.75, 0.045, 0.36), 0.0, 0.03)
    return smooth_max(shelf, body(x, y, z) + 0.045, 0.02)


def steering_wheel() -> list[Piece]:
    """Return rim, spokes, boss and column of the steering wheel, on the left."""
    turn = np.linspace(0.0, 2.0 * np.pi, 36, endpoint=False)
    section = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)
    radius = 0.178 + 0.0145 * np.cos(section)[None, :]
    rim = np.stack(
        np.broadcast_arrays(
            radius * np.cos(turn)[:, None], radius * np.sin(turn)[:, None], 0.0145 * np.sin(section)[None, :]
        ),
        axis=2,
    )
    parts = [loft(np.concatenate([rim, rim[:1]]), closed=True)]
    for angle in (0.0, np.pi, -0.5 * np.pi):
        out, aside = (
            np.array([np.cos(angle), np.sin(angle), 0.0]),
            np.array([-np.sin(angle), np.cos(angle), 0.0]),
        )
        ends = np.array([0.02, 0.175])[:, None, None] * out
        corners = np.array([(-0.02, -0.006), (0.02, -0.006), (0.02, 0.006), (-0.02, 0.006)])
        parts.append(loft(ends + corners[:, :1] * aside + corners[:, 1:] * np.array([0.0, 0.0, 1.0])))
    for near, far, across in ((0.022, -0.02, 0.058), (-0.02, -0.26, 0.032)):
        ring = np.stack([across * np.cos(section), across * np.sin(section), 0.0 * section], axis=1)
        axial = np.array([0.0, 0.0, 1.0])
        rows = [0.01 * ring + (near + 0.004) * axial, ring + near * axial, ring + far * axial]
        parts.append(loft(np.stack(rows)))
    axis = np.array([0.0, np.sin(_TILT), -np.cos(_TILT)])
    frame = np.stack([np.array([-1.0, 0.0, 0.0]), np.cross(axis, [-1.0, 0.0, 0.0]), axis])
    pieces = []
    for soup, facing in parts:
        place = soup.points @ frame + _WHEEL
        # The lofts' directions differ; what faces inwards is turned about.
        a, b, c = (place[soup.triangles[:, k]] for k in range(3))
        triangles, out = soup.triangles, facing @ frame
        if (np.cross(b - a, c - a) * out[soup.triangles].mean(axis=1)).sum() < 0.0:
            triangles = triangles[:, ::-1]
        pieces.append(Piece("steering_wheel", "trim", Soup(place, triangles), out))
    return pieces
