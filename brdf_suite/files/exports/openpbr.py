"""MaterialX export (``.mtlx``): the paint as an OpenPBR surface for renderers and film-industry tools.

A metal of one roughness and one colour, mixed with a matt base, under a clearcoat of the paint's own index and
roughness. ``specular_ior`` is that of the coat, so that there is no second interface below it, and the darkening of
base by coat is off, since the readings were taken through the coat. Colours are linear Rec. 709. How the parameters are
found stands in :mod:`brdf_suite.files.exports.metal_rough_fit`.
"""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import PathLike
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.exports.metal_rough_fit import MetalRough, fit_openpbr
from brdf_suite.files.exports.model_fit import fitted_losses, material_names
from brdf_suite.progress import Progress
from brdf_suite.release import __version__


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what an OpenPBR surface cannot hold of a paint; it is fitted for this."""
    found = fit_openpbr(item.modelled)
    what = "OpenPBR (one colour for every angle, so no change of hue)"
    return fitted_losses(item, what, found.differences, found.clipped)


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write the materials of paints; raise :class:`FileError`, or :class:`UnreachableError` of a paint."""
    names = material_names([item.name for item in items])
    blocks = [_block(item, name, fit_openpbr(item.modelled)) for item, name in zip(items, names, strict=True)]
    text = (
        '<?xml version="1.0"?>\n<materialx version="1.39" colorspace="lin_rec709">\n'
        f"{''.join(blocks)}</materialx>\n"
    )
    write_atomically(path, text.encode("utf-8"))
    return ()


def _block(item: ExportItem, name: str, model: MetalRough) -> str:
    floats = {
        "base_weight": 1.0,
        "base_metalness": model.metalness,
        "specular_weight": 1.0,
        "specular_roughness": model.roughness,
        "specular_ior": model.coat_ior,
        "coat_weight": 1.0,
        "coat_roughness": model.coat_roughness,
        "coat_ior": model.coat_ior,
        "coat_darkening": 0.0,
    }
    colour = ", ".join(f"{value:.9g}" for value in model.colour)
    inputs = [f'    <input name="base_color" type="color3" value="{colour}"/>']
    inputs += [f'    <input name="{key}" type="float" value="{value:.9g}"/>' for key, value in floats.items()]
    differences = ", ".join(f"{value:.2f}" for value in model.differences)
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
    holds="One base colour, metalness and roughness under a clearcoat, fitted to the readings.",
    losses=losses,
    write=write,
    many=True,
)
