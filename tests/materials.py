"""A name or file of every kind of material: every command and program takes each of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.files.measured import write_measured
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoringOptions, factor_reflectance, save_factored
from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.material import load_document, load_material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.reflectance.tensor.tabulate import tabulate

_GRID = (
    """VERSION 0.2
DATA_TYPE brdf
COLOR_MODEL rgb
PARAM_TYPE specular_coordinate_system
REDUCTION_TYPE bilateral_symmetry
PARAM0_LIST 0 60
PARAM2_LIST 0 15 90 180
PARAM3_LIST 0 180
DATA ascii
"""
    + 2
    * "0.9 0.8 0.7\n0.9 0.8 0.7\n0.3 0.2 0.1\n0.3 0.2 0.1\n0.2 0.1 0.05\n0.2 0.1 0.05\n0.2 0.1 0.05\n0.2 0.1 0.05\n"
)
_SHADER = """<?xml version="1.0"?>
<materialx version="1.39" colorspace="lin_rec709">
  <open_pbr_surface name="surface" type="surfaceshader">
    <input name="base_color" type="color3" value="0.5, 0.1, 0.05"/>
    <input name="specular_roughness" type="float" value="0.5"/>
    <input name="coat_weight" type="float" value="1"/>
    <input name="coat_roughness" type="float" value="0.2"/>
  </open_pbr_surface>
</materialx>
"""


def make_materials(folder: Path) -> dict[str, str]:
    """Return a name or file of each kind; files are written to ``folder``."""
    red, silver = load_document("red"), load_document("table1_polaris_silver")
    save_paint(red, folder / "red.brdfpaint")
    (folder / "red.json").write_bytes((folder / "red.brdfpaint").read_bytes())
    save_paint(silver, folder / "silver.brdfpaint")
    factored = factor_reflectance(
        "Silver", load_material("table1_polaris_silver").reflectance, FactoringOptions(pairs=4000)
    )
    save_factored(factored, folder / "factored.brdfpaint")
    # Coarse, since every test reads it: one of the full size has 42 MB.
    satin = tabulate(load_material("satin_blue").reflectance, incidences=24, resolution=64)
    write_measured(satin, folder / "satin.bsdf")
    write_measured(_scattered(), folder / "samples.astm")
    (folder / "grid.ssdd").write_text(_GRID)
    (folder / "coated.mtlx").write_text(_SHADER)
    two = Palette("Two", (Entry(red, id="1"), Entry(silver, id="2")))
    save_palette(two, folder / "two.brdfpalette")
    save_palette(Palette("One", (Entry(red, id="1"),)), folder / "one.brdfpalette")
    names = {
        "paint file": "red.brdfpaint",
        "paint file of another ending": "red.json",
        "Cook-Torrance file": "silver.brdfpaint",
        "factored file": "factored.brdfpaint",
        "RGL file": "satin.bsdf",
        "scattered file": "samples.astm",
        "table over angles": "grid.ssdd",
        "surface shader": "coated.mtlx",
        "palette entry": "two.brdfpalette#2",
        "palette of one": "one.brdfpalette",
    }
    files = {kind: str(folder / name) for kind, name in names.items()}
    return {"shipped": "blue", "table 1": "table1_blue", "model": "lambertian", **files}


def _scattered() -> ScatteredSamples:
    theta, phi = np.meshgrid(np.radians(np.arange(0.0, 85.0, 10.0)), np.radians(np.arange(0.0, 360.0, 30.0)))
    wo = spherical(theta.ravel(), phi.ravel())
    light = np.repeat(spherical(np.radians([5.0, 25.0, 45.0, 65.0]), np.pi), len(wo), axis=0)
    views = np.tile(wo, (4, 1))
    return ScatteredSamples(light, views, Lambertian((0.5, 0.3, 0.2)).eval(light, views))
