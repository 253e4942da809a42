"""A lobe surface as a mesh for export: no duplicate points, with its unit and origin in words."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from brdf_suite.errors import ValueRangeError
from brdf_suite.files.meshes.writing import PointMesh, write_obj, write_ply
from brdf_suite.inspection.lobe_surface.surface import LobeSurface, RadiusScale, grid_faces

MESH_ENDINGS = (".obj", ".ply")


def surface_mesh(surface: LobeSurface, size: float = 1.0) -> PointMesh:
    """Return the surface with radius 1 made ``size`` long; points in holes, and those that are doubled, are left out.

    The mirror direction, where all columns meet, is one point, and the last column is the first.
    """
    rows, columns = surface.shape
    place = np.arange(rows * columns).reshape(rows, columns)
    place[:, -1] = place[:, 0]
    place[0] = 0
    faces = place.reshape(-1)[surface.faces if surface.holes else grid_faces(rows, columns)]
    # The fan about the mirror direction leaves nothing where two corners became one.
    corners = np.sort(faces, axis=1)
    faces = faces[(corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2])]
    used, again = np.unique(faces, return_inverse=True)
    return PointMesh(
        size * surface.points.reshape(-1, 3)[used],
        surface.normals.reshape(-1, 3)[used],
        surface.colours.reshape(-1, 3)[used],
        again.reshape(-1, 3).astype(np.int32),
        "value",
        surface.values.reshape(-1)[used],
    )


def write_surface(
    path: str | os.PathLike[str], surface: LobeSurface, about: tuple[str, ...] = (), size: float = 1.0
) -> None:
    """Write a surface as OBJ or PLY, by the ending of ``path``; ``about`` are lines on what it is.

    Raises
    ------
    ValueRangeError
        Another ending, or a surface without a face.
    FileError
        The file cannot be written.
    """
    ending = Path(path).suffix.lower()
    if ending not in MESH_ENDINGS:
        raise ValueRangeError("path", f"a surface is written as {' or '.join(MESH_ENDINGS)}, not {ending!r}")
    mesh = surface_mesh(surface, size)
    if not len(mesh.faces):
        raise ValueRangeError("surface", "has no value in any direction, so that there is nothing to write")
    comments = ("BRDF Suite, a lobe surface", *about, *scale_words(surface.scale, size))
    (write_obj if ending == ".obj" else write_ply)(path, mesh, comments)


def scale_words(scale: RadiusScale, size: float = 1.0) -> tuple[str, ...]:
    """Return what lengths mean, in ASCII."""
    how = {
        "linear": "radius = value / full",
        "cbrt": "radius = cube root of (value / full)",
        "log": f"radius = 1 + log10(value / full) / {scale.decades:g}, at least 0",
    }[scale.kind]
    return (
        f"a length of {size:g} is radius 1; full = {scale.full:.9g} 1/sr; {how}",
        "x along the tangent, z along the normal of the surface",
    )
