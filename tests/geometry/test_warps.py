"""Sampling warps against their densities, and the densities against numbers worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import illumination, spherical

COUNT = 200_000
AXIS = spherical(0.4, 0.0)
VIEW = illumination(50.0)

WARPS = {
    "cosine_hemisphere": (warps.cosine_hemisphere, warps.cosine_hemisphere_pdf, 0.0),
    "cosine_lobe": (
        lambda u: warps.cosine_lobe(u, AXIS, 12.0),
        lambda w: warps.cosine_lobe_pdf(w, AXIS, 12.0),
        0.4,
    ),
    "sharp_cosine_lobe": (
        lambda u: warps.cosine_lobe(u, AXIS, 50_000.0),
        lambda w: warps.cosine_lobe_pdf(w, AXIS, 50_000.0),
        0.4,
    ),
    "beckmann_normal": (
        lambda u: warps.beckmann_normal(u, 0.3),
        lambda h: warps.beckmann_normal_pdf(h, 0.3),
        0.0,
    ),
    "narrow_beckmann_normal": (
        lambda u: warps.beckmann_normal(u, 0.002),
        lambda h: warps.beckmann_normal_pdf(h, 0.002),
        0.0,
    ),
    "ggx_visible_normal": (
        lambda u: warps.ggx_visible_normal(u, np.broadcast_to(VIEW, (len(u), 3)), 0.4),
        lambda h: warps.ggx_visible_normal_pdf(h, VIEW, 0.4),
        0.0,
    ),
    "mirrored_beckmann": (
        lambda u: warps.mirror_at(VIEW, warps.beckmann_normal(u, 0.2)),
        lambda w: _mirrored(w, 0.2),
        math.radians(50.0),
    ),
}


def _mirrored(w: np.ndarray, m: float) -> np.ndarray:
    h = warps.half_vector(w, VIEW)
    return warps.mirrored_pdf(warps.beckmann_normal_pdf(h, m), VIEW, h)


@pytest.mark.parametrize("name", WARPS)
def test_what_is_drawn_has_the_density(name: str, chi_square) -> None:
    draw, density, peak = WARPS[name]
    w = draw(np.random.default_rng(41).random((COUNT, 2)))
    np.testing.assert_allclose(np.linalg.norm(w, axis=-1), 1.0, atol=1e-12)
    # Seven tests, together 1 % to fail by chance, and the seed is fixed.
    assert chi_square(w, density, peak) > 0.01 / len(WARPS)


@pytest.mark.parametrize("wrong", [0.97, 1.03])
def test_the_test_notices_a_wrong_density(chi_square, wrong: float) -> None:
    w = warps.beckmann_normal(np.random.default_rng(41).random((COUNT, 2)), 0.3)
    assert chi_square(w, lambda h: warps.beckmann_normal_pdf(h, 0.3 * wrong)) < 1e-6


def test_densities_by_hand() -> None:
    """cos 60°/π; (n+1)/2π at the axis and half-way down; 1/(π m²) at the normal; 1/(π α²) seen along the normal."""
    assert float(warps.cosine_hemisphere_pdf(spherical(math.pi / 3, 1.0))) == pytest.approx(0.5 / math.pi)
    axis = spherical(1.0, 2.0)
    assert float(warps.cosine_lobe_pdf(axis, axis, 9.0)) == pytest.approx(10.0 / (2.0 * math.pi))
    sideways = warps.rotate_to_axis(axis, spherical(math.acos(0.5 ** (1.0 / 9.0)), 0.7))
    assert float(warps.cosine_lobe_pdf(sideways, axis, 9.0)) == pytest.approx(5.0 / (2.0 * math.pi))
    normal = np.array([0.0, 0.0, 1.0])
    assert float(warps.beckmann_normal_pdf(normal, 0.2)) == pytest.approx(1.0 / (math.pi * 0.04))
    assert float(warps.ggx_visible_normal_pdf(normal, normal, 0.2)) == pytest.approx(1.0 / (math.pi * 0.04))
    # tan²θ = m²: e^-1/(π m²) (1 + m²)^(3/2).
    at_m = spherical(math.atan(0.2), 0.0)
    assert float(warps.beckmann_normal_pdf(at_m, 0.2)) == pytest.approx(
        math.exp(-1.0) / (math.pi * 0.04) * 1.04**1.5
    )


def test_below_the_horizon_there_is_nothing() -> None:
    down = np.array([0.6, 0.0, -0.8])
    assert float(warps.cosine_hemisphere_pdf(down)) == 0.0
    assert float(warps.beckmann_normal_pdf(down, 0.5)) == 0.0
    assert float(warps.ggx_visible_normal_pdf(down, VIEW, 0.5)) == 0.0


def test_about_keeps_angles_for_every_axis() -> None:
    random = np.random.default_rng(2)
    axis = spherical(random.uniform(0.0, math.pi, 300), random.uniform(-3.0, 3.0, 300))
    local = spherical(random.uniform(0.0, 3.0, 300), random.uniform(-3.0, 3.0, 300))
    turned = warps.rotate_to_axis(axis, local)
    np.testing.assert_allclose(np.sum(turned * axis, axis=-1), local[:, 2], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(turned, axis=-1), 1.0, atol=1e-12)


def test_shapes_broadcast() -> None:
    u = np.zeros((4, 5, 2))
    assert warps.cosine_lobe(u, AXIS, 3.0).shape == (4, 5, 3)
    assert warps.cosine_lobe_pdf(AXIS, AXIS, np.ones((4, 5))).shape == (4, 5)
