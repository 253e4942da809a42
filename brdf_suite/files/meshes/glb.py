"""Binary glTF 2.0 of our own meshes: a small writer, and a reader that takes milliseconds.

Any glTF viewer opens the files: a node, a mesh and one primitive per part, the material word as the name of a
material with a matching look. What glTF does not say is said in ``asset.extras``: texture coordinates are
millimetres (``uv_unit``), and nothing needs repair, so that no mesh library has to be imported to read them.

Layout: 12-byte header, a JSON chunk, a binary chunk with, per part, positions, normals, uvs (float32) and
triangles (uint16 where they fit, else uint32), each aligned to 4 bytes.
"""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.documents.view_settings import TRANSMITTANCE
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import check_made
from brdf_suite.surface.mesh import Mesh, PartGeometry

_MARK = {"brdf_suite_mesh": 1, "uv_unit": "mm"}
_HEADER = struct.Struct("<4sII")
_CHUNK = struct.Struct("<I4s")
_JSON, _BIN = b"JSON", b"BIN\0"
_ARRAY_BUFFER, _ELEMENT_ARRAY_BUFFER = 34962, 34963
_NUMPY: dict[int, np.dtype[Any]] = {5123: np.dtype("<u2"), 5125: np.dtype("<u4"), 5126: np.dtype("<f4")}
_CODES = {kind: code for code, kind in _NUMPY.items()}
_LARGEST_UINT16_INDEX = 65534  # 65535 restarts a primitive

# Base colour (linear), metallic, roughness: how other viewers show the material words.
_LOOKS = {
    word: {"baseColorFactor": list(colour), "metallicFactor": metallic, "roughnessFactor": roughness}
    for word, colour, metallic, roughness in (
        ("paint", (0.20, 0.03, 0.03, 1.0), 0.0, 0.15),
        ("second_paint", (0.03, 0.03, 0.20, 1.0), 0.0, 0.15),
        ("glass", (0.02, 0.025, 0.03, 0.4), 0.0, 0.02),
        ("lens", (0.9, 0.9, 0.9, 0.08), 0.0, 0.02),
        ("rubber", (0.02, 0.02, 0.02, 1.0), 0.0, 0.75),
        ("chrome", (0.75, 0.75, 0.76, 1.0), 1.0, 0.08),
        ("lamp", (0.85, 0.85, 0.85, 1.0), 0.0, 0.05),
        ("tail_lamp", (0.45, 0.02, 0.015, 1.0), 0.0, 0.05),
        ("trim", (0.03, 0.03, 0.03, 1.0), 0.0, 0.55),
        ("cavity", (0.004, 0.004, 0.004, 1.0), 0.0, 1.0),
        ("gap", (0.004, 0.004, 0.004, 1.0), 0.0, 1.0),
        ("neutral", (0.35, 0.35, 0.35, 1.0), 0.0, 0.6),
    )
}


def write_mesh_glb(mesh: Mesh, path: PathLike) -> None:
    """Write ``mesh`` so that :func:`read_own_glb` gives back the same numbers. Same mesh, same bytes.

    Raises :class:`FileError`: the folder is missing or not writeable; an older file of that name is kept.
    """
    document, binary = _document(mesh)
    text = json.dumps(document, separators=(",", ":"), sort_keys=True).encode()
    text += b" " * (-len(text) % 4)
    total = _HEADER.size + 2 * _CHUNK.size + len(text) + len(binary)
    parts = [_HEADER.pack(b"glTF", 2, total), _CHUNK.pack(len(text), _JSON), text]
    parts += [_CHUNK.pack(len(binary), _BIN), binary]
    with replacing(path) as temporary:
        temporary.write_bytes(b"".join(parts))


def _document(mesh: Mesh) -> tuple[dict[str, Any], bytes]:
    materials = sorted({part.material for part in mesh.parts})
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    meshes: list[dict[str, Any]] = []
    binary = bytearray()

    def add(array: NDArray[Any], kind: str, target: int, limits: bool = False) -> int:
        view = {"buffer": 0, "byteOffset": len(binary), "byteLength": array.nbytes, "target": target}
        binary.extend(array.tobytes())
        binary.extend(b"\0" * (-len(binary) % 4))
        code = _CODES[array.dtype.newbyteorder("<")]
        accessor: dict[str, Any] = {"bufferView": len(views), "componentType": code}
        accessor |= {"count": len(array), "type": kind}
        if limits:
            accessor |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
        views.append(view)
        accessors.append(accessor)
        return len(accessors) - 1

    for part in mesh.parts:
        small = len(part.positions) <= _LARGEST_UINT16_INDEX
        indices = part.triangles.reshape(-1).astype("<u2" if small else "<u4")
        attributes = {
            "POSITION": add(part.positions.astype("<f4"), "VEC3", _ARRAY_BUFFER, limits=True),
            "NORMAL": add(part.normals.astype("<f4"), "VEC3", _ARRAY_BUFFER),
            "TEXCOORD_0": add(part.uvs.astype("<f4"), "VEC2", _ARRAY_BUFFER),
        }
        primitive = {
            "attributes": attributes,
            "indices": add(indices, "SCALAR", _ELEMENT_ARRAY_BUFFER),
            "material": materials.index(part.material),
        }
        meshes.append({"name": part.name, "primitives": [primitive]})
    document = {
        "asset": {"version": "2.0", "generator": "BRDF Suite", "extras": _MARK},
        "scene": 0,
        "scenes": [{"name": mesh.name, "nodes": list(range(len(meshes)))}],
        "nodes": [{"name": part.name, "mesh": index} for index, part in enumerate(mesh.parts)],
        "meshes": meshes,
        "materials": [_look(word) for word in materials],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    return document, bytes(binary)


def _look(word: str) -> dict[str, Any]:
    look = _LOOKS[word]
    see_through = {"alphaMode": "BLEND", "doubleSided": True} if word in TRANSMITTANCE else {}
    return {"name": word, "pbrMetallicRoughness": look} | see_through


def split_glb(path: PathLike, data: bytes) -> tuple[dict[str, Any], memoryview]:
    """Return the JSON document and the binary chunk (empty where there is none) of a binary glTF file.

    Raises :class:`FileError`: not binary glTF 2, cut short, or its JSON is damaged; the message gives the byte offset.
    """
    if len(data) < _HEADER.size + _CHUNK.size or data[:4] != b"glTF":
        raise FileError(path, "not a binary glTF file (it does not begin with the letters glTF)", "byte 0")
    _, version, total = _HEADER.unpack_from(data)
    if version != 2:
        raise FileError(path, f"binary glTF of version {version}; only version 2 can be read", "byte 4")
    if total > len(data):
        raise FileError(path, f"cut short: {len(data)} of {total} bytes are there", "byte 8")
    chunks: dict[bytes, memoryview] = {}
    offset = _HEADER.size
    while offset + _CHUNK.size <= total:
        length, kind = _CHUNK.unpack_from(data, offset)
        start = offset + _CHUNK.size
        if start + length > total:
            raise FileError(path, "a chunk reaches past the end of the file", f"byte {offset}")
        chunks.setdefault(kind, memoryview(data)[start : start + length])
        offset = start + length
    document = parse_json(path, bytes(chunks.get(_JSON, b"")), "", f"byte {_HEADER.size}")
    return document, chunks.get(_BIN, memoryview(b""))


def parse_json(path: PathLike, data: bytes, before: str, place: str | None = None) -> dict[str, Any]:
    """Return the JSON object of a glTF file; :class:`FileError`, ``before`` its reason, where it is none."""
    try:
        document = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"{before}its JSON is damaged ({error})", place) from error
    if not isinstance(document, dict):
        raise FileError(path, f"{before}its JSON is not an object", place)
    return document


def is_own(document: dict[str, Any]) -> bool:
    """Return whether a glTF document was written by :func:`write_mesh_glb`, in a version known here."""
    asset = document.get("asset")
    return isinstance(asset, dict) and asset.get("extras") == _MARK


def read_own_glb(path: PathLike, document: dict[str, Any], binary: memoryview, name: str) -> Mesh:
    """Return the mesh of a file of ours, from what :func:`split_glb` gave.

    Raises :class:`FileError`: the file was damaged or changed by hand.
    """
    try:
        primitives = [_only_primitive(document, node) for node in document["nodes"]]
        # Several nodes may show one mesh, of which each is a part.
        made = sum(_part_bytes(document, primitive) for primitive in primitives)
        check_made(path, made, "the triangles of all nodes", "nodes", len(binary))
        parts = []
        for node, primitive in zip(document["nodes"], primitives, strict=True):
            attributes = primitive["attributes"]
            part = PartGeometry(
                name=str(node["name"]),
                material=document["materials"][primitive["material"]]["name"],
                positions=_array(document, binary, attributes["POSITION"], 3),
                normals=_array(document, binary, attributes["NORMAL"], 3),
                uvs=_array(document, binary, attributes["TEXCOORD_0"], 2),
                triangles=_array(document, binary, primitive["indices"], 1).reshape(-1, 3),
            )
            parts.append(part)
        return Mesh(name, tuple(parts))
    except (LookupError, TypeError, AttributeError, OverflowError, ValueError) as error:
        raise FileError(path, f"damaged mesh file ({error})") from error


def _only_primitive(document: dict[str, Any], node: dict[str, Any]) -> dict[str, Any]:
    (primitive,) = document["meshes"][node["mesh"]]["primitives"]
    return dict(primitive)


def _part_bytes(document: dict[str, Any], primitive: dict[str, Any]) -> int:
    """Return what a part takes, which has four bytes a number."""
    named = primitive["attributes"]
    widths = {named["POSITION"]: 3, named["NORMAL"]: 3, named["TEXCOORD_0"]: 2, primitive["indices"]: 1}
    return sum(4 * width * int(document["accessors"][index]["count"]) for index, width in widths.items())


def _array(document: dict[str, Any], binary: memoryview, index: int, width: int) -> NDArray[Any]:
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = _NUMPY[accessor["componentType"]]
    count = accessor["count"] * width
    if count * kind.itemsize != view["byteLength"]:
        raise ValueError(f"accessor {index} and its buffer view differ in length")
    array: NDArray[Any] = np.frombuffer(binary, dtype=kind, count=count, offset=view["byteOffset"])
    return array.reshape(-1, width) if width > 1 else array
