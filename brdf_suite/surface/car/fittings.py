"""Parts bolted on: door mirrors, grille bars, exhaust tips, rear number plate. Half x ≥ 0."""

from __future__ import annotations

import numpy as np

from brdf_suite.surface.car.blends import Floats, smooth_max, smooth_min
from brdf_suite.surface.car.body import body
from brdf_suite.surface.car.cutting import at_points, cut
from brdf_suite.surface.car.lathe import loft
from brdf_suite.surface.car.nets import Soup, extract, normals, project, refine
from brdf_suite.surface.car.pieces import Piece

_MIRROR = (0.965, 0.998, 0.43)


def _housing(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the mirror's head: a rounded wedge, cut flat behind."""
    u, v, w = x - _MIRROR[0], y - _MIRROR[1], z - _MIRROR[2]
    r = np.sqrt((u / 0.118) ** 2 + ((v - 0.06 * u) / 0.068) ** 2 + (w / 0.105) ** 2 + 1e-9)
    head = (r - 1.0) * 0.075
    return smooth_max(head, -0.030 - w - 0.18 * u, 0.012)


def _stalk(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the foot that stands on the door's shoulder."""
    u, v, w = x - 0.86, y - 0.925, z - 0.45
    foot = np.sqrt((v - 0.45 * u) ** 2 + (0.45 * w) ** 2 + 1e-9) - 0.016
    return smooth_max(smooth_max(foot, u - 0.06, 0.01), -u - 0.09, 0.01)


def _mirror(x: Floats, y: Floats, z: Floats) -> Floats:
    return smooth_min(_housing(x, y, z), _stalk(x, y, z), 0.03)


def mirror() -> list[Piece]:
    """Return housing, foot and glass of the left mirror."""
    step = 0.011
    grid = [np.arange(low, high, step) for low, high in ((0.74, 1.13), (0.83, 1.11), (0.34, 0.58))]
    soup = extract(_mirror, *grid)
    soup = Soup(project(_mirror, soup.points), soup.triangles)
    soup = refine(_mirror, soup, 14.0, 0.006)
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
        ("mirror_glasses", "glass", glass),
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


def grille_bars() -> list[Piece]:
    """Return horizontal bars that follow the nose, set back in the main intake."""
    pieces = []
    x = np.linspace(0.0, 0.53, 28)
    for y in np.arange(0.262, 0.47, 0.030):
        z = _on_nose(x, np.full_like(x, y)) - 0.018
        section = [(0.0, 0.0), (0.0055, -0.008), (0.004, -0.030), (-0.004, -0.030), (-0.0055, -0.008)]
        strips = []
        for (v0, w0), (v1, w1) in zip(section, section[1:] + section[:1], strict=True):
            strips.append(
                np.stack(
                    [np.stack([x, y + v + 0 * x, z + w], axis=1) for v, w in ((v0, w0), (v1, w1))], axis=1
                )
            )
        for strip in strips:
            soup, facing = loft(strip[:, ::-1], closed=False)
            pieces.append(Piece("grille_bars", "chrome", soup, facing))
    return pieces
