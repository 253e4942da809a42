"""glTF 2.0 with ``KHR_materials_clearcoat``, ``_specular`` and ``_ior``: a sphere in the paint, for viewers.

The base colour is that of the matt layer, with metallic 0; flakes are the lobe of ``KHR_materials_specular``, whose
colour, f0 of ``KHR_materials_ior`` times ``specularColorFactor``, is free, so that face and flop differ in hue. Without
flakes ``specularFactor`` is 0: there is no second interface below the coat. The fit
(:mod:`brdf_suite.files.exports.coated_facets_fit`) takes glTF as Blender's Cycles evaluates it, with multiple
scattering. All the rest, the readings too, stands in the material's ``extras`` under ``brdf_suite``, as in the JSON
export, and is read back from there.
"""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Sequence

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.reading import read_json
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.exports import json_document
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportFormat, ExportItem, ImportedPaints
from brdf_suite.files.exports.model_fit import shape_losses
from brdf_suite.files.exports.sphere import RADIUS_M, unit_sphere
from brdf_suite.progress import Progress
from brdf_suite.reflectance.renderers.coated_facets import GLTF_COAT_IOR, GLTF_LOBE_IOR
from brdf_suite.reflectance.renderers.facet_lobe import normal_reflectance
from brdf_suite.release import __version__

EXTRAS = "brdf_suite"


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what a viewer of glTF does not show of a paint; it is fitted for this."""
    found = fit_coated_facets(item, "gltf")
    return (
        *shape_losses(item, "glTF in a renderer with multiple scattering (Blender)", found),
        f"The clearcoat of glTF has the index {GLTF_COAT_IOR:g}, whatever the paint's.",
        "Viewers show no flakes: readings, gloss, flakes and texts go along in the material's extras, which only this "
        "suite reads.",
        *json_document.losses(item),
    )


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write one paint on a sphere; :class:`FileError` where the disk refuses, :class:`UnreachableError` of a paint."""
    (item,) = items
    model = fit_coated_facets(item, "gltf").model
    vertices, triangles = unit_sphere(32, 64)
    data = vertices.tobytes() + triangles.tobytes()
    half, bound = vertices.nbytes, [RADIUS_M] * 3
    # On a unit sphere the normals are the positions; the node makes it smaller.
    document = {
        "asset": {"version": "2.0", "generator": f"BRDF Suite {__version__}"},
        "extensionsUsed": ["KHR_materials_clearcoat", "KHR_materials_ior", "KHR_materials_specular"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": item.name, "mesh": 0, "scale": bound}],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1, "material": 0}]}
        ],
        "materials": [
            {
                "name": item.name,
                "pbrMetallicRoughness": {
                    "baseColorFactor": [*model.diffuse, 1.0],
                    "metallicFactor": 0.0,
                    "roughnessFactor": math.sqrt(model.alpha),
                },
                "extensions": {
                    "KHR_materials_clearcoat": {
                        "clearcoatFactor": 1.0,
                        "clearcoatRoughnessFactor": math.sqrt(model.coat_alpha),
                    },
                    "KHR_materials_ior": {"ior": GLTF_LOBE_IOR},
                    "KHR_materials_specular": {
                        "specularFactor": 1.0 if model.has_lobe else 0.0,
                        "specularColorFactor": [f0 / normal_reflectance(GLTF_LOBE_IOR) for f0 in model.specular],
                    },
                },
                "extras": {EXTRAS: json_document.document(items)},
            }
        ],
        "accessors": [
            {
                "bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3",
                "min": vertices.min(axis=0).tolist(), "max": vertices.max(axis=0).tolist(),
            },
            {"bufferView": 1, "componentType": 5123, "count": triangles.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": half, "target": 34962},
            {"buffer": 0, "byteOffset": half, "byteLength": triangles.nbytes, "target": 34963},
        ],
        "buffers": [
            {
                "byteLength": len(data),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode("ascii"),
            }
        ],
    }  # fmt: skip
    text = json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    write_atomically(path, text.encode("utf-8"))
    return ()


def is_ours(head: bytes) -> bool:
    """Return whether the first bytes of a file are those of a glTF that this suite wrote."""
    return (
        head.lstrip(b" \t\r\n").startswith(b"{")
        and b'"asset"' in head
        and b'"generator": "BRDF Suite' in head
    )


def read(path: PathLike) -> ImportedPaints:
    """Return the paint in the extras of a glTF that this suite wrote; raise :class:`FileError` where there is none."""
    value = read_json(path)
    try:
        found = value["materials"][0]["extras"][EXTRAS]  # type: ignore[index]  # any shape but ours is caught
    except (KeyError, IndexError, TypeError) as error:
        raise FileError(path, "holds no paint of this suite", f"materials[0].extras.{EXTRAS}") from error
    return json_document.import_paints(found, path)


FORMAT = ExportFormat(
    name="gltf",
    title="glTF, clearcoat (KHR_materials_clearcoat)",
    ending=".gltf",
    holds="A matt colour and a lobe of another under a clearcoat of index 1.5; the readings in extras.",
    losses=losses,
    write=write,
    read=read,
    sniff=is_ours,
)
