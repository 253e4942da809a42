"""glTF 2.0 reader: triangles, normals, texture coordinates, and materials without their textures.

Source: Khronos Group, glTF 2.0 Specification, with the extensions for quantized and compressed meshes (Draco's in a
child process) and KHR_materials_transmission. Textures, cameras, animations, skins and morph targets are not read. The
scene graph is walked once, each node's matrix being its parent's times its own.
"""

from __future__ import annotations

import base64
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Integers
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import check_made, most_made_bytes
from brdf_suite.files.meshes.meshopt import decode_view
from brdf_suite.files.meshes.outside.child import OutsidePart, decode_draco
from brdf_suite.regular_files import find_inside, read_bytes
from brdf_suite.surface.normals import index_type
from brdf_suite.surface.repair import ForeignLook, RawPart, repair_bytes

_MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
_DRACO = "KHR_draco_mesh_compression"
NO_SHAPE_PREFIXES = (
    "KHR_materials_",
    "ADOBE_materials_",
    "KHR_texture_",
    "KHR_xmp",
    "KHR_lights_",
    "EXT_lights_",
)
NO_SHAPE = frozenset(
    {
        "EXT_materials_specular_edge_color",
        "EXT_mesh_features",
        "EXT_mesh_manifold",
        "EXT_structural_metadata",
        "EXT_texture_astc",
        "EXT_texture_avif",
        "EXT_texture_webp",
        "KHR_animation_pointer",
        "KHR_node_hoverability",
        "KHR_node_selectability",
        "KHR_techniques_webgl",
        "MSFT_packing_normalRoughnessMetallic",
        "MSFT_packing_occlusionRoughnessMetallic",
        "MSFT_texture_dds",
    }
)
"""Extensions, with those of :data:`NO_SHAPE_PREFIXES`, that change neither triangles nor where they stand."""
_DECODED = frozenset({"KHR_mesh_quantization", _DRACO, *_MESHOPT})

_COMPONENTS: dict[int, np.dtype[Any]] = {
    5120: np.dtype("i1"),
    5121: np.dtype("u1"),
    5122: np.dtype("<i2"),
    5123: np.dtype("<u2"),
    5125: np.dtype("<u4"),
    5126: np.dtype("<f4"),
}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
_USED = ("POSITION", "NORMAL", "TEXCOORD_0")

_MOST_UNSTORED = 1 << 24
"""Bytes of values that are zero because the file does not hold them; repair makes many times as much of triangles."""
_SEPARATE, _MOST_TOGETHER, _MOST_TRIANGLES = 64, 1 << 16, 1 << 17
"""Instances of one primitive; vertices and triangles of instances that are joined to one part where there are more."""
_MOST_PACKED = 8
"""Times that compressed values count as bytes held by a file; zeros are compressed to much less."""


def read_gltf(path: PathLike, document: dict[str, Any], binary: memoryview | None) -> list[RawPart]:
    """Return the parts of a glTF document with triangles, in world axes and the unit of the file, unchecked.

    ``binary`` is the binary chunk of a ``.glb``. One part for each primitive of each node; a primitive that has more
    than 64 instances is joined to parts of up to 65,536 vertices and 131,072 triangles.

    What all nodes make is counted before it is made, by :func:`brdf_suite.surface.repair.repair_bytes`, against the
    limit of :func:`brdf_suite.files.bounded_reading.check_made`. A file holds its buffers and what its compressed
    values decode to, at most 8 times their size.

    Raises
    ------
    FileError
        An extension is required that is not decoded, something is damaged, or what it announces is too large.
    OSError, LookupError, TypeError, ValueError
        A buffer beside it cannot be read, or it refers to what it does not hold.
    """
    _check_extensions(path, document)
    places: dict[tuple[int, int], list[Floats]] = {}
    for mesh, matrix in _walk(path, document):
        for number, primitive in enumerate(_at(document["meshes"], mesh)["primitives"]):
            if primitive.get("mode", _TRIANGLES) in (_TRIANGLES, _STRIP, _FAN):
                places.setdefault((mesh, number), []).append(matrix)
    primitives = _Primitives(path, document, binary)
    primitives.decompress(list(places))
    parts: list[RawPart] = []
    total = 0
    for key, matrices in places.items():
        total += len(matrices) * repair_bytes(*primitives.sizes(*key))
        check_made(path, total, "the triangles of all nodes", "nodes", primitives.held_bytes)
        part = primitives.read(*key)
        if not len(part.triangles) or not len(part.positions):
            continue
        most = min(_MOST_TOGETHER // len(part.positions), _MOST_TRIANGLES // len(part.triangles))
        together = 1 if len(matrices) <= _SEPARATE else max(1, most)
        for first in range(0, len(matrices), together):
            parts.append(_placed(part, np.array(matrices[first : first + together])))
    return parts


def _check_extensions(path: PathLike, document: dict[str, Any]) -> None:
    required = document.get("extensionsRequired", [])
    for name in required if isinstance(required, list) else []:
        if name not in _DECODED and name not in NO_SHAPE and not str(name).startswith(NO_SHAPE_PREFIXES):
            shown = str(name)[:80] if str(name).isprintable() else repr(str(name)[:80])
            reason = f"it requires the extension {shown}, which is not read; export it again without"
            raise FileError(path, reason, "extensionsRequired")


# The scene graph.


def _walk(path: PathLike, document: dict[str, Any]) -> Iterator[tuple[int, Floats]]:
    """Yield the mesh of each node of the scene that has one, and its matrix (4, 4) to world axes."""
    nodes = document.get("nodes", [])
    if not isinstance(nodes, list) or not all(isinstance(node, dict) for node in nodes):
        raise FileError(path, "not a list of objects", "nodes")
    parents = [-1] * len(nodes)
    for place, node in enumerate(nodes):
        for child in node.get("children", []):
            if not isinstance(child, int) or not 0 <= child < len(nodes):
                raise FileError(path, "a child that is not there", f"nodes[{place}].children")
            if parents[child] >= 0:
                raise FileError(path, "a child of two nodes", f"nodes[{place}].children")
            parents[child] = place
    roots = [place for place, parent in enumerate(parents) if parent < 0]
    order = list(roots)
    for place in order:  # grows as it is walked
        order += nodes[place].get("children", [])
    if len(order) < len(nodes):
        raise FileError(path, "the scene graph runs in a circle", "nodes")
    local = _local_matrices(path, nodes)
    scenes = document.get("scenes")
    shown = _at(scenes, document.get("scene", 0)).get("nodes", []) if scenes else roots
    if any(_at(parents, place) >= 0 for place in shown) or len(set(shown)) < len(shown):
        raise FileError(path, "a scene names a node twice, or one that stands below another", "scenes")
    waiting = [(place, np.eye(4)) for place in shown]
    while waiting:
        place, above = waiting.pop()
        node = _at(nodes, place)
        with np.errstate(over="ignore", invalid="ignore"):
            matrix = above @ local[place]
        if "mesh" in node:
            if not np.isfinite(matrix).all():
                raise FileError(path, "its place in the scene is not finite", f"nodes[{place}]")
            yield node["mesh"], matrix
        waiting += [(child, matrix) for child in node.get("children", [])]


def _local_matrices(path: PathLike, nodes: list[dict[str, Any]]) -> Floats:
    """Return (n, 4, 4): the matrix of each node, or its translation times rotation times scale."""
    count = len(nodes)
    shift, scale, turn = np.zeros((count, 3)), np.ones((count, 3)), np.tile([0.0, 0.0, 0.0, 1.0], (count, 1))
    whole: dict[int, Floats] = {}
    for place, node in enumerate(nodes):
        try:
            if "matrix" in node:
                whole[place] = np.array(node["matrix"], np.float64).reshape(4, 4).T
            for key, rows in (("translation", shift), ("scale", scale), ("rotation", turn)):
                if key in node:
                    rows[place] = node[key]
        except (TypeError, ValueError, OverflowError) as error:
            raise FileError(
                path, "its matrix, translation, rotation or scale is damaged", f"nodes[{place}]"
            ) from error
    with np.errstate(all="ignore"):
        x, y, z, w = (turn / np.linalg.norm(turn, axis=1, keepdims=True)).T
    rotation = np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
            [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
            [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )
    result = np.zeros((count, 4, 4))
    result[:, 3, 3] = 1.0
    with np.errstate(all="ignore"):
        result[:, :3, :3] = np.moveaxis(rotation, 2, 0) * scale[:, None, :]
    result[:, :3, 3] = shift
    for place, matrix in whole.items():
        result[place] = matrix
    return result


def _placed(part: RawPart, matrices: Floats) -> RawPart:
    """Return the instances of a part at ``matrices`` (n, 4, 4), joined."""
    turns, count = matrices[:, :3, :3], len(part.positions)
    # What is not finite stays what it is, without a warning; the repair leaves it out and says so.
    with np.errstate(all="ignore"):
        positions = part.positions @ np.swapaxes(turns, 1, 2) + matrices[:, None, :3, 3]
        turned = np.linalg.det(turns)
        normals = None
        if part.normals is not None and (turned != 0.0).all():
            normals = (part.normals @ np.linalg.inv(turns)).reshape(-1, 3)
    total = len(matrices) * count
    triangles = np.empty((len(matrices), *part.triangles.shape), index_type(total))
    for place, rows in enumerate(triangles):
        rows[:] = part.triangles[:, ::-1] if turned[place] < 0.0 else part.triangles
        if place:
            np.add(rows, place * count, out=rows, where=rows >= 0)
    uvs = None if part.uvs is None else np.tile(part.uvs, (len(matrices), 1))
    return replace(
        part,
        positions=positions.reshape(-1, 3),
        triangles=triangles.reshape(-1, 3),
        normals=normals,
        uvs=uvs,
    )


# Values.


class _Primitives:
    """Reader of a document's primitives from its buffers."""

    def __init__(self, path: PathLike, document: dict[str, Any], binary: memoryview | None) -> None:
        self._path, self._document, self._binary = path, document, binary
        self._buffers: dict[int, memoryview] = {}
        self._files: dict[Path, memoryview] = {}
        self.held_bytes = 0
        self._decoded: dict[int, memoryview] = {}
        self._decoded_bytes = 0
        self._draco: dict[tuple[int, int], OutsidePart] = {}

    def decompress(self, keys: list[tuple[int, int]]) -> None:
        """Decode the primitives, of those with these (mesh, number), that are stored with Draco: all in one go."""
        wanted: dict[int, list[tuple[int, int]]] = {}
        for mesh, number in keys:
            stored = _extension(self._document["meshes"][mesh]["primitives"][number], _DRACO)
            if stored is not None:
                wanted.setdefault(stored["bufferView"], []).append((mesh, number))
        if not wanted:
            return
        chunks = [bytes(self._view(view)) for view in wanted]
        for found, chunk, those in zip(
            decode_draco(self._path, chunks), chunks, wanted.values(), strict=True
        ):
            self._count_packed(sum(array.nbytes for array in found.arrays.values()), len(chunk))
            self._draco.update(dict.fromkeys(those, found))

    def sizes(self, mesh: int, number: int) -> tuple[int, int]:
        """Return how many vertices and triangles a primitive announces; its buffers are read."""
        primitive = self._document["meshes"][mesh]["primitives"][number]
        draco = self._draco.get((mesh, number))
        if draco is not None:
            vertices = max((len(array) for name, array in draco.arrays.items() if name != "faces"), default=0)
            return vertices, len(draco.arrays["faces"])
        indices = [primitive["indices"]] if "indices" in primitive else []
        named = [primitive["attributes"][key] for key in _USED if key in primitive["attributes"]]
        counts = {index: self._announced(index) for index in named + indices}
        vertices = max((counts[index] for index in named), default=0)
        corners = counts[indices[0]] if indices else vertices
        return vertices, corners // 3 if primitive.get("mode", _TRIANGLES) == _TRIANGLES else corners

    def _announced(self, index: int) -> int:
        """Return how many values an accessor announces; its buffer is read, and too many refused."""
        accessor, place = _at(self._document["accessors"], index), f"accessors[{index}]"
        width = _WIDTHS[accessor["type"]]
        count = self._whole(accessor, "count", place)
        if "bufferView" in accessor:
            self._stored(accessor, _COMPONENTS[accessor["componentType"]], count, width, place)
            check_made(self._path, 8 * count * width, f"its {count:,} values", place, self.held_bytes)
        else:
            check_made(self._path, 8 * count * width, f"its {count:,} values", place)
            if 8 * count * width > _MOST_UNSTORED:
                reason = f"its {count:,} values are not in the file; {_MOST_UNSTORED // (8 * width):,} may be left out"
                raise FileError(self._path, reason, place)
        return count

    def _count_packed(self, decoded: int, stored: int) -> None:
        self.held_bytes += min(decoded, _MOST_PACKED * stored)

    def read(self, mesh: int, number: int) -> RawPart:
        """Return a primitive in its own axes; its normals and texture coordinates where it has as many as positions."""
        found = self._document["meshes"][mesh]
        primitive = found["primitives"][number]
        values = self._attributes(primitive, self._draco.get((mesh, number)))
        positions = values["POSITION"]
        if positions.shape[1] != 3:
            raise FileError(self._path, "its points do not have three coordinates each", f"meshes[{mesh}]")
        positions[~(np.abs(positions) <= np.finfo(np.float32).max)] = np.nan
        with np.errstate(invalid="ignore"):  # a number that is none becomes no corner, and is left out below
            corners = values.get("indices", np.arange(len(positions))).ravel().astype(np.int64)
        normals, uvs = values.get("NORMAL"), values.get("TEXCOORD_0")
        if uvs is not None:
            uvs[:, 1] = 1.0 - uvs[:, 1]  # glTF counts v downwards
        name = str(found.get("name", f"mesh {mesh}")) + (f"_{number}" if number else "")
        look = ForeignLook()
        if "material" in primitive:
            look = _look(_at(self._document["materials"], primitive["material"]))
        mode = _TRIANGLES if (mesh, number) in self._draco else primitive.get("mode", _TRIANGLES)
        triangles = _triangles(corners, mode)
        # The repair leaves these out and reports them; moved by the number of vertices, they would hit other instances.
        triangles[((triangles < 0) | (triangles >= len(positions))).any(axis=1)] = -1
        triangles = triangles.astype(index_type(len(positions)))
        return RawPart(name, "", positions, triangles, normals, uvs, look)

    def _attributes(self, primitive: dict[str, Any], draco: OutsidePart | None) -> dict[str, Floats]:
        """Return the values that are used of a primitive by name, ``indices`` among them."""
        named = {key: primitive["attributes"][key] for key in _USED if key in primitive["attributes"]}
        if draco is None:
            if "indices" in primitive:
                named["indices"] = primitive["indices"]
            return {key: self._values(index) for key, index in named.items()}
        numbers = primitive["extensions"][_DRACO]["attributes"]
        values: dict[str, Floats] = {"indices": draco.arrays["faces"].astype(np.float64)}
        for key, index in named.items():
            if key in numbers:
                stored = draco.arrays[f"attribute {int(numbers[key])}"]
                accessor = _at(self._document["accessors"], index)
                with np.errstate(invalid="ignore"):
                    values[key] = _fractions(stored.astype(np.float64), stored.dtype, accessor)
        return values

    def _values(self, index: int) -> Floats:
        """Return the values (count, width) of an accessor, normalized integers as the fractions that they represent."""
        accessor, place = _at(self._document["accessors"], index), f"accessors[{index}]"
        kind, width = _COMPONENTS[accessor["componentType"]], _WIDTHS[accessor["type"]]
        count = self._announced(index)
        if "bufferView" in accessor:
            with np.errstate(invalid="ignore"):  # of numbers that are none
                values = self._stored(accessor, kind, count, width, place).astype(np.float64)
        else:
            values = np.zeros((count, width))
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            changed = self._whole(sparse, "count", place)
            at = self._stored(
                sparse["indices"], _COMPONENTS[sparse["indices"]["componentType"]], changed, 1, place
            )
            values[at[:, 0].astype(np.int64)] = self._stored(sparse["values"], kind, changed, width, place)
        return _fractions(values, kind, accessor)

    def _stored(
        self, fields: dict[str, Any], kind: np.dtype[Any], count: int, width: int, place: str
    ) -> NDArray[Any]:
        """Return a view of values (count, width) in a buffer view, as an accessor's ``fields`` place them in it."""
        content = self._view(fields["bufferView"])
        item = kind.itemsize * width
        start = self._whole(fields, "byteOffset", place, 0)
        stride = (
            self._whole(self._document["bufferViews"][fields["bufferView"]], "byteStride", place, item)
            or item
        )
        if count and start + stride * (count - 1) + item > len(content):
            raise FileError(self._path, "its values reach past the end of the file", place)
        strides = (stride, kind.itemsize)
        return np.ndarray((count, width), kind, content, start if count else 0, strides)

    def _view(self, index: Any) -> memoryview:
        """Return the content of a buffer view, decoded where it is compressed."""
        view, place = _at(self._document["bufferViews"], index), f"bufferViews[{index}]"
        packed = next((found for name in _MESHOPT if (found := _extension(view, name)) is not None), None)
        if packed is None:
            return self._slice(view, place)
        if index not in self._decoded:
            count, stride = self._whole(packed, "count", place), self._whole(packed, "byteStride", place)
            self._decoded_bytes += count * stride
            check_made(self._path, self._decoded_bytes, "what its compressed views hold", place)
            stored = self._slice(packed, place)
            try:
                content = decode_view(stored, count, stride, packed["mode"], packed.get("filter", "NONE"))
            except (ValueError, LookupError) as error:
                raise FileError(self._path, f"its meshopt compression is damaged ({error})", place) from error
            self._decoded[index] = memoryview(content)
            self._count_packed(len(content), len(stored))
        return self._decoded[index]

    def _slice(self, fields: dict[str, Any], place: str) -> memoryview:
        buffer = self._buffer(fields["buffer"])
        begin = self._whole(fields, "byteOffset", place, 0)
        length = self._whole(fields, "byteLength", place)
        if begin + length > len(buffer):
            raise FileError(self._path, "reaches past the end of the file", place)
        return buffer[begin : begin + length]

    def _whole(self, fields: dict[str, Any], key: str, place: str, default: int | None = None) -> int:
        value = fields[key] if default is None else fields.get(key, default)
        if not isinstance(value, int) or not 0 <= value < 1 << 48:
            raise FileError(self._path, f"{key} is {str(value)[:40]}, which is no size or place", place)
        return value

    def _buffer(self, index: int) -> memoryview:
        if index not in self._buffers:
            self._buffers[index] = self._opened(index)
        return self._buffers[index]

    def _opened(self, index: int) -> memoryview:
        place = f"buffers[{index}]"
        uri = _at(self._document["buffers"], index).get("uri")
        if uri is None:
            if index != 0 or self._binary is None:
                raise IndexError(index)
            self.held_bytes += len(self._binary)
            return self._binary
        if uri.startswith("data:"):
            content = memoryview(base64.b64decode(uri.partition(",")[2]))
            self.held_bytes += len(content)
            return content
        folder = Path(self._path).resolve().parent
        file = find_inside(folder, unquote(uri))
        if file is None:
            raise FileError(self._path, f"refers to {uri[:80]}, which is not in its folder", place)
        if file not in self._files:  # several buffers may name it
            taken = sum(len(content) for content in self._files.values())
            try:
                self._files[file] = memoryview(read_bytes(file, most_made_bytes() - taken))
            except FileError as error:
                raise FileError(
                    self._path, f"needs {file.name} beside it, which {error.reason}", place
                ) from error
            self.held_bytes += len(self._files[file])
        return self._files[file]


def _fractions(values: Floats, kind: np.dtype[Any], accessor: dict[str, Any]) -> Floats:
    """Return values of an accessor, normalized integers as the fractions that they represent."""
    if accessor.get("normalized") and kind.kind in "iu":
        return np.asarray(np.maximum(values / np.iinfo(kind).max, -1.0))
    return values


def _extension(fields: dict[str, Any], name: str) -> dict[str, Any] | None:
    """Return what an extension says of an object, None where it says nothing."""
    found = fields.get("extensions", {}).get(name)
    return found if isinstance(found, dict) else None


def _look(material: dict[str, Any]) -> ForeignLook:
    metal = material.get("pbrMetallicRoughness", {})
    gloss = _extension(material, "KHR_materials_pbrSpecularGlossiness")
    factor = (
        metal.get("baseColorFactor", [1.0] * 4) if gloss is None else gloss.get("diffuseFactor", [1.0] * 4)
    )
    *colour, alpha = (min(max(float(number), 0.0), 1.0) for number in factor)
    textured = "baseColorTexture" in metal if gloss is None else "diffuseTexture" in gloss
    through = _extension(material, "KHR_materials_transmission") or {}
    passing = max(
        float(through.get("transmissionFactor", 0.0)),
        1.0 - alpha if material.get("alphaMode") == "BLEND" else 0.0,
    )
    known = "metallicRoughnessTexture" not in metal and gloss is None
    red, green, blue = colour
    return ForeignLook(
        str(material.get("name", "")),
        None if textured else (red, green, blue),
        float(metal.get("metallicFactor", 1.0)) if known else None,
        float(metal.get("roughnessFactor", 1.0)) if known else None,
        passing,
    )


def _triangles(corners: Integers, mode: int) -> Integers:
    """Return the triangles (k, 3) of a list, a strip or a fan of corners."""
    if mode == _TRIANGLES:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    if len(corners) < 3:
        return np.zeros((0, 3), np.int64)
    if mode == _FAN:
        return np.column_stack((np.full(len(corners) - 2, corners[0]), corners[1:-1], corners[2:]))
    strip = np.column_stack((corners[:-2], corners[1:-1], corners[2:]))
    strip[1::2] = strip[1::2, ::-1]
    return strip


def _at(items: Any, index: Any) -> Any:
    """Return an item; IndexError for a negative number, which counts from the end in Python alone."""
    if not isinstance(index, int) or index < 0:
        raise IndexError(index)
    return items[index]
