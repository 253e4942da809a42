"""glTF and GLB: accessors, buffers, node graphs and extensions; what is damaged is refused with its place."""

from __future__ import annotations

import base64
import json
import math
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import trimesh

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.glb import split_glb
from brdf_suite.files.meshes.reading import read_mesh, write_mesh_glb
from brdf_suite.surface.mesh import Mesh, PartGeometry


def one_line(error: pytest.ExceptionInfo[FileError]) -> str:
    text = str(error.value)
    assert "\n" not in text
    return text


@pytest.mark.parametrize("name", ["CesiumMilkTruck.glb", "materialx_shaderball.glb"])
@pytest.mark.parametrize("share", [0.0001, 0.01, 0.5, 0.999])
def test_truncated_binary_gltf(shared_data: Path, tmp_path: Path, name: str, share: float) -> None:
    data = (shared_data / "meshes" / name).read_bytes()
    file = tmp_path / name
    file.write_bytes(data[: int(len(data) * share)])
    with pytest.raises(FileError, match=r"cut short|does not begin"):
        read_mesh(file)


def own_mesh(corners: int = 5) -> Mesh:
    rng = np.random.default_rng(corners)
    parts = []
    for name, material in (("shell", "paint"), ("pane", "glass")):
        normals = rng.normal(size=(corners, 3))
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        triangles = rng.integers(0, corners, (2 * corners, 3))
        uvs = rng.random((corners, 2)) * 1000
        parts.append(PartGeometry(name, material, rng.random((corners, 3)), normals, uvs, triangles))
    return Mesh("own", tuple(parts))


@pytest.mark.parametrize("corners", [5, 65534, 65536])
def test_our_own_files_come_back_exactly(tmp_path: Path, corners: int) -> None:
    mesh = own_mesh(corners)
    write_mesh_glb(mesh, tmp_path / "own.glb")
    again = read_mesh(tmp_path / "own.glb")
    assert again.name == "own"
    assert not again.notes
    for before, after in zip(mesh.parts, again.parts, strict=True):
        assert (before.name, before.material) == (after.name, after.material)
        for field in ("positions", "normals", "uvs", "triangles"):
            np.testing.assert_array_equal(getattr(before, field), getattr(after, field))
    first = (tmp_path / "own.glb").read_bytes()
    write_mesh_glb(mesh, tmp_path / "own.glb")
    assert (tmp_path / "own.glb").read_bytes() == first
    assert [file.name for file in tmp_path.iterdir()] == ["own.glb"]


def test_our_own_files_are_gltf_for_others(tmp_path: Path) -> None:
    mesh = own_mesh(50)
    write_mesh_glb(mesh, tmp_path / "own.glb")
    scene = trimesh.load_scene(tmp_path / "own.glb", process=False)
    assert set(scene.geometry) == {"shell", "pane"}
    pane = scene.geometry["pane"]
    assert pane.visual.material.name == "glass"
    np.testing.assert_array_equal(pane.vertices, mesh.parts[1].positions)
    np.testing.assert_array_equal(pane.faces, mesh.parts[1].triangles)


def test_a_damaged_file_of_ours_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "own.glb"
    write_mesh_glb(own_mesh(), file)
    data = file.read_bytes()
    file.write_bytes(data.replace(b'"POSITION":0', b'"POSITION":9'))
    with pytest.raises(FileError, match="damaged mesh file"):
        read_mesh(file)
    file.write_bytes(data.replace(b'"name":"glass"', b'"name":"gloss"'))
    with pytest.raises(FileError, match="'gloss' is none of"):
        read_mesh(file)


def test_writing_into_a_missing_folder_is_an_error_of_the_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be written"):
        write_mesh_glb(own_mesh(), tmp_path / "none" / "own.glb")


def test_our_own_files_are_read_without_the_slow_library(tmp_path: Path) -> None:
    write_mesh_glb(own_mesh(), tmp_path / "own.glb")
    code = (
        "import sys; from brdf_suite.files.meshes.reading import read_mesh; read_mesh(sys.argv[1]);"
        "sys.exit('trimesh' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code, tmp_path / "own.glb"], check=False, timeout=240)
    assert done.returncode == 0


def test_a_gltf_with_its_buffer_beside_it(shared_data: Path, tmp_path: Path) -> None:
    for name, content in (
        trimesh.creation.icosphere(subdivisions=2, radius=0.5).export(file_type="gltf").items()
    ):
        (tmp_path / ("ball.gltf" if name.endswith("gltf") else name)).write_bytes(content)
    assert read_mesh(tmp_path / "ball.gltf").triangle_count == 320
    for file in tmp_path.glob("*.bin"):
        file.unlink()
    with pytest.raises(FileError):
        read_mesh(tmp_path / "ball.gltf")


TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<3H", 0, 1, 2)


def gltf(tmp_path: Path, content: bytes = TRIANGLE, name: str = "a.gltf", **more: object) -> Path:
    """A glTF file of one triangle, or with what is given in place of its parts."""
    document: dict[str, object] = {
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0}],
        "meshes": [{"name": "part", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 6},
        ],
        "buffers": [
            {
                "byteLength": len(content),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(content).decode(),
            }
        ],
    }
    file = tmp_path / name
    file.write_text(json.dumps(document | more))
    return file


def calls_of_reading(file: Path) -> int:
    """How many functions are called while a mesh is read: a measure of time that no machine changes."""
    count = 0

    def called(_frame: object, event: str, _argument: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(called)
    try:
        assert read_mesh(file).triangle_count > 0
    finally:
        sys.setprofile(None)
    return count


def chain(nodes: int) -> list[dict[str, object]]:
    """Each node is the only child of the one before; the last holds the mesh."""
    links = [{"children": [n + 1], "translation": [1e-4, 0, 0]} for n in range(nodes - 1)]
    return [*links, {"mesh": 0}]


def instances(nodes: int) -> list[dict[str, object]]:
    return [{"mesh": 0, "translation": [2.0 * (n % 10), 2.0 * (n // 10), 0]} for n in range(nodes)]


@pytest.mark.parametrize("scene", [chain, instances])
def test_a_scene_graph_is_walked_once(tmp_path: Path, scene) -> None:
    read_mesh(gltf(tmp_path))  # imports
    some, more = (calls_of_reading(gltf(tmp_path, nodes=scene(count))) for count in (1_000, 4_000))
    assert more < 4.2 * some
    assert more < 60 * 4_000


def test_a_long_chain_adds_up_and_many_instances_are_all_there(tmp_path: Path) -> None:
    low, _ = read_mesh(gltf(tmp_path, nodes=chain(5_001))).bounds()
    assert low[0] == pytest.approx(0.5, rel=1e-6)
    mesh = read_mesh(gltf(tmp_path, nodes=instances(400)), unit="m")
    assert mesh.triangle_count == 400
    assert len(mesh.parts) == 1
    assert [part.triangles.shape for part in read_mesh(gltf(tmp_path, nodes=instances(9))).parts] == [
        (1, 3)
    ] * 9
    np.testing.assert_allclose(mesh.bounds()[1], [19.0, 79.0, 0.0])
    mirrored = [{**node, "scale": [-1, 1, 1]} for node in instances(400)]
    (part,) = read_mesh(gltf(tmp_path, nodes=mirrored), unit="m").parts
    a, b, c = (part.positions[part.triangles[:, k]] for k in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0.0).all(), "mirrored triangles are turned back"


@pytest.mark.parametrize("named", [[0, 0], [0, 1]])
def test_a_scene_draws_each_node_once(tmp_path: Path, named: list[int]) -> None:
    nodes = [{"children": [1]}, {"mesh": 0}]
    with pytest.raises(
        FileError, match="scenes: a scene names a node twice, or one that stands below another"
    ):
        read_mesh(gltf(tmp_path, nodes=nodes, scenes=[{"nodes": named}]))


@pytest.mark.parametrize("count", [1, 400])
def test_a_corner_that_is_not_there_costs_its_triangle_in_every_instance(tmp_path: Path, count: int) -> None:
    content = TRIANGLE[:36] + struct.pack("<6H", 0, 1, 2, 0, 1, 3)
    accessors = [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
    ]
    views = [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12}]
    mesh = read_mesh(
        gltf(tmp_path, content, nodes=instances(count), accessors=accessors, bufferViews=views), unit="m"
    )
    assert mesh.triangle_count == count
    np.testing.assert_allclose(mesh.bounds()[1], [19.0, 79.0, 0.0] if count > 1 else [1.0, 1.0, 0.0])


@pytest.mark.parametrize(
    "uri", ["//host/share/a.bin", "\\\\host\\a.bin", "C:/a.bin", "..%2Fa.bin", "/etc/passwd"]
)
def test_buffers_elsewhere_are_refused_by_their_name_alone(tmp_path: Path, uri: str) -> None:
    with pytest.raises(FileError, match="which is not in its folder"):
        read_mesh(gltf(tmp_path, buffers=[{"byteLength": 42, "uri": uri}]))


def test_rotation_scale_and_matrix_place_a_part(tmp_path: Path) -> None:
    half = math.sqrt(0.5)
    turned = [{"mesh": 0, "rotation": [0, 0, half, half], "scale": [2, 3, 1], "translation": [5, 0, 0]}]
    as_matrix = [{"mesh": 0, "matrix": [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]}]
    for nodes in (turned, as_matrix):
        low, high = read_mesh(gltf(tmp_path, nodes=nodes)).bounds()
        np.testing.assert_allclose([low, high], [[2, 0, 0], [5, 2, 0]], atol=1e-6)


@pytest.mark.parametrize(
    ("component", "numbers", "normalized", "size"),
    [
        (5120, "<9b3x3H", True, 127),
        (5121, "<9B3x3H", True, 255),
        (5122, "<9h2x3H", True, 32767),
        (5123, "<9H2x3H", True, 65535),
        (5120, "<9b3x3H", False, 100),
        (5123, "<9H2x3H", False, 4000),
    ],
)
def test_quantized_positions_are_read(
    tmp_path: Path, component: int, numbers: str, normalized: bool, size: int
) -> None:
    """As optimizers write them: whole numbers, normalized or not, which the node's scale takes to metres."""
    content = struct.pack(numbers, 0, 0, 0, size, 0, 0, 0, size, 0, 0, 1, 2)
    scale = 2.0 if normalized else 2.0 / size
    file = gltf(
        tmp_path,
        content,
        extensionsUsed=["KHR_mesh_quantization"],
        extensionsRequired=["KHR_mesh_quantization"],
        nodes=[{"mesh": 0, "scale": [scale] * 3}],
        accessors=[
            {
                "bufferView": 0,
                "componentType": component,
                "normalized": normalized,
                "count": 3,
                "type": "VEC3",
            },
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
        ],
        bufferViews=[
            {"buffer": 0, "byteLength": len(content) - 6},
            {"buffer": 0, "byteOffset": len(content) - 6, "byteLength": 6},
        ],
    )
    low, high = read_mesh(file).bounds()
    np.testing.assert_allclose([low, high], [[0, 0, 0], [2, 2, 0]], atol=1e-6)


def test_a_quantized_real_file_is_the_file(shared_data: Path, tmp_path: Path) -> None:
    """Each part's positions as normalized 16-bit numbers in strides of 8 bytes, scaled by a node, as gltfpack does."""
    whole = read_mesh(shared_data / "meshes" / "CesiumMilkTruck.glb")
    content, nodes, meshes, accessors, views = bytearray(), [], [], [], []
    for number, part in enumerate(whole.parts):
        low, high = part.positions.min(axis=0), part.positions.max(axis=0)
        half, middle = 0.5 * (high - low).max(), 0.5 * (low + high)
        codes = np.zeros((len(part.positions), 4), "<i2")
        codes[:, :3] = np.round((part.positions - middle) / half * 32767)
        for array in (codes, part.triangles.astype("<u4")):
            views.append({"buffer": 0, "byteOffset": len(content), "byteLength": array.nbytes})
            content += array.tobytes()
        views[-2]["byteStride"] = 8
        accessors += [
            {
                "bufferView": 2 * number,
                "componentType": 5122,
                "normalized": True,
                "count": len(codes),
                "type": "VEC3",
            },
            {
                "bufferView": 2 * number + 1,
                "componentType": 5125,
                "count": part.triangles.size,
                "type": "SCALAR",
            },
        ]
        meshes.append({"primitives": [{"attributes": {"POSITION": 2 * number}, "indices": 2 * number + 1}]})
        nodes.append({"mesh": number, "scale": [float(half)] * 3, "translation": middle.tolist()})
    required = ["KHR_mesh_quantization"]
    parts = {"nodes": nodes, "meshes": meshes, "accessors": accessors, "bufferViews": views}
    mesh = read_mesh(gltf(tmp_path, bytes(content), extensionsRequired=required, **parts), unit="m")
    assert mesh.triangle_count == pytest.approx(
        whole.triangle_count, abs=20
    )  # the thinnest have no area any more
    np.testing.assert_allclose(mesh.bounds(), whole.bounds(), atol=1e-4)


@pytest.mark.parametrize(
    "name",
    [
        "KHR_materials_clearcoat",
        "KHR_materials_unlit",
        "KHR_materials_variants",
        "KHR_materials_pbrSpecularGlossiness",
        "KHR_texture_transform",
        "KHR_texture_basisu",
        "EXT_texture_webp",
        "KHR_lights_punctual",
        "EXT_structural_metadata",
    ],
)
def test_required_extensions_that_change_no_triangle_are_passed_over(tmp_path: Path, name: str) -> None:
    assert read_mesh(gltf(tmp_path, extensionsRequired=[name])).triangle_count == 1


@pytest.mark.parametrize(
    "name",
    [
        "EXT_mesh_gpu_instancing",
        "KHR_node_visibility",
        "KHR_gaussian_splatting",
        "MSFT_lod",
        "CESIUM_RTC",
        "ACME_new_geometry",
        "",
    ],
)
@pytest.mark.parametrize("ending", ["gltf", "glb"])
def test_a_required_extension_that_is_not_read_is_refused_by_name(
    tmp_path: Path, name: str, ending: str
) -> None:
    file = gltf(tmp_path, extensionsRequired=["KHR_materials_unlit", name])
    if ending == "glb":
        text = file.read_bytes() + b" " * (-len(file.read_bytes()) % 4)
        head = struct.pack("<4sII", b"glTF", 2, 20 + len(text)) + struct.pack("<I4s", len(text), b"JSON")
        file = tmp_path / "a.glb"
        file.write_bytes(head + text)
    with pytest.raises(
        FileError, match=f"at extensionsRequired: it requires the extension {name}, which is not read"
    ):
        read_mesh(file)


def test_strips_fans_interleaved_and_sparse_values_are_read(tmp_path: Path) -> None:
    corners = struct.pack("<15f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0)
    for mode, triangles in ((5, 3), (6, 3), (4, 1)):
        primitive = {"attributes": {"POSITION": 0}, "mode": mode}
        accessors = [{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"}]
        views = [{"buffer": 0, "byteLength": 60}]
        meshes = [{"primitives": [primitive]}]
        file = gltf(tmp_path, corners, accessors=accessors, bufferViews=views, meshes=meshes)
        (part,) = read_mesh(file).parts
        assert len(part.triangles) == triangles
        a, b, c = (part.positions[part.triangles[:, k]] for k in range(3))
        assert mode == 6 or (np.cross(b - a, c - a)[:, 2] > 0.0).all(), "a strip turns every other triangle"
    content = TRIANGLE + b"\0\0" + struct.pack("<I3f", 2, 0, 3, 0)
    changed = {"bufferView": 2, "componentType": 5125}
    sparse = {"count": 1, "indices": changed, "values": {"bufferView": 2, "byteOffset": 4}}
    points = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "sparse": sparse}
    indices = {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}
    views = [
        {"buffer": 0, "byteLength": 36},
        {"buffer": 0, "byteOffset": 36, "byteLength": 6},
        {"buffer": 0, "byteOffset": 44, "byteLength": 16},
    ]
    mesh = read_mesh(gltf(tmp_path, content, accessors=[points, indices], bufferViews=views))
    np.testing.assert_allclose(mesh.bounds()[1], [1, 3, 0])


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"accessors": [{"bufferView": 0, "byteOffset": 1 << 63, "componentType": 5126, "count": 3, "type": "VEC3"}]},
         "at accessors[0]: byteOffset is 9223372036854775808"),
        ({"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}]},
         "at accessors[0]: its values reach past the end of the file"),
        ({"accessors": [{"bufferView": 0, "componentType": 5126, "count": -3, "type": "VEC3"}]},
         "at accessors[0]: count is -3"),
        ({"accessors": [{"bufferView": -1, "componentType": 5126, "count": 3, "type": "VEC3"}]},
         "refers to data that it does not hold"),
        ({"nodes": [{"mesh": 0, "translation": [1, 2]}]}, "at nodes[0]: its matrix, translation"),
        ({"nodes": [{"mesh": 0, "scale": [1e300, 1, 1]}, {"mesh": 0}], "scenes": [{"nodes": [1, 7]}]},
         "refers to data that it does not hold"),
        ({"nodes": [{"children": [2]}, {"children": [2]}, {"mesh": 0}]}, "at nodes[1].children: a child of two nodes"),
        ({"nodes": [{"children": 5}]}, "refers to data that it does not hold"),
        ({"buffers": [{"byteLength": 42, "uri": "../a.bin"}]}, "refers to ../a.bin, which is not in its folder"),
        ({"buffers": [{"byteLength": 42, "uri": "/etc/passwd"}]}, "which is not in its folder"),
        ({"buffers": [{"byteLength": 42, "uri": "https://example.org/a.bin"}]}, "needs a.bin beside it"),
    ],
)  # fmt: skip
def test_damaged_gltf_names_the_place(tmp_path: Path, change: dict[str, object], said: str) -> None:
    with pytest.raises(FileError) as error:
        read_mesh(gltf(tmp_path, **change))
    assert said in one_line(error)


def test_a_byte_offset_that_no_file_has_is_refused_in_our_own_files(tmp_path: Path) -> None:
    file = tmp_path / "own.glb"
    write_mesh_glb(own_mesh(), file)
    document, binary = split_glb(file, file.read_bytes())
    document["bufferViews"][0]["byteOffset"] = 1 << 63
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)) + struct.pack(
        "<I4s", len(text), b"JSON"
    )
    file.write_bytes(head + text + struct.pack("<I4s", len(binary), b"BIN\0") + bytes(binary))
    with pytest.raises(FileError, match="damaged mesh file"):
        read_mesh(file)


def test_a_required_extension_that_is_not_read_is_named_in_letters_that_can_be_shown(tmp_path: Path) -> None:
    for name, shown in (
        ("EXT_mesh_gpu_instancing", "EXT_mesh_gpu_instancing"),
        ("EXT\x7f\n", r"'EXT\x7f\n'"),
    ):
        with pytest.raises(FileError) as error:
            read_mesh(gltf(tmp_path, extensionsRequired=[name]))
        assert f"requires the extension {shown}, which is not read" in str(error.value)
        assert str(error.value).isprintable()
