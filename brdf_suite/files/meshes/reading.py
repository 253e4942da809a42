"""Reading meshes: glTF, OBJ, STL and PLY, and by optional libraries USD, FBX, Collada, 3MF, X3D, STEP and IGES.

Our own ``.glb`` files are read as they are (:mod:`brdf_suite.files.meshes.glb`). glTF files of others are read by
:mod:`brdf_suite.files.meshes.gltf`, OBJ, STL and PLY through ``trimesh``, the rest in a child process
(:mod:`brdf_suite.files.meshes.outside`); the scene graph is applied, so that parts stand in world axes. Materials are
guessed by :mod:`brdf_suite.surface.part_materials`, and :mod:`brdf_suite.surface.repair` makes parts drawable. What was
changed or assumed stands in ``Mesh.notes``.
"""

from __future__ import annotations

import math
import os
import struct
from collections import deque
from dataclasses import replace
from pathlib import Path, PureWindowsPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view_settings import PARAMETERS
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import check_made
from brdf_suite.files.meshes.glb import is_own, parse_json, read_own_glb, split_glb, write_mesh_glb
from brdf_suite.files.meshes.gltf import read_gltf
from brdf_suite.files.meshes.kinds import MESH_ENDINGS, OUTSIDE, kind_of
from brdf_suite.files.meshes.outside.child import OutsideMesh, read_outside
from brdf_suite.regular_files import check_regular, find_inside, read_bytes, within_memory
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.normals import index_type
from brdf_suite.surface.part_materials import guess_materials
from brdf_suite.surface.repair import ForeignLook, RawPart, raised, repair, repair_bytes
from brdf_suite.surface.standing import guess_up

_STL_HEADER, _STL_TRIANGLE = 84, 50
_MOST_OBJECTS = 256
_LARGEST_LIBRARY = 16 << 20
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


def read_parts(path: PathLike, kind: str, data: bytes) -> list[RawPart]:
    """Return the parts with triangles of an OBJ, STL or PLY file, in world axes and the unit of the file, unchecked.

    Of an OBJ file up to 256 objects, or else groups, are parts of their own; of more, each material is one.

    Raises :class:`FileError`: the file is damaged or refers to what it does not hold.
    """
    # Imported here: it takes a third of a second, and only meshes of others need it.
    import trimesh

    check_regular(path)
    try:
        scene = trimesh.load_scene(
            os.fspath(path), process=False, file_type=kind, resolver=_Beside(path), **_divided(kind, data)
        )
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


class _Beside:
    """What an OBJ file may name beside it, as ``trimesh`` asks for it: a material library, and no picture.

    Pictures have no use here, and Pillow would open whatever format they have.
    """

    def __init__(self, path: PathLike) -> None:
        self._folder = Path(path).resolve().parent

    def get(self, name: str) -> bytes:
        """Return the content of a file in the folder; FileError where it is no library that can be read."""
        named = PureWindowsPath(name.strip())
        file = find_inside(self._folder, named.as_posix())
        if file is None or named.suffix.lower() != ".mtl":
            raise FileError(name, "is no material library in the folder of the mesh")
        return read_bytes(file, _LARGEST_LIBRARY)

    def __getitem__(self, name: str) -> bytes:
        return self.get(name)


def _divided(kind: str, data: bytes) -> dict[str, bool]:
    """Return how an OBJ file is divided into parts beside its materials, as ``trimesh`` takes it."""
    if kind == "obj":
        for start, option in ((b"o", "split_objects"), (b"g", "split_groups")):
            count = data.count(b"\n" + start + b" ") + data.startswith(start + b" ")
            if 1 < count <= _MOST_OBJECTS:
                return {option: True}
    return {}


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
    triangles = np.asarray(mesh.faces)
    if len(triangles) and 0 <= triangles.min() <= triangles.max() < len(positions):
        triangles = triangles.astype(index_type(len(positions)))
    normals = None
    # trimesh computes normals on demand; only those that came from the file are in its cache by now.
    if "vertex_normals" in mesh._cache and abs(np.linalg.det(turn)) > 0.0:
        normals = _finite_or_nan(mesh.vertex_normals) @ np.linalg.inv(turn)
    if np.linalg.det(turn) < 0.0:
        triangles = triangles[:, ::-1]
    uvs = getattr(mesh.visual, "uv", None)
    uvs = None if uvs is None else np.asarray(uvs, dtype=np.float64)
    look = _look(getattr(mesh.visual, "material", None))
    own_name = str(name).lower().endswith(Path(path).suffix.lower())
    label = Path(str(name)).stem if own_name else str(name)
    return RawPart(label, "", positions, triangles, normals, uvs, look)


def _look(material: Any) -> ForeignLook:
    """Return what a material of an OBJ file says (MTL; ``Pm`` and ``Pr`` are those of its extension)."""
    said = getattr(material, "kwargs", None) or {}

    def number(key: str) -> float | None:
        found: Any = said.get(key)
        try:
            value = float(found[0] if isinstance(found, list) else found)
        except (TypeError, ValueError, LookupError):
            return None
        return min(max(value, 0.0), 1.0) if math.isfinite(value) else None

    given = said.get("kd")
    colour = None
    if isinstance(given, list) and len(given) == 3 and np.isfinite(given).all() and "map_kd" not in said:
        red, green, blue = (min(max(float(channel), 0.0), 1.0) for channel in given)
        colour = (red, green, blue)
    opacity, clear = number("d"), number("tr")
    passing = 1.0 - opacity if opacity else clear or 0.0
    name = str(getattr(material, "name", None) or "")
    return ForeignLook(name, colour, number("pm"), number("pr"), passing)


def _finite_or_nan(values: Any) -> NDArray[np.float64]:
    """Return the numbers with NaN for all that single precision does not hold.

    Infinity times zero is an invalid operation in a transform, NaN passes through it; the repair leaves
    either out and says so.
    """
    array = np.array(values, dtype=np.float64)
    array[~(np.abs(array) <= _LARGEST)] = np.nan
    return array


__all__ = ["MESH_ENDINGS", "read_mesh", "write_mesh_glb"]

_LARGEST_FILE = 1 << 30
_SMALLEST_M, _LARGEST_M = 0.001, 50.0
METRES = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254}
"""The length of each unit that a file's numbers can be in, metres."""
_UNIT_NAMES = {"m": "metres", "cm": "centimetres", "mm": "millimetres", "in": "inches"}


_NO_UP = {"obj": "y", "stl": "z", "ply": "z"}
"""Kinds that do not say which axis is up, and the one that is up in most of them."""
TESSELLATION_MM = PARAMETERS["surface.tessellation_mm"].default


@within_memory
def read_mesh(
    path: PathLike, unit: str = "file", up: str = "file", tessellation_mm: float = TESSELLATION_MM
) -> Mesh:
    """Return the mesh in a file, in metres and y up, every part with normals and texture coordinates in millimetres.

    Parameters
    ----------
    path
        A file, usually of one of :data:`MESH_ENDINGS`; its content says of which kind it is.
    unit
        The unit of the lengths in the file, one of ``m``, ``cm``, ``mm``, ``in``; ``file``: as the file says, else
        metres, or what the size reports where that is no size for an object in metres.
    up
        The axis that points up in the file, ``y`` or ``z``; ``file``: as the file says, else where it seems to stand.
    tessellation_mm
        The largest distance of a triangle from the CAD surface that it stands for, millimetres.

    Raises
    ------
    FileError
        No such file, not a mesh, damaged, without triangles, or of a kind whose library is not installed.
    """
    found = _read(path, tessellation_mm)
    return _in_unit(found, unit, up) if isinstance(found, Mesh) else _repaired(path, *found, unit, up)


def _read(path: PathLike, tessellation_mm: float) -> Mesh | tuple[OutsideMesh, str]:
    """Return the mesh in a file of ours, or that of another program and its kind; the file's content is released."""
    file = Path(path)
    data = _content(file)
    kind = kind_of(path, data)
    if kind == "glb":
        document, binary = split_glb(path, data)
        if is_own(document):
            return read_own_glb(path, document, binary, file.stem)
        return OutsideMesh(gltf_parts(path, document, binary), "y", None), kind
    if kind == "gltf":
        return OutsideMesh(gltf_parts(path, parse_json(path, data, "not glTF: "), None), "y", None), kind
    if kind in OUTSIDE:
        found = read_outside(path, OUTSIDE[kind], kind, tessellation_mm)
    else:
        if kind == "stl":
            check_stl(path, data)
        found = OutsideMesh(read_parts(path, kind, data), None, None)
    made = sum(repair_bytes(len(part.positions), len(part.triangles)) for part in found.parts)
    check_made(path, made, "its triangles", held=len(data))
    return found, kind


def _content(file: Path) -> bytes:
    content = read_bytes(file, _LARGEST_FILE)
    if not content:
        raise FileError(file, "the file is empty")
    return content


def _repaired(path: PathLike, found: OutsideMesh, kind: str, unit: str, up: str) -> Mesh:
    if not found.parts:
        raise FileError(path, "holds no triangles (points or lines alone cannot be drawn)")
    corners = _corners(found.parts)
    if unit == "file":
        factor, note = _scale(corners, found.metres or 1.0)
    else:
        factor, note = METRES[unit], f"taken as {_UNIT_NAMES[unit]}"
    notes = [note] if note else []
    is_told = note is None and found.metres is not None
    turned = False
    if up == "file" and found.up is None:
        up = guess_up(corners, _NO_UP[kind])
        turned = up == "z"
        if turned:
            notes.append("taken as z up, which the file does not say")
    turns = (up if up != "file" else found.up) == "z"
    parts: list[PartGeometry] = []
    waiting = deque(guess_materials(found.parts))
    found.parts.clear()
    while waiting:  # each is released as it is repaired
        part, said = repair(_standing(waiting.popleft(), factor, turns))
        notes += said
        if part is not None:
            parts.append(part)
    if not parts:
        raise FileError(path, f"no triangle that can be drawn ({'; '.join(notes)})")
    return Mesh(Path(path).stem, tuple(parts), tuple(notes), None if is_told else factor, turned)


def _standing(part: RawPart, factor: float, turns: bool) -> RawPart:
    """Return a part in metres and y up."""
    positions, normals = part.positions, part.normals
    if factor != 1.0:
        positions = positions * factor
    if turns:
        positions, normals = raised(positions), None if normals is None else raised(normals)
    return replace(part, positions=positions, normals=normals)


def _in_unit(mesh: Mesh, unit: str, up: str) -> Mesh:
    """Take the numbers of a mesh in metres and y up for those of another unit and axis."""
    factor, notes = METRES.get(unit, 1.0), mesh.notes
    parts = mesh.parts
    if up == "z":
        parts = tuple(replace(p, positions=raised(p.positions), normals=raised(p.normals)) for p in parts)
    if factor != 1.0:
        notes = (*notes, f"taken as {_UNIT_NAMES[unit]}")
        parts = tuple(
            replace(p, positions=p.positions * np.float64(factor), uvs=p.uvs * np.float64(factor))
            for p in parts
        )
    return mesh if parts is mesh.parts else Mesh(mesh.name, parts, notes)


def _corners(raw: list[RawPart]) -> NDArray[np.float64]:
    """Return the lowest and the highest corner (2, 3) of all points that can be drawn; (0, 3) where none can."""
    found = []
    for part in raw:
        points = part.positions
        if len(points) and not -1e12 < points.min() <= points.max() < 1e12:
            points = points[(np.abs(points) < 1e12).all(axis=1)]
        if len(points):
            found += [points.min(axis=0), points.max(axis=0)]
    if not found:
        return np.empty((0, 3))
    return np.stack([np.min(found, axis=0), np.max(found, axis=0)])


def _scale(corners: NDArray[np.float64], metres: float) -> tuple[float, str | None]:
    """Return the factor to metres, and a note where the size in the file cannot be one in units of ``metres``."""
    if not len(corners):
        return metres, None
    size = float(np.ptp(corners, axis=0).max()) * metres
    if size == 0.0 or _SMALLEST_M <= size <= _LARGEST_M:
        return metres, None
    written = f"{size:.3g} m across as written, which no object is"
    if _LARGEST_M < size <= _LARGEST_M * 1000.0:
        return 0.001 * metres, f"{written}; taken as millimetres"
    factor = 10.0 ** -round(math.log10(size))
    if not 0.3 <= size * factor <= 3.2:
        factor = 1.0 / size
    return factor * metres, f"{written}; scaled by {factor:g}"
