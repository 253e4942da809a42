"""A factored paint on the roads that every paint takes: measured, fitted, in a palette, under a coat, handed on."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.cook_torrance import Clearcoat
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import load_palette, save_palette
from brdf_suite.documents.store import load_any_paint
from brdf_suite.errors import SuiteError
from brdf_suite.files.palettes.conversions import as_readings, face_lab
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoringOptions, factor_reflectance, save_factored
from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

WI, WO = spherical([0.2, 0.9, 1.2], 0.3), spherical([0.6, 0.8, 0.1], 2.5)


@pytest.fixture(scope="module")
def found():
    """Polaris silver, factored with few pairs."""
    truth = CookTorrance(TABLE_1["table1_polaris_silver"])
    return factor_reflectance("Polaris", truth, FactoringOptions(pairs=4000))


@pytest.fixture(scope="module")
def path(found, tmp_path_factory) -> Path:
    out = tmp_path_factory.mktemp("paints") / "polaris.brdfpaint"
    save_factored(found, out)
    return out


def test_the_file_is_the_product_that_was_found(found, path: Path) -> None:
    value = load_material(path).reflectance
    assert isinstance(value, Factored)
    np.testing.assert_allclose(value.eval(WI, WO), found.value.eval(WI, WO), rtol=1e-6)
    assert value.facts["largest"] == pytest.approx(found.value.facts["largest"])
    truth = CookTorrance(TABLE_1["table1_polaris_silver"]).eval(WI, WO)
    np.testing.assert_allclose(value.eval(WI, WO), truth, rtol=0.35)
    table = path.with_name("polaris.brdftable")
    save_factored(found, table)
    np.testing.assert_allclose(load_material(table).reflectance.eval(WI, WO), value.eval(WI, WO), rtol=1e-6)


def test_it_is_fitted_and_read_as_every_paint(path: Path) -> None:
    fit = fit_material(load_material(path))
    assert fit.name == "Polaris"
    assert fit.weights.kd.shape == (3,)
    paint = load_any_paint(path)
    assert isinstance(paint, FactoredPaint)
    assert len(as_readings(paint).measurements) >= 3
    assert 20.0 < face_lab(paint)[0] < 120.0


def test_a_palette_keeps_it_and_a_coat_lies_over_it(path: Path, tmp_path: Path) -> None:
    paint = load_any_paint(path)
    assert isinstance(paint, FactoredPaint)
    file = tmp_path / "one.brdfpalette"
    save_palette(Palette("One", (Entry(paint, id="a"),)), file)
    again = load_palette(file).entries[0].content
    assert again == paint
    coated = build_reflectance(replace(paint, clearcoat=Clearcoat(1.5, 0.01)))
    assert isinstance(coated, Coated)
    assert np.isfinite(coated.eval(WI, WO)).all()


def test_without_its_textures_a_palette_still_opens_and_the_paint_says_what_is_missing(
    found, tmp_path: Path
) -> None:
    out = tmp_path / "lost.brdfpaint"
    save_factored(found, out)
    paint = load_any_paint(out)
    assert isinstance(paint, FactoredPaint)
    file = tmp_path / "one.brdfpalette"
    save_palette(Palette("One", (Entry(paint, id="a"),)), file)
    Path(paint.textures.path).unlink()
    moved = load_palette(file).entries[0].content
    assert moved == paint
    with pytest.raises(SuiteError, match="textures"):
        load_material(out)
