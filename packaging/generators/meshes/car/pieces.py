"""Pieces: soups with normals and a material; edges turned in, areas sunk, halves mirrored, UVs laid on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats, Integers
from brdf_suite.surface.mesh import PartGeometry
from meshes.car.nets import Soup, compact

LIP_DROP = 0.0008
"""How far the edge of a panel lies below its surface, m."""
_LIP_TURN = 0.1
_ATLAS_MM = 20000.0


@dataclass(frozen=True)
class Piece:
    """A soup with unit normals (n, 3) that belongs to a part of that name and material.

    ``uvs`` (n, 2), mm, are its texture coordinates; left out, they are made when pieces are joined.
    """

    name: str
    material: str
    soup: Soup
    normals: Floats
    uvs: Floats | None = None


def lowered(soup: Soup, normals: Floats, down: Floats) -> Soup:
    """Return the soup with each point moved against its normal by ``down`` (n,), m."""
    return Soup(soup.points - down[:, None] * normals, soup.triangles)


def turn_edges_in(soup: Soup, normals: Floats, edge: Integers) -> tuple[Soup, Floats]:
    """Return a panel whose given edges bend inwards: the rounded edge of pressed sheet metal.

    Points on the border drop by a fraction of a millimetre and their normals lean outwards a little: highlights of a
    sheet's real radius are far narrower than a pixel and would break into dots. The strip that bends must have been
    cut beforehand.
    """
    a, b = edge.T
    outwards = np.zeros_like(soup.points)
    along = soup.points[b] - soup.points[a]
    for end in (a, b):
        sideways = np.cross(along, normals[end])
        length = np.linalg.norm(sideways, axis=1, keepdims=True)
        np.add.at(outwards, end, sideways / np.maximum(length, 1e-12))
    length = np.linalg.norm(outwards, axis=1, keepdims=True)
    outwards /= np.maximum(length, 1e-9)
    outwards[np.abs(soup.points[:, 0]) < 1e-6, 0] = 0.0
    turned = length[:, 0] > 1e-6
    points, bent = soup.points.copy(), normals.copy()
    points[turned] -= LIP_DROP * normals[turned]
    bent[turned] += _LIP_TURN * outwards[turned]
    bent[turned] /= np.linalg.norm(bent[turned], axis=1, keepdims=True)
    return Soup(points, soup.triangles), bent


def walls(soup: Soup, normals: Floats, edge: Integers, top: Floats, depth: Floats) -> tuple[Soup, Floats]:
    """Return walls along edges of a sunk area, facing into it.

    They go from ``top`` to ``depth`` (m, one per point) below the surface.
    """
    used, index = np.unique(edge, return_inverse=True)
    ends = index.reshape(-1, 2)
    p, n = soup.points[used], normals[used]
    a, b = ends.T
    across = np.cross(p[b] - p[a], -(n[a] + n[b]))
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12)
    facing = np.zeros_like(p)
    for end in (a, b):
        np.add.at(facing, end, across)
    facing /= np.maximum(np.linalg.norm(facing, axis=1, keepdims=True), 1e-12)
    # Where a wall turns a corner its points are doubled.
    sharp = np.minimum(*(np.einsum("ij,ij->i", across, facing[end]) for end in (a, b))) < 0.8
    ends[sharp] = len(used) + np.arange(2 * int(sharp.sum())).reshape(-1, 2)
    place = np.concatenate([used, edge[sharp].ravel()])
    facing = np.concatenate([facing, np.repeat(across[sharp], 2, axis=0)])
    a, b = ends.T
    below = len(place)
    triangles = [np.stack([a, b, a + below], 1), np.stack([b, b + below, a + below], 1)]
    points, outwards = soup.points[place], normals[place]
    levels = [points - down[place, None] * outwards for down in (top, depth)]
    walls, used = compact(np.concatenate(levels), np.concatenate(triangles))
    return walls, np.concatenate([facing, facing])[used]


def mirror_piece(piece: Piece) -> Piece:
    """Return the piece on the other side of the middle plane."""
    flip = np.array([-1.0, 1.0, 1.0])
    soup = Soup(piece.soup.points * flip, piece.soup.triangles[:, ::-1])
    return Piece(piece.name, piece.material, soup, piece.normals * flip, piece.uvs)


def join_pieces(name: str, pieces: list[Piece]) -> PartGeometry:
    """Return pieces of one name and material as a part, with box-projected UVs."""
    offset = np.cumsum([0] + [len(piece.soup.points) for piece in pieces])
    points = np.concatenate([piece.soup.points for piece in pieces])
    normals = np.concatenate([piece.normals for piece in pieces])
    triangles = np.concatenate([piece.soup.triangles + o for piece, o in zip(pieces, offset, strict=False)])
    triangles = without_slivers(points, triangles)
    given = [piece.uvs for piece in pieces if piece.uvs is not None]
    if given:
        uvs = np.concatenate(given)
    elif pieces[0].material == "paint":
        points, normals, uvs, triangles = project_box(points, normals, triangles)
    else:
        uvs = planar(points, normals)
    return PartGeometry(name, pieces[0].material, points, normals, uvs, triangles)


def without_slivers(points: Floats, triangles: Integers) -> Integers:
    """Return the triangles whose area single precision can hold (over 1e-10 m²)."""
    p = points.astype(np.float32).astype(np.float64)
    a, b, c = (p[triangles[:, i]] for i in range(3))
    result: Integers = triangles[np.linalg.norm(np.cross(b - a, c - a), axis=1) > 2e-10]
    return result


def planar(points: Floats, normals: Floats) -> Floats:
    """Return UVs (n, 2), mm, along the axis that each point's normal is nearest to: for parts without flakes."""
    axis = np.argmax(np.abs(normals), axis=1)
    across = np.where(axis == 0, points[:, 2], points[:, 0])
    up = np.where(axis == 1, points[:, 2], points[:, 1])
    result: Floats = np.stack([across, up], axis=1) * 1000.0
    return result


def project_box(
    points: Floats, normals: Floats, triangles: Integers
) -> tuple[Floats, Floats, Floats, Integers]:
    """Return points, normals, UVs (mm) and triangles, points doubled where the projection axis changes.

    Each triangle is seen along the axis that it faces most, so lengths shrink by at most 1/√3, and
    the six directions lie apart in UV space so that no flake appears twice.
    """
    facing = normals[triangles].sum(axis=1)
    axis = np.argmax(np.abs(facing) * np.array([1.0, 1.0, 0.8]), axis=1)
    side = 2 * axis + (np.take_along_axis(facing, axis[:, None], 1)[:, 0] < 0.0)
    key = triangles * 6 + side[:, None]
    unique, inverse = np.unique(key, return_inverse=True)
    index, face = unique // 6, unique % 6
    p = points[index]
    across = np.where(face // 2 == 0, p[:, 2], p[:, 0])
    up = np.where(face // 2 == 1, p[:, 2], p[:, 1])
    uvs = np.stack([across * 1000.0 + _ATLAS_MM * (face % 2), up * 1000.0 + _ATLAS_MM * (face // 2)], axis=1)
    return p, normals[index], uvs, inverse.reshape(-1, 3).astype(np.int64)
