"""Atomic writing of triangle meshes with vertex normals and colours as OBJ or PLY.

- Wavefront OBJ (Wavefront Technologies, Object Files): text; colours follow the place of a vertex, as MeshLab, Blender
  and trimesh read them (0 to 1, sRGB codes).
- PLY (Turk, The PLY Polygon File Format): binary, little-endian, with uchar red, green and blue and, where there is
  one, a number of each point under a name of its own.

Neither has a unit or a meaning of its numbers: what is to be known goes into comments.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Reals
from brdf_suite.documents.atomic import write_atomically


@dataclass(frozen=True, eq=False)
class PointMesh:
    """Triangles with shared vertices.

    Attributes
    ----------
    points, normals
        (n, 3); normals are of unit length.
    colours
        (n, 3) uint8, sRGB codes.
    faces
        (m, 3) indices, counter-clockwise seen from outside.
    quantity, values
        A name and (n,) numbers that go with the points; no name where there are none.
    """

    points: Reals
    normals: Reals
    colours: npt.NDArray[np.uint8]
    faces: npt.NDArray[np.integer]
    quantity: str = ""
    values: Reals | None = None


def write_obj(path: str | os.PathLike[str], mesh: PointMesh, comments: Sequence[str] = ()) -> None:
    """Write ``mesh`` as OBJ; raises :class:`FileError` where that cannot be."""
    lines = [f"# {line}" for line in _lines(comments)]
    codes = mesh.colours / 255.0
    lines += [
        f"v {x:.9g} {y:.9g} {z:.9g} {r:.4f} {g:.4f} {b:.4f}"
        for (x, y, z), (r, g, b) in zip(mesh.points.tolist(), codes.tolist(), strict=True)
    ]
    lines += [f"vn {x:.6f} {y:.6f} {z:.6f}" for x, y, z in mesh.normals.tolist()]
    # Places and normals are counted from 1.
    lines += [f"f {a}//{a} {b}//{b} {c}//{c}" for a, b, c in (mesh.faces.astype(int) + 1).tolist()]
    write_atomically(path, ("\n".join(lines) + "\n").encode("utf-8"))


def write_ply(path: str | os.PathLike[str], mesh: PointMesh, comments: Sequence[str] = ()) -> None:
    """Write ``mesh`` as binary PLY; raises :class:`FileError` where that cannot be."""
    fields: list[tuple[str, str]] = [(name, "<f4") for name in ("x", "y", "z", "nx", "ny", "nz")]
    fields += [(name, "u1") for name in ("red", "green", "blue")]
    if mesh.values is not None:
        fields.append((mesh.quantity, "<f4"))
    rows = np.empty(len(mesh.points), np.dtype(fields))
    for axis, name in enumerate(("x", "y", "z")):
        rows[name], rows[f"n{name}"] = mesh.points[:, axis], mesh.normals[:, axis]
    for channel, name in enumerate(("red", "green", "blue")):
        rows[name] = mesh.colours[:, channel]
    if mesh.values is not None:
        rows[mesh.quantity] = mesh.values
    faces = np.empty(len(mesh.faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    faces["count"], faces["corners"] = 3, mesh.faces
    words = {"<f4": "float", "u1": "uchar"}
    header = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {line}" for line in _lines(comments)),
        f"element vertex {len(rows)}",
        *(f"property {words[kind]} {name}" for name, kind in fields),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header",
    ]
    # Readers of a header expect ASCII.
    text = ("\n".join(header) + "\n").encode("ascii", "replace")
    write_atomically(path, text + rows.tobytes() + faces.tobytes())


def _lines(comments: Sequence[str]) -> list[str]:
    """Return comments as single lines for any name."""
    return [" ".join(comment.split()) for comment in comments]
