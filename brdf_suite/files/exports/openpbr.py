"""MaterialX export (``.mtlx``): the paint as an OpenPBR surface for renderers and film-industry tools.

A matt base and a specular lobe of its own colour, under a clearcoat of the paint's index and roughness. Metalness is 0:
the lobe is a dielectric whose ``specular_ior`` is high against that of the coat, coloured by ``specular_color``; a
solid paint has the coat's own index, so that there is no second interface. The darkening of the base by the coat is
off, since the readings were taken through it. Colours are linear Rec. 709. The parameters are those of
:mod:`brdf_suite.files.exports.coated_facets_fit`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import PathLike
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.exports.model_fit import Fitted, fitted_losses, material_names
from brdf_suite.progress import Progress
from brdf_suite.reflectance.renderers.coated_facets import CoatedFacets
from brdf_suite.reflectance.renderers.facet_lobe import index_of
from brdf_suite.release import __version__


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what an OpenPBR surface cannot hold of a paint; it is fitted for this."""
    return fitted_losses(item, "OpenPBR in MaterialX", fit_coated_facets(item, "openpbr"))


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write the materials of paints; raise :class:`FileError`, or :class:`UnreachableError` of a paint."""
    names = material_names([item.name for item in items])
    blocks = [
        _block(item, name, fit_coated_facets(item, "openpbr"))
        for item, name in zip(items, names, strict=True)
    ]
    text = (
        '<?xml version="1.0"?>\n<materialx version="1.39" colorspace="lin_rec709">\n'
        f"{''.join(blocks)}</materialx>\n"
    )
    write_atomically(path, text.encode("utf-8"))
    return ()


def _block(item: ExportItem, name: str, found: Fitted[CoatedFacets]) -> str:
    model = found.model
    floats = {
        "base_weight": 1.0,
        "base_metalness": 0.0,
        "specular_weight": 1.0,
        "specular_roughness": math.sqrt(model.alpha),
        "specular_ior": model.coat_ior * index_of(model.grey),
        "coat_weight": 1.0,
        "coat_roughness": math.sqrt(model.coat_alpha),
        "coat_ior": model.coat_ior,
        "coat_darkening": 0.0,
    }
    colours = {"base_color": model.diffuse, "specular_color": model.specular}
    inputs = [
        f'    <input name="{key}" type="color3" value="{", ".join(f"{value:.9g}" for value in colour)}"/>'
        for key, colour in colours.items()
    ]
    inputs += [f'    <input name="{key}" type="float" value="{value:.9g}"/>' for key, value in floats.items()]
    differences = ", ".join(f"{value:.2f}" for value in found.differences)
    comment = f"{item.name}, by BRDF Suite {__version__}; ΔE00 at its readings: {differences}"
    lines = "\n".join(inputs)
    return (
        f'  <open_pbr_surface name="{name}_surface" type="surfaceshader" doc={quoteattr(comment)}>\n{lines}\n'
        "  </open_pbr_surface>\n"
        f'  <surfacematerial name="{name}" type="material">\n'
        f'    <input name="surfaceshader" type="surfaceshader" nodename="{name}_surface"/>\n'
        "  </surfacematerial>\n"
    )


FORMAT = ExportFormat(
    name="openpbr",
    title="MaterialX, OpenPBR surface",
    ending=".mtlx",
    holds="A matt colour and a lobe of another under a clearcoat, fitted on a sphere.",
    losses=losses,
    write=write,
    many=True,
)
