from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.fitting import default_basis
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples
from brdf_suite.geometry.directions import aspecular_angle


def test_base_views_stand_at_their_aspecular_angles() -> None:
    samples = BaseSamples()
    np.testing.assert_allclose(aspecular_angle(samples.light, samples.views), samples.gamma_rad, atol=1e-9)
    assert {15.0, 25.0, 45.0, 75.0, 110.0} <= set(samples.gammas_deg)


def test_rings_stand_at_their_angles_around_the_mirror_direction() -> None:
    samples = CoatSamples()
    gamma = np.abs(aspecular_angle(samples.lights, samples.view))
    np.testing.assert_allclose(gamma, np.broadcast_to(samples.gamma_rad[:, None], gamma.shape), atol=1e-9)
    assert samples.gamma_rad[0] == 0.0


@pytest.mark.parametrize("exponent", [e for e in default_basis().exponents if e >= 8.0])
def test_rings_integrate_a_lobe(exponent: float) -> None:
    samples = CoatSamples(theta_rad=0.0)  # nothing below the horizon
    lobe = samples.cosine_lobes(np.array([exponent]))[:, 0]
    assert samples.solid_angle @ lobe == pytest.approx(2 * np.pi / (exponent + 1), rel=5e-3)


def test_a_broad_lobe_loses_what_lies_below_the_horizon() -> None:
    samples = CoatSamples(log_step=0.02, azimuths=360)
    energy = samples.lobe_energy(np.array([1.0]))[0]
    # The cosine about R, cut by a horizon tilted by β: the form factor π·(1 + cos β)/2.
    closed = np.pi * (1.0 + np.cos(np.pi / 4)) / 2.0
    assert energy == pytest.approx(closed, rel=3e-3)
