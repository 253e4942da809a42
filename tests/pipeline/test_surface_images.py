"""What a view lays on the paint: which changes of it ask for another load, and the second paint's lamp."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import LightColour, TwoTone
from brdf_suite.pipeline.lobe_fit import fit_material, refit_under
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.surface_images import ImageRequest, load_surface_images


def test_a_second_paint_with_spectra_is_fitted_for_the_views_lamp(shared_data: Path) -> None:
    file = shared_data / "brdf" / "krylon_blue.brdf"
    lamp = LightColour("A")
    request = ImageRequest(second_paint=str(file), lamp="A")
    found = load_surface_images(request).second_paint
    fit = fit_material(load_material(file))
    assert found is not None
    np.testing.assert_allclose(found.weights.kd, refit_under(fit, lamp).weights.kd, atol=1e-9)
    assert np.abs(found.weights.kd - fit.weights.kd).max() > 1e-4


def test_the_lamp_matters_only_where_there_is_a_second_paint() -> None:
    lit = View(light_colour=LightColour("A"))
    assert ImageRequest.of(lit) == ImageRequest.of(View())
    two = TwoTone(paint="solid_red", mask="/somewhere/mask.png")
    assert ImageRequest.of(replace(lit, two_tone=two)) != ImageRequest.of(View(two_tone=two))
