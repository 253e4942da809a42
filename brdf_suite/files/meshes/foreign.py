"""Meshes of other programs: glTF by an own reader, other formats through ``trimesh``, with plain error messages.

The scene graph is applied, so that the parts stand in world axes. Nothing is repaired here.
"""

from __future__ import annotations

import os
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.meshes.gltf import read_gltf
from brdf_suite.files.meshes.material_words import material_word
from brdf_suite.surface.repair import RawPart

_STL_HEADER, _STL_TRIANGLE = 84, 50
_LARGEST = float(np.finfo(np.float32).max)


def check_stl(path: PathLike, data: bytes) -> None:
    """Refuse a binary STL whose size is not that of the triangles that its header promises.

    Raises
    ------
    FileError
        The file is cut off, or something was appended; with both numbers.
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

    Raises
    ------
    FileError
        The file is damaged or refers to what it does not hold.
    """
    # Imported here: it takes a third of a second, and only meshes of others need it.
    import trimesh

    try:
        scene = trimesh.load_scene(os.fspath(path), process=False)
        names = scene.graph.nodes_geometry
        return [
            _raw_part(path, scene, node) for node in names if _has_faces(scene.geometry[scene.graph[node][1]])
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


def _has_faces(geometry: Any) -> bool:
    return getattr(geometry, "faces", None) is not None and len(geometry.faces) > 0


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
