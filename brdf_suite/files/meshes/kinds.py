"""Which kind of mesh a file holds: by its content, and by its name's ending where the content leaves that open."""

from __future__ import annotations

import io
import re
import struct
import zipfile
from pathlib import PurePath

from brdf_suite.errors import FileError, PathLike

OUTSIDE = {
    **dict.fromkeys(("usda", "usdc", "usdz"), "usd"),
    **dict.fromkeys(("fbx", "dae", "3mf", "x3d", "ac", "3ds"), "assimp"),
    **dict.fromkeys(("step", "iges"), "step"),
}
"""The library that reads a kind, of :data:`brdf_suite.files.meshes.outside.child.LIBRARIES`."""
_ENDINGS = {
    **{ending: ending for ending in ("glb", "gltf", "obj", "stl", "ply", *OUTSIDE)},
    **{"usd": "usdc", "stp": "step", "igs": "iges", "p21": "step"},
}
CAD_ENDINGS = tuple(f".{ending}" for ending, kind in _ENDINGS.items() if OUTSIDE.get(kind) == "step")
"""Of files whose surfaces are cut into triangles on reading."""
MESH_ENDINGS = (
    *(".glb", ".gltf", ".obj", ".stl", ".ply", ".usd", ".usda", ".usdc", ".usdz", ".fbx", ".dae", ".3mf"),
    *(".step", ".stp", ".iges", ".igs", ".x3d", ".ac", ".3ds"),
)
"""The usual endings of files that can be read."""

_STARTS = {
    b"glTF": "glb",
    b"ply\n": "ply",
    b"ply\r": "ply",
    b"Kaydara FBX Binary": "fbx",
    b"; FBX": "fbx",
    b"PXR-USDC": "usdc",
    b"#usda": "usda",
    b"ISO-10303-21": "step",
    b"AC3D": "ac",
}
_OTHERS = {
    b"BLENDER": "a Blender file",
    b"3D Geometry File Format": "a Rhino file",
    b"Version 8.1 JT": "a JT file",
    b"Version 9": "a JT file",
    b"Version 10": "a JT file",
    b"AC10": "an AutoCAD drawing",
    b"V_CFV2": "a CATIA file",
    b"\xd0\xcf\x11\xe0": "a file of a CAD program",
}
"""What is known and not read, by its beginning."""
_STL_HEADER, _STL_TRIANGLE = 84, 50
_OBJ_LINE = re.compile(rb"^(?:v|vn|vt|f|o|g|usemtl|mtllib)\s", re.MULTILINE)


def kind_of(path: PathLike, data: bytes) -> str:
    """Return the kind of a mesh: a key of :data:`OUTSIDE`, or ``glb``, ``gltf``, ``obj``, ``stl``, ``ply``.

    Raises :class:`FileError`: neither content nor ending is that of a mesh that can be read; with the way on.
    """
    ending = PurePath(path).suffix.lower()
    found = _by_content(data) or _ENDINGS.get(ending.removeprefix("."))
    if found is not None:
        return found
    known = next((what for start, what in _OTHERS.items() if data.startswith(start)), None)
    what = f"{known}, which cannot be read" if known else "of no kind of mesh that can be read"
    raise FileError(path, f"{what}; export it as glTF, FBX, USD, STEP, OBJ, STL or PLY")


def _by_content(data: bytes) -> str | None:
    for start, kind in _STARTS.items():
        if data.startswith(start):
            return kind
    head = data[:4096].lstrip(b"\xef\xbb\xbf \t\r\n")
    if head.startswith(b"{"):
        return "gltf"
    if head.startswith(b"<"):
        return "dae" if b"<COLLADA" in head else "x3d" if b"<X3D" in head else None
    if data.startswith(b"PK\x03\x04"):
        return _in_archive(data)
    if len(data) >= _STL_HEADER and b"\0" in data[:_STL_HEADER]:
        (count,) = struct.unpack("<I", data[80:_STL_HEADER])
        if _STL_HEADER + _STL_TRIANGLE * count == len(data):
            return "stl"
    if head.startswith(b"solid") and b"facet" in data[: 1 << 16]:
        return "stl"
    if data[:2] == b"MM" and len(data) >= 6 and struct.unpack("<I", data[2:6])[0] == len(data):
        return "3ds"
    if len(data) > 80 and data[72:73] == b"S" and data[73:80].strip() == b"1":
        return "iges"
    if b"\0" not in data[:4096] and len(_OBJ_LINE.findall(data[: 1 << 16])) >= 3:
        return "obj"
    return None


def _in_archive(data: bytes) -> str | None:
    try:
        names = [name.lower() for name in zipfile.ZipFile(io.BytesIO(data)).namelist()]
    except (zipfile.BadZipFile, ValueError, NotImplementedError, struct.error):
        return None
    if any(name.endswith(".model") for name in names):
        return "3mf"
    if names and names[0].endswith((".usd", ".usda", ".usdc")):
        return "usdz"
    return None
