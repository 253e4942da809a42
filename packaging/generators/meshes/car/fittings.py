"""Parts bolted on: door mirrors, grille bars, exhaust tips. Half x ≥ 0."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from meshes.car.blends import smooth_max, smooth_min
from meshes.car.body import body
from meshes.car.cutting import at_points, cut
from meshes.car.lathe import lathe, loft
from meshes.car.nets import Soup, extract, normals, project, refine
from meshes.car.outlines import round_nose
from meshes.car.pieces import Piece

_MIRROR = (0.944, 0.996, 0.43)


def _housing(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the mirror's head: a rounded wedge, cut flat behind."""
    u, v, w = x - _MIRROR[0], y - _MIRROR[1], z - _MIRROR[2]
    r = np.sqrt((u / 0.116) ** 2 + ((v - 0.06 * u) / (0.063 + 0.10 * u)) ** 2 + (w / 0.108) ** 2 + 1e-9)
    head = (r - 1.0) * 0.075
    return smooth_max(head, -0.030 - w - 0.18 * u, 0.012)


def _stalk(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the foot that stands on the door's shoulder."""
    u, v, w = x - 0.865, y - 0.925, z - 0.45
    foot = np.sqrt((v - 0.45 * u) ** 2 + (0.45 * w) ** 2 + 1e-9) - 0.016
    return smooth_max(smooth_max(foot, u - 0.06, 0.01), -u - 0.09, 0.01)


def _mirror(x: Floats, y: Floats, z: Floats) -> Floats:
    return smooth_min(_housing(x, y, z), _stalk(x, y, z), 0.03)


def mirror() -> list[Piece]:
    """Return housing, foot and glass of the left mirror."""
    step = 0.018
    grid = [np.arange(low, high, step) for low, high in ((0.76, 1.15), (0.83, 1.11), (0.34, 0.58))]
    soup = extract(_mirror, *grid)
    soup = Soup(project(_mirror, soup.points), soup.triangles)
    soup = refine(_mirror, soup, 20.0, 0.010)
    lower = at_points(lambda x, y, z: y - 0.972 - 0.10 * (x - _MIRROR[0]) + 0.0 * z)
    flat = at_points(
        lambda x, y, z: smooth_max((z - _MIRROR[2]) + 0.0285 + 0.18 * (x - _MIRROR[0]), 0.0 * y - 1.0, 0.001)
    )
    for function in (lower, flat):
        soup = cut(soup, function)
    middle = soup.points[soup.triangles].mean(axis=1)
    glass = flat(middle) < 0.0
    black = (lower(middle) < 0.0) & ~glass
    pieces = []
    for name, material, chosen in (
        ("mirror_housings", "paint", ~glass & ~black),
        ("mirror_feet", "trim", black),
        ("mirror_glasses", "chrome", glass),
    ):
        piece = soup.keep(chosen)
        pieces.append(Piece(name, material, piece, normals(_mirror, piece.points)))
    return pieces


def _on_nose(x: Floats, y: Floats) -> Floats:
    """Return z of the nose's surface at (x, y), by Newton's method along z."""
    z = np.full_like(x, 2.1)
    for _ in range(20):
        slope = (body(x, y, z + 1e-4) - body(x, y, z - 1e-4)) / 2e-4
        z = z - np.clip(body(x, y, z) / np.maximum(slope, 0.2), -0.05, 0.05)
    return z


def _bar(lines: list[Floats], name: str, material: str) -> list[Piece]:
    """Return the sides of a bar between neighbouring ``lines`` (n, 3) along it, the last one before the first."""
    pieces = []
    for one, two in zip(lines, lines[1:] + lines[:1], strict=True):
        soup, facing = loft(np.stack([two, one], axis=1), closed=False)
        pieces.append(Piece(name, material, soup, facing))
    return pieces


def grille_bars() -> list[Piece]:
    """Return horizontal bars that follow the nose, set back in the main intake."""
    pieces = []
    x = np.linspace(0.0, 0.53, 13)
    section = [(0.0, 0.0), (0.0045, -0.006), (0.003, -0.020), (-0.003, -0.020), (-0.0045, -0.006)]
    for y in np.arange(0.268, 0.47, 0.034):
        z = _on_nose(x, np.full_like(x, y)) - 0.018
        lines = [np.stack([x, np.full_like(x, y + up), z + forward], axis=1) for up, forward in section]
        pieces += _bar(lines, "grille_bars", "chrome")
    return pieces


def grille_slats() -> list[Piece]:
    """Return the mesh behind the bars of the main intake: upright slats and a row of level ones between the bars."""
    pieces = []
    y = np.linspace(0.24, 0.47, 4)
    for x in np.arange(0.0125, 0.51, 0.025):
        z = _on_nose(np.full_like(y, x), y) - 0.046
        section = [(-0.0014, 0.0), (-0.0014, -0.022), (0.0014, -0.022), (0.0014, 0.0)]
        lines = [np.stack([np.full_like(y, x + aside), y, z + forward], axis=1) for aside, forward in section]
        pieces.append(Piece("grille_mesh", "trim", *loft(np.stack(lines[::-1], axis=1))))
    x = np.linspace(0.0, 0.53, 7)
    for level in np.arange(0.251, 0.47, 0.017):
        z = _on_nose(x, np.full_like(x, level)) - 0.046
        section = [(0.0014, 0.0), (0.0014, -0.022), (-0.0014, -0.022), (-0.0014, 0.0)]
        lines = [np.stack([x, np.full_like(x, level + up), z + forward], axis=1) for up, forward in section]
        pieces.append(Piece("grille_mesh", "trim", *loft(np.stack(lines[::-1], axis=1))))
    return pieces


def intake_fins() -> list[Piece]:
    """Return the level fins of the outer intake, set back in it."""
    pieces = []
    for y in (0.282, 0.320, 0.358, 0.396):
        x = np.linspace(0.40, 0.90, 200)
        q = round_nose(x, _on_nose(x, np.full_like(x, y)))
        low, high = (float(np.interp(at, q, x)) for at in (0.73 + 0.35 * (y - 0.3), 1.01 + 0.2 * (y - 0.3)))
        x = np.linspace(low, high, 8)
        z = _on_nose(x, np.full_like(x, y)) - 0.012
        section = [(0.0015, 0.0), (0.004, -0.034), (-0.004, -0.034), (-0.0015, 0.0)]
        lines = [np.stack([x, np.full_like(x, y + up), z + forward], axis=1) for up, forward in section]
        pieces += _bar(lines, "intake_fins", "trim")
    return pieces


def exhaust() -> list[Piece]:
    """Return the left tail pipe: an oval chrome tip with a dark inside."""
    place, oval = np.array([0.50, 0.318, -2.175]), np.array([1.0, 0.66, 1.0])
    tip = [(-0.12, 0.056), (0.012, 0.056), (0.015, 0.0535), (0.012, 0.050), (-0.04, 0.050)]
    inside = [(-0.04, 0.050), (-0.10, 0.048), (-0.10, 0.001)]
    pieces = []
    for name, material, profile in (("exhaust_tips", "chrome", tip), ("exhaust_pipes", "cavity", inside)):
        soup, facing = lathe(profile, 40)
        # The lathe turns about +x; the pipe points backwards: x -> -z, z -> x, a rotation.
        points = soup.points[:, [2, 1, 0]] * np.array([1.0, 1.0, -1.0])
        facing = facing[:, [2, 1, 0]] * np.array([1.0, 1.0, -1.0]) / oval
        facing /= np.linalg.norm(facing, axis=1, keepdims=True)
        pieces.append(Piece(name, material, Soup(points * oval + place, soup.triangles), facing))
    return pieces
