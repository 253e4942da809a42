"""Reading meshes: glTF (``.glb``, ``.gltf``), OBJ, STL and PLY.

Our own ``.glb`` files are read as they are (:mod:`brdf_suite.files.meshes.glb`). glTF files of others are read by
:mod:`brdf_suite.files.meshes.gltf`, the other formats through ``trimesh`` (:mod:`brdf_suite.files.meshes.foreign`), and
:mod:`brdf_suite.surface.repair` makes them drawable. What was
changed or assumed stands in ``Mesh.notes``.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.memory_limit import within_memory
from brdf_suite.files.meshes.foreign import check_stl, gltf_parts, read_parts
from brdf_suite.files.meshes.glb import is_own, read_own_glb, split_glb, write_mesh_glb
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.repair import RawPart, repair

__all__ = ["MESH_ENDINGS", "read_mesh", "write_mesh_glb"]

MESH_ENDINGS = (".glb", ".gltf", ".obj", ".stl", ".ply")

_LARGEST_FILE = 1 << 30
_SMALLEST_M, _LARGEST_M = 0.001, 50.0
METRES = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254}
"""The length of each unit that a file's numbers can be in, metres."""
_UNIT_NAMES = {"m": "metres", "cm": "centimetres", "mm": "millimetres", "in": "inches"}


@within_memory
def read_mesh(path: PathLike, unit: str = "file") -> Mesh:
    """Return the mesh in a file, in metres, every part with normals and texture coordinates in millimetres.

    Parameters
    ----------
    path
        A file whose name ends in one of :data:`MESH_ENDINGS`.
    unit
        The unit of the lengths in the file, one of ``m``, ``cm``, ``mm``, ``in``; ``file``: metres, or what the size
        reports where that is no size for an object in metres.

    Raises
    ------
    FileError
        No such file, not a mesh, damaged, compressed in a way that cannot be read, or without triangles.
    """
    file = Path(path)
    ending = file.suffix.lower()
    if ending not in MESH_ENDINGS:
        known = ", ".join(MESH_ENDINGS)
        raise FileError(path, f"not a mesh file that can be read; the name has to end in one of {known}")
    data = _content(file)
    if ending == ".glb":
        document, binary = split_glb(path, data)
        if is_own(document):
            return _in_unit(read_own_glb(path, document, binary, file.stem), unit)
        return _repaired(path, gltf_parts(path, document, binary), unit)
    if ending == ".gltf":
        return _repaired(path, gltf_parts(path, _gltf_json(path, data), None), unit)
    if ending == ".stl":
        check_stl(path, data)
    return _repaired(path, read_parts(path), unit)


def _content(file: Path) -> bytes:
    try:
        size = file.stat().st_size
        if not file.is_file():
            raise FileError(file, "not a file")
        if size == 0:
            raise FileError(file, "the file is empty")
        if size > _LARGEST_FILE:
            raise FileError(file, f"{size / 2**30:.1f} GiB; meshes of up to 1 GiB can be read")
        return file.read_bytes()
    except OSError as error:
        raise FileError(file, f"cannot be read ({error.strerror or error})") from error


def _gltf_json(path: PathLike, data: bytes) -> dict[str, Any]:
    try:
        document = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"not glTF: its JSON is damaged ({error})") from error
    if not isinstance(document, dict):
        raise FileError(path, "not glTF: its JSON is not an object")
    return document


def _repaired(path: PathLike, raw: list[RawPart], unit: str) -> Mesh:
    if not raw:
        raise FileError(path, "holds no triangles (points or lines alone cannot be drawn)")
    factor, note = _scale(raw) if unit == "file" else (METRES[unit], f"taken as {_UNIT_NAMES[unit]}")
    notes = [note] if note else []
    parts: list[PartGeometry] = []
    for one in raw:
        scaled = RawPart(one.name, one.material, one.positions * factor, one.triangles, one.normals, one.uvs)
        part, said = repair(scaled)
        notes += said
        if part is not None:
            parts.append(part)
    if not parts:
        raise FileError(path, f"no triangle that can be drawn ({'; '.join(notes)})")
    return Mesh(Path(path).stem, tuple(parts), tuple(notes))


def _in_unit(mesh: Mesh, unit: str) -> Mesh:
    """Take the numbers of a mesh in metres for those of another unit."""
    factor = METRES.get(unit, 1.0)
    if factor == 1.0:
        return mesh
    parts = [
        replace(p, positions=p.positions * np.float64(factor), uvs=p.uvs * np.float64(factor))
        for p in mesh.parts
    ]
    return Mesh(mesh.name, tuple(parts), (*mesh.notes, f"taken as {_UNIT_NAMES[unit]}"))


def _scale(raw: list[RawPart]) -> tuple[float, str | None]:
    """Return the factor to metres, and a note where the size in the file cannot be one in metres."""
    points = np.concatenate([one.positions for one in raw])
    points = points[(np.abs(points) < 1e12).all(axis=1)]
    if not len(points):
        return 1.0, None
    size = float(np.ptp(points, axis=0).max())
    if size == 0.0 or _SMALLEST_M <= size <= _LARGEST_M:
        return 1.0, None
    written = f"{size:.3g} m across as written, which no object is"
    if _LARGEST_M < size <= _LARGEST_M * 1000.0:
        return 0.001, f"{written}; taken as millimetres"
    factor = 10.0 ** -round(math.log10(size))
    if not 0.3 <= size * factor <= 3.2:
        factor = 1.0 / size
    return factor, f"{written}; scaled by {factor:g}"
