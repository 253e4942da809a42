"""The whole car from its pieces."""

from __future__ import annotations

import numpy as np

from brdf_suite.surface.car import outlines
from brdf_suite.surface.car.blends import Floats, ramp
from brdf_suite.surface.car.cutting import at_points
from brdf_suite.surface.car.fittings import grille_bars, mirror
from brdf_suite.surface.car.nets import Soup
from brdf_suite.surface.car.pieces import LIP_DROP, Piece, joined, mirrored, turned_in, walls
from brdf_suite.surface.car.proportions import AXLES, FRONT_AXLE_Z, FRONT_FACE_X, REAR_FACE_X, WHEEL_RADIUS
from brdf_suite.surface.car.shell import AREAS, PANELS, Shell, build_shell, take
from brdf_suite.surface.car.wells import floor, wells
from brdf_suite.surface.car.wheel import wheel
from brdf_suite.surface.mesh import Mesh

_GROOVE_DEPTH = 0.009
_BORDER_DEPTH = 0.0012
_FLANGE_DEPTH = 0.022


def car() -> Mesh:
    """Return the car: metres, ground at y = 0, front towards +z; the same every time.

    Parts are named after what they are; materials are the words of :data:`brdf_suite.surface.mesh.MATERIALS`.
    """
    half = [*body_pieces(build_shell()), floor(), *wells(), *mirror(), *grille_bars(), *wheels()]
    everything = [piece for one in half for piece in (one, mirrored(one))]
    groups: dict[str, list[Piece]] = {}
    for piece in everything:
        groups.setdefault(piece.name, []).append(piece)
    return Mesh("car", tuple(joined(name, pieces) for name, pieces in sorted(groups.items())))


def body_pieces(shell: Shell) -> list[Piece]:
    """Return the pieces of half the body: painted panels, sunk areas, shut lines."""
    pieces = []
    for name in ("paint", *(name for name, _ in PANELS)):
        soup, normals, shared, at_arch = take(shell, shell.chosen(name))
        if len(at_arch):
            drops = (np.full(len(normals), drop) for drop in (LIP_DROP, _FLANGE_DEPTH))
            flange, facing = walls(soup, normals, at_arch[:, ::-1], *drops)
            pieces.append(Piece("gap_walls", "trim", flange, facing))
        soup, normals = turned_in(soup, normals, np.concatenate([shared, at_arch]))
        pieces.append(Piece("body" if name == "paint" else name, "paint", soup, normals))
    pieces += _sunk(shell, "groove", "shut_lines", "trim", LIP_DROP, _GROOVE_DEPTH)
    for area in AREAS:
        top = _BORDER_DEPTH if area.border else LIP_DROP
        inner = ("split",) if area.name == "side_window" else ()
        pieces += _sunk(shell, area.name, area.name, area.material, top, area.depth, inner)
        if area.border:
            frame = f"{area.name}_frame"
            pieces += _sunk(shell, f"{area.name}_border", frame, area.border_material, LIP_DROP, top)
        for name in inner:
            pieces += _sunk(shell, name, f"{area.name}_{name}", "trim", area.depth, area.depth)
    return pieces


def _sunk(
    shell: Shell, piece: str, name: str, material: str, top: float, depth: float, inner: tuple[str, ...] = ()
) -> list[Piece]:
    """Return an area moved inwards by ``depth``, and the dark walls round it from ``top`` down.

    ``inner`` are pieces that lie in it at the same depth: no wall stands between.
    """

    def fade(points: Floats) -> Floats:
        return ramp(at_points(outlines.floor)(points), 0.0, 0.03)  # meets the underbody without a step

    soup, normals, _, _ = take(shell, shell.chosen(piece))
    down = depth * fade(soup.points)
    result = [Piece(name, material, Soup(soup.points - down[:, None] * normals, soup.triangles), normals)]
    if depth > top:
        whole = np.any([shell.chosen(each) for each in (piece, *inner)], axis=0)
        soup, normals, edge, _ = take(shell, whole)
        share = fade(soup.points)
        wall, facing = walls(soup, normals, edge, top * share, depth * share)
        result.append(Piece("gap_walls", "trim", wall, facing))
    return result


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
