"""Lobes fitted to samples: known ones come back, and what cannot be fitted is named."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.errors import Cancelled, FittingError, ValueRangeError
from brdf_suite.fitting.cook_torrance import CookTorranceFit, Settings, fit_lobes
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

QUICK = Settings(starts=4, samples=1500)


def directions(count: int = 1500, seed: int = 3) -> tuple[Floats, Floats]:
    h, d, p = np.random.default_rng(seed).random((3, 4 * count))
    wi, wo = from_half_angle_coordinates(1.5 * h**2, 0.0, 1.4 * d, np.pi * p)
    seen = (wi[:, 2] > 0.18) & (wo[:, 2] > 0.18)
    return wi[seen][:count], wo[seen][:count]


@pytest.fixture(scope="module")
def pairs() -> tuple[Floats, Floats]:
    return directions()


def noisy(paint: CookTorrancePaint, pairs: tuple[Floats, Floats], noise: float) -> Floats:
    values = CookTorrance(paint).eval(*pairs)
    return values * np.exp(noise * np.random.default_rng(5).normal(size=values.shape))


@pytest.fixture(scope="module")
def polaris(pairs: tuple[Floats, Floats]) -> CookTorranceFit:
    return fit_lobes(*pairs, noisy(TABLE_1["table1_polaris_silver"], pairs, 0.02), settings=QUICK)


def test_the_parameters_of_a_metallic_paint_come_back_from_noisy_samples(polaris: CookTorranceFit) -> None:
    truth = TABLE_1["table1_polaris_silver"]
    assert polaris.kd == pytest.approx(truth.kd, rel=0.02)
    assert polaris.m == pytest.approx([lobe.m for lobe in truth.lobes], rel=0.02)
    assert polaris.r == pytest.approx([lobe.r for lobe in truth.lobes], rel=0.06)
    assert np.allclose(polaris.ks, [lobe.ks for lobe in truth.lobes], rtol=0.06)
    assert list(polaris.m) == sorted(polaris.m, reverse=True)


def test_errors_are_within_a_few_of_those_reported(polaris: CookTorranceFit) -> None:
    truth, errors = TABLE_1["table1_polaris_silver"], polaris.standard_errors
    away = np.abs(polaris.m - [lobe.m for lobe in truth.lobes]) / errors.m
    assert np.all(away < 5.0)
    assert np.all(np.abs(polaris.kd - truth.kd) < 5.0 * errors.kd)
    # The first lobe has r = 1, the end of the range, where there is no spread.
    assert np.isnan(errors.r[0])
    assert np.all(errors.correlation_ks_r[1:] < -0.5)


def test_the_paint_reflects_as_the_fit_and_its_parts_sum_to_it(
    polaris: CookTorranceFit, pairs: tuple[Floats, Floats]
) -> None:
    values = polaris.eval(*pairs)
    assert np.allclose(CookTorrance(polaris.paint("fitted")).eval(*pairs), values, rtol=1e-9)
    parts = polaris.parts(*pairs)
    assert parts.shape == (4, len(values), 3)
    assert np.allclose(parts.sum(axis=0), values)
    below = pairs[1] * [1.0, 1.0, -1.0]
    assert not polaris.eval(pairs[0], below).any()


def test_the_energy_is_that_of_equation_2(polaris: CookTorranceFit, pairs: tuple[Floats, Floats]) -> None:
    values = noisy(TABLE_1["table1_polaris_silver"], pairs, 0.02)
    wanted = np.abs(np.log(polaris.eval(*pairs) / values)).sum()
    assert polaris.energy == pytest.approx(wanted)
    assert polaris.energy_mean == pytest.approx(wanted / values.size)


def test_outliers_pull_the_robust_fit_and_the_paper_s_less_than_squares(pairs: tuple[Floats, Floats]) -> None:
    truth = replace(TABLE_1["table1_ford_f8"], lobes=TABLE_1["table1_ford_f8"].lobes[1:])
    values = noisy(truth, pairs, 0.01)
    values[::7] *= 8.0
    error = {}
    for loss in ("l1", "l2", "robust"):
        fit = fit_lobes(*pairs, values, settings=replace(QUICK, lobes=2, starts=2, loss=loss))
        error[loss] = float(np.abs(np.log(fit.kd / truth.kd)).max())
    assert error["l1"] < 0.02
    assert error["robust"] < 0.01
    assert error["l2"] > 0.1


def test_a_lobe_that_nothing_asks_for_gets_no_weight(pairs: tuple[Floats, Floats]) -> None:
    one = CookTorrancePaint("one", (0.2, 0.1, 0.05), (CookTorranceLobe((0.1, 0.2, 0.3), 0.2, 0.1),))
    fit = fit_lobes(*pairs, noisy(one, pairs, 0.02), settings=replace(QUICK, lobes=2))
    assert fit.dropped == (0,)
    assert not fit.ks[0].any()
    assert fit.m[1] == pytest.approx(0.2, rel=0.02)
    assert any("no weight" in notice for notice in fit.notices)
    assert len(fit.paint("one").lobes) == 1


def test_a_matt_surface_has_no_peak(pairs: tuple[Floats, Floats]) -> None:
    fit = fit_lobes(*pairs, np.full((len(pairs[0]), 3), 0.1), settings=replace(QUICK, starts=2))
    assert np.allclose(fit.eval(*pairs), 0.1, rtol=1e-3)


def test_weights_decide_between_samples_that_disagree(pairs: tuple[Floats, Floats]) -> None:
    values = np.full((len(pairs[0]), 3), 0.1)
    values[::2] = 0.3
    weights = np.where(np.arange(len(values)) % 2, 1.0, 0.0)
    fit = fit_lobes(*pairs, values, weights, settings=replace(QUICK, lobes=1, starts=1))
    assert np.allclose(fit.eval(*pairs), 0.1, rtol=1e-2)
    assert fit.left_out == (len(values) + 1) // 2


def test_a_black_channel_stays_black(pairs: tuple[Floats, Floats]) -> None:
    values = noisy(TABLE_1["table1_ford_f8"], pairs, 0.0)
    values[:, 2] = 0.0
    fit = fit_lobes(*pairs, values, settings=replace(QUICK, lobes=2, starts=2))
    assert fit.kd[2] == 0.0
    assert not fit.ks[:, 2].any()
    assert any("blue" in notice for notice in fit.notices)


def test_bad_samples_are_left_out_and_counted(pairs: tuple[Floats, Floats]) -> None:
    values = noisy(TABLE_1["table1_polaris_silver"], pairs, 0.0)
    values[3, 1], values[4], values[5] = np.nan, 0.0, -1.0
    fit = fit_lobes(*pairs, values, settings=replace(QUICK, lobes=1, starts=1))
    assert fit.left_out == 3
    assert np.isfinite(fit.eval(*pairs)).all()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda wi, wo, values: (wi[:4], wo[:4], values[:4]), "cannot determine"),
        (lambda wi, wo, values: (wi, wo, values[:-1]), "fit together"),
        (lambda wi, wo, values: (2.0 * wi, wo, values), "unit length"),
        (lambda wi, wo, values: (wi, wo, values * np.nan), "None of"),
        (lambda wi, wo, values: (wi, wo, values * 0.0), "None of"),
        (lambda wi, wo, values: (wi[:, :2], wo, values), "shape"),
    ],
    ids=["few", "lengths", "unit", "nan", "black", "shape"],
)
def test_what_cannot_be_fitted_is_named(pairs: tuple[Floats, Floats], change, said: str) -> None:
    with pytest.raises(FittingError, match=said):
        fit_lobes(*change(*pairs, np.ones((len(pairs[0]), 3))), settings=QUICK)


@pytest.mark.parametrize("bad", [{"lobes": 0}, {"model": "phong"}, {"loss": "l3"}, {"grazing_deg": np.nan}])
def test_settings_out_of_range_are_named(bad: dict[str, object]) -> None:
    with pytest.raises(ValueRangeError, match=next(iter(bad))):
        Settings(**bad)


def test_a_fit_can_be_cancelled(pairs: tuple[Floats, Floats]) -> None:
    def cancel(fraction: float, what: str) -> None:
        if "start 2" in what:
            raise Cancelled

    with pytest.raises(Cancelled):
        fit_lobes(*pairs, np.ones((len(pairs[0]), 3)), settings=QUICK, progress=cancel)
