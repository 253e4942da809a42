from __future__ import annotations

import gc
import pickle
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeBasis, LobeFitter, LobeWeights, log_spaced

MakePaint = Callable[..., Any]
PATIENCE_S = 250.0


def targets(fitter: LobeFitter) -> tuple[np.ndarray, np.ndarray]:
    gamma = fitter.base_samples.gamma_rad
    base = 0.02 + 0.3 * np.clip(np.cos(gamma), 0, None)[:, None] ** np.array([5.0, 6.0, 7.0])
    coat = 300.0 * np.exp(-np.outer(fitter.coat_samples.gamma_rad**2, np.full(3, 9_000.0)))
    return base, coat


def test_a_sum_of_the_basis_is_found_again(fitter: LobeFitter) -> None:
    rng = np.random.default_rng(1)
    exponents = fitter.basis.array()
    kd, kdd = rng.uniform(0.1, 1, 3), rng.uniform(0, 1, (exponents.size, 3))
    kg = rng.uniform(0, 1, (exponents.size, 3)) * exponents[:, None]
    samples = fitter.base_samples
    base = np.cos(samples.theta_rad) * (kd + samples.cosine_lobes(exponents) @ kdd)
    coat = fitter.coat_samples.cosine_lobes(exponents) @ kg
    fit = fitter.fit_samples(base, coat, ior=1.5)
    assert (fit.base_error.relative < 1e-6).all()
    np.testing.assert_allclose(fit.weights.kd, kd, rtol=1e-4)
    found = np.cos(samples.theta_rad) * (fit.weights.kd + samples.cosine_lobes(exponents) @ fit.weights.kdd)
    np.testing.assert_allclose(found, base, rtol=1e-6)


def test_the_coat_keeps_its_energy_and_the_base_its_measured_angles(
    fitter: LobeFitter, make_paint: MakePaint
) -> None:
    for roughness in (0.002, 0.004, 0.01, 0.03, 0.1):
        paint = make_paint(roughness=roughness)
        fit = fitter.fit(paint)
        # The paint's coat reflects .05 of what falls on it, in whatever lobe.
        np.testing.assert_allclose(fit.weights.coat_energy(), 0.05, rtol=0.01)
        samples = fitter.base_samples
        at = [samples.gammas_deg.index(g) for g in (15.0, 45.0, 110.0)]
        wanted = paint.base.eval(samples.light, samples.views[at])
        coatless = LobeWeights(
            fit.weights.exponents,
            fit.weights.kd,
            fit.weights.kdd,
            0 * fit.weights.kg,
            fit.weights.theta_fit_rad,
            1.5,
        )
        np.testing.assert_allclose(coatless.eval(samples.light, samples.views[at]), wanted, rtol=1e-3)


def test_weights_say_how_they_came_about(fitter: LobeFitter, make_paint: MakePaint) -> None:
    fit = fitter.fit(make_paint())
    assert fit.weights.theta_fit_rad == pytest.approx(np.pi / 4)
    assert fit.weights.ior == 1.5
    assert fit.seconds > 0.0
    assert fit.sampling_seconds > 0.0
    assert not fit.time_limited
    assert fit.base_error.method == ("optimum",) * 3
    assert fit.base_error.relative.shape == fit.coat_error.absolute.shape == (3,)


def test_the_last_basis_is_the_next_start(make_paint: MakePaint) -> None:
    fitter = LobeFitter(time_limit_s=60.0)
    far = fitter.fit(make_paint(exponent=20.0, roughness=0.05)).iterations
    assert far > 0
    assert fitter.fit(make_paint(exponent=20.0, roughness=0.05)).iterations == 0
    assert fitter.fit(make_paint(exponent=20.05, roughness=0.05)).iterations < far / 2


@settings(max_examples=settings.default.max_examples // 4)
@given(st.floats(-6.0, 6.0))
def test_brightness_only_scales_the_weights(fitter: LobeFitter, magnitude: float) -> None:
    base, coat = targets(fitter)
    factor = 10.0**magnitude
    plain, scaled = (fitter.fit_samples(base * f, coat * f, ior=1.5) for f in (1.0, factor))
    samples = fitter.base_samples
    lobes = samples.cosine_lobes(fitter.basis.array())
    np.testing.assert_allclose(
        (scaled.weights.kd + lobes @ scaled.weights.kdd) / factor,
        plain.weights.kd + lobes @ plain.weights.kdd,
        rtol=1e-6,
    )
    np.testing.assert_allclose(scaled.weights.coat_energy() / factor, plain.weights.coat_energy(), rtol=1e-7)


@settings(max_examples=settings.default.max_examples // 4)
@given(st.integers(0, 2**32 - 1))
def test_the_way_to_a_target_does_not_change_its_error(fitter: LobeFitter, seed: int) -> None:
    rng = np.random.default_rng(seed)
    base, coat = targets(fitter)
    base = base * rng.uniform(0.7, 1.3, base.shape)
    first = fitter.fit_samples(base, coat, ior=1.5)
    for _ in range(3):
        fitter.fit_samples(rng.uniform(0, 1, base.shape), coat * rng.uniform(0, 1, coat.shape), ior=1.5)
    again = fitter.fit_samples(base, coat, ior=1.5)
    np.testing.assert_allclose(again.base_error.absolute, first.base_error.absolute, rtol=1e-7, atol=1e-12)
    np.testing.assert_allclose(again.coat_error.absolute, first.coat_error.absolute, rtol=1e-7, atol=1e-12)


def test_a_dark_channel_and_a_black_paint_stay_dark(fitter: LobeFitter) -> None:
    base, coat = targets(fitter)
    reference = fitter.fit_samples(base, coat, ior=1.5)
    dark = base.copy()
    dark[:, 1] = 0.0
    fit = fitter.fit_samples(dark, coat, ior=1.5)
    assert fit.weights.kd[1] == 0.0
    assert not fit.weights.kdd[:, 1].any()
    np.testing.assert_allclose(
        fit.base_error.absolute[[0, 2]], reference.base_error.absolute[[0, 2]], rtol=1e-6
    )
    black = fitter.fit_samples(0 * base, 0 * coat, ior=1.5)
    assert not black.weights.kd.any()
    assert not black.weights.kdd.any()
    assert not black.weights.kg.any()
    assert not black.base_error.relative.any()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -0.01])
@pytest.mark.parametrize("part", ["base", "coat"])
def test_bad_targets_are_refused_with_their_place(fitter: LobeFitter, part: str, bad: float) -> None:
    base, coat = targets(fitter)
    (base if part == "base" else coat)[4, 2] = bad
    with pytest.raises(FittingError, match=rf"{part}.*blue.*°"):
        fitter.fit_samples(base, coat, ior=1.5)
    base, coat = targets(fitter)
    assert not fitter.fit_samples(base, coat, ior=1.5).time_limited


def test_wrong_shapes_are_refused(fitter: LobeFitter) -> None:
    base, coat = targets(fitter)
    with pytest.raises(FittingError, match="shape"):
        fitter.fit_samples(base[:-1], coat, ior=1.5)


def test_more_lobes_than_samples_still_fit() -> None:
    fitter = LobeFitter(log_spaced(40, 1.0, 50_000.0), time_limit_s=60.0)
    base, coat = targets(fitter)
    fit = fitter.fit_samples(base, coat, ior=1.5)
    assert (fit.base_error.relative < 0.01).all()


def test_one_lobe_is_enough_to_answer() -> None:
    fitter = LobeFitter(LobeBasis((6.0,)), time_limit_s=60.0)
    base, coat = targets(fitter)
    assert np.isfinite(fitter.fit_samples(base, coat, ior=1.5).weights.kg).all()


def test_the_limit_gives_the_best_answer_at_hand_and_the_optimum_later() -> None:
    basis = log_spaced(300, 1.0, 50_000.0)
    hurried = LobeFitter(basis, time_limit_s=1e-5)
    patient = LobeFitter(basis, time_limit_s=PATIENCE_S)
    rng = np.random.default_rng(2)
    for _ in range(5):
        base, coat = targets(hurried)
        base = base * np.exp(rng.normal(0, 0.3, base.shape))
        coat = coat * np.exp(rng.normal(0, 0.3, coat.shape))
        fit, best = (f.fit_samples(base, coat, ior=1.4) for f in (hurried, patient))
        assert not best.time_limited
        assert best.exact is None
        assert fit.time_limited
        assert fit.weights.time_limited
        for error, exact in ((fit.base_error, best.base_error), (fit.coat_error, best.coat_error)):
            assert "optimum" not in error.method
            assert (error.absolute >= exact.absolute * (1 - 1e-6) - 1e-12).all()
            assert (error.relative <= 1.0).all()  # never worse than no weights at all
            assert (error.relative <= 3.0 * exact.relative + 0.2).all()
        assert fit.exact is not None
        exact_fit = fit.exact.result(timeout=PATIENCE_S)
        assert not exact_fit.time_limited
        assert not exact_fit.weights.time_limited
        assert exact_fit.weights.ior == 1.4
        for error, exact in (
            (exact_fit.base_error, best.base_error),
            (exact_fit.coat_error, best.coat_error),
        ):
            assert error.method == ("optimum",) * 3
            np.testing.assert_allclose(error.absolute, exact.absolute, rtol=1e-6, atol=1e-12)
    # The next fit with time enough is exact again: the interrupted run left nothing behind.
    hurried.time_limit_s = PATIENCE_S
    after = hurried.fit_samples(base, coat, ior=1.5)
    assert not after.time_limited
    np.testing.assert_allclose(after.base_error.absolute, best.base_error.absolute, rtol=1e-6, atol=1e-12)
    hurried.close()


def test_a_limited_fit_goes_to_another_process_without_its_future() -> None:
    hurried = LobeFitter(time_limit_s=1e-6)
    fit = hurried.fit_samples(*targets(hurried), ior=1.5)
    assert fit.exact is not None
    again = pickle.loads(pickle.dumps(fit))
    assert again.exact is None
    assert again.time_limited
    np.testing.assert_array_equal(again.weights.kdd, fit.weights.kdd)
    hurried.close()


def test_a_fitter_that_is_lost_takes_its_thread_along() -> None:
    def threads() -> int:
        return sum(thread.name.startswith("brdf-fit") for thread in threading.enumerate())

    gc.collect()
    before = threads()
    hurried = LobeFitter(log_spaced(300, 1.0, 50_000.0), time_limit_s=1e-6)
    fit = hurried.fit_samples(*targets(hurried), ior=1.5)
    assert fit.exact is not None
    assert threads() > 0
    del hurried
    for _ in range(2400):
        gc.collect()
        if fit.exact.done() and threads() <= before:
            break
        time.sleep(0.05)
    assert fit.exact.done()
    assert threads() <= before


def test_the_limit_is_that_of_one_fit_and_not_of_all_together() -> None:
    """The solver itself counts the time of all its runs; a drag of minutes must not run out of it."""
    fitter = LobeFitter(time_limit_s=0.5)
    rng = np.random.default_rng(6)
    base, coat = targets(fitter)
    limited: list[bool] = []
    end = time.perf_counter() + 2.5 * fitter.time_limit_s  # by the clock: how many fits that is, is no matter
    while len(limited) < 200 or time.perf_counter() < end:
        target = base * rng.uniform(0.5, 1.5, base.shape)
        limited.append(fitter.fit_samples(target, coat, ior=1.5).time_limited)
    assert sum(limited[-100:]) < 50  # on a busy machine a single fit may be kept waiting


@pytest.mark.parametrize("limit", [0.0, -1.0, np.nan, np.inf])
def test_a_senseless_limit_is_refused(limit: float) -> None:
    with pytest.raises(FittingError, match="time limit"):
        LobeFitter(time_limit_s=limit)


@pytest.mark.parametrize("under", [True, False])
def test_weights_say_whether_the_base_is_under_a_coat(
    fitter: LobeFitter, make_paint: MakePaint, under: bool
) -> None:
    assert fitter.fit(replace(make_paint(), base_under_coat=under)).weights.base_under_coat is under
