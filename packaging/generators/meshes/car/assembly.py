"""Assembly of the car from its pieces."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.surface.mesh import Mesh
from meshes.car.fittings import exhaust, grille_bars, grille_slats, intake_fins, mirror
from meshes.car.interior import LINING_DEPTH, interior, steering_wheel
from meshes.car.lamps import lamps
from meshes.car.nets import Soup, compact
from meshes.car.outlines import BODY_PARTS, body_part
from meshes.car.pieces import LIP_DROP, Piece, join_pieces, lowered, mirror_piece, turn_edges_in, walls
from meshes.car.proportions import AXLES, FRONT_AXLE_Z, FRONT_FACE_X, REAR_FACE_X, WHEEL_RADIUS
from meshes.car.shell import AREAS, GAP, PANELS, Shell, across_gaps, build_shell, take
from meshes.car.wells import floor, wells
from meshes.car.wheel import wheel

_FLANGE_DEPTH = 0.022
_DEEP = 0.03


def car() -> Mesh:
    """Return the car: metres, ground at y = 0, front towards +z; the same every time.

    Parts are named after what they are; materials are the words of :data:`brdf_suite.surface.mesh.MATERIALS`.
    """
    half = [*body_pieces(build_shell()), *floor(), *wells(), *interior(), *mirror(), *wheels()]
    half += [*grille_bars(), *grille_slats(), *intake_fins(), *exhaust()]
    everything = [piece for one in half for piece in (one, mirror_piece(one))] + steering_wheel()
    groups: dict[str, list[Piece]] = {}
    for piece in everything:
        groups.setdefault(piece.name, []).append(piece)
    return Mesh("car", tuple(join_pieces(name, pieces) for name, pieces in sorted(groups.items())))


def body_pieces(shell: Shell) -> list[Piece]:
    """Return the pieces of half the body: painted panels, lamps, sunk areas, windows, shut lines."""
    pieces = []
    for name in ("paint", *(name for name, _ in PANELS)):
        soup, normals, shared, at_arch = take(shell, shell.chosen(name))
        if len(at_arch):
            drops = (np.full(len(normals), drop) for drop in (LIP_DROP, _FLANGE_DEPTH))
            flange, facing = walls(soup, normals, at_arch[:, ::-1], *drops)
            pieces.append(Piece("arch_flanges", "cavity", flange, facing))
        soup, normals = turn_edges_in(soup, normals, np.concatenate([shared, at_arch]))
        pieces += _divided(soup, normals) if name == "paint" else [Piece(name, "paint", soup, normals)]
    pieces += _gaps(shell)
    pieces += lamps(shell)
    for area in AREAS:
        if area.material in ("glass", "chrome", "cavity", "trim"):
            pieces += _area(shell, area.name, area.name, area.material, area.depth)
        if area.material == "glass":
            pieces.append(_reveal(shell, area.name))
        if area.border:
            pieces += _area(shell, f"{area.name}_border", f"{area.name}_frame", area.border_material, 0.0)
    return pieces + _area(shell, "split", "side_window_split", "cavity", 0.0)


def _gaps(shell: Shell) -> list[Piece]:
    """Return the shut lines, those of each panel apart: where two meet, the distance from their middles leaps."""
    soup, normals, _, _ = take(shell, shell.chosen("groove"))
    level = lowered(soup, normals, np.full(len(normals), LIP_DROP))
    owner = np.argmin(np.abs(across_gaps(soup.points[soup.triangles].mean(axis=1))), axis=0)
    distances = across_gaps(soup.points)
    pieces = []
    for number in np.unique(owner):
        own, used = compact(level.points, level.triangles[owner == number])
        across = 1000.0 * np.clip(distances[number, used], -0.5 * GAP, 0.5 * GAP)
        uvs = np.stack([across, np.zeros_like(across)], axis=1)
        pieces.append(Piece("shut_lines", "gap", own, normals[used], uvs))
    return pieces


def _divided(soup: Soup, normals: Floats) -> list[Piece]:
    """Return the body without the panels that open, as its named parts; at their joints normals are the same."""
    part = body_part(*soup.points[soup.triangles].mean(axis=1).T)
    pieces = []
    for number, name in enumerate(BODY_PARTS):
        own, used = compact(soup.points, soup.triangles[part == number])
        pieces.append(Piece(name, "paint", own, normals[used]))
    return pieces


def _reveal(shell: Shell, name: str) -> Piece:
    """Return the walls that close the space between skin and lining round a window."""
    soup, normals, edge, _ = take(shell, shell.chosen(name) | shell.chosen(f"{name}_border"))
    down = np.full(len(normals), LIP_DROP)
    wall, facing = walls(soup, normals, edge, down, np.full(len(normals), LINING_DEPTH + 0.006))
    return Piece("reveals", "trim", wall, facing)


def _area(shell: Shell, piece: str, name: str, material: str, depth: float) -> list[Piece]:
    """Return an area as deep as the edges of the panels round it, or an opening with its walls."""
    soup, normals, edge, _ = take(shell, shell.chosen(piece))
    level = lowered(soup, normals, np.full(len(normals), LIP_DROP))
    if not depth:
        return [Piece(name, material, level, normals)]
    # Deep openings go straight back, since lines along the normals would cross.
    outwards = normals if depth < _DEEP else np.tile([0.0, 0.0, 1.0], (len(normals), 1))
    down = np.full(len(normals), depth)
    wall, facing = walls(level, outwards, edge, 0.0 * down, down)
    floor = Piece(name, material, lowered(level, outwards, down), normals)
    return [floor, Piece("opening_walls", "trim", wall, facing)]


def wheels() -> list[Piece]:
    """Return the wheels of the half x ≥ 0 in their places."""
    pieces = []
    for axle in AXLES:
        face = FRONT_FACE_X if axle == FRONT_AXLE_Z else REAR_FACE_X
        place = np.array([face, WHEEL_RADIUS, axle])
        for piece in wheel():
            soup = Soup(piece.soup.points + place, piece.soup.triangles)
            pieces.append(Piece(piece.name, piece.material, soup, piece.normals))
    return pieces
