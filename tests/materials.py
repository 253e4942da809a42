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
