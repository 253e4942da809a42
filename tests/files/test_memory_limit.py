"""Small files that announce much are refused before it is made: measured in a process of its own."""

from __future__ import annotations

import base64
import json
import struct
import subprocess
import sys
import tempfile
import zlib
from collections.abc import Callable, Iterator
from itertools import pairwise, takewhile
from pathlib import Path
from threading import Timer

import numpy as np
import pytest
from PIL import Image

from brdf_suite.errors import FileError
from brdf_suite.files import bounded_reading
from brdf_suite.files.bounded_reading import MOST_MADE_BYTES, check_made
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.meshes.glb import split_glb, write_mesh_glb
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.regular_files import within_memory
from brdf_suite.surface.mesh import Mesh, PartGeometry

MEASURE = """
import os, sys
from brdf_suite.acquisition.photographs.reading import read_photograph
from brdf_suite.errors import FileError
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.images.pictures import read_rgb
from brdf_suite.files.meshes.reading import read_mesh
import PIL.JpegImagePlugin, PIL.PngImagePlugin, PIL.WebPImagePlugin
def read_picture_within(named):  # a path and the bytes allowed
    path, most = named.split("?")
    read_rgb(path, ("PNG", "JPEG", "WEBP"), most_bytes=int(most))
import OpenEXR, scipy.spatial, tifffile
def peak():  # of this process alone: getrusage begins with the peak of the process that started it
    with open("/proc/self/status") as status:
        kb = {line.split()[0]: int(line.split()[1]) for line in status if line.endswith("kB\\n")}
    return kb["VmHWM:"] - kb["RssFile:"] >> 10  # the system may drop code of libraries and load it again
for line in sys.stdin:
    if os.fork():  # this process only imports, which takes longer than most of the reading
        os.wait()
        print("end", flush=True)
        continue
    reader, path = line.rstrip().split(chr(9))
    before = peak()
    try:
        globals()[reader](path)
        print("read")
    except FileError as error:
        print(error)
    print(peak() - before, flush=True)
    os._exit(0)
"""

Measured = Callable[[str, Path], tuple[str, int]]


@pytest.fixture(scope="module")
def measured() -> Iterator[Measured]:
    """What a reader says of a file, ``read`` where it takes it, and by how many MB a process of its own grew."""
    command = [sys.executable, "-P", "-c", MEASURE]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:

        def measure(reader: str, path: Path) -> tuple[str, int]:
            assert process.stdin is not None
            assert process.stdout is not None
            process.stdin.write(f"{reader}\t{path}\n")
            process.stdin.flush()
            hanging = Timer(240.0, process.kill)
            hanging.start()
            said, grown = [
                line.rstrip("\n") for line in takewhile(lambda line: line != "end\n", process.stdout)
            ]
            hanging.cancel()
            return said, int(grown)

        yield measure


def gltf(accessors: list[dict[str, object]], **more: object) -> bytes:
    primitive = {"attributes": {"POSITION": 0}, "indices": 1}
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "accessors": accessors,
        **more,
    }
    return json.dumps(document).encode()


def not_stored(count: int) -> bytes:
    points = {"componentType": 5126, "type": "VEC3", "count": count}
    return gltf([points, {"componentType": 5125, "type": "SCALAR", "count": count}])


def sparse(count: int) -> bytes:
    stored = {"bufferView": 0, "componentType": 5125}
    changed = {"count": 1, "indices": stored, "values": {"bufferView": 0}}
    points = {"componentType": 5126, "type": "VEC3", "count": count, "sparse": changed}
    indices = {"componentType": 5125, "type": "SCALAR", "count": count}
    views = [{"buffer": 0, "byteLength": 12}]
    buffers = [{"byteLength": 12, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAA"}]
    return gltf([points, indices], bufferViews=views, buffers=buffers)


def instances(triangles: int, nodes: int) -> bytes:
    """Many nodes with one mesh of many triangles, all of which are the same in the file."""
    points = {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}
    indices = {"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 3 * triangles}
    views = [
        {"buffer": 0, "byteLength": 36},
        {"buffer": 0, "byteOffset": 36, "byteLength": 3 * triangles},
    ]
    content = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + b"\0\1\2" * triangles
    uri = "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    return gltf(
        [points, indices],
        bufferViews=views,
        buffers=[{"byteLength": len(content), "uri": uri}],
        nodes=[{"mesh": 0}] * nodes,
        scenes=[{"nodes": list(range(nodes))}],
    )


def own_instances(triangles: int, nodes: int) -> bytes:
    """A mesh of ours that many nodes show."""
    corner = np.eye(3, dtype=np.float32)
    up = np.tile(np.float32([0, 0, 1]), (3, 1))
    part = PartGeometry("a", "paint", corner, up, corner[:, :2], np.tile([[0, 1, 2]], (triangles, 1)))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.glb"
        write_mesh_glb(Mesh("a", (part,)), path)
        document, binary = split_glb(path, path.read_bytes())
    document["nodes"] *= nodes
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def radiance(width: int, height: int) -> bytes:
    """Black lines of the old run-length coding, where a line takes a few bytes."""
    line = b"\0\0\0\0" + b"\1\1\1\xff" * 0
    left, shift = width - 1, 0
    while left:
        line += bytes((1, 1, 1, left & 255))
        left, shift = left >> 8, shift + 8
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode() + line * height


def tiff(field: int, values: int) -> bytes:
    """A grey TIFF of a million rows in which a field holds many values."""
    fields = {256: 16, 257: 1 << 20, 258: 8, 259: 1, 262: 1, 273: 8, 277: 1, 278: 1 << 20, 279: 64}
    blob = bytes(64) + struct.pack(f"<{values}I", *(fields[field],) * values)
    rows = [
        struct.pack("<HHII", code, 4, *((values, 72) if code == field else (1, value)))
        for code, value in fields.items()
    ]
    head = b"II*\0" + struct.pack("<I", 8 + len(blob)) + blob
    return head + struct.pack("<H", len(rows)) + b"".join(rows) + bytes(4)


def png(width: int, height: int, bits: int = 16, packed: bytes = b"") -> bytes:
    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, bits, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


@pytest.mark.parametrize(
    ("reader", "name", "content", "place", "reason"),
    [
        ("read_mesh", "a.gltf", lambda: not_stored(200_000_000), "accessors[0]", "would take 4.5 GiB"),
        ("read_mesh", "a.gltf", lambda: sparse(200_000_000), "accessors[0]", "would take 4.5 GiB"),
        ("read_mesh", "a.gltf", lambda: sparse(20_000_000), "accessors[0]", "are not in the file"),
        ("read_mesh", "a.gltf", lambda: instances(5_000, 20_000), "nodes", "all nodes would take"),
        ("read_mesh", "a.gltf", lambda: instances(5_000, 640), "nodes", "all nodes would take"),
        ("read_mesh", "a.glb", lambda: own_instances(5_000, 20_000), "nodes", "all nodes would take"),
        ("read_environment_image", "a.hdr", lambda: radiance(524288, 256), "byte 35", "would take 1.2 GiB"),
        ("read_photograph", "a.tif", lambda: tiff(256, 513), "field ImageWidth", "holds 513 values"),
        ("read_photograph", "a.png", lambda: png(1 << 14, 1 << 14), "IHDR", "would take 3.5 GiB"),
    ],
)
def test_small_files_that_announce_gigabytes_are_refused_within_one(
    tmp_path: Path,
    measured: Measured,
    reader: str,
    name: str,
    content: Callable[[], bytes],
    place: str,
    reason: str,
) -> None:
    path = tmp_path / name
    path.write_bytes(content())
    assert path.stat().st_size < 1 << 20
    said, grown = measured(reader, path)
    assert f"{path}, at {place}: " in said
    assert reason in said
    assert grown < 256


def test_what_is_large_and_true_is_read(tmp_path: Path, measured: Measured) -> None:
    """An environment of the largest size that is not reduced, and a mesh of two million triangles."""
    path = tmp_path / "large.hdr"
    path.write_bytes(radiance(8192, 4096))
    assert measured("read_environment_image", path)[0] == "read"
    side = 1000
    x, y = np.meshgrid(np.arange(side, dtype="<f4"), np.arange(side, dtype="<f4"))
    points = np.column_stack((x.ravel(), y.ravel(), np.sin(x + y).ravel())) * np.float32(1e-3)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    square = np.column_stack(
        (corner, corner + 1, corner + side, corner + side, corner + 1, corner + side + 1)
    )
    up = np.zeros_like(points)  # normals are in the file: to make them would take most of the time
    up[:, 2] = 1.0
    arrays = [points.astype("<f4"), square.astype("<u4"), up]
    (tmp_path / "large.bin").write_bytes(b"".join(array.tobytes() for array in arrays))
    ends = np.cumsum([0, *(array.nbytes for array in arrays)]).tolist()
    views = [{"buffer": 0, "byteOffset": start, "byteLength": end - start} for start, end in pairwise(ends)]
    accessors = [
        {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": len(points)},
        {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": square.size},
        {"bufferView": 2, "componentType": 5126, "type": "VEC3", "count": len(points)},
    ]
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}
    buffers = [{"byteLength": ends[-1], "uri": "large.bin"}]
    mesh = tmp_path / "large.gltf"
    mesh.write_bytes(
        gltf(accessors, bufferViews=views, buffers=buffers, meshes=[{"primitives": [primitive]}])
    )
    assert read_mesh(mesh).triangle_count == 2 * (side - 1) ** 2


def test_what_is_below_the_limit_is_read_within_it(tmp_path: Path, measured: Measured) -> None:
    """Instances of a small file, and a photograph whose pixels nearly reach the limit."""
    mesh = tmp_path / "instances.gltf"
    mesh.write_bytes(instances(5_000, 580))
    said, grown = measured("read_mesh", mesh)
    assert said == "read"
    assert grown < 256, "instances are repaired in parts, of which each is released"
    photograph = tmp_path / "large.png"
    side = 8_700
    packer, row = zlib.compressobj(1), bytes(1 + 8 * side)
    packed = b"".join(packer.compress(row) for _ in range(side)) + packer.flush()
    photograph.write_bytes(
        png(side, side, 16, packed)
    )  # with alpha, so that three of four channels are copied
    said, grown = measured("read_photograph", photograph)
    assert said == "read"
    assert 900 < grown < 1080


@pytest.mark.parametrize(
    ("name", "options", "each"),
    [
        ("a.png", {"compress_level": 1}, 7),
        ("a.jpg", {}, 7),
        ("a.jpg", {"progressive": True, "subsampling": 0}, 10),
        ("a.webp", {"method": 0}, 17),
    ],
)
def test_a_picture_takes_what_is_counted(
    tmp_path: Path, measured: Measured, name: str, options: dict[str, object], each: int
) -> None:
    path, width, height = tmp_path / name, 4000, 3000
    Image.new("RGB", (width, height), (40, 80, 120)).save(path, **options)
    most = each * width * height + (12 << 20)
    said, grown = measured("read_picture_within", Path(f"{path}?{most}"))
    assert said == "read"
    assert grown <= (most >> 20) + 10  # and what the interpreter took
    said, _ = measured("read_picture_within", Path(f"{path}?{most - 1}"))
    assert "too large to be read" in said


def test_a_file_that_holds_its_triangles_may_make_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bounded_reading, "MOST_MADE_BYTES", 100_000)
    side = 60
    x, y = np.meshgrid(np.arange(side, dtype="<f4"), np.arange(side, dtype="<f4"))
    points = np.column_stack((x.ravel(), y.ravel(), x.ravel())).astype("<f4")
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    square = np.column_stack((corner, corner + 1, corner + side)).astype("<u4")
    accessors = [
        {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": len(points)},
        {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": square.size},
    ]
    views = [
        {"buffer": 0, "byteLength": points.nbytes},
        {"buffer": 0, "byteOffset": points.nbytes, "byteLength": square.nbytes},
    ]
    content = points.tobytes() + square.tobytes()
    (tmp_path / "a.bin").write_bytes(content)
    buffers = [{"byteLength": len(content), "uri": "a.bin"}]
    path = tmp_path / "a.gltf"
    for nodes in (1, 3):
        path.write_bytes(
            gltf(
                accessors,
                bufferViews=views,
                buffers=buffers,
                nodes=[{"mesh": 0}] * nodes,
                scenes=[{"nodes": list(range(nodes))}],
            )
        )
        if nodes == 1:
            assert read_mesh(path).triangle_count == len(square)
        else:
            with pytest.raises(FileError, match="at nodes: the triangles of all nodes would take"):
                read_mesh(path)


def test_text_with_polygons_of_many_corners_is_counted_by_its_triangles(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bounded_reading, "MOST_MADE_BYTES", 1 << 16)
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + " 1 2 3" * 1_000 + "\n", "ascii")
    with pytest.raises(FileError, match="its triangles would take"):
        read_mesh(path)


@pytest.mark.parametrize(("width", "height"), [(1_000_000, 3), (3, 1_000_000)])
def test_an_image_thinner_than_its_reduction_is_refused(tmp_path: Path, width: int, height: int) -> None:
    path = tmp_path / "thin.hdr"
    path.write_bytes(
        b"#?RADIANCE\n\n" + f"-Y {height} +X {width}\n".encode() + bytes(4) * 8 * max(width, height)
    )
    with pytest.raises(FileError, match="too thin to be reduced"):
        read_environment_image(path)


def test_the_limit_is_one_and_names_the_place(monkeypatch: pytest.MonkeyPatch) -> None:
    check_made("a.exr", MOST_MADE_BYTES, "its pixels")
    with pytest.raises(
        FileError,
        match=r"^a\.exr, at byte 4: its pixels would take 2\.0 GiB; 1 GiB is allowed \(BRDF_SUITE_READ_MB",
    ):
        check_made("a.exr", 2 * MOST_MADE_BYTES, "its pixels", "byte 4")
    check_made("a.glb", 5 * MOST_MADE_BYTES, "its triangles", held=MOST_MADE_BYTES // 6)
    with pytest.raises(FileError, match=r"would take 6\.0 GiB; 5\.33 GiB is allowed"):
        check_made("a.glb", 6 * MOST_MADE_BYTES, "its triangles", held=MOST_MADE_BYTES // 6)
    with pytest.raises(FileError, match="more memory than there is"):
        check_made("a.exr", 1 << 200, "its pixels")
    monkeypatch.setenv("BRDF_SUITE_READ_MB", "4000")
    check_made("a.exr", 2 * MOST_MADE_BYTES, "its pixels")
    for damaged in ("4 GB", "-5", "1"):
        monkeypatch.setenv("BRDF_SUITE_READ_MB", damaged)
        with pytest.raises(FileError, match="1 GiB is allowed"):
            check_made("a.exr", 2 * MOST_MADE_BYTES, "its pixels")


def test_no_memory_is_an_error_of_the_file(tmp_path: Path) -> None:
    @within_memory
    def read(path: object, size: int) -> bytes:
        return bytes(size)

    assert read("a.png", 3) == bytes(3)
    with pytest.raises(FileError, match=r"^a\.png: there is not enough memory"):
        read("a.png", 1 << 62)
