"""Meshes of every kind that is known by content or by ending, those of other libraries read in the reading process.

With a user the libraries run in a child process for each file. Here they run in the harness's own children, many files
to each: their deaths are counted, and are no crash of the suite.
"""

from __future__ import annotations

import contextlib
import functools
import importlib
import importlib.util
import json
import struct
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.meshes.glb import write_mesh_glb
from brdf_suite.files.meshes.kinds import OUTSIDE, kind_of
from brdf_suite.files.meshes.outside import child, worker
from brdf_suite.files.meshes.outside.values import ReadMesh, Refused
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.files.meshes.writing import PointMesh, write_obj, write_ply
from brdf_suite.surface.mesh import Mesh, PartGeometry
from tools.attack.readers.reader import MEGABYTE, Reader, WrongValueError

_OWN_KINDS = ("glb", "gltf", "obj", "stl", "ply")
_WRITTEN = {
    "usd": range(1, 7),
    "fbx": (1, 2),
    "collada": (1,),
    "3mf": (1,),
    "step": (1,),
    "quantized": (1,),
    "meshopt": (1, 6),
    "draco": (1,),
}
"""Variants of the tests' writers that are taken as seeds."""
_POINTS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
_FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]

_USDA = """#usda 1.0
(
    subLayers = [@./sub.usda@]
)
def Mesh "body" (
    references = [@b.usdz[b.usda]@</X>, @./c.usda:SDF_FORMAT_ARGS:target=x@]
    payload = @./d.usda@
    variants = { string v = "one" }
    prepend variantSets = "v"
    clips = { dictionary default = {
        asset[] assetPaths = [@./clip.usda@]
        string primPath = "/X"
        double2[] active = [(0, 0)]
        double2[] times = [(0, 0)]
    } }
)
{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    variantSet "v" = { "one" ( references = @./e.usda@ ) { } "two" { } }
}
"""
"""A mesh with everything that leads to other files."""


def run_here(path: PathLike, library: str, file: str, options: dict[str, Any]) -> Any:
    """Do what the child process does, in this one."""
    read = importlib.import_module(worker._READERS[library]).read
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        try:
            with np.errstate(all="ignore"):
                found = read(Path(file), options)
        except Refused as refusal:
            found = ReadMesh([], refused=str(refusal))
        answer = Path(folder, "answer")
        worker._write(answer, found)
        content = answer.read_bytes()
    return child._unpacked(path, content)


def _read(path: Path) -> None:
    child._run = run_here  # the reader starts a process for each file, which takes a second
    low, high = read_mesh(path).bounds()
    if not np.isfinite([low, high]).all():
        raise WrongValueError("a mesh without bounds")


@functools.cache
def writers() -> Any:
    """Return the tests' writers of meshes."""
    path = Path(__file__).parents[3] / "tests" / "mesh_writers.py"
    spec = importlib.util.spec_from_file_location("mesh_writers", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["mesh_writers"] = module
    spec.loader.exec_module(module)
    return module


def _by_hand(kind: str, folder: Path) -> None:
    """Write a tetrahedron as a file of a kind that the tests do not write."""
    faces, points = np.array(_FACES), np.array(_POINTS)
    if kind == "glb":
        normals = points - points.mean(axis=0)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        part = PartGeometry("body", "paint", points, normals, 1000.0 * points[:, :2], faces)
        write_mesh_glb(Mesh("made", (part,)), folder / "own.glb")
    elif kind == "gltf":
        data = points.astype("<f4").tobytes() + faces.astype("<u2").tobytes()
        (folder / "made.bin").write_bytes(data)
        views = [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}]
        accessors = [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [0, 0, 0],
                "max": [1, 1, 1],
            },
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
        ]
        document = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [
                {"mesh": 0, "children": [1], "rotation": [0, 0, 0, 1]},
                {"mesh": 0, "scale": [1, 2, 1]},
            ],
            "meshes": [
                {"name": "m", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}
            ],
            "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
            "accessors": accessors,
            "bufferViews": views,
            "buffers": [{"uri": "made.bin", "byteLength": len(data)}],
        }
        (folder / "made.gltf").write_text(json.dumps(document))
    elif kind == "obj":
        write_obj(folder / "plain.obj", _point_mesh())
        (folder / "made.mtl").write_text("newmtl red\nKd 1 0 0\nPm 0.5\nPr 0.2\nd 0.5\nmap_Kd none.png\n")
        lines = ["mtllib made.mtl", "o body", "usemtl red", *(f"v {x} {y} {z}" for x, y, z in _POINTS)]
        lines += ["vt 0 0", "vt 1 0", "vt 0 1", "vn 0 0 1"]
        lines += [
            "f " + " ".join(f"{corner + 1}/{number + 1}/1" for number, corner in enumerate(f)) for f in _FACES
        ]
        (folder / "made.obj").write_text("\n".join(lines) + "\n")
    elif kind == "stl":
        rows = b"".join(
            struct.pack("<12fH", 0, 0, 1, *(c for corner in f for c in _POINTS[corner]), 0) for f in _FACES
        )
        (folder / "binary.stl").write_bytes(bytes(80) + struct.pack("<I", 4) + rows)
        loops = "".join(
            "facet normal 0 0 1\nouter loop\n"
            + "".join("vertex {} {} {}\n".format(*_POINTS[corner]) for corner in f)
            + "endloop\nendfacet\n"
            for f in _FACES
        )
        (folder / "text.stl").write_text(f"solid made\n{loops}endsolid made\n")
    elif kind == "ply":
        write_ply(folder / "binary.ply", _point_mesh())
        head = (
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        )
        head += "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
        rows_text = "".join(f"{x} {y} {z}\n" for x, y, z in _POINTS) + "".join(
            f"3 {a} {b} {c}\n" for a, b, c in _FACES
        )
        (folder / "text.ply").write_text(head + rows_text)
    elif kind == "x3d":
        index = " ".join(f"{a} {b} {c} -1" for a, b, c in _FACES)
        corners = " ".join(f"{x} {y} {z}" for x, y, z in _POINTS)
        (folder / "made.x3d").write_text(
            '<?xml version="1.0" encoding="UTF-8"?><X3D version="3.0" profile="Immersive"><Scene><Transform><Shape>'
            '<Appearance><Material diffuseColor="1 0 0"/></Appearance>'
            f'<IndexedFaceSet coordIndex="{index}"><Coordinate point="{corners}"/></IndexedFaceSet>'
            "</Shape></Transform></Scene></X3D>"
        )
    elif kind == "ac":
        corners = "".join(f"{x} {y} {z}\n" for x, y, z in _POINTS)
        surfaces = "".join(f"SURF 0x0\nmat 0\nrefs 3\n{a} 0 0\n{b} 1 0\n{c} 0 1\n" for a, b, c in _FACES)
        (folder / "made.ac").write_text(
            'AC3Db\nMATERIAL "red" rgb 1 0 0 amb 0.2 0.2 0.2 emis 0 0 0 spec 0.5 0.5 0.5 shi 10 trans 0\n'
            f'OBJECT world\nkids 1\nOBJECT poly\nname "body"\nnumvert 4\n{corners}numsurf 4\n{surfaces}kids 0\n'
        )
    elif kind == "3ds":
        (folder / "made.3ds").write_bytes(_three_ds())
    elif kind == "usda":
        (folder / "composed.usda").write_text(_USDA)
    elif kind == "iges":
        (folder / "made.igs").write_text(_iges())


def _point_mesh() -> PointMesh:
    points = np.array(_POINTS)
    return PointMesh(points, np.tile((0.0, 0.0, 1.0), (4, 1)), np.zeros((4, 3), np.uint8), np.array(_FACES))


def _three_ds() -> bytes:
    def chunk(number: int, content: bytes) -> bytes:
        return struct.pack("<HI", number, 6 + len(content)) + content

    corners = struct.pack("<H", 4) + b"".join(struct.pack("<3f", *point) for point in _POINTS)
    faces = struct.pack("<H", 4) + b"".join(struct.pack("<4H", *face, 7) for face in _FACES)
    mesh = chunk(0x4100, chunk(0x4110, corners) + chunk(0x4120, faces))
    return chunk(0x4D4D, chunk(0x0002, struct.pack("<I", 3)) + chunk(0x3D3D, chunk(0x4000, b"body\0" + mesh)))


def _iges() -> str:
    """A bounded plane: a square of four lines, trimmed."""

    def card(text: str, section: str, number: int) -> str:
        return f"{text:<72}{section}{number:>7}\n"

    head = card("A square", "S", 1)
    values = "1H,,1H;,4Hmade,4Hmade,1Ha,1Ha,32,38,6,308,15,4Hmade,1.,2,2HMM,1,0.01,15H20260101.000000,1E-6,10.,1Ha,1Ha,"
    values += "11,0,15H20260101.000000;"
    rows = [values[at : at + 72] for at in range(0, len(values), 72)]
    head += "".join(card(row, "G", number + 1) for number, row in enumerate(rows))
    corners = [(0, 0), (10, 0), (10, 10), (0, 10)]
    ends = zip(corners, corners[1:] + corners[:1], strict=True)
    parameters = [f"110,{a}.,{b}.,0.,{c}.,{d}.,0.;" for (a, b), (c, d) in ends]
    parameters += ["102,4,1,3,5,7;", "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,10.,0.,0.,"
                   "0.,10.,0.,10.,10.,0.,0.,1.,0.,1.;", "142,0,11,0,9,2;", "144,11,1,0,13;"]  # fmt: skip
    directory, data, line = "", "", 1
    for number, text in enumerate(parameters):
        kind = text.split(",")[0]
        parts = [text[at : at + 64] for at in range(0, len(text), 64)]
        fields = [kind, line, 0, 0, 0, 0, 0, 0, "00000000" if kind == "144" else "00010000"]
        directory += card("".join(f"{field:>8}" for field in fields), "D", 2 * number + 1)
        fields = [kind, 0, 0, len(parts), 0, "", "", "", 0]
        directory += card("".join(f"{field:>8}" for field in fields), "D", 2 * number + 2)
        for part in parts:
            data += f"{part:<64}{2 * number + 1:>8}P{line:>7}\n"
            line += 1
    counts = f"S{1:>7}G{len(rows):>7}D{2 * len(parameters):>7}P{line - 1:>7}"
    return head + directory + data + card(counts, "T", 1)


@functools.cache
def _written(folder: Path) -> dict[str, list[Path]]:
    """Write the variants of the tests' writers below a folder; return them by the kind that they are read as."""
    found: dict[str, list[Path]] = {}
    for name, numbers in _WRITTEN.items():
        for number in numbers:
            own = folder / f"{name}{number}"
            own.mkdir(parents=True)
            path = writers().VARIANTS[name](number, own).path
            kind = "draco" if name == "draco" else kind_of(path, path.read_bytes())
            found.setdefault(kind, []).append(path)
    return found


def _make(kind: str, folder: Path) -> list[Path]:
    _by_hand(kind, folder)
    made = [path for path in sorted(folder.iterdir()) if path.suffix not in (".bin", ".mtl")]
    return [*made, *_written(folder.parent / "written meshes").get(kind, [])]


def _check_libraries(kind: str) -> None:
    library = OUTSIDE.get(kind, "draco" if kind == "draco" else "")
    if library:
        importlib.import_module(worker._READERS[library])


def reader_of(kind: str) -> Reader:
    """Return the reader of a kind of mesh."""
    outside = kind in OUTSIDE or kind == "draco"

    def make(folder: Path) -> list[Path]:
        _check_libraries(kind)
        return _make(kind, folder)

    return Reader(f"mesh:{kind}", _read, make, memory=1024 * MEGABYTE, outside=outside)


def read_kind(path: Path) -> str:
    """Return the kind of a mesh file; "" where it is none."""
    try:
        return kind_of(path, path.read_bytes())
    except FileError:
        return ""


READERS = [reader_of(kind) for kind in (*_OWN_KINDS, "draco", *OUTSIDE)]
