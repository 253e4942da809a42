"""Meshes as other programs write them: every variant is read, and its materials and axes are understood."""

from __future__ import annotations

import os
import shutil
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import trimesh
from PIL import Image

from brdf_suite import variables
from brdf_suite.cli.main import main
from brdf_suite.errors import FileError
from brdf_suite.files.meshes.outside import child
from brdf_suite.files.meshes.outside.child import read_outside
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.resources import resource
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.standing import find_standing

FORMATS = ("quantized", "draco", "meshopt", "usd", "fbx", "collada", "3mf", "step")
OLD_FORMATS = ("x3d", "ac3d", "3ds")
SMALLEST_SHARE = 0.97


@pytest.fixture(scope="session")
def writers(load_helper: Callable[[str], ModuleType]) -> ModuleType:
    return load_helper("mesh_writers.py")


def faults(mesh: Mesh, written) -> list[str]:
    """What is other than it was written."""
    points = np.concatenate([solid.points for solid in written.solids])
    found = []
    for bound, wanted in zip(mesh.bounds(), (points.min(axis=0), points.max(axis=0)), strict=True):
        if np.abs(bound - wanted).max() > written.error:
            found.append(f"reaches to {bound}, not {wanted}")
    if mesh.triangle_count != sum(len(solid.triangles) for solid in written.solids):
        found.append(f"{mesh.triangle_count} triangles")
    if len(mesh.parts) != len(written.solids):
        found.append(f"{len(mesh.parts)} parts")
    for part in mesh.parts:
        corners = part.positions.astype(np.float64)[part.triangles]
        faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        out = corners.mean(axis=1) - np.mean(part.bounds(), axis=0)
        if (np.einsum("kd,kd->k", faces, out) < 0.0).mean() > 0.05:
            found.append(f"{part.name} is wound inwards")
        if (np.einsum("kd,kd->k", faces, part.normals[part.triangles].sum(axis=1)) < 0.0).mean() > 0.05:
            found.append(f"{part.name} has normals inwards")
    return found


@pytest.mark.parametrize("name", [*FORMATS, *OLD_FORMATS])
def test_every_variant_is_read(writers: ModuleType, tmp_path: Path, name: str) -> None:
    good, said = 0, []
    for number in range(writers.COUNT):
        folder = tmp_path / str(number)
        folder.mkdir()
        written = writers.VARIANTS[name](number, folder)
        found = faults(read_mesh(written.path), written)
        good += not found
        said += [(number, found)] if found else []
    assert good >= SMALLEST_SHARE * writers.COUNT, said


@pytest.mark.parametrize("name", FORMATS)
def test_parts_get_their_materials_by_name_look_and_area(
    writers: ModuleType, tmp_path: Path, name: str
) -> None:
    materials = {
        part.name: part.material for part in read_mesh(writers.VARIANTS[name](14, tmp_path).path).parts
    }
    assert materials["Karosserie"] == "paint"  # the largest; no word of its names is known
    if name != "step":  # which has no clear materials and no balls
        assert materials["Scheibe"] == "glass"
        assert materials["Reifen_0"] in ("rubber", "trim")


def car(writers: ModuleType) -> list:
    """The shipped car as solids to write, in the order that they come in."""
    looks = {
        "glass": {"colour": (0.02, 0.025, 0.03), "opacity": 0.4},
        "lens": {"colour": (0.9, 0.9, 0.9), "opacity": 0.08},
    }
    return [
        writers.Solid(
            part.name,
            part.material,
            part.positions.astype(np.float64),
            [tuple(face) for face in part.triangles.tolist()],
            given_normals=part.normals.astype(np.float64),
            given_uvs=part.uvs.astype(np.float64),
            **looks.get(part.material, {}),
        )
        for part in read_mesh(resource("meshes", "car.glb")).parts
    ]


def picture(mesh: Path | str, folder: Path, *more: str) -> np.ndarray:
    out = folder / f"{Path(mesh).stem}.png"
    words = ["render", "solid_red", "-o", str(out), "--mesh", str(mesh), "--size", "480x270"]
    assert main([*words, "--no-occlusion", "--no-ground", "--environment", "overcast", *more]) == 0
    return np.asarray(Image.open(out).convert("RGB"), np.float64) / 255.0


# Of 16 bits, of 14 bits within Draco's own quantization, of 14 bits with normals of 12, and as text.
@pytest.mark.parametrize(("name", "number"), [("quantized", 21), ("draco", 15), ("meshopt", 2), ("usd", 5)])
def test_the_car_looks_the_same_from_every_format(
    writers: ModuleType, tmp_path: Path, name: str, number: int
) -> None:
    flip = pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    written = writers.VARIANTS[name](number, tmp_path, car(writers))
    mesh = read_mesh(written.path)
    own = {part.name: part.material for part in read_mesh(resource("meshes", "car.glb")).parts}
    assert {part.name: part.material for part in mesh.parts} == own
    one, other = picture("car", tmp_path), picture(written.path, tmp_path)
    assert one.std() > 0.1
    _, mean, _ = flip.evaluate(one.astype(np.float32), other.astype(np.float32), "LDR")
    print(f"FLIP {mean:.4f}")
    assert mean <= 0.02


def test_the_content_counts_and_not_the_ending(writers: ModuleType, tmp_path: Path) -> None:
    for name, ending in (("quantized", ".obj"), ("fbx", ".glb"), ("collada", ".fbx"), ("usd", ".stl")):
        folder = tmp_path / name
        folder.mkdir()
        written = writers.VARIANTS[name](4, folder)
        misnamed = folder / f"wrong{ending}"
        shutil.copy(written.path, misnamed)
        assert not faults(read_mesh(misnamed), written), name


def test_a_cad_surface_is_cut_as_finely_as_asked(writers: ModuleType, tmp_path: Path) -> None:
    file = writers.Step()
    body = file.ball(np.array([0.0, 0.0, 300.0]), 300.0)
    path = file.write(tmp_path / "ball.step", [(body, "Kugel", (0.7, 0.1, 0.1))], "millimetre")
    coarse, fine = (read_mesh(path, tessellation_mm=mm) for mm in (20.0, 0.5))
    assert fine.triangle_count > 2 * coarse.triangle_count
    low, high = fine.bounds()
    np.testing.assert_allclose([low[1], high[1]], [0.0, 0.6], atol=0.002)  # upright, and in metres
    (part,) = fine.parts
    away = np.linalg.norm(part.positions - [0.0, 0.3, 0.0], axis=1)
    np.testing.assert_allclose(away, 0.3, atol=0.001)


@pytest.mark.parametrize(
    ("name", "library"), [("draco", "DracoPy"), ("fbx", "assimp_py"), ("usd", "pxr"), ("step", "cascadio")]
)
def test_a_library_that_is_missing_is_named_with_what_to_do(
    writers: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, library: str
) -> None:
    written = writers.VARIANTS[name](1, tmp_path)
    monkeypatch.setattr("brdf_suite.extras.find_spec", lambda module: None if module == library else object())
    with pytest.raises(FileError, match=r"which is not installed; .*installs it, and glTF, OBJ, STL and PLY"):
        read_mesh(written.path)


def test_a_library_that_breaks_down_or_hangs_costs_the_file_alone(
    writers: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written = writers.VARIANTS["fbx"](1, tmp_path)
    for code, reason in (
        ("import os; os.abort()", "the library that reads it broke down"),
        ("raise SystemExit(0)", "the library that reads it broke down"),
        ("import time; time.sleep(600)", "takes more than 1 s"),
        ("import sys; open(sys.argv[3], 'wb').write(b'not an answer')", "its answer is damaged"),
        (
            'import sys; h = b\'{"parts": [{"arrays": {"positions": ["<f4", [999999999, 3]]}}]}\';'
            "open(sys.argv[3], 'wb').write(len(h).to_bytes(8, 'little') + h)",
            "its answer is damaged",
        ),
        (
            'import sys; h = b\'{"parts": [{"arrays": {"positions": ["O", [1, 3]]}}]}\';'
            "open(sys.argv[3], 'wb').write(len(h).to_bytes(8, 'little') + h + bytes(24))",
            "its answer is damaged",
        ),
    ):
        monkeypatch.setattr(child, "SECONDS", 1.0 if "sleep" in code else 120.0)
        monkeypatch.setattr(
            child, "child_command", lambda _, *words, code=code: [sys.executable, "-c", code, *words]
        )
        with pytest.raises(FileError, match=reason):
            read_mesh(written.path)


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("share", [0.02, 0.5, 0.98])
def test_files_that_are_cut_off_give_a_mesh_or_one_line(
    writers: ModuleType, tmp_path: Path, name: str, share: float
) -> None:
    written = writers.VARIANTS[name](1, tmp_path)
    data = written.path.read_bytes()
    written.path.write_bytes(data[: int(len(data) * share)])
    try:
        said = str(read_mesh(written.path).triangle_count)
    except FileError as error:
        said = str(error)
    assert said != "0"
    assert "\n" not in said


def sheet(z: float, size: float = 1.0) -> trimesh.Trimesh:
    """A box with its foot on z and its middle over the origin."""
    made = trimesh.creation.box((2.0 * size, size, 0.8 * size))
    made.apply_translation([0.0, 0.0, z + 0.4 * size])
    return made


@pytest.mark.parametrize("ending", ["stl", "ply"])
def test_cad_formats_that_say_nothing_are_taken_as_z_up_unless_they_stand(
    tmp_path: Path, ending: str
) -> None:
    lying, standing = tmp_path / f"lying.{ending}", tmp_path / f"standing.{ending}"
    sheet(1.5).export(lying)  # nothing speaks for either axis
    mesh = read_mesh(lying)
    low, high = mesh.bounds()
    np.testing.assert_allclose(high - low, [2.0, 0.8, 1.0], atol=1e-6)
    assert "taken as z up, which the file does not say" in mesh.notes
    found = find_standing(mesh)
    assert found is not None
    assert (found.up, found.is_doubtful) == ("z", True)
    np.testing.assert_allclose(np.ptp(read_mesh(lying, up="y").bounds(), axis=0), [2.0, 1.0, 0.8], atol=1e-6)

    upright = sheet(0.0)
    upright.vertices = upright.vertices[:, [0, 2, 1]]  # stands on y = 0
    upright.invert()
    upright.export(standing)
    assert not read_mesh(standing).was_turned


def test_a_foreign_obj_takes_colours_of_its_material_file(tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text(
        "newmtl a\nKd 0.5 0.02 0.02\nnewmtl b\nKd 0.01 0.01 0.01\nPr 0.9\nnewmtl c\nKd 0.7 0.7 0.7\nPm 1\nPr 0.1\n"
        "newmtl d\nKd 0.5 0.3 0.2\nPr 0.8\nnewmtl e\nKd 1 1 1\nd 0.3\n"
    )
    text = ["mtllib a.mtl"]
    for place, name in enumerate("abcde"):
        size = 4.0 if name == "a" else 1.0
        text += [f"v {9 * place + x * size} {y * size} 0" for x, y in ((0, 0), (1, 0), (1, 1))]
        text += [f"o part_{name}", f"usemtl {name}", "f " + " ".join(str(3 * place + k) for k in (1, 2, 3))]
    (tmp_path / "a.obj").write_text("\n".join(text) + "\n")
    mesh = read_mesh(tmp_path / "a.obj", unit="m")
    materials = [part.material for part in sorted(mesh.parts, key=lambda part: part.bounds()[0][0])]
    assert materials == ["paint", "rubber", "chrome", "neutral", "glass"]


def test_seats_and_trim_of_a_gltf_stay_what_they_are(writers: ModuleType, tmp_path: Path) -> None:
    box = writers.box
    wide, small = box(np.zeros(3), np.array([2.0, 1.0, 4.0])), box(np.zeros(3), np.full(3, 0.5))
    high = box(np.zeros(3), np.ones(3))
    parts = [
        writers.Solid("Mesh_0", "Material.000", *wide),
        writers.Solid("Mesh_1", "Material.001", *small, colour=(0.5, 0.35, 0.2), roughness=0.8),
        writers.Solid("Mesh_2", "Material.002", *small, colour=(0.02,) * 3, roughness=0.6),
        writers.Solid("Mesh_3", "Material.003", *small, colour=(0.8,) * 3, metallic=1.0, roughness=0.1),
        writers.Solid("Mesh_4", "Material.004", *high, colour=(0.02, 0.02, 0.4), roughness=0.2),
        writers.Solid("Mesh_5", "Material.005", *small),
    ]
    mesh = read_mesh(writers.quantized_glb(0, tmp_path, parts).path)
    words = {part.name: part.material for part in mesh.parts}
    assert [words[f"Mesh_{k}"] for k in range(6)] == [
        "paint",
        "neutral",
        "trim",
        "chrome",
        "second_paint",
        "paint",
    ]


@pytest.mark.parametrize("word", ["x", "1.5", "\x88", "\f", "0\v", "&#49;", "<![CDATA[x]]>"])
def test_indices_of_collada_that_are_no_integers_are_refused_with_their_line(
    writers: ModuleType, tmp_path: Path, word: str
) -> None:
    path = writers.VARIANTS["collada"](1, tmp_path).path
    head, found, rest = path.read_bytes().partition(b"<p>")
    assert found
    line = head.count(b"\n") + 1
    path.write_bytes(head + found + word.encode("latin-1") + b" " + rest)
    with pytest.raises(FileError, match=f"the indices <p> in line {line} are no integers"):
        read_mesh(path)


def test_texts_in_comments_and_extras_of_collada_are_no_indices(writers: ModuleType, tmp_path: Path) -> None:
    path = writers.VARIANTS["collada"](1, tmp_path).path
    before = read_mesh(path)
    head, found, rest = path.read_bytes().partition(b"<library_geometries>")
    assert found
    more = b"<!-- <p>none</p> --><extra type='a'><technique profile='b'><p>text</p></technique></extra>"
    path.write_bytes(
        head + b"<!-- <p>none</p> -->" + found + rest.replace(b"</COLLADA>", more + b"</COLLADA>")
    )
    after = read_mesh(path)
    assert [part.name for part in after.parts] == [part.name for part in before.parts]
    assert after.triangle_count == before.triangle_count


def test_compressed_data_that_announce_too_much_are_refused(writers: ModuleType, tmp_path: Path) -> None:
    path = writers.meshopt_glb(1, tmp_path).path
    data = path.read_bytes()
    (length,) = struct.unpack("<I", data[12:16])
    text = data[20 : 20 + length].replace(b'"count": 8,', b'"count": 987654321,')
    assert text != data[20 : 20 + length]
    chunk = struct.pack("<I4s", len(text), b"JSON") + text
    path.write_bytes(
        struct.pack("<4sII", b"glTF", 2, len(data) - length + len(text)) + chunk + data[20 + length :]
    )
    with pytest.raises(FileError, match="GiB is allowed"):
        read_mesh(path)


def _refers(composed: str) -> str:
    """The text of a stage with one prim that is composed so."""
    head = '#usda 1.0\n(\n    defaultPrim = "Car"\n    metersPerUnit = 1\n    upAxis = "Y"\n'
    if composed.startswith("subLayers"):
        return f"{head}    {composed}\n)\n"
    return f'{head})\ndef Xform "Car" (\n    {composed}\n)\n{{\n}}\n'


_VARIANT = """variants = {{ string v = "one" }}
    prepend variantSets = "v"
)
{{
    variantSet "v" = {{ "one" ( references = @{0}@ ) {{ }} "two" {{ }} }}
}}
def Xform "More" ("""
_CLIPS = """clips = {{ dictionary default = {{
        asset[] assetPaths = [@{0}@]
        asset manifestAssetPath = @{0}@
        string primPath = "/Car"
        double2[] active = [(0, 0)]
        double2[] times = [(0, 0)]
    }} }}
    references = @./part.usda@"""
_COMPOSED = ("references = @{0}@", "payload = @{0}@", "subLayers = [@{0}@]", _VARIANT)


@pytest.fixture
def usd_folder(writers: ModuleType, tmp_path: Path) -> Path:
    """A folder of a mesh with parts/part.usda, which two further layers lead to, and another one beside it."""
    pytest.importorskip("pxr")
    text, _ = writers.usda_text(6)
    for name in ("mesh/part.usda", "mesh/parts/part.usda", "elsewhere/part.usda"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "mesh/parts/second.usda").write_text(_refers("references = @../part.usda@"))
    return tmp_path / "mesh"


@pytest.mark.parametrize("composed", _COMPOSED)
@pytest.mark.parametrize("name", ["./parts/part.usda", "part.usda", "parts/second.usda"])
def test_layers_of_usd_in_the_folder_of_the_mesh_are_read(usd_folder: Path, composed: str, name: str) -> None:
    path = usd_folder / "a.usda"
    path.write_text(_refers(composed.format(name)))
    assert read_mesh(path).triangle_count == read_mesh(usd_folder / "part.usda").triangle_count


@pytest.mark.parametrize("composed", _COMPOSED)
def test_layers_of_usd_outside_the_folder_of_the_mesh_are_refused(usd_folder: Path, composed: str) -> None:
    path, elsewhere = usd_folder / "a.usda", usd_folder.parent / "elsewhere"
    (usd_folder / "link.usda").symlink_to(elsewhere / "part.usda")
    (usd_folder / "parts/third.usda").write_text(_refers("references = @../../elsewhere/part.usda@"))
    names = ("../elsewhere/part.usda", f"{elsewhere}/part.usda", "link.usda", "./parts/third.usda")
    expression = '`"../elsewhere/part.usda"`'
    for name in (*names, "//server/share/part.usda", "C:/part.usda", "../elsewhere/none.usda", expression):
        path.write_text(_refers(composed.format(name)))
        with pytest.raises(FileError, match=r"refers to .*, which is not in its folder"):
            read_mesh(path)


def test_layers_in_a_package_of_usd_are_read_and_lead_nowhere_else(usd_folder: Path) -> None:
    from pxr import Sdf

    (usd_folder.parent / "out.usda").write_text(_refers("references = @../elsewhere/part.usda@"))
    (usd_folder.parent / "in.usda").write_text(_refers("references = @./parts/part.usda@"))
    for name, is_read in (("in", True), ("out", False)):
        with Sdf.ZipFileWriter.CreateNew(str(usd_folder / f"{name}.usdz")) as package:
            package.AddFile(str(usd_folder.parent / f"{name}.usda"), "a.usda")
            package.AddFile(str(usd_folder / "part.usda"), "parts/part.usda")
        for path in (usd_folder / f"{name}.usdz", usd_folder / "a.usda"):
            if path.suffix == ".usda":
                path.write_text(_refers(f"references = @./{name}.usdz@"))
            if is_read:
                assert read_mesh(path).triangle_count
            else:
                with pytest.raises(
                    FileError, match=r"refers to \.\./elsewhere/part\.usda, which is not in its"
                ):
                    read_mesh(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
@pytest.mark.parametrize("composed", _COMPOSED)
def test_a_pipe_in_the_place_of_a_layer_of_usd_is_refused_at_once(
    usd_folder: Path, monkeypatch: pytest.MonkeyPatch, composed: str
) -> None:
    monkeypatch.setattr(child, "SECONDS", 20.0)
    os.mkfifo(usd_folder / "parts/pipe.usda")
    (usd_folder / "a.usda").write_text(_refers(composed.format("./parts/pipe.usda")))
    with pytest.raises(FileError, match=r"needs pipe\.usda beside it, which is not a plain file"):
        read_mesh(usd_folder / "a.usda")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_value_clips_of_usd_are_not_opened(usd_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(child, "SECONDS", 20.0)
    os.mkfifo(usd_folder / "pipe.usda")
    (usd_folder / "a.usda").write_text(_refers(_CLIPS.format("./pipe.usda")))
    assert read_mesh(usd_folder / "a.usda").triangle_count


def test_a_file_that_is_no_layer_of_usd_is_refused(tmp_path: Path) -> None:
    pytest.importorskip("pxr")
    (tmp_path / "a.usd").write_text("#not usda")
    with pytest.raises(FileError, match="damaged, or refers to files that are not there"):
        read_mesh(tmp_path / "a.usd")


_DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><library_geometries>
<geometry id="g"><mesh><source id="p"><float_array id="a" count="{count}">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


@pytest.mark.skipif(sys.platform != "linux", reason="limits of memory are of Linux")
def test_a_library_that_asks_for_more_than_is_allowed_is_refused_unless_more_is_set(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("assimp_py")
    path = tmp_path / "small.dae"
    path.write_text(_DAE.format(count=9))
    assert [len(part.triangles) for part in read_outside(path, "assimp", "dae").parts] == [1]
    path.write_text(_DAE.format(count=400_000_000))  # 1.6 GB, which nothing in the file fills
    with pytest.raises(FileError, match=r"more than 1 GiB of memory \(BRDF_SUITE_READ_MB can allow more\)"):
        read_outside(path, "assimp", "dae")
    monkeypatch.setenv(variables.READ_MB, "4000")
    with pytest.raises(FileError, match="Expected more values"):
        read_outside(path, "assimp", "dae")
