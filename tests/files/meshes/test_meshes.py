"""Meshes of others are read, repaired aloud, or refused in one line."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.surface.part_materials import named_material


def ball_of_triangles() -> trimesh.Trimesh:
    return trimesh.creation.icosphere(subdivisions=2, radius=0.5)


def one_line(error: pytest.ExceptionInfo[FileError]) -> str:
    text = str(error.value)
    assert "\n" not in text
    return text


@pytest.mark.parametrize(
    ("name", "triangles", "materials"),
    [
        ("CesiumMilkTruck.glb", 3624, ["paint", "glass", "trim", "rubber", "rubber"]),
        ("materialx_shaderball.glb", 88264, ["neutral", "paint"]),
        ("spot.obj", 5856, ["paint"]),
        ("teapot.obj", 6320, ["paint"]),
    ],
)
def test_real_files(shared_data: Path, name: str, triangles: int, materials: list[str]) -> None:
    mesh = read_mesh(shared_data / "meshes" / name)
    assert mesh.triangle_count == triangles
    assert [part.material for part in mesh.parts] == materials
    for part in mesh.parts:
        a, b, c = (part.positions[part.triangles[:, k]] for k in range(3))
        facing = np.einsum("ij,ij->i", np.cross(b - a, c - a), part.normals[part.triangles].sum(axis=1))
        assert (facing > 0).mean() > 0.99, "normals point to the side that triangles are wound for"


@pytest.mark.parametrize("ending", ["glb", "obj", "stl", "ply"])
def test_every_format_gives_the_same_sphere(tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"ball.{ending}"
    ball_of_triangles().export(file)
    mesh = read_mesh(file)
    (part,) = mesh.parts
    outwards = np.einsum("ij,ij->i", part.positions, part.normals) / 0.5
    assert outwards.min() > 0.99
    assert mesh.triangle_count == 320
    assert any("texture coordinates" in note for note in mesh.notes)
    # Projected coordinates are lengths on the surface: the area in mm² agrees within the projection's √3.
    corners = part.uvs.astype(np.float64)[part.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    flat = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]).sum() / 2
    assert 0.6 < flat / (np.pi * 1e6) <= 1.0


def test_scene_transforms_apply_to_positions_and_normals(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    ball = ball_of_triangles()
    ball.vertex_normals  # noqa: B018 - makes the exporter write them
    mirror = np.diag([-2.0, 1.0, 1.0, 1.0])
    mirror[:3, 3] = [5.0, 0.0, 0.0]
    scene.add_geometry(ball, node_name="left", geom_name="left tyre")
    scene.add_geometry(ball, node_name="right", geom_name="right", transform=mirror)
    file = tmp_path / "two.glb"
    scene.export(file, include_normals=True)
    mesh = read_mesh(file)
    low, high = mesh.bounds()
    np.testing.assert_allclose([low[0], high[0]], [-0.5, 6.0], atol=1e-5)
    assert sorted(part.material for part in mesh.parts) == ["paint", "rubber"]
    (right,) = (part for part in mesh.parts if part.material == "paint")
    local = right.positions - [5.0, 0.0, 0.0]
    gradient = local / [4.0, 1.0, 1.0]
    gradient /= np.linalg.norm(gradient, axis=1, keepdims=True)
    assert np.einsum("ij,ij->i", gradient, right.normals).min() > 0.98
    a, b, c = (right.positions[right.triangles[:, k]] for k in range(3))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), right.normals[right.triangles[:, 0]]) > 0).all()


@pytest.mark.parametrize(
    ("size", "expected", "said"),
    [
        (4000.0, 4.0, "millimetres"),
        (60.0, 0.06, "millimetres"),
        (2e7, 2.0, "scaled"),
        (1e-5, 1.0, "scaled"),
        (3.0, 3.0, ""),
    ],
)
def test_a_size_that_no_object_has_is_scaled_and_said(
    tmp_path: Path, size: float, expected: float, said: str
) -> None:
    file = tmp_path / "ball.stl"
    trimesh.creation.icosphere(subdivisions=2, radius=size / 2).export(file)
    mesh = read_mesh(file)
    low, high = mesh.bounds()
    assert np.max(high - low) == pytest.approx(expected, rel=0.01)
    assert any("as written" in note and said in note for note in mesh.notes) == bool(said)


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("a.glb", b"", "empty"),
        ("a.glb", b"this is a text file and no mesh", "does not begin with"),
        ("a.gltf", b"{ not json", "JSON is damaged"),
        ("a.gltf", b"[]", "not an object"),
        ("a.gltf", b'{"nodes":[{"children":[1]},{"children":[0]}]}', "circle"),
        ("a.gltf", b'{"nodes":[{"children":[7]}]}', "not there"),
        ("a.obj", b"just some words\n", "triangles"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "triangles"),
        ("a.stl", b"solid nothing\nendsolid\n", "no triangles|damaged"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 9\n", "damaged"),
        ("a.txt", b"x", "of no kind of mesh that can be read; export it as glTF"),
        ("a.jt", b"Version 9.5 JT  DM 6.4.0.0", "a JT file, which cannot be read; export it as glTF"),
    ],
)
def test_what_is_no_mesh_is_refused_in_one_line(
    tmp_path: Path, name: str, content: bytes, reason: str
) -> None:
    file = tmp_path / name
    file.write_bytes(content)
    with pytest.raises(FileError, match=reason) as error:
        read_mesh(file)
    assert str(file) in one_line(error)


def test_missing_files_and_folders_are_refused(tmp_path: Path) -> None:
    (tmp_path / "folder.glb").mkdir()
    for name in ("nothing.glb", "folder.glb"):
        with pytest.raises(FileError):
            read_mesh(tmp_path / name)


def test_a_point_cloud_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "points.ply"
    trimesh.PointCloud(np.random.default_rng(1).random((10, 3))).export(file)
    with pytest.raises(FileError, match="holds no triangles"):
        read_mesh(file)


def test_corners_that_are_not_finite_are_left_out_and_said(tmp_path: Path) -> None:
    ball = ball_of_triangles()
    triangles = ball.triangles.astype("<f4").copy()
    triangles[0, 0, 0] = np.nan
    triangles[5] = triangles[5, 0]
    record = np.zeros(len(triangles), dtype=[("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
    record["v"] = triangles
    file = tmp_path / "ball.stl"
    file.write_bytes(b"\0" * 80 + struct.pack("<I", len(triangles)) + record.tobytes())
    mesh = read_mesh(file)
    assert mesh.triangle_count == 318
    text = " ".join(mesh.notes)
    assert "not finite" in text
    assert "without area" in text
    record["v"] = np.nan
    file.write_bytes(b"\0" * 80 + struct.pack("<I", len(triangles)) + record.tobytes())
    with pytest.raises(FileError, match="no triangle that can be drawn"):
        read_mesh(file)


@pytest.mark.parametrize(
    ("material", "part", "word"),
    [
        ("", "", None),
        ("Glass_Windscreen", "", "glass"),
        ("CarPaintMetallic", "", "paint"),
        ("metallic paint", "", "paint"),
        ("Metal", "", "chrome"),
        ("material_0", "FrontTyre", "rubber"),
        ("metallic_red", "body", "paint"),
        ("window_trim", "", "trim"),
        ("HeadLight", "", None),
        ("Headlight", "", "lamp"),
        ("taillight", "", "tail_lamp"),
        ("primer", "antibody", None),
    ],
)
def test_names_that_give_the_material(material: str, part: str, word: str | None) -> None:
    assert named_material(material, part) == word


@pytest.mark.parametrize("ending", ["glb", "obj", "stl", "ply"])
def test_damaged_bytes_give_a_mesh_or_one_line(tmp_path: Path, ending: str) -> None:
    """Whatever is changed in a file, the answer is a mesh that can be drawn or a named error."""
    file = tmp_path / f"ball.{ending}"
    ball_of_triangles().export(file)
    sound = np.frombuffer(file.read_bytes(), np.uint8)
    rng = np.random.default_rng(11)
    outcomes = set()
    for _ in range(40):
        data = sound.copy()
        places = rng.integers(0, len(data), rng.integers(1, 12))
        data[places] = (
            rng.integers(32, 127, len(places)) if ending == "obj" else rng.integers(0, 256, len(places))
        )
        file.write_bytes(data[: len(data) - int(rng.integers(0, 2) * rng.integers(0, len(data)))].tobytes())
        try:
            drawn = read_mesh(file).triangle_count
            outcomes.add("mesh" if drawn > 0 else "nothing")
        except FileError as error:
            outcomes.add("lines" if "\n" in str(error) else "line")
    assert "line" in outcomes
    assert outcomes <= {"mesh", "line"}


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("strasse.obj", "# Größe: Straße 1\no Tür\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        (
            "strasse.stl",
            "solid Straße\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
            "endloop\nendfacet\nendsolid\n",
        ),
    ],
)
def test_text_in_another_encoding_than_utf_8_is_read(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_bytes(text.encode("latin-1"))
    assert read_mesh(tmp_path / name).triangle_count == 1


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda data: data[:-77], "is cut off: its header promises 320 triangles, which take 16,084 bytes"),
        (lambda data: data + bytes(50), "holds more than its triangles: .* it has 16,134"),
        (lambda data: data[:80] + struct.pack("<I", 7) + data[84:], "promises 7 triangles"),
        (lambda data: data[:50], "cut off within its header"),
    ],
)
def test_a_binary_stl_whose_count_is_not_its_size_is_refused(tmp_path: Path, change, reason: str) -> None:
    file = tmp_path / "ball.stl"
    ball_of_triangles().export(file)
    file.write_bytes(change(file.read_bytes()))
    with pytest.raises(FileError, match=reason) as error:
        read_mesh(file)
    one_line(error)


def test_a_point_at_infinity_is_left_out_and_said(tmp_path: Path) -> None:
    file = tmp_path / "far.obj"
    points = "v 0 0 0\nv inf 0 0\nv 0 1 0\nv 1 1 0\n"
    file.write_text(points + "f 1 2 3\nf 1 3 4\n")
    mesh = read_mesh(file)
    assert mesh.triangle_count == 1
    assert "left out 1 triangle with corners that are not finite" in " ".join(mesh.notes)
    file.write_text(points + "f 1 2 3\n")
    with pytest.raises(FileError, match=r"no triangle that can be drawn .*not finite"):
        read_mesh(file)


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("a.obj", b"f 1 ", b"f 999 "),
        ("a.glb", b'"POSITION":1', b'"POSITION":8'),
        ("a.glb", b'"indices":0', b'"indices":7'),
        ("a.glb", b'"bufferView":1', b'"bufferView":9'),
    ],
)
def test_what_a_file_refers_to_and_lacks_is_said_in_words(
    tmp_path: Path, name: str, old: bytes, new: bytes
) -> None:
    file = tmp_path / name
    if name.endswith("obj"):
        file.write_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    else:
        ball_of_triangles().export(file)
    data = file.read_bytes()
    assert old in data
    file.write_bytes(data.replace(old, new))
    with pytest.raises(FileError) as error:
        read_mesh(file)
    assert str(error.value) == f"{file}: damaged: it refers to data that it does not hold."


def test_points_in_a_plane_are_no_mesh(tmp_path: Path) -> None:
    file = tmp_path / "flat.obj"
    file.write_text("v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n")
    with pytest.raises(FileError, match="three coordinates"):
        read_mesh(file)
