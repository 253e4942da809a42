"""USD (``.usda``): paints as materials of ``UsdPreviewSurface``, which every program that reads USD knows.

One colour, of a metal or of a matt layer, and one roughness, under a clearcoat of index ``ior``. ``metallic`` is 0 or
1, since programs differ between these: a blue of ``metallic`` 0.7, fitted to ΔE00 3.0 in MaterialX, was 11 off in
Blender. The specular workflow, which has two colours, is left out by many programs. The surface is fitted as MaterialX
evaluates it (:mod:`brdf_suite.files.exports.coated_facets_fit`). Each material has a sphere in its paint, 0.2 m wide;
the axis up is y, and a unit is a metre. The spheres are meshes, all of one class, since Blender gives ``Sphere`` prims
no material. Colours are linear Rec. 709.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import replace

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import PathLike
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.exports.model_fit import Fitted, fitted_losses, material_names
from brdf_suite.files.exports.sphere import RADIUS_M, unit_sphere
from brdf_suite.progress import Progress
from brdf_suite.reflectance.instruments.rendered_sphere import sphere_difference
from brdf_suite.reflectance.renderers.coated_facets import CoatedFacets
from brdf_suite.release import __version__

_APART_M = 0.25


def loss_in_blender(item: ExportItem) -> float:
    """Return the mean ΔE00 on a sphere as Blender evaluates what is written."""
    found = fit_coated_facets(item, "usd").model
    return sphere_difference(item.reflectance, replace(found, in_blender=True))


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what a USD Preview Surface cannot hold of a paint; it is fitted for this."""
    known = fitted_losses(
        item,
        "USD Preview Surface (one colour for every angle, so no change of hue)",
        fit_coated_facets(item, "usd"),
    )
    return (
        *known,
        f"In Blender, which evaluates the clearcoat otherwise, ΔE00 {loss_in_blender(item):.1f} on a sphere.",
    )


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write the materials of paints, and spheres; raise :class:`FileError`, or :class:`UnreachableError` of a paint."""
    # A name in USD does not begin with a digit.
    names = [f"_{name}" if name[0].isdigit() else name for name in material_names([i.name for i in items])]
    found = [fit_coated_facets(item, "usd") for item in items]
    materials = "".join(
        _material(item, name, one) for item, name, one in zip(items, names, found, strict=True)
    )
    spheres = "".join(_sphere(index, name) for index, name in enumerate(names))
    maker = f"By BRDF Suite {__version__}"
    text = (
        "#usda 1.0\n(\n"
        '    defaultPrim = "Paints"\n'
        f"    doc = {_text(maker)}\n"
        "    metersPerUnit = 1\n"
        '    upAxis = "Y"\n)\n\n'
        f'{_shape()}\ndef Xform "Paints"\n{{\n    def Scope "Materials"\n    {{\n{materials}    }}\n{spheres}}}\n'
    )
    write_atomically(path, text.encode("utf-8"))
    return ()


def _material(item: ExportItem, name: str, found: Fitted[CoatedFacets]) -> str:
    model = found.model
    differences = ", ".join(f"{value:.2f}" for value in found.differences)
    reported = f"{item.name}; dE00 {found.on_sphere:.2f} on a sphere, at its readings {differences}"
    inputs = {
        "color3f inputs:diffuseColor": _triple(model.diffuse),
        "float inputs:metallic": "1" if model.metal else "0",
        "float inputs:roughness": f"{math.sqrt(model.alpha):.9g}",
        "float inputs:clearcoat": "1",
        "float inputs:clearcoatRoughness": f"{math.sqrt(model.coat_alpha):.9g}",
        "float inputs:ior": f"{model.coat_ior:.9g}",
    }
    lines = "".join(f"                {key} = {value}\n" for key, value in inputs.items())
    return (
        f'        def Material "{name}" (\n            doc = {_text(reported)}\n        )\n        {{\n'
        f"            token outputs:surface.connect = </Paints/Materials/{name}/Surface.outputs:surface>\n\n"
        '            def Shader "Surface"\n            {\n'
        '                uniform token info:id = "UsdPreviewSurface"\n'
        f"{lines}                token outputs:surface\n            }}\n        }}\n"
    )


def _shape() -> str:
    """Return the mesh of all spheres, an abstract class."""
    vertices, triangles = unit_sphere(24, 48)
    points, normals = (
        ", ".join(_triple(place) for place in places.tolist()) for places in (RADIUS_M * vertices, vertices)
    )
    return (
        'class Mesh "Sphere"\n{\n'
        f"    float3[] extent = [{_triple([-RADIUS_M] * 3)}, {_triple([RADIUS_M] * 3)}]\n"
        f"    int[] faceVertexCounts = [{', '.join(['3'] * len(triangles))}]\n"
        f"    int[] faceVertexIndices = [{', '.join(map(str, triangles.ravel().tolist()))}]\n"
        f"    point3f[] points = [{points}]\n"
        f'    normal3f[] normals = [{normals}] (\n        interpolation = "vertex"\n    )\n'
        '    uniform token subdivisionScheme = "none"\n}\n'
    )


def _sphere(index: int, name: str) -> str:
    return (
        f'\n    def Mesh "{name}" (\n        prepend apiSchemas = ["MaterialBindingAPI"]\n'
        "        prepend inherits = </Sphere>\n    )\n    {\n"
        f"        double3 xformOp:translate = ({index * _APART_M:g}, 0, 0)\n"
        '        uniform token[] xformOpOrder = ["xformOp:translate"]\n'
        f"        rel material:binding = </Paints/Materials/{name}>\n    }}\n"
    )


def _triple(values: Sequence[float]) -> str:
    return f"({', '.join(f'{value:.9g}' for value in values)})"


def _text(value: str) -> str:
    """Return a text in quotes, as USD's text format reads it: the escapes of JSON, with letters as they are."""
    return json.dumps(" ".join(value.split()), ensure_ascii=False)


FORMAT = ExportFormat(
    name="usd",
    title="USD Preview Surface",
    ending=".usda",
    holds="One colour, of a metal or a matt layer, and a roughness under a clearcoat, fitted on a sphere.",
    losses=losses,
    write=write,
    many=True,
)
