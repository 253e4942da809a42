"""Lamps: clear lenses flush with the skin, and behind them housings, light guides and projectors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from meshes.car.lathe import lathe
from meshes.car.nets import Soup, border, compact
from meshes.car.outlines import headlamp_middle, round_nose
from meshes.car.pieces import LIP_DROP, Piece, lowered, walls
from meshes.car.shell import Shell, take
from meshes.car.simplify import merge_points

_INTO_NOSE = np.array([-0.42, 0.0, -0.91]) / np.hypot(0.42, 0.91)
_INTO_TAIL = np.array([-0.30, 0.0, 0.95]) / np.hypot(0.30, 0.95)
_PROJECTORS = (0.70, 0.81, 0.92, 1.03)
"""Places of the projectors round the nose, m."""


def lamps(shell: Shell) -> list[Piece]:
    """Return head and tail lamps of the half x ≥ 0."""
    front = shell.chosen("headlamp") | shell.chosen("daylight")
    rear = shell.chosen("tail_panel") | shell.chosen("tail_band")
    pieces = _lamp(shell, front, "headlamp", _INTO_NOSE, 0.055)
    pieces += _guide(shell, "daylight", "lamp", _INTO_NOSE, 0.016)
    pieces += _lamp(shell, rear, "tail_panel", _INTO_TAIL, 0.035)
    pieces += _guide(shell, "tail_band", "tail_lamp", _INTO_TAIL, 0.014)
    lens, _, _, _ = take(shell, front)
    for q in _PROJECTORS:
        pieces += _projector(lens.points, q)
    return pieces


def _lamp(shell: Shell, chosen: NDArray[np.bool_], name: str, into: Floats, depth: float) -> list[Piece]:
    """Return a lens, and the housing behind it as deep as ``depth`` (m) along ``into``."""
    soup, normals, _, _ = take(shell, chosen)
    level = lowered(soup, normals, np.full(len(normals), LIP_DROP))
    lens, on_lens = _merged(level, normals, 0.03, 8.0)
    coarse, on_floor = _merged(level, normals, 0.06, 20.0)
    edge = border(coarse.triangles)
    edge = edge[coarse.points[edge][..., 0].max(axis=1) > 1e-6]
    down = np.full(len(on_floor), depth)
    outwards = np.tile(-into, (len(on_floor), 1))
    wall, facing = walls(coarse, outwards, edge, 0.0 * down, down)
    floor = lowered(coarse, outwards, down)
    return [
        Piece(f"{name}_lens", "lens", lens, on_lens),
        Piece(f"{name}_housing", "trim", wall, facing),
        Piece(f"{name}_housing", "trim", floor, on_floor),
    ]


def _merged(soup: Soup, normals: Floats, shortest: float, angle_deg: float) -> tuple[Soup, Floats]:
    """Return the soup without the short edges that outlines within it left, and its normals."""
    none = np.zeros((len(soup.points), 1), dtype=bool)
    triangles, _ = merge_points(soup.points, normals, soup.triangles, none, shortest, angle_deg)
    merged, used = compact(soup.points, triangles)
    return merged, normals[used]


def _guide(shell: Shell, name: str, material: str, into: Floats, depth: float) -> list[Piece]:
    """Return a band of light behind the lens, with a dark step round it."""
    soup, normals, edge, _ = take(shell, shell.chosen(name))
    outwards = np.tile(-into, (len(normals), 1))
    top, down = np.full(len(normals), depth), np.full(len(normals), depth + 0.016)
    wall, facing = walls(soup, outwards, edge, top, down)
    return [
        Piece(name, material, lowered(soup, outwards, top), normals),
        Piece(f"{name}_guide", "trim", Soup(wall.points, wall.triangles[:, ::-1]), -facing),
    ]


def _projector(lens: Floats, q: float) -> list[Piece]:
    """Return a cup and the ball lens in it, at the place ``q`` round the nose on the middle line of the lens."""
    off = np.hypot(round_nose(lens[:, 0], lens[:, 2]) - q, lens[:, 1] - headlamp_middle(np.array([q]))[0])
    place = lens[np.argsort(off)[:6]].mean(axis=0) + 0.012 * _INTO_NOSE
    cup = [(0.0, 0.0185), (-0.0005, 0.0170), (-0.010, 0.0150), (-0.020, 0.0110), (-0.026, 0.0005)]
    t = np.linspace(0.0, 0.5 * np.pi, 5)[:-1]
    ball = [(-0.022 + 0.013 * float(np.sin(a)), 0.013 * float(np.cos(a))) for a in t] + [(-0.009, 0.0003)]
    pieces = []
    for name, material, profile in (
        ("projector_cups", "chrome", cup),
        ("projector_lenses", "lens", ball),
    ):
        soup, facing = lathe(profile, 14)
        pieces.append(
            Piece(name, material, Soup(_turned(soup.points) + place, soup.triangles), _turned(facing))
        )
    return pieces


def _turned(vectors: Floats) -> Floats:
    """Return vectors (n, 3) of a lathe, whose axis is +x, with that axis out of the nose."""
    out = -_INTO_NOSE
    up = np.array([0.0, 1.0, 0.0])
    return np.asarray(vectors @ np.stack([out, up, np.cross(out, up)]))
