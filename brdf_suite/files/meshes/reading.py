"""Reading meshes: glTF (``.glb``, ``.gltf``), OBJ, STL and PLY.

Our own ``.glb`` files are read as they are (:mod:`brdf_suite.files.meshes.glb`). glTF files of others are read by
:mod:`brdf_suite.files.meshes.gltf`, the other formats through ``trimesh``; the scene graph is applied, so that parts
stand in world axes, and :mod:`brdf_suite.surface.repair` makes them drawable. What was changed or assumed stands in
``Mesh.notes``.
"""

from __future__ import annotations

import math
import os
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import within_memory
from brdf_suite.files.meshes.glb import is_own, parse_json, read_own_glb, split_glb, write_mesh_glb
from brdf_suite.files.meshes.gltf import material_word, read_gltf
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.repair import RawPart, repair

_STL_HEADER, _STL_TRIANGLE = 84, 50
_LARGEST = float(np.finfo(np.float32).max)


def check_stl(path: PathLike, data: bytes) -> None:
    """Refuse a binary STL whose size is not that of the triangles that its header promises.

    Raises :class:`FileError`: the file is cut off, or something was appended; with both numbers.
    """
    if b"\0" not in data[:4096]:
        return  # text: zero bytes are in every count and in nearly every coordinate of the binary kind
    if len(data) < _STL_HEADER:
        raise FileError(path, f"is cut off within its header of {_STL_HEADER} bytes", f"byte {len(data)}")
    (count,) = struct.unpack("<I", data[80:_STL_HEADER])
    wanted = _STL_HEADER + _STL_TRIANGLE * count
    if wanted != len(data):
        what = "is cut off" if wanted > len(data) else "holds more than its triangles"
        sizes = f"its header promises {count:,} triangles, which take {wanted:,} bytes; it has {len(data):,}"
        raise FileError(path, f"{what}: {sizes}", "byte 80")


def read_parts(path: PathLike) -> list[RawPart]:
    """Return the parts with triangles, in world axes and the unit of the file, unchecked.

    Raises :class:`FileError`: the file is damaged or refers to what it does not hold.
    """
    # Imported here: it takes a third of a second, and only meshes of others need it.
    import trimesh

    try:
        scene = trimesh.load_scene(os.fspath(path), process=False)
        names = scene.graph.nodes_geometry
        faces: dict[str, Any] = {
            node: getattr(scene.geometry[scene.graph[node][1]], "faces", None) for node in names
        }
        return [
            _raw_part(path, scene, node) for node in names if faces[node] is not None and len(faces[node])
        ]
    except FileError:
        raise
    except Exception as error:  # its readers raise whatever a damaged file runs them into
        raise FileError(path, _in_words(error)) from error


def gltf_parts(path: PathLike, document: dict[str, Any], binary: memoryview | None) -> list[RawPart]:
    """Return the parts of a glTF document, as :func:`brdf_suite.files.meshes.gltf.read_gltf`; all faults as
    FileError."""
    try:
        return read_gltf(path, document, binary)
    except FileError:
        raise
    except (OSError, LookupError, TypeError, AttributeError, ValueError, OverflowError, MemoryError) as error:
        raise FileError(path, _in_words(error)) from error


def _in_words(error: Exception) -> str:
    """Return the cause of a library error in plain words; its own text names variables and axes."""
    if isinstance(error, FileNotFoundError) or (isinstance(error, OSError) and error.filename):
        name = Path(str(error.filename)).name if error.filename else "another file"
        return f"needs {name} beside it, which cannot be read ({error.strerror or 'it is not there'})"
    if isinstance(error, LookupError | NameError | AttributeError | TypeError):
        return "damaged: it refers to data that it does not hold"
    if isinstance(error, MemoryError):
        return "damaged, or too large: there is not enough memory for what it announces"
    if isinstance(error, UnicodeError):
        return "damaged: it holds bytes that are no text where text belongs"
    return "damaged, or not the kind of mesh that its name says"


def _raw_part(path: PathLike, scene: Any, node: str) -> RawPart:
    transform, name = scene.graph[node]
    mesh = scene.geometry[name]
    matrix = np.asarray(transform, dtype=np.float64)
    if not np.isfinite(matrix).all():
        raise FileError(path, "its place in the scene is not finite", f"node {node}")
    turn = matrix[:3, :3]
    positions = _finite_or_nan(mesh.vertices)
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise FileError(path, "its points do not have three coordinates each", f"mesh {name}")
    positions = positions @ turn.T + matrix[:3, 3]
    triangles = np.asarray(mesh.faces, dtype=np.int64)
    normals = None
    # trimesh computes normals on demand; only those that came from the file are in its cache by now.
    if "vertex_normals" in mesh._cache and abs(np.linalg.det(turn)) > 0.0:
        normals = _finite_or_nan(mesh.vertex_normals) @ np.linalg.inv(turn)
    if np.linalg.det(turn) < 0.0:
        triangles = triangles[:, ::-1]
    uvs = getattr(mesh.visual, "uv", None)
    uvs = None if uvs is None else np.asarray(uvs, dtype=np.float64)
    material = str(getattr(getattr(mesh.visual, "material", None), "name", None) or "")
    own_name = str(name).lower().endswith(Path(path).suffix.lower())
    label = Path(str(name)).stem if own_name else str(name)
    return RawPart(label, material_word(material, str(name)), positions, triangles, normals, uvs)


def _finite_or_nan(values: Any) -> NDArray[np.float64]:
    """Return the numbers with NaN for all that single precision does not hold.

    Infinity times zero is an invalid operation in a transform, NaN passes through it; the repair leaves
    either out and says so.
    """
    array = np.array(values, dtype=np.float64)
    array[~(np.abs(array) <= _LARGEST)] = np.nan
    return array


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
        return _repaired(path, gltf_parts(path, parse_json(path, data, "not glTF: "), None), unit)
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
    return Mesh(Path(path).stem, tuple(parts), tuple(notes), factor)


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
