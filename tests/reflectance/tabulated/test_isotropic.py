"""The isotropic table: exact where it must be, near where it samples, quiet about odd input."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

Pair = tuple[np.ndarray, np.ndarray]

GRID = HalfAngleGrid(10, 12, 24)


def at_places(h: np.ndarray, d: np.ndarray, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Directions at places in index space, azimuth of the half vector 0.4."""
    theta_h, theta_d, phi_d = GRID.angles(h, d, p)
    return from_half_angle_coordinates(theta_h, 0.4, theta_d, phi_d)


def ramps() -> IsotropicTable:
    """Channels that are the bins' own coordinates."""
    h, d, p = np.meshgrid(*(np.arange(n) for n in GRID.shape), indexing="ij")
    return IsotropicTable(np.stack((h, d, np.abs(p - 12)), axis=-1).astype(np.float32))


def test_between_centres_a_linear_table_is_met_exactly() -> None:
    rng = np.random.default_rng(1)
    h, d, p = rng.uniform(0.5, 7.0, 500), rng.uniform(0.5, 5.5, 500), rng.uniform(0.5, 12.5, 500)
    wi, wo = at_places(h, d, p)
    above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
    assert above.sum() > 400
    value = ramps().eval(wi, wo)[above]
    assert np.allclose(value, np.stack((h - 0.5, d - 0.5, 12.0 - (p - 0.5)), axis=-1)[above], atol=1e-5)


def test_outside_the_first_centre_the_value_is_held() -> None:
    inner = ramps().eval(*at_places(np.array([0.0, 0.2, 0.5]), np.full(3, 0.3), np.full(3, 6.5)))
    assert np.allclose(inner[:, 0], 0.0)
    assert np.allclose(inner[:, 1], 0.0)


def test_phi_goes_round_through_reciprocity() -> None:
    values = np.zeros((*GRID.shape, 3), np.float32)
    values[:, :, 0], values[:, :, 23] = 1.0, 3.0
    table = IsotropicTable(values)
    places = np.array([23.5, 23.75, 23.999, 24.001, 24.25, 24.5, 0.0, 0.25, 0.5])
    value = table.eval(*at_places(np.full(9, 3.0), np.full(9, 3.0), places))[:, 0]
    assert value == pytest.approx([3.0, 2.5, 2.002, 1.998, 1.5, 1.0, 2.0, 1.5, 1.0], abs=1e-4)


def test_a_table_over_the_whole_turn_distinguishes_a_pair_from_its_swap() -> None:
    values = np.zeros((*GRID.shape, 3), np.float32)
    values[:, :, :12] = 1.0
    values[:, :, 12:] = 3.0
    table = IsotropicTable(values, reciprocal=False)
    wi, wo = from_half_angle_coordinates(0.3, 0.1, 0.4, 1.0)
    assert table.eval(wi, wo)[0] == pytest.approx(1.0)
    assert table.eval(wo, wi)[0] == pytest.approx(3.0)
    even = table.made_reciprocal()
    assert even.reciprocal
    assert even.values.shape == (10, 12, 12, 3)
    assert even.eval(wi, wo)[0] == pytest.approx(2.0)
    assert even.eval(wo, wi)[0] == pytest.approx(2.0)
    assert even.made_reciprocal() is even


def test_where_only_one_of_a_pair_was_measured_that_one_counts() -> None:
    values = np.full((*GRID.shape, 3), 1.0, np.float32)
    values[:, :, 12:] = 3.0
    holes = np.zeros(GRID.shape, bool)
    holes[3, 3, 5] = holes[4, 4, 17] = True
    holes[5, 5, 6] = holes[5, 5, 18] = True
    even = IsotropicTable(values, holes, reciprocal=False).made_reciprocal()
    assert even.values[3, 3, 5, 0] == 3.0
    assert even.values[4, 4, 5, 0] == 1.0
    assert even.values[5, 5, 6, 0] == pytest.approx(2.0, abs=0.01)
    assert np.argwhere(even.holes).tolist() == [[5, 5, 6]]


def test_a_tabulated_model_is_met_off_the_grid(smooth: Reflectance, directions: Pair) -> None:
    table = IsotropicTable.from_reflectance(smooth)
    wi, wo = directions
    assert np.allclose(table.eval(wi, wo), smooth.eval(wi, wo), rtol=1.5e-3)
    assert table.holes_above_horizon() == 0
    assert not np.any(np.asarray(table.holes) & table.grid.above_horizon())


def test_reciprocity_is_averaged_on_request(
    lopsided: Reflectance, smooth: Reflectance, directions: Pair
) -> None:
    wi, wo = directions
    mean = IsotropicTable.from_reflectance(lopsided)
    assert np.allclose(mean.eval(wi, wo), smooth.eval(wi, wo), rtol=1.5e-3)
    assert np.array_equal(mean.eval(wi, wo), mean.eval(wo, wi))
    first = IsotropicTable.from_reflectance(lopsided, reciprocity="assume")
    centre = from_half_angle_coordinates(0.3, 0.0, 0.3, 0.5)
    assert np.allclose(first.eval(*centre), lopsided.eval(*centre), rtol=1e-3)
    whole = IsotropicTable.from_reflectance(lopsided, HalfAngleGrid(90, 90, 360, reciprocal=False))
    assert np.allclose(whole.eval(wi, wo), lopsided.eval(wi, wo), rtol=1.5e-3)


def test_near_the_horizon_the_empty_bins_below_do_not_darken() -> None:
    class Constant:
        def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
            above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
            return np.where(above[..., None], 0.25, np.zeros(3))

    table = IsotropicTable.from_reflectance(Constant())
    theta = np.radians(np.linspace(0.0, 89.999, 200))
    wi = spherical(theta[:, None, None], 0.0)
    wo = spherical(theta[None, :, None], np.linspace(0.0, np.pi, 13))
    assert np.allclose(table.eval(wi, wo), 0.25, rtol=1e-6)


def test_below_the_horizon_and_for_what_is_no_direction_it_is_zero() -> None:
    up, down = spherical(0.3, 0.0), spherical(2.0, 0.0)
    flat = spherical(np.pi / 2, 0.0) * np.array([1.0, 1.0, 0.0])
    table = ramps()
    for wi, wo in ((up, down), (down, up), (down, down), (up, flat), (up, -up)):
        assert np.array_equal(table.eval(wi, wo), np.zeros(3))
    for odd in (np.nan, np.inf):
        assert np.array_equal(table.eval(np.array([odd, 0.0, 1.0]), up), np.zeros(3))


def test_shapes_broadcast_and_may_be_empty() -> None:
    table = ramps()
    wi = spherical(np.linspace(0.1, 1.0, 5)[:, None], np.zeros((1, 4)))
    wo = spherical(0.5, 1.0)
    value = table.eval(wi, wo)
    assert value.shape == (5, 4, 3)
    assert value.dtype == np.float64
    assert np.array_equal(value[2, 1], table.eval(wi[2, 1], wo))
    assert table.eval(np.empty((0, 3)), wo).shape == (0, 3)


def test_many_pairs_give_what_few_give(smooth: Reflectance, directions: Pair) -> None:
    table = IsotropicTable.from_reflectance(smooth, GRID)
    wi, wo = (np.tile(w, (40, 1)) for w in directions)
    value = table.eval(wi, wo)
    assert np.array_equal(value[:4000], value[-4000:])
    assert np.array_equal(value[7], table.eval(wi[7], wo[7]))


def test_arrays_cannot_be_changed_through_the_table() -> None:
    own = np.ones((*GRID.shape, 3), np.float32)
    table = IsotropicTable(own)
    with pytest.raises(ValueError, match="read-only"):
        table.values[0] = 1.0
    own[0] = 2.0


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"values": np.ones((4, 4, 4))}, "values"),
        ({"values": np.full((4, 4, 4, 3), -1.0)}, "values"),
        ({"values": np.full((4, 4, 4, 3), np.nan)}, "values"),
        ({"values": np.full((4, 4, 4, 3), np.inf)}, "values"),
        ({"values": np.ones((4, 1, 4, 3))}, "grid"),
        ({"values": np.ones((4, 4, 4, 3)), "holes": np.zeros((4, 4, 5), bool)}, "holes"),
    ],
)
def test_what_is_no_table_is_refused_by_name(change: dict[str, np.ndarray], place: str) -> None:
    with pytest.raises(ValueRangeError, match=place):
        IsotropicTable(**change)


def test_an_odd_whole_turn_cannot_be_averaged() -> None:
    table = IsotropicTable(np.ones((4, 4, 5, 3), np.float32), reciprocal=False)
    with pytest.raises(ValueRangeError, match="even"):
        table.made_reciprocal()
