from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from brdf_suite.fitting.lobes.angles import AngleGrid
from brdf_suite.fitting.lobes.angles.program import HORIZON_DEG, AngleBaseSamples, AngleCoatSamples
from brdf_suite.fitting.lobes.samples import BaseSamples
from brdf_suite.geometry.directions import aspecular_angle
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe

GRID = AngleGrid()


def test_base_samples_are_the_single_fits_at_45_degrees_and_above_the_horizon() -> None:
    samples, single = AngleBaseSamples(GRID), BaseSamples()
    measured = samples.angle == GRID.measured
    np.testing.assert_allclose(samples.views[measured], single.views, atol=1e-12)
    np.testing.assert_array_equal(samples.weights[measured], single.weights)
    assert (samples.views[~measured, 2] >= np.cos(np.radians(HORIZON_DEG)) - 1e-12).all()
    # Along the normal there are no two sides, and γ has no sign.
    tilted = samples.lights[:, 0] < 0.0
    gamma = aspecular_angle(samples.lights, samples.views)
    np.testing.assert_allclose(gamma[tilted], samples.gamma_rad[tilted], atol=1e-7)
    np.testing.assert_allclose(np.abs(gamma), np.abs(samples.gamma_rad), atol=1e-7)
    # Every incidence is sampled, also on the flank.
    for k in range(GRID.count):
        assert np.rad2deg(samples.gamma_rad[samples.angle == k]).max() >= 74.9


def _energy(alpha: float, cosine: float) -> NDArray[np.float64]:
    """What a Beckmann coat reflects of a constant environment, by its own facets' density."""
    sine = np.sqrt(1.0 - cosine * cosine)
    view = np.array([-sine, 0.0, cosine])
    u = (np.arange(300) + 0.5) / 300
    tilt, phi = np.meshgrid(alpha * np.sqrt(-np.log1p(-u)), (np.arange(120) + 0.5) * 2.0 * np.pi / 120)
    half = np.stack([tilt * np.cos(phi), tilt * np.sin(phi), np.ones_like(tilt)], -1)
    half /= np.linalg.norm(half, axis=-1, keepdims=True)
    towards = half @ view
    light = 2.0 * towards[..., None] * half - view
    facets = np.exp(-((tilt / alpha) ** 2)) * (1.0 + tilt**2) ** 2 / (np.pi * alpha**2)
    density = facets * half[..., 2] / (4.0 * np.maximum(towards, 1e-9))
    above = (light[..., 2] > 0.0) & (towards > 0.0)
    value = CoatLobe(1.5, alpha).eval_grey(light, view) * light[..., 2] / density
    return np.where(above, value, 0.0).mean()


@pytest.mark.parametrize("alpha", [0.002, 0.02, 0.1])
def test_rings_hold_the_energy_of_a_coat_up_to_grazing(alpha: float) -> None:
    samples = AngleCoatSamples(GRID)
    rings = (CoatLobe(1.5, alpha).eval_grey(samples.lights, samples.views) * samples.cosines).sum(axis=2)
    found = (rings * samples.solid_angle).sum(axis=1)
    expected = [_energy(alpha, cosine) for cosine in GRID.cosines]
    np.testing.assert_allclose(found, expected, rtol=0.02)


def test_rings_of_a_constant_are_the_constant_and_lie_at_their_angle() -> None:
    samples = AngleCoatSamples(GRID)
    mirror = samples.views * np.array([-1.0, -1.0, 1.0])
    cosine = (samples.lights * mirror).sum(axis=-1)
    np.testing.assert_allclose(cosine, np.cos(samples.gamma_rad)[..., None] * np.ones(8), atol=1e-9)
    # The whole cap of 90° about the normal is 2π.
    assert samples.solid_angle[-1].sum() == pytest.approx(2.0 * np.pi, rel=0.01)
    energy = samples.lobe_energy(np.array([80.0, 5000.0]))
    np.testing.assert_allclose(energy[-1], 2.0 * np.pi / np.array([81.0, 5001.0]), rtol=0.01)


def test_samples_halfway_come_in_reciprocal_pairs_about_each_angle() -> None:
    samples = AngleBaseSamples(GRID, halfway=True)
    half = np.sqrt(0.5 * (1.0 + (samples.lights * samples.views).sum(axis=1)))
    at = samples.share == 0.0
    np.testing.assert_allclose(half[at], GRID.cosines[samples.angle[at]], atol=1e-9)
    # Between the angles are the pairs of an instrument, with the light at 45°.
    np.testing.assert_allclose(samples.lights[~at, 2], np.sqrt(0.5))
    lower, share = GRID.shares(half[~at])
    np.testing.assert_array_equal(samples.angle[~at], lower)
    np.testing.assert_allclose(samples.share[~at], share, atol=1e-9)
    assert {15, 45, 110} <= set(np.rint(np.degrees(samples.gamma_rad[~at])))
    np.testing.assert_allclose(
        np.abs(aspecular_angle(samples.lights, samples.views)), samples.gamma_rad, atol=1e-7
    )
    assert set(samples.angle) == set(range(GRID.count))
