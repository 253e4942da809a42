"""Stated errors cover what the noise, other minima and the instrument's pixels leave possible."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.fitting.cook_torrance import CookTorranceFit, Settings, check_samples, fit_checked_samples
from brdf_suite.fitting.cook_torrance.samples import Instrument, even_pairs, samples_of
from brdf_suite.fitting.cook_torrance.uncertainty import SIGMAS
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import PIXEL_FACT, IsotropicTable

QUICK = Settings(lobes=2, starts=4, samples=1200)
PAINT = CookTorrancePaint(
    "satin",
    (0.1, 0.2, 0.3),
    (CookTorranceLobe((0.1, 0.12, 0.08), 0.35, 0.5), CookTorranceLobe((0.2, 0.2, 0.2), 0.05, 0.04)),
)


def noisy(values: Floats, noise: float = 0.03, seed: int = 1) -> Floats:
    return values * np.exp(noise * np.random.default_rng(seed).normal(size=values.shape))


@pytest.fixture(scope="module")
def fit() -> CookTorranceFit:
    wi, wo = even_pairs(1200, 4, 75.0)
    return fit_checked_samples(check_samples(wi, wo, noisy(CookTorrance(PAINT).eval(wi, wo))), QUICK)


def test_the_misfit_has_a_profile_over_each_parameter(fit: CookTorranceFit) -> None:
    reported = json.loads(json.dumps(fit.to_json()))["profiles"]
    names = [row["parameter"] for row in reported]
    assert len(set(names)) == len(names) == 13
    assert {"kd red", "ks·r 1 green", "m 2", "r 1"} <= set(names)
    for one, row in zip(fit.profiles, reported, strict=True):
        assert np.all(np.diff(one.values) > 0.0)
        answer = int(np.flatnonzero(one.values == fit.vector[one.parameter])[0])
        # Held away from the answer on either side, the parameter costs misfit.
        assert 0 < answer < len(one.values) - 1
        assert one.energies[0] > one.energies[answer] < one.energies[-1]
        assert len(row["energies_mean"]) == len(one.values)


def test_the_truth_is_within_the_stated_intervals(fit: CookTorranceFit) -> None:
    errors, lobes = fit.standard_errors, PAINT.lobes
    pairs = (
        (fit.kd, errors.kd, PAINT.kd),
        (fit.ks, errors.ks, [lobe.ks for lobe in lobes]),
        (fit.m, errors.m, [lobe.m for lobe in lobes]),
        (fit.r, errors.r, [lobe.r for lobe in lobes]),
    )
    inside = [(np.abs(found - truth) <= SIGMAS * error).ravel() for found, error, truth in pairs]
    assert np.concatenate(inside).mean() >= 0.9


def test_another_answer_within_the_noise_is_reported_and_covered() -> None:
    # Up to 50° of θd a lobe of r = .92 looks like one of less than half of that.
    truth = CookTorrancePaint(
        "bright", (0.05, 0.06, 0.07), (CookTorranceLobe((0.11, 0.13, 0.13), 0.17, 0.92),)
    )
    wi, wo = even_pairs(4000, 2, 75.0)
    near = np.einsum("nk,nk->n", wi, wo) > np.cos(np.radians(100.0))
    wi, wo = wi[near][:1200], wo[near][:1200]
    values = noisy(CookTorrance(truth).eval(wi, wo), 0.05)
    found = fit_checked_samples(check_samples(wi, wo, values), replace(QUICK, lobes=1))
    assert found.alternatives
    for other in found.alternatives:
        assert np.all(np.abs(other.r - found.r) <= 1.0001 * SIGMAS * found.standard_errors.r)
        assert np.all(np.abs(other.ks - found.ks) <= 1.0001 * SIGMAS * found.standard_errors.ks)
    assert abs(found.r[0] - 0.92) <= SIGMAS * found.standard_errors.r[0]
    assert any("Another answer" in notice for notice in found.notices)
    assert found.to_json()["alternatives"][0]["lobes"][0]["r"] == pytest.approx(found.alternatives[0].r[0])


def test_what_pixels_blur_is_stated_for_the_sharp_lobe() -> None:
    wi, wo = even_pairs(1200, 4, 70.0)
    model, pixel = CookTorrance(PAINT), np.radians(4.0)
    plain = check_samples(wi, wo, model.eval(wi, wo))
    blurred = np.zeros((len(wi), 3))
    # A pixel's normals: even over its width, more of them where it is seen at an angle.
    tilt = Instrument(pixel).tilt_rad(plain)[:, None] * np.sqrt(3.0)
    steps = (np.arange(8) + 0.5) / 4.0 - 1.0
    for x, y in ((x, y) for x in steps for y in steps):
        turned = (w + tilt * np.cross((x, y, 0.0), w) for w in (wi, wo))
        blurred += model.eval(*(w / np.linalg.norm(w, axis=1)[:, None] for w in turned)) / 64.0
    samples = check_samples(wi, wo, noisy(blurred, 0.005))
    unknown = fit_checked_samples(samples, QUICK)
    known = fit_checked_samples(replace(samples, instrument=Instrument(pixel)), QUICK)
    assert known.m == pytest.approx(unknown.m)
    away = abs(known.m[1] - PAINT.lobes[1].m)
    assert away > SIGMAS * unknown.standard_errors.m[1]
    assert away < SIGMAS * known.standard_errors.m[1] < 5.0 * away


def test_an_acquired_table_has_errors_that_more_bins_do_not_average_out() -> None:
    table = IsotropicTable.from_reflectance(CookTorrance(PAINT), HalfAngleGrid(45, 30, 40))
    table = replace(table, values=noisy(table.values.astype(np.float64)).astype(np.float32))
    acquired = replace(table, facts={PIXEL_FACT: 0.1})
    plain, careful = (fit_checked_samples(samples_of(one, QUICK), QUICK) for one in (table, acquired))
    assert np.all(careful.standard_errors.kd > 1.2 * plain.standard_errors.kd)
    assert np.all(careful.standard_errors.kd < 0.02 * careful.kd)
