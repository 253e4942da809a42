"""Fresnel's equations against values from elsewhere."""

from __future__ import annotations

import math

import numpy as np
import pytest

from brdf_suite.geometry.fresnel import fresnel_at, fresnel_dielectric


def test_known_values() -> None:
    assert float(fresnel_dielectric(1.0, 1.5)) == pytest.approx(0.04)
    assert float(fresnel_dielectric(0.0, 1.5)) == pytest.approx(1.0)
    # The polished black glass of ASTM D523: its reflected shares at 20, 60 and 85°.
    for angle, share in ((20, 0.04908), (60, 0.10006), (85, 0.61915)):
        assert fresnel_at(angle, 1.567) == pytest.approx(share, abs=5e-6)


def test_at_brewsters_angle_only_one_polarisation_is_reflected() -> None:
    """tan θB = n; there r_p = 0 and r_s = (1 - n²)/(1 + n²)."""
    n = 1.5
    expected = 0.5 * ((1.0 - n * n) / (1.0 + n * n)) ** 2
    assert float(fresnel_dielectric(math.cos(math.atan(n)), n)) == pytest.approx(expected, rel=1e-12)


def test_no_interface_reflects_nothing() -> None:
    np.testing.assert_allclose(fresnel_dielectric([0.0, 0.3, 1.0], 1.0), 0.0, atol=1e-15)


def test_it_rises_towards_grazing_and_stays_a_share() -> None:
    cosines = np.linspace(0.0, 1.0, 500)
    for n in (1.3, 1.5, 1.7):
        share = fresnel_dielectric(cosines, n)
        assert share.min() >= 0.0
        assert share.max() <= 1.0
        # From air into glass F never falls on the way to grazing by more than rounding.
        assert np.all(np.diff(share) <= 1e-15)


def test_both_forms_agree_and_cosines_out_of_range_are_held() -> None:
    angles = np.linspace(0.0, 89.9, 50)
    one_by_one = [fresnel_at(angle, 1.53) for angle in angles]
    np.testing.assert_allclose(fresnel_dielectric(np.cos(np.radians(angles)), 1.53), one_by_one, rtol=1e-12)
    assert float(fresnel_dielectric(1.0 + 1e-12, 1.5)) == pytest.approx(0.04)
    assert float(fresnel_dielectric(-0.2, 1.5)) == 1.0
