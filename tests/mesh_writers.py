"""Writers of meshes as other programs export them, in many variants of each format; none shares code with a reader.

``VARIANTS[format](number, folder)`` writes variant ``number`` and returns its file and what it holds.
"""

from __future__ import annotations

import json
import re
import struct
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

COUNT = 24
"""Variants of a format."""


@dataclass
class Solid:
    """A closed solid of quads and triangles, its faces as corners; in metres, y up, where it stands in the world."""

    name: str
    material: str
    points: np.ndarray
    faces: list[tuple[int, ...]]
    colour: tuple[float, float, float] = (0.6, 0.05, 0.04)
    metallic: float = 0.0
    roughness: float = 0.3
    opacity: float = 1.0
    given_normals: np.ndarray | None = None
    given_uvs: np.ndarray | None = None

    @property
    def triangles(self) -> np.ndarray:
        fans = [[face[0], face[k], face[k + 1]] for face in self.faces for k in range(1, len(face) - 1)]
        return np.array(fans, np.int64)

    def normals(self) -> np.ndarray:
        """Of points, outwards."""
        if self.given_normals is not None:
            return self.given_normals
        away = self.points - self.points.mean(axis=0)
        return away / np.linalg.norm(away, axis=1, keepdims=True)

    def uvs(self) -> np.ndarray:
        """Millimetres, as far as a projection gives them."""
        return self.points[:, :2] * 1000.0 if self.given_uvs is None else self.given_uvs


def box(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, list[tuple[int, ...]]]:
    points = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)], np.float64)
    faces = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return points, faces


def ball(centre: np.ndarray, radius: float, rows: int) -> tuple[np.ndarray, list[tuple[int, ...]]]:
    columns = 2 * rows
    points = [[0.0, 1.0, 0.0]]
    for row in range(1, rows):
        for column in range(columns):
            polar, turn = np.pi * row / rows, 2.0 * np.pi * column / columns
            points.append([np.sin(polar) * np.sin(turn), np.cos(polar), np.sin(polar) * np.cos(turn)])
    points.append([0.0, -1.0, 0.0])

    def at(row: int, column: int) -> int:
        return (
            0 if row == 0 else len(points) - 1 if row == rows else 1 + (row - 1) * columns + column % columns
        )

    faces: list[tuple[int, ...]] = []
    for row in range(rows):
        for column in range(columns):
            ring = [at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)]
            faces.append(tuple(dict.fromkeys(ring)))
    return np.array(points) * radius + centre, faces


def solids(number: int) -> list[Solid]:
    """The solids of a variant: a body, glass, tyres and seats in changing numbers and places."""
    rng = np.random.default_rng(number)
    body = box(np.array([-0.9, 0.2, -2.0]), np.array([0.9, 1.0, 2.0]))
    found = [Solid("Karosserie", "Lack", *body)]
    if number % 3:
        found.append(
            Solid("Scheibe", "Material.002", *box(np.array([-0.7, 1.0, -1.0]), np.array([0.7, 1.4, 0.8])))
        )
        found[-1] = replace(found[-1], colour=(0.8, 0.9, 0.9), roughness=0.02, opacity=0.3)
    for wheel in range(number % 5):
        middle = np.array([(-0.8, 0.8)[wheel % 2], 0.3, (-1.3, 1.3)[wheel // 2]]) + rng.normal(size=3) * 0.01
        round_ = ball(middle, 0.3, 5 + number % 7)
        found.append(Solid(f"Reifen_{wheel}", "Gummi", *round_, colour=(0.02,) * 3, roughness=0.9))
    return found


@dataclass
class Written:
    """A file, and what it holds: its solids, and how far points may be from where they were, metres."""

    path: Path
    solids: list[Solid]
    error: float = 1e-5


def lowered(points: np.ndarray) -> np.ndarray:
    """Points of axes with y up in those with z up."""
    return np.stack((points[:, 0], -points[:, 2], points[:, 1]), axis=1)


# glTF


class Glb:
    """A binary glTF file that is being written."""

    def __init__(self) -> None:
        self.document: dict = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}]}
        for key in ("nodes", "meshes", "materials", "accessors", "bufferViews"):
            self.document[key] = []
        self.binary = bytearray()

    def add(self, key: str, value: dict) -> int:
        self.document[key].append(value)
        return len(self.document[key]) - 1

    def view(self, data: bytes, **more: object) -> int:
        self.binary += b"\0" * (-len(self.binary) % 4)
        place = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.binary += data
        return self.add("bufferViews", place | more)

    def accessor(self, view: int | None, code: int, count: int, kind: str, **more: object) -> int:
        fields = {"componentType": code, "count": count, "type": kind} | more
        return self.add("accessors", fields if view is None else fields | {"bufferView": view})

    def material(self, solid: Solid) -> int:
        look = {"baseColorFactor": [*solid.colour, solid.opacity], "metallicFactor": solid.metallic}
        look["roughnessFactor"] = solid.roughness
        more = {"alphaMode": "BLEND"} if solid.opacity < 1.0 else {}
        return self.add("materials", {"name": solid.material, "pbrMetallicRoughness": look} | more)

    def part(self, solid: Solid, primitive: dict, **node: object) -> None:
        mesh = self.add(
            "meshes", {"name": solid.name, "primitives": [primitive | {"material": self.material(solid)}]}
        )
        self.document["scenes"][0]["nodes"].append(
            self.add("nodes", {"name": solid.name, "mesh": mesh} | node)
        )

    def write(self, path: Path, *required: str, fallback: int = 0) -> Path:
        if required:
            self.document |= {"extensionsUsed": [*required], "extensionsRequired": [*required]}
        self.document["buffers"] = [{"byteLength": len(self.binary)}]
        if fallback:
            self.document["buffers"].append({"byteLength": fallback})
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        binary = bytes(self.binary) + b"\0" * (-len(self.binary) % 4)
        chunks = (
            struct.pack("<I4s", len(text), b"JSON")
            + text
            + struct.pack("<I4s", len(binary), b"BIN\0")
            + binary
        )
        path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
        return path


def quantized(solid: Solid, bits: int, signed: bool) -> tuple[np.ndarray, dict, float]:
    """Positions as integers of up to ``bits``, the node that puts them back, and the largest error."""
    low, size = solid.points.min(axis=0), float(np.ptp(solid.points, axis=0).max())
    most = (1 << (bits - signed)) - 1
    codes = np.rint((solid.points - low) / size * most)
    kind = {(8, False): "u1", (8, True): "i1", (16, False): "<u2", (16, True): "<i2"}[
        8 if bits <= 8 else 16, signed
    ]
    return codes.astype(kind), {"translation": low.tolist(), "scale": [size / most] * 3}, size / most


_CODES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}


def code(array: np.ndarray) -> int:
    return _CODES[array.dtype.str[1:]]


def padded(array: np.ndarray) -> np.ndarray:
    """Rows filled up to a multiple of four bytes."""
    rows = array.view(np.uint8).reshape(len(array), -1)
    return np.ascontiguousarray(np.pad(rows, ((0, 0), (0, -rows.shape[1] % 4))))


def small_normals(solid: Solid) -> np.ndarray:
    return np.rint(solid.normals() * 127).astype("i1")


def quantized_glb(number: int, folder: Path, given: list[Solid] | None = None) -> Written:
    file, worst, found = Glb(), 0.0, given or solids(number)
    for solid in found:
        bits, signed, normalized = (16, 14, 12, 8)[number % 4], number % 2 == 1, number % 3 == 0
        codes, node, error = quantized(solid, bits, signed)
        if normalized:
            node["scale"] = [edge * np.iinfo(codes.dtype).max for edge in node["scale"]]
        worst = max(worst, error)
        attributes = {}
        rows = [padded(codes), padded(small_normals(solid))]
        stride = sum(row.shape[1] for row in rows)
        if number % 5 == 0:  # interleaved
            view = file.view(np.hstack(rows).tobytes(), byteStride=stride)
            views, offsets = [view, view], [0, rows[0].shape[1]]
        else:
            views = [file.view(row.tobytes(), byteStride=row.shape[1]) for row in rows]
            offsets = [0, 0]
        for name, array, view, offset, norm in (
            ("POSITION", codes, views[0], offsets[0], normalized),
            ("NORMAL", small_normals(solid), views[1], offsets[1], True),
        ):
            attributes[name] = file.accessor(
                view, code(array), len(array), "VEC3", byteOffset=offset, normalized=norm
            )
        if number % 2:
            uvs = np.rint(solid.uvs() * 4.0).astype("<i2")
            view = file.view(uvs.tobytes(), byteStride=4)
            attributes["TEXCOORD_0"] = file.accessor(view, 5122, len(uvs), "VEC2")
        indices = solid.triangles.ravel().astype(
            ("u1", "<u2", "<u4")[number % 3 if len(solid.points) < 255 else 1]
        )
        at = file.accessor(file.view(indices.tobytes()), code(indices), len(indices), "SCALAR")
        file.part(solid, {"attributes": attributes, "indices": at}, **node)
    return Written(file.write(folder / "a.glb", "KHR_mesh_quantization"), found, worst)


def draco_glb(number: int, folder: Path, given: list[Solid] | None = None) -> Written:
    import DracoPy

    file, worst, found = Glb(), 0.0, given or solids(number)
    bits = 10 + number % 7
    for solid in found:
        more = {}
        if number % 2:
            more["normals"] = solid.normals()
        if number % 3 == 0:
            more["tex_coord"] = solid.uvs()
        packed = DracoPy.encode(
            solid.points,
            solid.triangles.astype(np.uint32),
            quantization_bits=bits,
            compression_level=number % 11,
            preserve_order=number % 4 == 0,
            **more,
        )
        mesh = DracoPy.decode(packed)
        numbers = {
            ("POSITION", "NORMAL", "COLOR_0", "TEXCOORD_0")[a["attribute_type"]]: a for a in mesh.attributes
        }
        attributes = {
            name: file.accessor(None, 5126, len(mesh.points), f"VEC{2 + (name != 'TEXCOORD_0')}")
            for name in numbers
        }
        extension = {
            "bufferView": file.view(packed),
            "attributes": {name: a["unique_id"] for name, a in numbers.items()},
        }
        at = file.accessor(None, 5125, mesh.faces.size, "SCALAR")
        primitive = {"attributes": attributes, "indices": at, "mode": 4}
        file.part(solid, primitive | {"extensions": {"KHR_draco_mesh_compression": extension}})
        worst = max(worst, float(np.ptp(solid.points, axis=0).max()) / (1 << bits))
    return Written(file.write(folder / "a.glb", "KHR_draco_mesh_compression"), found, 2.0 * worst)


def meshopt_glb(number: int, folder: Path, given: list[Solid] | None = None) -> Written:
    import meshopt

    name = ("EXT_meshopt_compression", "KHR_meshopt_compression")[number % 2]
    version = number % 2  # of the bitstream; the second name has both
    file, worst, fallback, found = Glb(), 0.0, 0, given or solids(number)

    def view(rows: np.ndarray, mode: str, filter_name: str = "NONE") -> int:
        nonlocal fallback
        if mode == "ATTRIBUTES":
            packed = meshopt.encode_vertex_buffer_level(rows, number % 4, version)
        else:
            codec = meshopt.encode_index_buffer if mode == "TRIANGLES" else meshopt.encode_index_sequence
            packed = codec(rows.astype(np.uint32))
        file.binary += b"\0" * (-len(file.binary) % 4)
        stride = rows.nbytes // len(rows)
        extension = {
            "buffer": 0,
            "byteOffset": len(file.binary),
            "byteLength": len(packed),
            "byteStride": stride,
        }
        extension |= {"count": len(rows), "mode": mode, "filter": filter_name}
        file.binary += packed
        at = {"buffer": 1, "byteOffset": fallback, "byteLength": rows.nbytes, "extensions": {name: extension}}
        fallback += rows.nbytes + -rows.nbytes % 4
        return file.add("bufferViews", at | ({"byteStride": stride} if mode == "ATTRIBUTES" else {}))

    for solid in found:
        node: dict = {}
        if number % 3 == 0:
            positions = solid.points.astype("<f4")
            position = view(positions, "ATTRIBUTES")
        elif number % 3 == 1:
            filtered = meshopt.encode_filter_exp(solid.points.astype(np.float32), 15)
            positions, error = solid.points.astype("<f4"), 4.0 / (1 << 13)
            position = view(
                np.ascontiguousarray(filtered).view(np.uint8).reshape(len(positions), -1),
                "ATTRIBUTES",
                "EXPONENTIAL",
            )
            worst = max(worst, error)
        else:
            positions, node, error = quantized(solid, 14, signed=False)
            position, worst = view(padded(positions), "ATTRIBUTES"), max(worst, error)
        attributes = {"POSITION": file.accessor(position, code(positions), len(positions), "VEC3")}
        if number % 4:
            long = np.pad(solid.normals(), ((0, 0), (0, 1)))
            wide = number % 4 == 2
            codes = meshopt.encode_filter_oct(long, 8 if wide else 4, 12 if wide else 8)
            rows = np.ascontiguousarray(codes).view(np.uint8).reshape(len(long), -1)
            normal = view(rows, "ATTRIBUTES", "OCTAHEDRAL")
            attributes["NORMAL"] = file.accessor(
                normal, 5122 if wide else 5120, len(long), "VEC3", normalized=True
            )
        uvs = solid.uvs().astype("<f4")
        attributes["TEXCOORD_0"] = file.accessor(view(uvs, "ATTRIBUTES"), 5126, len(uvs), "VEC2")
        indices = solid.triangles.ravel().astype("<u2" if number % 2 else "<u4")
        mode = "TRIANGLES" if number % 5 else "INDICES"
        at = file.accessor(view(indices, mode), code(indices), len(indices), "SCALAR")
        file.part(solid, {"attributes": attributes, "indices": at}, **node)
    path = file.write(folder / "a.glb", name, "KHR_mesh_quantization", fallback=fallback)
    return Written(path, found, worst + 1e-5)


# USD


def usda_text(number: int, given: list[Solid] | None = None) -> tuple[str, list[Solid]]:
    z_up, metres = number % 2 == 1, (1.0, 0.01, 0.001)[number % 3]
    found = given or solids(number)
    prims, materials = [], {}
    for solid in found:
        points = (lowered(solid.points) if z_up else solid.points) / metres
        shift = points.mean(axis=0) if number % 4 == 2 else np.zeros(3)
        faces = [tuple(reversed(face)) for face in solid.faces] if number % 5 == 3 else solid.faces
        if number % 3 == 1:
            triangles = solid.triangles
            faces = [tuple(f) for f in (triangles[:, ::-1] if number % 5 == 3 else triangles).tolist()]
        counts, indices = [len(f) for f in faces], [k for f in faces for k in f]

        def listed(rows: np.ndarray) -> str:
            return "[" + ", ".join("(" + ", ".join(f"{v:.9g}" for v in row) + ")" for row in rows) + "]"

        lines = [f"int[] faceVertexCounts = {counts}", f"int[] faceVertexIndices = {indices}"]
        lines.append(f"point3f[] points = {listed(points - shift)}")
        lines.append(f'uniform token subdivisionScheme = "{("none", "catmullClark")[number % 2]}"')
        if number % 5 == 3:
            lines.append('uniform token orientation = "leftHanded"')
        normals = lowered(solid.normals()) if z_up else solid.normals()
        if number % 4 == 1:
            lines.append(f'normal3f[] normals = {listed(normals)} (interpolation = "vertex")')
        elif number % 4 == 3:
            lines.append(
                f'normal3f[] primvars:normals = {listed(normals[indices])} (interpolation = "faceVarying")'
            )
        if number % 3 == 2:
            lines.append(
                f'texCoord2f[] primvars:st = {listed(solid.uvs()[indices])} (interpolation = "faceVarying")'
            )
        if number % 4 == 2:
            shown = "(" + ", ".join(f"{v:.9g}" for v in shift) + ")"
            lines += [
                f"double3 xformOp:translate = {shown}",
                'uniform token[] xformOpOrder = ["xformOp:translate"]',
            ]
        material = re.sub(r"\W", "_", solid.material)
        lines.append(f"rel material:binding = </Looks/{material}>")
        body = "\n        ".join(lines)
        prims.append(
            f'    def Mesh "{solid.name}" (prepend apiSchemas = ["MaterialBindingAPI"])\n    {{\n        {body}\n    }}'
        )
        red, green, blue = solid.colour
        materials[material] = f"""    def Material "{material}" {{
        token outputs:surface.connect = </Looks/{material}/S.outputs:surface>
        def Shader "S" {{
            uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor = ({red}, {green}, {blue})
            float inputs:opacity = {solid.opacity}
            float inputs:roughness = {solid.roughness}
            token outputs:surface
        }}
    }}"""
    head = f'#usda 1.0\n(\n    defaultPrim = "Car"\n    metersPerUnit = {metres}\n    upAxis = "{"ZY"[not z_up]}"\n)\n'
    car = 'def Xform "Car"\n{\n' + "\n".join(prims) + "\n}\n"
    return head + car + 'def Scope "Looks"\n{\n' + "\n".join(materials.values()) + "\n}\n", found


def usd(number: int, folder: Path, given: list[Solid] | None = None) -> Written:
    text, found = usda_text(number, given)
    path = folder / ("a.usda", "a.usd", "a.usdc", "a.usdz")[number % 4]
    if path.suffix == ".usdc":
        from pxr import Usd

        (folder / "from.usda").write_text(text)
        Usd.Stage.Open(str(folder / "from.usda")).Export(str(path))
    elif path.suffix == ".usdz":
        name, content = b"a.usda", text.encode()
        gap = -(30 + len(name) + 4) % 64  # content begins at a multiple of 64 bytes
        extra = struct.pack("<HH", 0x1986, gap) + bytes(gap)
        fields = (20, 0, 0, 0, 33, zlib.crc32(content), len(content), len(content), len(name))
        local = b"PK\3\4" + struct.pack("<5H3I2H", *fields, len(extra)) + name + extra
        central = b"PK\1\2" + struct.pack("<6H3I5H2I", 20, *fields, 0, 0, 0, 0, 0, 0) + name
        end = struct.pack("<4H2IH", 0, 0, 1, 1, len(central), len(local) + len(content), 0)
        path.write_bytes(local + content + central + b"PK\5\6" + end)
    else:
        path.write_text(text)
    return Written(path, found, 1e-5)


# FBX


@dataclass
class Field:
    """A node of an FBX file: a name, values and nodes below it."""

    name: str
    values: tuple = ()
    below: tuple[Field, ...] = ()


def fbx_text(field: Field, depth: int = 0) -> str:
    def shown(value: object) -> str:
        if isinstance(value, np.ndarray):
            return (
                f"*{value.size} {{\n{pad}\ta: {','.join(f'{v:.9g}' for v in value.ravel().tolist())}\n{pad}}}"
            )
        if isinstance(value, str):
            named, _, kind = value.partition("\0\1")
            return f'"{kind}::{named}"' if kind else f'"{value}"'
        return f"{value:.9g}" if isinstance(value, float) else str(value)

    pad = "\t" * depth
    text = f"{pad}{field.name}: " + ", ".join(shown(v) for v in field.values)
    if field.below:
        text += " {\n" + "".join(fbx_text(one, depth + 1) for one in field.below) + pad + "}"
    return text + "\n"


def fbx_binary(field: Field, at: int, wide: bool, packed: bool) -> bytes:
    def stored(value: object) -> bytes:
        if isinstance(value, np.ndarray):
            kind = b"d" if value.dtype.kind == "f" else b"i"
            data = value.astype("<f8" if kind == b"d" else "<i4").tobytes()
            stored_ = zlib.compress(data) if packed else data
            return kind + struct.pack("<III", value.size, int(packed), len(stored_)) + stored_
        if isinstance(value, str):
            return b"S" + struct.pack("<I", len(value.encode())) + value.encode()
        if isinstance(value, float):
            return b"D" + struct.pack("<d", value)
        return (
            b"L" + struct.pack("<q", value)
            if isinstance(value, np.int64)
            else b"I" + struct.pack("<i", value)
        )

    head = struct.calcsize("<QQQB" if wide else "<IIIB") + len(field.name)
    values = b"".join(stored(value) for value in field.values)
    content, inside = values, at + head + len(values)
    for one in field.below:
        made = fbx_binary(one, inside, wide, packed)
        content, inside = content + made, inside + len(made)
    if field.below:
        content += bytes(25 if wide else 13)
    numbers = (at + head + len(content), len(field.values), len(values), len(field.name))
    return struct.pack("<QQQB" if wide else "<IIIB", *numbers) + field.name.encode() + content


def fbx(number: int, folder: Path) -> Written:
    z_up, centimetres = number % 2 == 1, (1.0, 100.0, 0.1)[number % 3]
    found = solids(number)
    objects, links = [], []

    def prop(name: str, kind: str, *values: object) -> Field:
        return Field("P", (name, kind, "", "A", *values))

    for place, solid in enumerate(found):
        points = (lowered(solid.points) if z_up else solid.points) * 100.0 / centimetres
        normals = lowered(solid.normals()) if z_up else solid.normals()
        corners = np.array([k if n + 1 < len(f) else -k - 1 for f in solid.faces for n, k in enumerate(f)])
        used = np.array([k for face in solid.faces for k in face])
        shift = points.mean(axis=0) if number % 4 == 3 else np.zeros(3)
        layers = []
        if number % 3:
            by_corner = number % 3 == 1
            values = normals[used] if by_corner else normals
            mapping = "ByPolygonVertex" if by_corner else "ByVertice"
            layers.append(("LayerElementNormal", mapping, "Normals", values.ravel()))
        if number % 4 == 2:
            layers.append(("LayerElementUV", "ByPolygonVertex", "UV", solid.uvs()[used].ravel()))
        layers.append(("LayerElementMaterial", "AllSame", "Materials", np.zeros(1, np.int64)))
        elements = []
        for name, mapping, key, values in layers:
            reference = "IndexToDirect" if key == "Materials" else "Direct"
            fields = [Field("Version", (101,)), Field("Name", ("",))]
            fields += [
                Field("MappingInformationType", (mapping,)),
                Field("ReferenceInformationType", (reference,)),
            ]
            elements.append(Field(name, (0,), (*fields, Field(key, (values,)))))
        typed = tuple(
            Field("LayerElement", (), (Field("Type", (name,)), Field("TypedIndex", (0,))))
            for name, *_ in layers
        )
        shape = Field("Vertices", ((points - shift).ravel(),)), Field("PolygonVertexIndex", (corners,))
        objects.append(
            Field(
                "Geometry",
                (np.int64(1000 + place), f"{solid.name}\0\1Geometry", "Mesh"),
                (*shape, *elements, Field("Layer", (0,), (Field("Version", (100,)), *typed))),
            )
        )
        moved = (prop("Lcl Translation", "Lcl Translation", *map(float, shift)),) if shift.any() else ()
        objects.append(
            Field(
                "Model",
                (np.int64(2000 + place), f"{solid.name}\0\1Model", "Mesh"),
                (Field("Version", (232,)), Field("Properties70", (), moved)),
            )
        )
        look = (prop("DiffuseColor", "Color", *solid.colour), prop("Opacity", "double", solid.opacity))
        objects.append(
            Field(
                "Material",
                (np.int64(3000 + place), f"{solid.material}\0\1Material", ""),
                (Field("ShadingModel", ("phong",)), Field("Properties70", (), look)),
            )
        )
        links += [(2000 + place, 0), (1000 + place, 2000 + place), (3000 + place, 2000 + place)]
    axes = {"UpAxis": 2 if z_up else 1, "UpAxisSign": 1, "FrontAxis": 1 if z_up else 2}
    axes |= {"FrontAxisSign": -1 if z_up else 1, "CoordAxis": 0, "CoordAxisSign": 1}
    settings = [prop(name, "int", value) for name, value in axes.items()]
    settings += [prop("UnitScaleFactor", "double", centimetres)]
    version = (7400, 7500, 7700)[number % 3]
    top = [
        Field(
            "FBXHeaderExtension", (), (Field("FBXHeaderVersion", (1003,)), Field("FBXVersion", (version,)))
        ),
        Field("GlobalSettings", (), (Field("Version", (1000,)), Field("Properties70", (), tuple(settings)))),
        Field("Objects", (), tuple(objects)),
        Field("Connections", (), tuple(Field("C", ("OO", *map(np.int64, pair))) for pair in links)),
    ]
    path = folder / "a.fbx"
    if number % 4 == 0:
        path.write_text(
            f"; FBX {version // 1000}.{version // 100 % 10}.0 project file\n" + "".join(map(fbx_text, top))
        )
    else:
        content = b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", version)
        for field in top:
            content += fbx_binary(field, len(content), version >= 7500, number % 2 == 1)
        path.write_bytes(content + bytes(25 if version >= 7500 else 13) + bytes(160))
    return Written(path, found, 1e-4)


# Collada and 3MF


def collada(number: int, folder: Path) -> Written:
    z_up, metres = number % 2 == 1, (1.0, 0.01, 0.0254)[number % 3]
    found = solids(number)
    parts = {key: [] for key in ("effects", "materials", "geometries", "nodes")}
    for place, solid in enumerate(found):
        points = (lowered(solid.points) if z_up else solid.points) / metres
        normals = lowered(solid.normals()) if z_up else solid.normals()
        shift = points.mean(axis=0) if number % 4 == 1 else np.zeros(3)
        with_normals = number % 3 != 0

        def source(name: str, rows: np.ndarray, place: int = place) -> str:
            axes = "".join(f'<param name="{axis}" type="float"/>' for axis in "XYZ")
            text = " ".join(f"{v:.9g}" for v in rows.ravel())
            return (
                f'<source id="g{place}-{name}"><float_array id="g{place}-{name}-a" count="{rows.size}">{text}'
                f'</float_array><technique_common><accessor source="#g{place}-{name}-a" count="{len(rows)}" stride="3">'
                f"{axes}</accessor></technique_common></source>"
            )

        inputs = f'<input semantic="VERTEX" source="#g{place}-v" offset="0"/>'
        inputs += f'<input semantic="NORMAL" source="#g{place}-n" offset="1"/>' if with_normals else ""
        faces = [tuple(f) for f in solid.triangles.tolist()] if number % 5 < 2 else solid.faces

        def numbers(face: tuple[int, ...], twice: bool = with_normals) -> str:
            return " ".join(f"{k} {k}" if twice else str(k) for k in face)

        if number % 5 < 2:
            text = " ".join(map(numbers, faces))
            shape = f'<triangles count="{len(faces)}" material="s">{inputs}<p>{text}</p></triangles>'
        elif number % 5 < 4:
            counts = " ".join(str(len(face)) for face in faces)
            text = " ".join(map(numbers, faces))
            listed = f"{inputs}<vcount>{counts}</vcount><p>{text}</p>"
            shape = f'<polylist count="{len(faces)}" material="s">{listed}</polylist>'
        else:
            text = "".join(f"<p>{numbers(face)}</p>" for face in faces)
            shape = f'<polygons count="{len(faces)}" material="s">{inputs}{text}</polygons>'
        sources = source("p", points - shift) + (source("n", normals) if with_normals else "")
        vertices = f'<vertices id="g{place}-v"><input semantic="POSITION" source="#g{place}-p"/></vertices>'
        parts["geometries"].append(
            f'<geometry id="g{place}" name="{solid.name}"><mesh>{sources}{vertices}{shape}</mesh></geometry>'
        )
        colour = " ".join(f"{v:.6g}" for v in solid.colour)
        kind = ("phong", "lambert", "blinn")[number % 3]
        parts["effects"].append(
            f'<effect id="e{place}"><profile_COMMON><technique sid="c"><{kind}><diffuse><color>{colour} 1</color>'
            f"</diffuse><transparency><float>{solid.opacity}</float></transparency></{kind}></technique></profile_COMMON></effect>"
        )
        parts["materials"].append(
            f'<material id="m{place}" name="{solid.material}"><instance_effect url="#e{place}"/></material>'
        )
        matrix = np.eye(4)
        matrix[:3, 3] = shift
        place_ = (
            f"<matrix>{' '.join(f'{v:.9g}' for v in matrix.ravel())}</matrix>"
            if number % 2
            else f"<translate>{' '.join(f'{v:.9g}' for v in shift)}</translate>"
        )
        bind = f'<instance_material symbol="s" target="#m{place}"/>'
        parts["nodes"].append(
            f'<node id="n{place}" name="{solid.name}">{place_}<instance_geometry url="#g{place}"><bind_material>'
            f"<technique_common>{bind}</technique_common></bind_material></instance_geometry></node>"
        )
    version, space = (("1.4.1", "2005/11"), ("1.5.0", "2008/03"))[number % 7 == 6]
    text = (
        f'<?xml version="1.0" encoding="utf-8"?>\n<COLLADA xmlns="http://www.collada.org/{space}/COLLADASchema" '
        f'version="{version}"><asset><unit name="unit" meter="{metres}"/><up_axis>{"ZY"[not z_up]}_UP</up_axis></asset>'
        f"<library_effects>{''.join(parts['effects'])}</library_effects>"
        f"<library_materials>{''.join(parts['materials'])}</library_materials>"
        f"<library_geometries>{''.join(parts['geometries'])}</library_geometries>"
        f'<library_visual_scenes><visual_scene id="vs">{"".join(parts["nodes"])}</visual_scene></library_visual_scenes>'
        '<scene><instance_visual_scene url="#vs"/></scene></COLLADA>\n'
    )
    path = folder / "a.dae"
    path.write_text(text)
    return Written(path, found, 1e-4)


def three_mf(number: int, folder: Path) -> Written:
    units = {
        "millimeter": 0.001,
        "centimeter": 0.01,
        "meter": 1.0,
        "inch": 0.0254,
        "foot": 0.3048,
        "micron": 1e-6,
    }
    unit, metres = list(units.items())[number % 6]
    found = solids(number)
    objects, items = [], []
    for place, solid in enumerate(found):
        points = lowered(solid.points) / metres
        shift = points.mean(axis=0) if number % 3 == 1 else np.zeros(3)
        vertices = "".join(f'<vertex x="{x:.9g}" y="{y:.9g}" z="{z:.9g}"/>' for x, y, z in points - shift)
        triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in solid.triangles)
        objects.append(
            f'<object id="{10 + place}" type="model" name="{solid.name}" pid="5" pindex="{place}"><mesh><vertices>'
            f"{vertices}</vertices><triangles>{triangles}</triangles></mesh></object>"
        )
        moved = "1 0 0 0 1 0 0 0 1 " + " ".join(f"{v:.9g}" for v in shift)
        if number % 4 == 3:  # an object that consists of another
            objects.append(
                f'<object id="{100 + place}" type="model"><components><component objectid="{10 + place}" '
                f'transform="{moved}"/></components></object>'
            )
            items.append(f'<item objectid="{100 + place}"/>')
        else:
            items.append(f'<item objectid="{10 + place}" transform="{moved}"/>')

    def code_of(solid: Solid) -> str:
        return (
            "#"
            + "".join(f"{round(255 * v ** (1 / 2.2)):02X}" for v in solid.colour)
            + f"{round(255 * solid.opacity):02X}"
        )

    bases = "".join(f'<base name="{solid.material}" displaycolor="{code_of(solid)}"/>' for solid in found)
    model = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<model unit="{unit}" xml:lang="en-US" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
        f'<basematerials id="5">{bases}</basematerials>{"".join(objects)}</resources>'
        f"<build>{''.join(items)}</build></model>"
    )
    types = (
        '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
    )
    relations = (
        '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
        '<Relationship Target="/3D/3dmodel.model" Id="rel0" '
        'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
    )
    path = folder / "a.3mf"
    with zipfile.ZipFile(path, "w", (zipfile.ZIP_DEFLATED, zipfile.ZIP_STORED)[number % 2]) as archive:
        for name, text in (
            ("[Content_Types].xml", types),
            ("_rels/.rels", relations),
            ("3D/3dmodel.model", model),
        ):
            archive.writestr(name, text)
    return Written(path, found, 1e-4)


# STEP


class Step:
    """A STEP file (AP214) that is being written: numbered entities."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, text: str) -> str:
        self.lines.append(f"#{len(self.lines) + 1}={text};")
        return f"#{len(self.lines)}"

    def place(self, kind: str, values: np.ndarray) -> str:
        return self.add(f"{kind}('',({','.join(f'{v:.9E}' for v in values)}))")

    def axes(self, origin: np.ndarray, z: np.ndarray, x: np.ndarray) -> str:
        named = self.place("CARTESIAN_POINT", origin), self.place("DIRECTION", z), self.place("DIRECTION", x)
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(named)})")

    def solid(self, points: np.ndarray, faces: list[tuple[int, ...]]) -> str:
        """A solid with plane faces."""
        corners = [self.add(f"VERTEX_POINT('',{self.place('CARTESIAN_POINT', point)})") for point in points]
        edges: dict[tuple[int, int], str] = {}
        bounds = []
        for face in faces:
            oriented = []
            for a, b in zip(face, (*face[1:], face[0]), strict=True):
                if (b, a) in edges:
                    oriented.append(self.add(f"ORIENTED_EDGE('',*,*,{edges[b, a]},.F.)"))
                    continue
                length = float(np.linalg.norm(points[b] - points[a]))
                along = self.place("DIRECTION", (points[b] - points[a]) / length)
                vector = self.add(f"VECTOR('',{along},1.0)")
                line = self.add(f"LINE('',{self.place('CARTESIAN_POINT', points[a])},{vector})")
                edges[a, b] = self.add(f"EDGE_CURVE('',{corners[a]},{corners[b]},{line},.T.)")
                oriented.append(self.add(f"ORIENTED_EDGE('',*,*,{edges[a, b]},.T.)"))
            loop = self.add(f"EDGE_LOOP('',({','.join(oriented)}))")
            bound = self.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
            first = points[face[1]] - points[face[0]]
            up = np.cross(first, points[face[2]] - points[face[0]])
            plane = self.axes(points[face[0]], up / np.linalg.norm(up), first / np.linalg.norm(first))
            bounds.append(
                self.add(f"ADVANCED_FACE('',({bound}),{self.add(f'PLANE({chr(39) * 2},{plane})')},.T.)")
            )
        shell = self.add(f"CLOSED_SHELL('',({','.join(bounds)}))")
        return self.add(f"MANIFOLD_SOLID_BREP('body',{shell})")

    def ball(self, centre: np.ndarray, radius: float) -> str:
        """A sphere as one face: its seam is a meridian, its poles are vertices."""
        z, x = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
        surface = self.add(f"SPHERICAL_SURFACE('',{self.axes(centre, z, x)},{radius:.9E})")
        poles = [
            self.add(f"VERTEX_POINT('',{self.place('CARTESIAN_POINT', centre + s * radius * z)})")
            for s in (-1, 1)
        ]
        circle = self.add(f"CIRCLE('',{self.axes(centre, np.array([0.0, -1.0, 0.0]), x)},{radius:.9E})")
        seam = self.add(f"EDGE_CURVE('',{poles[0]},{poles[1]},{circle},.T.)")
        both = [self.add(f"ORIENTED_EDGE('',*,*,{seam},{way})") for way in (".T.", ".F.")]
        bound = self.add(
            f"FACE_OUTER_BOUND('',{self.add(f'EDGE_LOOP({chr(39) * 2},({both[0]},{both[1]}))')},.T.)"
        )
        face = self.add(f"ADVANCED_FACE('',({bound}),{surface},.T.)")
        return self.add(f"MANIFOLD_SOLID_BREP('ball',{self.add(f'CLOSED_SHELL({chr(39) * 2},({face}))')})")

    def write(self, path: Path, bodies: list[tuple[str, str, tuple[float, float, float]]], unit: str) -> Path:
        """Write bodies (entity, name, colour) as products of one file."""
        contexts = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(
            f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{contexts})"
        )
        if unit == "inch":
            base = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
            measure = self.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{base})")
            exponents = self.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            length = self.add(
                f"(CONVERSION_BASED_UNIT('INCH',{measure})LENGTH_UNIT()NAMED_UNIT({exponents}))"
            )
        else:
            prefix = {"millimetre": ".MILLI.", "centimetre": ".CENTI.", "metre": "$"}[unit]
            length = self.add(f"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.))")
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        solid = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        near = self.add(
            f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),{length},'distance_accuracy_value','')"
        )
        context = self.add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
            f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({near}))GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))"
            "REPRESENTATION_CONTEXT('',''))"
        )
        product_context = self.add(f"PRODUCT_CONTEXT('',{contexts},'mechanical')")
        definition_context = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{contexts},'design')")
        styled = []
        for body, name, colour in bodies:
            origin = self.axes(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]))
            shape = self.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('{name}',({origin},{body}),{context})")
            product = self.add(f"PRODUCT('{name}','{name}','',({product_context}))")
            formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
            definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{definition_context})")
            defined = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
            self.add(f"SHAPE_DEFINITION_REPRESENTATION({defined},{shape})")
            red, green, blue = colour
            rgb = self.add(f"COLOUR_RGB('',{red:.6E},{green:.6E},{blue:.6E})")
            fill = self.add(
                f"FILL_AREA_STYLE('',({self.add(f'FILL_AREA_STYLE_COLOUR({chr(39) * 2},{rgb})')}))"
            )
            side = self.add(f"SURFACE_SIDE_STYLE('',({self.add(f'SURFACE_STYLE_FILL_AREA({fill})')}))")
            style = self.add(
                f"PRESENTATION_STYLE_ASSIGNMENT(({self.add(f'SURFACE_STYLE_USAGE(.BOTH.,{side})')}))"
            )
            styled.append(self.add(f"STYLED_ITEM('color',({style}),{body})"))
        self.add(
            f"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({','.join(styled)}),{context})"
        )
        head = (
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
            f"FILE_NAME('{path.name}','2026-01-01T00:00:00',(''),(''),'','','');\n"
            "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
        )
        path.write_text(head + "\n".join(self.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n")
        return path


def step(number: int, folder: Path) -> Written:
    units = {"millimetre": 1000.0, "metre": 1.0, "inch": 1.0 / 0.0254, "centimetre": 100.0}
    unit, per_metre = list(units.items())[number % 4]
    found = [solid for solid in solids(number) if len(solid.points) == 8]
    for k in range(number % 6):
        found.append(
            Solid(
                f"Block_{k}", "", *box(np.array([k, 2.0, 0.0]), np.array([k + 0.5, 2.2, 0.3 + 0.01 * number]))
            )
        )
    file = Step()
    bodies = []
    for solid in found:
        points = lowered(solid.points) * per_metre
        # In their new axes the faces are turned as before, since these are a rotation of the old.
        bodies.append((file.solid(points, solid.faces), solid.name, solid.colour))
    path = folder / ("a.step", "a.stp")[number % 2]
    return Written(file.write(path, bodies, unit), found, 1e-4)


# X3D, AC3D and 3DS


def x3d(number: int, folder: Path) -> Written:
    found = solids(number)
    shapes = []
    for place, solid in enumerate(found):
        shift = solid.points.mean(axis=0) if number % 2 else np.zeros(3)
        comma = ", " if number % 3 == 1 else " "
        points = comma.join(" ".join(f"{v:.9g}" for v in row) for row in solid.points - shift)
        faces = [tuple(f) for f in solid.triangles.tolist()] if number % 5 < 2 else solid.faces
        index = " -1 ".join(" ".join(map(str, face)) for face in faces) + (" -1" if number % 2 else "")
        red, green, blue = solid.colour
        clear = f' transparency="{1.0 - solid.opacity:g}"' if solid.opacity < 1.0 else ""
        look = f'<Appearance><Material diffuseColor="{red:g} {green:g} {blue:g}"{clear}/></Appearance>'
        flags = ' solid="true" ccw="true"' if number % 4 == 2 else ""
        shapes.append(
            f'<Transform DEF="{solid.name}" translation="{" ".join(f"{v:.9g}" for v in shift)}"><Shape DEF="s{place}">'
            f'{look}<IndexedFaceSet coordIndex="{index}"{flags}><Coordinate point="{points}"/></IndexedFaceSet>'
            "</Shape></Transform>"
        )
    version = ("3.0", "3.2", "3.3")[number % 3]
    kind = f'<!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D {version}//EN" "http://www.web3d.org/x3d.dtd">\n'
    text = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n{kind if number % 4 == 3 else ""}'
        f'<X3D profile="Interchange" version="{version}"><head><meta name="title" content="a"/></head><Scene>'
        f"{''.join(shapes)}</Scene></X3D>\n"
    )
    path = folder / "a.x3d"
    path.write_text(text)
    return Written(path, found, 1e-4)


def ac3d(number: int, folder: Path) -> Written:
    found = solids(number)
    lines = [f"AC3D{'bc'[number % 2]}"]
    for solid in found:
        red, green, blue = solid.colour
        lines.append(
            f'MATERIAL "{solid.material}" rgb {red:g} {green:g} {blue:g}  amb 0.2 0.2 0.2  emis 0 0 0  '
            f"spec 0.5 0.5 0.5  shi 10  trans {1.0 - solid.opacity:g}"
        )
    lines += ["OBJECT world", f"kids {len(found)}"]
    for place, solid in enumerate(found):
        shift = solid.points.mean(axis=0) if number % 3 == 1 else np.zeros(3)
        lines += ["OBJECT poly", f'name "{solid.name}"']
        lines += ["loc " + " ".join(f"{v:.9g}" for v in shift)] if shift.any() else []
        lines += ["crease 30.0"] if number % 4 == 1 else []
        lines.append(f"numvert {len(solid.points)}")
        lines += [" ".join(f"{v:.9g}" for v in row) for row in solid.points - shift]
        faces = [tuple(f) for f in solid.triangles.tolist()] if number % 5 < 2 else solid.faces
        lines.append(f"numsurf {len(faces)}")
        for face in faces:
            lines += [f"SURF 0x{(0x00, 0x10)[number % 2]:02x}", f"mat {place}", f"refs {len(face)}"]
            lines += [f"{k} 0 0" for k in face]
        lines.append("kids 0")
    path = folder / "a.ac"
    path.write_bytes(("\r\n" if number % 4 == 3 else "\n").join([*lines, ""]).encode())
    return Written(path, found, 1e-4)


def three_ds(number: int, folder: Path) -> Written:
    def chunk(code_: int, content: bytes) -> bytes:
        return struct.pack("<HI", code_, 6 + len(content)) + content

    found = solids(number)
    materials, objects = b"", b""
    for solid in found:
        colour = chunk(0x0011, bytes(round(255 * v) for v in solid.colour))
        if number % 2:
            colour = chunk(0x0010, struct.pack("<3f", *solid.colour))
        name = solid.material.encode() + b"\0"
        clear = chunk(0xA050, chunk(0x0030, struct.pack("<H", round(100 * (1.0 - solid.opacity)))))
        if name not in materials:
            materials += chunk(0xAFFF, chunk(0xA000, name) + chunk(0xA020, colour) + clear)
        points = lowered(solid.points).astype("<f4")
        triangles = solid.triangles.astype("<u2")
        flags = np.full((len(triangles), 1), 7 if number % 3 else 0, "<u2")
        listed = np.arange(len(triangles), dtype="<u2").tobytes()
        faces = struct.pack("<H", len(triangles)) + np.concatenate((triangles, flags), 1).tobytes()
        faces += chunk(0x4130, name + struct.pack("<H", len(triangles)) + listed)
        if number % 4 == 1:
            faces += chunk(0x4150, np.ones(len(triangles), "<u4").tobytes())
        inner = chunk(0x4110, struct.pack("<H", len(points)) + points.tobytes()) + chunk(0x4120, faces)
        if number % 5 == 2:
            inner += chunk(0x4160, np.eye(4, 3, dtype="<f4").tobytes())
        objects += chunk(0x4000, solid.name.encode() + b"\0" + chunk(0x4100, inner))
    version = chunk(0x0002, struct.pack("<I", 3))
    edited = chunk(0x3D3D, (chunk(0x3D3E, struct.pack("<I", 3)) if number % 2 else b"") + materials + objects)
    path = folder / "a.3ds"
    path.write_bytes(chunk(0x4D4D, version + edited))
    return Written(path, found, 1e-4)


VARIANTS: dict[str, Callable[[int, Path], Written]] = {
    "quantized": quantized_glb,
    "draco": draco_glb,
    "meshopt": meshopt_glb,
    "usd": usd,
    "fbx": fbx,
    "collada": collada,
    "3mf": three_mf,
    "step": step,
    "x3d": x3d,
    "ac3d": ac3d,
    "3ds": three_ds,
}
