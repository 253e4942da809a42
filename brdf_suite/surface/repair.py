"""Conversion of a foreign file's arrays to a drawable :class:`~brdf_suite.surface.mesh.PartGeometry`.

Every change is said in a note. The steps, in order: triangles that cannot be drawn are left out (indices that
are not there, corners that are not finite, no area); a closed body turned inside out is turned back; missing
normals are made, smooth within a crease angle; texture coordinates become millimetres on the surface.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Bools, Floats, Integers
from brdf_suite.surface.mesh import PartGeometry
from brdf_suite.surface.normals import corner_normals, face_normals, is_inside_out, packed, used_numbers, weld
from brdf_suite.surface.unwrap import box_uvs, uvs_in_millimetres

CREASE_DEG = 40.0
"""Faces that meet at more than this angle keep an edge between them when normals are made."""


@dataclass(frozen=True, eq=False)
class RawPart:
    """Unchecked data of one part from a file.

    ``positions`` (n, 3) metres, world axes; ``triangles`` (k, 3) indices; ``normals`` (n, 3) or ``None``;
    ``uvs`` (n, 2) in any unit, or ``None``.
    """

    name: str
    material: str
    positions: Floats
    triangles: Integers
    normals: Floats | None = None
    uvs: Floats | None = None


def repair(raw: RawPart) -> tuple[PartGeometry | None, list[str]]:
    """Return a part that can be drawn and notes on what was changed.

    The part is ``None`` where no triangle is left; the notes then say why.
    """
    notes: list[str] = []
    triangles = _drawable(raw, notes)
    if not len(triangles):
        return None, notes
    used, triangles = used_numbers(triangles, len(raw.positions))
    positions = raw.positions[used]
    uvs = raw.uvs[used] if raw.uvs is not None and raw.uvs.shape == (len(raw.positions), 2) else None
    normals = _given_normals(raw, used)
    if normals is None:
        welded = weld(positions)
        if is_inside_out(positions, triangles, welded):
            triangles = triangles[:, ::-1]
            notes.append(f"{raw.name}: turned inside out, its triangles faced inwards")
        corners = corner_normals(positions, triangles, welded, CREASE_DEG)
        positions, triangles, normals, kept = split_corners(positions, triangles, corners)
        uvs = None if uvs is None else uvs[kept]
        notes.append(f"{raw.name}: had no normals; made smooth, with edges above {CREASE_DEG:g}°")
    else:
        normals = _mended_normals(raw.name, positions, triangles, normals, notes)

    scaled = None if uvs is None else uvs_in_millimetres(positions, triangles, uvs)
    if scaled is None:
        why = (
            "had no texture coordinates" if uvs is None else "texture coordinates were too uneven for flakes"
        )
        notes.append(f"{raw.name}: {why}; projected from the sides of a box, in millimetres")
        scaled, kept, triangles = box_uvs(positions, triangles)
        positions, normals = positions[kept], normals[kept]
    part = PartGeometry(raw.name, raw.material, positions, normals, scaled, triangles)
    return part, notes


def _drawable(raw: RawPart, notes: list[str]) -> Integers:
    """Return the triangles that exist, are finite and have an area."""
    triangles = np.asarray(raw.triangles, dtype=np.int64).reshape(-1, 3)
    present: Bools = np.all((triangles >= 0) & (triangles < len(raw.positions)), axis=1)
    if not present.all():
        notes.append(f"{raw.name}: left out {_count(~present)} with corners that are not in the file")
        triangles = triangles[present]
    # Beyond 1e12 m single precision has nothing left to draw with.
    sound: Bools = np.all(np.abs(raw.positions) < 1e12, axis=1)
    finite: Bools = np.all(sound[triangles], axis=1)
    if not finite.all():
        notes.append(f"{raw.name}: left out {_count(~finite)} with corners that are not finite")
        triangles = triangles[finite]
    a, b, c = (raw.positions[triangles[:, corner]] for corner in range(3))
    edges = a - c, b - a, c - b
    longest = np.maximum.reduce([np.einsum("kj,kj->k", edge, edge) for edge in edges])
    doubled = np.linalg.norm(np.cross(edges[0], edges[1]), axis=1)
    flat = doubled <= 1e-10 * longest
    if flat.any():
        notes.append(f"{raw.name}: left out {_count(flat)} without area")
        triangles = triangles[~flat]
    return triangles


def _count(mask: Bools) -> str:
    number = int(mask.sum())
    return "1 triangle" if number == 1 else f"{number:,} triangles"


def _given_normals(raw: RawPart, used: Integers) -> Floats | None:
    """Return the file's normals of the ``used`` vertices, unit or zero; ``None`` where most are no use."""
    if raw.normals is None or raw.normals.shape != raw.positions.shape:
        return None
    normals = np.where(np.isfinite(raw.normals[used]), raw.normals[used], 0.0)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    good = (length > 1e-6) & (length < 1e12)
    if good.mean() < 0.5:
        return None
    return np.where(good, normals / np.where(good, length, 1.0), 0.0)


def _mended_normals(
    name: str, positions: Floats, triangles: Integers, normals: Floats, notes: list[str]
) -> Floats:
    """Fill the zero normals with the mean of the faces around them."""
    missing = ~normals.any(axis=1)
    if not missing.any():
        return normals
    welded = weld(positions)
    summed = np.zeros((welded.max() + 1, 3))
    faces = face_normals(positions, triangles)
    for corner in range(3):
        np.add.at(summed, welded[triangles[:, corner]], faces)
    length = np.linalg.norm(summed, axis=1, keepdims=True)
    smooth = np.where(length > 1e-12, summed / np.maximum(length, 1e-12), [0.0, 1.0, 0.0])
    normals = normals.copy()
    normals[missing] = smooth[welded[missing]]
    notes.append(f"{name}: made {int(missing.sum()):,} normals that were missing or not finite")
    return normals


def split_corners(
    positions: Floats, triangles: Integers, corners: Floats
) -> tuple[Floats, Integers, Floats, Integers]:
    """Give each vertex one normal by splitting it where ``corners`` (k, 3, 3) has several.

    Returns positions, triangles, normals and, for each new vertex, the old one.
    """
    vertices, normals = triangles.reshape(-1), corners.reshape(-1, 3)
    facing = packed(np.round(normals * 1e6).astype(np.int64) + 1_000_000)
    order = np.lexsort((facing, vertices))
    starts = np.ones(len(order), np.bool_)
    starts[1:] = (np.diff(vertices[order]) != 0) | (np.diff(facing[order]) != 0)
    flat = np.empty(len(order), np.int64)
    flat[order] = np.cumsum(starts) - 1
    first = order[starts]
    kept = vertices[first]
    return positions[kept], flat.reshape(-1, 3), normals[first], kept
