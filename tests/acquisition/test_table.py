"""From readings to a table: sums, means brought to the bins' centres, holes, coverage."""

from __future__ import annotations

import re

import numpy as np
import pytest

from brdf_suite.acquisition.reconstruction.table import unresolved_peak
from brdf_suite.acquisition.table.sums import (
    FIELDS,
    LAYOUTS,
    Layout,
    Parameterization,
    TableSums,
    position_sums,
    reading_weights,
)
from brdf_suite.acquisition.table.table_from_sums import (
    bin_means,
    fill_table_holes,
    half_angle_table,
    tabulate_means,
)
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

PAINT = CookTorrance(TABLE_1["table1_polaris_silver"])
SMALL = (30, 15, 24)


def pairs(n: int, seed: int = 0, within_deg: float = 80.0) -> tuple[np.ndarray, np.ndarray]:
    """Directions to light and view, half of them near each other's mirror direction."""
    rng = np.random.default_rng(seed)
    wi, wo = (
        spherical(np.radians(within_deg) * np.sqrt(rng.random(n)), rng.uniform(0, 2 * np.pi, n))
        for _ in range(2)
    )
    near = wi * [-1.0, -1.0, 1.0] + rng.normal(0.0, 0.03, (n, 3))
    near /= np.linalg.norm(near, axis=1)[:, None]
    wo = np.where((np.arange(n) % 2 == 0)[:, None] & (near[:, 2:] > 0.1), near, wo)
    return wi, wo


def sums_of(
    layout: Layout, n: int, parts: int = 1, shape: tuple[int, int, int] = SMALL
) -> tuple[TableSums, np.ndarray]:
    sums = TableSums(Parameterization(layout, shape))
    total = 0.0
    for part in range(parts):
        wi, wo = pairs(n, part)
        value = PAINT.eval(wi, wo).astype(np.float32)
        weights = reading_weights(wi.astype(np.float32), wo.astype(np.float32), value, None)
        total += weights.sum()
        sums.add(position_sums(sums.parameterization, sums.parameterization.index_of(wi, wo), value, weights))
    return sums, np.array(total)


def centres(bins: Parameterization, first: int) -> tuple[np.ndarray, np.ndarray]:
    """Return ``wi`` and ``wo`` (b, c, 3) at the centres of the bins with index ``first`` along the first axis."""
    a, b, c = bins.shape
    second, third = (np.arange(b) + 0.5) / b * 0.5 * np.pi, (np.arange(c) + 0.5) / c * np.pi
    share = (first + 0.5) / a
    if bins.layout == "traditional":
        wi = spherical(0.5 * np.pi * share, np.zeros((b, c)))
        return wi, spherical(second[:, None], third[None, :])
    theta_h = 0.5 * np.pi * (share if bins.layout == "linear" else share * share)
    return from_half_angle_coordinates(theta_h, 0.0, second[:, None], third[None, :])


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_place_lies_in_the_bin_whose_centre_is_half_a_bin_away(layout: Layout) -> None:
    bins = Parameterization(layout, (12, 10, 16))
    for first in (0, 5, 11):
        wi, wo = centres(bins, first)
        above = (wi[..., 2] > 0.01) & (wo[..., 2] > 0.01)
        places = bins.index_of(wi[above], wo[above])
        second, third = np.nonzero(above)
        wanted = np.stack((np.full(len(second), first), second, third)) + 0.5
        assert np.abs(places - wanted).max() < 1e-6
    # Directions that are equal, mirrored or at the horizon fall into bins too.
    z, flat = np.array([[0.0, 0.0, 1.0]]), np.array([[1.0, 0.0, 1e-9]])
    for one, other in ((z, z), (flat, flat * [-1, -1, 1]), (flat, flat), (z, flat)):
        places = bins.index_of(one, other)
        assert np.all(places >= 0.0)
        assert np.all(places < np.array(bins.shape)[:, None])


@pytest.mark.parametrize("layout", ["half-angle", "linear"])
def test_a_pair_and_its_swap_are_one(layout: Layout) -> None:
    bins = Parameterization(layout)
    wi, wo = pairs(500)
    assert np.array_equal(bins.index_of(wi, wo), bins.index_of(wo, wi))


def test_traditional_bins_know_no_handedness() -> None:
    bins = Parameterization("traditional")
    wi, wo = pairs(500)
    other = np.array([1.0, -1.0, 1.0])
    assert np.abs(bins.index_of(wi, wo) - bins.index_of(wi * other, wo * other)).max() < 1e-9


def test_weights_add_up_and_bad_readings_are_left_out() -> None:
    sums, total = sums_of("half-angle", 4_000, 2)
    assert sums.sums[:, FIELDS.index("w")].sum() == pytest.approx(float(total), rel=1e-5)
    assert sums.sums[:, FIELDS.index("n")].sum() == 8_000
    wi, wo = pairs(4)
    value = np.ones((4, 3), np.float32)
    value[1, 2] = np.nan
    bins = Parameterization("half-angle", SMALL)
    found = position_sums(bins, bins.index_of(wi, wo), value, np.array([1.0, 1.0, 0.0, np.inf]))
    assert found.sums[:, 0].sum() == 1.0
    nothing = position_sums(bins, np.empty((3, 0)), value[:0], np.empty(0))
    assert nothing.places.shape == (0,)


def test_noise_lowers_a_weight_alike_for_bright_and_dark() -> None:
    wi = np.tile(np.array([0.0, 0.0, 1.0], np.float32), (3, 1))
    value = np.array([[1.0] * 3, [10.0] * 3, [1.0] * 3], np.float32)
    variance = (np.array([0.1, 1.0, 0.0], np.float32)[:, None] ** 2) * np.ones(3, np.float32)
    weights = reading_weights(wi, wi, value, variance)
    assert weights[0] == pytest.approx(weights[1], rel=1e-5)
    assert weights[2] == pytest.approx(1.0 / 0.02**2)
    assert weights[0] < 0.2 * weights[2]
    assert reading_weights(wi, wi, np.zeros((3, 3), np.float32), variance).max() <= weights[2]


@pytest.fixture(scope="module")
def dense() -> TableSums:
    return sums_of("half-angle", 60_000, 4)[0]


def errors_at_centres(values: np.ndarray, measured: np.ndarray, bins: Parameterization) -> np.ndarray:
    found = []
    for first in range(bins.shape[0]):
        wi, wo = centres(bins, first)
        here = (np.minimum(wi[..., 2], wo[..., 2]) > np.cos(np.radians(70.0))) & measured[first]
        truth = PAINT.eval(wi[here], wo[here])
        found.append(np.abs(values[first][here] / truth - 1.0).ravel())
    return np.concatenate(found)


def test_centring_takes_the_bias_of_means_away(dense: TableSums) -> None:
    raw, centred = bin_means(dense, centre=False), bin_means(dense)
    before = errors_at_centres(raw.values, raw.measured, raw.parameterization)
    after = errors_at_centres(centred.values, centred.measured, centred.parameterization)
    # Bins of 3° along θh and 6° along θd, so that the mean differs much from the centre.
    assert np.median(before) > 0.02
    assert np.median(after) < 0.5 * np.median(before)


def test_the_table_is_measured_where_readings_fell_and_whole_elsewhere(dense: TableSums) -> None:
    means = bin_means(dense)
    table = half_angle_table(means, "a sphere")
    assert np.array_equal(~np.asarray(table.holes), means.measured)
    assert table.coverage is means.coverage
    assert np.array_equal(table.values[means.measured], means.values[means.measured])
    wi, wo = pairs(2_000, 99, 70.0)
    assert np.median(np.abs(table.eval(wi, wo) / PAINT.eval(wi, wo) - 1.0)) < 0.05
    assert table.eval(wi, wo).min() > 0.0


@pytest.mark.parametrize("layout", LAYOUTS)
def test_all_layouts_serve_for_comparison(layout: Layout) -> None:
    table = tabulate_means(bin_means(sums_of(layout, 60_000)[0]))
    wi, wo = pairs(2_000, 99, 60.0)
    wi, wo = wi[1::2], wo[1::2]  # off the highlight, where every layout must do
    assert np.median(np.abs(table.eval(wi, wo) / PAINT.eval(wi, wo) - 1.0)) < 0.08
    value, measured = table.nearest(wi, wo)
    assert measured.mean() > 0.5
    assert np.median(np.abs(value[measured] / PAINT.eval(wi, wo)[measured] - 1.0)) < 0.15


def test_the_narrow_highlight_needs_the_narrow_bins() -> None:
    errors = {}
    rng = np.random.default_rng(5)
    for layout in ("half-angle", "linear"):
        table = tabulate_means(bin_means(sums_of(layout, 60_000)[0]))
        wi = spherical(rng.uniform(0.2, 1.0, 500), rng.uniform(0, 6, 500))
        wo = wi * [-1.0, -1.0, 1.0] + rng.normal(0.0, 0.01, (500, 3))
        wo /= np.linalg.norm(wo, axis=1)[:, None]
        errors[layout] = np.median(np.abs(table.eval(wi, wo) / PAINT.eval(wi, wo) - 1.0))
    assert errors["half-angle"] < 0.5 * errors["linear"]


def test_a_deviation_holds_the_spread_and_the_noise() -> None:
    bins = Parameterization("half-angle", SMALL)
    rng = np.random.default_rng(3)
    wi, wo = np.repeat(spherical([0.4], 0.0), 400, 0), np.repeat(spherical([0.8], 2.0), 400, 0)
    value = np.repeat(rng.normal(1.0, 0.1, (400, 1)), 3, 1).astype(np.float32)
    sums = TableSums(bins)
    sums.add(position_sums(bins, bins.index_of(wi, wo), value, np.ones(400)))
    means = bin_means(sums)
    found = means.coverage.deviation[means.measured]
    assert found == pytest.approx([0.1 / 20.0], rel=0.15)
    # One reading has no spread: its own noise counts.
    single = TableSums(bins)
    noise = np.full((1, 3), 0.3**2, np.float32)
    single.add(position_sums(bins, bins.index_of(wi[:1], wo[:1]), value[:1] * 0 + 1, np.ones(1), noise))
    means = bin_means(single)
    assert means.coverage.deviation[means.measured] == pytest.approx([0.3 / np.sqrt(3.0)], rel=1e-5)


def test_colours_come_into_the_working_space(dense: TableSums) -> None:
    matrix = np.array([[0.8, 0.2, 0.0], [0.1, 0.9, 0.0], [0.0, -2.0, 3.0]])
    plain, turned = bin_means(dense), bin_means(dense, matrix)
    wanted = np.maximum(plain.values @ matrix.T, 0.0)
    assert np.allclose(turned.values, wanted, rtol=1e-4, atol=1e-6)
    with pytest.raises(ValueRangeError, match="3 × 3"):
        bin_means(dense, np.ones((2, 3)))


def test_nothing_measured_is_reported() -> None:
    with pytest.raises(ValueRangeError, match="nothing was measured"):
        half_angle_table(bin_means(TableSums(Parameterization("half-angle", SMALL))))


def test_a_hole_takes_its_mirrored_bin_first() -> None:
    bins = Parameterization("half-angle", (6, 6, 12))
    values = np.ones((6, 6, 12, 3), np.float32)
    weights = np.ones((6, 6, 12), np.float32)
    values[5, 2, 1], values[5, 2, 10] = 7.0, 3.0
    weights[5, 2, 1] = 0.0
    whole, known = fill_table_holes(values, weights, bins)
    assert np.array_equal(whole[5, 2, 1], [3.0, 3.0, 3.0])
    assert not known[5, 2, 1]
    assert known.sum() == weights.sum()


def test_few_readings_near_the_peak_serve_their_whole_ring() -> None:
    bins = Parameterization("half-angle", (90, 6, 180))
    values = np.zeros((90, 6, 180, 3), np.float32)
    weights = np.zeros((90, 6, 180), np.float32)
    values[1, 2, 40], weights[1, 2, 40] = 5.0, 1.0
    values[60, 2, 40], weights[60, 2, 40] = 1.0, 1.0
    values[60, 2, 50], weights[60, 2, 50] = 2.0, 1.0
    whole, _ = fill_table_holes(values, weights, bins)
    assert np.allclose(whole[1, 2], 5.0, rtol=1e-6)
    # Far from it each lies nearer to its own.
    assert whole[60, 2, 41, 0] < 1.2
    assert whole[60, 2, 49, 0] > 1.8


@pytest.mark.parametrize(
    ("paint", "pixel_deg", "narrow"),
    [
        ("table1_polaris_silver", 0.2, False),
        ("table1_polaris_silver", 0.8, True),
        ("table1_blue_matte", 0.8, False),
    ],
    ids=["small pixels", "large pixels", "matte"],
)
def test_a_peak_narrower_than_the_pixels_is_named(paint: str, pixel_deg: float, narrow: bool) -> None:
    table = IsotropicTable.from_reflectance(CookTorrance(TABLE_1[paint]), HalfAngleGrid(90, 30, 20))
    sentence = unresolved_peak(table, np.radians(pixel_deg))
    assert (sentence is not None) == narrow
    if sentence is not None:
        # Beckmann's facets of m = .013 fall to half at 0.62° on either side.
        width = re.search(r"it is ([\d.]+)° wide", sentence)
        assert width is not None
        assert float(width[1]) == pytest.approx(1.24, abs=0.1)
        assert "a pixel covers 0.8°" in sentence
        assert "times as large" in sentence
