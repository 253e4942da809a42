"""Conversion of a foreign file's arrays to a drawable :class:`~brdf_suite.surface.mesh.PartGeometry`.

Every change is said in a note. The steps, in order: triangles that cannot be drawn are left out (indices that
are not there, corners that are not finite, no area); a closed body turned inside out is turned back; missing
normals are made, smooth within a crease angle; texture coordinates become millimetres on the surface.

Flakes are counted per square millimetre of texture space, so what matters is that one millimetre there is one
millimetre on the surface, in both directions; seams do not show. Coordinates of a file are kept, scaled,
where they are even enough; else each triangle is projected from the side of a box that it faces, which
stretches by at most √3.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.arrays import AnyArray, AnyIntegers, Bools, Floats, Integers, Reals
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.normals import (
    blocks,
    corner_normals,
    cross_columns,
    edge_columns,
    face_normals,
    index_type,
    is_inside_out,
    packed,
    used_numbers,
    weld,
)

MILLIMETRES = 1000.0
_EVEN = 2.0
_SHARE = 0.8


def stretch(positions: Floats, triangles: AnyIntegers, uvs: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the smallest and largest length in texture space of a unit length on each triangle, and its area.

    All are (k,).

    The lengths are the singular values of the Jacobian from the triangle's plane to texture space; units of ``uvs``
    per unit of ``positions``.
    """
    smallest, largest, area = (np.empty(len(triangles)) for _ in range(3))
    for block in blocks(len(triangles)):
        smallest[block], largest[block], area[block] = _stretch(positions, triangles[block], uvs)
    return smallest, largest, area


def _stretch(positions: Floats, triangles: AnyIntegers, uvs: Floats) -> tuple[Floats, Floats, Floats]:
    # Coordinates that no scale can hold give infinite lengths, or none.
    with np.errstate(over="ignore", invalid="ignore"):
        along, other = edge_columns(positions, triangles)
        base = np.sqrt(np.einsum("ij,ij->j", along, along))
        x_axis = along / base
        shear = np.einsum("ij,ij->j", other, x_axis)
        up = other - shear * x_axis
        height = np.sqrt(np.einsum("ij,ij->j", up, up))
        uv_along, uv_other = edge_columns(uvs, triangles)
        uv_along = uv_along / base
        uv_up = (uv_other - shear * uv_along) / height
        # Singular values of the 2×2 matrix with these columns.
        total = np.einsum("ij,ij->j", uv_along, uv_along) + np.einsum("ij,ij->j", uv_up, uv_up)
        area = np.abs(uv_along[0] * uv_up[1] - uv_along[1] * uv_up[0])
        root = np.sqrt(np.maximum(total * total - 4.0 * area * area, 0.0))
        smallest, largest = np.sqrt(np.maximum(total - root, 0.0) / 2.0), np.sqrt((total + root) / 2.0)
    return smallest, largest, 0.5 * base * height


def uvs_in_millimetres(positions: Floats, triangles: AnyIntegers, uvs: Floats) -> Floats | None:
    """Return ``uvs`` scaled to millimetres, (n, 2), or ``None`` where they are too uneven to be.

    Even enough: on 80 % of the area every length is within a factor of two of the scale chosen.
    """
    if not np.isfinite(uvs).all():
        return None
    smallest, largest, area = stretch(positions, triangles, uvs)
    middle = np.sqrt(smallest * largest)
    order = np.argsort(middle)
    half = np.searchsorted(np.cumsum(area[order]), area.sum() / 2.0)
    scale = float(middle[order][min(int(half), len(order) - 1)])
    if scale <= 0.0 or not np.isfinite(scale):
        return None
    even = (smallest >= scale / _EVEN) & (largest <= scale * _EVEN)
    if area[even].sum() < _SHARE * area.sum():
        return None
    return np.asarray(uvs * (MILLIMETRES / scale))


def box_uvs(positions: Floats, triangles: AnyIntegers) -> tuple[Floats, Integers, AnyIntegers]:
    """Project every triangle along the axis that its normal is nearest to.

    Returns
    -------
    uvs, kept, triangles
        (m, 2) millimetres; (m,) the old vertex of each new one, since a vertex is split where its triangles
        face different sides; (k, 3) new indices.
    """
    corners = np.empty(triangles.shape, index_type(3 * len(positions)))
    for block in blocks(len(triangles)):
        side = np.abs(face_normals(positions, triangles[block])).argmax(axis=1)
        corners[block] = triangles[block] * corners.dtype.type(3) + side[:, None]
    used, numbered = used_numbers(corners, 3 * len(positions))
    del corners
    kept, axis = np.divmod(used, 3)
    del used
    planes = np.array([[2, 1], [0, 2], [0, 1]])
    uvs = np.empty((len(kept), 2))
    for block in blocks(len(kept)):
        uvs[block] = np.take_along_axis(positions[kept[block]], planes[axis[block]], axis=1) * MILLIMETRES
    return uvs, kept, numbered


CREASE_DEG = 40.0
"""Faces that meet at more than this angle keep an edge between them when normals are made."""


@dataclass(frozen=True)
class ForeignLook:
    """The material of a part in a foreign file: its name, and what is known of its look.

    ``colour`` linear red, green and blue, 0…1, ``metallic`` and ``roughness`` 0…1: None where the file does not say,
    or says it by a picture; ``passing`` is the share of light that comes through.
    """

    name: str = ""
    colour: tuple[float, float, float] | None = None
    metallic: float | None = None
    roughness: float | None = None
    passing: float = 0.0


@dataclass(frozen=True, eq=False)
class RawPart:
    """Unchecked data of one part from a file.

    ``positions`` (n, 3) metres, world axes; ``triangles`` (k, 3) indices, of any integer type; ``normals`` (n, 3) or
    ``None``; ``uvs`` (n, 2) in any unit, or ``None``. ``look`` is the file's material, ``material`` ours, to
    be guessed by :func:`brdf_suite.surface.part_materials.guess_materials`.
    """

    name: str
    material: str
    positions: Floats
    triangles: AnyIntegers
    normals: Floats | None = None
    uvs: Floats | None = None
    look: ForeignLook = ForeignLook()


_TRIANGLE_BYTES, _VERTEX_BYTES = 352, 96
"""What reading and repairing take at most: the file's arrays, those of the part, and what is made on the way."""


def repair_bytes(vertices: int, triangles: int) -> int:
    """Return a bound on the memory, bytes, that a part of a file takes until it can be drawn.

    It is reached by triangles without normals and texture coordinates that share no edge, since each of their corners
    becomes a vertex of its own. A test measures that no part takes more.
    """
    return _VERTEX_BYTES * vertices + _TRIANGLE_BYTES * triangles


def repair(raw: RawPart) -> tuple[PartGeometry | None, list[str]]:
    """Return a part that can be drawn and notes on what was changed.

    The part is ``None`` where no triangle is left; the notes then say why.
    """
    notes: list[str] = []
    triangles = _drawable(raw, notes)
    if not len(triangles):
        return None, notes
    name, material, count = raw.name, raw.material, len(raw.positions)
    used, triangles = used_numbers(triangles, count)
    positions = raw.positions[used]
    uvs = raw.uvs[used] if raw.uvs is not None and raw.uvs.shape == (count, 2) else None
    normals: Reals | None = _given_normals(raw, used)
    del raw, used  # the arrays of the file, where the caller does not hold them
    if normals is None:
        welded = weld(positions)
        if is_inside_out(positions, triangles, welded):
            triangles = triangles[:, ::-1]
            notes.append(f"{name}: turned inside out, its triangles faced inwards")
        corners = corner_normals(positions, triangles, welded, CREASE_DEG)
        del welded
        triangles, first, kept = _split(triangles, corners, len(positions))
        normals = np.empty((len(first), 3), np.float32)
        for block in blocks(len(first)):
            normals[block] = corners.reshape(-1, 3).take(first[block], axis=0)
        del corners, first
        positions = positions.take(kept, axis=0)
        uvs = None if uvs is None else uvs[kept]
        del kept
        notes.append(f"{name}: had no normals; made smooth, with edges above {CREASE_DEG:g}°")
    else:
        normals = _mended_normals(name, positions, triangles, normals, notes)

    scaled = None if uvs is None else uvs_in_millimetres(positions, triangles, uvs)
    if scaled is None:
        why = (
            "had no texture coordinates" if uvs is None else "texture coordinates were too uneven for flakes"
        )
        del uvs
        notes.append(f"{name}: {why}; projected from the sides of a box, in millimetres")
        scaled, kept, triangles = box_uvs(positions, triangles)
        drawn: Reals = positions.astype(np.float32)
        del positions
        drawn, normals = drawn.take(kept, axis=0), normals.take(kept, axis=0)
    else:
        drawn = positions
    return PartGeometry(name, material, drawn, normals, scaled, triangles), notes


def _drawable(raw: RawPart, notes: list[str]) -> AnyIntegers:
    """Return the triangles that exist, are finite and have an area."""
    triangles = np.asarray(raw.triangles).reshape(-1, 3)
    positions = raw.positions
    if len(triangles) and not 0 <= triangles.min() <= triangles.max() < len(positions):
        present: Bools = np.all((triangles >= 0) & (triangles < len(positions)), axis=1)
        notes.append(f"{raw.name}: left out {_count(~present)} with corners that are not in the file")
        triangles = triangles[present]
    # Beyond 1e12 m single precision has nothing left to draw with.
    if len(positions) and not -1e12 < positions.min() <= positions.max() < 1e12:
        sound = np.all(np.abs(positions) < 1e12, axis=1)
        if not sound[triangles].all():
            finite: Bools = np.all(sound[triangles], axis=1)
            notes.append(f"{raw.name}: left out {_count(~finite)} with corners that are not finite")
            triangles = triangles[finite]
    flat = np.empty(len(triangles), np.bool_)
    for block in blocks(len(triangles)):
        one, other = edge_columns(positions, triangles[block])
        longest = np.maximum.reduce([np.einsum("jk,jk->k", edge, edge) for edge in (one, other, other - one)])
        normal = cross_columns(one, other)
        flat[block] = np.sqrt(np.einsum("jk,jk->k", normal, normal)) <= 1e-10 * longest
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
    normals = np.empty((len(used), 3))
    usable = 0
    for block in blocks(len(used)):
        given = raw.normals[used[block]]
        given[~np.isfinite(given)] = 0.0
        length = np.sqrt(np.einsum("ij,ij->i", given, given))[:, None]
        good = (length > 1e-6) & (length < 1e12)
        usable += int(good.sum())
        normals[block] = np.where(good, given / np.where(good, length, 1.0), 0.0)
    return normals if usable >= 0.5 * len(used) else None


def _mended_normals(
    name: str, positions: Floats, triangles: AnyIntegers, normals: Reals, notes: list[str]
) -> Reals:
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
    positions: Floats, triangles: AnyIntegers, corners: Floats
) -> tuple[Floats, AnyIntegers, Floats, AnyIntegers]:
    """Give each vertex one normal by splitting it where ``corners`` (k, 3, 3) has several.

    Returns positions, triangles, normals and, for each new vertex, the old one.
    """
    made, first, kept = _split(triangles, corners, len(positions))
    return positions[kept], made, corners.reshape(-1, 3)[first], kept


def _split(
    triangles: AnyIntegers, corners: Floats, count: int
) -> tuple[AnyIntegers, AnyIntegers, AnyIntegers]:
    """Return the triangles of :func:`split_corners`; for each new vertex, its first corner and the old vertex."""
    vertices, normals = triangles.reshape(-1), corners.reshape(-1, 3)
    number = index_type(len(vertices))
    facing = np.empty(len(vertices), np.int64)
    for block in blocks(len(vertices)):
        facing[block] = packed(np.round(normals[block] * 1e6).astype(np.int64) + 1_000_000)
    # Most vertices have one normal, and are not sorted: in reverse, the first corner of each is written last.
    first_of = np.full(count, -1, number)
    first_of[vertices[::-1]] = np.arange(len(vertices) - 1, -1, -1, dtype=number)
    several = np.zeros(count, np.bool_)
    for block in blocks(len(vertices)):
        here = vertices[block]
        several[here[facing[block] != facing[first_of[here]]]] = True
    corner = np.flatnonzero(several[vertices]).astype(number)
    facing = facing[corner]
    sorting = np.lexsort((facing, vertices[corner]))
    order, facing = corner[sorting], facing[sorting]
    del corner, sorting
    starts = np.ones(len(order), np.bool_)
    at = vertices[order]
    starts[1:] = (at[1:] != at[:-1]) | (facing[1:] != facing[:-1])
    del facing
    counts = (first_of >= 0).astype(number)
    counts[several] = np.bincount(at[starts], minlength=count)[several]
    begins = np.cumsum(counts, dtype=number) - counts
    total = int(counts.sum())
    del counts
    flat = begins[vertices]
    # Those of one vertex are numbered from its first.
    among = np.cumsum(starts, dtype=number) - number.type(1)
    new = np.flatnonzero(np.diff(at, prepend=-1))
    among -= np.repeat(among[new], np.diff(np.append(new, len(order))))
    flat[order] += among
    del among, new, at
    first = np.empty(total, number)
    plain = np.flatnonzero((first_of >= 0) & ~several)
    first[begins[plain]] = first_of[plain]
    starting = order[starts]
    first[flat[starting]] = starting
    return flat.reshape(-1, 3), first, vertices[first]


def shape_mesh(mesh: Mesh, look: SurfaceLook) -> Mesh:
    """Return ``mesh`` with scale, place and normals of ``look``; the same object where nothing is to be done.

    Texture coordinates are lengths on the surface and grow with it. Where normals are made again, vertices are split at
    edges: ``smooth`` keeps those above 40°, ``flat`` all. ``flip_normals`` turns triangles and normals to the
    other side. Unit and up axis belong to the file and are no matter of this.
    """
    parts = list(mesh.parts)
    if look.normals != "file":
        crease = CREASE_DEG if look.normals == "smooth" else 0.0
        parts = [_with_normals(part, crease) for part in parts]
    if look.flip_normals:
        parts = [replace(p, normals=-p.normals, triangles=p.triangles[:, ::-1]) for p in parts]
    if look.scale != 1.0:
        of_both = ("positions", "uvs")
        parts = [
            replace(p, **{f: getattr(p, f).astype(np.float64) * look.scale for f in of_both}) for p in parts
        ]
    if look.recentre:
        low, high = Mesh(mesh.name, tuple(parts)).bounds()
        shift = np.array([low[0] + high[0], 2.0 * low[1], low[2] + high[2]]) / 2.0
        if np.abs(shift).max() > 1e-7 * np.abs(high - low).max():
            parts = [replace(p, positions=p.positions - shift) for p in parts]
    if all(one is other for one, other in zip(parts, mesh.parts, strict=True)):
        return mesh
    return replace(mesh, parts=tuple(parts))


def raised(vectors: AnyArray) -> AnyArray:
    """Return vectors (n, 3) of axes with z up in those with y up: turned by a quarter about x."""
    return np.stack((vectors[:, 0], vectors[:, 2], -vectors[:, 1]), axis=1)


def _with_normals(part: PartGeometry, crease_deg: float) -> PartGeometry:
    positions, triangles = part.positions.astype(np.float64), part.triangles.astype(np.int64)
    if crease_deg > 0.0:
        corners = corner_normals(positions, triangles, weld(positions), crease_deg)
    else:
        corners = np.repeat(face_normals(positions, triangles)[:, None, :], 3, axis=1)
    # A triangle too thin to have a normal in single precision keeps what its corners had.
    lost = np.linalg.norm(corners, axis=2) < 0.5
    corners[lost] = part.normals[triangles[lost]]
    # Some files wind triangles against their normals; made again, normals stay on the side that they were on.
    given = part.normals[triangles].sum(axis=1)
    corners *= np.where(np.einsum("kd,kd->k", corners.sum(axis=1), given) < 0.0, -1.0, 1.0)[:, None, None]
    made, indices, normals, kept = split_corners(positions, triangles, corners)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return replace(part, positions=made, normals=normals, uvs=part.uvs[kept], triangles=indices)
