"""FBX, Collada, 3MF, X3D, AC3D and 3DS, by the Open Asset Import Library.

It turns the axes of FBX, Collada and 3DS to y up, and gives Collada in metres; FBX it scales to metres when asked. What
it leaves out of Collada and 3MF, names and the unit, is read from their text.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.files.meshes.outside.child import import_library
from brdf_suite.files.meshes.outside.values import ReadMesh, ReadPart, Refused, named
from brdf_suite.regular_files import read_bytes

assimp_py = import_library("assimp")

_METRES = {"fbx": 1.0, "dae": 1.0, "x3d": 1.0, "ac": 1.0}
_3MF_UNITS = {
    "micron": 1e-6,
    "millimeter": 1e-3,
    "centimeter": 1e-2,
    "inch": 0.0254,
    "foot": 0.3048,
    "meter": 1.0,
}
_3MF_UNIT = re.compile(rb"<[\w:]*model\b[^>]*?\bunit\s*=\s*[\"'](\w+)[\"']")
_NAMED = re.compile(rb"<(?:node|object)\b([^>]{1,4000})>")
_ATTRIBUTE = re.compile(rb"\b(id|name)\s*=\s*[\"']([^\"']*)[\"']")
_INDICES = re.compile(rb"<(p|v|vcount)(?:\s[^>]{0,1000})?(?<!/)>([^<]*(?:<!)?)")
_NO_INTEGER = re.compile(rb"[^0-9 \t\r\n+-]")
_SKIPPED = (
    (re.compile(rb"<!--"), re.compile(rb"-->")),
    (re.compile(rb"<extra(?:\s[^>]{0,1000})?(?<!/)>"), re.compile(rb"</extra\s*>")),
)
"""What begins and ends a part of a Collada file that holds no indices, whatever stands in it."""
_LONGEST = 1 << 28
_BASE = (
    assimp_py.Process_Triangulate | assimp_py.Process_SortByPType | assimp_py.Process_JoinIdenticalVertices
)


def read(file: Path, options: dict[str, Any]) -> ReadMesh:
    """Return the triangles of all nodes; ``kind`` is the ending that the content asks for."""
    kind = options["kind"]
    text = read_bytes(file) if kind == "dae" else b""
    _check_indices(text)
    flags = _BASE | (assimp_py.Process_GlobalScale if kind == "fbx" else 0)
    try:
        scene = assimp_py.import_file(str(named(file, kind)), flags)
    except (RuntimeError, ValueError, OSError) as error:
        reason = str(error).partition("': ")[2][:160].rstrip(". ") or "no reason is given"
        raise Refused(f"damaged, or of a kind that its library does not read ({reason})") from error
    if kind == "3mf":
        text = _3mf_model(file)
    names = _names(text, kind)
    parts: list[ReadPart] = []
    waiting = [(scene.root_node, np.eye(4))]
    while waiting:
        node, above = waiting.pop()
        matrix = above @ np.array(node.transformation, np.float64).reshape(4, 4)
        for number in node.mesh_indices:
            if not 0 <= number < len(scene.meshes):
                raise Refused("damaged: a node names a mesh that is not there")
            name = names.get(str(node.name), str(node.name))
            part = _part(scene, scene.meshes[number], name, matrix, linear=kind != "3mf")
            if part is not None:
                parts.append(part)
        waiting += [(child, matrix) for child in node.children]
    if kind == "3mf":
        unit = _3MF_UNIT.search(text)
        return ReadMesh(parts, "z", _3MF_UNITS.get(unit[1].decode(), 1e-3) if unit is not None else 1e-3)
    return ReadMesh(parts, "y", _METRES.get(kind))


def _check_indices(text: bytes) -> None:
    """Refuse a Collada file whose indices are no integers: the library would never come past them."""
    for found in _INDICES.finditer(_without_skipped(text)):
        wrong = _NO_INTEGER.search(found[2])
        if wrong is not None:
            line = text.count(b"\n", 0, found.start()) + 1
            raise Refused(f"damaged: the indices <{found[1].decode()}> in line {line} are no integers")


def _without_skipped(text: bytes) -> bytes:
    """Return a Collada file with blanks in place of comments and of other programs' own data, line by line."""
    data = bytearray(text)
    for begins, ends in _SKIPPED:
        at = 0
        while (first := begins.search(data, at)) and (last := ends.search(data, first.end())):
            at = last.end()
            data[first.start() : at] = re.sub(rb"[^\n]", b" ", data[first.start() : at])
    return bytes(data)


def _part(scene: Any, mesh: Any, node: str, matrix: Any, *, linear: bool) -> ReadPart | None:
    if mesh.num_faces == 0 or mesh.num_indices != 3 * mesh.num_faces:
        return None
    positions = np.asarray(mesh.vertices, np.float64).reshape(-1, 3)
    triangles = np.asarray(mesh.indices, np.int64).reshape(-1, 3)
    turn = matrix[:3, :3]
    arrays = {"positions": (positions @ turn.T + matrix[:3, 3]).astype(np.float32)}
    if mesh.normals is not None and abs(np.linalg.det(turn)) > 0.0:
        normals = np.asarray(mesh.normals, np.float64).reshape(-1, 3)
        arrays["normals"] = (normals @ np.linalg.inv(turn)).astype(np.float32)
    if mesh.texcoords and len(mesh.texcoords[0]):
        uvs = np.asarray(mesh.texcoords[0], np.float64).reshape(len(positions), -1)
        arrays["uvs"] = uvs[:, :2].astype(np.float32)
    if np.linalg.det(turn) < 0.0:
        triangles = triangles[:, ::-1]
    arrays["triangles"] = triangles
    known = 0 <= mesh.material_index < len(scene.materials)
    look = _look(scene.materials[mesh.material_index], linear) if known else {}
    return ReadPart(arrays, {"name": node or str(mesh.name), **look})


def _look(material: dict[str, Any], linear: bool) -> dict[str, Any]:
    fields: dict[str, Any] = {"material": str(material.get("NAME", ""))}
    colour = material.get("COLOR_BASE", material.get("COLOR_DIFFUSE"))
    if isinstance(colour, list | tuple) and len(colour) >= 3 and not material.get("TEXTURES"):
        channels = np.clip(np.array(colour[:3], np.float64), 0.0, 1.0)
        fields["colour"] = (channels if linear else channels**2.2).tolist()
    for key, name in (("metallic", "METALLIC_FACTOR"), ("roughness", "ROUGHNESS_FACTOR")):
        if isinstance(material.get(name), float):
            fields[key] = material[name]
    alpha = colour[3] if isinstance(colour, list | tuple) and len(colour) > 3 else 1.0
    opacity = material.get("OPACITY", alpha)
    # Nothing that is to be seen lets all light through; some programs mean the opposite by their number.
    if isinstance(opacity, float) and 0.0 < opacity < 1.0:
        fields["passing"] = 1.0 - opacity
    return fields


def _names(text: bytes, kind: str) -> dict[str, str]:
    """Return what a Collada or 3MF file calls the things that its library names by their identity alone."""
    before = "" if kind == "dae" else "Object_"
    names = {}
    for tag in _NAMED.findall(text):
        said = dict(_ATTRIBUTE.findall(tag))
        if b"id" in said and said.get(b"name"):
            names[before + said[b"id"].decode("utf-8", "replace")] = unescape(
                said[b"name"].decode("utf-8", "replace")
            )
    return names


def _3mf_model(file: Path) -> bytes:
    """Return the model of a 3MF file as text, empty where it cannot be had."""
    try:
        with zipfile.ZipFile(file) as archive:
            for name in archive.namelist():
                if name.lower().endswith(".model"):
                    with archive.open(name) as stream:
                        return stream.read(_LONGEST)
    except (OSError, ValueError, EOFError, zipfile.BadZipFile, NotImplementedError, RuntimeError, zlib.error):
        return b""  # the library has read it nevertheless
    return b""
