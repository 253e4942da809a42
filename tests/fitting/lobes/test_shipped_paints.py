"""The default fit of every shipped paint, at the angles where it was measured and between them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.documents.paint import Measurement
from brdf_suite.documents.store import load_paint
from brdf_suite.fitting import LobeFitter
from brdf_suite.fitting.lobes.samples import CoatSamples
from brdf_suite.fitting.metrics import aspecular_delta_e
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.resources import resource, resource_names

ENDING = ".brdfpaint"


@pytest.mark.parametrize("name", resource_names("paints", ENDING))
def test_the_fit_shows_the_colours_and_the_gloss_that_were_asked_for(fitter: LobeFitter, name: str) -> None:
    paint = build_paint(load_paint(resource("paints", name + ENDING)))
    fit = fitter.fit(paint)
    # A satin coat shines as far as 15°, where a round lobe is not as wide as it (docs/method/fit.md).
    bound = 0.05 if paint.roughness < 0.03 else 3.5
    assert aspecular_delta_e(paint, fit.weights, (15.0, 45.0, 110.0)).max() <= bound
    assert aspecular_delta_e(paint, fit.weights, (25.0, 75.0)).max() <= 1.2
    # Over rings finer than the fit's own.
    rings = CoatSamples(first_ring_rad=2e-4, log_step=0.08, azimuths=24)
    values = (paint.coat.eval(rings.lights, rings.view) * rings.cosines[..., None]).mean(axis=1)
    np.testing.assert_allclose(fit.weights.coat_energy(), rings.solid_angle @ values, rtol=5e-3)


@pytest.mark.parametrize("name", ["blue", "copper", "fine_silver", "violet_shift"])
def test_readings_at_six_angles_are_met_where_the_base_is_lobes(fitter: LobeFitter, name: str) -> None:
    """At -15° the coat lets less out than lobes that are even in γ can know; at 25° the bell is a little wider."""
    paint = load_paint(resource("paints", name + ENDING))
    angles = np.array([-15.0, 15.0, 25.0, 45.0, 75.0, 110.0])
    seen = build_paint(paint).eval(illumination(45.0), aspecular_view(45.0, angles))
    labs = working_to_lab(np.pi * seen)
    readings = tuple(Measurement(45.0, g, (*map(float, lab),)) for g, lab in zip(angles, labs, strict=True))
    six = build_paint(replace(paint, measurements=readings))
    errors = aspecular_delta_e(six, fitter.fit(six).weights, tuple(angles))
    assert (errors <= [1.25, 0.02, 1.15, 0.02, 0.45, 0.02]).all()
