"""The cylinders against a traced profile, and against the limits that can be worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier

NORMAL = np.array([0.0, 0.0, 1.0])


def reached(y: np.ndarray, z: np.ndarray, w: np.ndarray, spacing: float, floor: float) -> np.ndarray:
    """Whether rays from profile points (n,) towards ``w`` pass every cylinder: intersections by the quadratic."""
    uy, uz = w[1] / math.hypot(w[1], w[2]), w[2] / math.hypot(w[1], w[2])
    free = np.ones(len(y), dtype=bool)
    for k in range(-8, 9):
        dy = y - k * spacing
        # |p + t u|² = 1.
        b, c = dy * uy + z * uz, dy * dy + z * z - 1.0
        root = np.sqrt(np.maximum(b * b - c, 0.0))
        for t in (-b - root, -b + root):
            hit = (b * b > c) & (t > 1e-7) & (z + t * uz >= floor)
            free &= ~hit
    return free


def traced(model: PoulinFournier, wi: np.ndarray, wo: np.ndarray, count: int = 4_000) -> np.ndarray:
    """f_r by tracing the points of one period, each a facet of f = kd/π + ks c (N·h)ⁿ."""
    d, h, n = model.spacing, model.floor, model.exponent
    end = math.acos(h)
    phi = ((np.arange(count) + 0.5) / count * 2.0 - 1.0) * end
    flat = (np.arange(count) + 0.5) / count * (d - 2.0 * math.sin(end)) + math.sin(end)
    y, z = np.concatenate((np.sin(phi), flat)), np.concatenate((np.cos(phi), np.full(count, h)))
    normal = np.zeros((2 * count, 3))
    normal[:count, 1], normal[:count, 2], normal[count:, 2] = np.sin(phi), np.cos(phi), 1.0
    length = np.concatenate(
        (np.full(count, 2.0 * end / count), np.full(count, (d - 2.0 * math.sin(end)) / count))
    )
    lit = reached(y, z, wi, d, h) & reached(y, z, wo, d, h)
    half = (wi + wo) / np.linalg.norm(wi + wo)
    # The facet's gloss, normalised so that it sends back ks along its own normal.
    norm = (n + 2.0) * (n + 4.0) / (8.0 * math.pi * (2.0 ** (-n / 2.0) + n))
    gloss = norm * np.maximum(normal @ half, 0.0) ** n
    seen = np.maximum(normal @ wi, 0.0) * np.maximum(normal @ wo, 0.0) * length * lit
    facet = np.asarray(model.kd) / math.pi + gloss[:, None] * np.asarray(model.ks)
    return (seen[:, None] * facet).sum(axis=0) / (d * wi[2] * wo[2])


@pytest.mark.parametrize(
    ("spacing", "floor", "exponent"),
    [(2.5, 0.6, 50.0), (2.0, 0.0, 10.0), (1.0, 0.87, 200.0), (6.0, 0.2, 0.0), (1.21, 0.8, 1.0)],
)
def test_the_closed_form_is_what_tracing_finds(spacing: float, floor: float, exponent: float) -> None:
    model = PoulinFournier((0.3, 0.1, 0.2), (0.2, 0.5, 0.1), exponent, spacing, floor)
    random = np.random.default_rng(11)
    wi = spherical(random.uniform(0.0, 1.5, 40), random.uniform(-3.1, 3.1, 40))
    wo = spherical(random.uniform(0.0, 1.5, 40), random.uniform(-3.1, 3.1, 40))
    # Half of the pairs near the mirror direction, where the gloss is.
    wo[:20] = mirror(wi[:20]) + 0.1 * random.normal(size=(20, 3))
    wo[:20, 2] = np.abs(wo[:20, 2])
    wo /= np.linalg.norm(wo, axis=-1, keepdims=True)
    expected = np.array([traced(model, i, o) for i, o in zip(wi, wo, strict=True)])
    np.testing.assert_allclose(model.eval(wi, wo), expected, rtol=2e-3, atol=2e-4 * expected.max())


def test_far_apart_or_sunk_the_cylinders_are_gone() -> None:
    """A flat floor: kd/π + ks (n+2)(n+4)/(8π(2^(-n/2)+n)) (h·z)ⁿ; for n = 2 the factor is 24/(8π · 2.5)."""
    wi, wo = illumination(50.0), spherical(0.4, 1.0)
    half = (wi + wo) / np.linalg.norm(wi + wo)
    expected = 0.2 / math.pi + 0.5 * 24.0 / (20.0 * math.pi) * half[2] ** 2
    sunk = PoulinFournier(0.2, 0.5, 2.0, 10.0, 0.9999)
    far = PoulinFournier(0.2, 0.5, 2.0, 1000.0, 0.5)
    np.testing.assert_allclose(sunk.eval(wi, wo), expected, rtol=0.01)
    np.testing.assert_allclose(far.eval(wi, wo), expected, rtol=0.01)


def test_touching_half_cylinders_from_above_by_hand() -> None:
    """Light and view along the normal, spacing 2, floor 0, matt: ∫ cos² φ dφ from -90 to 90° over 2 is π/4."""
    found = PoulinFournier(1.0, 0.0, 10.0, 2.0, 0.0).eval(NORMAL, NORMAL)
    np.testing.assert_allclose(found, 0.25, rtol=1e-12)


def test_the_highlight_stretches_across_the_cylinders() -> None:
    model = PoulinFournier(0.0, 1.0, 200.0, 2.5, 0.6)
    along, across = spherical(0.6, 0.0), spherical(0.6, math.pi / 2)
    assert model.eval(NORMAL, across)[0] > 100.0 * model.eval(NORMAL, along)[0]


def test_cylinders_that_would_meet_are_refused() -> None:
    with pytest.raises(ValueRangeError, match=r"spacing: cylinders over a floor at 0.6 need at least 1.6"):
        PoulinFournier(spacing=1.5, floor=0.6)
