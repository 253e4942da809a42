"""Lobes for data that nothing divides: known answers, and what cannot be answered."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import Cancelled, FittingError
from brdf_suite.files.measured import read_measured
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.measured import (
    UndividedFit,
    fit_rows,
    fit_undivided,
    scattered_values,
)
from brdf_suite.fitting.lobes.measured_samples import reflectance_rows, scattered_rows
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import aspecular_view, illumination, spherical
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

EXPONENTS = default_basis().array()
REAL_FILES = (
    "bird_example.json",
    "cayman.brdf",
    "krylon_blue.brdf",
    "paper_white_rgb.bsdf",
    "retro-gray-tape.dat",
    "vch_golden_yellow_rgb.bsdf",
)


class Function:
    """A reflectance of any function of the directions."""

    def __init__(self, function: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> None:
        self.function = function

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        wi, wo = np.broadcast_arrays(wi, wo)
        return self.function(wi, wo)


def lobe_sum(seed: int, share: float = 0.5) -> LobeWeights:
    """Random lobes of either kind, all of which reflect about as much."""
    rng = np.random.default_rng(seed)
    count = EXPONENTS.size
    size = (EXPONENTS[:, None] + 1.0) * 0.01
    kdd, kg = (size * rng.uniform(0.1, 1.0, (count, 3)) * (rng.random((count, 1)) < share) for _ in range(2))
    return LobeWeights(EXPONENTS, rng.uniform(0.01, 0.3, 3), kdd, kg, np.pi / 4.0, 1.0)


def assert_same_lobes(fit: UndividedFit, known: LobeWeights, tolerance: float) -> None:
    size = (EXPONENTS[:, None] + 1.0) * 0.01
    found = fit.weights
    np.testing.assert_allclose(found.kd, known.kd, rtol=tolerance)
    assert np.abs((found.kdd - known.kdd) / size).max() <= tolerance
    assert np.abs((found.kg - known.kg) / size).max() <= tolerance


def scattered_from(known: LobeWeights, incidences_deg: tuple[float, ...]) -> ScatteredSamples:
    """Samples of ``known`` as a goniometer takes them, dense near the mirror direction."""
    gamma = np.concatenate(([0.0], 0.2 * 1.35 ** np.arange(20), [100.0, 115.0, 130.0]))
    wi, wo = [], []
    for angle in incidences_deg:
        for view in aspecular_view(angle, np.concatenate((gamma, -gamma[1:]))):
            if view[2] > 0.02:
                wi.append(illumination(angle))
                wo.append(view)
    light, view = np.array(wi), np.array(wo)
    return ScatteredSamples(light, view, known.eval(light, view))


@pytest.mark.parametrize("incidences", [(20.0, 45.0, 65.0), (10.0, 30.0, 45.0, 60.0, 75.0)])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_lobe_sum_is_found_again(incidences: tuple[float, ...], seed: int) -> None:
    known = lobe_sum(seed)
    fit = fit_undivided(known, rows=reflectance_rows(known, incidences))
    assert fit.split_determined
    assert fit.relative_error.max() < 1e-9
    assert fit.notices == ()
    assert_same_lobes(fit, known, 1e-6)
    assert fit.weights.ior == 1.0  # the data hold Fresnel's factor already


def test_a_lobe_sum_is_found_again_from_scattered_samples() -> None:
    known = lobe_sum(4, share=0.3)
    fit = fit_undivided(scattered_from(known, (15.0, 40.0, 65.0)))
    assert fit.split_determined
    assert_same_lobes(fit, known, 1e-6)


def test_two_incidences_leave_the_split_undetermined() -> None:
    known = lobe_sum(5)
    scattered = scattered_from(known, (20.0, 65.0))
    for fit in (
        fit_undivided(known, rows=reflectance_rows(known, (20.0, 65.0))),
        fit_undivided(scattered),
    ):
        assert not fit.split_determined
        assert not fit.weights.kg.any()
        assert fit.weights.kdd.any()
        assert any("undetermined" in notice and "20, 65°" in notice for notice in fit.notices)


def test_incidences_too_alike_count_as_one() -> None:
    fit = fit_undivided(scattered_from(lobe_sum(6), (40.0, 40.3, 65.0, 65.4)))
    assert len(fit.incidences_rad) == 2
    assert not fit.split_determined


def test_a_split_that_is_determined_is_right_at_an_angle_not_sampled() -> None:
    """Gloss and directional-diffuse lobes differ by N·L: taken for each other, 75° would be wrong by cosines."""
    known = lobe_sum(7)
    light = illumination(75.0)
    views = aspecular_view(75.0, np.array([0.0, 2.0, 10.0, 30.0]))
    wi = np.broadcast_to(light, views.shape)
    truth = known.reflected(wi, views)
    three = fit_undivided(known, rows=reflectance_rows(known, (20.0, 45.0, 60.0))).weights
    np.testing.assert_allclose(three.reflected(wi, views), truth, rtol=1e-5)
    two = fit_undivided(known, rows=reflectance_rows(known, (20.0, 60.0))).weights
    assert np.abs(two.reflected(wi, views) / truth - 1.0).max() > 0.2


@pytest.mark.parametrize("name", REAL_FILES)
def test_every_real_file(shared_data: Path, name: str) -> None:
    value = read_measured(shared_data / "brdf" / name)
    fit = fit_undivided(value)
    weights = fit.weights
    assert not fit.time_limited
    # LobeWeights refuses negative and not finite ones; here it is that something was fitted, and nothing wild.
    light = float((np.pi * weights.kd + (2 * np.pi / (EXPONENTS + 1)) @ (weights.kdd + weights.kg)).max())
    assert 0.01 < light < 1.2
    assert fit.relative_error.max() < 0.8
    assert fit.split_determined == (name != "bird_example.json")


def test_scattered_samples_are_fitted_where_they_were_measured(shared_data: Path) -> None:
    """The fit takes each sample's own value and direction, and asks for no other."""
    samples = read_measured(shared_data / "brdf" / "krylon_blue.brdf")
    rows = scattered_rows(samples)
    np.testing.assert_array_equal(rows.wi, samples.wi)
    np.testing.assert_array_equal(rows.wo, samples.wo)
    np.testing.assert_array_equal(scattered_values(samples), samples.values)
    assert [round(float(np.degrees(angle))) for angle in rows.incidences_rad] == [
        10,
        20,
        30,
        40,
        50,
        60,
        70,
        80,
    ]
    object.__setattr__(samples, "eval", None)  # interpolation would fail
    assert fit_undivided(samples).samples == 1439


def test_the_diffuse_part_of_a_blue_enamel_is_blue(shared_data: Path) -> None:
    fit = fit_undivided(read_measured(shared_data / "brdf" / "krylon_blue.brdf"))
    assert fit.weights.kd[2] > 3.0 * fit.weights.kd[1] > 6.0 * fit.weights.kd[0] > 0.0


def test_one_sample_is_a_diffuse_value(shared_data: Path) -> None:
    value = read_measured(shared_data / "brdf" / "bird_example.json")
    fit = fit_undivided(value)
    np.testing.assert_allclose(fit.weights.kd, value.values[0], rtol=1e-9)
    assert not fit.weights.kdd.any()
    assert any("diffuse part alone" in notice for notice in fit.notices)
    assert any("undetermined" in notice for notice in fit.notices)


def test_no_lobe_is_claimed_that_no_sample_sees() -> None:
    """Samples 8° and more from the mirror direction say nothing of a lobe of exponent 50,000, whatever its size."""
    theta = np.radians(np.array([20.0, 45.0, 65.0]))
    gamma = np.radians(np.arange(8.0, 100.0, 4.0))
    polar = theta[:, None] - gamma
    wi = np.repeat(np.stack((-np.sin(theta), 0 * theta, np.cos(theta)), -1), gamma.size, axis=0)
    wo = np.stack((np.sin(polar), 0 * polar, np.cos(polar)), -1).reshape(-1, 3)
    above = wo[:, 2] > 0.05
    wi, wo = wi[above], wo[above]
    known = lobe_sum(8)
    fit = fit_undivided(ScatteredSamples(wi, wo, known.eval(wi, wo)))
    assert not fit.weights.kdd[EXPONENTS > 200.0].any()
    assert not fit.weights.kg[EXPONENTS > 200.0].any()
    assert any("near enough to the mirror direction" in notice for notice in fit.notices)


def test_where_answers_tie_the_one_with_least_light_is_taken() -> None:
    """One sample at the mirror direction alone does not determine how wide the gloss is."""
    samples = scattered_from(lobe_sum(9, share=0.0), (20.0, 45.0, 65.0))
    values = np.array(samples.values)
    peak = np.abs(samples.wi * (-1, -1, 1) - samples.wo).max(axis=1) < 1e-9
    far = peak | (np.abs(samples.wi * (-1, -1, 1) - samples.wo).max(axis=1) > 0.15)
    values[peak] += 5.0
    fit = fit_undivided(ScatteredSamples(samples.wi[far], samples.wo[far], values[far]))
    lobes = fit.weights.kdd + fit.weights.kg
    assert lobes[-1].min() > 0.0
    assert lobes[:-1].max() < 1e-6 * lobes[-1].max()


def test_of_lobes_that_meet_one_sample_equally_the_narrowest_is_taken() -> None:
    """Without a price on light the simplex stops at the first of them, which reflects ten times as much."""
    wi, wo, values = [], [], []
    for theta in (20.0, 45.0, 65.0):
        for gamma in (0.3, 20.0, 30.0, 40.0, 60.0, 80.0, 100.0):
            view = aspecular_view(theta, gamma)
            if view[2] > 0.02:
                wi.append(illumination(theta))
                wo.append(view)
                values.append([1.1 if gamma < 1.0 else 0.1] * 3)
    samples = ScatteredSamples(np.array(wi), np.array(wo), np.array(values))
    basis = LobeBasis((2.0, 6.0, 20.0, 80.0, 500.0, 3_000.0, 20_000.0, 110_000.0))
    lobes = fit_undivided(samples, basis)
    reflected = (lobes.weights.kdd + lobes.weights.kg) * (
        2.0 * np.pi / (lobes.weights.exponents[:, None] + 1.0)
    )
    # Lobes sharper than 80,000 are less than a third there and would have to be higher.
    np.testing.assert_allclose(reflected.sum(axis=0), reflected[6])
    assert reflected[6].min() > 0.0


def test_black_is_all_zeros() -> None:
    fit = fit_undivided(Lambertian((0.0, 0.0, 0.0)))
    assert not np.concatenate((fit.weights.kd[None], fit.weights.kdd, fit.weights.kg)).any()
    assert any("black" in notice for notice in fit.notices)


def test_one_channel_zero_stays_zero() -> None:
    fit = fit_undivided(Lambertian((0.4, 0.0, 0.1)))
    np.testing.assert_allclose(fit.weights.kd * np.pi, (0.4, 0.0, 0.1), atol=1e-9)
    assert not fit.weights.kdd[:, 1].any()
    assert not fit.weights.kg[:, 1].any()


@pytest.mark.parametrize("scale", [1e-12, 1e12])
def test_any_brightness(scale: float) -> None:
    known = lobe_sum(10)
    bright = Function(lambda wi, wo: scale * known.eval(wi, wo))
    fit = fit_undivided(bright)
    np.testing.assert_allclose(fit.weights.kd / scale, known.kd, rtol=1e-6)


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (np.nan, "is not finite"),
        (np.inf, "is not finite"),
        (-0.5, "is negative"),
        (1e305, "is beyond any reflectance"),
    ],
)
def test_bad_values_are_named_with_their_place(bad: float, words: str) -> None:
    def value(wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        result = np.full(wi.shape, 0.1)
        result[np.abs(wi[..., 2] - np.cos(np.pi / 4)) < 1e-9, 1] = bad
        return result

    with pytest.raises(FittingError, match=f"green channel {words}.* light at 45°"):
        fit_undivided(Function(value))


def test_nothing_above_the_horizon_is_refused() -> None:
    flat = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    with pytest.raises(FittingError, match="above the horizon"):
        fit_undivided(ScatteredSamples(flat, flat, np.ones((2, 3))))


def test_samples_at_the_horizon_are_left_out_and_reported() -> None:
    known = lobe_sum(11, share=0.0)
    good = scattered_from(known, (20.0, 45.0, 65.0))
    wi = np.concatenate((good.wi, [[1.0, 0.0, 0.0]]))
    wo = np.concatenate((good.wo, [[0.0, 0.0, 1.0]]))
    fit = fit_undivided(ScatteredSamples(wi, wo, np.concatenate((good.values, [[1e6, 1e6, 1e6]]))))
    np.testing.assert_allclose(fit.weights.kd, known.kd, rtol=1e-6)
    assert any("1 samples at the horizon" in notice for notice in fit.notices)


def test_holes_of_a_table_are_not_fitted() -> None:
    """A third of the table is marked as not measured and holds nonsense; the rest decides."""
    matt = IsotropicTable.from_reflectance(Lambertian((0.5, 0.3, 0.2)))
    values, holes = np.array(matt.values), np.array(matt.holes)
    values[:, 30:50] = 7.0
    holes[:, 30:50] = True
    fit = fit_undivided(IsotropicTable(values, holes))
    np.testing.assert_allclose(fit.weights.kd * np.pi, (0.5, 0.3, 0.2), rtol=1e-4)
    assert fit.relative_error.max() < 1e-4
    assert any("not measured" in notice for notice in fit.notices)
    assert fit_undivided(IsotropicTable(values)).relative_error.max() > 0.6


def test_a_table_of_photographs_is_fitted_though_holes_lie_between_all_of_its_bins() -> None:
    """One bin in seven was measured, and what lies between was filled in."""
    matt = IsotropicTable.from_reflectance(Lambertian((0.5, 0.3, 0.2)), HalfAngleGrid(90, 90, 36))
    samples = np.zeros(matt.values.shape[:3], np.float32)
    samples.reshape(-1)[::7] = 1.0
    samples[:, 80:] = 0.0
    values = np.array(matt.values)
    values[:, 82:] = 7.0
    coverage = Coverage(samples, np.zeros_like(samples))
    fit = fit_undivided(IsotropicTable(values, samples == 0.0, coverage=coverage))
    np.testing.assert_allclose(fit.weights.kd * np.pi, (0.5, 0.3, 0.2), rtol=1e-4)
    # Where nothing at all was measured nearby, it is left out still.
    assert any("not measured" in notice for notice in fit.notices)


@pytest.mark.parametrize(("last", "split"), [(90, True), (34, False), (3, False)])
def test_an_incidence_of_which_little_was_measured_is_none(last: int, split: bool) -> None:
    """Rows of θd from ``last`` on are holes: with them go the rings about the mirror directions of those angles."""
    known = lobe_sum(13, share=0.2)
    table = IsotropicTable.from_reflectance(known, HalfAngleGrid(90, 90, 36))
    holes = np.zeros(table.values.shape[:3], np.bool_)
    holes[:, last:] = True
    rows = reflectance_rows(IsotropicTable(table.values, holes))
    fit = fit_undivided(IsotropicTable(table.values, holes), rows=rows)
    assert fit.split_determined == split
    assert fit.weights.kg.any() == split
    reported = [notice for notice in fit.notices if "undetermined" in notice]
    assert bool(reported) != split
    if last == 34:
        assert "The light stood at 10, 30° only" in reported[0]


def test_a_part_of_the_rows_has_the_incidences_that_are_in_it() -> None:
    samples = scattered_from(lobe_sum(14), (20.0, 45.0, 65.0))
    rows = scattered_rows(samples)
    near = rows.theta_rad < np.radians(50.0)
    part = rows.subset(near)
    np.testing.assert_allclose(np.degrees(part.incidences_rad), (20.0, 45.0))
    assert not fit_rows(part, scattered_values(samples)[near]).split_determined
    some = np.zeros(near.size, np.bool_)
    some[::3] = True
    assert rows.subset(some).incidences_rad == rows.incidences_rad
    # One that does not count as a whole does not count in a part.
    whole = reflectance_rows(lobe_sum(14))
    fewer = replace(whole, incidences_rad=whole.incidences_rad[:2])
    assert fewer.subset(np.ones(fewer.weights.size, np.bool_)).incidences_rad == fewer.incidences_rad


def test_a_fit_reports_its_progress_and_is_cancelled_between_runs() -> None:
    rng = np.random.default_rng(3)
    wi, wo = (
        spherical(np.arccos(rng.uniform(0.05, 1.0, 20_000)), rng.uniform(0, 2 * np.pi, 20_000))
        for _ in range(2)
    )
    samples = ScatteredSamples(wi, wo, lobe_sum(15).eval(wi, wo) * rng.lognormal(0.0, 0.3, (20_000, 1)))
    reported: list[tuple[float, str]] = []

    def cancel(fraction: float, what: str) -> None:
        reported.append((fraction, what))
        if len(reported) == 4:
            raise Cancelled

    with pytest.raises(Cancelled):
        fit_undivided(samples, progress=cancel)
    assert [what for _, what in reported] == ["fitting"] * 4
    assert 0.0 <= reported[0][0] < reported[3][0] < 1.0


def test_what_differs_with_azimuth_is_fitted_to_its_mean() -> None:
    def brushed(wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        half = wi + wo
        azimuth = 2.0 * np.arctan2(half[..., 1], half[..., 0])
        return (0.1 + 0.05 * np.cos(azimuth))[..., None] * np.ones(3)

    fit = fit_undivided(Function(brushed))
    assert any("azimuth" in notice for notice in fit.notices)
    np.testing.assert_allclose(fit.weights.kd, 0.1, rtol=0.02)


def test_a_limit_that_is_too_short_gives_marked_weights() -> None:
    fit = fit_undivided(lobe_sum(12), time_limit_s=1e-5)
    assert fit.time_limited
    assert np.isfinite(fit.relative_error).all()
    with pytest.raises(FittingError, match="more than 0"):
        fit_undivided(lobe_sum(12), time_limit_s=0.0)


def test_another_basis() -> None:
    basis = LobeBasis((3.0, 30.0, 300.0))
    fit = fit_undivided(Lambertian((0.4, 0.3, 0.1)), basis)
    assert fit.weights.exponents.tolist() == [3.0, 30.0, 300.0]


@settings(max_examples=settings.default.max_examples // 2)
@given(st.integers(0, 10_000), st.integers(1, 40), st.floats(1e-9, 1e9))
def test_scattered_values_of_any_kind_give_sound_weights(seed: int, count: int, size: float) -> None:
    rng = np.random.default_rng(seed)
    wi, wo = (
        spherical(np.arccos(rng.uniform(0.01, 1.0, count)), rng.uniform(0, 2 * np.pi, count))
        for _ in range(2)
    )
    values = size * rng.random((count, 3)) ** 4 * (rng.random((count, 3)) < 0.7)
    samples = ScatteredSamples(wi, wo, values)
    fit = fit_rows(scattered_rows(samples), scattered_values(samples))
    assert np.isfinite(fit.relative_error).all()
    # No answer at all would leave an error of 1.
    assert fit.relative_error.max() <= 1.0 + 1e-6
