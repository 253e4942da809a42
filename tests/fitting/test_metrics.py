from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from brdf_suite.fitting import LobeFitter, LobeWeights
from brdf_suite.fitting.lobes.samples import CoatSamples
from brdf_suite.fitting.metrics import (
    aspecular_delta_e,
    aspecular_lab,
    error_figures,
)


def diffuse(rho: float) -> LobeWeights:
    exponents = np.array([2.0])
    return LobeWeights(exponents, np.full(3, rho / np.pi), np.zeros((1, 3)), np.zeros((1, 3)), np.pi / 4, 1.5)


def test_a_perfect_diffuser_reads_white_at_every_angle() -> None:
    lab = aspecular_lab(diffuse(1.0), (-15.0, 15.0, 110.0))
    np.testing.assert_allclose(lab, np.tile([100.0, 0.0, 0.0], (3, 1)), atol=1e-6)


def test_difference_is_zero_for_itself_and_grows() -> None:
    assert aspecular_delta_e(diffuse(0.5), diffuse(0.5), (45.0,))[0] == pytest.approx(0.0, abs=1e-9)
    near, far = (aspecular_delta_e(diffuse(0.5), diffuse(r), (45.0,))[0] for r in (0.49, 0.4))
    assert 0.0 < near < far


def test_error_figures_of_two_diffusers_by_hand() -> None:
    wi = np.tile([-0.6, 0.0, 0.8], (4, 1))
    wo = np.tile([0.0, 0.0, 1.0], (4, 1))
    figures = error_figures(diffuse(np.pi), diffuse(8 * np.pi), wi, wo, np.array([1.0, 2.0, 3.0, 4.0]))
    assert figures.cosine_rms == pytest.approx(0.8 * 7.0)
    assert figures.cube_root_rms == pytest.approx(0.8 * 1.0)
    assert figures.log_rms == pytest.approx(np.log(1 + 6.4) - np.log(1 + 0.8))


def directional_reflectance(coat: Any) -> np.ndarray:
    """What a coat reflects of a constant environment, seen at 45°, over rings finer than the fit's own."""
    rings = CoatSamples(first_ring_rad=2e-4, log_step=0.08, azimuths=24)
    values = coat.eval(rings.lights, rings.view) * rings.cosines[..., None]
    return rings.solid_angle @ values.mean(axis=1)


def test_directional_reflectance_of_a_coat(make_paint: Callable[..., Any], fitter: LobeFitter) -> None:
    paint = make_paint(roughness=0.01, reflected=0.07)
    assert directional_reflectance(paint.coat)[1] == pytest.approx(0.07, rel=2e-3)
    gloss = fitter.fit(paint).weights
    coat = LobeWeights(gloss.exponents, 0 * gloss.kd, 0 * gloss.kdd, gloss.kg, gloss.theta_fit_rad, gloss.ior)
    # Seen from the other side, by integrating the lobes themselves over the environment.
    assert directional_reflectance(coat)[1] == pytest.approx(0.07, rel=5e-3)
