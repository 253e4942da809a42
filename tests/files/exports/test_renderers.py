"""Paints as renderers' materials: what those renderers read, and how their own shaders reflect."""

from __future__ import annotations

import importlib.util
import math
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.files.exports import FORMATS
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.luxcore import fit_carpaint
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.instruments.rendered_sphere import sphere_difference
from brdf_suite.reflectance.renderers.facet_lobe import normal_reflectance
from brdf_suite.reports.handover import item_of

_shader = load_module(Path(__file__).parent / "materialx_shader.py")

LABS = {15.0: (86.1, 4.1, 44.0), 45.0: (37.8, 2.1, 23.5), 110.0: (13.6, 1.2, 14.5)}
PAINT = Paint(
    name="gold fine",
    measurements=tuple(Measurement(45.0, angle, lab) for angle, lab in LABS.items()),
    gloss=Gloss(89.5, 97.25),
)
BY_NAME = {known.name: known for known in FORMATS}
TO_709 = WORKING_TO_SRGB.T


@pytest.mark.parametrize(
    ("name", "most"), [("solid_red", 1.5), ("silver_metallic", 3.5), ("emerald_pearl", 3.5)]
)
def test_models_of_renderers_come_near_on_a_sphere(name: str, most: float) -> None:
    """The limits are those of what the formats can hold, with some room; the losses report each paint's own."""
    item = ExportItem(load_shipped_paint(name))
    found = {
        "carpaint": fit_carpaint(item),
        "gltf": fit_coated_facets(item, "gltf"),
        "openpbr": fit_coated_facets(item, "openpbr"),
        "usd": fit_coated_facets(item, "usd"),
    }
    assert {kind: one.on_sphere for kind, one in found.items() if one.on_sphere > most} == {}
    for one in found.values():
        assert one.on_sphere == sphere_difference(item.reflectance, one.model)


def test_what_the_losses_report_is_the_difference_on_the_sphere() -> None:
    found = fit_coated_facets(ExportItem(PAINT), "gltf")
    (reported,) = (loss for loss in BY_NAME["gltf"].losses(ExportItem(PAINT)) if "on a sphere" in loss)
    assert f"mean ΔE00 {found.on_sphere:.1f} on a sphere" in reported
    assert f"{found.differences[0]:.1f} at 15°" in reported


@pytest.mark.parametrize("name", ["table1_polaris_silver", "table1_blue"])
def test_a_paint_that_is_no_design_is_fitted_itself(name: str) -> None:
    """Not the design of the same five readings, which differs from it by more than the fit does."""
    item = item_of(name)
    found = fit_coated_facets(item, "gltf")
    assert found.on_sphere == sphere_difference(item.reflectance, found.model)
    design = fit_coated_facets(ExportItem(item.modelled), "gltf")
    assert found.on_sphere < 0.7 * sphere_difference(item.reflectance, design.model)
    reported = next(loss for loss in BY_NAME["gltf"].losses(item) if "on a sphere" in loss)
    assert f"mean ΔE00 {found.on_sphere:.1f} on a sphere" in reported


def test_a_solid_paint_has_no_lobe_and_a_metallic_one_has() -> None:
    solid, metallic = (ExportItem(load_shipped_paint(name)) for name in ("solid_red", "silver_metallic"))
    for kind in ("gltf", "openpbr"):
        assert not fit_coated_facets(solid, kind).model.has_lobe
        assert fit_coated_facets(metallic, kind).model.has_lobe
    assert not fit_coated_facets(solid, "usd").model.metal
    assert fit_coated_facets(metallic, "usd").model.metal


def test_materialx_takes_the_openpbr_surface(tmp_path: Path) -> None:
    mx = pytest.importorskip("MaterialX")
    path = tmp_path / "a.mtlx"
    BY_NAME["openpbr"].write([ExportItem(PAINT)] * 2, path, None)
    library, document = mx.createDocument(), mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    mx.readFromXmlFile(document, str(path))
    document.setDataLibrary(library)
    valid, why = document.validate()
    assert valid, why
    surfaces = document.getNodes("open_pbr_surface")
    assert len(surfaces) == len(document.getMaterialNodes()) == 2
    definition = library.getNodeDef("ND_open_pbr_surface_surfaceshader")
    assert {item.getName() for item in surfaces[0].getInputs()} <= {
        item.getName() for item in definition.getInputs()
    }
    found = fit_coated_facets(ExportItem(PAINT), "openpbr").model
    assert surfaces[0].getInputValue("specular_roughness") == pytest.approx(math.sqrt(found.alpha))
    assert surfaces[0].getInputValue("coat_ior") == pytest.approx(found.coat_ior)


_USD_PREVIEW = """<?xml version="1.0"?>
<materialx version="1.39" colorspace="lin_rec709">
  <UsdPreviewSurface name="surface" type="surfaceshader">{inputs}</UsdPreviewSurface>
  <surfacematerial name="paint" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="surface"/>
  </surfacematerial>
</materialx>
"""


def test_the_shader_of_materialx_reflects_as_the_fitted_openpbr(tmp_path: Path) -> None:
    path = tmp_path / "a.mtlx"
    BY_NAME["openpbr"].write([ExportItem(PAINT)], path, None)
    wi, wo, found = _shader.shade(path)
    ratio = found / (fit_coated_facets(ExportItem(PAINT), "openpbr").model.eval(wi, wo) @ TO_709 * wi[:, 2:])
    assert np.abs(ratio - 1.0).max() < 0.03
    # Only towards grazing are its formulas for albedos, which are approximations, off by more than a percent.
    assert np.abs(ratio[wo[:, 2] > 0.5] - 1.0).max() < 0.01


def test_the_shader_of_materialx_reflects_as_the_fitted_usd_preview(tmp_path: Path) -> None:
    BY_NAME["usd"].write([ExportItem(PAINT)], tmp_path / "a.usda", None)
    inputs = re.findall(r"(color3f|float) inputs:(\w+) = (\S.*)", (tmp_path / "a.usda").read_text())
    assert len(inputs) == 6
    lines = [
        f'<input name="{name}" type="{"color3" if kind == "color3f" else kind}" value="{value.strip("()")}"/>'
        for kind, name, value in inputs
    ]
    path = tmp_path / "a.mtlx"
    path.write_text(_USD_PREVIEW.format(inputs="".join(lines)))
    wi, wo, found = _shader.shade(path)
    ratio = found / (fit_coated_facets(ExportItem(PAINT), "usd").model.eval(wi, wo) @ TO_709 * wi[:, 2:])
    # Its metal is a conductor, ours rises after Schlick; the two differ most in dark channels.
    assert np.abs(ratio - 1.0).max() < 0.08
    assert np.abs(ratio - 1.0).mean() < 0.02


def test_usd_is_valid_to_its_own_checks(tmp_path: Path) -> None:
    pytest.importorskip("pxr")
    from pxr import Usd, UsdShade, UsdValidation

    def faults(path: Path) -> list[str]:
        found = UsdValidation.ValidationContext(
            UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
        ).Validate(Usd.Stage.Open(str(path)))
        return [error.GetName() for error in found]

    path = tmp_path / "a.usda"
    items = [ExportItem(PAINT), ExportItem(load_shipped_paint("solid_red"))]
    BY_NAME["usd"].write(items, path, None)
    assert faults(path) == []
    stage = Usd.Stage.Open(str(path))
    spheres = [prim for prim in stage.Traverse() if prim.GetTypeName() == "Mesh"]
    assert [prim.GetName() for prim in spheres] == ["gold_fine", "Solid_red"]
    for prim, kind in zip(spheres, ("gold fine", "Solid red"), strict=True):
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        assert material.GetPrim().GetDocumentation().startswith(kind)
    # The checks are not blind to what could be wrong.
    text = path.read_text()
    for kept, broken in (
        ('prepend apiSchemas = ["MaterialBindingAPI"]', ""),
        ("float inputs:ior", "double inputs:ior"),
    ):
        assert kept in text
        path.with_name("broken.usda").write_text(text.replace(kept, broken))
        assert faults(path.with_name("broken.usda")) != []


def test_the_mesh_of_a_usd_faces_outwards(tmp_path: Path) -> None:
    pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom

    BY_NAME["usd"].write([ExportItem(PAINT)], tmp_path / "a.usda", None)
    stage = Usd.Stage.Open(str(tmp_path / "a.usda"))
    mesh = UsdGeom.Mesh(next(prim for prim in stage.Traverse() if prim.GetTypeName() == "Mesh"))
    points = np.array(mesh.GetPointsAttr().Get())
    corners = points[np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)]
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6.0
    assert volume == pytest.approx(4.0 / 3.0 * math.pi * 0.1**3, rel=0.02)
    assert np.array(mesh.GetNormalsAttr().Get()) == pytest.approx(points / 0.1, abs=1e-5)


def test_gltf_is_read_by_another_library(tmp_path: Path) -> None:
    pygltflib = pytest.importorskip("pygltflib")
    import trimesh

    path = tmp_path / "a.gltf"
    BY_NAME["gltf"].write([ExportItem(PAINT)], path, None)
    material = pygltflib.GLTF2().load(str(path)).materials[0]
    found = fit_coated_facets(ExportItem(PAINT), "gltf").model
    assert material.extensions["KHR_materials_clearcoat"]["clearcoatFactor"] == 1.0
    assert material.pbrMetallicRoughness.baseColorFactor == [*found.diffuse, 1.0]
    assert material.pbrMetallicRoughness.metallicFactor == 0.0
    specular = material.extensions["KHR_materials_specular"]
    plain = normal_reflectance(material.extensions["KHR_materials_ior"]["ior"])
    assert specular["specularFactor"] == 1.0
    assert [plain * factor for factor in specular["specularColorFactor"]] == pytest.approx(found.specular)
    assert material.extras["brdf_suite"]["paints"][0]["paint"]["name"] == PAINT.name
    (sphere,) = trimesh.load(path).geometry.values()
    assert sphere.volume == pytest.approx(4.0 / 3.0 * math.pi, rel=0.01)


# LuxCore ends in its own way, so it has a process of its own.
_LUX = """
import math, os, sys, time
import numpy as np
import pyluxcore
pyluxcore.Init(lambda message: None)
scene_file, name = sys.argv[1:3]
for view in map(float, sys.argv[3:]):
    scene, lines = pyluxcore.Scene(), pyluxcore.Properties()
    eye = (5.0 * math.sin(view), 0.0, 5.0 * math.cos(view))
    lines.SetFromString(open(scene_file).read() + f'''
scene.camera.type = "orthographic"
scene.camera.lookat.orig = {eye[0]} {eye[1]} {eye[2]}
scene.camera.lookat.target = 0 0 0
scene.camera.up = 0 1 0
scene.camera.screenwindow = -0.1 0.1 -0.1 0.1
scene.camera.autofocus.enable = 0
scene.lights.sun.type = "sharpdistant"
scene.lights.sun.direction = 1 0 -1
''')
    scene.Parse(lines)
    corners = [(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)]
    scene.DefineMesh("quad", corners, [(0, 1, 2), (0, 2, 3)], None, None, None, None)
    lines = pyluxcore.Properties()
    lines.SetFromString(f'scene.objects.q.shape = "quad"\\nscene.objects.q.material = "{name}"')
    scene.Parse(lines)
    settings = pyluxcore.Properties()
    settings.SetFromString('''
renderengine.type = "PATHCPU"
sampler.type = "RANDOM"
path.pathdepth.total = 1
film.width = 8
film.height = 8
film.filter.type = "NONE"
film.imagepipelines.0.0.type = "NOP"
native.threads.count = 1
batch.haltspp = 4
''')
    session = pyluxcore.RenderSession(pyluxcore.RenderConfig(settings, scene))
    session.Start()
    while not session.HasDone():
        session.UpdateStats()
        time.sleep(0.01)
    session.Stop()
    pixels = np.zeros(8 * 8 * 3, np.float32)
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB_IMAGEPIPELINE, pixels, 0)
    # A pixel of the edge may look past the others by a rounding; all see one plane under one light.
    print("FOUND", *np.median(pixels.reshape(-1, 3), axis=0).tolist(), flush=True)
os._exit(0)
"""


def test_luxcore_itself_renders_the_material_as_it_was_fitted(tmp_path: Path) -> None:
    if importlib.util.find_spec("pyluxcore") is None:
        pytest.skip("could not import pyluxcore")
    path = tmp_path / "a.scn"
    BY_NAME["luxcore"].write([ExportItem(PAINT)], path, None)
    views = [math.radians(45.0 - angle) for angle in LABS]
    done = subprocess.run(
        [sys.executable, "-c", _LUX, str(path), "gold_fine", *map(repr, views)],
        capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    found = [line.split()[1:] for line in done.stdout.splitlines() if line.startswith("FOUND")]
    assert len(found) == 3, done.stderr[-2000:]
    wi, wo = np.broadcast_to(illumination(45.0), (3, 3)), aspecular_view(45.0, np.array(list(LABS)))
    expected = fit_carpaint(ExportItem(PAINT)).model.eval(wi, wo) @ TO_709 * math.cos(math.pi / 4.0)
    assert np.array(found, float) == pytest.approx(expected, rel=1e-4)
