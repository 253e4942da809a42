"""The default fit of every shipped paint, at the angles where it was measured and between them."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.store import load_paint
from brdf_suite.fitting import LobeFitter
from brdf_suite.fitting.metrics import aspecular_delta_e, directional_reflectance
from brdf_suite.reflectance.build import build_paint
from brdf_suite.resources import resource, resource_names

ENDING = ".brdfpaint"


@pytest.mark.parametrize("name", resource_names("paints", ENDING))
def test_the_fit_shows_the_colours_and_the_gloss_that_were_asked_for(fitter: LobeFitter, name: str) -> None:
    paint = build_paint(load_paint(resource("paints", name + ENDING)))
    fit = fitter.fit(paint)
    # A satin coat shines as far as 15°, where a round lobe is not as wide as it (docs/fit.md).
    bound = 0.05 if paint.roughness < 0.03 else 3.5
    assert aspecular_delta_e(paint, fit.weights, (15.0, 45.0, 110.0)).max() <= bound
    assert aspecular_delta_e(paint, fit.weights, (25.0, 75.0)).max() <= 1.2
    np.testing.assert_allclose(fit.weights.coat_energy(), directional_reflectance(paint.coat), rtol=5e-3)
