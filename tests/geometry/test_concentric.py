"""The concentric map: its inverse, its areas, and places known by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from brdf_suite.geometry.concentric import hemisphere_to_square, square_to_hemisphere

UNIT = st.floats(0.0, 1.0)


@settings(max_examples=2 * settings.default.max_examples)
@given(UNIT, UNIT)
@example(0.5, 0.5)
@example(0.5, 0.5 + 1e-16)
@example(0.0, 0.0)
@example(1.0, 1.0)
@example(0.5 + 1e-9, 0.5 - 1e-9)
def test_there_and_back(u: float, v: float) -> None:
    point = np.array([u, v])
    assert np.abs(hemisphere_to_square(square_to_hemisphere(point)) - point).max() <= 1e-12


@given(st.floats(0.0, math.pi / 2.0), st.floats(-math.pi, math.pi))
def test_back_and_there(theta: float, phi: float) -> None:
    w = np.array([math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)])
    assert np.abs(square_to_hemisphere(hemisphere_to_square(w)) - w).max() <= 1e-12


def test_directions_are_of_unit_length_and_above_the_horizon() -> None:
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, 41)] * 2), axis=-1)
    w = square_to_hemisphere(grid)
    assert np.abs(np.linalg.norm(w, axis=-1) - 1.0).max() < 1e-15
    assert w[..., 2].min() >= 0.0
    edge = np.concatenate((w[0], w[-1], w[:, 0], w[:, -1]))
    assert np.abs(edge[:, 2]).max() < 1e-15


@pytest.mark.parametrize(
    ("u", "w"),
    [
        ((0.5, 0.5), (0.0, 0.0, 1.0)),
        ((1.0, 0.5), (1.0, 0.0, 0.0)),
        ((0.0, 0.5), (-1.0, 0.0, 0.0)),
        ((0.5, 1.0), (0.0, 1.0, 0.0)),
        ((0.5, 0.0), (0.0, -1.0, 0.0)),
        ((1.0, 1.0), (math.sqrt(0.5), math.sqrt(0.5), 0.0)),
        ((0.0, 0.0), (-math.sqrt(0.5), -math.sqrt(0.5), 0.0)),
        # Half way to the edge: r = ½, cosθ = 1 - r² = ¾.
        ((0.75, 0.5), (math.sqrt(7.0) / 4.0, 0.0, 0.75)),
    ],
)
def test_known_places(u: tuple[float, float], w: tuple[float, float, float]) -> None:
    assert square_to_hemisphere(u) == pytest.approx(w, abs=1e-15)
    assert hemisphere_to_square(w) == pytest.approx(u, abs=1e-15)


def test_a_share_of_the_square_is_its_share_of_the_hemisphere() -> None:
    """The map's Jacobian by central differences: 2π everywhere, whatever the quarter."""
    u = np.random.default_rng(5).uniform(0.01, 0.99, (4000, 2))
    # No step may cross a diagonal.
    away = np.abs(np.abs(2.0 * u[:, 0] - 1.0) - np.abs(2.0 * u[:, 1] - 1.0)) > 1e-3
    u, step = u[away], 1e-5
    east, north = np.array([step, 0.0]), np.array([0.0, step])

    def slopes(mapped) -> tuple[np.ndarray, np.ndarray]:
        return (mapped(u + east) - mapped(u - east)) / (2.0 * step), (
            mapped(u + north) - mapped(u - north)
        ) / (2.0 * step)

    du, dv = slopes(square_to_hemisphere)
    solid = np.einsum("ij,ij->i", np.cross(du, dv), square_to_hemisphere(u))
    assert np.abs(solid - 2.0 * math.pi).max() < 1e-6


def test_the_middles_of_a_grid_integrate_the_hemisphere() -> None:
    count = 256
    middle = (np.arange(count) + 0.5) / count
    w = square_to_hemisphere(np.stack(np.meshgrid(middle, middle), axis=-1))
    assert 2.0 * math.pi * w[..., 2].mean() == pytest.approx(math.pi, rel=1e-4)
    assert 2.0 * math.pi * (w[..., 0] ** 2).mean() == pytest.approx(2.0 * math.pi / 3.0, rel=1e-3)
