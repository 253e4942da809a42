"""MaterialX documents as reflectances, against the shaders that MaterialX itself generates of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError
from brdf_suite.files.exports import FORMATS
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.measured import read_measured, sniff
from brdf_suite.pipeline.material import load_material, load_shipped_paint
from brdf_suite.reflectance.albedo import white_furnace
from brdf_suite.reflectance.renderers.surface_shader import SurfaceShader

_shader = load_module(Path(__file__).parents[1] / "exports" / "materialx_shader.py")
TO_709 = WORKING_TO_SRGB.T

DOCUMENT = """<?xml version="1.0"?>
<materialx version="{version}"{space}>
{before}  <{kind} name="surface" type="surfaceshader"{more}>
{inputs}  </{kind}>
  <surfacematerial name="paint" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="surface"/>
  </surfacematerial>
</materialx>
"""
Given = dict[str, float | tuple[float, float, float] | bool]


def element(name: str, value: float | tuple[float, ...] | bool, tag: str = "input") -> str:
    kind = "boolean" if isinstance(value, bool) else "float" if isinstance(value, (int, float)) else "color3"
    text = str(value).lower() if isinstance(value, bool) else str(value).strip("()")
    return f'    <{tag} name="{name}" type="{kind}" value="{text}"/>\n'


def document(kind: str, inputs: Given, **changes: str) -> str:
    fields = {"version": "1.39", "space": ' colorspace="lin_rec709"', "before": "", "more": ""} | changes
    text = "".join(element(name, value) for name, value in inputs.items())
    return DOCUMENT.format(kind=kind, inputs=text + fields.pop("raw", ""), **fields)


RED, BLUE, GOLD = (0.6, 0.1, 0.05), (0.05, 0.1, 0.4), (0.9, 0.6, 0.2)
STANDARD: dict[str, Given] = {
    "defaults": {},
    "matt": {"base_color": RED, "specular": 0.0},
    "rough diffuse": {"base_color": RED, "specular": 0.0, "diffuse_roughness": 0.8},
    "half a base": {"base": 0.4, "base_color": RED},
    "glossy": {"base_color": BLUE, "specular_roughness": 0.35},
    "tinted": {"base_color": BLUE, "specular_color": GOLD, "specular_roughness": 0.5},
    "weak": {"base_color": RED, "specular": 0.3, "specular_roughness": 0.4},
    "another index": {"base_color": RED, "specular_IOR": 1.8, "specular_roughness": 0.3},
    "metal": {"base_color": GOLD, "metalness": 1.0, "specular_roughness": 0.4},
    "metal with an edge": {"base_color": GOLD, "metalness": 1.0, "specular_color": RED, "specular_roughness": 0.5},
    "half a metal": {"base_color": GOLD, "metalness": 0.5, "specular_roughness": 0.4},
    "coat": {"base_color": RED, "coat": 1.0, "coat_roughness": 0.3},
    "half a coat": {"base_color": RED, "coat": 0.5, "coat_roughness": 0.3, "coat_IOR": 1.7},
    "coloured coat": {"base_color": RED, "coat": 1.0, "coat_color": GOLD, "coat_roughness": 0.4},
    "coat on metal": {"base_color": GOLD, "metalness": 1.0, "coat": 1.0, "specular_roughness": 0.5},
    "coat with effects": {
        "base_color": RED, "coat": 1.0, "coat_roughness": 0.4, "coat_affect_color": 0.7, "coat_affect_roughness": 0.6,
    },
    "all": {
        "base": 0.7, "base_color": RED, "diffuse_roughness": 0.3, "metalness": 0.3, "specular": 0.8,
        "specular_color": GOLD, "specular_roughness": 0.45, "specular_IOR": 1.6, "coat": 0.7, "coat_color": GOLD,
        "coat_roughness": 0.3, "coat_IOR": 1.45,
    },
    "rough metal": {"base_color": GOLD, "metalness": 1.0, "specular_roughness": 0.8},
    "tinted weak specular": {"base_color": RED, "specular": 0.5, "specular_color": GOLD, "specular_roughness": 0.4},
    "coat of a high index": {"base_color": BLUE, "coat": 1.0, "coat_IOR": 1.9, "coat_roughness": 0.35},
}  # fmt: skip
OPENPBR: dict[str, Given] = {
    "defaults": {},
    "matt": {"base_color": RED, "specular_weight": 0.0},
    "rough diffuse": {"base_color": RED, "specular_weight": 0.0, "base_diffuse_roughness": 0.7},
    "half a base": {"base_weight": 0.4, "base_color": RED},
    "glossy": {"base_color": BLUE, "specular_roughness": 0.4},
    "tinted": {"base_color": BLUE, "specular_color": GOLD, "specular_roughness": 0.5},
    "weak": {"base_color": RED, "specular_weight": 0.3},
    "strong": {"base_color": RED, "specular_weight": 2.0, "specular_ior": 1.6},
    "metal": {"base_color": GOLD, "base_metalness": 1.0, "specular_roughness": 0.4},
    "metal with an edge": {"base_color": GOLD, "base_metalness": 1.0, "specular_color": RED, "specular_roughness": 0.5},
    "half a metal": {"base_color": GOLD, "base_metalness": 0.5, "specular_roughness": 0.4},
    "weak metal": {"base_color": GOLD, "base_metalness": 1.0, "specular_weight": 0.6},
    "coat": {"base_color": RED, "coat_weight": 1.0, "coat_roughness": 0.3},
    "coat without darkening": {"base_color": RED, "coat_weight": 1.0, "coat_roughness": 0.3, "coat_darkening": 0.0},
    "half a coat": {"base_color": RED, "coat_weight": 0.5, "coat_roughness": 0.3, "coat_ior": 1.4},
    "coloured coat": {"base_color": RED, "coat_weight": 1.0, "coat_color": GOLD, "coat_roughness": 0.4},
    "coat on metal": {"base_color": GOLD, "base_metalness": 1.0, "coat_weight": 1.0, "coat_roughness": 0.3},
    "all": {
        "base_weight": 0.9, "base_color": RED, "base_diffuse_roughness": 0.3, "base_metalness": 0.3,
        "specular_weight": 0.8, "specular_color": GOLD, "specular_roughness": 0.45, "specular_ior": 1.6,
        "coat_weight": 0.7, "coat_color": GOLD, "coat_roughness": 0.3, "coat_ior": 1.45, "coat_darkening": 0.5,
    },
    "another index": {"base_color": BLUE, "specular_ior": 1.9, "specular_roughness": 0.4},
    "coat on half a metal": {
        "base_color": GOLD, "base_metalness": 0.5, "specular_roughness": 0.5, "coat_weight": 1.0, "coat_roughness": 0.3,
    },
    "coat on a rough base": {
        "base_color": RED, "base_diffuse_roughness": 0.5, "specular_weight": 0.5, "specular_roughness": 0.6,
        "coat_weight": 1.0, "coat_roughness": 0.35,
    },
}  # fmt: skip
GLTF: dict[str, Given] = {
    "defaults": {},
    "plastic": {"base_color": RED, "metallic": 0.0, "roughness": 0.4},
    "matt": {"base_color": RED, "metallic": 0.0, "specular": 0.0},
    "rough": {"base_color": RED, "metallic": 0.0, "roughness": 0.8},
    "metal": {"base_color": GOLD, "metallic": 1.0, "roughness": 0.4},
    "half a metal": {"base_color": GOLD, "metallic": 0.5, "roughness": 0.5},
    "coloured specular": {"base_color": BLUE, "metallic": 0.0, "specular_color": GOLD, "roughness": 0.4},
    "weak specular": {"base_color": BLUE, "metallic": 0.0, "specular": 0.4, "roughness": 0.4},
    "another index": {"base_color": BLUE, "metallic": 0.0, "ior": 1.9, "roughness": 0.4},
    "clearcoat": {"base_color": RED, "metallic": 0.0, "clearcoat": 1.0, "clearcoat_roughness": 0.3},
    "half a clearcoat": {"base_color": GOLD, "metallic": 1.0, "clearcoat": 0.5, "clearcoat_roughness": 0.3},
    "all": {
        "base_color": GOLD, "metallic": 0.3, "roughness": 0.5, "specular": 0.8, "specular_color": BLUE, "ior": 1.7,
        "clearcoat": 0.6, "clearcoat_roughness": 0.35,
    },
    "rough metal": {"base_color": GOLD, "metallic": 1.0, "roughness": 0.8},
    "dark plastic": {"base_color": (0.02, 0.02, 0.02), "metallic": 0.0, "roughness": 0.35},
    "clearcoat on metal": {
        "base_color": GOLD, "metallic": 1.0, "roughness": 0.5, "clearcoat": 1.0, "clearcoat_roughness": 0.3,
    },
    "clearcoat on matt": {
        "base_color": BLUE, "metallic": 0.0, "specular": 0.0, "clearcoat": 1.0, "clearcoat_roughness": 0.4,
    },
    "quarter of a metal": {"base_color": RED, "metallic": 0.25, "roughness": 0.45},
    "weak coloured specular": {
        "base_color": RED, "metallic": 0.0, "specular": 0.5, "specular_color": GOLD, "roughness": 0.5,
    },
    "low index": {"base_color": RED, "metallic": 0.0, "ior": 1.3, "roughness": 0.4},
    "index under a clearcoat": {
        "base_color": BLUE, "metallic": 0.0, "ior": 1.8, "roughness": 0.5, "clearcoat": 0.8, "clearcoat_roughness": 0.4,
    },
}  # fmt: skip
VARIANTS = {"standard_surface": STANDARD, "open_pbr_surface": OPENPBR, "gltf_pbr": GLTF}
LEAST_VARIANTS = 20


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "paint.mtlx"
    path.write_text(text, "utf-8")
    return path


@pytest.mark.parametrize("kind", VARIANTS)
def test_the_reflectance_is_that_of_the_shader_of_materialx(tmp_path: Path, kind: str) -> None:
    """The shader is compiled once; its inputs are uniforms."""
    differences = {}
    assert len(VARIANTS[kind]) >= LEAST_VARIANTS
    with _shader.open_shader(written(tmp_path, document(kind, {}))) as shader:
        for name, given in VARIANTS[kind].items():
            shader.set({f"surface_{key}": size for key, size in given.items()})
            wi, wo, found = shader.shade()
            value = read_measured(written(tmp_path, document(kind, given)))
            ours = value.eval(wi, wo) @ TO_709 * wi[:, 2:]
            # Its formulas for albedos are approximations, which differ most towards grazing and in dark channels;
            # without a specular weight it takes light from the base nevertheless.
            limit = 0.07 if given.get("specular_weight") == 0.0 else 0.04
            steep = np.abs(found / ours - 1.0)[wo[:, 2] > 0.5].max()
            differences[name] = max(np.abs(found - ours).max() / np.abs(ours).max(), steep) / limit
    assert {name: size for name, size in differences.items() if size > 1.0} == {}


PLAIN: Given = {"base_color": RED, "specular_roughness": 0.4}
GRAPH = """  <nodegraph name="graph">
    <input name="tone" type="color3" value="0.6, 0.1, 0.05"/>
    <constant name="red" type="color3"><input name="value" type="color3" value="0.6, 0.1, 0.05"/></constant>
    <constant name="inner" type="color3"><input name="value" type="color3" interfacename="tone"/></constant>
    <dot name="passed" type="color3"><input name="in" type="color3" nodename="red"/></dot>
    <output name="out" type="color3" nodename="red"/>
    <output name="tone_out" type="color3" interfacename="tone"/>
    <output name="inner_out" type="color3" nodename="inner"/>
    <output name="passed_out" type="color3" nodename="passed"/>
  </nodegraph>
"""
ROUGH = element("specular_roughness", 0.4)
OLD = """<?xml version="1.0"?>
<materialx version="1.36">
  <material name="paint">
    <shaderref name="surface" node="standard_surface">
      <bindinput name="base" type="float" value="1.0"/>
      <bindinput name="base_color" type="color3" value="0.6, 0.1, 0.05"/>
      <bindinput name="specular_roughness" type="float" value="0.4"/>
    </shaderref>
  </material>
</materialx>
"""


def connected(**attributes: str) -> str:
    text = " ".join(f'{name}="{value}"' for name, value in attributes.items())
    return f'    <input name="base_color" type="color3" {text}/>\n' + ROUGH


def encode(linear: float, exponent: float) -> float:
    return linear ** (1.0 / exponent)


SAME = {
    "plain": document("standard_surface", PLAIN),
    "without a colour space": document("standard_surface", PLAIN, space=""),
    "none": document("standard_surface", PLAIN, space=' colorspace="none"'),
    "version 1.38": document("standard_surface", PLAIN, version="1.38"),
    "version 1.37": document("standard_surface", PLAIN | {"base": 1.0}, version="1.37"),
    "version 1.0.0 of the shader": document(
        "standard_surface", PLAIN | {"base": 1.0}, more=' version="1.0.0"'
    ),
    "shaderref": OLD,
    "parameters": document("standard_surface", PLAIN).replace('<input name="base', '<parameter name="base'),
    "spaces for commas": document("standard_surface", PLAIN).replace("0.6, 0.1, 0.05", "0.6 0.1  0.05"),
    "color4": document("standard_surface", PLAIN).replace(
        'color3" value="0.6, 0.1, 0.05"', 'color4" value="0.6, 0.1, 0.05, 1"'
    ),
    "comments and a namespace": document("standard_surface", PLAIN).replace(
        "<materialx", '<!-- a --><materialx xmlns:xi="http://www.w3.org/2001/XInclude"'
    ),
    "a byte order mark": "\ufeff" + document("standard_surface", PLAIN),
    "carriage returns": document("standard_surface", PLAIN).replace("\n", "\r\n"),
    "no material": document("standard_surface", PLAIN).replace("surfacematerial", "other"),
    "graph": document("standard_surface", {}, before=GRAPH, raw=connected(nodegraph="graph")),
    "graph, by its output": document(
        "standard_surface", {}, before=GRAPH, raw=connected(nodegraph="graph", output="out")
    ),
    "graph, by its interface": document(
        "standard_surface", {}, before=GRAPH, raw=connected(nodegraph="graph", output="tone_out")
    ),
    "graph, by an inner interface": document(
        "standard_surface", {}, before=GRAPH, raw=connected(nodegraph="graph", output="inner_out")
    ),
    "graph, passed on": document(
        "standard_surface", {}, before=GRAPH, raw=connected(nodegraph="graph", output="passed_out")
    ),
    "a constant outside": document(
        "standard_surface",
        {},
        before=f'  <constant name="red" type="color3">{element("value", RED)}</constant>\n',
        raw=connected(nodename="red"),
    ),
    "encoded as sRGB": document(
        "standard_surface",
        PLAIN | {"base_color": tuple(1.055 * c ** (1 / 2.4) - 0.055 for c in RED)},
        space=' colorspace="srgb_texture"',
    ),
    "encoded as sRGB, one input": document(
        "standard_surface", PLAIN | {"base_color": tuple(1.055 * c ** (1 / 2.4) - 0.055 for c in RED)}
    ).replace('name="base_color"', 'name="base_color" colorspace="srgb_texture"'),
    "gamma 2.2": document(
        "standard_surface",
        PLAIN | {"base_color": tuple(encode(c, 2.2) for c in RED)},
        space=' colorspace="g22_rec709"',
    ),
    "gamma 1.8": document(
        "standard_surface",
        PLAIN | {"base_color": tuple(encode(c, 1.8) for c in RED)},
        space=' colorspace="g18_rec709"',
    ),
    # 0.6, 0.1, 0.05 of Rec. 709 in AP1 with the white of ACES (Bradford), rounded to five digits.
    "ACEScg": document(
        "standard_surface", PLAIN | {"base_color": (0.40418, 0.13443, 0.06681)}, space=' colorspace="acescg"'
    ),
}


@pytest.mark.parametrize("name", SAME)
def test_every_way_to_write_a_document_gives_the_same_reflectance(tmp_path: Path, name: str) -> None:
    path = written(tmp_path, SAME[name])
    assert sniff(path).name == "materialx"
    value = read_measured(path)
    assert isinstance(value, SurfaceShader)
    tolerance = 1e-2 if name == "ACEScg" else 1e-9
    assert value.base == pytest.approx(RED, rel=tolerance, abs=2e-3 if name == "ACEScg" else 0.0)
    assert value.alpha == pytest.approx(0.16)
    assert not [note for note in value.facts.get("notes", ()) if "Left out" in note or "not read" in note]


def test_the_documents_of_the_suite_read_back(tmp_path: Path) -> None:
    paint = load_shipped_paint("gold_metallic")
    path = tmp_path / "gold.mtlx"
    next(known for known in FORMATS if known.name == "openpbr").write([ExportItem(paint)], path, None)
    material = load_material(path)
    model = fit_coated_facets(ExportItem(paint), "openpbr").model
    wi, wo = (
        _shader.illumination(np.full(4, 45.0)),
        _shader.aspecular_view(45.0, np.array([15, 25, 45, 110.0])),
    )
    assert material.eval(wi, wo) == pytest.approx(model.eval(wi, wo), rel=1e-4)
    assert material.facts["model"] == "OpenPBR Surface"


LOST = {
    "standard_surface": {
        "transmission": 0.5, "sheen": 0.3, "thin_film_thickness": 300.0, "emission": 1.0, "opacity": (0.5, 0.5, 0.5),
        "specular_anisotropy": 0.4, "thin_walled": True,
    },
    "open_pbr_surface": {
        "transmission_weight": 0.5, "fuzz_weight": 0.2, "thin_film_weight": 1.0, "emission_luminance": 10.0,
        "geometry_opacity": 0.5, "coat_roughness_anisotropy": 0.5,
    },
    "gltf_pbr": {
        "transmission": 0.5, "sheen_color": (0.1, 0.1, 0.1), "iridescence": 1.0, "emissive": (1.0, 1.0, 1.0),
        "anisotropy_strength": 0.5,
    },
}  # fmt: skip


@pytest.mark.parametrize(("kind", "name"), [(kind, name) for kind, given in LOST.items() for name in given])
def test_what_cannot_be_held_is_named(tmp_path: Path, kind: str, name: str) -> None:
    value = read_measured(written(tmp_path, document(kind, {name: LOST[kind][name]})))
    (note,) = [note for note in value.facts["notes"] if note.startswith("Left out")]
    assert name in note


def test_textures_and_normal_maps_are_named(tmp_path: Path) -> None:
    image = (
        '  <image name="albedo" type="color3"><input name="file" type="filename" value="a.png"/></image>\n'
    )
    normal = '    <input name="normal" type="vector3" nodename="bumps"/>\n'
    text = document("standard_surface", {}, before=image, raw=connected(nodename="albedo") + normal)
    value = read_measured(written(tmp_path, text))
    assert value.base == (0.8, 0.8, 0.8)
    notes = " ".join(value.facts["notes"])
    assert "base_color (image)" in notes
    assert "normal (given by a map)" in notes


def test_the_first_of_several_materials_is_read_and_the_others_named(tmp_path: Path) -> None:
    text = document("standard_surface", PLAIN)
    second = text[text.index("  <standard") : text.index("</materialx>")]
    second = second.replace('surface" type', 'surface2" type').replace('"surface"/', '"surface2"/')
    second = second.replace('name="paint"', 'name="glass"')
    value = read_measured(written(tmp_path, text.replace("</materialx>", second + "</materialx>")))
    assert value.facts["name"] == "paint"
    assert any("2 materials" in note and "glass" in note for note in value.facts["notes"])


def test_values_beyond_their_range_are_limited_and_named(tmp_path: Path) -> None:
    given = {"base_color": (1.5, 0.5, -0.1), "specular_roughness": 0.0, "specular_IOR": 0.5, "metalness": 3.0}
    value = read_measured(written(tmp_path, document("standard_surface", given)))
    assert value.base == (1.0, 0.5, 0.0)
    assert value.metalness == 1.0
    assert value.specular_ior == 2.0
    (note,) = [note for note in value.facts["notes"] if note.startswith("Values limited")]
    assert all(name in note for name in given)


def test_a_white_furnace_loses_little_and_gains_nothing(tmp_path: Path) -> None:
    given = {
        "base_color": (1.0, 1.0, 1.0),
        "specular_roughness": 0.5,
        "coat_weight": 1.0,
        "coat_roughness": 0.4,
    }
    value = read_measured(written(tmp_path, document("open_pbr_surface", given)))
    found = white_furnace(value, _shader.illumination(np.array([10.0, 45.0, 70.0])))
    assert found.min() > 0.8
    assert found.max() < 1.01


@pytest.mark.parametrize(
    ("old", "new", "reason", "line"),
    [
        ("0.6, 0.1, 0.05", "0.6, 0.1", "expected 3 finite numbers", 4),
        ("0.6, 0.1, 0.05", "0.6, nan, 1", "expected 3 finite numbers", 4),
        ('value="0.4"', 'value="rough"', "expected 1 finite", 5),
        ("standard_surface", "disney_principled", "no surface shader that is known", 2),
        ('version="1.39"', 'version="new"', "none of MaterialX", 2),
        ("</standard_surface>", "", "not valid XML", 0),
        ("<?xml", "<!DOCTYPE materialx [<!ENTITY a 'b'>]><?xml", "document type", 0),
    ],
)
def test_damage_is_refused_with_the_line(tmp_path: Path, old: str, new: str, reason: str, line: int) -> None:
    text = document("standard_surface", PLAIN)
    assert old in text
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, text.replace(old, new)))
    assert (caught.value.place or "").startswith(f"line {line}" if line else "line")


def test_connections_that_go_round_are_refused(tmp_path: Path) -> None:
    ring = """  <nodegraph name="graph">
    <dot name="a" type="color3"><input name="in" type="color3" nodename="b"/></dot>
    <dot name="b" type="color3"><input name="in" type="color3" nodename="a"/></dot>
    <output name="out" type="color3" nodename="a"/>
  </nodegraph>
"""
    text = document("standard_surface", {}, before=ring, raw=connected(nodegraph="graph"))
    with pytest.raises(FileError, match="go round"):
        read_measured(written(tmp_path, text))
