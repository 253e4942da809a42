"""The clearcoat's lobe against numbers worked out by hand and by integration."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.geometry.fresnel import fresnel_at
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe

directions = st.builds(spherical, st.floats(0.0, 1.56), st.floats(-3.1, 3.1))


def around_mirror(wi: np.ndarray, half_in: float, half_across: float, n: int = 120) -> tuple:
    """Gauss-Legendre directions over an angular window about the mirror direction, with dω."""
    nodes, shares = np.polynomial.legendre.leggauss(n)
    theta = math.atan2(-wi[0], wi[2])
    u, v = np.meshgrid(half_in * nodes, half_across * nodes, indexing="ij")
    wo = np.stack((np.cos(v) * np.sin(theta + u), np.sin(v), np.cos(v) * np.cos(theta + u)), axis=-1)
    return wo, np.outer(shares, shares) * half_in * half_across * np.cos(v)


@pytest.mark.parametrize(("roughness", "theta"), [(0.002, 0.0), (0.002, 45.0), (0.01, 20.0), (0.05, 60.0)])
def test_the_peak(roughness: float, theta: float) -> None:
    """In the mirror direction h is the normal: D = 1/(πα²), no shadowing, so f_r = F / (4πα² cos²θ)."""
    wi = illumination(theta)
    found = CoatLobe(1.53, roughness).eval(wi, mirror(wi))
    expected = fresnel_at(theta, 1.53) / (4.0 * math.pi * roughness**2 * math.cos(math.radians(theta)) ** 2)
    np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_facets_shade_each_other_as_smith_says() -> None:
    """Λ = (erf a - 1)/2 + exp(-a²)/(2a√π), a = 1/(α tanθ), worked out here with the exact error function."""
    alpha, theta = 0.5, math.radians(70.0)
    a = 1.0 / (alpha * math.tan(theta))
    shade = 0.5 * (math.erf(a) - 1.0) + math.exp(-a * a) / (2.0 * a * math.sqrt(math.pi))
    wi = illumination(70.0)
    found = CoatLobe(1.5, alpha, "single").eval_grey(wi, mirror(wi))
    plain = fresnel_at(70.0, 1.5) / (4.0 * math.pi * alpha**2 * math.cos(theta) ** 2)
    assert float(found) == pytest.approx(plain / (1.0 + 2.0 * shade), rel=0.004)
    assert float(found) < 0.9 * plain


@pytest.mark.parametrize("roughness", [0.002, 0.01, 0.03])
@pytest.mark.parametrize("theta", [0.0, 20.0, 45.0, 60.0])
def test_a_narrow_lobe_reflects_fresnels_share(roughness: float, theta: float) -> None:
    wi = illumination(theta)
    wo, solid = around_mirror(wi, min(12.0 * roughness, math.radians(89.9 - theta)), 12.0 * roughness)
    energy = np.sum(CoatLobe(1.5, roughness).eval_grey(wi, wo) * wo[..., 2] * solid)
    # A wide lobe at 60° reaches where F is steep, so its mean differs from F of the mirror direction.
    assert energy == pytest.approx(fresnel_at(theta, 1.5), rel=0.003 + 12.0 * roughness**2)


@pytest.mark.parametrize(("angle", "half_in", "half_across"), [(20, 0.9, 1.8), (60, 2.2, 5.85)])
def test_a_receptor_catches_what_the_gloss_formula_says(
    angle: int, half_in: float, half_across: float
) -> None:
    """For a point source A = erf(a/(2α)) erf(b/(2α cosθ)): the lobe and the gloss formula are one surface."""
    alpha = 0.015
    a, b = math.radians(half_in), math.radians(half_across)
    wi = illumination(angle)
    wo, solid = around_mirror(wi, a, b, 60)
    caught = np.sum(CoatLobe(1.53, alpha).eval_grey(wi, wo) * wo[..., 2] * solid) / fresnel_at(angle, 1.53)
    across = math.erf(b / (2.0 * alpha * math.cos(math.radians(angle))))
    assert caught == pytest.approx(math.erf(a / (2.0 * alpha)) * across, abs=0.004)


@given(directions, directions, st.floats(1.3, 1.7), st.floats(0.002, 0.5))
def test_it_is_reciprocal_grey_and_never_negative(wi, wo, ior: float, roughness: float) -> None:
    lobe = CoatLobe(ior, roughness)
    there, back = lobe.eval(wi, wo), lobe.eval(wo, wi)
    assert np.isfinite(there).all()
    assert there.min() >= 0.0
    assert there.min() == there.max()
    np.testing.assert_allclose(there, back, rtol=1e-9)


@pytest.mark.parametrize("theta", [0.0, 45.0, 75.0, 85.0])
def test_a_rough_coat_never_gives_more_than_it_gets(theta: float) -> None:
    nodes, shares = np.polynomial.legendre.leggauss(200)
    polar, azimuth = np.meshgrid((nodes + 1) * math.pi / 4, (nodes + 1) * math.pi, indexing="ij")
    weight = np.outer(shares, shares) * math.pi**2 / 4 * np.sin(polar) * np.cos(polar)
    value = CoatLobe(1.5, 0.3).eval_grey(illumination(theta), spherical(polar, azimuth))
    albedo = float(np.sum(value * weight))
    assert 0.02 < albedo < 1.0
    if theta == 0.0:
        assert albedo == pytest.approx(0.04, abs=0.002)


def test_below_the_horizon_there_is_nothing() -> None:
    lobe = CoatLobe(1.5, 0.1)
    up, down = np.array([0.0, 0.6, 0.8]), np.array([0.0, -0.6, -0.8])
    for wi, wo in ((up, down), (down, up), (down, down), (up, -up), ([1.0, 0, 0], up), (up, [1.0, 0, 0])):
        np.testing.assert_array_equal(lobe.eval(wi, wo), 0.0)


def test_directions_broadcast() -> None:
    lobe = CoatLobe(1.5, 0.1)
    wi, wo = spherical(np.linspace(0, 1, 4), 0.0)[:, None], spherical(np.linspace(0, 1, 5), 1.0)
    assert lobe.eval(wi, wo).shape == (4, 5, 3)
    np.testing.assert_allclose(lobe.eval(wi, wo)[2, 3], lobe.eval(wi[2, 0], wo[3]), rtol=1e-12)
    assert lobe.eval(np.zeros((0, 3)), wo[0]).shape == (0, 3)
