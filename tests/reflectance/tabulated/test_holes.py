"""Holes get weighted sums of their neighbours, from their rim inwards."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid, fill_holes
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

GRID = HalfAngleGrid(8, 8, 16)
STEPS = (1.0, 0.5, 0.25)


def test_a_hole_gets_the_mean_along_phi_weighted_inversely_by_distance() -> None:
    values = np.random.default_rng(1).random((8, 8, 16, 3)).astype(np.float32)
    holes = np.zeros(GRID.shape, bool)
    holes[3, 2, [0, 15, 14]] = True  # φd goes round: between bins 13 and 1
    assert fill_holes(values, holes, GRID) == 3
    for steps, bin_p in ((1, 14), (2, 15), (3, 0)):
        want = ((4 - steps) * values[3, 2, 13] + steps * values[3, 2, 1]) / 4
        assert values[3, 2, bin_p] == pytest.approx(want, rel=1e-5)


def test_an_empty_line_gets_the_weighted_mean_of_the_26_neighbours() -> None:
    values = np.random.default_rng(1).random((8, 8, 16, 3)).astype(np.float32)
    holes = np.zeros(GRID.shape, bool)
    holes[3, 2] = True
    total, weight = np.zeros(3), 0.0
    for a in (-1, 0, 1):
        for b in (-1, 0, 1):
            for c in (-1, 0, 1):
                if (a, b) != (0, 0):
                    w = 1.0 / (a**2 + (0.5 * b) ** 2 + (0.25 * c) ** 2)
                    total += w * values[3 + a, 2 + b, (0 + c) % 16]
                    weight += w
    assert fill_holes(values, holes, GRID, STEPS) == 16
    assert values[3, 2, 0] == pytest.approx(total / weight, rel=1e-6)


def test_at_the_edge_only_neighbours_inside_count() -> None:
    values = np.zeros((8, 8, 16, 3), np.float32)
    values[0, :] = 1.0
    values[1, :] = 3.0
    holes = np.zeros(GRID.shape, bool)
    holes[0, 0] = True
    fill_holes(values, holes, GRID, (1.0, 1.0, 1.0))
    near = 1.0 + 2 * 0.5  # (0,1,0), (0,1,±1)
    far = 1.0 + 0.5 + 2 * 0.5 + 2 / 3  # (1,0,0), (1,1,0), (1,0,±1), (1,1,±1)
    assert values[0, 0, 5, 0] == pytest.approx((near + 3.0 * far) / (near + far), rel=1e-6)


def test_far_from_what_was_measured_along_phi_the_other_neighbours_count() -> None:
    grid = HalfAngleGrid(8, 8, 32)
    values = np.zeros((8, 8, 32, 3), np.float32)
    values[2, 2, 0] = 5.0
    values[2, 3] = 1.0
    holes = np.zeros(grid.shape, bool)
    holes[2, 2, 1:] = True
    fill_holes(values, holes, grid)
    assert values[2, 2, 5, 0] == 5.0
    assert values[2, 2, 16, 0] < 1.0


def test_a_constant_stays_constant_however_large_the_gap() -> None:
    grid = HalfAngleGrid(20, 20, 40)
    values = np.full((*grid.shape, 3), 0.25, np.float32)
    holes = np.ones(grid.shape, bool)
    holes[4, 4, 4] = False
    values[holes] = np.nan
    filled = fill_holes(values, holes, grid)
    assert filled == np.count_nonzero(holes & grid.reached())
    assert values[grid.reached()] == pytest.approx(0.25, rel=1e-6)
    assert np.all(values[holes & ~grid.reached()] == 0.0)


def test_what_was_measured_stays_and_the_fill_stays_within_it() -> None:
    rng = np.random.default_rng(2)
    values = rng.random((8, 8, 16, 3)).astype(np.float32)
    before = values.copy()
    holes = rng.random(GRID.shape) < 0.5
    fill_holes(values, holes, GRID)
    assert np.array_equal(values[~holes], before[~holes])
    filled = values[holes & GRID.reached()]
    assert filled.min() >= before[~holes].min() - 1e-6
    assert filled.max() <= before[~holes].max() + 1e-6


def test_the_fill_does_not_hang_on_the_order_of_the_bins() -> None:
    rng = np.random.default_rng(4)
    values = rng.random((8, 8, 16, 3)).astype(np.float32)
    holes = rng.random(GRID.shape) < 0.6
    turned, turned_holes = np.roll(values, 5, axis=2), np.roll(holes, 5, axis=2)
    # Only bins that are always above the horizon: the mask itself does not turn.
    flat = HalfAngleGrid(8, 8, 16)
    fill_holes(values, holes, flat)
    fill_holes(turned, turned_holes, flat)
    assert np.allclose(np.roll(values, 5, axis=2)[:3, :3], turned[:3, :3], rtol=1e-5)


def test_a_smooth_table_is_restored(smooth: Reflectance) -> None:
    grid = HalfAngleGrid(45, 45, 90)
    table = IsotropicTable.from_reflectance(smooth, grid)
    rng = np.random.default_rng(6)
    extra = rng.random(grid.shape) < 0.2
    extra[20:23, 20:23, 30:40] = True
    holes = np.asarray(table.holes) | extra
    values = table.values.copy()
    values[holes] = -1.0
    fill_holes(values, holes, grid)
    checked = extra & grid.above_horizon()
    error = np.abs(values[checked] / table.values[checked] - 1.0)
    assert np.median(error) < 0.005
    assert error.max() < 0.2


def test_nothing_known_fills_nothing() -> None:
    values = np.full((8, 8, 16, 3), 7.0, np.float32)
    assert fill_holes(values, np.ones(GRID.shape, bool), GRID) == 0
    assert not values.any()
