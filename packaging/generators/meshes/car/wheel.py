"""One wheel: tyre, rim with five twin spokes, disc and caliper. Axis along x, outer face at x = 0, facing +x."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from meshes.car.lathe import lathe, loft
from meshes.car.nets import Soup
from meshes.car.pieces import Piece
from meshes.car.proportions import TYRE_WIDTH, WHEEL_RADIUS

_SEGMENTS = 44
_SPOKES = 5
_RIM = 0.260


_BLOCKS, _BLOCK_SHARE, _SLOT = 24, 0.80, 0.0055
"""Blocks of the outer shoulder of the tread, their share of the way round, and how deep the slots between are, m."""


def _tyre() -> tuple[Soup, Floats]:
    """Return the tyre: walls with a rim guard and rings, a shoulder of blocks, and ribs between round grooves."""
    r, w = WHEEL_RADIUS, TYRE_WIDTH
    wall = [
        (-0.014, _RIM - 0.010),
        (-0.006, _RIM + 0.004),
        (0.0, _RIM + 0.012),
        (0.0, _RIM + 0.018),
        (-0.0035, _RIM + 0.021),
        (-0.0020, _RIM + 0.034),
        (-0.0040, _RIM + 0.0345),
        (-0.0040, _RIM + 0.0365),
        (-0.0022, _RIM + 0.0370),
        (-0.0045, _RIM + 0.056),
        (-0.0095, r - 0.019),
    ]
    shoulder = [wall[-1], (-0.019, r - 0.0085), (-0.033, r - 0.0025), (-0.050, r - 0.0005)]
    tread = [shoulder[-1]]
    for start in (-0.050, -0.086, -0.1225, -0.159):
        tread += [(start, r), (start - 0.005, r - 0.0075), (start - 0.010, r)]
    tread.append((_across(-0.055, w), r - 0.0005))
    inner = [
        (_across(x, w), y) for x, y in ((-0.055, r - 0.0005), *shoulder[2::-1], wall[5], wall[1], wall[0])
    ]
    return _merged(
        [
            lathe(wall[::-1], _SEGMENTS),
            _blocks(shoulder),
            lathe(tread[::-1], _SEGMENTS),
            lathe(inner[::-1], _SEGMENTS // 2),
        ]
    )


def _across(x: float, width: float) -> float:
    """Return the place across a tyre of ``width`` on the other side of its middle, m."""
    return -width - x


def _blocks(profile: list[tuple[float, float]]) -> tuple[Soup, Floats]:
    """Return a shoulder of the tread: its profile turned about the axle, with slots across; flat faces."""
    x, high = np.asarray(profile).T
    low = high - _SLOT * np.array([0.3, *np.ones(len(profile) - 1)])
    step = 2.0 * np.pi / _BLOCKS
    rows = []
    for number in range(_BLOCKS):
        for share, radius in ((0.0, high), (_BLOCK_SHARE, high), (_BLOCK_SHARE + 0.02, low), (0.98, low)):
            # The slots lean, as those of a tyre do that throws water out.
            angle = -0.5 * np.pi + step * (number + share - 0.5 * _BLOCK_SHARE) + 4.0 * (x - x[0])
            rows.append(np.stack([x, radius * np.sin(angle), radius * np.cos(angle)], axis=1))
    grid = np.stack(rows)
    after = np.roll(grid, -1, axis=0)
    corners = np.stack([grid[:, :-1], grid[:, 1:], after[:, 1:], after[:, :-1]], axis=2).reshape(-1, 4, 3)
    facing = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    first = 4 * np.arange(len(corners))[:, None]
    triangles = np.concatenate([first + np.array([0, 2, 1]), first + np.array([0, 3, 2])])
    return Soup(corners.reshape(-1, 3), triangles), np.repeat(-facing, 4, axis=0)


def _spoke(angle: float, lean: float) -> tuple[Soup, Floats]:
    """Return one spoke, from the hub to the rim at ``angle`` (rad), its outer end ``lean`` further."""
    t = np.linspace(0.0, 1.0, 5)
    radius = 0.045 + (_RIM - 0.008 - 0.045) * t
    turn = angle + lean * (0.35 + 0.65 * t)
    half = 0.0195 - 0.0050 * t + 0.006 * (1.0 - t) ** 2 + 0.006 * np.clip(t - 0.8, 0, None) / 0.2
    front = -0.050 + 0.038 * t**1.7
    depth = 0.045 - 0.012 * t
    # Section: a flat face with bevelled shoulders on a deeper, narrower rib.
    outline = np.array(
        [
            (-0.55, 0.0),
            (0.55, 0.0),
            (1.0, -0.18),
            (0.92, -0.45),
            (0.6, -1.0),
            (-0.6, -1.0),
            (-0.92, -0.45),
            (-1.0, -0.18),
        ]
    )
    strips = []
    for (u0, d0), (u1, d1) in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        rows = []
        for u, d in ((u0, d0), (u1, d1)):
            tangential, x = u * half, front + d * depth
            y = radius * np.sin(turn) + tangential * np.cos(turn)
            z = radius * np.cos(turn) - tangential * np.sin(turn)
            rows.append(np.stack([x, y, z], axis=1))
        strips.append(loft(np.stack(rows, axis=1), closed=False))
    return _merged(strips)


def _merged(parts: list[tuple[Soup, Floats]]) -> tuple[Soup, Floats]:
    offset = np.cumsum([0] + [len(soup.points) for soup, _ in parts])
    points = np.concatenate([soup.points for soup, _ in parts])
    triangles = np.concatenate([soup.triangles + o for (soup, _), o in zip(parts, offset, strict=False)])
    return Soup(points, triangles), np.concatenate([n for _, n in parts])


def _caliper() -> tuple[Soup, Floats]:
    """Return a block that straddles the disc, ahead of the axle."""
    angles = np.radians(np.linspace(215.0, 150.0, 9))
    section = np.array([(-0.070, 0.115), (-0.070, 0.196), (-0.078, 0.207), (-0.165, 0.207), (-0.165, 0.115)])
    strips = []
    for one, two in zip(section, np.roll(section, -1, axis=0), strict=True):
        rows = [
            np.stack([np.full(9, x), r * np.sin(angles), r * np.cos(angles)], axis=1) for x, r in (one, two)
        ]
        strips.append(loft(np.stack(rows, axis=1), closed=False))
    for end in (0, -1):
        fan = np.stack(
            [section[:, 0], section[:, 1] * np.sin(angles[end]), section[:, 1] * np.cos(angles[end])], 1
        )
        triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4]])
        if end == 0:
            triangles = triangles[:, ::-1]
        facing = np.cross(
            fan[triangles[0, 1]] - fan[triangles[0, 0]], fan[triangles[0, 2]] - fan[triangles[0, 0]]
        )
        strips.append((Soup(fan, triangles), np.tile(facing / np.linalg.norm(facing), (5, 1))))
    return _merged(strips)


def wheel() -> list[Piece]:
    """Return the pieces of one wheel about the origin."""
    rim = [
        (-0.016, _RIM + 0.0010),
        (-0.0060, _RIM + 0.0010),
        (-0.0035, _RIM - 0.0030),
        (-0.0035, _RIM - 0.0070),
        (-0.0085, _RIM - 0.0145),
        (-0.020, _RIM - 0.0170),
        (-0.060, _RIM - 0.021),
        (-0.235, _RIM - 0.021),
        (-0.240, _RIM - 0.017),
        (-0.241, _RIM + 0.0005),
    ]
    cap = [
        (-0.055, 0.062),
        (-0.046, 0.060),
        (-0.043, 0.054),
        (-0.043, 0.036),
        (-0.047, 0.034),
        (-0.047, 0.031),
        (-0.041, 0.029),
        (-0.039, 0.020),
        (-0.038, 0.0005),
    ]
    disc = [
        (-0.118, 0.192),
        (-0.102, 0.192),
        (-0.102, 0.088),
        (-0.085, 0.082),
        (-0.080, 0.05),
        (-0.080, 0.001),
    ]
    spokes = []
    for k in range(_SPOKES):
        middle = np.pi / 2 + 2.0 * np.pi * k / _SPOKES
        spokes += [_spoke(middle + s * 0.10, s * 0.13) for s in (1.0, -1.0)]
    pieces = [
        ("tyres", "rubber", _tyre()),
        ("rims", "chrome", lathe(rim[:6], _SEGMENTS)),
        ("rim_barrels", "trim", lathe(rim[5:], 24)),
        ("rims", "chrome", lathe(cap, 24)),
        ("rims", "chrome", _merged(spokes)),
        ("discs", "chrome", lathe(disc, 28)),
        ("calipers", "trim", _caliper()),
    ]
    return [Piece(name, material, soup, normals) for name, material, (soup, normals) in pieces]
